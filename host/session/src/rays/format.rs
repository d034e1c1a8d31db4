//! Hits become lines of text.

use std::fmt::{Display, LowerExp};
use std::io::Write;

use strahl_engine::RayHit;
use strahl_settings::Precision;

/// The names of the fields.
pub(super) const HEADER: &str = "hit,t,object,px,py,pz,nx,ny,nz\n";

/// Appends the row of a hit, or of a miss.
pub(super) fn push_row(rows: &mut Vec<u8>, hit: Option<RayHit>, precision: Precision) {
    let Some(RayHit { t, object, point, normal }) = hit else {
        rows.extend_from_slice(b"0,,,,,,,,\n");
        return;
    };
    rows.extend_from_slice(b"1,");
    number(rows, t, precision);
    // Writing to a vector cannot fail.
    let _ = write!(rows, ",{object}");
    for x in point.into_iter().chain(normal) {
        rows.push(b',');
        number(rows, x, precision);
    }
    rows.push(b'\n');
}

/// Appends a number in the shortest form that reads back exactly in this precision.
fn number(rows: &mut Vec<u8>, x: f64, precision: Precision) {
    let narrow = x as f32;
    if precision == Precision::Single && f64::from(narrow) == x {
        shortest(rows, narrow, x);
    } else {
        shortest(rows, x, x);
    }
}

/// Appends `x`, whose value is `value`, with or without an exponent, whichever is shorter.
fn shortest(rows: &mut Vec<u8>, x: impl Display + LowerExp, value: f64) {
    let start = rows.len();
    let _ = write!(rows, "{x}");
    // In this range an exponent never makes it shorter.
    let is_plain = value == 0.0 || (value.abs() >= 0.01 && value.abs() < 1000.0);
    if !is_plain {
        let second = rows.len();
        let _ = write!(rows, "{x:e}");
        if rows.len() - second < second - start {
            rows.drain(start..second);
        } else {
            rows.truncate(second);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(x: f64, precision: Precision) -> String {
        let mut rows = Vec::new();
        number(&mut rows, x, precision);
        String::from_utf8(rows).unwrap()
    }

    #[test]
    fn numbers_have_their_shortest_form() {
        for (x, short) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (-0.5, "-0.5"),
            (100.0, "100"),
            (1000.0, "1e3"),
            (1024.0, "1024"),
            (1.5e6, "1.5e6"),
            (0.01, "0.01"),
            (0.001, "1e-3"),
            (0.0015, "0.0015"),
            (1e-30, "1e-30"),
            (-1e30, "-1e30"),
        ] {
            assert_eq!(text(f64::from(x as f32), Precision::Single), short);
            assert_eq!(text(x, Precision::Double), short);
        }
        assert_eq!(text(f64::from(0.1_f32), Precision::Single), "0.1");
        assert_eq!(text(f64::from(0.1_f32), Precision::Double), "0.10000000149011612");
        // Out of the range of single precision.
        assert_eq!(text(1e60, Precision::Single), "1e60");
    }

    #[test]
    fn numbers_read_back_exactly_and_no_form_is_shorter() {
        let mut state = 0x5eed_u32;
        for _ in 0..20_000 {
            state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            let x = f32::from_bits(state);
            if !x.is_finite() {
                continue;
            }
            let short = text(f64::from(x), Precision::Single);
            assert_eq!(short.parse::<f32>().unwrap().to_bits(), x.to_bits(), "{short}");
            for other in [format!("{x}"), format!("{x:e}"), format!("{x:?}")] {
                assert!(short.len() <= other.len(), "{short} {other}");
            }
        }
    }

    #[test]
    fn the_fields_of_a_miss_are_empty() {
        let mut rows = Vec::new();
        push_row(&mut rows, None, Precision::Single);
        assert_eq!(rows, b"0,,,,,,,,\n");
        let hit = RayHit { t: 2.5, object: 7, point: [1.0, 2.0, -0.5], normal: [0.0, 0.0, 1.0] };
        rows.clear();
        push_row(&mut rows, Some(hit), Precision::Single);
        assert_eq!(rows, b"1,2.5,7,1,2,-0.5,0,0,1\n");
    }
}
