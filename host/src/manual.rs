//! The commands `completions` and `man`: what the shell and the manual know of the command line.

use clap::CommandFactory;
use clap_complete::Shell;
use clap_mangen::Man;

use crate::args::{Args, ManArgs};
use crate::failure::Failure;
use crate::output::Output;

/// Prints the completions for one shell.
pub fn completions(shell: Shell) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Args::command(), "strahl", &mut text);
    Output::Stdout.commit(&text)
}

/// Prints the page of the program, or that of one command.
pub fn man(args: &ManArgs) -> Result<(), Failure> {
    let mut program = Args::command();
    // Gives every command its whole name, as in `strahl-render`.
    program.build();
    let page = match &args.command {
        None => program,
        Some(name) => match program.find_subcommand(name) {
            Some(command) => command.clone().display_name(format!("strahl-{name}")),
            None => return Err(Failure::Usage(format!("there is no command {name}"))),
        },
    };
    let mut text = Vec::new();
    Man::new(page).render(&mut text).map_err(|error| Failure::Unwritable { path: None, error })?;
    Output::Stdout.commit(&text)
}
