//! A scene as files, and back as what the library makes of them.

use super::motion::Motion;
use super::{mgf, picture};
use crate::relations::scene::{Picture, Shape};
use std::fs;
use std::io;
use std::path::Path;
use traylib_math::Vec3;
use traylib_math::glam::DMat3;

/// The placement of the shapes of other files by a scene file: scaled, then turned about one axis
/// by right angles, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Metres a unit of the file.
    pub scale: f32,
    /// Degrees about x, y and z, of which one is not zero at most.
    pub rotate: [f32; 3],
    /// In metres.
    pub translate: Vec3,
}

/// A scene file and what has to lie beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct Files {
    /// The scene file.
    pub text: String,
    /// Names and contents of the others.
    pub beside: Vec<(String, Vec<u8>)>,
    stem: String,
    pub(super) ending: &'static str,
    placement: Option<Placement>,
}

impl Placement {
    /// Returns the shape as it stands in a file that is placed so. Right angles are exact, as they
    /// are where files are read: else what touches would not touch any more.
    fn taken_back(&self, shape: &Shape) -> Shape {
        let [x, y, z] = self.rotate.map(|degrees| f64::from(degrees).to_radians());
        let turn =
            DMat3::from_rotation_z(z) * DMat3::from_rotation_y(y) * DMat3::from_rotation_x(x);
        let turn = DMat3::from_cols_array(&turn.to_cols_array().map(f64::round));
        let (back, scale) = (turn.transpose(), 1.0 / f64::from(self.scale));
        let shift = back * self.translate.as_dvec3() * -scale;
        Motion { turn: back, scale, shift }.shape(shape)
    }
}

impl Files {
    /// The words for a shape that stands in an MGF file of its own, if it should.
    pub(super) fn mesh(&mut self, shape: &Shape) -> String {
        let Some(placement) = self.placement else {
            return format!("Mesh(file: \"{}\")", self.add("mgf", mgf::single(shape).into_bytes()));
        };
        let taken_back = mgf::single(&placement.taken_back(shape));
        let file = self.add("mgf", taken_back.into_bytes());
        let Placement { scale, rotate: [x, y, z], translate } = placement;
        let translate = vector(translate);
        format!(
            "Mesh(file: \"{file}\", scale: {scale}, rotate: ({x}, {y}, {z}), translate: {translate})"
        )
    }

    /// Tells whether shapes that need no file get one.
    pub(super) fn places_all(&self) -> bool {
        self.placement.is_some()
    }

    pub(super) fn empty(stem: &str, placement: Option<Placement>) -> Self {
        Self {
            text: String::new(),
            beside: Vec::new(),
            stem: stem.into(),
            ending: "ron",
            placement,
        }
    }

    /// The name of the scene file.
    pub fn name(&self) -> String {
        format!("{}.{}", self.stem, self.ending)
    }

    /// Adds a file and gives its name; the same content once.
    pub(super) fn add(&mut self, ending: &str, content: Vec<u8>) -> String {
        if let Some((name, _)) =
            self.beside.iter().find(|(name, old)| name.ends_with(ending) && *old == content)
        {
            return name.clone();
        }
        let name = format!("{}-{}.{ending}", self.stem, self.beside.len());
        self.beside.push((name.clone(), content));
        name
    }

    pub(super) fn add_picture(&mut self, picture: &Picture) -> String {
        let (ending, content) = picture::file(picture);
        self.add(ending, content)
    }

    /// Writes all into a folder; `head` goes before the text, as comments.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn save(&self, folder: &Path, head: &str) -> io::Result<()> {
        for (name, content) in &self.beside {
            fs::write(folder.join(name), content)?;
        }
        let head: Vec<String> = head.lines().map(|line| format!("// {line}\n")).collect();
        fs::write(folder.join(self.name()), head.concat() + &self.text)
    }

    /// Removes what [`save`](Self::save) wrote.
    pub fn remove(&self, folder: &Path) {
        for (name, _) in &self.beside {
            let _ = fs::remove_file(folder.join(name));
        }
        let _ = fs::remove_file(folder.join(self.name()));
    }
}

/// Three numbers, as short as they can be read back to the last bit.
pub(super) fn vector(v: Vec3) -> String {
    format!("({}, {}, {})", v.x, v.y, v.z)
}
