//! Writes a scene with most of it in a file of another format.

use super::ron::{self, Entry};
use super::{Files, mgf, three_ds};
use crate::relations::scene::sides_of_box;
use crate::relations::scene::{Base, DrawnScene, Lobes, Material, Mesh, Object, Shape, luminance};
use std::collections::BTreeMap;
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// A scene in our own format and the same through another.
#[derive(Clone, Debug, PartialEq)]
pub struct Exported {
    /// In the pieces and the order in which the other format's reader leaves it, so
    /// that random numbers fall alike.
    pub arranged: DrawnScene,
    /// A scene file that includes the other format's file.
    pub files: Files,
}

/// Returns all that MGF can hold in an MGF file, in grey; `None` if that is nothing.
pub fn through_mgf(scene: &DrawnScene, stem: &str) -> Option<Exported> {
    let scene = &greyed(scene);
    let (inside, outside): (Vec<Object>, Vec<Object>) =
        scene.objects.iter().map(mgf_would_say).partition(mgf::can_say);
    if inside.is_empty() {
        return None;
    }
    let arranged = outside.iter().cloned().chain(in_order_of_mgf(&inside)).collect();
    let mut files = Files::empty(stem, None);
    let text = mgf::whole(&in_order_of_mgf(&inside));
    let whole = Entry::Whole(files.add("mgf", text.into_bytes()));
    let entries: Vec<Entry<'_>> = outside.iter().map(Entry::Object).chain([whole]).collect();
    files.text = ron::scene(scene, &entries, &mut files);
    Some(Exported { arranged: DrawnScene { objects: arranged, ..scene.clone() }, files })
}

/// Every colour as light as it was.
fn greyed(scene: &DrawnScene) -> DrawnScene {
    let grey = |colour: Vec3| Vec3::splat(luminance(colour));
    let lobes = |part: Lobes| Lobes {
        diffuse: grey(part.diffuse),
        specular: grey(part.specular),
        exponent: part.exponent.max(1.0),
    };
    let mut scene = scene.clone();
    for object in &mut scene.objects {
        object.emission = grey(object.emission);
        let base = &mut object.material.base;
        *base = match *base {
            Base::Lambert(colour) => Base::Lambert(grey(colour)),
            Base::Phong(part) => Base::Phong(lobes(part)),
            Base::MaxPhong(colour, exponent) => Base::MaxPhong(grey(colour), exponent),
            Base::Mirror(mirrored, diffuse) => Base::Mirror(grey(mirrored), grey(diffuse)),
            Base::Sheet(back, on) => Base::Sheet(lobes(back), lobes(on)),
            Base::Glass(index) => Base::Glass(index),
            Base::Pane(mirrored, through) => Base::Pane(grey(mirrored), grey(through)),
        };
    }
    scene
}

/// In MGF what is open and has two sides shines from both.
fn mgf_would_say(object: &Object) -> Object {
    let is_closed = matches!(object.shape, Shape::Sphere { .. });
    let sides = if object.is_light() && !is_closed { Sides::Front } else { object.sides };
    Object { sides, ..object.clone() }
}

/// Round shapes first, then a mesh for each material.
fn in_order_of_mgf(objects: &[Object]) -> Vec<Object> {
    let mut surfaces: Vec<(&Material, Vec3, Sides)> = Vec::new();
    let mut round = Vec::new();
    let mut flat: BTreeMap<(usize, bool), Object> = BTreeMap::new();
    for object in objects {
        let surface = (&object.material, object.emission, object.sides);
        let number = surfaces.iter().position(|known| *known == surface).unwrap_or(surfaces.len());
        if number == surfaces.len() {
            surfaces.push(surface);
        }
        let Some(mesh) = as_mesh(&object.shape) else {
            round.push(object.clone());
            continue;
        };
        let key = (number, mesh.normals.is_some());
        let whole = flat.entry(key).or_insert_with(|| {
            let normals = mesh.normals.is_some().then(Vec::new);
            object.with_shape(Shape::Mesh(Mesh { normals, ..Mesh::flat(Vec::new(), Vec::new()) }))
        });
        if let Shape::Mesh(sum) = &mut whole.shape {
            sum.join(&mesh);
        }
    }
    round.into_iter().chain(flat.into_values()).collect()
}

/// Returns a flat shape as triangles, without pictures.
fn as_mesh(shape: &Shape) -> Option<Mesh> {
    match shape {
        Shape::Triangle(corners) => Some(Mesh::flat(corners.to_vec(), vec![[0, 1, 2]])),
        &Shape::Quad([corner, u, v]) => {
            let corners = vec![corner, corner + u, corner + u + v, corner + v];
            Some(Mesh::flat(corners, vec![[0, 1, 2], [0, 2, 3]]))
        }
        Shape::Box(_) => {
            let mut mesh = Mesh::flat(Vec::new(), Vec::new());
            sides_of_box(shape).iter().filter_map(as_mesh).for_each(|side| mesh.join(&side));
            Some(mesh)
        }
        Shape::Mesh(mesh) => Some(Mesh { uvs: None, ..mesh.clone() }),
        Shape::Disk { .. } | Shape::Cone { .. } | Shape::Sphere { .. } => None,
    }
}

/// Returns all that 3DS can hold in 3DS files, each lamp in one of its own; `None` if that is
/// nothing.
pub fn through_three_ds(scene: &DrawnScene, stem: &str) -> Option<Exported> {
    let (mut outside, mut inside, mut lamps) = (Vec::new(), Vec::new(), Vec::new());
    for object in &scene.objects {
        let mesh = as_mesh(&object.shape).filter(|mesh| mesh.normals.is_none());
        let mesh = mesh.filter(|_| !object.material.has_maps());
        let flat = mesh.map(|mesh| object.with_shape(Shape::Mesh(mesh)));
        match flat {
            Some(lamp) if lamp.is_light() => lamps.push(lamp),
            Some(flat) if three_ds::can_say(&flat.material) => inside.push(flat),
            Some(_) | None => outside.push(object.clone()),
        }
    }
    if inside.is_empty() && lamps.is_empty() {
        return None;
    }
    let mut files = Files::empty(stem, None);
    let mut entries: Vec<Entry<'_>> = outside.iter().map(Entry::Object).collect();
    if !inside.is_empty() {
        entries.push(Entry::Whole(files.add("3ds", three_ds::whole(&inside))));
    }
    for lamp in &lamps {
        let brightest = lamp.emission.max_element();
        let file = files.add("3ds", three_ds::lamp(lamp, brightest));
        entries.push(Entry::Lamp(file, brightest, lamp));
    }
    let text = ron::scene(scene, &entries, &mut files);
    files.text = text;
    let objects = [outside, inside, lamps].concat();
    Some(Exported { arranged: DrawnScene { objects, ..scene.clone() }, files })
}
