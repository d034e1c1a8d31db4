//! Measurements made by firmware: a CSV file for a section of the report.
//!
//! The header is `scene,width,height,precision,levels,cutoff,sampler,instructions,rays,rmse`; every other line is one
//! setting. `instructions` and `rays` are totals of the picture. `rmse` may be empty.

use serde::Deserialize;

use crate::error::ParseError;
use crate::pareto::CostErrorPoint;

/// The header.
pub const HEADER: [&str; 10] =
    ["scene", "width", "height", "precision", "levels", "cutoff", "sampler", "instructions", "rays", "rmse"];

/// A picture rendered on a device.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct DeviceRow {
    /// The scene's name.
    pub scene: String,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// `single` or `double`, or another name.
    pub precision: String,
    /// The value of `--levels`.
    pub levels: u8,
    /// The value of `--cutoff`.
    pub cutoff: f32,
    /// The value of `--sampler`.
    pub sampler: String,
    /// Instructions of the whole picture.
    pub instructions: u64,
    /// Rays of all kinds of the whole picture.
    pub rays: u64,
    /// Error relative to the most accurate picture of the device; `None` for that picture.
    pub rmse: Option<f64>,
}

/// All pictures rendered on a device.
#[derive(Clone, Debug, PartialEq)]
pub struct DeviceMeasurements {
    /// The name of the file.
    pub name: String,
    /// Rows in the order of the file.
    pub rows: Vec<DeviceRow>,
}

impl DeviceRow {
    /// Instructions per pixel.
    pub fn per_pixel(&self) -> f64 {
        self.instructions as f64 / (f64::from(self.width) * f64::from(self.height))
    }

    /// Instructions per pixel and error, if there is one.
    pub fn point(&self) -> Option<CostErrorPoint> {
        Some(CostErrorPoint { cost: self.per_pixel(), error: self.rmse? })
    }
}

impl DeviceMeasurements {
    /// Names of the scenes, each once, in the order of the file.
    pub fn scenes(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for row in &self.rows {
            if !names.contains(&row.scene.as_str()) {
                names.push(&row.scene);
            }
        }
        names
    }

    /// Parses a file; `name` is shown in the report.
    pub fn parse(name: &str, text: &[u8]) -> Result<Self, ParseError> {
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text);
        let at = |error: csv::Error, names: &[&str]| {
            // Name the field.
            let field = match error.kind() {
                csv::ErrorKind::Deserialize { err, .. } => {
                    err.field().and_then(|field| names.get(field as usize))
                }
                _ => None,
            };
            let line = error.position().map_or(1, |position| position.line());
            let reason = match (error.kind(), field) {
                (csv::ErrorKind::Deserialize { err, .. }, Some(field)) => format!("{field}: {}", err.kind()),
                (csv::ErrorKind::UnequalLengths { expected_len, len, .. }, _) => {
                    format!("{len} fields, expected {expected_len}")
                }
                (csv::ErrorKind::Utf8 { .. }, _) => "not UTF-8".into(),
                _ => error.to_string(),
            };
            ParseError::at(line as usize, reason)
        };
        let header = reader.headers().map_err(|error| at(error, &HEADER))?.clone();
        if header.iter().ne(HEADER) {
            return Err(ParseError::at(1, format!("the first line must be {}", HEADER.join(","))));
        }
        let mut rows = Vec::new();
        let mut record = csv::StringRecord::new();
        while reader.read_record(&mut record).map_err(|error| at(error, &HEADER))? {
            let line = record.position().map_or(1, |position| position.line()) as usize;
            let row: DeviceRow = record.deserialize(Some(&header)).map_err(|error| at(error, &HEADER))?;
            check_row(&row).map_err(|reason| ParseError::at(line, reason))?;
            rows.push(row);
        }
        if rows.is_empty() {
            return Err(ParseError::at(2, "no rows after the header"));
        }
        Ok(DeviceMeasurements { name: name.to_owned(), rows })
    }
}

fn check_row(row: &DeviceRow) -> Result<(), String> {
    if row.width == 0 || row.height == 0 {
        return Err("width and height must be at least 1".into());
    }
    if row.instructions == 0 {
        return Err("instructions must be at least 1".into());
    }
    if !(row.cutoff >= 0.0 && row.cutoff <= 1.0) {
        return Err("cutoff must be between 0 and 1".into());
    }
    match row.rmse {
        Some(rmse) if !(rmse >= 0.0 && rmse <= 1.0) => Err("rmse must be between 0 and 1, or empty".into()),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(rows: &str) -> Result<DeviceMeasurements, String> {
        let text = format!("{}\n{rows}", HEADER.join(","));
        DeviceMeasurements::parse("chip.csv", text.as_bytes()).map_err(|failure| failure.to_string())
    }

    #[test]
    fn all_fields_of_a_row_are_read() {
        let device = parse(
            "balls,64,48,single,5,0.001953125,single,30720,4000,0.01\nballs,64,48,double,5,0,regular:2,9,8,\n",
        );
        let device = device.unwrap();
        assert_eq!((device.rows.len(), device.scenes()), (2, vec!["balls"]));
        assert_eq!(device.rows[0].point(), Some(CostErrorPoint { cost: 10.0, error: 0.01 }));
        assert_eq!((device.rows[1].rmse, device.rows[1].point()), (None, None));
    }

    #[test]
    fn an_error_names_its_line() {
        let good = "a,1,1,single,5,0,single,9,8,0\n";
        for (row, says) in [
            ("a,1,1,single,5,0,single,9,8", "line 3: 9 fields, expected 10"),
            ("a,x,1,single,5,0,single,9,8,0", "line 3: width: invalid digit"),
            ("a,1,1,single,500,0,single,9,8,0", "line 3: levels:"),
            ("a,0,1,single,5,0,single,9,8,0", "line 3: width and height"),
            ("a,1,1,single,5,2,single,9,8,0", "line 3: cutoff"),
            ("a,1,1,single,5,0,single,0,8,0", "line 3: instructions"),
            ("a,1,1,single,5,0,single,9,8,-1", "line 3: rmse"),
        ] {
            let error = parse(&format!("{good}{row}\n")).unwrap_err();
            assert!(error.contains(says), "{row}: {error}");
        }
        assert!(parse("").unwrap_err().contains("no rows"));
        let error = DeviceMeasurements::parse("chip.csv", b"a,b\n1,2\n").unwrap_err().to_string();
        assert!(error.contains("line 1: the first line must be scene,width"), "{error}");
    }
}
