//! The program `strahl`.

use std::process::ExitCode;

use clap::Parser;
use strahl::args::{Args, Command, Schema};
use strahl::error::CommandStatus;
use strahl::output::Output;
use strahl_scene::toml_scene;
use strahl_study::record::file;

fn main() -> ExitCode {
    let args = Args::parse();
    let success = |()| CommandStatus::Success;
    let done = match args.command {
        Command::Render { args, aim, print_settings: false } => strahl::render::run(&args, &aim),
        Command::Render { args, print_settings: true, .. } => {
            strahl::render::print_settings(&args).map(success)
        }
        Command::Cast(args) => strahl::cast::run(&args).map(success),
        Command::Watch(args) => strahl::watch::run(&args).map(CommandStatus::Stopped),
        Command::Bake(args) => strahl::bake::run(&args).map(success),
        Command::Explain(args) => strahl::explain::run(&args).map(success),
        Command::Info(args) => strahl::info::run(&args).map(success),
        Command::Study(args) => strahl::study_command::run(&args).map(success),
        Command::Schema { format } => {
            let schema = match format {
                Schema::Scene => toml_scene::schema(),
                Schema::Study => file::schema(),
            };
            Output::Stdout.commit(schema.as_bytes()).map(success)
        }
        Command::Compare(args) => strahl::compare::run(&args),
        Command::Generate(args) => strahl::generate::run(&args).map(success),
        Command::Completions { shell } => strahl::manual::completions(shell).map(success),
        Command::Man(args) => strahl::manual::man(&args).map(success),
    };
    match done {
        Ok(answer) => ExitCode::from(answer.status()),
        Err(failure) => {
            strahl::output::print_error(&failure);
            ExitCode::from(failure.status())
        }
    }
}
