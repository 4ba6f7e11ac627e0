//! Finds the scenes that are compiled in: through a link in this folder, which becomes files
//! in a package of this crate, or where the project has them if links are no links here.
#![allow(clippy::print_stdout, reason = "so Cargo is told")]

use std::path::Path;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let package = std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default();
    let sources = Path::new(&package).join("src");
    // From the sources, as `include_bytes` wants it, so that a project may be moved.
    for folder in ["../scenes", "../../../scenes"] {
        if sources.join(folder).join("cornell.ron").is_file() {
            println!("cargo::rustc-env=TRAYLIB_SCENES={folder}");
            return;
        }
    }
}
