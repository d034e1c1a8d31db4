//! The completions and the manual pages.

use clap::CommandFactory;
use strahl::args::Args;

use crate::program::{EMPTY, Folder};

/// Every command with its long options, as the program knows them.
fn commands() -> Vec<(String, Vec<String>)> {
    let program = Args::command();
    let options = |command: &clap::Command| {
        command.get_opts().filter_map(|option| Some(option.get_long()?.to_owned())).collect()
    };
    program.get_subcommands().map(|command| (command.get_name().to_owned(), options(command))).collect()
}

#[test]
fn the_completions_know_every_command_and_option() {
    let folder = Folder::with(EMPTY);
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let text = String::from_utf8(folder.done(&format!("completions {shell}"))).unwrap();
        assert!(commands().len() >= 5);
        for (command, options) in commands() {
            assert!(text.contains(&command), "{shell}: {command}");
            for option in options {
                assert!(text.contains(&option), "{shell}: {command} --{option}");
            }
        }
    }
}

#[test]
fn the_page_of_the_program_names_every_command_and_theirs_every_option() {
    let folder = Folder::with(EMPTY);
    // In roff a hyphen is written `\-`.
    let page = |words: &str| String::from_utf8(folder.done(words)).unwrap().replace("\\-", "-");
    let whole = page("man");
    assert!(whole.contains(".TH strahl 1"), "{whole}");
    for (command, options) in commands() {
        assert!(whole.contains(&format!("strahl-{command}(1)")), "{command} is not in\n{whole}");
        let its = page(&format!("man {command}"));
        assert!(its.contains(&format!(".TH strahl-{command} 1")), "{its}");
        for option in options {
            assert!(its.contains(&format!("--{option}")), "{command} --{option} is not in\n{its}");
        }
    }
}

#[test]
fn examples_stand_line_by_line_in_a_section_of_their_own() {
    let folder = Folder::with(EMPTY);
    let page = |words: &str| String::from_utf8(folder.done(words)).unwrap();
    let render = page("man render");
    let examples =
        render.split(".SH EXAMPLES\n.nf\n").nth(1).and_then(|rest| rest.strip_suffix(".fi\n")).unwrap();
    assert!(examples.lines().count() > 3, "{examples}");
    assert!(examples.lines().all(|line| line.starts_with("\\&strahl render ")), "{examples}");
    assert!(page("man").contains(".SH EXIT STATUS\n"));
    assert!(!page("man cast").contains(".SH EXAMPLES"));
    assert_eq!(page("help render"), page("render --help"));
}

#[test]
fn a_shell_or_a_command_that_is_not_there_is_wrong_usage() {
    let folder = Folder::with(EMPTY);
    folder.run("completions").failed(2, "<SHELL>");
    folder.run("completions dos").failed(2, "dos");
    folder.run("man paint").failed(2, "unknown command paint");
}
