//! Enumerations with named values.

/// The name and the documentation of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Named {
    /// The name.
    pub name: &'static str,
    /// Other accepted names.
    pub aliases: &'static [&'static str],
    /// The documentation.
    pub doc: &'static str,
}

impl Named {
    /// The documentation without the full stop at its end.
    pub fn about(&self) -> &'static str {
        self.doc.trim().trim_end_matches('.')
    }
}

/// An enumeration with named values, declared by [`choices!`](crate::choices).
pub trait Choice: Copy + PartialEq + 'static {
    /// All values.
    const VALUES: &'static [Self];

    /// The names, in the order of the values.
    const NAMES: &'static [Named];

    /// The name of this value.
    fn name_of(self) -> &'static str {
        let index = Self::VALUES.iter().position(|it| *it == self);
        index.and_then(|index| Self::NAMES.get(index)).map_or("", |named| named.name)
    }

    /// The value with this name or alias.
    fn from_name(name: &str) -> Option<Self> {
        let has_name = |it: &Named| it.name == name || it.aliases.contains(&name);
        Self::NAMES.iter().position(has_name).and_then(|index| Self::VALUES.get(index)).copied()
    }
}

/// Declares enumerations with named values.
///
/// ```
/// use strahl_settings::{Choice, choices};
///
/// choices! {
///     /// A volume.
///     pub enum Volume {
///         /// Inaudible.
///         Silent = "silent",
///         /// Clearly audible.
///         Loud = "loud" | "noisy",
///     }
/// }
///
/// assert_eq!(Volume::from_name("noisy"), Some(Volume::Loud));
/// assert_eq!(Volume::Silent.to_string(), "silent");
/// assert_eq!(Volume::NAMES[1].about(), "Clearly audible");
/// ```
#[macro_export]
macro_rules! choices {
    ($(
        $(#[doc = $type_doc:literal])+
        pub enum $Type:ident {
            $( $(#[doc = $doc:literal])+ $Value:ident = $name:literal $(| $alias:literal)*, )+
        }
    )+) => {$(
        $(#[doc = $type_doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $Type {
            $( $(#[doc = $doc])+ $Value, )+
        }

        impl $Type {
            /// All values.
            pub const ALL: [Self; [$(stringify!($Value)),+].len()] = [$($Type::$Value),+];

            /// The name of this value.
            pub fn name(self) -> &'static str {
                $crate::Choice::name_of(self)
            }
        }

        impl $crate::Choice for $Type {
            const VALUES: &'static [Self] = &Self::ALL;
            const NAMES: &'static [$crate::Named] = &[$($crate::Named {
                name: $name,
                aliases: &[$($alias),*],
                doc: concat!($($doc),+),
            }),+];
        }

        impl core::fmt::Display for $Type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str(self.name())
            }
        }
    )+};
}

#[cfg(test)]
mod tests {
    use super::*;

    choices! {
        /// Of two lines,
        /// one sentence.
        pub enum Side {
            /// To the west
            /// on maps.
            Left = "left" | "west",
            /// The other.
            Right = "right",
        }
    }

    #[test]
    fn a_value_is_found_by_its_name_and_its_aliases_only() {
        assert_eq!(
            ["left", "west", "right"].map(Side::from_name),
            [Side::Left, Side::Left, Side::Right].map(Some)
        );
        assert_eq!(["", "Left", "lef", "left "].map(Side::from_name), [None; 4]);
    }

    #[test]
    fn lines_of_documentation_become_one() {
        assert_eq!(
            Side::NAMES.iter().map(Named::about).collect::<Vec<_>>(),
            ["To the west on maps", "The other"]
        );
    }
}
