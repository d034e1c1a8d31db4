#![no_main]

#[path = "../packs.rs"]
mod packs;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| packs::pack(bytes));
