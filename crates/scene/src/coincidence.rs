//! Lamps that lie in one place with other surfaces.
//!
//! Rounding would decide which of two surfaces in one place is seen, and each program in its own
//! way. So lamps are lifted off their fronts when the scene is built, by a few times what rounding
//! can move a point: a lamp flush with its ceiling shines. Of lamps in one place that face the same
//! way the first is lifted highest and hides the rest. Of other surfaces in one place the one added
//! first is seen.

use crate::Light;
use crate::surfaces::Surfaces;
use traylib_geometry::{Bvh, Error, Ray, ShapeList, Shapes, Sides};
use traylib_math::Vec2;

/// Points along each side of a lamp at which something else is looked for.
const POINTS: u8 = 3;

/// The least cosine between the normals of surfaces in one place.
const PARALLEL: f32 = 1.0 - 1e-4;

/// Counts of lamps that lay in one place with something else, which the builder of the scene
/// told apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coincidences {
    /// Lamps in one place with other surfaces or lamps, which were lifted off their
    /// fronts.
    pub lifted_lights: usize,
    /// Point lights within a surface, which shine on both its sides.
    pub points_in_surfaces: usize,
    /// Surfaces in which the camera lay, which was lifted off them.
    pub surfaces_at_camera: usize,
}

/// The tree with every lamp lifted that lies in one place with another surface, and how
/// many there were, with those at the limits of numbers, which stay where they are.
///
/// # Errors
/// Those of the shapes.
pub(crate) fn lift_lights(
    tree: Bvh<Shapes<Surfaces>>,
    lights: &mut [Light],
) -> Result<(Bvh<Shapes<Surfaces>>, usize), Error> {
    let count = tree.shapes().count() as u32;
    let lamps = (0..count).filter(|&i| tree.shapes().get(i).light().is_some());
    let heights: Vec<(u32, f32)> =
        lamps.filter_map(|lamp| Some((lamp, height(&tree, lamp)?))).collect();
    if heights.is_empty() {
        return Ok((tree, 0));
    }
    let mut surfaces = tree.into_shapes();
    for &(index, height) in &heights {
        let surface = surfaces.get(index);
        // So far out that there is no number above its own: it stays.
        let Some(Ok(lifted)) = surface.primitive().map(|shape| shape.lifted(height)) else {
            continue;
        };
        let light = surface.light().map(|id| &mut lights[id.0 as usize]);
        if let Some(Light::Area { primitive, .. }) = light {
            *primitive = lifted;
        }
        surfaces.replace(index, lifted);
    }
    Ok((Bvh::of_shapes(surfaces)?, heights.len()))
}

/// Returns the height to lift a lamp by, in units of
/// [`Primitive::lifted`](traylib_geometry::Primitive::lifted): one, and one more for each later
/// lamp in its place that faces the same way. `None` if it lies alone.
fn height(tree: &Bvh<Shapes<Surfaces>>, lamp: u32) -> Option<f32> {
    let others = in_one_place(tree, lamp)?;
    let hides = |&&(other, same_way): &&(u32, bool)| {
        same_way && other > lamp && tree.shapes().get(other).light().is_some()
    };
    let hidden = others.iter().filter(hides).count();
    (!others.is_empty()).then_some(1.0 + hidden as f32)
}

/// The other shapes in one place with this one, and whether they face the same way.
/// Two that face opposite ways and have their fronts alone are never met together.
fn in_one_place(tree: &Bvh<Shapes<Surfaces>>, index: u32) -> Option<Vec<(u32, bool)>> {
    let surface = tree.shapes().get(index);
    let primitive = surface.primitive()?;
    let share = |i: u8| (f32::from(i) + 0.5) / f32::from(POINTS);
    let mut found = Vec::new();
    for i in 0..POINTS * POINTS {
        let site = primitive.sample_area(Vec2::new(share(i / POINTS), share(i % POINTS)));
        let forth = site.through();
        // One-sided surfaces are met one way.
        let back = Ray { origin: forth.at(forth.t_max), direction: -forth.direction, ..forth };
        for ray in [forth, back] {
            for hit in tree.all_hits(&ray) {
                let other = tree.shapes().get(hit.primitive);
                let cosine = other.site(&ray, &hit)?.normal.dot(site.normal);
                let is_parallel = cosine.abs() > PARALLEL;
                let met_together =
                    cosine > 0.0 || [surface.sides(), other.sides()].contains(&Sides::Both);
                if hit.primitive != index && is_parallel && met_together {
                    found.push((hit.primitive, cosine > 0.0));
                }
            }
        }
    }
    found.sort_unstable();
    found.dedup();
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LightId;
    use crate::{Camera, CameraSettings, Object, ObjectShape, Scene, SceneBuilder};
    use std::sync::Arc;
    use traylib_geometry::{Facing, Primitive, Quad, Sphere, SurfaceSite};
    use traylib_materials::{Lambert, SurfaceModel};
    use traylib_math::{Rgb, Sampler, Vec3, warp};

    /// Surfaces by how brightly they shine, in this order.
    fn scene(shapes: &[(Primitive, Sides, f32)], point: Option<Vec3>) -> Scene {
        let camera = Camera::new(CameraSettings {
            position: Vec3::new(0.0, 1.0, 0.0),
            target: Vec3::ZERO,
            up: Vec3::Z,
            fov_degrees: 40.0,
            width: 8,
            height: 8,
        });
        seen_by(camera.unwrap(), shapes, point)
    }

    fn seen_by(camera: Camera, shapes: &[(Primitive, Sides, f32)], point: Option<Vec3>) -> Scene {
        let mut builder = SceneBuilder::new(camera);
        let grey = Lambert::new(Rgb::splat(0.5)).unwrap();
        let material = builder.add_material(SurfaceModel::Lambert(grey));
        for &(primitive, sides, radiance) in shapes {
            let (shape, emission) = (ObjectShape::Primitive(primitive), Rgb::splat(radiance));
            builder.add_object(Object { shape, sides, material, emission }).unwrap();
        }
        if let Some(position) = point {
            builder.add_point_light(position, Rgb::WHITE).unwrap();
        }
        builder.build().unwrap()
    }

    /// A square that faces down, about a point of the plane y = 2 turned by `slope`.
    fn square(half: f32, slope: f32) -> Primitive {
        let u = Vec3::new(2.0 * half, 2.0 * half * slope, 0.0);
        let corner = Vec3::new(-half, 2.0 - half * slope, -half);
        Primitive::Quad(Quad::new(corner, u, Vec3::new(0.0, 0.0, 2.0 * half)).unwrap())
    }

    /// Returns the light that is seen from below at random points of the square.
    fn seen(scene: &Scene, slope: f32) -> Vec<f32> {
        let mut sampler = Sampler::numbered(3, 0);
        let mut draw = || {
            let [x, z] = (sampler.next_2d() * 1.8 - 0.9).to_array();
            let from = Vec3::new(sampler.next_1d(), 0.0, sampler.next_1d());
            let ray = Ray::new(from, Vec3::new(x, 2.0 + slope * x, z) - from);
            scene.emitted(&scene.intersect(&ray).unwrap()).g
        };
        (0..2000).map(|_| draw()).collect()
    }

    #[test]
    fn a_lamp_flush_with_its_ceiling_shines() {
        for slope in [0.0, 0.3, -0.77] {
            let ceiling = (square(3.0, slope), Sides::Both, 0.0);
            let lamp = (square(1.0, slope), Sides::Both, 1.0);
            for order in [[ceiling, lamp], [lamp, ceiling]] {
                let scene = scene(&order, None);
                assert_eq!(scene.coincidences().lifted_lights, 1);
                assert!(seen(&scene, slope).iter().all(|&radiance| radiance == 1.0), "{slope}");
            }
        }
    }

    #[test]
    fn of_lamps_in_one_place_the_first_hides_the_rest() {
        for slope in [0.0, 0.3] {
            let lamps = [5.0, 7.0, 9.0].map(|radiance| (square(1.0, slope), Sides::Both, radiance));
            let scene = scene(&lamps, None);
            assert_eq!(scene.coincidences().lifted_lights, 3);
            assert!(seen(&scene, slope).iter().all(|&radiance| radiance == 5.0), "{slope}");
        }
    }

    /// The halves of a lamp with two fronts are never met together.
    #[test]
    fn lamps_back_to_back_stay_where_they_are() {
        let up = Quad::new(Vec3::new(-1.0, 2.0, -1.0), 2.0 * Vec3::Z, 2.0 * Vec3::X).unwrap();
        let up = (Primitive::Quad(up), Sides::Front, 2.0);
        let scene = scene(&[(square(1.0, 0.0), Sides::Front, 1.0), up], None);
        assert_eq!(scene.coincidences(), Coincidences::default());
        assert!(seen(&scene, 0.0).iter().all(|&radiance| radiance == 1.0));
    }

    /// A hollow ball so far out that lifted it would have no room within.
    #[test]
    fn lamps_that_cannot_be_lifted_stay_where_they_are() {
        let ball = Sphere::new(Vec3::new(1e5, 0.0, 0.0), 0.1, Facing::Inward).unwrap();
        let ball = |radiance| (Primitive::Sphere(ball), Sides::Both, radiance);
        let scene = scene(&[ball(0.0), ball(1.0)], None);
        assert_eq!(scene.coincidences().lifted_lights, 1);
    }

    /// All rays into the surface meet it, none that leaves it.
    #[test]
    fn a_camera_in_a_surface_sees_from_one_side_of_it() {
        let mut sampler = Sampler::numbered(5, 0);
        for slope in [0.0, 0.3, -0.77] {
            for side in [1.0, -1.0] {
                let floor = square(3.0, slope);
                let site = floor.sample_area(sampler.next_2d());
                let (along, _) = site.normal.any_orthonormal_pair();
                let camera = Camera::new(CameraSettings {
                    position: site.position,
                    target: site.position + along + site.normal * (0.2 * side),
                    up: site.normal,
                    fov_degrees: 90.0,
                    width: 32,
                    height: 32,
                });
                let scene = seen_by(camera.unwrap(), &[(floor, Sides::Both, 1.0)], None);
                assert_eq!(scene.coincidences().surfaces_at_camera, 1);
                let mut met = 0;
                for _ in 0..1000 {
                    let ray = scene.camera().ray(sampler.next_2d() * 32.0);
                    let into = ray.direction.dot(site.normal) * side;
                    let hit = scene.intersect(&ray).is_some();
                    assert!(into.abs() < 1e-6 || hit == (into < 0.0), "{slope}, {side}, {into}");
                    met += usize::from(hit);
                }
                assert!((100..900).contains(&met), "{met}");
            }
        }
    }

    /// Nothing is built again for another camera, and it sees what it would have seen
    /// from the start, also from within a surface.
    #[test]
    fn another_camera_shares_all_but_itself() {
        let floor = (square(3.0, 0.3), Sides::Both, 1.0);
        let camera = |position| {
            let target = Vec3::new(0.3, 2.0, 0.2);
            let (up, fov_degrees) = (Vec3::Z, 60.0);
            let settings =
                CameraSettings { position, target, up, fov_degrees, width: 16, height: 16 };
            Camera::new(settings).unwrap()
        };
        let first = seen_by(camera(Vec3::new(0.0, 5.0, 0.0)), &[floor], None);
        for position in [Vec3::new(1.0, -3.0, 0.5), Vec3::new(-1.0, 1.7, 0.0)] {
            let moved = first.seen_by(camera(position));
            assert!(Arc::ptr_eq(&moved.stage, &first.stage));
            let anew = seen_by(camera(position), &[floor], None);
            assert_eq!(moved.camera(), anew.camera());
            assert_eq!(moved.coincidences(), anew.coincidences());
        }
    }

    /// All points outside see all or nothing of a point light on a ball.
    #[test]
    fn a_point_light_in_a_surface_is_seen_from_all_around() {
        let centre = Vec3::new(0.3, 2.5, 0.1);
        let mut sampler = Sampler::numbered(4, 0);
        for _ in 0..200 {
            let normal = warp::uniform_sphere(sampler.next_2d());
            let ball = Sphere::new(centre, 0.7, Facing::Outward).unwrap();
            let light = centre + 0.7 * normal;
            let scene = scene(&[(Primitive::Sphere(ball), Sides::Both, 0.0)], Some(light));
            assert_eq!(scene.coincidences().points_in_surfaces, 1);
            let (x0, _) = scene.sample_light(LightId(0), Vec3::ZERO, Vec2::ZERO);
            let floor = square(3.0, 0.0).sample_area(sampler.next_2d());
            for _ in 0..50 {
                let away = warp::cosine_hemisphere(normal, sampler.next_2d());
                let position = light + away * 3.0 * (0.01 + sampler.next_1d());
                let site = SurfaceSite { position, ..floor };
                assert_eq!(scene.transmittance(&x0.segment_from(&site)), Rgb::WHITE, "{away}");
            }
        }
    }
}
