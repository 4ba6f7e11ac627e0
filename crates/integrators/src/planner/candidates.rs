//! The methods that a plan chooses from.

use crate::{BdptSettings, BlindSpot, DirectLight, Method, PathsPerPixel, SceneFacts};
use traylib_math::Heuristic;

const HEURISTICS: [Heuristic; 2] = [Heuristic::Power, Heuristic::Balance];

/// Light paths for each pixel, in thousandths, where they are splatted.
const SPLATTED: [u32; 4] = [250, 500, 1000, 2000];

/// The same where they are only joined with camera paths: one more than one is joined with
/// nothing.
const JOINED: [u32; 2] = [500, 1000];

/// The methods that may pay, and those that do not come into question.
pub(super) struct Candidates {
    /// Each finds whatever whole bidirectional tracing finds.
    pub(super) methods: Vec<Method>,
    /// The methods that are blind to some of the light: to be faster for that is no merit.
    pub(super) blind: Vec<(Method, BlindSpot)>,
}

/// Returns the methods to choose from in a scene of such facts.
pub(super) fn candidates(facts: SceneFacts) -> Candidates {
    let mut all = vec![Method::PURE_MC, Method::DIRECT_LIGHT, Method::PARTICLE];
    // Point lights are not hit: there is nothing to combine.
    if facts.area_lights || facts.sky {
        all.extend(HEURISTICS.map(combined));
    }
    for heuristic in HEURISTICS {
        let bdpt = BdptSettings { heuristic, ..BdptSettings::DEFAULT };
        let lean = BdptSettings { no_connections: true, ..bdpt };
        all.extend(SPLATTED.iter().flat_map(|&paths| [with(bdpt, paths), with(lean, paths)]));
        let unsplatted = BdptSettings { no_splats: true, ..bdpt };
        all.extend(JOINED.map(|paths| with(unsplatted, paths)));
    }
    let whole = Method::BDPT.build().blind_spots(&facts);
    let blind_to = |method: Method| {
        method.build().blind_spots(&facts).into_iter().find(|spot| !whole.contains(spot))
    };
    let blind: Vec<(Method, BlindSpot)> =
        all.iter().filter_map(|&method| Some((method, blind_to(method)?))).collect();
    all.retain(|method| blind.iter().all(|(other, _)| other != method));
    Candidates { methods: all, blind }
}

fn combined(heuristic: Heuristic) -> Method {
    Method::DirectLight(DirectLight { combine: Some(heuristic), ..DirectLight::default() })
}

fn with(settings: BdptSettings, thousandths: u32) -> Method {
    let light_paths = PathsPerPixel::of_thousandths(thousandths);
    Method::Bdpt(BdptSettings { light_paths, ..settings })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facts(area_lights: bool, point_lights: bool, mirrors: bool) -> SceneFacts {
        SceneFacts { area_lights, point_lights, sky: false, mirrors }
    }

    #[test]
    fn nothing_is_chosen_that_is_blind() {
        let names = |facts| -> Vec<&str> {
            candidates(facts).methods.into_iter().map(Method::name).collect()
        };
        assert!(names(facts(true, false, false)).contains(&"particle"));
        // What is seen in a mirror no light path shows, and points no walk from the camera finds
        // by way of one.
        assert!(!names(facts(true, false, true)).contains(&"particle"));
        let beside_points = names(facts(true, true, true));
        assert!(beside_points.iter().all(|name| *name == "bdpt"), "{beside_points:?}");
    }

    /// The sky is hit as lamps with an area are.
    #[test]
    fn the_sky_is_aimed_at_and_hit() {
        let under_sky = SceneFacts { sky: true, ..facts(false, false, false) };
        let methods = |facts| candidates(facts).methods;
        assert_eq!(methods(under_sky), methods(facts(true, false, false)));
    }

    #[test]
    fn each_stands_there_once() {
        let all = candidates(facts(true, false, false)).methods;
        assert!((20..40).contains(&all.len()), "{}", all.len());
        for (i, method) in all.iter().enumerate() {
            assert!(!all[..i].contains(method), "{method}");
        }
    }
}
