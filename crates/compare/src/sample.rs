//! A made-up comparison, for tests of page and chart.

mod pictures;

use crate::pictures::ScenePictures;
use crate::results::{
    Estimate, How, LengthShare, MethodResults, Metrics, Oracle, OracleCrossing, OracleCurve,
    OraclePoint, OutsidePoint, Point, Rays, ReferenceAgreement, ReferenceResults, Results,
    SceneResults, Stability, Target, Verdict,
};

/// Two scenes with five methods each: one blind, one biased, one without variance;
/// a picture of another program; the oracle.
pub fn sample() -> (Results, Vec<ScenePictures>) {
    let scenes = vec![scene("cornell", &CORNELL), scene("caustic", &CAUSTIC)];
    let pictures = scenes.iter().map(pictures::of).collect();
    (Results { how: how(), scenes, oracle: Some(oracle()), complete: false }, pictures)
}

/// What a method is made up from.
struct Kind {
    name: &'static str,
    /// Error times seconds.
    cost: f64,
    /// Seconds of a pass.
    pass: f64,
    /// Error that stays.
    floor: f64,
    blind: bool,
    alarm: bool,
}

const fn kind(name: &'static str, cost: f64, pass: f64) -> Kind {
    Kind { name, cost, pass, floor: 0.0, blind: false, alarm: false }
}

const CORNELL: [Kind; 5] = [
    kind("directlight", 0.021, 0.011),
    kind("bdpt", 0.024, 0.048),
    Kind { floor: 2.0e-3, ..kind("bdpt:depth=6", 0.017, 0.034) },
    kind("puremc", 1.9, 0.0085),
    Kind { floor: 0.4, blind: true, ..kind("particle", 0.35, 0.019) },
];

const CAUSTIC: [Kind; 5] = [
    Kind { alarm: true, ..kind("directlight", 340.0, 0.012) },
    kind("bdpt", 0.09, 0.051),
    Kind { floor: 5.0e-4, ..kind("bdpt:depth=6", 0.085, 0.04) },
    Kind { floor: 0.97, blind: true, ..kind("puremc", 0.02, 0.009) },
    kind("particle", 0.04, 0.02),
];

const BUDGETS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];
const SEEDS: u32 = 16;

fn how() -> How {
    How {
        command: "cargo xtask compare-integrators --scenes cornell,caustic --budgets 1s,2s,4s,8s"
            .into(),
        program: "traylib-compare 0.1.0".into(),
        commit: Some("0123abc+".into()),
        processor: "A processor with a rather long name @ 3.10GHz".into(),
        threads: 2,
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
        best: best.into(),
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
        mean_ratio: Estimate { value: 1.0004, low: 0.998, high: 1.003 },
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
    }
}

fn method(kind: &Kind, best: f64) -> MethodResults {
    let ratio = kind.cost / best;
    let spread = if kind.alarm { 2.5 } else { 1.15 };
    let is_best = ratio == 1.0;
    MethodResults {
        name: kind.name.into(),
        biased: kind.floor > 0.0,
        blind: if kind.blind { vec!["light of a lamp mirrored twice".into()] } else { Vec::new() },
        points: powers(kind, spread),
        budgets: budgets(kind, spread),
        cost: around(kind.cost, spread),
        cost_ratio: if is_best { around(1.0, 1.0) } else { around(ratio, spread) },
        error_per_pass: around(kind.cost / kind.pass, spread),
        seconds_per_pass: around(kind.pass, 1.05),
        targets: [1e-1, 1e-2, 1e-3].map(|error| target(kind, error, spread)).to_vec(),
        metrics: metrics(kind),
        rays: Rays { camera: 6912.0, bounce: 21_400.0, shadow: 18_100.0, per_second: 4.1e6 },
        peak_bytes: 3_200_000,
        stability: stability(kind),
    }
}

fn around(value: f64, spread: f64) -> Estimate {
    Estimate { value, low: value / spread, high: value * spread }
}

fn point(kind: &Kind, seconds: f64, averaged: u32, spread: f64) -> Point {
    let error = kind.cost / seconds + kind.floor;
    Point {
        passes: (seconds / kind.pass).max(1.0).round(),
        seconds,
        error: around(error, spread.sqrt()),
        low: error / spread,
        high: error * spread * spread,
        averaged,
        solid: error > 1.2e-4,
    }
}

fn powers(kind: &Kind, spread: f64) -> Vec<Point> {
    let times = (0..20).map(|k| kind.pass * f64::from(1 << k));
    times.take_while(|&t| t <= 8.0).map(|t| point(kind, t, 1, spread)).collect()
}

fn budgets(kind: &Kind, spread: f64) -> Vec<Point> {
    let own = BUDGETS.iter().map(|&t| point(kind, t, 1, spread));
    let longer = (1..=4).map(|k| point(kind, 8.0 * f64::from(1 << k), 1 << k, spread));
    own.chain(longer).collect()
}

fn target(kind: &Kind, error: f64, spread: f64) -> Target {
    let left = error - kind.floor;
    Target { error, seconds: (left > 0.0).then(|| around(kind.cost / left, spread)) }
}

fn metrics(kind: &Kind) -> Metrics {
    let rel_mse = kind.cost / 8.0 + kind.floor;
    Metrics {
        rel_mse,
        trimmed_rel_mse: 0.8 * rel_mse,
        smape: rel_mse.sqrt().min(1.0) / 2.0,
        bias: if kind.blind { -0.41 } else { 0.0007 },
        bias_z: if kind.blind { -212.0 } else { 0.8 },
        noise_share: 1.0 - kind.floor / rel_mse,
    }
}

fn stability(kind: &Kind) -> Stability {
    let tail = Estimate { value: 1.52, low: 1.4, high: 1.66 };
    Stability {
        tail: (kind.alarm || kind.cost > 1.0).then_some(if kind.alarm {
            tail
        } else {
            around(3.1, 1.2)
        }),
        alarm: kind.alarm,
        fireflies: if kind.alarm { 2300.0 } else { 0.0 },
        worst_over_median: if kind.alarm { 14.2 } else { 1.08 },
        rejected: u64::from(kind.alarm),
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
