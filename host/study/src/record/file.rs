//! `study.json`: write, read and validate.

use serde::Deserialize;
use serde_json::error::Category;

use super::{ErrorMetrics, FORMAT, Study, VERSION};
use crate::error::ParseError;

impl Study {
    /// The contents of the file.
    pub fn to_json(&self) -> String {
        let mut json = serde_json::to_string_pretty(self).unwrap_or_default();
        json.push('\n');
        json
    }

    /// Parses a file. Checks format, version and indices.
    pub fn parse(bytes: &[u8]) -> Result<Self, ParseError> {
        /// The first fields, the same in every version.
        #[derive(Deserialize)]
        struct StudyHeader {
            format: Option<String>,
            version: Option<u32>,
        }
        let wrong = ParseError::from;
        let at = |error: serde_json::Error| ParseError::at(error.line(), reason(&error));
        let other = || format!("not a study.json file: it must begin with \"format\": \"{FORMAT}\"");
        let head: StudyHeader = serde_json::from_slice(bytes).map_err(|error| match error.classify() {
            // Valid JSON with other contents.
            Category::Data => wrong(other()),
            _ => at(error),
        })?;
        let (format, version) = (head.format.ok_or_else(|| wrong(other()))?, head.version);
        if format != FORMAT {
            return Err(wrong(format!("not a study.json file: its format is `{format}`, not `{FORMAT}`")));
        }
        let found = version.ok_or_else(|| wrong("the study has no version".into()))?;
        if found != VERSION {
            return Err(wrong(format!(
                "study version {found} is not supported; this program reads version {VERSION}"
            )));
        }
        let study: Study = serde_json::from_slice(bytes).map_err(at)?;
        study.check().map_err(wrong)?;
        Ok(study)
    }

    /// Checks beyond the schema: indices are in range, and every run has a time.
    fn check(&self) -> Result<(), String> {
        let count = self.runs.len();
        let steps = self.knobs.iter().flat_map(|knob| knob.steps.iter().map(|step| step.run));
        let techniques = self.techniques.iter().flat_map(|it| [it.without, it.with]).flatten();
        let pictures = self.pictures.iter().filter_map(|it| it.run);
        let threads = self.threads.iter().copied();
        if let Some(index) =
            steps.chain(techniques).chain(pictures).chain(threads).find(|index| *index >= count)
        {
            return Err(format!("run {index} does not exist; there are {count} runs, counted from 0"));
        }
        for (index, run) in self.runs.iter().enumerate() {
            if run.cpu_seconds.is_empty() || run.elapsed_seconds.is_empty() {
                return Err(format!("run {index} has no measured time"));
            }
            let is_wrong = |value: &f64| !(value.is_finite() && *value >= 0.0);
            let ErrorMetrics { rmse, largest, beyond, .. } = run.error;
            if run
                .cpu_seconds
                .iter()
                .chain(&run.elapsed_seconds)
                .chain(&[run.work, rmse, largest, beyond])
                .any(is_wrong)
            {
                return Err(format!("a time, the work or an error of run {index} is negative"));
            }
        }
        Ok(())
    }
}

/// The message without the position, which is printed before it.
fn reason(error: &serde_json::Error) -> String {
    let text = error.to_string();
    text.rsplit_once(" at line ").map_or(text.clone(), |(reason, _)| reason.to_owned())
}

/// The JSON Schema of `study.json`.
pub fn schema() -> String {
    let schema = serde_json::to_string_pretty(&schemars::schema_for!(Study)).unwrap_or_default();
    schema + "\n"
}
