//! The same command with less work.

/// Samples a pixel that are left of more: as many as `--noise` takes before it looks.
const SAMPLES: u32 = 16;

/// Returns the arguments of a program so that it takes a moment: fewer samples of a small picture,
/// one frame, of what measures for long no more than to understand what it is told.
pub(super) fn small(program: &str, arguments: &[&str]) -> Vec<String> {
    let mut small: Vec<String> = arguments.iter().copied().map(String::from).collect();
    let has = |option: &str| arguments.contains(&option);
    match program {
        "trace" | "puremc" | "directlight" | "particle" | "bdpt" => {
            // Places of pixels are meant in the picture's own size, where a sample is enough.
            let is_whole = ["--pixel", "--pixelbounds"].iter().any(|place| has(place));
            let samples = if is_whole { 1 } else { SAMPLES };
            let asks = ["--list", "--man", "--completions", "--version", "--help", "-h"];
            if !asks.iter().any(|question| has(question)) {
                lower(&mut small, "--spp", samples);
                if !is_whole {
                    replace(&mut small, "--resolution", "32x24");
                }
            }
        }
        "realtime" => {
            lower(&mut small, "--frames", 1);
            replace(&mut small, "--resolution", "32x24");
        }
        // All that is before `--help` is understood first.
        "compare-integrators" | "needs" | "scaling" | "costs" | "stability" => {
            small.push("--help".into());
        }
        "relations" => {
            lower(&mut small, "--scenes", 0);
            lower(&mut small, "--passes", 8);
        }
        _ => {}
    }
    small
}

/// Makes the number after an option no larger than `most`, which is given where it is not.
fn lower(arguments: &mut Vec<String>, option: &str, most: u32) {
    let value = arguments.iter().skip_while(|word| *word != option).nth(1);
    match value.map(|value| value.parse::<u32>()) {
        Some(Ok(value)) => replace(arguments, option, &value.min(most).to_string()),
        None => replace(arguments, option, &most.to_string()),
        // Not a number, as the program has to say.
        Some(Err(_)) => {}
    }
}

/// Puts another value after an option, or the option with it at the end.
fn replace(arguments: &mut Vec<String>, option: &str, value: &str) {
    match arguments.iter().position(|word| word == option) {
        Some(place) if place + 1 < arguments.len() => arguments[place + 1] = value.into(),
        Some(_) => {}
        None => arguments.extend([option.into(), value.into()]),
    }
}

#[test]
fn numbers_get_lower_and_nothing_else_changes() {
    let found = small("bdpt", &["cornell", "--spp", "256", "-o", "a.exr"]);
    assert_eq!(found.join(" "), "cornell --spp 16 -o a.exr --resolution 32x24");
    let found = small("bdpt", &["--pixel", "9,9", "--spp", "8"]);
    assert_eq!(found.join(" "), "--pixel 9,9 --spp 1");
    assert_eq!(small("bdpt", &["--spp", "many"])[1], "many");
    assert_eq!(small("bdpt", &["--list"]), ["--list"]);
    assert_eq!(small("film", &["info", "a.exr"]), ["info", "a.exr"]);
    assert_eq!(small("needs", &["pyramid"]), ["pyramid", "--help"]);
    assert_eq!(small("realtime", &[]).join(" "), "--frames 1 --resolution 32x24");
}
