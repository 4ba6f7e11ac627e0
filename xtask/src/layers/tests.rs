use super::*;
use serde_json::json;

const TWO_FLOORS: &[Layer] = &[
    Layer { package: "ground", may_use: &["vectors"], behind_features: &["threads"] },
    Layer { package: "upper", may_use: &["ground"], behind_features: &[] },
];

/// Metadata of a workspace with one package and one dependency.
fn one_arrow(from: &str, to: &str, kind: Option<&str>, optional: bool) -> Value {
    let arrow = json!({ "name": to, "kind": kind, "optional": optional });
    json!({ "packages": [{ "name": from, "dependencies": [arrow] }] })
}

fn check(metadata: &Value) -> Vec<String> {
    wrong_arrows(metadata, TWO_FLOORS).unwrap()
}

#[test]
fn arrows_down_are_fine() {
    assert!(check(&one_arrow("upper", "ground", None, false)).is_empty());
    assert!(check(&one_arrow("ground", "vectors", None, true)).is_empty());
}

#[test]
fn an_arrow_up_is_found() {
    let wrong = check(&one_arrow("ground", "upper", None, false));
    assert_eq!(wrong, ["ground -> upper: not allowed"]);
}

#[test]
fn a_build_dependency_is_an_arrow_too_and_a_development_dependency_is_none() {
    assert_eq!(check(&one_arrow("ground", "upper", Some("build"), false)).len(), 1);
    assert!(check(&one_arrow("ground", "upper", Some("dev"), false)).is_empty());
}

#[test]
fn a_package_outside_the_table_is_found() {
    let wrong = check(&one_arrow("cellar", "vectors", None, false));
    assert_eq!(wrong, ["cellar: not in the table"]);
}

#[test]
fn a_feature_must_stay_a_feature() {
    assert!(check(&one_arrow("ground", "threads", None, true)).is_empty());
    let wrong = check(&one_arrow("ground", "threads", None, false));
    assert_eq!(wrong, ["ground -> threads: allowed behind a feature only"]);
}

#[test]
fn every_fault_gets_a_line() {
    let arrow = |to| json!({ "name": to, "kind": null, "optional": false });
    let metadata = json!({ "packages": [
        { "name": "ground", "dependencies": [arrow("upper"), arrow("vectors")] },
        { "name": "upper", "dependencies": [arrow("ground"), arrow("files")] },
    ] });
    let wrong = check(&metadata);
    assert_eq!(wrong, ["ground -> upper: not allowed", "upper -> files: not allowed"]);
}

#[test]
fn something_else_than_metadata_is_refused() {
    assert!(wrong_arrows(&json!({}), TWO_FLOORS).is_err());
    assert!(wrong_arrows(&json!({ "packages": [{ "name": "ground" }] }), TWO_FLOORS).is_err());
}

/// A row may name only packages of rows above it in the table: the rows are in
/// the order of the floors.
#[test]
fn the_table_itself_points_down() {
    for (floor, layer) in table::LAYERS.iter().enumerate() {
        for &name in layer.may_use {
            let target = table::LAYERS.iter().position(|other| other.package == name);
            assert!(target.is_none_or(|target| target < floor), "{} -> {name}", layer.package);
        }
    }
}
