//! The Materials and Geometry Format.

use crate::relations::scene::sides_of_box;
use crate::relations::scene::{Base, Lobes, Mesh, Object, Shape};
use std::f64::consts::PI;
use std::fmt::Write;
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// Lumens a watt of Radiance.
const LUMENS_PER_WATT: f64 = 179.0;

/// One shape with both sides that neither shines nor reflects: what it is made of
/// stands in the scene file.
pub(super) fn single(shape: &Shape) -> String {
    let mut text = Text::default();
    text.shape(shape);
    format!("m only =\n\tsides 2\n{}", text.0)
}

/// Tells whether MGF has words for it: grey, and no pictures.
pub(super) fn can_say(object: &Object) -> bool {
    let base = &object.material.base;
    let is_glass = matches!(base, Base::Glass(_));
    let scatters_on = !matches!(base, Base::Sheet(_, on) if on.diffuse == Vec3::ZERO && on.specular == Vec3::ZERO);
    let known = !matches!(base, Base::MaxPhong(..)) && scatters_on;
    // Glass has both sides there, and does not shine.
    let as_glass_must = !is_glass || object.sides == Sides::Both && !object.is_light();
    !object.material.has_maps() && known && as_glass_must
}

/// These objects, each with a material of its own.
pub(super) fn whole(objects: &[Object]) -> String {
    let mut text = Text::default();
    for (number, object) in objects.iter().enumerate() {
        text.material(number, object);
        text.shape(&object.shape);
    }
    text.0
}

/// The roughness whose lobe has this exponent.
fn roughness(exponent: f32) -> f64 {
    (0.5 / f64::from(exponent)).sqrt()
}

/// Lines of a file under way.
#[derive(Default)]
pub(super) struct Text(pub(super) String);

impl Text {
    /// The material of an object, and makes it the current one.
    fn material(&mut self, number: usize, object: &Object) {
        let is_glass = matches!(object.material.base, Base::Glass(_));
        let sides = if object.sides == Sides::Front || is_glass { 1 } else { 2 };
        self.line(&format!("m m{number} =\n\tsides {sides}\n\tc"));
        // All are grey.
        let part = |colour: Vec3| colour.x;
        match object.material.base {
            Base::Lambert(colour) => self.line(&format!("\trd {}", part(colour))),
            Base::Phong(lobes) => self.lobes(["rd", "rs"], &lobes),
            Base::Mirror(mirrored, diffuse) => {
                self.line(&format!("\trd {}\n\trs {} 0", part(diffuse), part(mirrored)));
            }
            Base::Sheet(back, on) => {
                self.lobes(["rd", "rs"], &back);
                self.lobes(["td", "ts"], &on);
            }
            Base::Glass(index) => self.line(&format!("\tts 1 0\n\tir {index} 0")),
            Base::Pane(mirrored, through) => {
                self.line(&format!("\trs {} 0\n\tts {} 0", part(mirrored), part(through)));
            }
            // Not among what can be said.
            Base::MaxPhong(..) => {}
        }
        if object.is_light() {
            let exitance = f64::from(part(object.emission)) * PI * LUMENS_PER_WATT;
            self.line(&format!("\ted {exitance}"));
        }
    }

    fn lobes(&mut self, [diffuse, specular]: [&str; 2], lobes: &Lobes) {
        let rough = roughness(lobes.exponent);
        self.line(&format!("\t{diffuse} {}", lobes.diffuse.x));
        self.line(&format!("\t{specular} {} {rough}", lobes.specular.x));
    }

    /// A shape of the current material.
    pub(super) fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Triangle(corners) => self.face(corners),
            &Shape::Quad([corner, u, v]) => {
                self.face(&[corner, corner + u, corner + u + v, corner + v]);
            }
            &Shape::Disk { centre, normal, inner, radius } => {
                self.vertex("a", centre, Some(normal));
                self.line(&format!("ring a {inner} {radius}"));
            }
            &Shape::Cone { ends, radii: [a, b], inward } => {
                self.vertex("a", ends[0], None);
                self.vertex("b", ends[1], None);
                let sign = if inward { "-" } else { "" };
                if a == b {
                    self.line(&format!("cyl a {sign}{a} b"));
                } else {
                    self.line(&format!("cone a {sign}{a} b {sign}{b}"));
                }
            }
            &Shape::Sphere { centre, radius, inward } => {
                self.vertex("a", centre, None);
                self.line(&format!("sph a {}{radius}", if inward { "-" } else { "" }));
            }
            Shape::Box(_) => {
                for side in sides_of_box(shape) {
                    self.shape(&side);
                }
            }
            Shape::Mesh(mesh) => self.mesh(mesh),
        }
    }

    fn face(&mut self, corners: &[Vec3]) {
        let mut face = String::from("f");
        for (number, &corner) in corners.iter().enumerate() {
            self.vertex(&format!("v{number}"), corner, None);
            let _ = write!(face, " v{number}");
        }
        self.line(&face);
    }

    fn mesh(&mut self, mesh: &Mesh) {
        for (number, &position) in mesh.positions.iter().enumerate() {
            let normal = mesh.normals.as_ref().map(|normals| normals[number]);
            self.vertex(&format!("v{number}"), position, normal);
        }
        for [a, b, c] in &mesh.triangles {
            self.line(&format!("f v{a} v{b} v{c}"));
        }
    }

    fn vertex(&mut self, name: &str, Vec3 { x, y, z }: Vec3, normal: Option<Vec3>) {
        self.line(&format!("v {name} =\n\tp {x} {y} {z}"));
        if let Some(Vec3 { x, y, z }) = normal {
            self.line(&format!("\tn {x} {y} {z}"));
        }
    }

    pub(super) fn line(&mut self, line: &str) {
        self.0 += line;
        self.0.push('\n');
    }
}
