//! A made-up comparison, for tests of page and chart.

mod method;
mod pictures;

use crate::pictures::ScenePictures;
use crate::results::{
    Estimate, How, LengthShare, Oracle, OracleCrossing, OracleCurve, OraclePoint, OutsidePoint,
    ReferenceAgreement, ReferenceResults, Results, SceneResults, Verdict,
};
use method::{BUDGETS, Kind, around, kind, method};

/// Two scenes with five methods each: one blind, one biased, one without variance;
/// a picture of another program; the oracle.
pub fn sample() -> (Results, Vec<ScenePictures>) {
    let scenes = vec![scene("cornell", &CORNELL), scene("caustic", &CAUSTIC)];
    let pictures = scenes.iter().map(pictures::of).collect();
    (Results { how: how(), scenes, oracle: Some(oracle()), complete: false }, pictures)
}

const CORNELL: [Kind; 5] = [
    kind("directlight", 0.021, 0.011),
    kind("bdpt", 0.024, 0.048),
    Kind { floor: 2.0e-3, ..kind("bdpt --max-depth 6", 0.017, 0.034) },
    kind("puremc", 1.9, 0.0085),
    Kind { floor: 0.4, blind: true, ..kind("particle", 0.35, 0.019) },
];

const CAUSTIC: [Kind; 5] = [
    Kind { alarm: true, ..kind("directlight", 340.0, 0.012) },
    kind("bdpt", 0.09, 0.051),
    Kind { floor: 5.0e-4, ..kind("bdpt --max-depth 6", 0.085, 0.04) },
    Kind { floor: 0.97, blind: true, ..kind("puremc", 0.02, 0.009) },
    kind("particle", 0.04, 0.02),
];

const SEEDS: u32 = 16;

fn how() -> How {
    How {
        command: "cargo xtask compare-integrators --scenes cornell,caustic --budgets 1s,2s,4s,8s"
            .into(),
        program: "traylib-compare 0.1.0".into(),
        commit: Some("0123abc45678".into()),
        processor: "A processor with a rather long name @ 3.10GHz".into(),
        threads: 2,
        sampler: "sobol".into(),
        seeds: SEEDS,
        first_seed: 1,
        budgets: BUDGETS.to_vec(),
        seconds: 2913.0,
    }
}

fn scene(name: &str, kinds: &[Kind]) -> SceneResults {
    let best = kinds
        .iter()
        .filter(|kind| kind.floor == 0.0)
        .min_by(|a, b| a.cost.total_cmp(&b.cost))
        .map_or(0.0, |kind| kind.cost);
    let best_name = kinds.iter().find(|k| k.cost == best).map_or("", |kind| kind.name);
    SceneResults {
        name: name.into(),
        width: 96,
        height: 72,
        primitives: 34,
        area_lights: 1,
        point_lights: 0,
        load_seconds: 0.0042,
        scene_bytes: 48_230,
        epsilon: 3.2e-4,
        reference: reference(name),
        verdict: verdict(name, best_name),
        methods: kinds.iter().map(|kind| method(kind, best)).collect(),
        outside: vec![OutsidePoint {
            name: "other".into(),
            seconds: 5.0,
            error: 0.03,
            solid: true,
        }],
        lengths: lengths(),
    }
}

fn verdict(scene: &str, best: &str) -> Verdict {
    Verdict {
        best: Some(best.into()),
        rivals: vec!["bdpt".into()],
        sentence: format!(
            "On {scene}, {best} reaches a given error 1.14 times (0.98–1.3) as fast as bdpt and \
             cannot be told from it; all others take at least 9 times as long."
        ),
    }
}

fn reference(scene: &str) -> ReferenceResults {
    let agreement = ReferenceAgreement {
        methods: ["bdpt".into(), "directlight".into()],
        mean_ratio: Some(Estimate { value: 1.0004, low: 0.998, high: 1.003 }),
        tiles: 108,
        refused: 0,
        masked: 0.0,
    };
    let closed = scene == "caustic";
    ReferenceResults {
        origin: if closed {
            "a closed form".into()
        } else {
            "the mean of bdpt and directlight, 4096 passes each".into()
        },
        own_error: if closed { 0.0 } else { 6e-6 },
        seconds: if closed { 0.0 } else { 912.0 },
        agreement: (!closed).then_some(agreement),
        doubted_by: None,
    }
}

fn lengths() -> Vec<LengthShare> {
    let light = [0.31, 0.42, 0.16, 0.062, 0.028, 0.011, 0.005, 0.004];
    let variance = [0.0, 0.21, 0.33, 0.22, 0.12, 0.07, 0.03, 0.02];
    let rays = [0.12, 0.14, 0.16, 0.17, 0.15, 0.12, 0.08, 0.06];
    (0..8)
        .map(|i| LengthShare {
            edges: i as u32 + 1,
            light: light[i],
            variance: variance[i],
            rays: rays[i],
        })
        .collect()
}

fn oracle() -> Oracle {
    let puremc = |r: f64| r * r / (1.0 + r * r).powi(2);
    let directlight = |r: f64| {
        let f = r * r / (1.0 + r * r);
        r * r / 3.0 * (1.0 - (1.0 + r * r).powi(-3)) - f * f
    };
    Oracle {
        curves: vec![curve("puremc", 1.1e-7, puremc), curve("directlight", 1.6e-7, directlight)],
        crossing: OracleCrossing {
            measured: Estimate { value: 1.449, low: 1.444, high: 1.455 },
            theory: 1.450_45,
        },
        crossing_in_time: OracleCrossing {
            measured: Estimate { value: 1.31, low: 1.28, high: 1.34 },
            theory: 1.32,
        },
        samples: 1_000_000,
    }
}

fn curve(method: &str, seconds: f64, variance: impl Fn(f64) -> f64) -> OracleCurve {
    let radii = [0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 5.0, 10.0];
    let point = |radius| {
        let theory = variance(radius);
        OraclePoint { radius, theory, variance: around(1.01 * theory, 1.03), seconds }
    };
    OracleCurve { method: method.into(), points: radii.map(point).to_vec() }
}
