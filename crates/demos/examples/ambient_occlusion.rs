//! Ambient occlusion: how much of the sky each point sees that nothing hides within 0.5 m.

use std::{error::Error, path::Path};
use traylib_geometry::Ray;
use traylib_integrators::{
    BlindSpot, Chunk, ChunkOutput, Integrator, SceneFacts, Settings, render_to_end,
};
use traylib_io::{PictureInfo, load_scene, save_picture};
use traylib_math::{Rgb, Vec2, warp};
use traylib_scene::Scene;

struct AmbientOcclusion;

impl Integrator for AmbientOcclusion {
    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        chunk.sample_pixels(scene, out, |tracer, film_point, sampler| {
            let (ray, numbers) = (scene.camera().ray(film_point), sampler.vertex());
            let Some(hit) = tracer.camera_ray(&ray, numbers.pass_through) else {
                return Rgb::WHITE;
            };
            let square = Vec2::new(numbers.bsdf[1], numbers.bsdf[2]);
            let direction = warp::cosine_hemisphere(hit.point.normal, square);
            let origin = hit.point.site.ray_origin(direction);
            tracer.sees(&Ray { origin, direction, t_max: 0.5 }).unwrap_or(Rgb::BLACK)
        });
    }

    fn blind_spots(&self, _: &SceneFacts) -> Vec<BlindSpot> {
        vec![BlindSpot::Interreflection, BlindSpot::AreaLights]
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let scene = load_scene("office-lamps")?.scene;
    let settings = Settings { spp: 32, ..Settings::default() };
    let film = render_to_end(&scene, &AmbientOcclusion, &settings)?.film;
    let info = PictureInfo { exposure: 1.0, ..PictureInfo::default() };
    Ok(save_picture(Path::new("ambient_occlusion.png"), &film.develop(), &info)?)
}
