//! Reading the command line.

use crate::VERSION;
use crate::for_shells;
use crate::options::RenderOptions;
use crate::say::say;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, Error, FromArgMatches, Parser};
use std::ffi::OsString;
use traylib_integrators::{Method, MethodOption, MethodSetting, OptionValues};

/// The options of a program. Ends it if they make no sense, or if only help or the
/// version is wanted.
pub fn parse<O: Parser>() -> O {
    answer(&mut O::command());
    O::try_parse().unwrap_or_else(|error| end(&error))
}

/// The command line of a program that renders by a method.
#[derive(Clone, Debug)]
pub struct CommandLine<O> {
    /// The options that all programs have.
    pub render: RenderOptions,
    /// The method by which it is rendered.
    pub method: Method,
    /// The program's other options.
    pub own: O,
}

impl<O: Args> CommandLine<O> {
    /// Reads the words that the program was started with; without options its method is
    /// `plain`. Ends the program as [`parse`] does.
    pub fn parse(plain: Method) -> Self {
        answer(&mut command::<O>(plain));
        Self::read(plain, std::env::args_os()).unwrap_or_else(|error| end(&error))
    }

    fn read(plain: Method, words: impl IntoIterator<Item = OsString>) -> Result<Self, Error> {
        let mut command = command::<O>(plain);
        let mut matches = command.try_get_matches_from_mut(words)?;
        let method = plain.with(&settings(plain, &matches));
        let method = method.map_err(|error| command.error(ErrorKind::ArgumentConflict, error))?;
        let render = RenderOptions::from_arg_matches_mut(&mut matches)?;
        Ok(Self { render, method, own: O::from_arg_matches_mut(&mut matches)? })
    }
}

fn command<O: Args>(plain: Method) -> Command {
    let command = Command::new(plain.name()).version(VERSION).max_term_width(80);
    let own = plain.options().iter().map(|&option| argument(plain, option));
    let command = RenderOptions::augment_args(command).args(own);
    let (about, more) = plain.about();
    // Set last: the texts of groups of options would stand there.
    let command = O::augment_args(command).about(about).long_about(None);
    let command = command.after_long_help(crate::examples(plain.name()));
    match more {
        Some(more) => command.long_about(format!("{about}\n\n{more}")),
        None => command,
    }
}

fn argument(method: Method, option: MethodOption) -> Arg {
    let argument = Arg::new(option.name()).long(option.name()).help(option.help());
    let argument = match option.values() {
        OptionValues::None => return argument.action(ArgAction::SetTrue),
        OptionValues::Text(name) => {
            argument.value_name(name).value_parser(move |text: &str| option.read(text))
        }
        OptionValues::OneOf(name, words) => {
            let words = words.iter().map(|&(word, help)| PossibleValue::new(word).help(help));
            let parser = PossibleValuesParser::new(words);
            argument.value_name(name).value_parser(parser.try_map(move |word| option.read(&word)))
        }
    };
    match option.default_value(method) {
        Some(value) => argument.default_value(value),
        None => argument,
    }
}

/// Returns the method's options that were given.
fn settings(plain: Method, matches: &ArgMatches) -> Vec<MethodSetting> {
    let options = plain.options().iter();
    let is_given = |name| matches.value_source(name) == Some(ValueSource::CommandLine);
    let given = options.filter(|option| is_given(option.name()));
    let setting = |option: &MethodOption| match option.values() {
        OptionValues::None => option.read("").ok(),
        OptionValues::Text(_) | OptionValues::OneOf(..) => {
            matches.get_one::<MethodSetting>(option.name()).copied()
        }
    };
    given.filter_map(setting).collect()
}

/// Ends the program if its words ask for nothing but what shells and manuals want.
fn answer(command: &mut Command) {
    let words: Vec<OsString> = std::env::args_os().collect();
    if for_shells::answer(command, &words) {
        std::process::exit(0);
    }
}

/// Tells what is amiss, or the help that was wanted, and ends.
fn end(error: &Error) -> ! {
    // The shell may have put in names of files, which are text of others. Colour,
    // which is for a terminal to obey, is left out then.
    let is_odd = |word: OsString| {
        let word = word.to_string_lossy().into_owned();
        traylib_io::printable(&word) != word
    };
    if !error.use_stderr() || !std::env::args_os().any(is_odd) {
        error.exit();
    }
    say(error.render().to_string().trim_end());
    std::process::exit(error.exit_code())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Method, String> {
        let name = text.split_whitespace().next().unwrap();
        let plain = Method::ALL.into_iter().find(|method| method.name() == name).unwrap();
        let line = CommandLine::<()>::read(plain, text.split_whitespace().map(OsString::from));
        line.map(|line| line.method).map_err(|error| error.to_string())
    }

    /// One spelling for command lines and charts, right or wrong.
    #[test]
    fn a_method_is_what_its_command_line_says() {
        for text in [
            "trace",
            "trace --jitter",
            "puremc --max-depth 4 --roulette off",
            "particle --roulette=2",
            "directlight",
            "directlight --combine",
            "directlight --combine --heuristic balance --max-depth 7",
            "bdpt --no-connections",
            "bdpt --direct-sum --heuristic power --no-connections --max-depth 2 --roulette 9",
        ] {
            let method = text.parse::<Method>().unwrap();
            assert_eq!(read(text), Ok(method), "{text}");
            assert_eq!(read(&method.to_string()), Ok(method), "{method}");
        }
        for text in [
            "trace --max-depth 3",
            "puremc --heuristic balance",
            "bdpt --max-depth 0",
            "bdpt --max-depth 2 --max-depth 3",
            "bdpt --heuristic best",
            "bdpt --roulette off",
            "directlight --heuristic power",
        ] {
            assert!(text.parse::<Method>().is_err() && read(text).is_err(), "{text}");
        }
    }

    #[test]
    fn options_are_sound() {
        for method in Method::ALL {
            command::<()>(method).debug_assert();
        }
    }
}
