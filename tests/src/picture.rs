//! Pictures as text.

use strahl_core::Rgb;

/// Returns the picture as text. By the brightest channel, a pixel is `.` (black), `+` (up to 1/3), `o` (up to
/// 2/3) or `#`.
pub fn picture(colors: &[Rgb], width: usize) -> String {
    let sign = |color: &Rgb| match color.max_component() {
        0.0 => '.',
        x if x <= 1.0 / 3.0 => '+',
        x if x <= 2.0 / 3.0 => 'o',
        _ => '#',
    };
    let rows: Vec<String> = colors.chunks(width).map(|row| row.iter().map(sign).collect()).collect();
    rows.join("\n")
}

/// Asserts that the picture as text equals `expected`, whose lines may be indented.
pub fn assert_picture(colors: &[Rgb], width: usize, expected: &str) {
    let expected: Vec<&str> = expected.split_whitespace().collect();
    let got = picture(colors, width);
    assert!(got == expected.join("\n"), "\nexpected\n{}\ngot\n{got}", expected.join("\n"));
}
