//! `cargo xtask layers`: the arrows between packages, held against a table, and no circles
//! of files within any.

mod circles;
mod modules;
mod table;

#[cfg(test)]
mod tests;

use crate::workspace::cargo;
use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::path::Path;
use table::Layer;

/// Reads the workspace's packages from cargo and their modules from source, and prints
/// every arrow that the table does not have or that is part of a circle; an error if there
/// is one.
pub(crate) fn run() -> Result<()> {
    let metadata = metadata()?;
    let wrong = wrong_arrows(&metadata, table::LAYERS)?;
    let circular = circular_arrows(&metadata)?;
    for line in wrong.iter().chain(&circular) {
        println!("{line}");
    }
    let table = "xtask/src/layers/table.rs";
    ensure!(
        wrong.is_empty(),
        "dependencies that are not in the table of layers ({table}): {}",
        wrong.len()
    );
    ensure!(circular.is_empty(), "imports that are part of a circle of files: {}", circular.len());
    Ok(())
}

/// One line for each import that is part of a circle, in libraries and programs.
fn circular_arrows(metadata: &Value) -> Result<Vec<String>> {
    let mut circular = Vec::new();
    for package in list(metadata, "packages")? {
        let name = text(package, "name")?;
        for target in list(package, "targets")? {
            let kinds = list(target, "kind")?;
            if kinds.iter().any(|kind| kind == "lib" || kind == "bin") {
                let modules = modules::read(Path::new(text(target, "src_path")?))?;
                let lines = circles::circles(&modules);
                circular.extend(lines.into_iter().map(|line| format!("{name}: {line}")));
            }
        }
    }
    Ok(circular)
}

fn metadata() -> Result<Value> {
    let output = cargo(&["metadata", "--format-version", "1", "--no-deps"])
        .output()
        .context("cargo metadata does not start")?;
    ensure!(
        output.status.success(),
        "cargo metadata failed:\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    serde_json::from_slice(&output.stdout).context("cargo metadata is not JSON")
}

/// One line for each dependency outside `layers`. Development dependencies are
/// free: nobody who uses a crate gets them.
fn wrong_arrows(metadata: &Value, layers: &[Layer]) -> Result<Vec<String>> {
    let mut wrong = Vec::new();
    for package in list(metadata, "packages")? {
        let name = text(package, "name")?;
        let Some(layer) = layers.iter().find(|layer| layer.package == name) else {
            wrong.push(format!("{name}: not in the table"));
            continue;
        };
        for dependency in list(package, "dependencies")? {
            if dependency["kind"] != "dev" {
                wrong.extend(fault(layer, dependency)?);
            }
        }
    }
    Ok(wrong)
}

/// Says what is wrong with one dependency of a package in `layer`, if anything.
fn fault(layer: &Layer, dependency: &Value) -> Result<Option<String>> {
    let name = text(dependency, "name")?;
    if layer.may_use.contains(&name) {
        return Ok(None);
    }
    let complaint = match (layer.behind_features.contains(&name), &dependency["optional"]) {
        (true, Value::Bool(true)) => return Ok(None),
        (true, _) => "allowed behind a feature only",
        (false, _) => "not allowed",
    };
    Ok(Some(format!("{} -> {name}: {complaint}", layer.package)))
}

fn list<'a>(value: &'a Value, key: &str) -> Result<&'a [Value]> {
    let items = value[key].as_array();
    items.map(Vec::as_slice).with_context(|| format!("cargo metadata has no list `{key}`"))
}

fn text<'a>(value: &'a Value, key: &str) -> Result<&'a str> {
    value[key].as_str().with_context(|| format!("cargo metadata has no text `{key}`"))
}
