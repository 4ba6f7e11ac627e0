//! `bdpt --auto`: the method that a plan chooses.

use crate::common::Folder;
use serde_json::Value;

/// A picture that is just worth a plan.
const PICTURE: &str = "plates --resolution 96x72 --spp 64";

/// The evidence as JSON, without a rendering.
fn explained(folder: &Folder, options: &str) -> Value {
    let run = folder.run("bdpt", &format!("{options} --auto --explain json --check"));
    assert_eq!(run.status, Some(0), "{}", run.err);
    let end = run.out.rfind('}').unwrap();
    serde_json::from_str(&run.out[..=end]).unwrap()
}

#[test]
fn a_plan_is_the_same_on_any_number_of_threads_and_can_be_given_back() {
    let folder = Folder::new();
    let plan = explained(&folder, &format!("{PICTURE} --threads 1"));
    assert_eq!(plan, explained(&folder, &format!("{PICTURE} --threads 3")));
    let method = plan["plan"].as_str().unwrap();
    // By itself, by the plan as text, and by the program that it names.
    let auto = folder.run("bdpt", &format!("{PICTURE} --auto -o auto.exr --stats done.json"));
    assert_eq!(auto.status, Some(0), "{}", auto.err);
    let done: Value = serde_json::from_slice(&folder.bytes("done.json")).unwrap();
    assert_eq!(done["plan"], plan);
    assert!(auto.err.contains(&format!("plan: {method}")), "{}", auto.err);
    let mut given = folder.command("bdpt", &format!("{PICTURE} -o given.exr --plan"));
    assert!(given.arg(method).output().unwrap().status.success());
    let (program, options) = method.split_once(' ').unwrap_or((method, ""));
    let named = folder.run(program, &format!("{PICTURE} {options} -o named.exr"));
    assert_eq!(named.status, Some(0), "{}", named.err);
    for other in ["given.exr", "named.exr"] {
        let same = folder.run("film", &format!("diff auto.exr {other} --max-relmse 0"));
        assert_eq!(same.status, Some(0), "{other}: {}{}", same.out, same.err);
    }
    // The picture says how to make it again.
    let info = folder.run("film", "info auto.exr").out;
    assert!(info.contains(&format!("{program} plates")), "{info}");
}

/// Under a lamp as large as the room nobody needs light paths; where a mirror hides the lamp's
/// light from the camera everybody does. Trials are short: of twenty seeds two chose light paths
/// for the former, at which rate fewer than seven of ten would be one case in eighty.
#[test]
fn easy_scenes_are_walked_from_the_camera_and_hard_ones_from_both_ends() {
    let folder = Folder::new();
    let method = |scene: &str, seed: u32| {
        let picture = format!("{scene} --resolution 128x96 --spp 64 --seed {seed}");
        let plan = explained(&folder, &picture);
        plan["plan"].as_str().unwrap().to_owned()
    };
    let easy: Vec<String> = (0..10).map(|seed| method("reference-a", seed)).collect();
    let walked = easy.iter().filter(|plan| plan.starts_with("directlight --combine")).count();
    assert!(walked >= 7, "{easy:?}");
    let hard = method("pyramid", 0);
    assert!(hard.starts_with("bdpt") && !hard.contains("--no-splats"), "{hard}");
}

/// Its caustic is too rare for a trial to meet: without light paths that is 80 times whole bdpt's
/// time to an error, though a trial finds less noise than of any other method.
#[test]
fn light_that_no_trial_meets_is_no_saving() {
    let plan = explained(&Folder::new(), "bowl --resolution 128x96 --spp 64");
    let method = plan["plan"].as_str().unwrap();
    assert!(method.starts_with("bdpt") && !method.contains("--no-splats"), "{method}");
}

#[test]
fn the_longest_path_is_chosen_by_what_it_loses() {
    let folder = Folder::new();
    let plan = explained(&folder, "cornell --resolution 128x96 --spp 64 --max-depth auto:1%");
    let method = plan["plan"].as_str().unwrap();
    let beyond = |edges: usize| plan["evidence"]["light_beyond_edges"][edges].as_f64().unwrap();
    let chosen = (2..=16).find(|&edges| beyond(edges) <= 0.01).unwrap();
    assert!(method.contains(&format!("--max-depth {chosen}")), "{method}: {chosen}");
    assert!((5..=10).contains(&chosen), "{chosen}");
}

#[test]
fn what_a_plan_chooses_is_not_for_others_to_say() {
    let folder = Folder::new();
    for (options, told) in [
        ("--auto --no-connections", "--no-connections is for --auto to choose"),
        ("--auto --heuristic balance", "--heuristic is for --auto to choose"),
        ("--max-depth auto:1%", "wants --auto"),
        ("--explain", "--auto"),
        ("--auto --techniques t", "--auto"),
        ("--plan bdpt --max-depth 3", "--max-depth"),
        ("--plan pt", "`pt` is no method"),
    ] {
        let run = folder.run("bdpt", options);
        assert_eq!(run.status, Some(2), "{options}: {}", run.err);
        assert!(run.err.contains(told), "{options}: {}", run.err);
    }
    assert!(folder.names().is_empty());
}

/// A picture of too few samples is rendered by all techniques at once.
#[test]
fn a_small_picture_is_worth_no_plan() {
    let folder = Folder::new();
    let run = folder.run("bdpt", "--auto --resolution 16x12 --spp 1 -o small.png");
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(run.err.contains("plan: bdpt, as the picture is too small to choose"), "{}", run.err);
}
