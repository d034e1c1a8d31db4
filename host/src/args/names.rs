//! Options with named values.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use strahl_settings::{Choice, Named};

/// Parser of a value of `T` by its name.
pub(super) fn name_of<T: Choice + Send + Sync>() -> impl TypedValueParser<Value = T> {
    parser(T::NAMES).try_map(|name| T::from_name(&name).ok_or("unknown name"))
}

/// Parser of one of these names.
pub(super) fn parser(names: &'static [Named]) -> PossibleValuesParser {
    let value = |it: &Named| PossibleValue::new(it.name).help(it.about()).aliases(it.aliases);
    PossibleValuesParser::new(names.iter().map(value))
}
