//! Kinds (enums without data), and bit sets over them, usable in constants.

/// Defines `ALL` of an enum without data. A variant that is missing does not compile.
macro_rules! all_kinds {
    ($Kind:ident { $($Variant:ident),+ $(,)? }) => {
        impl $Kind {
            /// All kinds, in the order of their declaration.
            pub const ALL: [$Kind; [$($Kind::$Variant),+].len()] = [$($Kind::$Variant),+];
        }

        const _: fn($Kind) = |kind| match kind {
            $($Kind::$Variant)|+ => (),
        };
    };
}
pub(crate) use all_kinds;

/// Declares `$Set`, a set of values of `$Kind`: an enum without data, with at most 16 variants and a
/// constant `ALL` with all of them.
macro_rules! bit_set {
    ($(#[$doc:meta])* $Set:ident of $Kind:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq)]
        pub struct $Set(u16);

        impl $Set {
            /// The empty set.
            pub const NONE: Self = Self(0);
            /// The set of all kinds.
            pub const ALL: Self = Self::of(&$Kind::ALL);

            /// The set of the given kinds.
            pub const fn of(mut kinds: &[$Kind]) -> Self {
                let mut set = Self::NONE;
                while let [kind, rest @ ..] = kinds {
                    set = set.with(*kind);
                    kinds = rest;
                }
                set
            }

            /// This set with `kind` added.
            pub const fn with(self, kind: $Kind) -> Self {
                Self(self.0 | 1 << kind as u16)
            }

            /// Whether `kind` is in this set.
            #[inline(always)]
            pub const fn contains(self, kind: $Kind) -> bool {
                self.0 & 1 << kind as u16 != 0
            }

            /// Whether every kind in `other` is in this set.
            pub const fn is_superset(self, other: Self) -> bool {
                other.0 & !self.0 == 0
            }

            /// The number of kinds in this set.
            pub const fn len(self) -> u32 {
                self.0.count_ones()
            }

            /// Whether this set has no kind.
            pub const fn is_empty(self) -> bool {
                self.0 == 0
            }

            /// The kinds that are in this set, in `other`, or in both.
            pub const fn union(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }

            /// The kinds that are in this set and not in `other`.
            pub const fn difference(self, other: Self) -> Self {
                Self(self.0 & !other.0)
            }

            /// The kinds in this set, in the order of their declaration.
            pub fn iter(self) -> impl Iterator<Item = $Kind> {
                $Kind::ALL.into_iter().filter(move |kind| self.contains(*kind))
            }
        }

        impl core::fmt::Debug for $Set {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.debug_set().entries(self.iter()).finish()
            }
        }
    };
}
pub(crate) use bit_set;
