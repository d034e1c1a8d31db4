//! How items are found, by the names that the program has for it so far.

pub use strahl_settings::accelerator::{
    Accel, AccelChoice as Choice, AccelKind as Kind, AccelSettings as Finding, Bounds, HEAPS, MAILBOX,
    MAILBOXES, STACK, Walk,
};
