//! Mitsuba's scene format, version 3, of what both programs have words for.

use super::Files;
use crate::relations::scene::{Base, Camera, DrawnScene, Light, Lobes, Material, Object, Shape};
use std::fmt::Write;
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// Sizes, from the least to the greatest, within which single precision and the offsets of
/// Mitsuba's rays, a part of the distance to the origin and at least of one, do no harm.
const SIZES: [f32; 2] = [0.02, 1e3];

/// The scene that is most like it of those that both programs read in the same way: without
/// pictures, normals of corners, lobes, cones of light and what else Mitsuba has not. `None` of one
/// with a sky, with surfaces that lie in one plane, with a light in a surface, and of sizes out of
/// the ordinary: there rounding decides, or the offsets of rays.
pub fn common(drawn: &DrawnScene) -> Option<DrawnScene> {
    let objects = drawn.objects.iter().map(common_object).collect();
    let lights = drawn.lights.iter().map(|light| Light { spot: None, ..*light }).collect();
    let scene = DrawnScene { objects, lights, ..drawn.clone() };
    let is_usual = scene.finest() > SIZES[0] && scene.reach() < SIZES[1];
    (is_usual && scene.sky.is_none() && scene.is_clear() && scene.glass_is_solid()).then_some(scene)
}

fn common_object(object: &Object) -> Object {
    let shape = common_shape(&object.shape, object.is_light());
    let base = if lights_itself(object) {
        Base::Lambert(Vec3::ZERO)
    } else {
        common_base(object.material.base, shape.is_solid() && !object.is_light())
    };
    Object { shape, material: Material::plain(base), ..object.clone() }
}

fn common_base(base: Base, may_be_glass: bool) -> Base {
    match base {
        Base::Lambert(colour) | Base::MaxPhong(colour, _) | Base::Mirror(_, colour)
            if colour != Vec3::ZERO =>
        {
            Base::Lambert(colour)
        }
        Base::Mirror(colour, _) => Base::Mirror(colour, Vec3::ZERO),
        Base::Glass(index) if may_be_glass => Base::Glass(index),
        Base::Phong(Lobes { diffuse, .. }) | Base::Sheet(Lobes { diffuse, .. }, _) => {
            Base::Lambert(diffuse)
        }
        Base::Lambert(_) | Base::MaxPhong(..) | Base::Glass(_) | Base::Pane(..) => {
            Base::Lambert(Vec3::ZERO)
        }
    }
}

/// True of a sphere that shines inward. Of points on it Mitsuba 3.9.1 samples its light as from
/// within, but weighs some as if it saw the sphere from outside, as they are rounded: its `path`
/// then finds too much, where `direct` with either technique alone is right
/// (`findings/mitsuba-sphere-within.sh`).
fn lights_itself(object: &Object) -> bool {
    object.is_light() && matches!(object.shape, Shape::Sphere { inward: true, .. })
}

/// The shape that both programs have. A tube that shines shines outward: Mitsuba 3.9.1 ends shadow
/// rays 9e-4 of their length before the light, so of one that shines inward light passes through
/// the wall (`findings/mitsuba-shadow-ends.sh`).
fn common_shape(shape: &Shape, is_light: bool) -> Shape {
    match shape {
        &Shape::Disk { centre, normal, radius, .. } => {
            Shape::Disk { centre, normal, inner: 0.0, radius }
        }
        &Shape::Cone { ends, radii: [radius, _], inward } => {
            Shape::Cone { ends, radii: [radius; 2], inward: inward && !is_light }
        }
        Shape::Mesh(mesh) => {
            let (positions, triangles) = (mesh.positions.clone(), mesh.triangles.clone());
            Shape::Mesh(crate::relations::scene::Mesh::flat(positions, triangles))
        }
        Shape::Triangle(_) | Shape::Quad(_) | Shape::Sphere { .. } | Shape::Box(_) => shape.clone(),
    }
}

impl Files {
    /// A scene in Mitsuba's format; of what [`common`] leaves out nothing is written.
    pub fn of_mitsuba(scene: &DrawnScene, stem: &str) -> Self {
        let mut files = Self::empty(stem, None);
        files.ending = "xml";
        // Roulette, which need not be the same, never begins.
        let depth = scene.max_depth.map_or(-1, i64::from);
        let mut text = format!(
            "<scene version=\"3.0.0\">\n<integrator type=\"path\">\n\
             <integer name=\"max_depth\" value=\"{depth}\"/>\n\
             <integer name=\"rr_depth\" value=\"100000\"/>\n</integrator>\n"
        );
        text += &camera(&scene.camera, scene.reach());
        for light in &scene.lights {
            let Vec3 { x, y, z } = light.position;
            let intensity = rgb("intensity", light.intensity);
            _ = writeln!(
                text,
                "<emitter type=\"point\">\n<point name=\"position\" x=\"{x}\" y=\"{y}\" z=\"{z}\"/>\n\
                 {intensity}</emitter>"
            );
        }
        for object in &scene.objects {
            text += &shape(&mut files, object);
        }
        files.text = text + "</scene>\n";
        files
    }
}

fn camera(camera: &Camera, reach: f32) -> String {
    let Camera { position, target, up, fov, pixels } = *camera;
    let point = |v: Vec3| format!("{}, {}, {}", v.x, v.y, v.z);
    let [position, target, up] = [position, target, up].map(point);
    let (near, far) = (1e-5 * reach, 10.0 * reach);
    format!(
        "<sensor type=\"perspective\">\n<float name=\"fov\" value=\"{fov}\"/>\n\
         <string name=\"fov_axis\" value=\"x\"/>\n<float name=\"near_clip\" value=\"{near}\"/>\n\
         <float name=\"far_clip\" value=\"{far}\"/>\n<transform name=\"to_world\">\n\
         <lookat origin=\"{position}\" target=\"{target}\" up=\"{up}\"/>\n</transform>\n\
         <film type=\"hdrfilm\">\n<integer name=\"width\" value=\"{pixels}\"/>\n\
         <integer name=\"height\" value=\"{pixels}\"/>\n<rfilter type=\"box\"/>\n</film>\n</sensor>\n"
    )
}

fn rgb(name: &str, colour: Vec3) -> String {
    let Vec3 { x, y, z } = colour;
    format!("<rgb name=\"{name}\" value=\"{x}, {y}, {z}\"/>\n")
}

fn shape(files: &mut Files, object: &Object) -> String {
    let (kind, fields) = form(files, &object.shape);
    let lamp = if object.is_light() {
        format!("<emitter type=\"area\">\n{}</emitter>\n", rgb("radiance", object.emission))
    } else {
        String::new()
    };
    format!("<shape type=\"{kind}\">\n{fields}{}{lamp}</shape>\n", bsdf(object))
}

fn bsdf(object: &Object) -> String {
    let plain = match object.material.base {
        Base::Lambert(colour) => {
            format!("<bsdf type=\"diffuse\">\n{}</bsdf>\n", rgb("reflectance", colour))
        }
        Base::Mirror(colour, _) => format!(
            "<bsdf type=\"conductor\">\n<string name=\"material\" value=\"none\"/>\n{}</bsdf>\n",
            rgb("specular_reflectance", colour)
        ),
        Base::Glass(index) => {
            return format!(
                "<bsdf type=\"dielectric\">\n<float name=\"int_ior\" value=\"{index}\"/>\n\
                 <float name=\"ext_ior\" value=\"1\"/>\n</bsdf>\n"
            );
        }
        // Not among what is common.
        Base::Phong(_) | Base::MaxPhong(..) | Base::Sheet(..) | Base::Pane(..) => String::new(),
    };
    match object.sides {
        Sides::Front => plain,
        Sides::Both => format!("<bsdf type=\"twosided\">\n{plain}</bsdf>\n"),
    }
}

/// The name of a shape, and its fields.
fn form(files: &mut Files, shape: &Shape) -> (&'static str, String) {
    match shape {
        &Shape::Quad([corner, u, v]) => {
            let (u, v) = (0.5 * u, 0.5 * v);
            ("rectangle", place([u, v, u.cross(v).normalize()], corner + u + v))
        }
        &Shape::Disk { centre, normal, radius, .. } => {
            let normal = normal.normalize();
            let u = normal.any_orthonormal_vector();
            ("disk", place([u * radius, normal.cross(u) * radius, normal], centre))
        }
        &Shape::Box([min, max]) => {
            let half = 0.5 * (max - min);
            ("cube", place([Vec3::X, Vec3::Y, Vec3::Z].map(|axis| axis * half), min + half))
        }
        &Shape::Sphere { centre, radius, inward } => (
            "sphere",
            format!(
                "{}<float name=\"radius\" value=\"{radius}\"/>\n{}",
                point("center", centre),
                turned(inward)
            ),
        ),
        &Shape::Cone { ends: [a, b], radii: [radius, _], inward } => (
            "cylinder",
            format!(
                "{}{}<float name=\"radius\" value=\"{radius}\"/>\n{}",
                point("p0", a),
                point("p1", b),
                turned(inward)
            ),
        ),
        Shape::Triangle(corners) => mesh(files, corners, &[[0, 1, 2]]),
        Shape::Mesh(m) => mesh(files, &m.positions, &m.triangles),
    }
}

fn point(name: &str, Vec3 { x, y, z }: Vec3) -> String {
    format!("<point name=\"{name}\" x=\"{x}\" y=\"{y}\" z=\"{z}\"/>\n")
}

fn turned(inward: bool) -> String {
    format!("<boolean name=\"flip_normals\" value=\"{inward}\"/>\n")
}

/// Columns of the matrix from a unit shape.
fn place([x, y, z]: [Vec3; 3], t: Vec3) -> String {
    let row = |i: usize| format!("{} {} {} {} ", x[i], y[i], z[i], t[i]);
    let rows = [0, 1, 2].map(row).concat();
    format!("<transform name=\"to_world\"><matrix value=\"{rows}0 0 0 1\"/></transform>\n")
}

/// A PLY file as text, with the normals of its faces.
fn mesh(files: &mut Files, positions: &[Vec3], triangles: &[[u32; 3]]) -> (&'static str, String) {
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n\
         property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        positions.len(),
        triangles.len()
    );
    for Vec3 { x, y, z } in positions {
        _ = writeln!(text, "{x} {y} {z}");
    }
    for [a, b, c] in triangles {
        _ = writeln!(text, "3 {a} {b} {c}");
    }
    let name = files.add("ply", text.into_bytes());
    let fields = format!(
        "<string name=\"filename\" value=\"{name}\"/>\n\
         <boolean name=\"face_normals\" value=\"true\"/>\n"
    );
    ("ply", fields)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spheres_that_shine_inward_reflect_nothing_and_others_stay() {
        let sphere = |inward, emission| Object {
            shape: Shape::Sphere { centre: Vec3::ZERO, radius: 2.0, inward },
            material: Material::grey(0.5),
            emission: Vec3::splat(emission),
            sides: Sides::Both,
        };
        let base = |inward, emission| common_object(&sphere(inward, emission)).material.base;
        let (grey, black) = (Base::Lambert(Vec3::splat(0.5)), Base::Lambert(Vec3::ZERO));
        assert_eq!(base(true, 1.0), black);
        assert_eq!(base(true, 0.0), grey);
        assert_eq!(base(false, 1.0), grey);
    }

    #[test]
    fn tubes_that_shine_do_so_outward() {
        let ends = [Vec3::ZERO, Vec3::X];
        let tube = |inward| Shape::Cone { ends, radii: [0.02, 0.01], inward };
        let plain = |inward| Shape::Cone { ends, radii: [0.02; 2], inward };
        assert_eq!(common_shape(&tube(true), true), plain(false));
        assert_eq!(common_shape(&tube(true), false), plain(true));
        assert_eq!(common_shape(&tube(false), true), plain(false));
    }
}
