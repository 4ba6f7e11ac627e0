//! The Materials and Geometry Format.

use crate::relations::form::cut::sides_of_box;
use crate::relations::scene::{Mesh, Shape};
use std::fmt::Write;
use traylib_math::Vec3;

/// One shape with both sides that neither shines nor reflects: what it is made of
/// stands in the scene file.
pub(super) fn single(shape: &Shape) -> String {
    let mut text = Text::default();
    text.shape(shape);
    format!("m only =\n\tsides 2\n{}", text.0)
}

/// Lines of a file under way.
#[derive(Default)]
pub(super) struct Text(pub(super) String);

impl Text {
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
