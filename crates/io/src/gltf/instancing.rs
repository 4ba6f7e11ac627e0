//! Many places of one mesh, by `EXT_mesh_gpu_instancing`.

use super::accessor::Arrays;
use super::budget::Budget;
use super::json::Instancing;
use super::nodes::composed;
use super::{Cause, Error};
use traylib_math::glam::DAffine3;

/// The places of a node's mesh within the node.
///
/// # Errors
/// Attributes that are no places, of different lengths, or more than `budget` has left.
pub(super) fn places(
    instancing: &Instancing,
    arrays: &Arrays<'_>,
    budget: &mut Budget,
    place: &str,
) -> Result<Vec<DAffine3>, Error> {
    let here = |cause| Error::at(place, cause);
    let named = |name: &str| instancing.attributes.get(name).copied();
    let names = ["TRANSLATION", "ROTATION", "SCALE"].map(named);
    let mut count = None;
    for accessor in names.into_iter().flatten() {
        let given = arrays.count(accessor, place)?;
        if given != *count.get_or_insert(given) {
            return Err(here(Cause::Kind("as many values for each attribute of instances")));
        }
    }
    budget.take(count.unwrap_or(0)).map_err(here)?;
    let [translations, rotations, scales] = names;
    let translations = vectors::<3>(translations, arrays, place)?;
    let rotations = vectors::<4>(rotations, arrays, place)?;
    let scales = vectors::<3>(scales, arrays, place)?;
    let own = |index: usize| {
        let [translation, scale] = [&translations, &scales].map(|list| list.get(index).copied());
        composed(translation, rotations.get(index).copied(), scale)
    };
    let places: Vec<DAffine3> = (0..count.unwrap_or(0) as usize).map(own).collect();
    let is_finite = places.iter().all(DAffine3::is_finite);
    if is_finite { Ok(places) } else { Err(here(Cause::NotFinite)) }
}

/// Vectors of an attribute, none of one that is not there.
fn vectors<const N: usize>(
    accessor: Option<u64>,
    arrays: &Arrays<'_>,
    place: &str,
) -> Result<Vec<[f64; N]>, Error> {
    let Some(accessor) = accessor else { return Ok(Vec::new()) };
    let vectors = arrays.vectors::<N>(accessor, place)?;
    Ok(vectors.into_iter().map(|vector| vector.map(f64::from)).collect())
}
