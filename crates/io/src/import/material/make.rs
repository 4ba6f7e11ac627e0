//! From documents to materials.

use crate::import::place::Place;
use crate::import::textures::{Meaning, Textures, Usage};
use crate::report::Problems;
use crate::ron_scene::Material;
use crate::ron_scene::material::{
    BumpMap, Gauze, Lay, Lobes, Pane, Sheet, Texture, Textured, Tiling,
};
use crate::source::Location;
use traylib_materials::{self as materials, Bump, Error, Lambert, Layer, Maps, SurfaceModel};
use traylib_math::glam::{Affine2, Mat2};
use traylib_math::{Rgb, Vec2};

/// Makes the materials of a scene file, and notes what makes none.
pub(super) struct Maker<'a> {
    pub(super) location: &'a Location,
    pub(super) textures: &'a mut Textures,
    pub(super) problems: &'a mut Problems,
}

impl Maker<'_> {
    pub(super) fn material(
        &mut self,
        place: &Place,
        material: &Material,
    ) -> Option<materials::Material> {
        let model = match material {
            Material::Lambert(m) => {
                Lambert::new(Rgb::from(m.reflectance)).map(SurfaceModel::Lambert)
            }
            Material::Phong(m) => {
                phong([m.diffuse, m.specular], m.exponent).map(SurfaceModel::Phong)
            }
            Material::MaxPhong(m) => materials::MaxPhong::new(Rgb::from(m.specular), m.exponent)
                .map(SurfaceModel::MaxPhong),
            Material::Mirror(m) => mirror([m.reflectance, m.diffuse]).map(SurfaceModel::Mirror),
            Material::Glass(m) => materials::Dielectric::new(m.index).map(SurfaceModel::Dielectric),
            Material::Sheet(m) => return self.sheet(place, m).map(Into::into),
            Material::Pane(m) => return self.pane(place, m),
            Material::Gauze(m) => return self.gauze(place, m),
            Material::Textured(m) => return self.textured(place, m),
        };
        self.made(place, model).map(Into::into)
    }

    fn made<T>(&mut self, place: &Place, made: Result<T, Error>) -> Option<T> {
        made.map_err(|e| {
            let problem = faulty_part(place, &e).problem(&e);
            self.problems.push(problem.with_help_if_any(advice(&e)));
        })
        .ok()
    }

    fn sheet(&mut self, place: &Place, sheet: &Sheet) -> Option<SurfaceModel> {
        let mut side = |name, Lobes { diffuse, specular, exponent }: Lobes| {
            self.made(&place.field(name), phong([diffuse, specular], exponent))
        };
        let reflection = side("reflection", sheet.reflection);
        let transmission = side("transmission", sheet.transmission);
        let sheet = materials::Sheet::new(reflection?, transmission?);
        self.made(place, sheet).map(SurfaceModel::Sheet)
    }

    fn pane(&mut self, place: &Place, pane: &Pane) -> Option<materials::Material> {
        let [reflectance, through] = [pane.reflectance, pane.through].map(Rgb::from);
        let mirror = self.made(place, mirror([pane.reflectance, [0.0; 3]]));
        if !(through.min_band() >= 0.0 && (reflectance + through).max_band() <= 1.0 + 1e-6) {
            let message = "`reflectance` and `through` must be from 0 to 1, also their sum";
            self.problems.push(place.field("through").problem(message));
        }
        Some(materials::Material { through, ..SurfaceModel::Mirror(mirror?).into() })
    }

    fn gauze(&mut self, place: &Place, gauze: &Gauze) -> Option<materials::Material> {
        let base = place.field("base");
        if matches!(*gauze.base, Material::Gauze(_) | Material::Pane(_) | Material::Textured(_)) {
            let message = "the base has pictures, or light passes it straight already";
            self.problems.push(base.problem(message));
            return None;
        }
        let material = self.material(&base, &gauze.base)?;
        let through = Rgb::from(gauze.through);
        let sum = through + scattered(&material.model);
        if !(through.min_band() >= 0.0 && sum.max_band() <= 1.0 + 1e-5) {
            let message =
                "`through` must be from 0 to 1, also together with what the base scatters";
            self.problems.push(place.field("through").problem(message));
        }
        Some(materials::Material { through, ..material })
    }

    fn textured(&mut self, place: &Place, textured: &Textured) -> Option<materials::Material> {
        let base = place.field("base");
        if matches!(*textured.base, Material::Textured(_)) {
            self.problems.push(base.problem("the base has pictures of its own"));
            return None;
        }
        let material = self.material(&base, &textured.base);
        let mut layer = |name, texture: &Option<Texture>, meaning| {
            texture.as_ref().and_then(|t| self.layer(&place.field(name), t, meaning))
        };
        let maps = Maps {
            diffuse: layer("diffuse", &textured.diffuse, Meaning::Colour),
            specular: layer("specular", &textured.specular, Meaning::Colour),
            opacity: layer("opacity", &textured.opacity, Meaning::Amount)
                .and_then(|layer| self.textures.opacity(layer)),
            bump: textured.bump.as_ref().and_then(|b| self.bump(&place.field("bump"), b)),
        };
        let material = material?;
        self.check_base(place, &material.model, textured);
        Some(materials::Material { maps: Some(Box::new(maps)), ..material })
    }

    /// Refuses pictures that would not show.
    fn check_base(&mut self, place: &Place, base: &SurfaceModel, textured: &Textured) {
        let is_phong = matches!(base, SurfaceModel::Phong(_));
        let is_diffuse = is_phong || matches!(base, SurfaceModel::Lambert(_));
        if textured.diffuse.is_some() && !is_diffuse {
            let place = place.field("diffuse");
            self.problems
                .push(place.problem("a picture for `diffuse` wants a Lambert or Phong base"));
        }
        if textured.specular.is_some() && !is_phong {
            let place = place.field("specular");
            self.problems.push(place.problem("a picture for `specular` wants a Phong base"));
        }
    }

    fn layer(&mut self, place: &Place, texture: &Texture, meaning: Meaning) -> Option<Layer> {
        if !(0.0..=1.0).contains(&texture.strength) {
            self.problems.push(place.field("strength").problem("the strength must be from 0 to 1"));
        }
        self.lay(place, &texture.file, texture.lay, meaning)
            .map(|layer| Layer { strength: texture.strength, ..layer })
    }

    fn bump(&mut self, place: &Place, map: &BumpMap) -> Option<Bump> {
        if !map.height.is_finite() {
            self.problems.push(place.field("height").problem("the height must be finite"));
        }
        let layer = self.lay(place, &map.file, map.lay, Meaning::Amount)?;
        Some(Bump { layer, height: map.height })
    }

    fn placement(&mut self, place: &Place, lay: Lay) -> Affine2 {
        if let Some([a, b, c, d, x, y]) = lay.matrix {
            let matrix = Mat2::from_cols(Vec2::new(a, b), Vec2::new(c, d));
            let placement = Affine2::from_mat2_translation(matrix, Vec2::new(x, y));
            if !placement.is_finite() || matrix.determinant() == 0.0 {
                let message = "the matrix must be finite, and its a·d must not be b·c";
                self.problems.push(place.field("matrix").problem(message));
            }
            return placement;
        }
        let scale = Vec2::from(lay.scale);
        if !(scale.is_finite() && scale.cmpne(Vec2::ZERO).all()) {
            self.problems.push(place.field("scale").problem("the scale must be finite and not 0"));
        }
        Affine2::from_scale(scale)
    }

    fn lay(&mut self, place: &Place, file: &str, lay: Lay, meaning: Meaning) -> Option<Layer> {
        let placement = self.placement(place, lay);
        let location = self.location.beside(file);
        let texture = self.textures.load(&location, Usage::plain(meaning));
        let texture = texture.map_err(|error| {
            let problem = place.field("file").problem(error);
            self.problems.push(problem.with_help_if_any(location.advice(file)));
        });
        let texture = texture.ok()?;
        let tiling = tiling(lay.tiling);
        Some(Layer { placement, tiling, ..Layer::new(texture) })
    }
}

/// The most that a model scatters.
fn scattered(model: &SurfaceModel) -> Rgb {
    let both = |m: &materials::Phong| m.diffuse() + m.specular();
    match model {
        SurfaceModel::Lambert(m) => m.reflectance(),
        SurfaceModel::Phong(m) => both(m),
        SurfaceModel::MaxPhong(m) => m.specular(),
        SurfaceModel::Mirror(m) => m.reflectance() + m.diffuse(),
        SurfaceModel::Sheet(m) => both(&m.reflection()) + both(&m.transmission()),
        SurfaceModel::Dielectric(_) => Rgb::WHITE,
    }
}

fn phong([diffuse, specular]: [[f32; 3]; 2], exponent: f32) -> Result<materials::Phong, Error> {
    materials::Phong::new(Rgb::from(diffuse), Rgb::from(specular), exponent)
}

fn mirror([reflectance, diffuse]: [[f32; 3]; 2]) -> Result<materials::Mirror, Error> {
    materials::Mirror::new(Rgb::from(reflectance), Rgb::from(diffuse))
}

fn tiling(tiling: Tiling) -> materials::Tiling {
    match tiling {
        Tiling::Repeat => materials::Tiling::Repeat,
        Tiling::Mirror => materials::Tiling::Mirror,
        Tiling::Once => materials::Tiling::Once,
    }
}

#[expect(clippy::wildcard_enum_match_arm, reason = "of most errors there is no more to say")]
fn advice(error: &Error) -> Option<String> {
    match error {
        Error::Reflectance { value, .. } if value.iter().any(|&band| band > 2.0) => {
            Some("colours go from 0 to 1, not to 255, and are linear".to_string())
        }
        _ => None,
    }
}

/// The field that an error is about; errors name the fields as files do.
#[expect(clippy::wildcard_enum_match_arm, reason = "the others are about several fields")]
fn faulty_part(value: &Place, error: &Error) -> Place {
    match error {
        Error::Reflectance { name, .. } => value.field(name),
        Error::Exponent(_) => value.field("exponent"),
        Error::Index(_) => value.field("index"),
        _ => value.clone(),
    }
}
