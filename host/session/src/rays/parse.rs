//! Lines of text become rays.

use std::fmt;

use strahl_engine::RayInput;
use strahl_scene::quantity::quantity;
use strahl_settings::Precision;

/// The longest line, in bytes.
pub(super) const MAX_LINE_BYTES: usize = 1 << 16;

/// The names of the fields; the last is optional.
const FIELD_NAMES: [&str; 7] = ["ox", "oy", "oz", "dx", "dy", "dz", "tmax"];

/// Why a line is not a ray.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum RayParseError {
    /// It has this number of fields.
    FieldCount(usize),
    /// The field at this index is not a number: its text.
    NotANumber(usize, String),
    /// It is a header with other names than those of the fields: its text.
    Header(String),
    /// It is longer than 65536 bytes.
    TooLong,
}

impl fmt::Display for RayParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RayParseError::FieldCount(count) => {
                write!(
                    f,
                    "{}, expected ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,tmax",
                    quantity(*count, "field")
                )
            }
            RayParseError::NotANumber(index, word) if word.is_empty() => {
                write!(f, "{} is empty", FIELD_NAMES[*index])
            }
            RayParseError::NotANumber(index, word) => {
                write!(f, "{} is `{word}`, not a number", FIELD_NAMES[*index])
            }
            RayParseError::Header(words) => {
                write!(
                    f,
                    "`{words}` is not a valid header, expected ox,oy,oz,dx,dy,dz or \
                     ox,oy,oz,dx,dy,dz,tmax"
                )
            }
            RayParseError::TooLong => write!(f, "the line is longer than {MAX_LINE_BYTES} bytes"),
        }
    }
}

/// Parses a number and rounds it to the precision; out of range it is infinite or zero.
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

/// Parses a line.
pub(super) fn ray(line: &[u8], precision: Precision) -> Result<RayInput, RayParseError> {
    if line.len() > MAX_LINE_BYTES {
        return Err(RayParseError::TooLong);
    }
    let mut numbers = [f64::INFINITY; FIELD_NAMES.len()];
    let mut count = 0;
    let mut wrong = None;
    for field in fields(line) {
        if let Some(slot) = numbers.get_mut(count) {
            match number(field, precision) {
                Some(number) => *slot = number,
                None => wrong = wrong.or(Some((count, field))),
            }
        }
        count += 1;
    }
    if count != FIELD_NAMES.len() && count != FIELD_NAMES.len() - 1 {
        return Err(RayParseError::FieldCount(count));
    }
    if let Some((index, word)) = wrong {
        let word: String = String::from_utf8_lossy(word).chars().take(40).collect();
        return Err(RayParseError::NotANumber(index, word));
    }
    let [ox, oy, oz, dx, dy, dz, t_max] = numbers;
    Ok(RayInput { origin: [ox, oy, oz], direction: [dx, dy, dz], t_max })
}

/// Whether a line is a header: it has the number of fields of a ray, and none of them is a number. They must be the names
/// of the fields in their order, quoted or not, in upper or lower case.
pub(super) fn is_header(line: &[u8]) -> Result<bool, RayParseError> {
    let count = fields(line).count();
    let has_words = line.len() <= MAX_LINE_BYTES
        && (count == FIELD_NAMES.len() || count == FIELD_NAMES.len() - 1)
        && fields(line).all(|field| !field.is_empty() && number(field, Precision::Double).is_none());
    let unquoted = |field: &'_ [u8]| -> Vec<u8> {
        let quoted = field.strip_prefix(b"\"").and_then(|field| field.strip_suffix(b"\""));
        quoted.unwrap_or(field).trim_ascii().to_ascii_lowercase()
    };
    if has_words && !fields(line).map(unquoted).zip(FIELD_NAMES).all(|(field, name)| field == name.as_bytes())
    {
        let words = String::from_utf8_lossy(line.trim_ascii()).chars().take(80).collect();
        return Err(RayParseError::Header(words));
    }
    Ok(has_words)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(line: &str) -> Result<RayInput, RayParseError> {
        ray(line.as_bytes(), Precision::Single)
    }

    #[test]
    fn a_line_of_six_numbers_has_no_limit_and_the_seventh_is_the_limit() {
        let line = RayInput { origin: [1.0, -2.0, 0.5], direction: [0.0, 0.0, -1.0], t_max: f64::INFINITY };
        assert_eq!(of("1,-2,0.5,0,0,-1"), Ok(line));
        assert_eq!(of(" 1 ,\t-2.0,.5,0e0,-0,-1.,inf\r"), Ok(line));
        assert_eq!(of("+1,-2e0,5E-1,0,0,-1,2.5"), Ok(RayInput { t_max: 2.5, ..line }));
    }

    #[test]
    fn infinities_and_nan_are_numbers_in_any_spelling() {
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
    fn a_number_is_rounded_once_to_the_requested_precision() {
        // Just above the midpoint of 1 and the next float: rounded to double first, it would be the midpoint, and then
        // round down to 1.
        let line = "1.00000005960464477539062500000000000000000001,0.1,0,0,0,1";
        let single = of(line).unwrap();
        assert_eq!(single.origin, [f64::from(1.0_f32.next_up()), f64::from(0.1_f32), 0.0]);
        assert_eq!(ray(line.as_bytes(), Precision::Double).unwrap().origin[1], 0.1);
    }

    #[test]
    fn an_error_names_the_field_and_the_reason() {
        for (line, says) in [
            ("", "1 field, "),
            ("1,2,3,4,5", "5 fields, "),
            ("1,2,3,4,5,6,7,8", "8 fields, "),
            ("x,2,3,4,5", "5 fields, "),
            ("1,2,3,4,5,6,", "tmax is empty"),
            ("1,2,,4,5,6", "oz is empty"),
            ("1,2,3,4,five,6", "dy is `five`, not a number"),
            ("1,2,3,0x4,5,6", "dx is `0x4`"),
            ("1 2,2,3,4,5,6", "ox is `1 2`"),
            ("\"1\",2,3,4,5,6", "ox is `\"1\"`"),
        ] {
            let said = of(line).unwrap_err().to_string();
            assert!(said.starts_with(says), "{line}: {said}");
        }
        let long = format!("1,2,3,4,5,{}6", "0".repeat(MAX_LINE_BYTES));
        assert_eq!(of(&long), Err(RayParseError::TooLong));
        assert_eq!(
            ray(b"\xff,2,3,4,5,6", Precision::Single).unwrap_err().to_string(),
            "ox is `\u{fffd}`, not a number"
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
            let error = is_header(other.as_bytes()).unwrap_err();
            assert_eq!(error, RayParseError::Header(other.into()));
            let message = error.to_string();
            assert!(message.contains("expected ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,tmax"), "{message}");
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
