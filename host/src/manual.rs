//! The commands `completions` and `man`: shell completions and manual pages.

use std::io::{self, Write};

use clap::{Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;

use crate::args::{Args, ManArgs};
use crate::error::CommandError;
use crate::output::Output;

/// Prints the completions for one shell.
pub fn completions(shell: Shell) -> Result<(), CommandError> {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Args::command(), "strahl", &mut text);
    Output::Stdout.commit(&text)
}

/// Prints the page of the program, or that of one command.
pub fn man(args: &ManArgs) -> Result<(), CommandError> {
    let mut program = Args::command();
    // Sets the full name of every command, as in `strahl-render`.
    program.build();
    let page = match &args.command {
        None => program,
        Some(name) => match program.find_subcommand(name) {
            Some(command) => command.clone().display_name(format!("strahl-{name}")),
            None => return Err(CommandError::Usage(format!("unknown command {name}"))),
        },
    };
    let mut text = Vec::new();
    write(page, &mut text).map_err(|error| CommandError::Unwritable { path: None, error })?;
    Output::Stdout.commit(&text)
}

/// Writes a page, section by section; the text after the help is a section of its own.
fn write(page: Command, out: &mut Vec<u8>) -> io::Result<()> {
    let behind = page.get_after_long_help().map(|text| text.to_string()).unwrap_or_default();
    let has_commands = page.has_subcommands();
    let man = Man::new(page).source(concat!("strahl ", env!("CARGO_PKG_VERSION"))).manual("strahl");
    man.render_title(out)?;
    man.render_name_section(out)?;
    man.render_synopsis_section(out)?;
    man.render_description_section(out)?;
    man.render_options_section(out)?;
    if has_commands {
        man.render_subcommands_section(out)?;
    }
    // A title, and lines as they are, or running text.
    let Some((title, text)) = behind.split_once(':') else { return Ok(()) };
    writeln!(out, ".SH {}", title.to_uppercase())?;
    let has_lines = text.starts_with('\n');
    if has_lines {
        writeln!(out, ".nf")?;
    }
    for line in text.trim_matches('\n').lines() {
        // Hyphens stay ASCII, and no line is parsed as a roff request.
        writeln!(out, "\\&{}", line.trim().replace('\\', "\\e").replace('-', "\\-"))?;
    }
    if has_lines {
        writeln!(out, ".fi")?;
    }
    Ok(())
}
