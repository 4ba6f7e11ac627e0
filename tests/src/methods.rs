//! The methods under proof, and what proofs have to know of them.

use serde::{Deserialize, Deserializer, Serializer};
use traylib_integrators::{BdptSettings, LightSampling, Method};
use traylib_math::Heuristic;

/// `trace --jitter`: all others estimate the mean over a pixel, too.
pub const JITTERED_TRACE: Method = Method::JITTERED_TRACE;
/// `puremc`.
pub const PURE_MC: Method = Method::PURE_MC;
/// `directlight`, as strict as the paper.
pub const DIRECT_LIGHT: Method = Method::DIRECT_LIGHT;
/// `directlight --combine`.
pub const COMBINED: Method = Method::COMBINED;
/// `bdpt`, weights by the power heuristic.
pub const BDPT: Method = Method::BDPT;
/// `bdpt --heuristic balance`.
pub const BDPT_BALANCE: Method =
    Method::Bdpt(BdptSettings { heuristic: Heuristic::Balance, ..BdptSettings::DEFAULT });
/// `particle`.
pub const PARTICLE: Method = Method::PARTICLE;

/// In which settings a method is proved to find the light of lamps by way of other
/// surfaces.
const fn settings_of(method: Method) -> &'static [Method] {
    match method {
        // One reflection of point lights is all that it knows.
        Method::Trace(_) => &[],
        Method::PureMc(_) => &[PURE_MC],
        Method::DirectLight(_) => &[DIRECT_LIGHT, COMBINED],
        Method::Bdpt(_) => &[BDPT, BDPT_BALANCE],
        Method::Particle(_) => &[PARTICLE],
    }
}

/// The methods that find the light of lamps by way of other surfaces.
pub const WALKING: [Method; 6] = {
    let mut all = [JITTERED_TRACE; 6];
    let (mut next, mut method) = (0, 0);
    while method < Method::ALL.len() {
        let settings = settings_of(Method::ALL[method]);
        let mut index = 0;
        while index < settings.len() {
            assert!(next < all.len(), "there are more of them");
            all[next] = settings[index];
            (next, index) = (next + 1, index + 1);
        }
        method += 1;
    }
    assert!(next == all.len(), "there are fewer of them");
    all
};

/// All of [`WALKING`], these first.
pub fn beginning_with(first: &[Method]) -> Vec<Method> {
    let others = WALKING.iter().filter(|method| !first.contains(method));
    first.iter().chain(others).copied().collect()
}

/// Returns the methods that walk from the camera, and so see a spot as well as a wide view, each
/// with so many passes.
pub fn from_camera(passes: u32) -> Vec<(Method, u32)> {
    let methods = WALKING.into_iter().filter(|&method| !splats_alone(method));
    methods.map(|method| (method, passes)).collect()
}

/// Tells whether it walks from lamps, and so sees some surfaces from their other side first.
pub fn walks_from_lights(method: Method) -> bool {
    let techniques = method.techniques();
    techniques.splats || techniques.connections
}

/// Tells whether all that it shows of lit surfaces comes from walks from lamps.
pub fn splats_alone(method: Method) -> bool {
    let techniques = method.techniques();
    techniques.splats && !techniques.hits && techniques.light_samples == LightSampling::Off
}

/// Tells whether it never hits a lamp by itself, so that light near a sharp lobe or close to a
/// lamp is found rarely and counts for much.
pub fn never_hits(method: Method) -> bool {
    !method.techniques().hits
}

/// Tells whether walks find lamps, or the camera, and nothing is aimed at lamps with an area:
/// whatever is small is found rarely.
pub fn finds_by_chance(method: Method) -> bool {
    let techniques = method.techniques();
    let walks_find = techniques.hits || techniques.splats;
    walks_find && techniques.light_samples != LightSampling::All
}

/// Writes a method as it is spelled.
///
/// # Errors
/// Those of the format.
pub fn serialize<S: Serializer>(method: &Method, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(method)
}

/// Reads a method as it is spelled.
///
/// # Errors
/// The value is no text, or no method.
pub fn deserialize<'a, D: Deserializer<'a>>(deserializer: D) -> Result<Method, D::Error> {
    let text = String::deserialize(deserializer)?;
    text.parse().map_err(serde::de::Error::custom)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relations draw from this list by its order.
    #[test]
    fn facts_are_those_of_the_algorithms() {
        assert_eq!(WALKING, [PURE_MC, DIRECT_LIGHT, COMBINED, BDPT, BDPT_BALANCE, PARTICLE]);
        let order = beginning_with(&[BDPT, COMBINED, BDPT_BALANCE]);
        assert_eq!(order[3..], [PURE_MC, DIRECT_LIGHT, PARTICLE]);
        let order = beginning_with(&[PURE_MC, COMBINED]);
        assert_eq!(order[2..], [DIRECT_LIGHT, BDPT, BDPT_BALANCE, PARTICLE]);
        let those = |fact: fn(Method) -> bool| {
            WALKING.into_iter().filter(|&method| fact(method)).collect::<Vec<_>>()
        };
        assert_eq!(those(walks_from_lights), [BDPT, BDPT_BALANCE, PARTICLE]);
        assert_eq!(those(splats_alone), [PARTICLE]);
        assert_eq!(those(never_hits), [DIRECT_LIGHT, PARTICLE]);
        assert_eq!(those(finds_by_chance), [PURE_MC, PARTICLE]);
        assert!(!finds_by_chance(JITTERED_TRACE) && !walks_from_lights(JITTERED_TRACE));
    }
}
