//! Shapes with their materials and what they emit.

use super::Importer;
use super::content::Item;
use super::fields::Fields;
use super::form::{Form, is_round};
use super::surface::{Backing, Surface, grey};
use crate::import::imported_material::ImportedMaterial;
use crate::mitsuba::{Class, Fault};
use crate::suggest::shown;
use crate::{Error, Limit};
use std::rc::Rc;
use traylib_geometry::Sides;
use traylib_materials::{Lambert, Maps, Material, SurfaceModel};
use traylib_math::Rgb;
use traylib_math::glam::{DAffine3, DVec3};

/// The numbers of the materials of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Faces {
    front: usize,
    back: Option<usize>,
    is_textured: bool,
}

impl Importer<'_> {
    pub(super) fn shape(&mut self, object: usize) -> Result<(), Error> {
        let mut fields = Fields::of(self.document, object);
        let (form, own) = match fields.object.kind.as_str() {
            "rectangle" => (Rc::new(Form::Rectangle), DAffine3::IDENTITY),
            "cube" => (Rc::new(Form::Cube), DAffine3::IDENTITY),
            "disk" => (Rc::new(Form::Disk), DAffine3::IDENTITY),
            "sphere" => (Rc::new(Form::Sphere), ball(&mut fields)),
            "cylinder" => (Rc::new(cylinder(&mut fields)), DAffine3::IDENTITY),
            "obj" | "ply" => (self.mesh(&mut fields)?, DAffine3::IDENTITY),
            _ => {
                self.skipped(object);
                return Ok(());
            }
        };
        let place = fields.place() * own;
        let is_flipped = fields.flag("flip_normals").unwrap_or(false);
        let faces = self.faces(&mut fields)?;
        if faces.is_textured && !form.has_uvs() {
            self.pictures.counter.add(
                "picture on a shape that has no place for one here: its mean taken for all of it",
            );
        }
        self.note_form(&form, &place);
        self.count_triangles(&fields, &form, faces)?;
        fields.finish(self.pictures.counter);
        if form.fits(&place) {
            let Faces { front, back, is_textured } = faces;
            self.content.items.push(Item { form, place, is_flipped, front, back, is_textured });
        }
        Ok(())
    }

    fn note_form(&mut self, form: &Form, place: &DAffine3) {
        if !form.fits(place) {
            self.pictures.counter.add("round shape that is scaled unevenly left out");
        } else if matches!(form, Form::Disk) && !is_round(place) {
            self.pictures.counter.add("disk that is no circle cut into 64 triangles");
        }
    }

    fn count_triangles(
        &mut self,
        fields: &Fields<'_>,
        form: &Form,
        faces: Faces,
    ) -> Result<(), Error> {
        let times = if faces.back.is_some() { 2 } else { 1 };
        let count = form.triangles().saturating_mul(times);
        let Some(left) = self.triangles_left.checked_sub(count) else {
            let (what, limit) = ("triangles in all places", self.limits.triangles);
            let fault = Fault::Limit { what, limit, option: Limit::Surfaces };
            return Err(self.document.error(fields.object.place, fault).into());
        };
        self.triangles_left = left;
        Ok(())
    }

    /// The materials of a shape, by the BSDF and the emitter within.
    fn faces(&mut self, fields: &mut Fields<'_>) -> Result<Faces, Error> {
        let emission = self.emission(fields);
        let bsdfs = fields.children(Class::Bsdf);
        if bsdfs.len() > 1 {
            self.pictures.counter.add_many("bsdf beside the first skipped", bsdfs.len() as u32 - 1);
        }
        let bsdf = bsdfs.first().copied();
        let bits = emission.map_or([u32::MAX; 3], |light| light.to_array().map(f32::to_bits));
        if let Some(known) = self.faces.get(&(bsdf, bits)) {
            return Ok(*known);
        }
        let surface =
            match bsdf {
                Some(bsdf) => self.surface(bsdf, 0)?,
                // Mitsuba's own for what has none.
                None => Rc::new(if emission.is_some() { black() } else { plain() }.map_err(
                    |cause| Error::Material { file: self.document.files[0].clone(), cause },
                )?),
            };
        let name = bsdf.map_or("", |bsdf| self.document.objects[bsdf].id.as_str());
        let faces = self.new_faces(name, &surface, emission.unwrap_or(Rgb::BLACK));
        self.faces.insert((bsdf, bits), faces);
        Ok(faces)
    }

    fn new_faces(&mut self, name: &str, surface: &Surface, emission: Rgb) -> Faces {
        let front = &surface.front;
        let back = match &surface.backing {
            Backing::Same => None,
            Backing::Black => Some(blackened(front)).filter(|back| back != front),
            Backing::Other(back) => Some(back.clone()),
        };
        let is_textured =
            front.maps.is_some() || back.as_ref().is_some_and(|back| back.maps.is_some());
        let sides = if back.is_some() { Sides::Front } else { Sides::Both };
        let mut add = |surface: Material, emission| {
            self.materials.push(ImportedMaterial { name: shown(name), surface, sides, emission });
            self.materials.len() - 1
        };
        let front = add(front.clone(), emission);
        Faces { front, back: back.map(|back| add(back, Rgb::BLACK)), is_textured }
    }

    /// Returns the radiance of its front, if it is a lamp.
    fn emission(&mut self, fields: &mut Fields<'_>) -> Option<Rgb> {
        let emitter = fields.children(Class::Emitter).first().copied()?;
        let mut fields = Fields::of(self.document, emitter);
        if fields.object.kind != "area" {
            self.skipped(emitter);
            return None;
        }
        let radiance = self.radiance(&mut fields, "radiance");
        fields.ignore(&["sampling_weight"]);
        fields.finish(self.pictures.counter);
        radiance.is_finite().then_some(radiance)
    }
}

/// The same as a black one, which lets through what it does.
fn blackened(material: &Material) -> Material {
    let model = Lambert::new(Rgb::BLACK).map_or(material.model, SurfaceModel::Lambert);
    let opacity = material.maps.as_ref().and_then(|maps| maps.opacity.clone());
    let maps = opacity.map(|opacity| Box::new(Maps { opacity: Some(opacity), ..Maps::default() }));
    Material { model, through: material.through, maps }
}

fn plain() -> Result<Surface, traylib_materials::Error> {
    Ok(Surface { front: grey()?, backing: Backing::Black })
}

fn black() -> Result<Surface, traylib_materials::Error> {
    let front = SurfaceModel::Lambert(Lambert::new(Rgb::BLACK)?).into();
    Ok(Surface { front, backing: Backing::Same })
}

/// The place of a unit sphere that is this one.
fn ball(fields: &mut Fields<'_>) -> DAffine3 {
    let centre = fields.vector("center").map_or(DVec3::ZERO, DVec3::from);
    let radius = fields.number("radius").unwrap_or(1.0);
    DAffine3 { matrix3: DAffine3::from_scale(DVec3::splat(radius)).matrix3, translation: centre }
}

fn cylinder(fields: &mut Fields<'_>) -> Form {
    let mut end = |name, usual| fields.vector(name).map_or(usual, DVec3::from);
    let ends = [end("p0", DVec3::ZERO), end("p1", DVec3::Z)];
    Form::Cylinder { ends, radius: fields.number("radius").unwrap_or(1.0) }
}
