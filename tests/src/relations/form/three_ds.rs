//! 3D Studio's format.

use crate::relations::scene::{Base, Material, Mesh, Object, Shape};
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// One mesh without a material.
pub(super) fn mesh(mesh: &Mesh) -> Vec<u8> {
    let object = object("only", mesh, None);
    file(&object)
}

/// Tells whether 3D Studio has words for it.
pub(super) fn can_say(material: &Material) -> bool {
    let known = match material.base {
        Base::Lambert(_) => true,
        Base::Phong(lobes) => (1.0..=1024.0).contains(&lobes.exponent),
        Base::MaxPhong(..)
        | Base::Mirror(..)
        | Base::Sheet(..)
        | Base::Glass(_)
        | Base::Pane(..) => false,
    };
    known && !material.has_maps()
}

/// These meshes, each with a material of its own.
pub(super) fn whole(objects: &[Object]) -> Vec<u8> {
    let mut editor = Vec::new();
    for (number, object) in objects.iter().enumerate() {
        let (diffuse, specular, exponent) = match object.material.base {
            Base::Phong(lobes) => (lobes.diffuse, lobes.specular, lobes.exponent),
            Base::Lambert(colour) => (colour, Vec3::ZERO, 1.0),
            // Not among what can be said.
            Base::MaxPhong(..)
            | Base::Mirror(..)
            | Base::Sheet(..)
            | Base::Glass(_)
            | Base::Pane(..) => {
                continue;
            }
        };
        let name = format!("m{number}");
        let mut parts = [
            chunk(0xa000, &text(&name)),
            chunk(0xa020, &colour(diffuse)),
            chunk(0xa030, &colour(specular)),
            chunk(0xa040, &fraction(exponent.log2() / 10.0)),
            chunk(0xa041, &fraction(if specular == Vec3::ZERO { 0.0 } else { 1.0 })),
        ]
        .concat();
        if object.sides == Sides::Both {
            parts.extend(chunk(0xa081, &[]));
        }
        editor.extend(chunk(0xafff, &parts));
        editor.extend(placed(&name, object));
    }
    file(&editor)
}

/// One mesh that shines of itself, as a share of its brightest band.
pub(super) fn lamp(object: &Object, brightest: f32) -> Vec<u8> {
    let parts = [
        chunk(0xa000, &text("lamp")),
        chunk(0xa020, &colour(object.emission / brightest)),
        chunk(0xa041, &fraction(0.0)),
        chunk(0xa084, &fraction(1.0)),
    ];
    file(&[chunk(0xafff, &parts.concat()), placed("lamp", object)].concat())
}

fn placed(name: &str, object: &Object) -> Vec<u8> {
    match &object.shape {
        Shape::Mesh(mesh) => self::object(name, mesh, Some(name)),
        Shape::Triangle(_)
        | Shape::Quad(_)
        | Shape::Disk { .. }
        | Shape::Cone { .. }
        | Shape::Sphere { .. }
        | Shape::Box(_) => Vec::new(),
    }
}

/// Coded for a screen.
fn colour(linear: Vec3) -> Vec<u8> {
    let coded = linear.to_array().map(|band| {
        let band = f64::from(band);
        (if band <= 0.003_130_8 { 12.92 * band } else { 1.055 * band.powf(1.0 / 2.4) - 0.055 })
            as f32
    });
    chunk(0x0010, &floats(Vec3::from_array(coded)))
}

fn fraction(fraction: f32) -> Vec<u8> {
    chunk(0x0031, &fraction.to_le_bytes())
}

/// A whole file with these chunks in its section of meshes and materials.
pub(super) fn file(editor: &[u8]) -> Vec<u8> {
    chunk(0x4d4d, &[chunk(0x0002, &3_u32.to_le_bytes()), chunk(0x3d3d, editor)].concat())
}

/// A mesh by name, all of its faces of the material of this name.
pub(super) fn object(name: &str, mesh: &Mesh, material: Option<&str>) -> Vec<u8> {
    let mut vertices = count(mesh.positions.len());
    vertices.extend(mesh.positions.iter().flat_map(|&position| floats(position)));
    let mut faces = count(mesh.triangles.len());
    for triangle in &mesh.triangles {
        faces.extend(triangle.iter().flat_map(|&corner| (corner as u16).to_le_bytes()));
        faces.extend(7_u16.to_le_bytes());
    }
    if let Some(material) = material {
        let mut group = text(material);
        group.extend(count(mesh.triangles.len()));
        group.extend((0..mesh.triangles.len()).flat_map(|face| (face as u16).to_le_bytes()));
        faces.extend(chunk(0x4130, &group));
    }
    let mut parts = chunk(0x4110, &vertices);
    if let Some(uvs) = &mesh.uvs {
        let mut places = count(uvs.len());
        for uv in uvs {
            places.extend([uv.x, uv.y].iter().flat_map(|f| f.to_le_bytes()));
        }
        parts.extend(chunk(0x4140, &places));
    }
    parts.extend(chunk(0x4120, &faces));
    let mut object = text(name);
    object.extend(chunk(0x4100, &parts));
    chunk(0x4000, &object)
}

/// A number, the length of all, the content.
pub(super) fn chunk(id: u16, content: &[u8]) -> Vec<u8> {
    let mut bytes = id.to_le_bytes().to_vec();
    bytes.extend((content.len() as u32 + 6).to_le_bytes());
    bytes.extend(content);
    bytes
}

pub(super) fn text(text: &str) -> Vec<u8> {
    [text.as_bytes(), b"\0"].concat()
}

pub(super) fn floats(v: Vec3) -> Vec<u8> {
    v.to_array().iter().flat_map(|f| f.to_le_bytes()).collect()
}

fn count(count: usize) -> Vec<u8> {
    (count as u16).to_le_bytes().to_vec()
}
