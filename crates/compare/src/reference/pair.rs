//! The reference of a scene: two methods, each seen to agree with the other.

use super::Reference;
use super::agreement::agreement;
use super::method_reference::{MethodReference, Numbers, Order};
use crate::mirrors::mirrors;
use crate::picture::Picture;
use crate::results::ReferenceResults;
use crate::store::{Store, StoreError, key_of};
use std::fmt;
use traylib_integrators::{Control, Method, ThreadError};
use traylib_math::Grid;
use traylib_scene::Scene;
use traylib_statistics::{error_floor, inverse_variance_weight, own_rel_mse};

/// Sees all that any method here does.
const FIRST: Method = Method::BDPT;
/// Another method that sees as much, by paths from the camera alone.
const SECOND: Method = Method::COMBINED;
/// Blind to mirrors, but where paths from the camera do not converge the only
/// other one.
const LAST_RESORT: Method = Method::PARTICLE;

/// The second method is given up if its error costs so many times the first's.
const HOPELESS: f64 = 16.0;

/// These are seeds of no run: those count up from small numbers.
const SEEDS: [u64; 2] = [u64::MAX, u64::MAX - 1];

/// The settings by which a reference is made.
#[derive(Clone, Copy, Debug)]
pub struct Making<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// A hash of the scene and of the program that renders it.
    pub scene_key: u64,
    /// Seconds for each of the two methods.
    pub seconds: f64,
    /// Threads; 0 for one a processor.
    pub threads: usize,
    /// Raised when the user wants to stop.
    pub stop: &'a Control,
    /// The store of finished references of single methods.
    pub store: &'a Store,
}

/// The reason why there is no reference.
#[derive(Debug)]
#[non_exhaustive]
pub enum MakeError {
    /// The system refuses threads.
    Threads(ThreadError),
    /// The rendering cannot be kept.
    Store(StoreError),
}

impl fmt::Display for MakeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Threads(error) => error.fmt(f),
            Self::Store(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for MakeError {}

impl From<ThreadError> for MakeError {
    fn from(error: ThreadError) -> Self {
        Self::Threads(error)
    }
}

impl From<StoreError> for MakeError {
    fn from(error: StoreError) -> Self {
        Self::Store(error)
    }
}

/// Finds the reference of a scene in the store; `None` if it is not whole there.
pub fn find(making: &Making<'_>) -> Option<Reference> {
    let seen = mirrors(making.scene);
    let none = seen.map(|_| false);
    let second = making.chosen_second()?;
    let masked = if second == LAST_RESORT { &seen } else { &none };
    let a = making.found(making.render_key(FIRST, masked, 0))?;
    let b = making.found(making.render_key(second, masked, 1))?;
    Some(join(&a, &b, masked))
}

/// Makes the reference of a scene, or takes it from the store; `None` if it was
/// stopped. `tell` is called with what is being done.
///
/// # Errors
/// The system refuses threads, or a file cannot be written.
pub fn make(making: &Making<'_>, tell: &dyn Fn(Method)) -> Result<Option<Reference>, MakeError> {
    let seen = mirrors(making.scene);
    let none = seen.map(|_| false);
    let Some(second) = making.choose_second(&seen)? else { return Ok(None) };
    let masked = if second == LAST_RESORT { &seen } else { &none };
    tell(FIRST);
    let Some(a) = making.by_method(FIRST, masked, 0)? else { return Ok(None) };
    tell(second);
    let Some(b) = making.by_method(second, masked, 1)? else { return Ok(None) };
    Ok(Some(join(&a, &b, masked)))
}

impl Making<'_> {
    /// From the store, or rendered.
    fn by_method(
        &self,
        method: Method,
        masked: &Grid<bool>,
        index: usize,
    ) -> Result<Option<MethodReference>, MakeError> {
        let key = self.render_key(method, masked, index);
        if let Some(reference) = self.found(key) {
            return Ok(Some(reference));
        }
        let reference = self.order(masked, self.seconds, SEEDS[index]).render(method)?;
        // As it would come from the store, so that it makes no difference whether it does:
        // runs are found again by the reference that they were held against.
        let reference = reference.map(MethodReference::like_stored);
        if let Some(reference) = &reference {
            let pictures = [("mean", &reference.picture), ("variance", &reference.variance)];
            self.store.keep(key, &reference.numbers, &pictures)?;
        }
        Ok(reference)
    }

    fn render_key(&self, method: Method, masked: &Grid<bool>, index: usize) -> u64 {
        key_of(&(self.scene_key, method.to_string(), masked.values(), SEEDS[index]))
    }

    fn found(&self, key: u64) -> Option<MethodReference> {
        let numbers: Numbers = self.store.numbers(key)?;
        let picture = self.store.picture(key, "mean")?;
        let variance = self.store.picture(key, "variance")?;
        (numbers.seconds >= self.seconds).then_some(MethodReference { picture, variance, numbers })
    }

    fn order<'a>(&'a self, masked: &'a Grid<bool>, seconds: f64, seed: u64) -> Order<'a> {
        let Self { scene, threads, stop, .. } = *self;
        Order { scene, masked, seconds, seed, threads, stop }
    }

    fn second_key(&self) -> u64 {
        key_of(&(self.scene_key, "second method"))
    }

    /// Returns the method that [`Self::choose_second`] has found before, if any.
    fn chosen_second(&self) -> Option<Method> {
        let index: usize = self.store.numbers(self.second_key())?;
        [SECOND, LAST_RESORT].get(index).copied()
    }

    /// Chooses the method by which the first is checked: known from last time, or found by short
    /// renders of all three, compared where no mirror is seen.
    fn choose_second(&self, mirrors: &Grid<bool>) -> Result<Option<Method>, MakeError> {
        if let Some(second) = self.chosen_second() {
            return Ok(Some(second));
        }
        let mut costs = Vec::new();
        let mut scale = None;
        for method in [FIRST, SECOND, LAST_RESORT] {
            let order = self.order(mirrors, 0.04 * self.seconds, SEEDS[0] - 2);
            let Some(reference) = order.render(method)? else { return Ok(None) };
            let picture = &*scale.get_or_insert_with(|| reference.picture.clone());
            costs.push(
                relative_variance(picture, &reference.variance, mirrors)
                    * reference.numbers.seconds,
            );
        }
        let hopeless = costs[1] > HOPELESS * costs[0] && costs[2] < costs[1];
        self.store.keep(self.second_key(), &usize::from(hopeless), &[])?;
        Ok(Some(if hopeless { LAST_RESORT } else { SECOND }))
    }
}

/// Computes the mean of variance/(r² + ε) where nothing is masked.
fn relative_variance(picture: &Picture, variance: &Picture, masked: &Grid<bool>) -> f64 {
    let epsilon = error_floor(picture.values());
    let seen = |values: &Picture| -> Vec<[f64; 3]> {
        let pixels = values.values().iter().zip(masked.values());
        pixels.filter(|(_, masked)| !**masked).map(|(value, _)| *value).collect()
    };
    let (picture, variance) = (seen(picture), seen(variance));
    if picture.is_empty() { 0.0 } else { own_rel_mse(&picture, &variance, epsilon) }
}

/// The mean of both, by what each is worth; where masked, the first alone. If they
/// differ, the first alone everywhere: it finds rare light more often, and the
/// variance of one that has missed it looks small.
fn join(a: &MethodReference, b: &MethodReference, masked: &Grid<bool>) -> Reference {
    let hidden = masked.values().iter().filter(|masked| **masked).count();
    let masked_share = hidden as f64 / masked.values().len() as f64;
    let agreement = agreement(&a.numbers, &b.numbers, masked_share);
    let share = if agreement.refused > 0 { 1.0 } else { share_of_first(a, b, masked) };
    let shares: Vec<f64> =
        masked.values().iter().map(|masked| if *masked { 1.0 } else { share }).collect();
    let results = ReferenceResults {
        origin: origin(&a.numbers, &b.numbers, share, masked_share),
        own_error: 0.0,
        seconds: a.numbers.seconds + b.numbers.seconds,
        agreement: Some(agreement),
        doubted_by: None,
    };
    let picture = mix(&a.picture, &b.picture, &shares, |share| share);
    let variance = mix(&a.variance, &b.variance, &shares, |share| share * share);
    Reference::new(picture, variance, results)
}

/// Weighs both in inverse proportion to their noise.
fn share_of_first(a: &MethodReference, b: &MethodReference, masked: &Grid<bool>) -> f64 {
    let [noise_a, noise_b] =
        [a, b].map(|reference| relative_variance(&a.picture, &reference.variance, masked));
    inverse_variance_weight(noise_a, noise_b)
}

fn mix(a: &Picture, b: &Picture, shares: &[f64], weight: impl Fn(f64) -> f64) -> Picture {
    let pixel = |((a, b), share): ((&[f64; 3], &[f64; 3]), &f64)| {
        let (of_a, of_b) = (weight(*share), weight(1.0 - share));
        std::array::from_fn(|band| of_a * a[band] + of_b * b[band])
    };
    let values = a.values().iter().zip(b.values()).zip(shares).map(pixel).collect();
    Grid::from_values(a.width(), a.height(), values).expect("as many as there were")
}

fn origin(a: &Numbers, b: &Numbers, share: f64, masked: f64) -> String {
    let part =
        |n: &Numbers, share: f64| format!("{:.0} % {} ({} spp)", 100.0 * share, n.method, n.passes);
    if share == 1.0 {
        let (first, passes, second) = (&a.method, a.passes, &b.method);
        return format!("{first} ({passes} spp) alone, since {second} differs from it");
    }
    let alone = format!("; where mirrors are in view, {} alone", a.method);
    let mirrors = if masked > 0.0 { alone.as_str() } else { "" };
    format!("a mean: {}, {}{mirrors}", part(a, share), part(b, 1.0 - share))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn by_method(method: &str, value: f64, variance: f64) -> MethodReference {
        let tiles = vec![Some((value, variance)); 3];
        MethodReference {
            picture: Grid::filled(2, 1, [value; 3]),
            variance: Grid::filled(2, 1, [variance; 3]),
            numbers: Numbers { method: method.into(), passes: 10, seconds: 1.0, tiles },
        }
    }

    #[test]
    fn the_better_reference_counts_for_more_and_alone_where_the_other_is_blind() {
        let (good, poor) = (by_method("bdpt", 1.0, 0.3), by_method("particle", 2.0, 0.9));
        let mut masked = Grid::filled(2, 1, false);
        masked.values_mut()[1] = true;
        let joined = join(&good, &poor, &masked);
        assert!((joined.picture.get(0, 0)[0] - 1.25).abs() < 1e-12);
        assert_eq!(joined.picture.get(1, 0)[0], 1.0);
        let expected = 0.75 * 0.75 * 0.3 + 0.25 * 0.25 * 0.9;
        assert!((joined.variance.get(0, 0)[1] - expected).abs() < 1e-12);
        assert_eq!(joined.results.agreement.unwrap().masked, 0.5);
        assert!(joined.results.origin.contains("75 % bdpt"), "{}", joined.results.origin);
    }

    #[test]
    fn a_reference_that_differs_has_no_part_in_it() {
        let (right, wrong) =
            (by_method("bdpt", 1.0, 1e-6), by_method("directlight --combine", 1.5, 1e-6));
        let joined = join(&right, &wrong, &Grid::filled(2, 1, false));
        assert_eq!(joined.picture.get(0, 0)[0], 1.0);
        assert_eq!(joined.results.agreement.unwrap().refused, 2);
        assert!(joined.results.origin.contains("bdpt (10 spp) alone"));
    }

    #[test]
    fn methods_without_noise_share_evenly() {
        let joined =
            join(&by_method("a", 1.0, 0.0), &by_method("b", 1.0, 0.0), &Grid::filled(2, 1, false));
        assert_eq!(joined.picture.get(0, 0)[0], 1.0);
        assert_eq!(joined.results.own_error, 0.0);
    }
}
