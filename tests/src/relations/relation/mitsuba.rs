//! Mitsuba, a renderer by others, with the same file.

use super::who::{part, sees};
use super::{Subject, name};
use crate::methods::{BDPT, COMBINED};
use crate::relations::form::{Files, mitsuba};
use crate::relations::judge::{Claim, Law, Numbers, Outside, Side};
use crate::relations::outside;
use crate::relations::render::{Estimator, Trouble};
use std::sync::Arc;

/// The relative difference of means that the offsets of Mitsuba's rays may cause, which skip up to
/// some ten-thousandths of the distance to the origin.
const OFFSETS: f64 = 3e-3;

/// What both make of a file that both can read. Mitsuba's walks from the camera find no light that
/// comes from a point by way of a mirror.
pub(super) fn claims(subject: &Subject<'_>) -> Result<Vec<Claim>, Trouble> {
    let Some(common) = mitsuba::common(subject.drawn) else { return Ok(Vec::new()) };
    let has_hidden_light = !common.lights.is_empty() && common.has_mirrors();
    if has_hidden_light || outside::python().is_err() {
        return Ok(Vec::new());
    }
    let files = Files::of_mitsuba(&common, "common");
    let built = Arc::new(subject.workshop.load(&files, common.max_depth)?);
    let as_read = Subject { drawn: &common, built: Arc::clone(&built), right: None, ..*subject };
    let methods = [BDPT, COMBINED].into_iter().filter(|&method| sees(&as_read, method));
    let walked = part(&common, &built, Estimator::Method(COMBINED));
    let outside = Outside { files: Arc::new(files), part: walked };
    let claim = |method| Claim {
        what: format!("{} = Mitsuba", name(Estimator::Method(method))),
        left: Side::Rendered(vec![part(&common, &built, Estimator::Method(method))]),
        right: Side::Outside(outside.clone()),
        flipped: false,
        factor: 1.0,
        law: Law::SameMean(OFFSETS),
        numbers: Numbers::Own,
    };
    Ok(methods.map(claim).collect())
}
