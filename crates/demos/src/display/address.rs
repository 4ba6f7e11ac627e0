//! Where a viewer listens.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

/// The host and the port of a viewer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DisplayAddress {
    /// A name or a number, without the brackets of IPv6.
    pub(crate) host: String,
    pub(crate) port: u16,
}

/// The port that tev listens to if nothing else is said.
const TEV: u16 = 14158;

impl Display for DisplayAddress {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let Self { host, port } = self;
        if host.contains(':') { write!(f, "[{host}]:{port}") } else { write!(f, "{host}:{port}") }
    }
}

impl FromStr for DisplayAddress {
    type Err = &'static str;

    /// Reads `HOST:PORT` or `HOST`; an address by IPv6 is in brackets.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const WANTED: &str = "wanted as localhost:14158, or the host alone; IPv6 as [::1]:14158";
        let (host, rest) = match text.strip_prefix('[') {
            Some(text) => text.split_once(']').ok_or(WANTED)?,
            None => text.split_at(text.find(':').unwrap_or(text.len())),
        };
        let port = match rest.strip_prefix(':') {
            Some(port) => port.parse().ok().filter(|&port| port != 0),
            None => rest.is_empty().then_some(TEV),
        };
        let port = port.filter(|_| !host.is_empty() && !host.contains(char::is_whitespace));
        Ok(Self { host: host.to_owned(), port: port.ok_or(WANTED)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_port_may_be_left_out() {
        for (text, host, port) in [
            ("localhost", "localhost", 14158),
            ("10.0.0.1:80", "10.0.0.1", 80),
            ("[::1]", "::1", 14158),
            ("[fe80::2]:9", "fe80::2", 9),
        ] {
            let address: DisplayAddress = text.parse().unwrap();
            assert_eq!((address.host.as_str(), address.port), (host, port), "{text}");
            assert_eq!(address.to_string().parse(), Ok(address), "{text}");
        }
        for bad in
            ["", ":80", "a:", "a:b", "a:0", "a:65536", "::1", "[::1", "[]:1", "a b", "[::1]9"]
        {
            assert!(bad.parse::<DisplayAddress>().is_err(), "{bad}");
        }
    }
}
