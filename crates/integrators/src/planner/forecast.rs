//! The noise of a method that was not rendered by, from paths that others found.
//!
//! Where technique t finds a path with the density n_t·p_t and its share by the heuristic with
//! exponent b is w_t, the estimator's second moment is ∫ f²·S with
//! S = Σ_t (n_t·p_t)^(2b−1)/(Σ_t (n_t·p_t)^b)², and its variance that less Σ_t E_t²/n_t, where
//! E_t = ∫ f·w_t. Both integrals are means over the pilot's paths, each of which counts for
//! one over the sum of the densities of all techniques. (Veach 1997, section 9.2.)

use super::bands::{bands, grey, product};
use super::found::Found;
use super::pilot::{LONGEST, Pilot};
use crate::FoundPath;
use crate::{Method, MethodOption, MethodSetting, Techniques};
use traylib_math::Heuristic;

/// The expected variance of a method, with the shares of its techniques.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Forecast {
    /// Variance of one sample a pixel, relative as relMSE is; infinite if it cannot find what
    /// was found.
    pub(super) variance: f64,
    /// The part of it that samples of more than [`RARE`] times the light around add above it.
    pub(super) rare: f64,
    /// The shares of its techniques in light and in second moments.
    pub(super) shares: [Share; Kind::ALL.len()],
}

/// Parts of wholes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Share {
    /// The part of the picture's light.
    pub(super) light: f64,
    /// The part of the squares of what samples add, relative to the light around.
    pub(super) squares: f64,
}

/// Techniques that are told of together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// s = 0: walks from the camera hit a lamp.
    Hits,
    /// s = 1: lamps are aimed at.
    LightSamples,
    /// s and t from 2 on: two walks are connected.
    Connections,
    /// t = 1: walks from lamps are joined to the camera.
    Splats,
    /// Point lights are joined by way of mirrors with what sees them there.
    MirrorJoints,
}

impl Kind {
    /// All, in the order in which they are listed.
    pub const ALL: [Self; 5] =
        [Self::Hits, Self::LightSamples, Self::Connections, Self::Splats, Self::MirrorJoints];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hits => "hits",
            Self::LightSamples => "light samples",
            Self::Connections => "connections",
            Self::Splats => "splats",
            Self::MirrorJoints => "joined by mirrors",
        }
    }

    /// Returns the kind of technique s for a path.
    fn of(path: &FoundPath, s: usize) -> Self {
        match s {
            _ if s == path.edges() && s > 1 => Self::Splats,
            _ if path.mirror_joint == Some(s) => Self::MirrorJoints,
            0 => Self::Hits,
            1 => Self::LightSamples,
            _ => Self::Connections,
        }
    }
}

/// Samples of more than so many times the light around are rare where they matter: a trial
/// meets none or one of them, and tells nothing of how many there are.
pub(super) const RARE: f64 = 8.0;

/// Light that may be missing for rounding alone, as a part of all.
const NEGLIGIBLE: f64 = 1e-5;

/// Forecasts a method from the paths of the pilot.
pub(super) fn forecast(pilot: &Pilot, method: Method) -> Forecast {
    let use_of = Use::by(method);
    let mut sums = [Share::default(); Kind::ALL.len()];
    let mut means = Means::of(pilot);
    let (mut all, mut lost, mut rare) = (0.0, 0.0, 0.0);
    let longest = method.limits().and_then(|limits| limits.max_depth);
    let is_wanted = |found: &&Found| longest.is_none_or(|most| found.path.edges() as u32 <= most);
    for Found { path, probe, pass } in pilot.found.iter().filter(is_wanted) {
        let value = bands(path.value);
        let balance = 1.0 / path.ratios.iter().sum::<f64>();
        all += balance * grey(path.value);
        // How often each technique of the method finds it, raised, and their sum.
        let raised = |s: usize| use_of.heuristic.raise(use_of.count(path, s) * path.ratios[s]);
        let sum: f64 = (0..path.ratios.len()).map(raised).sum();
        if sum <= 0.0 {
            lost += balance * grey(path.value);
            continue;
        }
        // Found by camera paths alone, for the means of the techniques from the camera.
        let from_camera = path.found_from_camera();
        let square = pilot.tiles.weight(path.pixel) * product(value, value);
        for s in 0..path.ratios.len() {
            let count = use_of.count(path, s);
            if count * path.ratios[s] <= 0.0 {
                continue;
            }
            let share = raised(s) / sum;
            // (n·p)^(2b−1)/(Σ (n·p)^b)², as the share squared over n·p.
            let moment = square * balance * share * share / (count * path.ratios[s]);
            // What the technique would have added, had it found the path.
            let size = square.sqrt() * share / (count * path.ratios[s]);
            rare += moment * (1.0 - (RARE / size).powi(2)).max(0.0);
            let kind = Kind::of(path, s);
            let own = &mut sums[kind as usize];
            own.light += balance * grey(path.value) * share;
            own.squares += moment;
            if !path.is_splat && kind != Kind::Splats {
                means.add(*probe, *pass, (s, path.edges()), value, share / from_camera);
            }
        }
    }
    let squares: f64 = sums.iter().map(|share| share.squares).sum();
    let moment = squares / pilot.samples();
    let variance = if lost > NEGLIGIBLE * all {
        f64::INFINITY
    } else {
        // What noise of few samples makes of a difference must stay a variance.
        (moment - means.squares(pilot)).max(1e-3 * moment)
    };
    let part = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
    let shares = sums.map(|share| Share {
        light: part(share.light, all),
        squares: part(share.squares, squares),
    });
    Forecast { variance, rare: rare / pilot.samples(), shares }
}

/// The use that a method makes of techniques.
struct Use {
    techniques: Techniques,
    heuristic: Heuristic,
    /// Light paths for each pixel.
    light_paths: f64,
    /// Hits count where nothing could have been aimed at.
    is_strict: bool,
}

impl Use {
    fn by(method: Method) -> Self {
        let settings = method.settings();
        let heuristic = settings.iter().find_map(|setting| {
            let MethodSetting::Heuristic(heuristic) = *setting else { return None };
            Some(heuristic)
        });
        let may_combine = method.options().contains(&MethodOption::Combine);
        let light_paths = method.light_paths_per_pixel();
        Self {
            techniques: method.techniques(),
            heuristic: heuristic.unwrap_or(Heuristic::Balance),
            light_paths,
            is_strict: may_combine && !settings.contains(&MethodSetting::Combine),
        }
    }

    /// Samples that technique s has for a path, for each that the pilot had.
    fn count(&self, path: &FoundPath, s: usize) -> f64 {
        let t = path.edges() + 1 - s;
        let takes_part = match s {
            _ if path.mirror_joint == Some(s) => self.techniques.mirror_connections,
            0 if self.is_strict && t > 2 => path.ratios[1] == 0.0,
            _ => self.techniques.allow(s, t, path.is_point),
        };
        match (takes_part, t) {
            (false, _) => 0.0,
            (true, 1) => self.light_paths,
            (true, _) => 1.0,
        }
    }
}

/// Means of techniques from the camera at each probe, of each half of the pilot's passes.
struct Means {
    halves: [Vec<[f64; 3]>; 2],
    passes: [u32; 2],
}

/// Techniques (s, k) with s ≤ k ≤ [`LONGEST`].
const SLOTS: usize = (LONGEST as usize + 1) * (LONGEST as usize + 1);

impl Means {
    fn of(pilot: &Pilot) -> Self {
        let zeros = || vec![[0.0; 3]; pilot.pixels.len() * SLOTS];
        let first = pilot.passes / 2;
        Self { halves: [zeros(), zeros()], passes: [first, pilot.passes - first] }
    }

    fn add(&mut self, probe: usize, pass: u32, (s, k): (usize, usize), value: [f64; 3], by: f64) {
        let half = usize::from(pass >= self.passes[0]);
        let slot = probe * SLOTS + s * (LONGEST as usize + 1) + k;
        let by = by / f64::from(self.passes[half]);
        for (sum, value) in self.halves[half][slot].iter_mut().zip(value) {
            *sum += by * value;
        }
    }

    /// The sum of the squares of all means, weighted as errors are: the product of two
    /// independent halves has the square as its mean, which that of one with itself has not.
    fn squares(&self, pilot: &Pilot) -> f64 {
        let [a, b] = &self.halves;
        let products = a.chunks(SLOTS).zip(b.chunks(SLOTS)).zip(&pilot.pixels);
        let each = products.map(|((a, b), &pixel)| {
            let sum: f64 = a.iter().zip(b).map(|(&a, &b)| product(a, b)).sum();
            pilot.tiles.weight(pixel) * sum
        });
        each.sum::<f64>() / pilot.pixels.len() as f64
    }
}
