//! The table of layers: what each crate may be built from.
//!
//! Arrows go down only, and two crates on one floor never see each other: math and
//! statistics, geometry and materials, io and integrators, demos and known. A crate is missing from a row
//! because that row's package must not need to know of it.

/// One package of the workspace and the packages it may depend on.
pub(super) struct Layer {
    pub(super) package: &'static str,
    /// Always allowed.
    pub(super) may_use: &'static [&'static str],
    /// Allowed if optional.
    pub(super) behind_features: &'static [&'static str],
}

/// All packages, ground floor first.
pub(super) const LAYERS: &[Layer] = &[
    layer("traylib-math", &["glam", "rand_core", "rand_pcg"]),
    Layer { package: "traylib-statistics", may_use: &["statrs"], behind_features: &["serde"] },
    Layer {
        package: "traylib-geometry",
        may_use: &["traylib-math"],
        behind_features: &["rayon", "serde"],
    },
    layer("traylib-materials", &["traylib-math", "thiserror"]),
    layer("traylib-scene", &["traylib-math", "traylib-geometry", "traylib-materials", "thiserror"]),
    layer(
        "traylib-io",
        &[
            "traylib-math",
            "traylib-geometry",
            "traylib-materials",
            "traylib-scene",
            "annotate-snippets",
            "base64",
            "crc32fast",
            "exr",
            "image",
            "pcx",
            "png",
            "ron",
            "roxmltree",
            "serde",
            "serde_json",
            "strsim",
            "thiserror",
        ],
    ),
    layer(
        "traylib-integrators",
        &["traylib-math", "traylib-geometry", "traylib-materials", "traylib-scene", "rayon"],
    ),
    layer(
        "traylib-known",
        &[
            "traylib-math",
            "traylib-statistics",
            "traylib-geometry",
            "traylib-materials",
            "traylib-scene",
            "traylib-integrators",
            "glam",
        ],
    ),
    layer(
        "traylib-demos",
        &[
            "traylib-math",
            "traylib-statistics",
            "traylib-geometry",
            "traylib-materials",
            "traylib-scene",
            "traylib-io",
            "traylib-integrators",
            "clap",
            "clap_complete",
            "clap_mangen",
            "ctrlc",
            "indicatif",
            "rayon",
            "serde_json",
            "signal-hook",
        ],
    ),
    layer(
        "traylib-tests",
        &[
            "traylib-math",
            "traylib-statistics",
            "traylib-geometry",
            "traylib-materials",
            "traylib-scene",
            "traylib-io",
            "traylib-integrators",
            "traylib-known",
            "glam",
            "maud",
            "serde",
            "serde_json",
        ],
    ),
    layer(
        "traylib-realtime",
        &[
            "traylib-math",
            "traylib-scene",
            "traylib-io",
            "traylib-integrators",
            "traylib-demos",
            "clap",
            "minifb",
            "rayon",
        ],
    ),
    layer(
        "traylib-compare",
        &[
            "traylib-math",
            "traylib-statistics",
            "traylib-geometry",
            "traylib-scene",
            "traylib-io",
            "traylib-integrators",
            "traylib-known",
            "traylib-demos",
            "base64",
            "clap",
            "image",
            "indicatif",
            "maud",
            "peak_alloc",
            "plotters",
            "serde",
            "serde_json",
        ],
    ),
    layer(
        "xtask",
        &[
            "traylib-math",
            "traylib-geometry",
            "traylib-materials",
            "traylib-scene",
            "traylib-io",
            "traylib-integrators",
            "anyhow",
            "diffy",
            "flate2",
            "pulldown-cmark",
            "serde_json",
            "syn",
            "tar",
            "tempfile",
            "zip",
        ],
    ),
];

const fn layer(package: &'static str, may_use: &'static [&'static str]) -> Layer {
    Layer { package, may_use, behind_features: &[] }
}
