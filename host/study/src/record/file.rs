//! `study.json`: written, read and checked.

use serde::Deserialize;
use serde_json::error::Category;

use super::{ErrorMetrics, FORMAT, Study, VERSION};
use crate::error::ParseError;

impl Study {
    /// The file.
    pub fn to_json(&self) -> String {
        let mut json = serde_json::to_string_pretty(self).unwrap_or_default();
        json.push('\n');
        json
    }

    /// Reads the bytes of a file.
    pub fn parse(bytes: &[u8]) -> Result<Self, ParseError> {
        /// What every version begins with.
        #[derive(Deserialize)]
        struct StudyHeader {
            format: Option<String>,
            version: Option<u32>,
        }
        let wrong = ParseError::from;
        let at = |error: serde_json::Error| ParseError::at(error.line(), reason(&error));
        let other = || format!("this is no study.json: that begins with \"format\": \"{FORMAT}\"");
        let head: StudyHeader = serde_json::from_slice(bytes).map_err(|error| match error.classify() {
            // It is JSON, but of something else.
            Category::Data => wrong(other()),
            _ => at(error),
        })?;
        let (format, version) = (head.format.ok_or_else(|| wrong(other()))?, head.version);
        if format != FORMAT {
            return Err(wrong(format!("this is no study.json: its format is `{format}`, not `{FORMAT}`")));
        }
        let found = version.ok_or_else(|| wrong("this study does not say its version".into()))?;
        if found != VERSION {
            return Err(wrong(format!("this study is of version {found}; this program reads {VERSION}")));
        }
        let study: Study = serde_json::from_slice(bytes).map_err(at)?;
        study.check().map_err(wrong)?;
        Ok(study)
    }

    /// What no schema can say: places in lists are inside, and what is a measurement has one.
    fn check(&self) -> Result<(), String> {
        let count = self.runs.len();
        let steps = self.knobs.iter().flat_map(|knob| knob.steps.iter().map(|step| step.run));
        let techniques = self.techniques.iter().flat_map(|it| [it.without, it.with]).flatten();
        let pictures = self.pictures.iter().filter_map(|it| it.run);
        let threads = self.threads.iter().copied();
        if let Some(place) =
            steps.chain(techniques).chain(pictures).chain(threads).find(|place| *place >= count)
        {
            return Err(format!("there is no run {place}: there are {count}, counted from 0"));
        }
        for (place, run) in self.runs.iter().enumerate() {
            if run.cpu.is_empty() || run.wall.is_empty() {
                return Err(format!("run {place} has no measured time"));
            }
            let is_wrong = |value: &f64| !(value.is_finite() && *value >= 0.0);
            let ErrorMetrics { rmse, largest, beyond, .. } = run.error;
            if run.cpu.iter().chain(&run.wall).chain(&[run.work, rmse, largest, beyond]).any(is_wrong) {
                return Err(format!("a time, the work or an error of run {place} is negative"));
            }
        }
        Ok(())
    }
}

/// What is wrong, without the place, which stands before it.
fn reason(error: &serde_json::Error) -> String {
    let text = error.to_string();
    text.rsplit_once(" at line ").map_or(text.clone(), |(reason, _)| reason.to_owned())
}

/// The JSON Schema of `study.json`.
pub fn schema() -> String {
    let schema = serde_json::to_string_pretty(&schemars::schema_for!(Study)).unwrap_or_default();
    schema + "\n"
}
