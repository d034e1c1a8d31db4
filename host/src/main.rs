//! The program `strahl`.

use std::process::ExitCode;

use clap::Parser;
use strahl::args::{Args, Command, Schema};
use strahl::failure::Answer;
use strahl::output::Output;
use strahl_scene::toml_scene;
use strahl_study::record::file;

fn main() -> ExitCode {
    let args = Args::parse();
    let yes = |()| Answer::Yes;
    let done = match args.command {
        Command::Render { args, aim, print_settings: false } => strahl::render::run(&args, &aim),
        Command::Render { args, print_settings: true, .. } => strahl::render::print_settings(&args).map(yes),
        Command::Cast(args) => strahl::cast::run(&args).map(yes),
        Command::Watch(args) => strahl::watch::run(&args).map(Answer::Ended),
        Command::Bake(args) => strahl::bake::run(&args).map(yes),
        Command::Explain(args) => strahl::explain::run(&args).map(yes),
        Command::Info(args) => strahl::info::run(&args).map(yes),
        Command::Study(args) => strahl::study_command::run(&args).map(yes),
        Command::Schema { what } => {
            let schema = match what {
                Schema::Scene => toml_scene::schema(),
                Schema::Study => file::schema(),
            };
            Output::Stdout.commit(schema.as_bytes()).map(yes)
        }
        Command::Compare(args) => strahl::compare::run(&args),
        Command::Generate(args) => strahl::generate::run(&args).map(yes),
        Command::Completions { shell } => strahl::manual::completions(shell).map(yes),
        Command::Man(args) => strahl::manual::man(&args).map(yes),
    };
    match done {
        Ok(answer) => ExitCode::from(answer.status()),
        Err(failure) => {
            strahl::output::complain(&failure);
            ExitCode::from(failure.status())
        }
    }
}
