//! Relations that a right renderer keeps, on drawn scenes and on those that broke one
//! before they were mended. At length: `cargo xtask relations`.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on says so")]
#![allow(clippy::print_stdout, reason = "the figures are worth reading")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Duration;
use traylib_tests::findings::{Finding, settle};
use traylib_tests::relations::case::{Case, files};
use traylib_tests::relations::form::Files;
use traylib_tests::relations::relation::Relation;
use traylib_tests::relations::render::{Estimator, Workshop};
use traylib_tests::relations::run::{Bench, Plan, Summary, run};
use traylib_tests::relations::{draw, judge, shrink};

/// The probability that a right program fails one of the tests here: 10⁻⁹ for each claim, of which
/// there are less than 10⁴.
const LEVEL: f64 = 1e-5;
/// Samples of a pass: the film has 16 × 16 pixels.
const PIXELS: u64 = 256;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/relations")
}

/// A finding for each relation.
fn findings(subject: &str, summary: &Summary, passes: u32) -> Vec<Finding> {
    let mut by_relation: BTreeMap<Relation, (u64, Vec<String>)> = BTreeMap::new();
    for (relation, _, _) in &summary.held {
        by_relation.entry(*relation).or_default().0 += 1;
    }
    for outcome in &summary.others {
        by_relation.entry(outcome.relation).or_default().1.push(outcome.to_string());
    }
    let finding = |(relation, (held, broken)): (Relation, (u64, Vec<String>))| Finding {
        claim: format!("{subject}: {relation}"),
        statistic: match broken.first() {
            None => format!("{held} claims hold"),
            Some(first) => format!("{held} claims hold, {} do not: {first}", broken.len()),
        },
        level: Some(LEVEL),
        samples: (held + broken.len() as u64) * u64::from(passes) * PIXELS,
        holds: broken.is_empty(),
    };
    by_relation.into_iter().map(finding).collect()
}

#[test]
fn drawn_scenes_keep_all_relations() {
    let plan = Plan { scenes: 0..200, passes: 16, changes: 3, shrink: None, ..Plan::default() };
    let summary = run(&plan, &|outcome| println!("{outcome}"));
    settle(&findings("drawn scenes", &summary, plan.passes));
}

/// Scenes that broke a relation once, and the right values of those that have one.
#[test]
fn scenes_that_were_caught_keep_all_relations() {
    let passes = 32;
    let workshop = Workshop::new(Duration::from_mins(1)).unwrap();
    for file in files(&folder()).unwrap() {
        let case = Case::read(&file).unwrap();
        let right = case.right;
        let bench = Bench { workshop: &workshop, seed: 1, number: 0, passes, right, turn: 0 };
        settle(&findings(&case.name, &bench.judge(&case.drawn, &Relation::all()), passes));
    }
}

/// To the letter, but for files of shapes, in which corners are not shared.
#[test]
fn scenes_come_back_from_their_files() {
    let folder = std::env::temp_dir().join(format!("traylib-relations-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for number in 0..200 {
        let written = Files::of(&draw::scene(3, number), "scene");
        written.save(&folder, "").unwrap();
        let read = Case::read(&folder.join(written.name())).unwrap().drawn;
        written.remove(&folder);
        let again = Files::of(&read, "scene");
        assert_eq!(again.text, written.text, "scene {number}");
        for (old, new) in written.beside.iter().zip(&again.beside) {
            let is_mgf = Path::new(&old.0).extension().is_some_and(|ending| ending == "mgf");
            assert!(old == new || is_mgf, "scene {number}, {}", old.0);
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

/// A claim that is wrong by 5 % is refused, the same claim that is right is not.
#[test]
fn the_judge_sees_a_twentieth() {
    let workshop = Workshop::new(Duration::from_mins(1)).unwrap();
    let case = Case::read(&folder().join("floor-at-zero.ron")).unwrap();
    let verdict = |mean: f64| {
        let built = std::sync::Arc::new(workshop.build(&case.drawn).unwrap());
        let estimator = Estimator::Method(traylib_tests::methods::PURE_MC);
        let part = judge::Part { built, estimator, brightest: 1.0, is_rare: true };
        let claim = judge::Claim {
            what: String::new(),
            left: judge::Side::Rendered(vec![part]),
            right: judge::Side::Known(mean),
            flipped: false,
            factor: 1.0,
            law: judge::Law::SameMean(1e-4),
            numbers: judge::Numbers::Own,
        };
        judge::judge(&claim, &workshop, 64, 1)
    };
    assert!(matches!(verdict(0.5), judge::Verdict::Holds(_)), "{:?}", verdict(0.5));
    assert!(matches!(verdict(0.525), judge::Verdict::Broken(_)), "{:?}", verdict(0.525));
}

/// Objects that have nothing to do with a fault are left out: here the fault is a mesh.
#[test]
fn scenes_shrink_to_what_matters() {
    let is_mesh = |object: &traylib_tests::relations::scene::Object| {
        matches!(object.shape, traylib_tests::relations::scene::Shape::Mesh(_))
    };
    let numbers = (0..).filter(|&number| draw::scene(1, number).objects.iter().any(is_mesh));
    for number in numbers.take(5) {
        let drawn = draw::scene(1, number);
        let small = shrink::shrink(&drawn, Duration::from_mins(1), |scene| {
            scene.objects.iter().any(is_mesh)
        });
        assert!(small.objects.iter().filter(|object| is_mesh(object)).count() == 1);
        assert!(small.objects.len() + small.lights.len() <= 2, "{small:?}");
    }
}
