//! Cuts surfaces into other pieces: boxes as quads, quads as triangles, meshes
//! as triangles; lamps in two; objects in another order.

use crate::relations::scene::{DrawnScene, Mesh, Object, Shape, sides_of_box};

/// A function that cuts an object into pieces; `None` if it does not.
type Pieces = fn(&Object) -> Option<Vec<Object>>;

/// Every object in the pieces that `cut` makes of it; `None` if nothing is cut.
fn everywhere(scene: &DrawnScene, cut: Pieces) -> Option<DrawnScene> {
    let pieces: Vec<Option<Vec<Object>>> = scene.objects.iter().map(cut).collect();
    if pieces.iter().all(Option::is_none) {
        return None;
    }
    let whole = scene.objects.iter();
    let objects = pieces
        .into_iter()
        .zip(whole)
        .flat_map(|(pieces, whole)| pieces.unwrap_or_else(|| vec![whole.clone()]));
    Some(DrawnScene { objects: objects.collect(), ..scene.clone() })
}

/// The six quads of each box, as the importer makes them.
pub fn boxes_as_quads(scene: &DrawnScene) -> Option<DrawnScene> {
    everywhere(scene, |object| {
        matches!(object.shape, Shape::Box(_)).then(|| {
            sides_of_box(&object.shape).into_iter().map(|side| object.with_shape(side)).collect()
        })
    })
}

/// Two triangles for each quad without pictures.
pub fn quads_as_triangles(scene: &DrawnScene) -> Option<DrawnScene> {
    everywhere(scene, |object| {
        let Shape::Quad([corner, u, v]) = object.shape else { return None };
        let [a, b, c, d] = [corner, corner + u, corner + u + v, corner + v];
        let halves = [[a, b, c], [a, c, d]].map(|half| object.with_shape(Shape::Triangle(half)));
        (!object.material.has_maps()).then(|| halves.into())
    })
}

/// Each triangle of a mesh for itself, where it has neither normals nor pictures.
pub fn meshes_as_triangles(scene: &DrawnScene) -> Option<DrawnScene> {
    everywhere(scene, |object| {
        let Shape::Mesh(mesh) = &object.shape else { return None };
        let is_plain = mesh.normals.is_none() && !object.material.has_maps();
        let triangle = |corners| object.with_shape(Shape::Triangle(corners));
        is_plain.then(|| mesh.corners().map(triangle).collect())
    })
}

/// A mesh of one triangle for each triangle.
pub fn triangles_as_meshes(scene: &DrawnScene) -> Option<DrawnScene> {
    everywhere(scene, |object| {
        let Shape::Triangle(corners) = object.shape else { return None };
        let mesh = Mesh::flat(corners.into(), vec![[0, 1, 2]]);
        Some(vec![object.with_shape(Shape::Mesh(mesh))])
    })
}

/// Each lamp that is a quad, a disk or a triangle without pictures in two pieces.
pub fn lamps_in_two(scene: &DrawnScene) -> Option<DrawnScene> {
    everywhere(scene, |object| {
        if !object.is_light() || object.material.has_maps() {
            return None;
        }
        let halves = match object.shape {
            Shape::Quad([corner, u, v]) => {
                let half = u * 0.5;
                [Shape::Quad([corner, half, v]), Shape::Quad([corner + half, u - half, v])]
            }
            Shape::Triangle([a, b, c]) => {
                let middle = (b + c) * 0.5;
                [Shape::Triangle([a, b, middle]), Shape::Triangle([a, middle, c])]
            }
            Shape::Disk { centre, normal, inner, radius } => {
                let between = 0.5 * (inner + radius);
                [(inner, between), (between, radius)].map(|(inner, radius)| Shape::Disk {
                    centre,
                    normal,
                    inner,
                    radius,
                })
            }
            Shape::Cone { ends: [a, b], radii: [ra, rb], inward } => {
                let (middle, between) = ((a + b) * 0.5, 0.5 * (ra + rb));
                [([a, middle], [ra, between]), ([middle, b], [between, rb])]
                    .map(|(ends, radii)| Shape::Cone { ends, radii, inward })
            }
            Shape::Sphere { .. } | Shape::Box(_) | Shape::Mesh(_) => return None,
        };
        Some(halves.map(|half| object.with_shape(half)).into())
    })
}

/// The last object first.
pub fn backwards(scene: &DrawnScene) -> Option<DrawnScene> {
    let objects: Vec<Object> = scene.objects.iter().rev().cloned().collect();
    let lights = scene.lights.iter().rev().copied().collect();
    (objects.len() > 1).then(|| DrawnScene { objects, lights, ..scene.clone() })
}
