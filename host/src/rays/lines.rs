//! Lines of text become rays.

use std::fmt;

use strahl_engine::RayQuery;
use strahl_scene::quantity::quantity;
use strahl_settings::Precision;

/// The longest line that may be one, in bytes.
pub(super) const LONGEST: usize = 1 << 16;

/// The names of the fields; the last may be missing.
const NAMES: [&str; 7] = ["ox", "oy", "oz", "dx", "dy", "dz", "tmax"];

/// What is wrong with a line.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum LineFault {
    /// It has so many fields.
    Fields(usize),
    /// The field at this place is no number.
    Word(usize, String),
    /// It names fields, but not these: it has these words.
    Names(String),
    /// It is longer than [`LONGEST`].
    Long,
}

impl fmt::Display for LineFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LineFault::Fields(count) => {
                write!(
                    f,
                    "{}; ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,tmax is expected",
                    quantity(*count, "field")
                )
            }
            LineFault::Word(place, word) if word.is_empty() => {
                write!(f, "{} is empty; a number is expected", NAMES[*place])
            }
            LineFault::Word(place, word) => write!(f, "{} is `{word}`, which is no number", NAMES[*place]),
            LineFault::Names(words) => {
                write!(
                    f,
                    "`{words}` are no names of fields in their order; ox,oy,oz,dx,dy,dz or \
                     ox,oy,oz,dx,dy,dz,tmax is expected"
                )
            }
            LineFault::Long => write!(f, "the line is longer than {LONGEST} bytes"),
        }
    }
}

/// A number, rounded to the precision. Beyond its range it is infinite or zero.
fn number(field: &[u8], precision: Precision) -> Option<f64> {
    let text = std::str::from_utf8(field).ok()?;
    match precision {
        Precision::Single => text.parse::<f32>().ok().map(f64::from),
        Precision::Double => text.parse().ok(),
    }
}

fn fields(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|byte| *byte == b',').map(<[u8]>::trim_ascii)
}

/// The ray of a line.
pub(super) fn read(line: &[u8], precision: Precision) -> Result<RayQuery, LineFault> {
    if line.len() > LONGEST {
        return Err(LineFault::Long);
    }
    let mut numbers = [f64::INFINITY; NAMES.len()];
    let mut count = 0;
    let mut wrong = None;
    for field in fields(line) {
        if let Some(place) = numbers.get_mut(count) {
            match number(field, precision) {
                Some(number) => *place = number,
                None => wrong = wrong.or(Some((count, field))),
            }
        }
        count += 1;
    }
    if count != NAMES.len() && count != NAMES.len() - 1 {
        return Err(LineFault::Fields(count));
    }
    if let Some((place, word)) = wrong {
        let word: String = String::from_utf8_lossy(word).chars().take(40).collect();
        return Err(LineFault::Word(place, word));
    }
    let [ox, oy, oz, dx, dy, dz, t_max] = numbers;
    Ok(RayQuery { origin: [ox, oy, oz], direction: [dx, dy, dz], t_max })
}

/// Whether a line names its fields: there are as many as of a ray, and none of them is a number. They
/// must be the names of the fields of a ray, in their order; quoted or not, in letters of either size.
pub(super) fn is_header(line: &[u8]) -> Result<bool, LineFault> {
    let count = fields(line).count();
    let has_words = line.len() <= LONGEST
        && (count == NAMES.len() || count == NAMES.len() - 1)
        && fields(line).all(|field| !field.is_empty() && number(field, Precision::Double).is_none());
    let bare = |field: &'_ [u8]| -> Vec<u8> {
        let quoted = field.strip_prefix(b"\"").and_then(|field| field.strip_suffix(b"\""));
        quoted.unwrap_or(field).trim_ascii().to_ascii_lowercase()
    };
    if has_words && !fields(line).map(bare).zip(NAMES).all(|(field, name)| field == name.as_bytes()) {
        let words = String::from_utf8_lossy(line.trim_ascii()).chars().take(80).collect();
        return Err(LineFault::Names(words));
    }
    Ok(has_words)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(line: &str) -> Result<RayQuery, LineFault> {
        read(line.as_bytes(), Precision::Single)
    }

    #[test]
    fn a_line_of_six_numbers_has_no_limit_and_the_seventh_is_the_limit() {
        let line = RayQuery { origin: [1.0, -2.0, 0.5], direction: [0.0, 0.0, -1.0], t_max: f64::INFINITY };
        assert_eq!(of("1,-2,0.5,0,0,-1"), Ok(line));
        assert_eq!(of(" 1 ,\t-2.0,.5,0e0,-0,-1.,inf\r"), Ok(line));
        assert_eq!(of("+1,-2e0,5E-1,0,0,-1,2.5"), Ok(RayQuery { t_max: 2.5, ..line }));
    }

    #[test]
    fn infinities_and_what_is_no_number_are_numbers_in_any_spelling() {
        for (word, is) in [
            ("inf", f64::INFINITY),
            ("-Inf", f64::NEG_INFINITY),
            ("INFINITY", f64::INFINITY),
            ("+infinity", f64::INFINITY),
            ("1e39", f64::INFINITY),
            ("-1e999999999999", f64::NEG_INFINITY),
            ("1e-60", 0.0),
        ] {
            assert_eq!(of(&format!("{word},0,0,0,0,1")).unwrap().origin[0], is, "{word}");
        }
        for word in ["nan", "NaN", "NAN", "-nan", "+nan"] {
            assert!(of(&format!("0,0,0,0,0,{word}")).unwrap().direction[2].is_nan(), "{word}");
        }
        assert!(of("0,0,0,0,0,1,-0").unwrap().t_max.is_sign_negative());
    }

    #[test]
    fn a_number_is_rounded_once_and_to_the_precision_that_is_asked_for() {
        // Just above the middle between 1 and the next float: rounded to double first, it would be
        // that middle, and then go down to 1.
        let line = "1.00000005960464477539062500000000000000000001,0.1,0,0,0,1";
        let single = of(line).unwrap();
        assert_eq!(single.origin, [f64::from(1.0_f32.next_up()), f64::from(0.1_f32), 0.0]);
        assert_eq!(read(line.as_bytes(), Precision::Double).unwrap().origin[1], 0.1);
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (line, says) in [
            ("", "1 field; "),
            ("1,2,3,4,5", "5 fields; "),
            ("1,2,3,4,5,6,7,8", "8 fields; "),
            ("x,2,3,4,5", "5 fields; "),
            ("1,2,3,4,5,6,", "tmax is empty"),
            ("1,2,,4,5,6", "oz is empty"),
            ("1,2,3,4,five,6", "dy is `five`, which is no number"),
            ("1,2,3,0x4,5,6", "dx is `0x4`"),
            ("1 2,2,3,4,5,6", "ox is `1 2`"),
            ("\"1\",2,3,4,5,6", "ox is `\"1\"`"),
        ] {
            let said = of(line).unwrap_err().to_string();
            assert!(said.starts_with(says), "{line}: {said}");
        }
        let long = format!("1,2,3,4,5,{}6", "0".repeat(LONGEST));
        assert_eq!(of(&long), Err(LineFault::Long));
        assert_eq!(
            read(b"\xff,2,3,4,5,6", Precision::Single).unwrap_err().to_string(),
            "ox is `\u{fffd}`, which is no number"
        );
    }

    #[test]
    fn a_header_has_the_names_in_their_order_and_nothing_else() {
        for header in [
            "ox,oy,oz,dx,dy,dz,tmax",
            "ox, oy, oz, dx, dy, dz\r",
            "OX,OY,OZ,DX,DY,DZ,TMAX",
            "\"ox\",\"oy\",\"oz\",\"dx\",\"dy\",\"dz\"",
        ] {
            assert_eq!(is_header(header.as_bytes()), Ok(true), "{header}");
        }
        for other in ["dx,dy,dz,ox,oy,oz", "a,b,c,d,e,f", "ox,oy,oz,dx,dy,dz,t", "ox;,oy,oz,dx,dy,dz"] {
            let fault = is_header(other.as_bytes()).unwrap_err();
            assert_eq!(fault, LineFault::Names(other.into()));
            let said = fault.to_string();
            assert!(said.contains("ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,tmax is expected"), "{said}");
        }
        for no_header in [
            "",
            "ox",
            "ox,oy,oz,dx,dy",
            "1,2,x,4,5,6",
            "ox,oy,oz,dx,dy,nan",
            "ox,oy,oz,dx,dy,",
            "a,b,c,d,e,f,g,h",
        ] {
            assert_eq!(is_header(no_header.as_bytes()), Ok(false), "{no_header}");
        }
    }
}
