//! Made-up runs whose right judgement is known.

use super::*;
use crate::results::Verdict;
use crate::run::Snapshot;
use traylib_math::Sampler;

const PIXELS: usize = 400;

/// A normal law, nearly: the sum of twelve numbers.
fn normal(sampler: &mut Sampler) -> f64 {
    (0..12).map(|_| f64::from(sampler.next_1d())).sum::<f64>() - 6.0
}

/// Sixteen runs of a second and a hundred passes: each pixel off by `lost`, and by
/// noise of this deviation.
fn entry(name: &str, lost: f64, deviation: f64, reference: &Reference) -> Entry {
    let mut sampler = Sampler::numbered(3, name.len() as u64);
    let mut picture = || {
        let mut pixel = || 1.0 + lost + deviation * normal(&mut sampler);
        let values = (0..PIXELS).map(|_| [pixel(), pixel(), pixel()]).collect();
        Grid::from_values(PIXELS, 1, values).unwrap()
    };
    let pictures: Vec<Picture> = (0..16).map(|_| picture()).collect();
    let records = pictures.iter().map(|picture| record(picture, reference)).collect();
    Entry { method: name.parse().unwrap(), records, pictures }
}

fn record(picture: &Picture, reference: &Reference) -> Record {
    let error = reference.rel_mse(picture);
    let snapshot = |passes: u32, budget| Snapshot {
        passes,
        seconds: 0.01 * f64::from(passes),
        error: error * 100.0 / f64::from(passes),
        budget,
    };
    let all: Vec<f64> = picture.values().iter().flatten().copied().collect();
    Record {
        passes: 100,
        seconds: 1.0,
        snapshots: vec![snapshot(1, None), snapshot(2, None), snapshot(100, Some(0))],
        trimmed_rel_mse: error,
        smape: 0.0,
        mean_ratio: Sample::of(&all).mean,
        rays: [100, 200, 300],
        plan: None,
        rejected: 0,
        peak_bytes: 5,
        largest: Vec::new(),
    }
}

fn reference() -> Reference {
    Reference::constant(PIXELS, 1, 1.0)
}

const PLAIN: SceneFacts =
    SceneFacts { area_lights: true, point_lights: false, sky: false, mirrors: false };

#[test]
fn the_quiet_one_wins_by_the_ratio_of_variances() {
    let reference = reference();
    let entries = [entry("puremc", 0.0, 0.3, &reference), entry("bdpt", 0.0, 0.1, &reference)];
    let methods = judge(&entries, &reference, PLAIN);
    let Estimate { value, low, high } = methods[0].cost_ratio;
    assert!(low < 9.0 && 9.0 < high && high / low < 1.3, "{value} {low} {high}");
    let expected = 0.01 / 1.01;
    let cost = methods[1].cost;
    assert!(cost.low < expected && expected < cost.high, "{cost:?}");
    // 1e-2 is reached within a second, 1e-3 ten times later.
    let [_, second, third] = &methods[1].targets[..] else { panic!("three targets") };
    let times = [second, third].map(|target| target.seconds.unwrap().value);
    assert!((times[0] - expected / 1e-2).abs() < 0.1 && (times[1] / times[0] - 10.0).abs() < 1e-9);
    let verdict = verdict(&methods, &reference.results).unwrap();
    assert_eq!((verdict.best.as_deref(), verdict.rivals.len()), (Some("bdpt"), 0));
    assert!(verdict.sentence.starts_with("bdpt reaches a given error soonest: puremc takes"));
}

#[test]
fn equals_are_undecided() {
    let reference = reference();
    let entries =
        [entry("directlight --combine", 0.0, 0.1, &reference), entry("bdpt", 0.0, 0.1, &reference)];
    let methods = judge(&entries, &reference, PLAIN);
    let verdict = verdict(&methods, &reference.results).unwrap();
    assert_eq!(verdict.rivals.len(), 1, "{}", verdict.sentence);
    assert!(verdict.sentence.contains("cannot be told apart"));
}

#[test]
fn lost_light_is_told_from_noise() {
    let reference = reference();
    let entries =
        [entry("bdpt --max-depth 3", -0.2, 0.05, &reference), entry("bdpt", 0.0, 0.2, &reference)];
    let methods = judge(&entries, &reference, PLAIN);
    let biased = &methods[0];
    // Less error than the other, and still not the best.
    assert!(biased.cost.value < 1.1 * methods[1].cost.value);
    let verdict = verdict(&methods, &reference.results).unwrap();
    assert_eq!(verdict.best.as_deref(), Some("bdpt"));
    let loss = "bdpt --max-depth 3 loses light: all paths of more than 3 edges.";
    assert!(verdict.sentence.contains(loss), "{}", verdict.sentence);
    assert_eq!((methods[0].badge(), methods[1].badge()), (Some("biased"), None));
    let noise = 0.0025 / 0.0425;
    assert!((biased.metrics.noise_share - noise).abs() < 0.01, "{:?}", biased.metrics);
    assert!((biased.metrics.bias + 0.2).abs() < 0.01 && biased.metrics.bias_z < -20.0);
    assert!(biased.targets[2].seconds.is_none() && biased.targets[0].seconds.is_some());
    let share = methods[1].metrics.noise_share;
    assert!((share - 1.0).abs() < 0.01, "{share}");
    assert!(methods[1].metrics.bias_z.abs() < 4.0);
}

#[test]
fn one_edge_is_one() {
    let reference = reference();
    let entries =
        [entry("bdpt --max-depth 1", -0.2, 0.1, &reference), entry("bdpt", 0.0, 0.1, &reference)];
    let methods = judge(&entries, &reference, PLAIN);
    let sentence = verdict(&methods, &reference.results).unwrap().sentence;
    assert!(sentence.contains("all paths of more than 1 edge."), "{sentence}");
}

#[test]
fn averaged_runs_continue_the_curve() {
    let reference = reference();
    let methods = judge(&[entry("bdpt", 0.0, 0.1, &reference)], &reference, PLAIN);
    let passes: Vec<f64> = methods[0].points.iter().map(|point| point.passes).collect();
    assert_eq!(passes, [1.0, 2.0]);
    let budgets = &methods[0].budgets;
    assert_eq!(budgets.iter().map(|p| p.averaged).collect::<Vec<_>>(), [1, 2, 4, 8, 16]);
    assert_eq!(budgets[4].seconds, 16.0);
    let fall = budgets[0].error.value / budgets[4].error.value;
    assert!((12.0..20.0).contains(&fall), "{fall}");
}

#[test]
fn one_bright_pixel_of_one_run_is_a_firefly() {
    let reference = reference();
    let mut sparkling = entry("bdpt", 0.0, 0.01, &reference);
    let quiet = judge(std::slice::from_ref(&sparkling), &reference, PLAIN);
    assert_eq!(quiet[0].stability.fireflies, Some(0.0));
    sparkling.pictures[5].values_mut()[7] = [3.0; 3];
    let found = judge(&[sparkling], &reference, PLAIN)[0].stability.fireflies.unwrap();
    assert!((found - 1e6 / (16 * PIXELS) as f64).abs() < 1e-6, "{found}");
}

#[test]
fn a_reference_that_is_not_sure_is_told() {
    let exact = reference();
    let entry = entry("bdpt", 0.0, 0.1, &exact);
    let doubtful = |variance: f64| {
        let results = exact.results.clone();
        Reference::new(exact.picture.clone(), exact.picture.map(|_| [variance; 3]), results)
    };
    let solid = |reference: &Reference| {
        judge(std::slice::from_ref(&entry), reference, PLAIN)[0].budgets[0].solid
    };
    assert!(solid(&doubtful(1e-4)) && !solid(&doubtful(1e-3)));
}

#[test]
fn where_all_lose_light_nobody_is_best() {
    let reference = reference();
    let entries = [
        entry("particle", -0.2, 0.05, &reference),
        entry("bdpt --max-depth 3", -0.1, 0.1, &reference),
    ];
    let facts = SceneFacts { mirrors: true, ..PLAIN };
    let verdict = verdict(&judge(&entries, &reference, facts), &reference.results).unwrap();
    assert_eq!((verdict.best, verdict.rivals.len()), (None, 0));
    for part in ["No verdict: every method here loses light", "particle loses", "-depth 3 loses"] {
        assert!(verdict.sentence.contains(part), "{}", verdict.sentence);
    }
    assert!(!verdict.sentence.contains("times as long"), "{}", verdict.sentence);
}

#[test]
fn without_any_error_there_is_no_factor() {
    let reference = reference();
    let entries = [entry("puremc", 0.0, 0.0, &reference), entry("bdpt", 0.0, 0.0, &reference)];
    let verdict = verdict(&judge(&entries, &reference, PLAIN), &reference.results).unwrap();
    let expected = "No factor can be told: pictures of puremc and bdpt do not differ from the \
                    reference at all.";
    assert_eq!((verdict.best, verdict.sentence.as_str()), (None, expected));
}

#[test]
fn what_nobody_sees_is_told_once() {
    let reference = reference();
    let facts = SceneFacts { point_lights: true, mirrors: true, ..PLAIN };
    let entries = [entry("bdpt", 0.0, 0.1, &reference), entry("puremc", 0.0, 0.3, &reference)];
    let methods = judge(&entries, &reference, facts);
    let sentence = verdict(&methods, &reference.results).unwrap().sentence;
    assert_eq!(sentence.matches("No method here sees light of point lamps").count(), 1);
    assert!(sentence.contains("puremc loses light: "), "{sentence}");
    assert_eq!(methods[0].badge(), Some("blind"));
}

/// Held against a picture that nobody has checked: 5 standard errors of pixels for what
/// stays and 10⁻⁶ for brightness, so a right program fails once in some ten thousand years.
fn doubt(given: &Picture, names: [&str; 2]) -> (Option<String>, Verdict) {
    let truth = reference();
    let mut reference = Reference::given(given.clone(), "a picture".into());
    // Runs are of the true scene, and measured against what was given.
    let entries = names.map(|name| {
        let noise = if name == "bdpt" { 0.05 } else { 0.3 };
        let mut entry = entry(name, 0.0, noise, &truth);
        entry.records = entry.pictures.iter().map(|p| record(p, &reference)).collect();
        let bright = Sample::of(given.values().as_flattened()).mean;
        entry.records.iter_mut().for_each(|record| record.mean_ratio /= bright);
        entry
    });
    let mut methods = judge(&entries, &reference, PLAIN);
    let doubted = doubted_by(&entries, &methods, &reference).map(|method| method.to_string());
    reference.results.doubted_by.clone_from(&doubted);
    if doubted.is_some() {
        withhold(&mut methods);
        assert!(methods.iter().all(|m| m.targets.is_empty() && !m.budgets[0].solid));
    }
    let verdict = verdict(&methods, &reference.results).unwrap();
    (doubted, verdict)
}

fn noise(deviation: f64) -> Picture {
    let mut sampler = Sampler::numbered(7, 0);
    let mut pixel = || [0; 3].map(|_| 1.0 + deviation * normal(&mut sampler));
    Grid::from_values(PIXELS, 1, (0..PIXELS).map(|_| pixel()).collect()).unwrap()
}

/// One that has missed light in a tenth of the pixels, in one nearly all.
fn spotted() -> Picture {
    let mut picture = Grid::filled(PIXELS, 1, [1.0; 3]);
    picture.values_mut().iter_mut().step_by(10).for_each(|bands| *bands = [0.9; 3]);
    picture.values_mut()[0] = [0.1; 3];
    picture
}

#[test]
fn a_noisy_or_wrong_reference_gets_no_verdict() {
    let wrong = [
        ("noisy", noise(0.12)),
        ("dark in few pixels", spotted()),
        ("of another exposure", Grid::filled(PIXELS, 1, [4.5; 3])),
        ("slightly darker", Grid::filled(PIXELS, 1, [0.985; 3])),
    ];
    for (what, given) in wrong {
        let (doubted, verdict) = doubt(&given, ["puremc", "bdpt"]);
        assert_eq!((doubted.as_deref(), &verdict.best), (Some("bdpt"), &None), "{what}");
        let start = "No verdict: the reference is noisy or shows another scene.";
        assert!(verdict.sentence.starts_with(start), "{}", verdict.sentence);
        assert!(!verdict.sentence.contains("times as long"), "{}", verdict.sentence);
    }
}

#[test]
fn a_good_reference_is_believed_unchecked() {
    for given in [noise(0.0), noise(0.003)] {
        let (doubted, verdict) = doubt(&given, ["puremc", "bdpt"]);
        assert_eq!((doubted, verdict.best.as_deref()), (None, Some("bdpt")));
    }
}

/// Pareto's law with an index of 1.1 has no variance.
fn without_variance(entry: &mut Entry) {
    let largest = (1..=4096).map(|k| (4096.0 / f64::from(k)).powf(1.0 / 1.1)).collect();
    entry.records[0].largest = largest;
}

#[test]
fn of_values_without_a_variance_no_high_end_is_known() {
    let reference = reference();
    let mut wild = entry("puremc", 0.0, 0.3, &reference);
    without_variance(&mut wild);
    let mut best = entry("bdpt", 0.0, 0.1, &reference);
    let methods = judge(&[wild.clone(), best.clone()], &reference, PLAIN);
    let found = &methods[0];
    assert!(found.stability.alarm && !methods[1].stability.alarm);
    let times = found.targets.iter().map(|target| target.seconds.unwrap());
    let errors = found.points.iter().chain(&found.budgets).map(|point| point.error);
    for estimate in times.chain(errors).chain([found.cost, found.error_per_pass, found.cost_ratio])
    {
        assert!(estimate.knows_low() && !estimate.knows_high(), "{estimate:?}");
    }
    let sentence = verdict(&methods, &reference.results).unwrap().sentence;
    assert!(sentence.contains("puremc takes at least "), "{sentence}");
    // And nothing of the ratio of two such methods.
    without_variance(&mut best);
    let methods = judge(&[wild, best], &reference, PLAIN);
    let ratio = methods[0].cost_ratio;
    assert!(!ratio.knows_low() && !ratio.knows_high(), "{ratio:?}");
    assert_eq!(verdict(&methods, &reference.results).unwrap().rivals, ["puremc"]);
}
