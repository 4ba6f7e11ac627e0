//! The table for people.

use super::{Measured, Needs};
use std::fmt::Write;

/// Changes of time to an error within this part are called none.
const NOTHING: f64 = 0.05;

/// relMSE that is no other picture: 1 % of each pixel.
const INVISIBLE: f64 = 1e-4;

/// Differences that may be there by chance, in standard errors.
const BY_CHANCE: f64 = 4.0;

/// A line for each part, and what they come to.
pub fn table(name: &str, needs: &Needs) -> String {
    let Needs { whole, without } = needs;
    // Writing to a string does not fail.
    let mut text = format!(
        "{name}: bdpt takes {:.2} us a sample with a noise of {:.4}\n\n",
        whole.nanoseconds / 1000.0,
        whole.noise
    );
    text += "                             times the whole's\n";
    text +=
        "without                        time   noise   time to     light lost      error that\n";
    text += "                                              an error                    stays\n";
    for (part, measured) in without {
        let ratio = |of: fn(&Measured) -> f64| of(measured) / of(whole);
        let (lost, error) = lost(whole, measured);
        let _ = writeln!(
            text,
            "{:<28} {:>6.2}  {:>6.2}  {:>7.2}   {:>7.3} ± {:.3} %  {:>10.1e}",
            part.to_string(),
            ratio(|m| m.nanoseconds),
            ratio(|m| m.noise),
            ratio(Measured::cost),
            100.0 * lost,
            100.0 * error,
            measured.bias.0.max(0.0),
        );
    }
    let named = |kind: Kind| {
        let names = without.iter().filter(|(_, measured)| Kind::of(whole, measured) == kind);
        let names: Vec<String> = names.map(|(part, _)| part.to_string()).collect();
        if names.is_empty() { String::from("nothing") } else { names.join(", ") }
    };
    let _ = writeln!(text, "\nneeded, as light is lost without: {}", named(Kind::Light));
    let _ = writeln!(text, "needed, as the picture is another without: {}", named(Kind::Picture));
    let _ = writeln!(text, "needed, as it takes longer without: {}", named(Kind::Time));
    let _ = writeln!(text, "does not matter: {}", named(Kind::Nothing));
    let _ = writeln!(text, "better without: {}", named(Kind::Burden));
    text
}

/// The effect of leaving a part out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Light,
    Picture,
    Time,
    Nothing,
    Burden,
}

impl Kind {
    fn of(whole: &Measured, measured: &Measured) -> Self {
        let (lost, error) = lost(whole, measured);
        let cost = measured.cost() / whole.cost();
        // Less than a thousandth of the light is no need.
        if lost > (BY_CHANCE * error).max(1e-3) {
            Self::Light
        } else if measured.bias.0 > (BY_CHANCE * measured.bias.1).max(INVISIBLE) {
            Self::Picture
        } else if cost > 1.0 + NOTHING {
            Self::Time
        } else if cost < 1.0 - NOTHING {
            Self::Burden
        } else {
            Self::Nothing
        }
    }
}

/// The part of the light that is lost, and its standard error.
fn lost(whole: &Measured, measured: &Measured) -> (f64, f64) {
    let ((all, of_all), (mean, of_mean)) = (whole.mean, measured.mean);
    if all > 0.0 { (1.0 - mean / all, of_all.hypot(of_mean) / all) } else { (0.0, 0.0) }
}

#[cfg(test)]
mod tests {
    use super::super::Part;
    use super::*;
    use traylib_scene::Detail;

    fn measured(nanoseconds: f64, noise: f64, mean: f64) -> Measured {
        Measured { nanoseconds, noise, mean: (mean, 1e-3), bias: (0.0, 1e-4) }
    }

    #[test]
    fn parts_are_told_by_what_their_want_does() {
        let whole = measured(1000.0, 1.0, 1.0);
        let without = vec![
            (Part::Splats, measured(500.0, 1.0, 0.9)),
            (Part::Connections, measured(800.0, 2.0, 1.0)),
            (Part::Images, measured(1000.0, 1.01, 1.001)),
            (Part::LightPaths, measured(500.0, 1.5, 1.0)),
            // As bright, and elsewhere; and within the error of that.
            (Part::Detail(Detail::Pictures), Measured { bias: (6e-4, 1e-4), ..whole }),
            (Part::Detail(Detail::Bumps), Measured { bias: (3e-4, 1e-4), ..whole }),
        ];
        let text = table("room", &Needs { whole, without });
        for line in [
            "lost without: splats\n",
            "picture is another without: textures\n",
            "takes longer without: connections\n",
            "does not matter: images of lamps in mirrors, bump maps\n",
            "better without: three of four light paths\n",
        ] {
            assert!(text.contains(line), "{text}");
        }
    }
}
