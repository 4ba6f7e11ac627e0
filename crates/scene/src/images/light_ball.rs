//! A lamp as a mirror shows it: a ball around it.

use crate::{Light, PointLight};
use traylib_geometry::{Facing, Form, Outline};
use traylib_math::Vec3;

/// A lamp as far as its images depend on it: a ball around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LightBall {
    /// The middle of a ball that holds it.
    pub(super) centre: Vec3,
    /// The radius of that ball; zero of a point.
    pub(super) radius: f32,
    /// The front normal of a flat lamp, which shines to that side alone.
    pub(super) normal: Option<Vec3>,
    /// Luminance of its power in W.
    pub(super) power: f32,
}

impl LightBall {
    /// Describes any lamp but one that is seen from within, as the sky is, which fills every
    /// mirror.
    pub(super) fn of(light: &Light) -> Option<Self> {
        let power = light.power().luminance();
        let ([centre, reach], normal) = match light {
            Light::Area { primitive, .. } => around(&primitive.form())?,
            Light::Point(PointLight { position, .. }) => ([*position, Vec3::ZERO], None),
            Light::Sky(_) => return None,
        };
        Some(Self { centre, radius: reach.length(), normal, power })
    }

    /// Tells whether it has no extent.
    pub(super) fn is_point(&self) -> bool {
        self.radius == 0.0
    }

    /// Tells whether light of it may fall on a ball.
    pub(super) fn may_light(&self, centre: Vec3, radius: f32) -> bool {
        self.normal.is_none_or(|normal| normal.dot(centre - self.centre) > -radius)
    }

    /// Tells whether light may leave it in this direction, of any length.
    pub(super) fn shines_to(&self, direction: Vec3) -> bool {
        self.normal.is_none_or(|normal| normal.dot(direction) > 0.0)
    }
}

/// The centre of a ball around a shape and one of its radii, and the normal of what is flat.
fn around(form: &Form) -> Option<([Vec3; 2], Option<Vec3>)> {
    match form {
        Form::Flat { normal, outline } => Some((around_outline(outline), Some(*normal))),
        Form::Ball(sphere) if sphere.facing() == Facing::Inward => None,
        Form::Ball(sphere) => Some(([sphere.centre(), sphere.radius() * Vec3::X], None)),
        Form::Bent(bounds) => Some(([bounds.centre(), 0.5 * bounds.extent()], None)),
    }
}

fn around_outline(outline: &Outline) -> [Vec3; 2] {
    match *outline {
        Outline::Triangle(corners) => {
            let centre = corners.iter().map(|&corner| corner / 3.0).sum::<Vec3>();
            let spokes = corners.map(|corner| corner - centre);
            [centre, longest(&spokes)]
        }
        Outline::Parallelogram { corner, edges: [u, v] } => {
            let spokes = [0.5 * (u + v), 0.5 * (u - v)];
            [corner + spokes[0], longest(&spokes)]
        }
        Outline::Circle { centre, radius } => [centre, radius * Vec3::X],
    }
}

fn longest(spokes: &[Vec3]) -> Vec3 {
    let longer = |one: Vec3, other: &Vec3| {
        if other.length_squared() > one.length_squared() { *other } else { one }
    };
    spokes.iter().fold(Vec3::ZERO, longer)
}
