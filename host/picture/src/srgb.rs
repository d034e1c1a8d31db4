//! sRGB encoding, IEC 61966-2-1, in double precision.
//!
//! 8-bit pictures are encoded by the core ([`strahl_core::Rgb::to_srgb8`]).

use std::array;

use strahl_core::Rgb;

/// Encodes linear light, clamped to `[0, 1]`. NaN stays NaN.
pub fn encode(linear: f32) -> f64 {
    let v = f64::from(linear);
    if v.is_nan() {
        v
    } else if v >= 1.0 {
        1.0
    } else if v > 0.003_130_8 {
        1.055 * libm::pow(v, 1.0 / 2.4) - 0.055
    } else if v > 0.0 {
        12.92 * v
    } else {
        0.0
    }
}

/// The linear light of each 8-bit value.
pub fn decode8() -> [f32; 256] {
    array::from_fn(|byte| {
        let v = byte as f64 / 255.0;
        let linear = if v <= 0.040_45 { v / 12.92 } else { libm::pow((v + 0.055) / 1.055, 2.4) };
        linear as f32
    })
}

/// Decodes 8-bit values with the table of [`decode8`].
pub fn decode(table: &[f32; 256], bytes: [u8; 3]) -> Rgb {
    let [r, g, b] = bytes.map(|byte| table[usize::from(byte)]);
    Rgb::new(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_8_bit_value_is_decoded_and_encoded_to_itself() {
        let table = decode8();
        for byte in 0..=255 {
            assert_eq!(decode(&table, [byte; 3]).to_srgb8(), [byte; 3]);
            let back = encode(table[usize::from(byte)]) * 255.0;
            // The light was rounded to 24 bits, and the curve is at most 13 times as steep.
            assert!((back - f64::from(byte)).abs() <= 1e-4, "{byte}: {back}");
        }
    }

    #[test]
    fn the_encoding_has_the_values_of_the_standard_and_is_clamped_to_0_and_1() {
        // On the linear segment, and at half intensity.
        assert!((encode(0.002) - 0.025_84).abs() <= 1e-8);
        assert!((encode(0.5) - 0.735_356_98).abs() <= 1e-8);
        assert_eq!([-1.0, -0.0, 0.0, f32::NEG_INFINITY].map(encode), [0.0; 4]);
        assert_eq!([1.0, 7.0, f32::INFINITY].map(encode), [1.0; 3]);
        assert!(encode(f32::NAN).is_nan());
    }
}
