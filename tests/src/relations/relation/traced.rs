//! The light that `trace` sees: light that comes from a point light by way of one surface.

use super::who::part;
use super::{Subject, name};
use crate::methods;
use crate::relations::judge::{Claim, Law, Numbers, Side};
use crate::relations::render::{Estimator, Trouble};
use std::sync::Arc;
use traylib_math::Vec3;

/// Without other lamps it is what path tracing finds with two edges.
///
/// Both take the same places in the pixel, so of one point light on opaque objects they
/// find the same sample by sample.
pub(super) fn claims(subject: &Subject<'_>) -> Result<Vec<Claim>, Trouble> {
    let mut scene = subject.drawn.clone();
    if scene.lights.is_empty() {
        return Ok(Vec::new());
    }
    scene.objects.iter_mut().for_each(|object| object.emission = Vec3::ZERO);
    scene.sky = None;
    scene.max_depth = Some(2);
    let built = Arc::new(subject.workshop.build(&scene)?);
    let by = |estimator| Side::Rendered(vec![part(&scene, &built, estimator)]);
    let walked = Estimator::Method(methods::DIRECT_LIGHT);
    Ok(vec![Claim {
        what: format!("trace = two edges, {}", name(walked)),
        left: by(Estimator::Method(methods::JITTERED_TRACE)),
        right: by(walked),
        flipped: false,
        factor: 1.0,
        law: Law::SameMean(2e-5),
        numbers: Numbers::Common,
    }])
}
