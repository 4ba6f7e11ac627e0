//! Textures over a surface.

use crate::texture::{Texture, Tiling};
use crate::{Site, SurfaceModel};
use std::sync::Arc;
use traylib_math::glam::Affine2;
use traylib_math::{Rgb, Vec2, Vec3};

/// The textures of a material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Maps {
    /// Diffuse part.
    pub diffuse: Option<Layer>,
    /// Specular part of a Phong surface.
    pub specular: Option<Layer>,
    /// The opacity of the surface, by luminance. The rest of the light passes straight through.
    pub opacity: Option<Layer>,
    /// Height.
    pub bump: Option<Bump>,
}

/// A texture and how it lies on a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// The picture.
    pub texture: Arc<Texture>,
    /// From texture coordinates of the surface to those of the picture.
    pub placement: Affine2,
    /// The tiling beyond the picture's edges.
    pub tiling: Tiling,
    /// From 0, as if it were not there, to 1.
    pub strength: f32,
}

impl Layer {
    /// A picture that covers the unit square, again and again.
    pub fn new(texture: Arc<Texture>) -> Self {
        Self { texture, placement: Affine2::IDENTITY, tiling: Tiling::Repeat, strength: 1.0 }
    }

    /// The layer with one colour, the mean, in place of its picture.
    fn averaged(&self) -> Self {
        Self { texture: Arc::new(self.texture.averaged()), ..self.clone() }
    }

    /// Tells whether the picture has no end.
    fn is_everywhere(&self) -> bool {
        match self.tiling {
            Tiling::Repeat | Tiling::Mirror => true,
            Tiling::Once => false,
        }
    }

    /// Returns the colour at `uv`: the picture over `base`.
    fn over(&self, base: Rgb, uv: Vec2) -> Rgb {
        let texel = self.texture.lookup(self.placement.transform_point2(uv), self.tiling);
        texel.map_or(base, |texel| base * (1.0 - self.strength) + texel * self.strength)
    }
}

/// A bump map: a height over the surface that tilts the shading normal and moves nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Bump {
    /// Its luminance is the height, from 0 at the bottom to 1 at the top.
    pub layer: Layer,
    /// The height of 1, in units of the length that one unit of u has on the
    /// surface: independent of how large the object is.
    pub height: f32,
}

impl Bump {
    /// The shading normal of the bumps over a surface with the unit `normal`.
    ///
    /// With p_u and p_v the tangents and h the height over the surface, it is that
    /// of (p_u + h_u n) × (p_v + h_v n) without the term in h·n′ (Blinn,
    /// *Simulation of Wrinkled Surfaces*, 1978). The slopes are taken over a pixel
    /// of the picture.
    pub fn normal(&self, normal: Vec3, uv: Vec2, [p_u, p_v]: [Vec3; 2]) -> Vec3 {
        // Tangents as parts of the first, so that no product of them leaves f32.
        let unit = 1.0 / p_u.length();
        let [h_u, h_v] = self.slopes(uv).map(|slope| slope * self.height);
        let [t_u, t_v] = [p_u, p_v].map(|t| t * unit).map(|t| t - normal * normal.dot(t));
        let flat = t_u.cross(t_v);
        let side = normal.dot(flat).signum();
        let bumped = (t_u + normal * h_u).cross(t_v + normal * h_v) * side;
        bumped.try_normalize().unwrap_or(normal)
    }

    /// Height per unit of u and of v.
    fn slopes(&self, uv: Vec2) -> [f32; 2] {
        let layer = &self.layer;
        let height = |uv| layer.over(Rgb::BLACK, uv).luminance();
        let pixel = layer.texture.pixel_size();
        // As wide in texture coordinates as a pixel is in the picture.
        let scale = layer.placement.matrix2;
        let reach = |axis: Vec2| 0.5 / (scale * axis / pixel).length().max(f32::MIN_POSITIVE);
        [Vec2::X, Vec2::Y].map(|axis| {
            let reach = reach(axis);
            let step = axis * reach;
            (height(uv + step) - height(uv - step)) / (2.0 * reach)
        })
    }
}

impl Maps {
    /// Tells whether there is a picture of colour or opacity.
    pub(crate) fn have_pictures(&self) -> bool {
        let Self { diffuse, specular, opacity, bump: _ } = self;
        [diffuse, specular, opacity].into_iter().any(Option::is_some)
    }

    /// The maps with the mean of each picture of colour or opacity in its place: those that then
    /// colour every place alike, and the rest.
    pub(crate) fn averaged(&self) -> [Self; 2] {
        let Self { diffuse, specular, opacity, bump } = self;
        let averaged = |layer: &Option<Layer>, everywhere| {
            let layer = layer.as_ref().filter(|layer| layer.is_everywhere() == everywhere);
            layer.map(Layer::averaged)
        };
        let [even, rest] = [true, false].map(|everywhere| Self {
            diffuse: averaged(diffuse, everywhere),
            specular: averaged(specular, everywhere),
            ..Self::default()
        });
        let opacity = opacity.as_ref().map(Layer::averaged);
        [even, Self { opacity, bump: bump.clone(), ..rest }]
    }

    /// The model at a place: with the colours that the textures have there.
    pub(crate) fn apply(&self, model: SurfaceModel, uv: Vec2) -> SurfaceModel {
        let show = |layer: &Option<Layer>, base| layer.as_ref().map_or(base, |l| l.over(base, uv));
        model.with_colours(|base| show(&self.diffuse, base), |base| show(&self.specular, base))
    }

    /// Returns the part of the surface that is there.
    pub(crate) fn opacity(&self, uv: Vec2) -> f32 {
        let opacity = self.opacity.as_ref();
        opacity.map_or(1.0, |l| l.over(Rgb::WHITE, uv).luminance().clamp(0.0, 1.0))
    }

    pub(crate) fn shading_normal(&self, normal: Vec3, site: &Site) -> Vec3 {
        match (&self.bump, site.tangents) {
            (Some(bump), Some(tangents)) => bump.normal(normal, site.uv, tangents),
            _ => normal,
        }
    }
}

#[cfg(test)]
mod tests;
