//! Takes a scene elsewhere: moved, turned, scaled, mirrored.

use crate::relations::scene::{Camera, DrawnScene, Light, Mesh, Object, Shape, Spot};
use traylib_math::Vec3;
use traylib_math::glam::{DMat3, DVec3};

/// Points are turned, then scaled, then moved. In double precision, rounded once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Orthogonal; mirrors if its determinant is negative.
    pub turn: DMat3,
    /// Positive.
    pub scale: f64,
    /// In metres.
    pub shift: DVec3,
}

impl Motion {
    /// Leaves everything where it is.
    pub const NONE: Self = Self { turn: DMat3::IDENTITY, scale: 1.0, shift: DVec3::ZERO };

    /// Shifts by this many metres.
    pub fn shift(shift: DVec3) -> Self {
        Self { shift, ..Self::NONE }
    }

    /// Scales by this factor about the origin.
    pub fn scale(scale: f64) -> Self {
        Self { scale, ..Self::NONE }
    }

    /// About the origin by an orthogonal matrix.
    pub fn turn(turn: DMat3) -> Self {
        Self { turn, ..Self::NONE }
    }

    fn mirrors(&self) -> bool {
        self.turn.determinant() < 0.0
    }

    fn point(&self, point: Vec3) -> Vec3 {
        (self.turn * point.as_dvec3() * self.scale + self.shift).as_vec3()
    }

    /// An edge keeps its length but for the scale.
    fn edge(&self, edge: Vec3) -> Vec3 {
        (self.turn * edge.as_dvec3() * self.scale).as_vec3()
    }

    fn direction(&self, direction: Vec3) -> Vec3 {
        (self.turn * direction.as_dvec3()).as_vec3()
    }

    fn length(&self, length: f32) -> f32 {
        (f64::from(length) * self.scale) as f32
    }

    /// The whole scene. Point lights shine with the square of the scale, so that
    /// every picture stays; where it mirrors, pictures turn left for right. The sky stays as it is:
    /// one that is not the same all around must not be turned.
    pub fn scene(&self, scene: &DrawnScene) -> DrawnScene {
        let Camera { position, target, up, fov, pixels } = scene.camera;
        let camera = Camera {
            position: self.point(position),
            target: self.point(target),
            up: self.direction(up),
            fov,
            pixels,
        };
        let objects = scene.objects.iter().map(|object| self.object(object)).collect();
        let lights = scene.lights.iter().map(|light| self.light(light)).collect();
        DrawnScene { camera, objects, lights, sky: scene.sky.clone(), max_depth: scene.max_depth }
    }

    fn light(&self, light: &Light) -> Light {
        let square = (self.scale * self.scale) as f32;
        let spot = light.spot.map(|spot| Spot { target: self.point(spot.target), ..spot });
        Light { position: self.point(light.position), intensity: light.intensity * square, spot }
    }

    fn object(&self, object: &Object) -> Object {
        object.with_shape(self.shape(&object.shape))
    }

    /// A shape elsewhere. Fronts stay fronts.
    pub fn shape(&self, shape: &Shape) -> Shape {
        match shape {
            Shape::Triangle(corners) => {
                let [a, b, c] = corners.map(|corner| self.point(corner));
                Shape::Triangle(if self.mirrors() { [a, c, b] } else { [a, b, c] })
            }
            &Shape::Quad([corner, u, v]) => {
                let (corner, u, v) = (self.point(corner), self.edge(u), self.edge(v));
                Shape::Quad(if self.mirrors() { [corner, v, u] } else { [corner, u, v] })
            }
            &Shape::Disk { centre, normal, inner, radius } => Shape::Disk {
                centre: self.point(centre),
                normal: self.direction(normal),
                inner: self.length(inner),
                radius: self.length(radius),
            },
            &Shape::Cone { ends, radii, inward } => Shape::Cone {
                ends: ends.map(|end| self.point(end)),
                radii: radii.map(|radius| self.length(radius)),
                inward,
            },
            &Shape::Sphere { centre, radius, inward } => {
                Shape::Sphere { centre: self.point(centre), radius: self.length(radius), inward }
            }
            Shape::Box(corners) => {
                let [a, b] = corners.map(|corner| self.point(corner));
                Shape::Box([a.min(b), a.max(b)])
            }
            Shape::Mesh(mesh) => Shape::Mesh(self.mesh(mesh)),
        }
    }

    fn mesh(&self, mesh: &Mesh) -> Mesh {
        let turned = |&[a, b, c]: &[u32; 3]| if self.mirrors() { [a, c, b] } else { [a, b, c] };
        Mesh {
            positions: mesh.positions.iter().map(|&position| self.point(position)).collect(),
            triangles: mesh.triangles.iter().map(turned).collect(),
            normals: mesh
                .normals
                .as_ref()
                .map(|normals| normals.iter().map(|&normal| self.direction(normal)).collect()),
            uvs: mesh.uvs.clone(),
        }
    }
}
