//! Commands of a page, and the words that a shell makes of one.

use crate::book::page::Page;
use std::path::Path;
use std::process;

/// A command as it is typed.
#[derive(Debug, PartialEq)]
pub(super) struct Command {
    pub(super) text: String,
    /// The line of the page.
    pub(super) line: usize,
}

/// Returns the commands of a page: those in blocks of `sh`, lines that end in `\` joined with the
/// next, without lines that are empty or a comment.
pub(super) fn commands(page: &Page) -> Vec<Command> {
    let mut commands = Vec::new();
    for block in page.blocks.iter().filter(|block| block.language == "sh") {
        let mut begun: Option<Command> = None;
        for (number, line) in block.text.lines().enumerate() {
            let (part, goes_on) = match line.strip_suffix('\\') {
                Some(part) => (part, true),
                None => (line, false),
            };
            let mut command = begun
                .take()
                .unwrap_or_else(|| Command { text: String::new(), line: block.line + 1 + number });
            command.text.push_str(part);
            if goes_on {
                begun = Some(command);
            } else if !(command.text.trim().is_empty() || command.text.trim().starts_with('#')) {
                commands.push(command);
            }
        }
        commands.extend(begun);
    }
    commands
}

/// Asks a shell in `folder` for the words of a command: without its comment, with the files that
/// its patterns fit. What the command prints may be meant for a file.
pub(super) fn words(command: &str, folder: &Path) -> Result<Vec<String>, String> {
    let command = without_comment(command).split(" > ").next().unwrap_or_default();
    if command.contains(['|', ';', '&', '<', '>', '$', '`']) {
        return Err("more than a program with its arguments".into());
    }
    let script = format!("printf '%s\\0' {command}");
    let shell = process::Command::new("sh").arg("-c").arg(script).current_dir(folder).output();
    let output = shell.map_err(|error| format!("no shell: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let text = String::from_utf8(output.stdout).map_err(|error| error.to_string())?;
    Ok(text.split_terminator('\0').map(String::from).collect())
}

/// What stands before a `#` that begins a word.
fn without_comment(command: &str) -> &str {
    let (mut quote, mut before) = (None, ' ');
    for (place, letter) in command.char_indices() {
        match (quote, letter) {
            (None, '#') if before == ' ' => return &command[..place],
            (None, '\'' | '"') => quote = Some(letter),
            (Some(open), letter) if letter == open => quote = None,
            _ => {}
        }
        before = letter;
    }
    command
}

#[test]
fn lines_become_commands() {
    let page = Page::of("```sh\na 1 \\\n  2 # three\n\n# four\nb\n```\n```\nc\n```\n");
    let found = commands(&page);
    let wanted = [("a 1   2 # three", 2), ("b", 6)];
    assert_eq!(found, wanted.map(|(text, line)| Command { text: text.into(), line }));
}

#[test]
fn a_shell_reads_words() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.film", "b.film"] {
        std::fs::write(folder.path().join(name), "").unwrap();
    }
    let found = words("film merge *.film 'c d' \"e\" > f  # g", folder.path());
    assert_eq!(found.unwrap(), ["film", "merge", "a.film", "b.film", "c d", "e"]);
    assert_eq!(words("a 'b # c'd#e # f; g", folder.path()).unwrap(), ["a", "b # cd#e"]);
    assert!(words("a | b", folder.path()).is_err() && words("'a", folder.path()).is_err());
}
