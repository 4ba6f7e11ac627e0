//! From Mitsuba's BSDFs to models.
//!
//! | BSDF | becomes |
//! |---|---|
//! | `diffuse` | Lambert |
//! | `phong` | Phong, the same |
//! | `conductor` | mirror of the reflectance at normal incidence |
//! | `roughconductor` | max-Phong of that, n = 1/(2α²) |
//! | `dielectric` | clear solid glass |
//! | `thindielectric` | pane: what both of its sides reflect at normal incidence, 2R/(1 + R) |
//! | `plastic` | mirror of R = ((n − 1)/(n + 1))², and diffuse (1 − R)·ρ |
//! | `roughplastic` | Phong of the same, n = 1/(2α²) |
//! | `principled` | Phong, as of glTF's metal and roughness |
//! | `twosided`, `mask`, `null` | themselves |
//!
//! The facets of Beckmann's distribution have the slope α, and a lobe of n = 1/(2α²) about the
//! mirror direction is as wide; of GGX, whose lobe is narrower in the middle and has long tails,
//! the same is taken. n goes from 1 to 10⁶. What grows toward grazing angles there, Fresnel's
//! reflectance, does not here, but for solid glass.

use super::Importer;
use super::fields::Fields;
use super::index::{back_inside, relative, straight};
use super::paint::Paint;
use crate::Error;
use crate::import::model::appearance::{Appearance, SHARPEST};
use crate::import::model::plain::GREY;
use crate::mitsuba::{Class, Fault};
use crate::suggest::shown;
use std::rc::Rc;
use traylib_materials::{
    self as materials, Dielectric, Lambert, Maps, Material, MaxPhong, Mirror, SurfaceModel,
};
use traylib_math::Rgb;

/// BSDFs within each other.
const MOST_DEPTH: usize = 16;

/// The scattering of a surface.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    pub(super) front: Material,
    pub(super) backing: Backing,
}

/// The scattering of its back.
#[derive(Clone, Debug)]
pub(super) enum Backing {
    /// As its front.
    Same,
    /// Not at all; what passes the front straight passes here, too.
    Black,
    /// Otherwise.
    Other(Material),
}

type Made = Result<Material, materials::Error>;

impl Importer<'_> {
    /// Returns the surface that an object means, `depth` others being around it.
    pub(super) fn surface(&mut self, object: usize, depth: usize) -> Result<Rc<Surface>, Error> {
        if let Some(known) = self.surfaces.get(&object) {
            return Ok(Rc::clone(known));
        }
        let fields = Fields::of(self.document, object);
        if depth > MOST_DEPTH {
            let fault = Fault::Circle(shown(&fields.object.kind));
            return Err(self.document.error(fields.object.place, fault).into());
        }
        let surface = Rc::new(self.new_surface(fields, depth)?);
        self.surfaces.insert(object, Rc::clone(&surface));
        Ok(surface)
    }

    fn new_surface(&mut self, mut fields: Fields<'_>, depth: usize) -> Result<Surface, Error> {
        let made = match fields.object.kind.as_str() {
            "twosided" => self.two_sided(&mut fields, depth)?,
            "mask" => self.mask(&mut fields, depth)?,
            "blendbsdf" | "mixturebsdf" => self.blend(&mut fields, depth)?,
            "bumpmap" | "bump" | "normalmap" | "coating" | "roughcoating" => {
                self.coated(&mut fields, depth)?
            }
            _ => self.simple(&mut fields)?,
        };
        fields.finish(self.pictures.counter);
        Ok(made)
    }

    /// BSDFs with none within.
    fn simple(&mut self, fields: &mut Fields<'_>) -> Result<Surface, Error> {
        let (made, backing) = match fields.object.kind.as_str() {
            "diffuse" | "roughdiffuse" => (self.diffuse(fields), Backing::Black),
            "phong" => (self.phong(fields), Backing::Black),
            "conductor" => (self.conductor(fields), Backing::Black),
            "roughconductor" => (self.rough_conductor(fields), Backing::Black),
            "plastic" => (self.plastic(fields), Backing::Black),
            "roughplastic" => (self.rough_plastic(fields), Backing::Black),
            "principled" => (self.principled(fields), Backing::Black),
            "dielectric" | "roughdielectric" => (self.dielectric(fields), Backing::Same),
            "thindielectric" => (self.thin_dielectric(fields), Backing::Same),
            "null" => (clear(), Backing::Same),
            kind => {
                let what = format!("bsdf `{}` shown grey", shown(kind));
                self.pictures.counter.add(what);
                return Ok(Surface { front: self.made(fields, grey())?, backing: Backing::Black });
            }
        };
        Ok(Surface { front: self.made(fields, made)?, backing })
    }

    /// Numbers that make no material are a fault at its place.
    fn made(&self, fields: &Fields<'_>, made: Made) -> Result<Material, Error> {
        made.map_err(|error| {
            let object = fields.object;
            let fault = Fault::Material { kind: shown(&object.kind), why: error.to_string() };
            self.document.error(object.place, fault).into()
        })
    }

    /// The objects within, with what is missing grey.
    pub(super) fn nested(
        &mut self,
        fields: &mut Fields<'_>,
        depth: usize,
    ) -> Result<Vec<Rc<Surface>>, Error> {
        let mut nested = Vec::new();
        for object in fields.children(Class::Bsdf) {
            nested.push(self.surface(object, depth + 1)?);
        }
        if nested.is_empty() {
            let front = self.made(fields, grey())?;
            nested.push(Rc::new(Surface { front, backing: Backing::Black }));
        }
        Ok(nested)
    }

    fn two_sided(&mut self, fields: &mut Fields<'_>, depth: usize) -> Result<Surface, Error> {
        let nested = self.nested(fields, depth)?;
        let front = nested[0].front.clone();
        let backing =
            nested.get(1).map_or(Backing::Same, |back| Backing::Other(back.front.clone()));
        Ok(Surface { front, backing })
    }

    /// Two of our models cannot be in one place: that of which there is more is taken.
    fn blend(&mut self, fields: &mut Fields<'_>, depth: usize) -> Result<Surface, Error> {
        self.pictures.counter.add("blend of materials: that with the largest share taken");
        let nested = self.nested(fields, depth)?;
        let largest = match fields.text("weights") {
            Some(weights) => {
                let weights = weights.split([',', ' ']).filter_map(|text| text.trim().parse().ok());
                let weights: Vec<f64> = weights.take(nested.len()).collect();
                (0..weights.len()).max_by(|&a, &b| weights[a].total_cmp(&weights[b])).unwrap_or(0)
            }
            None => usize::from(self.share(fields, "weight", 0.5) > 0.5),
        };
        Ok((*nested[largest.min(nested.len() - 1)]).clone())
    }

    /// Bumps and varnish.
    fn coated(&mut self, fields: &mut Fields<'_>, depth: usize) -> Result<Surface, Error> {
        let what = format!("bsdf `{}`: shown without", shown(&fields.object.kind));
        self.pictures.counter.add(what);
        fields.children(Class::Texture);
        let names = fields.object.properties.iter().map(|property| property.name.as_str());
        let names: Vec<&str> = names.collect();
        fields.ignore(&names);
        Ok((*self.nested(fields, depth)?[0]).clone())
    }

    fn diffuse(&mut self, fields: &mut Fields<'_>) -> Made {
        let Paint { colour, layer } = self.paint(fields, "reflectance", 0.5, Rgb::WHITE);
        self.appearance([colour, Rgb::BLACK], 1.0, Maps { diffuse: layer, ..Maps::default() })
    }

    fn phong(&mut self, fields: &mut Fields<'_>) -> Made {
        let diffuse = self.paint(fields, "diffuse_reflectance", 0.5, Rgb::WHITE);
        let specular = self.paint(fields, "specular_reflectance", 0.2, Rgb::WHITE);
        let exponent = self.exponent_field(fields);
        let maps = Maps { diffuse: diffuse.layer, specular: specular.layer, ..Maps::default() };
        self.appearance([diffuse.colour, specular.colour], exponent, maps)
    }

    fn exponent_field(&mut self, fields: &mut Fields<'_>) -> f32 {
        let exponent = fields.number("exponent").unwrap_or(30.0) as f32;
        if !(0.0..=SHARPEST).contains(&exponent) {
            self.pictures.counter.add("exponent not from 0 to 10⁶, brought there");
        }
        exponent.clamp(0.0, SHARPEST)
    }

    fn appearance(&mut self, [diffuse, specular]: [Rgb; 2], exponent: f32, maps: Maps) -> Made {
        Appearance { diffuse, specular, exponent, share: 1.0, maps }.material(&mut self.pictures)
    }

    fn conductor(&mut self, fields: &mut Fields<'_>) -> Made {
        let reflectance = self.metal(fields) * self.even_paint(fields, "specular_reflectance", 1.0);
        Mirror::new(reflectance, Rgb::BLACK).map(|mirror| SurfaceModel::Mirror(mirror).into())
    }

    fn rough_conductor(&mut self, fields: &mut Fields<'_>) -> Made {
        let specular = self.metal(fields) * self.even_paint(fields, "specular_reflectance", 1.0);
        let exponent = self.lobe(fields);
        MaxPhong::new(specular, exponent).map(|metal| SurfaceModel::MaxPhong(metal).into())
    }

    /// The exponent for a roughness.
    fn lobe(&mut self, fields: &mut Fields<'_>) -> f32 {
        fields.ignore(&["distribution", "sample_visible", "sample_all"]);
        let alpha = self.share(fields, "alpha", 0.1);
        let [u, v] = ["alpha_u", "alpha_v"].map(|name| self.share(fields, name, alpha));
        if u != v {
            self.pictures.counter.add("roughness that differs along u and v: its mean taken");
        }
        let square = u * v;
        if square > 0.0 { (0.5 / square).clamp(1.0, SHARPEST) } else { SHARPEST }
    }

    fn dielectric(&mut self, fields: &mut Fields<'_>) -> Made {
        if fields.object.kind == "roughdielectric" {
            self.lobe(fields);
            self.pictures.counter.add("rough glass shown smooth");
        }
        let index = relative(fields, "bk7");
        self.note_tint(fields);
        if (index - 1.0).abs() < 1e-6 {
            return clear();
        }
        Dielectric::new(index as f32).map(|glass| SurfaceModel::Dielectric(glass).into())
    }

    /// Our glass is clear.
    fn note_tint(&mut self, fields: &mut Fields<'_>) {
        for name in ["specular_reflectance", "specular_transmittance"] {
            if self.even_paint(fields, name, 1.0) != Rgb::WHITE {
                self.pictures.counter.add(format!("`{name}` of glass skipped: ours is clear"));
            }
        }
    }

    fn thin_dielectric(&mut self, fields: &mut Fields<'_>) -> Made {
        let one = straight(relative(fields, "bk7"));
        let both = (2.0 * one / (1.0 + one)) as f32;
        let mut part = |name, part| self.even_paint(fields, name, 1.0) * part;
        let reflected = part("specular_reflectance", both);
        let passed = part("specular_transmittance", 1.0 - both);
        let mirror = Mirror::new(reflected, Rgb::BLACK)?;
        Ok(Material { through: passed, ..SurfaceModel::Mirror(mirror).into() })
    }

    /// Returns the diffuse and the mirrored part of a plastic.
    fn plastic_parts(&mut self, fields: &mut Fields<'_>) -> (Paint, Rgb) {
        let index = relative(fields, "polypropylene");
        let reflected = straight(index);
        let specular = self.even_paint(fields, "specular_reflectance", 1.0) * reflected as f32;
        let passed = Rgb::splat((1.0 - reflected) as f32);
        let mut diffuse = self.paint(fields, "diffuse_reflectance", 0.5, passed);
        if fields.flag("nonlinear") == Some(true) {
            if diffuse.layer.is_some() {
                self.pictures.counter.add("`nonlinear` of plastic with a picture skipped");
            } else {
                // Light that comes back from the inside of the boundary is coloured once more.
                let kept = back_inside(index) as f32;
                let again = |band: f32| band * (1.0 - kept) / (1.0 - band * kept);
                diffuse.colour =
                    Rgb::from((diffuse.colour / passed.r).to_array().map(again)) * passed;
            }
        }
        (diffuse, specular)
    }

    fn plastic(&mut self, fields: &mut Fields<'_>) -> Made {
        let (Paint { colour, layer }, specular) = self.plastic_parts(fields);
        if layer.is_some() {
            // No picture lies on a mirror of ours.
            return self.appearance(
                [colour, specular],
                SHARPEST,
                Maps { diffuse: layer, ..Maps::default() },
            );
        }
        Mirror::new(specular, colour).map(|mirror| SurfaceModel::Mirror(mirror).into())
    }

    fn rough_plastic(&mut self, fields: &mut Fields<'_>) -> Made {
        let (Paint { colour, layer }, specular) = self.plastic_parts(fields);
        let exponent = self.lobe(fields);
        self.appearance([colour, specular], exponent, Maps { diffuse: layer, ..Maps::default() })
    }

    /// Burley's model, of which base colour, metal, roughness and the highlight are kept.
    fn principled(&mut self, fields: &mut Fields<'_>) -> Made {
        let metallic = self.share(fields, "metallic", 0.0);
        let roughness = self.share(fields, "roughness", 0.5);
        let reflected = match fields.number("eta") {
            Some(eta) => straight(eta) as f32,
            None => 0.08 * fields.number("specular").unwrap_or(0.5).clamp(0.0, 1.0) as f32,
        };
        let Paint { colour, layer } =
            self.paint(fields, "base_color", 0.5, Rgb::splat((1.0 - metallic) * (1.0 - reflected)));
        let base =
            if layer.is_some() { Rgb::WHITE } else { self.even_paint(fields, "base_color", 0.5) };
        let specular = Rgb::splat(reflected * (1.0 - metallic)) + base * metallic;
        let square = roughness.powi(4);
        let exponent = if square > 0.0 { (0.5 / square).clamp(1.0, SHARPEST) } else { SHARPEST };
        self.appearance([colour, specular], exponent, Maps { diffuse: layer, ..Maps::default() })
    }
}

/// /// A surface that is not there.
fn clear() -> Made {
    let model = SurfaceModel::Lambert(Lambert::new(Rgb::BLACK)?);
    Ok(Material { through: Rgb::WHITE, ..model.into() })
}

pub(super) fn grey() -> Made {
    Ok(SurfaceModel::Lambert(Lambert::new(Rgb::splat(GREY))?).into())
}
