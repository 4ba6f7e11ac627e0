//! Material libraries that an OBJ file names.

use crate::Error;
use crate::import::counter::Counter;
use crate::import::model::beside::Beside;
use crate::import::model::source::ModelSource;
use crate::obj::mtl::{self, Material};
use crate::obj::{Document, Limits};
use crate::source::Location;
use std::collections::HashMap;

/// Material libraries that one file may name.
const MOST: usize = 1000;

/// Reads all materials by name; of those with the same name the first.
///
/// # Errors
/// A library cannot be read or makes no sense. One that is not there is a warning.
pub(super) fn read(
    document: &Document,
    beside: &Beside,
    limits: Limits,
    counter: &mut Counter,
) -> Result<HashMap<String, Material>, Error> {
    let mut materials = HashMap::new();
    let mut read: Vec<Location> = Vec::new();
    for name in document.libraries.iter().take(MOST) {
        for location in locations(name, beside, counter) {
            if read.contains(&location) {
                continue;
            }
            add(&location, limits, counter, &mut materials)?;
            read.push(location);
        }
    }
    Ok(materials)
}

/// Finds one file whose name may have blanks, else several between blanks.
fn locations(name: &str, beside: &Beside, counter: &mut Counter) -> Vec<Location> {
    if let Some(whole) = beside.find(name) {
        return vec![whole];
    }
    let mut found = |name| {
        let location = beside.find(name);
        if location.is_none() {
            counter.add(format!("material library `{name}` not found"));
        }
        location
    };
    if name.split_whitespace().any(|one| beside.find(one).is_some()) {
        name.split_whitespace().filter_map(found).collect()
    } else {
        found(name).into_iter().collect()
    }
}

fn add(
    location: &Location,
    limits: Limits,
    counter: &mut Counter,
    materials: &mut HashMap<String, Material>,
) -> Result<(), Error> {
    let source = ModelSource::new(location);
    let library = mtl::decode(&source.bytes()?, limits).map_err(|cause| source.malformed(cause))?;
    counter.add_counts(&library.warnings);
    for material in library.materials {
        materials.entry(material.name.clone()).or_insert(material);
    }
    Ok(())
}
