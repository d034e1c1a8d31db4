//! Copies memory.x to the linker's search path, and adds cortex-m-rt's linker script.

use std::{env, fs, path::PathBuf};

fn main() {
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap());
    let riscv = env::var("CARGO_CFG_TARGET_ARCH").unwrap() == "riscv32";
    let memory = if riscv { "memory-virt.x" } else { "memory.x" };
    fs::copy(memory, out.join(memory)).unwrap();
    println!("cargo:rustc-link-search={}", out.display());
    if riscv {
        println!("cargo:rustc-link-arg-bins=-Tmemory-virt.x"); // riscv-rt's script does not include it
    }
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rustc-link-arg-bin=proof=--defsym=only_linked=1");
    println!("cargo:rerun-if-changed={memory}");
}
