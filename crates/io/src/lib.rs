//! Scene and picture files.
//!
//! A decoder turns bytes into a plain document and knows nothing else
//! ([`ron_scene`], [`gltf`], [`obj`], [`ply`], [`three_ds`], [`mgf`], [`mitsuba`]); importing turns documents into a scene
//! ([`load_scene`]). Pictures go out through [`save_picture`] and come in through
//! [`load_exr`] and [`load_texture`].
//!
//! ```
//! let loaded = traylib_io::load_scene("cornell")?;
//! assert_eq!(loaded.scene.camera().width(), 400);
//! # Ok::<(), traylib_io::Error>(())
//! ```
//!
//! Nothing here prints, and no input makes it panic: what makes no sense is an
//! [`Error`], what is skipped or repaired is a [`Warning`] handed back beside the
//! result.

mod builtin;
mod chromaticities;
mod error;
mod export;
mod film;
mod film_fault;
mod format_error;
pub mod gltf;
mod import;
mod inventory;
mod limit;
mod load;
mod load_options;
pub mod locate;
mod mesh_counts;
pub mod mgf;
pub mod mitsuba;
pub mod obj;
pub mod picture;
pub mod ply;
mod polygon;
mod polygon_limits;
mod printable;
mod read_limits;
mod replace;
pub mod report;
pub mod ron_scene;
mod source;
mod srgb;
mod suggest;
pub mod texture;
mod texture_error;
pub mod three_ds;
pub mod warning_counts;

pub use builtin::builtin_names;
pub use error::{Error, Warning};
pub use export::{Converted, convert_scene};
pub use film::{FilmAbout, FilmReader, check_films_fit, load_film, merge_films, save_film};
pub use film_fault::{FilmDifference, FilmFault};
pub use format_error::FormatError;
pub use inventory::{Inventory, SceneCounts, inventory};
pub use limit::{Limit, MAX_PIXELS};
pub use load::{Loaded, load_scene, load_scene_with};
pub use load_options::{Headlight, LoadOptions, SceneSettings};
pub use mesh_counts::MeshCounts;
pub use picture::{
    ExrChannel, ExrFile, ExrLayer, Look, PictureFrame, PictureInfo, PictureLayer, Tone,
    check_picture, check_writable, exposure_of, load_exr, losses, open_exr, png_texts,
    save_picture, save_picture_with, write_picture,
};
pub use printable::{printable, printable_json};
pub use read_limits::ReadLimits;
pub(crate) use replace::write_file_by;
pub use replace::{check_file, discard_unfinished, write_file};
pub use texture::{Coding, Texture, TextureLimits, load_texture, texture_from_bytes};
pub use texture_error::{Fault, TextureError};

/// What the package says of itself is run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
