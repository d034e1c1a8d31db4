//! The program `strahl`.

use std::process::ExitCode;

use clap::Parser;
use strahl::args::{Args, Command};

fn main() -> ExitCode {
    let args = Args::parse();
    let done = match args.command {
        Command::Render(args) => strahl::render::run(&args),
        Command::Info(args) => strahl::info::run(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            strahl::output::say(&failure);
            ExitCode::from(failure.status())
        }
    }
}
