//! Settings in a study, as the command line has them.

use strahl_settings::{Group, Precision, SamplerSettings, Setting, Settings};

/// The same levels and cutoff with one ray in each pixel, and nothing else that changes the picture.
pub fn coarse(settings: &Settings) -> Settings {
    Settings {
        sampler: SamplerSettings::Single,
        select: None,
        precision: Precision::Single,
        seed: 0,
        ..settings.clone()
    }
}

/// The options of the command line. Levels, cutoff and sampler always; what is usual and the number of threads not.
pub fn words(settings: &Settings) -> String {
    let usual = Settings::default();
    let is_shown = |it: &&Setting| {
        let is_basic = it.group == Group::Frame || it.name == "sampler";
        let is_of_study = it.name == "size" || it.group == Group::Work;
        !is_of_study && (is_basic || it.word(settings) != it.word(&usual))
    };
    let options = settings.in_use().filter(is_shown).filter_map(|it| it.option(settings));
    options.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_those_of_the_command_line_and_what_is_usual_is_left_out() {
        assert_eq!(words(&Settings::default()), "--levels 5 --cutoff 1/512 --sampler single");
        let settings = Settings { threads: 7, seed: 3, shadow_cache: false, ..Settings::default() };
        assert_eq!(words(&settings), "--levels 5 --cutoff 1/512 --sampler single --seed 3 --no-shadow-cache");
    }
}
