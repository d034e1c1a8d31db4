//! Small sets of named things, known when compiling.

/// Makes `$Set`, a set of `$Kind`s (an enum without data, of at most 16), all `const`.
macro_rules! set_of {
    ($(#[$doc:meta])* $Set:ident of $Kind:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq)]
        pub struct $Set(u16);

        impl $Set {
            /// The set of none.
            pub const NONE: Self = Self(0);
            /// The set of all.
            pub const ALL: Self = Self::of(&$Kind::ALL);

            /// The set of these.
            pub const fn of(kinds: &[$Kind]) -> Self {
                let mut set = Self::NONE;
                let mut rest = kinds;
                while let [kind, others @ ..] = rest {
                    set = set.with(*kind);
                    rest = others;
                }
                set
            }

            /// This set and `kind`.
            pub const fn with(self, kind: $Kind) -> Self {
                Self(self.0 | 1 << kind as u16)
            }

            /// Whether `kind` is in it.
            #[inline(always)]
            pub const fn has(self, kind: $Kind) -> bool {
                self.0 & 1 << kind as u16 != 0
            }

            /// Whether all of `other` is in it.
            pub const fn contains(self, other: Self) -> bool {
                other.0 & !self.0 == 0
            }

            /// How many there are.
            pub const fn len(self) -> u32 {
                self.0.count_ones()
            }

            /// Whether there is none.
            pub const fn is_empty(self) -> bool {
                self.0 == 0
            }

            /// Everything that is in one of both.
            pub const fn union(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }

            /// The members, in the order of their declaration.
            pub fn iter(self) -> impl Iterator<Item = $Kind> {
                $Kind::ALL.into_iter().filter(move |kind| self.has(*kind))
            }
        }

        impl core::fmt::Debug for $Set {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.debug_set().entries(self.iter()).finish()
            }
        }
    };
}
pub(crate) use set_of;
