//! The input: what mouse and keyboard have done since one looked last.

use crate::motion::Motion;
use traylib_integrators::Method;
use traylib_math::{Vec2, Vec3};

/// The actions of mouse and keyboard, and their time.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Input {
    /// Seconds since the last.
    pub(crate) seconds: f32,
    /// Columns and rows of the window.
    pub(crate) size: (u32, u32),
    /// Keys that were pressed, in their order.
    pub(crate) pressed: Vec<Press>,
    /// Held keys to the right, up and forward, each -1, 0 or 1.
    pub(crate) walk: Vec3,
    /// Held keys to the right and up, each -1, 0 or 1.
    pub(crate) look: Vec2,
    /// True if steps are to be long.
    pub(crate) fast: bool,
    /// The distance that the mouse was dragged with its left button, in pixels to the right and
    /// down.
    pub(crate) turn: Vec2,
    /// The distance that the mouse was dragged with another button.
    pub(crate) shift: Vec2,
    /// Notches of the wheel, away from the hand.
    pub(crate) wheel: f32,
}

/// A key that does something at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Press {
    /// Ends the program.
    End,
    /// Back to the camera of the scene.
    Home,
    /// Prints the camera.
    Print,
    /// Writes the picture.
    Write,
    /// Renders by the method of this number, counted from zero in [`Method::ALL`].
    Method(usize),
    /// Renders by the method that a plan chooses.
    Auto,
}

/// Distances to the target that a held key walks in a second.
const WALK: f32 = 0.5;

/// Radians that a held key looks around in a second.
const LOOK: f32 = 1.2;

/// Times as far with Shift.
const FAST: f32 = 4.0;

/// Radians for a window's width that the mouse was drawn.
const TURN: f32 = 4.0;

/// Logarithms of the distance for a notch of the wheel.
const NOTCH: f32 = 0.1;

impl Input {
    /// The steps of the camera.
    pub(crate) fn motions(&self) -> impl Iterator<Item = Motion> + use<> {
        let stride = if self.fast { FAST } else { 1.0 };
        let width = self.size.0.max(1) as f32;
        // Rows of the window are counted downward. What was taken hold of follows the hand.
        let hand = |drawn: Vec2| Vec2::new(-drawn.x, drawn.y) / width;
        let motions = [
            (self.turn != Vec2::ZERO).then(|| Motion::Orbit(TURN * hand(self.turn))),
            (self.shift != Vec2::ZERO).then(|| Motion::Pan(hand(self.shift))),
            (self.wheel != 0.0).then_some(Motion::Approach(stride * NOTCH * self.wheel)),
            (self.walk != Vec3::ZERO)
                .then(|| Motion::Walk(stride * WALK * self.seconds * self.walk)),
            (self.look != Vec2::ZERO)
                .then(|| Motion::Look(stride * LOOK * self.seconds * self.look)),
        ];
        motions.into_iter().flatten()
    }
}

impl Press {
    /// The method that it stands for.
    pub(crate) fn method(self) -> Option<Method> {
        match self {
            Self::Method(number) => Method::ALL.get(number).copied(),
            Self::Auto => Some(Method::AUTO),
            Self::End | Self::Home | Self::Print | Self::Write => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motions(input: &Input) -> Vec<Motion> {
        input.motions().collect()
    }

    #[test]
    fn nothing_moves_by_itself() {
        let input = Input { seconds: 1.0, size: (100, 100), ..Input::default() };
        assert_eq!(motions(&input), []);
    }

    #[test]
    fn the_scene_follows_the_hand() {
        let size = (100, 50);
        // To the right and down: the eye goes to the left and up.
        let drawn = Vec2::new(10.0, 5.0);
        let turn = Input { size, turn: drawn, ..Input::default() };
        assert_eq!(motions(&turn), [Motion::Orbit(Vec2::new(-0.4, 0.2))]);
        let shift = Input { size, shift: drawn, ..Input::default() };
        assert_eq!(motions(&shift), [Motion::Pan(Vec2::new(-0.1, 0.05))]);
    }

    #[test]
    fn held_keys_count_by_time() {
        let walk = Input { seconds: 0.5, walk: Vec3::Z, fast: true, ..Input::default() };
        assert_eq!(motions(&walk), [Motion::Walk(Vec3::new(0.0, 0.0, 1.0))]);
        let look = Input { seconds: 0.5, look: Vec2::X, ..Input::default() };
        assert_eq!(motions(&look), [Motion::Look(Vec2::new(0.6, 0.0))]);
    }

    #[test]
    fn digits_stand_for_methods_in_their_order() {
        let names = (0..5).filter_map(|n| Press::Method(n).method()).map(Method::name);
        assert_eq!(
            names.collect::<Vec<_>>(),
            ["trace", "puremc", "directlight", "bdpt", "particle"]
        );
        assert_eq!(Press::Method(5).method(), None);
        assert_eq!(Press::Auto.method().map(|method| method.to_string()).unwrap(), "bdpt --auto");
    }
}
