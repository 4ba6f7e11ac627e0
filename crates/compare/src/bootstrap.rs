//! Bootstrap intervals whose random numbers are always the same, and so are they.

use traylib_math::Sampler;
use traylib_statistics::{Estimate, bootstrap};

/// [`bootstrap::mean`] of these values.
pub(crate) fn mean(values: &[f64], level: f64) -> Estimate {
    bootstrap::mean(values, level, stream)
}

/// [`bootstrap::ratio`] of these values.
pub(crate) fn ratio(values: &[f64], others: &[f64], level: f64) -> Estimate {
    bootstrap::ratio(values, others, level, stream)
}

fn stream(index: u64) -> impl FnMut() -> f32 {
    let mut sampler = Sampler::numbered(0, index);
    move || sampler.next_1d()
}
