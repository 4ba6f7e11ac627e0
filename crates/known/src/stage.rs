//! Building scenes from constants, without a word too many.
//!
//! All parameters are constants of tests, so what the library refuses here is a
//! mistake in a test.

use std::fmt::Debug;
use traylib_geometry::{Cone, Disk, Facing, Mesh, Primitive, Quad, Sides, Sphere, Triangle};
use traylib_materials::{
    Dielectric, Lambert, Material, MaxPhong, Mirror, Phong, Sheet, SurfaceModel,
};
use traylib_math::{Grid, Rgb, Vec3};
use traylib_scene::{Camera, CameraSettings, Object, ObjectShape, Scene, SceneBuilder, SpotCone};

/// A scene under construction, grey throughout.
#[derive(Debug)]
pub struct Stage(SceneBuilder);

impl Stage {
    /// Returns a stage with nothing but a camera.
    pub fn new(camera: Camera) -> Self {
        Self(SceneBuilder::new(camera))
    }

    /// Adds a surface with both sides.
    #[must_use]
    pub fn surface(self, primitive: Primitive, material: impl Into<Material>) -> Self {
        self.object(ObjectShape::Primitive(primitive), Sides::Both, material, 0.0)
    }

    /// Adds triangles with both sides.
    #[must_use]
    pub fn mesh(self, mesh: Mesh, model: SurfaceModel) -> Self {
        self.object(ObjectShape::Mesh(mesh), Sides::Both, model, 0.0)
    }

    /// Adds a lamp of this radiance that is not there from behind.
    #[must_use]
    pub fn light(self, primitive: Primitive, radiance: f32, model: SurfaceModel) -> Self {
        self.object(ObjectShape::Primitive(primitive), Sides::Front, model, radiance)
    }

    /// Adds a lamp of this radiance that is there from behind too, and does not
    /// shine that way.
    #[must_use]
    pub fn solid_light(self, primitive: Primitive, radiance: f32, model: SurfaceModel) -> Self {
        self.object(ObjectShape::Primitive(primitive), Sides::Both, model, radiance)
    }

    /// Adds a point light of this intensity.
    #[must_use]
    pub fn point(mut self, position: Vec3, intensity: f32) -> Self {
        sound(self.0.add_point_light(position, Rgb::splat(intensity)));
        self
    }

    /// Adds a point light that shines into a cone.
    #[must_use]
    pub fn spot_light(mut self, position: Vec3, intensity: f32, cone: SpotCone) -> Self {
        sound(self.0.add_spot_light(position, Rgb::splat(intensity), cone));
        self
    }

    /// Gives it a sky, turned by so many degrees.
    #[must_use]
    pub fn sky(mut self, radiance: Grid<Rgb>, turn_degrees: f32) -> Self {
        sound(self.0.set_sky(radiance, turn_degrees));
        self
    }

    /// The scene.
    pub fn build(self) -> Scene {
        sound(self.0.build())
    }

    fn object(
        mut self,
        shape: ObjectShape,
        sides: Sides,
        material: impl Into<Material>,
        radiance: f32,
    ) -> Self {
        let material = self.0.add_material(material);
        let emission = Rgb::splat(radiance);
        sound(self.0.add_object(Object { shape, sides, material, emission }));
        self
    }
}

/// A camera with a square film of `size` × `size` pixels.
pub fn camera(position: Vec3, target: Vec3, fov_degrees: f32, size: u32) -> Camera {
    camera_of_size(position, target, fov_degrees, [size, size])
}

/// A camera with a film of `[width, height]` pixels; upright is along y unless
/// that is along the view.
pub fn camera_of_size(
    position: Vec3,
    target: Vec3,
    fov_degrees: f32,
    [width, height]: [u32; 2],
) -> Camera {
    let along_y = (target - position).cross(Vec3::Y).length_squared() == 0.0;
    let up = if along_y { Vec3::X } else { Vec3::Y };
    sound(Camera::new(CameraSettings { position, target, up, fov_degrees, width, height }))
}

/// A camera that sees a single spot: 10⁻³ degrees and 64 × 64 pixels, so that a
/// pass has 4096 independent samples of one radiance. Terms of first order
/// cancel over the film; those of second order are (10⁻⁵)² for a diffuse
/// surface and 5·10⁻⁵ for a lobe of exponent 10⁶.
pub fn spot(position: Vec3, target: Vec3) -> Camera {
    camera(position, target, 1e-3, 64)
}

/// The plane z = 0, out to 64 m, with its front up.
pub fn floor() -> Primitive {
    rectangle(Vec3::new(-64.0, -64.0, 0.0), 128.0 * Vec3::X, 128.0 * Vec3::Y)
}

/// A parallelogram with its front along `edge_u` × `edge_v`.
pub fn rectangle(corner: Vec3, edge_u: Vec3, edge_v: Vec3) -> Primitive {
    Primitive::Quad(sound(Quad::new(corner, edge_u, edge_v)))
}

/// A disk parallel to the floor, facing it.
pub fn disk_facing_down(centre: Vec3, radius: f32) -> Primitive {
    disk(centre, Vec3::NEG_Z, radius)
}

/// A disk parallel to the floor, its front up.
pub fn disk_facing_up(centre: Vec3, radius: f32) -> Primitive {
    disk(centre, Vec3::Z, radius)
}

/// A disk with its front along `normal`.
pub fn disk(centre: Vec3, normal: Vec3, radius: f32) -> Primitive {
    Primitive::Disk(sound(Disk::new(centre, normal, radius)))
}

/// A triangle; from the front its corners go counter-clockwise.
pub fn triangle([a, b, c]: [Vec3; 3]) -> Primitive {
    Primitive::Triangle(sound(Triangle::new(a, b, c)))
}

/// A ball.
pub fn ball(centre: Vec3, radius: f32) -> Primitive {
    Primitive::Sphere(sound(Sphere::new(centre, radius, Facing::Outward)))
}

/// An open tube that narrows or widens, its front outside.
pub fn tube(ends: [Vec3; 2], radii: [f32; 2]) -> Primitive {
    Primitive::Cone(sound(Cone::new(ends, radii, Facing::Outward)))
}

/// A hollow ball, its front inside.
pub fn hollow_ball(centre: Vec3, radius: f32) -> Primitive {
    Primitive::Sphere(sound(Sphere::new(centre, radius, Facing::Inward)))
}

/// The six sides of the cube |x|, |y|, |z| ≤ `half`, their fronts inside.
pub fn hollow_cube(half: f32) -> [Primitive; 6] {
    hollow_cube_at(Vec3::ZERO, half)
}

/// Makes the cube about another centre.
pub fn hollow_cube_at(centre: Vec3, half: f32) -> [Primitive; 6] {
    let side = |normal: Vec3, u: Vec3| {
        // u × v is along the normal.
        let v = normal.cross(u);
        rectangle(centre - half * (normal + u + v), 2.0 * half * u, 2.0 * half * v)
    };
    [
        side(Vec3::X, Vec3::Y),
        side(Vec3::NEG_X, Vec3::Y),
        side(Vec3::Y, Vec3::Z),
        side(Vec3::NEG_Y, Vec3::Z),
        side(Vec3::Z, Vec3::X),
        side(Vec3::NEG_Z, Vec3::X),
    ]
}

/// Ideal diffuse.
pub fn lambert(reflectance: f32) -> SurfaceModel {
    SurfaceModel::Lambert(sound(Lambert::new(Rgb::splat(reflectance))))
}

/// Absorbs everything.
pub fn black() -> SurfaceModel {
    lambert(0.0)
}

/// Modified Phong.
pub fn phong(diffuse: f32, specular: f32, exponent: f32) -> SurfaceModel {
    let parts = [diffuse, specular].map(Rgb::splat);
    SurfaceModel::Phong(sound(Phong::new(parts[0], parts[1], exponent)))
}

/// Metal.
pub fn max_phong(specular: f32, exponent: f32) -> SurfaceModel {
    SurfaceModel::MaxPhong(sound(MaxPhong::new(Rgb::splat(specular), exponent)))
}

/// Mirror with a diffuse part.
pub fn mirror(reflectance: f32, diffuse: f32) -> SurfaceModel {
    SurfaceModel::Mirror(sound(Mirror::new(Rgb::splat(reflectance), Rgb::splat(diffuse))))
}

/// Smooth glass.
pub fn glass(index: f32) -> SurfaceModel {
    SurfaceModel::Dielectric(sound(Dielectric::new(index)))
}

/// A thin sheet that scatters light evenly to either side.
pub fn paper(reflectance: f32, transmittance: f32) -> SurfaceModel {
    let part = |share| sound(Phong::new(Rgb::splat(share), Rgb::BLACK, 1.0));
    SurfaceModel::Sheet(sound(Sheet::new(part(reflectance), part(transmittance))))
}

/// A thin clear pane that mirrors.
pub fn pane(reflectance: f32, through: f32) -> Material {
    Material { through: Rgb::splat(through), ..mirror(reflectance, 0.0).into() }
}

/// Returns the value that the library made of constants that it should not refuse.
pub(crate) fn sound<T, E: Debug>(result: Result<T, E>) -> T {
    result.expect("parameters of a test scene")
}
