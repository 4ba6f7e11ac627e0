//! Mirrors: a ball or a flat piece that reflects perfectly or with a narrow lobe.

use super::ImageCone;
use super::ball::BallMirror;
use super::flat::FlatMirror;
use super::light_ball::LightBall;
use super::reflection::Reflection;
use traylib_geometry::{Facing, Form, Primitive, Sides};
use traylib_math::Vec3;

/// A lobe of exponent n is taken to be this over √n wide, in radians: 99.8 % of cosⁿ.
const LOBE_WIDTH: f32 = 3.5;

/// A surface that shows images of lamps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mirror {
    form: MirrorForm,
    /// The angle by which a point is blurred, in radians; zero by an ideal mirror.
    blur: f32,
    /// Area in m².
    pub(super) area: f32,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum MirrorForm {
    Ball(BallMirror),
    Flat(FlatMirror),
}

impl Mirror {
    /// A shape with these sides whose lobe has this exponent, infinite for an ideal
    /// mirror. `None` of what shows no image that could be aimed at: the inside of a ball
    /// and what bends one way only.
    pub(super) fn new(primitive: &Primitive, sides: Sides, exponent: f32) -> Option<Self> {
        let form = match primitive.form() {
            Form::Flat { normal, outline } => {
                MirrorForm::Flat(FlatMirror::new(normal, outline, sides)?)
            }
            Form::Ball(sphere) => {
                let from_outside = sides == Sides::Both || sphere.facing() == Facing::Outward;
                MirrorForm::Ball(from_outside.then(|| BallMirror::new(&sphere))?)
            }
            Form::Bent(_) => return None,
        };
        Some(Self { form, blur: LOBE_WIDTH / exponent.sqrt(), area: primitive.area() })
    }

    /// About which part of what a lamp here sends arrives at the mirror.
    pub(super) fn part_of_sky(&self, from: Vec3) -> f32 {
        let distance_squared = (from - self.middle()).length_squared();
        self.area / (self.area + distance_squared)
    }

    /// A point in its middle, or that of the ball.
    pub(super) fn middle(&self) -> Vec3 {
        match &self.form {
            MirrorForm::Ball(ball) => ball.centre(),
            MirrorForm::Flat(flat) => flat.middle(),
        }
    }

    /// Tells whether it is flat and some point may see any of another mirror in it.
    pub(super) fn may_show_mirror(&self, other: &Self) -> bool {
        match (&self.form, &other.form) {
            (MirrorForm::Ball(_), MirrorForm::Ball(_) | MirrorForm::Flat(_)) => false,
            (MirrorForm::Flat(flat), MirrorForm::Ball(ball)) => {
                flat.faces_ball(ball.centre(), ball.radius())
            }
            (MirrorForm::Flat(flat), MirrorForm::Flat(other)) => {
                flat.faces(other) && other.faces(flat)
            }
        }
    }

    /// Tells whether both are flat and have a corner in common.
    pub(super) fn touches(&self, other: &Self) -> bool {
        match (&self.form, &other.form) {
            (MirrorForm::Flat(flat), MirrorForm::Flat(other)) => flat.touches(other),
            (MirrorForm::Ball(_), MirrorForm::Ball(_) | MirrorForm::Flat(_))
            | (MirrorForm::Flat(_), MirrorForm::Ball(_)) => false,
        }
    }

    /// Returns the cone in which a point sees the image of a lamp in another mirror in this one, if
    /// it does and this is flat.
    pub(super) fn image_of_image(
        &self,
        other: &Self,
        lamp: &LightBall,
        from: Vec3,
    ) -> Option<ImageCone> {
        let MirrorForm::Flat(flat) = &self.form else { return None };
        // As from behind this mirror.
        let image = other.image(lamp, flat.behind(from)?)?.widened(self.blur);
        let (cone, seen_at) = flat.turned(image, from)?;
        other.reflects_to(seen_at, lamp).then_some(cone)
    }

    /// Tells whether a point is on the side of it on which the lamp is.
    fn reflects_to(&self, at: Vec3, lamp: &LightBall) -> bool {
        match &self.form {
            MirrorForm::Ball(_) => true,
            MirrorForm::Flat(flat) => flat.are_on_one_side(at, lamp.centre),
        }
    }

    /// Tells whether some point may see this lamp in it.
    pub(super) fn may_show(&self, lamp: &LightBall) -> bool {
        // An ideal mirror shows a point as a point, which no direction meets.
        let has_extent = self.blur > 0.0 || !lamp.is_point();
        has_extent
            && match &self.form {
                MirrorForm::Ball(ball) => ball.may_show(lamp),
                MirrorForm::Flat(flat) => flat.may_show(lamp),
            }
    }

    /// Tells whether a surface with this normal may see any of it; what is flat does not say no.
    #[inline]
    pub(super) fn rises_above(&self, from: Vec3, normal: Vec3) -> bool {
        match &self.form {
            MirrorForm::Ball(ball) => ball.rises_above(from, normal),
            MirrorForm::Flat(_) => true,
        }
    }

    /// Returns the cone in which a point sees the image of a lamp, if it does.
    pub(super) fn image(&self, lamp: &LightBall, from: Vec3) -> Option<ImageCone> {
        match &self.form {
            MirrorForm::Ball(ball) => ball.image(lamp, self.blur, from),
            MirrorForm::Flat(flat) => flat.image(lamp, self.blur, from),
        }
    }

    /// Tells whether it shows a point as a point.
    pub(super) fn is_ideal(&self) -> bool {
        self.blur == 0.0
    }

    /// Returns how light of a point arrives by way of another mirror and then of this one, if this
    /// is flat.
    pub(super) fn reflection_of_reflection(
        &self,
        other: &Self,
        from: Vec3,
        light: Vec3,
    ) -> Option<Reflection> {
        let MirrorForm::Flat(flat) = &self.form else { return None };
        let behind = other.reflection(flat.behind(from)?, light)?;
        Some(Reflection { toward: flat.mirrored(behind.toward), ..behind })
    }

    /// Returns how light of a point arrives at another by way of it, wherever it ends.
    pub(crate) fn reflection(&self, from: Vec3, light: Vec3) -> Option<Reflection> {
        match &self.form {
            MirrorForm::Ball(ball) => ball.reflection(from, light),
            MirrorForm::Flat(flat) => flat.reflection(from, light),
        }
    }
}
