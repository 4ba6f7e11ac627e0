//! Chance.

use traylib_math::{Sampler, Vec3};

/// A stream of random numbers with the questions that are asked of it.
#[derive(Clone, Debug)]
pub struct Dice(Sampler);

impl Dice {
    /// The stream of this scene in this run.
    pub fn new(seed: u64, number: u64) -> Self {
        Self(Sampler::new(seed, [Sampler::TESTS, 1, number]))
    }

    /// A stream for this use of that scene.
    pub fn for_use(seed: u64, number: u64, purpose: u64) -> Self {
        Self(Sampler::new(seed, [Sampler::TESTS, 2 + purpose, number]))
    }

    /// Uniform on [0, 1).
    pub fn even(&mut self) -> f32 {
        self.0.next_1d()
    }

    /// Uniform on `low..high`.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.even()
    }

    /// One of 0, 1 … `end` − 1.
    pub fn below(&mut self, end: u32) -> u32 {
        ((self.even() * end as f32) as u32).min(end - 1)
    }

    /// Tells whether something of this probability happens.
    pub fn chance(&mut self, probability: f32) -> bool {
        self.even() < probability
    }

    /// One of these.
    pub fn pick<T: Clone>(&mut self, from: &[T]) -> T {
        from[self.below(from.len() as u32) as usize].clone()
    }

    /// In another order.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            let other = self.below(last as u32 + 1) as usize;
            items.swap(last, other);
        }
    }

    /// A unit vector, uniform on the sphere.
    pub fn direction(&mut self) -> Vec3 {
        let (z, phi) = (self.between(-1.0, 1.0), self.between(0.0, std::f32::consts::TAU));
        let across = (1.0 - z * z).max(0.0).sqrt();
        Vec3::new(across * phi.cos(), across * phi.sin(), z)
    }

    /// A direction along an axis, either way.
    pub fn axis(&mut self) -> Vec3 {
        self.pick(&[Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z])
    }
}
