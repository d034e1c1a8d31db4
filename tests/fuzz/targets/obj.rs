#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| strahl_loader_tests::loading::obj(bytes));
