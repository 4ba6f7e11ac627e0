//! Methods as text: a command line without a scene, and back.

use super::{Method, MethodOption, MethodSetting, OptionValues};
use std::fmt;
use std::str::FromStr;

/// The reason why text is no method.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MethodError {
    /// No method has this name.
    Unknown(String),
    /// This is how it was once spelled, and how it is now.
    Respelled(String, String),
    /// The method has no such option.
    NoSuchOption(Method, String),
    /// The option wants another value.
    Value(MethodOption, &'static str),
    /// The option stands there twice.
    Twice(MethodOption),
    /// Without roulette paths need a longest one.
    Endless,
    /// A heuristic was given where nothing is weighted.
    NothingWeighted,
    /// The option is for the plan to choose.
    Planned(MethodOption),
    /// The light that may be lost was given without a plan.
    NothingPlanned,
}

/// Every option that is not as by default, in the method's own order.
impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())?;
        let mut settings = self.settings();
        settings.retain(|own| own.option().default_value(*self) != Some(own.value().as_str()));
        settings.iter().try_for_each(|setting| write!(f, " {setting}"))
    }
}

impl FromStr for Method {
    type Err = MethodError;

    fn from_str(text: &str) -> Result<Self, MethodError> {
        let mut words = text.split_whitespace();
        let name = words.next().unwrap_or_default();
        let Some(method) = Self::ALL.into_iter().find(|method| method.name() == name) else {
            return Err(respelled(text).unwrap_or_else(|| MethodError::Unknown(text.into())));
        };
        let mut given: Vec<MethodSetting> = Vec::new();
        while let Some(word) = words.next() {
            let setting = method.read_option(word, &mut words)?;
            if given.iter().any(|other| other.option() == setting.option()) {
                return Err(MethodError::Twice(setting.option()));
            }
            given.push(setting);
        }
        method.with(&given)
    }
}

impl Method {
    /// The option that a word names, as `--max-depth 6` or `--max-depth=6`; its value is
    /// the next word.
    fn read_option<'a>(
        self,
        word: &'a str,
        rest: &mut impl Iterator<Item = &'a str>,
    ) -> Result<MethodSetting, MethodError> {
        let (name, value) = word.split_once('=').map_or((word, None), |(n, v)| (n, Some(v)));
        let found = name
            .strip_prefix("--")
            .and_then(|name| self.options().iter().copied().find(|option| option.name() == name));
        let option = found.ok_or_else(|| MethodError::NoSuchOption(self, word.into()))?;
        let value = match (value, option.values()) {
            (Some(value), _) => value,
            (None, OptionValues::None) => "",
            (None, OptionValues::Text(_) | OptionValues::OneOf(..)) => {
                rest.next().unwrap_or_default()
            }
        };
        option.read(value).map_err(|wanted| MethodError::Value(option, wanted))
    }
}

/// For those who remember `combined:balance:depth=6`.
fn respelled(text: &str) -> Option<MethodError> {
    let mut words = text.split(':');
    let name = words.next()?;
    let mut now = vec![if name == "combined" { "directlight --combine" } else { name }];
    for word in words {
        let (key, value) = word.split_once('=').unwrap_or((word, ""));
        now.extend(match key {
            "balance" => ["--heuristic", "balance"],
            "depth" => ["--max-depth", value],
            "roulette" => ["--roulette", value],
            "no-connections" => ["--no-connections", value],
            _ => return None,
        });
    }
    let now = now.join(" ");
    if now == text {
        return None;
    }
    now.parse::<Method>().ok().map(|method| MethodError::Respelled(text.into(), method.to_string()))
}

impl fmt::Display for MethodError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(text) => {
                let names = Method::ALL.map(Method::name).join(", ");
                write!(f, "`{text}` is no method; there are {names}, each with its options")
            }
            Self::Respelled(old, new) => write!(f, "`{old}` is spelled `{new}` now"),
            Self::NoSuchOption(method, word) => {
                let name = method.name();
                let options = method.options().iter().map(|option| format!("--{}", option.name()));
                let options = options.collect::<Vec<_>>().join(", ");
                write!(f, "{name} has no option `{word}`; it has {options}")
            }
            Self::Value(option, wanted) => write!(f, "--{}: {wanted}", option.name()),
            Self::Twice(option) => write!(f, "--{} is given twice", option.name()),
            Self::Endless => {
                f.write_str("--roulette off wants a --max-depth: some paths would never end")
            }
            Self::NothingWeighted => f.write_str("--heuristic wants --combine, which weights"),
            Self::Planned(option) => {
                write!(f, "--{} is for --auto to choose: leave one of them out", option.name())
            }
            Self::NothingPlanned => f.write_str("--max-depth auto:… wants --auto, and bdpt"),
        }
    }
}

impl std::error::Error for MethodError {}
