//! Shapes from OBJ and PLY files, as Mitsuba takes them: one material, whatever the file names, and
//! normals where there are none.

use super::fields::Fields;
use super::form::Form;
use super::{Importer, in_folder};
use crate::Error;
use crate::import::counter::Counter;
use crate::import::model::arrays::Arrays;
use crate::import::model::{obj, ply};
use crate::mitsuba::Fault;
use crate::polygon_limits::PolygonLimits;
use crate::source::{Location, why};
use crate::suggest::shown;
use std::rc::Rc;
use traylib_geometry::Vec3;
use traylib_math::glam::DVec3;

/// A file and the ways to take it: whether it is an OBJ file, has the normals of its faces, and its
/// texture coordinates are turned.
pub(super) type MeshKey = (Location, [bool; 3]);

/// A file that has been read.
pub(super) type Loaded = Rc<Form>;

impl Importer<'_> {
    /// Reads the file of a shape, each once.
    pub(super) fn mesh(&mut self, fields: &mut Fields<'_>) -> Result<Rc<Form>, Error> {
        let place = fields.object.place;
        let is_obj = fields.object.kind == "obj";
        let Some(name) = fields.text("filename") else {
            let fault = Fault::Missing { element: "shape".to_string(), attribute: "filename" };
            return Err(self.document.error(place, fault).into());
        };
        let is_flat = fields.flag("face_normals").unwrap_or(false);
        // Of older versions, which turn none in PLY files either.
        let is_turned = fields.flag("flip_tex_coords").unwrap_or(is_obj);
        fields.ignore(&["shape_index", "collapse", "srgb", "max_smooth_angle"]);
        let refused = |why| {
            let fault = Fault::Shape { name: shown(name), why };
            Error::from(self.document.error(place, fault))
        };
        let location = in_folder(self.beside, name).map_err(refused)?;
        let key = (location, [is_obj, is_flat, is_turned]);
        if let Some(known) = self.meshes.get(&key) {
            return Ok(Rc::clone(known));
        }
        let form = load(&key, self.polygons, self.pictures.counter).map_err(refused)?;
        let form = Rc::new(form);
        self.meshes.insert(key, Rc::clone(&form));
        Ok(form)
    }
}

fn load(
    (location, [is_obj, is_flat, is_turned]): &MeshKey,
    limits: PolygonLimits,
    counter: &mut Counter,
) -> Result<Form, String> {
    let bytes = location.read().map_err(|cause| why(&cause))?;
    let mut arrays = if *is_obj {
        obj::bare(&bytes, limits, counter)?
    } else {
        ply::bare(&bytes, limits, counter)?
    };
    if *is_flat {
        arrays.normals.clear();
    }
    if *is_turned {
        arrays.uvs.iter_mut().for_each(|uv| uv.y = 1.0 - uv.y);
    }
    let has_own_normals = !arrays.normals.is_empty();
    if has_own_normals {
        face_normals_way(&mut arrays);
    } else if !is_flat {
        arrays.normals = smooth(&arrays);
    }
    let mesh = arrays.finish(counter).map_err(|error| error.to_string())?;
    Ok(Form::Mesh { mesh, has_own_normals })
}

fn corner(arrays: &Arrays, corner: u32) -> DVec3 {
    arrays.positions.get(corner as usize).map_or(DVec3::ZERO, |position| position.as_dvec3())
}

/// Turns the triangles of a mesh of which most disagree with their normals: these say what is in
/// front.
fn face_normals_way(arrays: &mut Arrays) {
    let is_behind = |triangle: &&[u32; 3]| {
        let [a, b, c] = triangle.map(|number| corner(arrays, number));
        let normal = triangle.iter().filter_map(|&number| arrays.normals.get(number as usize));
        let normal: DVec3 = normal.map(|normal| normal.as_dvec3()).sum();
        (b - a).cross(c - a).dot(normal) < 0.0
    };
    let behind = arrays.triangles.iter().filter(is_behind).count();
    if 2 * behind > arrays.triangles.len() {
        arrays.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    }
}

/// Normals of vertices: the mean of the faces around, each weighted by its angle there.
fn smooth(arrays: &Arrays) -> Vec<Vec3> {
    let mut sums = vec![DVec3::ZERO; arrays.positions.len()];
    for triangle in &arrays.triangles {
        let corners = triangle.map(|number| corner(arrays, number));
        let front = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
        for (place, &number) in triangle.iter().enumerate() {
            let [next, last] = [1, 2].map(|step| corners[(place + step) % 3] - corners[place]);
            let angle = next.cross(last).length().atan2(next.dot(last));
            if let Some(sum) = sums.get_mut(number as usize) {
                *sum += front * angle;
            }
        }
    }
    sums.into_iter().map(|sum| sum.normalize_or_zero().as_vec3()).collect()
}
