//! Methods made up from a few numbers: error = cost/seconds + floor.

use crate::results::{Estimate, MethodResults, Metrics, Point, Rays, Stability, Target};

/// The times at which runs are looked at, in seconds.
pub(super) const BUDGETS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];

/// The properties that a method's results are made up from.
pub(super) struct Kind {
    pub(super) name: &'static str,
    /// Error times seconds.
    pub(super) cost: f64,
    /// Seconds of a pass.
    pub(super) pass: f64,
    /// Error that stays.
    pub(super) floor: f64,
    pub(super) blind: bool,
    pub(super) alarm: bool,
}

/// Unbiased and steady.
pub(super) const fn kind(name: &'static str, cost: f64, pass: f64) -> Kind {
    Kind { name, cost, pass, floor: 0.0, blind: false, alarm: false }
}

/// Makes up the results of a method, the best of its scene costing `best`.
pub(super) fn method(kind: &Kind, best: f64) -> MethodResults {
    let ratio = kind.cost / best;
    let spread = if kind.alarm { 2.5 } else { 1.15 };
    let is_best = ratio == 1.0;
    // Of values without a variance no high end is known.
    let around = |value: f64, spread: f64| {
        let estimate = around(value, spread);
        if kind.alarm { estimate.without_high() } else { estimate }
    };
    MethodResults {
        name: kind.name.into(),
        biased: kind.floor > 0.0,
        blind: if kind.blind { vec!["light of a lamp mirrored twice".into()] } else { Vec::new() },
        longest_path: kind
            .name
            .split_once("--max-depth ")
            .and_then(|(_, edges)| edges.parse().ok()),
        points: powers(kind, spread),
        budgets: budgets(kind, spread),
        cost: around(kind.cost, spread),
        cost_ratio: if is_best { around(1.0, 1.0) } else { around(ratio, spread) },
        error_per_pass: around(kind.cost / kind.pass, spread),
        seconds_per_pass: self::around(kind.pass, 1.05),
        targets: [1e-1, 1e-2, 1e-3]
            .map(|error| target(kind, error, &|t| around(t, spread)))
            .to_vec(),
        metrics: metrics(kind),
        rays: Rays { camera: 6912.0, bounce: 21_400.0, shadow: 18_100.0, per_second: 4.1e6 },
        peak_bytes: 3_200_000,
        stability: stability(kind),
        plans: Vec::new(),
    }
}

/// An interval from `value / spread` to `value · spread`.
pub(super) fn around(value: f64, spread: f64) -> Estimate {
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

fn target(kind: &Kind, error: f64, around: &dyn Fn(f64) -> Estimate) -> Target {
    let left = error - kind.floor;
    Target { error, seconds: (left > 0.0).then(|| around(kind.cost / left)) }
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
        fireflies: Some(if kind.alarm { 2300.0 } else { 0.0 }),
        worst_over_median: if kind.alarm { 14.2 } else { 1.08 },
        rejected: u64::from(kind.alarm),
    }
}
