//! The methods that are compared, and the facts about them that a comparison needs.

use traylib_integrators::{
    Auto, BdptSettings, BlindSpot, DirectLight, Limits, MayLose, Method, SceneFacts,
};
use traylib_math::Heuristic;

/// Settings of the two best methods that may pay.
const SETTINGS: [Method; 3] = [
    Method::DirectLight(DirectLight {
        limits: Limits::OF_CAMERA_WALKS,
        combine: Some(Heuristic::Balance),
        no_images: false,
    }),
    Method::Bdpt(BdptSettings { heuristic: Heuristic::Balance, ..BdptSettings::DEFAULT }),
    Method::Bdpt(BdptSettings { no_connections: true, ..BdptSettings::DEFAULT }),
];

/// The method that finds out by itself which of the others to render by.
const PLANNED: Method = Method::Bdpt(BdptSettings {
    auto: Some(Auto { may_lose: MayLose::NOTHING }),
    ..BdptSettings::DEFAULT
});

/// Returns the methods that are compared unless something else is asked for: every method, and some
/// settings unless it is done in a hurry.
pub fn by_default(in_a_hurry: bool) -> Vec<Method> {
    let settings = if in_a_hurry { &[][..] } else { &SETTINGS };
    [&Method::COMPARED[..], &[PLANNED], settings].concat()
}

/// Edges of the longest paths that it follows, if its settings limit them.
pub fn longest_path(method: Method) -> Option<u32> {
    method.limits().and_then(|limits| limits.max_depth)
}

/// The light that it cannot produce in such a scene, in words.
pub fn blind_spots(method: Method, facts: &SceneFacts) -> Vec<String> {
    method.build().blind_spots(facts).iter().map(ToString::to_string).collect()
}

/// Tells whether it loses light that full bidirectional tracing finds: for a limit on path
/// lengths, or because it is blind to it.
pub fn is_biased(method: Method, facts: &SceneFacts) -> bool {
    let [all, blind] = [Method::BDPT, method].map(|method| method.build().blind_spots(facts));
    longest_path(method).is_some() || blind.iter().any(|spot| !all.contains(spot))
}

/// Tells whether there is any light in such a scene that it is for.
pub fn suits(method: Method, facts: &SceneFacts) -> bool {
    facts.point_lights || !method.build().blind_spots(facts).contains(&BlindSpot::AreaLights)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn method(text: &str) -> Method {
        text.parse().unwrap()
    }

    #[test]
    fn names_on_the_chart_are_command_lines() {
        let names: Vec<String> = by_default(false).iter().map(ToString::to_string).collect();
        let expected = [
            "trace --jitter",
            "puremc",
            "directlight",
            "directlight --combine",
            "particle",
            "bdpt",
            "bdpt --auto",
            "directlight --combine --heuristic balance",
            "bdpt --heuristic balance",
            "bdpt --no-connections",
        ];
        assert_eq!(names, expected);
        assert_eq!(by_default(true), by_default(false)[..7]);
    }

    #[test]
    fn whoever_loses_light_is_biased() {
        let mirrors =
            SceneFacts { area_lights: true, point_lights: false, sky: false, mirrors: true };
        let plain = SceneFacts { mirrors: false, ..mirrors };
        let biased = |text: &str, facts| is_biased(method(text), facts);
        assert!(biased("particle", &mirrors) && !biased("particle", &plain));
        assert!(biased("bdpt --max-depth 4", &plain) && !biased("bdpt", &mirrors));
        assert!(!suits(method("trace"), &plain) && suits(method("puremc"), &plain));
    }
}
