//! Generates the models of revolution of `scenes/models`.
//!
//! ```text
//! cargo run -p strahl-tests --example models -- scenes/models
//! ```

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use strahl_tests::models;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).ok_or("usage: models FOLDER")?);
    for (name, bytes) in models::files() {
        fs::write(folder.join(name), bytes)?;
    }
    Ok(())
}
