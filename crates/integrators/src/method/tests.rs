//! Spellings and what they stand for.

use super::*;
use crate::{BlindSpot, Roulette, SceneFacts};

fn method(text: &str) -> Method {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// Every method with every subset of some settings of its options, as far as they go
/// together.
fn many() -> Vec<Method> {
    let values = |option: MethodOption| match option {
        MethodOption::MaxDepth => vec!["1", "4294967295", "auto:0.5%"],
        MethodOption::Roulette => vec!["2", "3", "4", "off"],
        MethodOption::Heuristic => vec!["balance", "power"],
        MethodOption::LightPaths => vec!["0.25", "1"],
        MethodOption::Jitter
        | MethodOption::Combine
        | MethodOption::DirectSum
        | MethodOption::NoConnections
        | MethodOption::NoSplats
        | MethodOption::Auto
        | MethodOption::NoImages => vec![""],
    };
    let mut all = Vec::new();
    for plain in Method::ALL {
        let mut lists = vec![Vec::new()];
        for &option in plain.options() {
            for value in values(option) {
                let with = |list: &Vec<MethodSetting>| {
                    let setting = option.read(value).unwrap();
                    let is_there = list.iter().any(|other| other.option() == option);
                    (!is_there).then(|| [list.as_slice(), &[setting]].concat())
                };
                let longer: Vec<_> = lists.iter().filter_map(with).collect();
                lists.extend(longer);
            }
        }
        all.extend(lists.iter().filter_map(|list| plain.with(list).ok()));
    }
    all
}

#[test]
fn text_and_method_are_each_others_inverse() {
    let many = many();
    assert!(many.len() > 100, "{}", many.len());
    for method in many {
        assert_eq!(method.to_string().parse(), Ok(method), "{method}");
        // In full it is the same, too.
        let words = method.settings().into_iter().map(|setting| format!(" {setting}"));
        let full = words.fold(String::from(method.name()), |text, word| text + &word);
        assert_eq!(full.parse(), Ok(method), "{full}");
    }
}

#[test]
fn spellings_are_command_lines() {
    let names = Method::COMPARED.map(|method| method.to_string());
    let expected =
        ["trace --jitter", "puremc", "directlight", "directlight --combine", "particle", "bdpt"];
    assert_eq!(names, expected);
    let lean = method("bdpt --no-connections --max-depth=6  --heuristic balance --roulette 5");
    let spelled = "bdpt --max-depth 6 --roulette 5 --heuristic balance --no-connections";
    assert_eq!(lean.to_string(), spelled);
    assert_eq!(lean.limits().map(|limits| limits.max_depth), Some(Some(6)));
    assert!(!lean.techniques().connections && lean.techniques().splats);
    assert_eq!(method("directlight --heuristic power --combine"), Method::COMBINED);
}

#[test]
fn what_is_no_method_is_told_with_what_is_wanted() {
    for (text, told) in [
        ("", "there are trace, puremc"),
        ("pt", "`pt` is no method"),
        ("puremc --heuristic balance", "puremc has no option `--heuristic`; it has --max-depth"),
        ("trace --max-depth 3", "it has --jitter"),
        ("directlight --no-connections", "has no option"),
        ("bdpt no-connections", "has no option `no-connections`"),
        ("bdpt --max-depth", "--max-depth: wanted: a number of edges from 1 on"),
        ("bdpt --max-depth 0", "from 1 on"),
        ("bdpt --max-depth x", "from 1 on"),
        ("bdpt --roulette 1", "an edge from 2 on"),
        ("bdpt --heuristic best", "balance or power"),
        ("bdpt --direct-sum=1", "takes no value"),
        ("bdpt --max-depth 3 --max-depth 4", "--max-depth is given twice"),
        ("bdpt --roulette off", "wants a --max-depth"),
        ("directlight --heuristic balance", "wants --combine"),
    ] {
        let error = text.parse::<Method>().unwrap_err().to_string();
        assert!(error.contains(told), "{text}: {error}");
    }
}

#[test]
fn old_spellings_name_the_new() {
    for (old, new) in [
        ("combined", "directlight --combine"),
        ("combined:balance:depth=6", "directlight --combine --max-depth 6 --heuristic balance"),
        ("bdpt:no-connections", "bdpt --no-connections"),
        ("puremc:roulette=2", "puremc --roulette 2"),
    ] {
        let new = method(new).to_string();
        let error = MethodError::Respelled(old.into(), new);
        assert_eq!(old.parse::<Method>(), Err(error), "{old}");
    }
    for never in ["combined:no-connections", "bdpt:depth=0", "bdpt:", "pt:balance"] {
        assert_eq!(never.parse::<Method>(), Err(MethodError::Unknown(never.into())));
    }
}

#[test]
fn defaults_are_spelled_as_they_are() {
    for method in Method::ALL {
        let option = MethodOption::Roulette;
        if method.options().contains(&option) {
            let default = option.read(option.default_value(method).unwrap()).unwrap();
            assert_eq!(method.with(&[default]), Ok(method));
        }
    }
}

#[test]
fn limits_are_set_where_there_are_any() {
    let short = Limits { max_depth: Some(4), roulette: Roulette { from_edge: 7 } };
    for method in Method::ALL {
        let limited = method.with_limits(short);
        assert_eq!(limited.limits(), method.limits().map(|_| short), "{method}");
        assert_eq!(limited.up_to(None).up_to(Some(4)), limited, "{method}");
    }
}

/// What a method is said to find is what its integrator says it misses.
#[test]
fn techniques_and_blind_spots_go_together() {
    let facts = SceneFacts { area_lights: true, point_lights: true, sky: true, mirrors: true };
    for method in many() {
        let blind = method.build().blind_spots(&facts);
        let (techniques, is_blind) = (method.techniques(), |spot| blind.contains(&spot));
        let mirrors = techniques.hits || techniques.light_samples != LightSampling::Off;
        assert_eq!(is_blind(BlindSpot::SeenInMirrors), !mirrors, "{method}");
        // It says of `trace` that no light is reflected twice, and no more.
        if method.name() != "trace" {
            let Techniques { splats, mirror_connections, .. } = techniques;
            let spot = match (splats, mirror_connections) {
                (false, false) => Some(BlindSpot::PointLightCaustics),
                (false, true) => Some(BlindSpot::PointLightChains),
                (true, true) => Some(BlindSpot::PointLightChainsInMirrors),
                // Mirrors are blind to it, or `particle` to mirrors.
                (true, false) => None,
            };
            for other in [BlindSpot::PointLightCaustics, BlindSpot::PointLightChains] {
                assert_eq!(is_blind(other), spot == Some(other), "{method}");
            }
        }
    }
}
