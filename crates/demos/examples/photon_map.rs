//! Progressive photon mapping: light paths leave photons, camera paths gather those nearby.
//! Each pass has its own and a smaller radius, so that the mean of all has neither bias nor
//! noise in the limit: Knaus and Zwicker, *Progressive Photon Mapping*, 2011.

use std::{collections::HashMap, error::Error, f32::consts::PI, path::Path};
use traylib_integrators::toolkit::{Step, Tracer, emit, next_step};
use traylib_integrators::{
    BlindSpot, Chunk, ChunkOutput, Integrator, Pass, PathSampler, RenderChunk, Roulette,
    SceneFacts, Settings, render_to_end,
};
use traylib_io::{PictureInfo, load_scene, save_picture};
use traylib_math::{Rgb, Vec2, Vec3};
use traylib_scene::{Scene, SurfacePoint, Walk};

/// The part of more photons that goes into less noise; the rest makes the radius smaller.
const ALPHA: f32 = 0.7;

/// Directions of a higher density per steradian are walked, not gathered: photons nearby say
/// little of a highlight. Matt surfaces have 1/π at most.
const SHARP: f32 = 0.5;

/// Power that arrived at a point, and the direction back to where it came from.
struct Photon {
    position: Vec3,
    wi: Vec3,
    power: Rgb,
}

/// Photons by the cubes of space, as wide as the radius, in which they lie.
struct PhotonMap {
    radius: f32,
    cells: HashMap<[i32; 3], Vec<Photon>>,
}

impl PhotonMap {
    fn new(photons: impl Iterator<Item = Photon>, radius: f32) -> Self {
        let mut map = Self { radius, cells: HashMap::new() };
        for photon in photons {
            map.cells.entry(map.cell(photon.position)).or_default().push(photon);
        }
        map
    }

    fn cell(&self, position: Vec3) -> [i32; 3] {
        (position / self.radius).to_array().map(|x| x.floor() as i32)
    }

    /// The photons within the radius.
    fn near(&self, position: Vec3) -> impl Iterator<Item = &Photon> {
        let [x, y, z] = self.cell(position);
        let cells = (0..27).map(move |i| [x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1]);
        let photons = cells.filter_map(|cell| self.cells.get(&cell)).flatten();
        photons.filter(move |p| p.position.distance_squared(position) < self.radius * self.radius)
    }

    /// Radiance toward `wo`: what the surface makes of the power around, over the disk.
    fn radiance(&self, point: &SurfacePoint, wo: Vec3) -> Rgb {
        let near = self.near(point.site.position);
        let scattered = near.map(|photon| (point.evaluate(wo, photon.wi), photon.power));
        let gathered = scattered.filter(|(scattering, _)| scattering.pdf.0 <= SHARP);
        gathered.map(|(s, power)| s.f * power).sum::<Rgb>() / (PI * self.radius * self.radius)
    }
}

struct PhotonMapping {
    radius: f32, // of the first pass, in metres
    roulette: Roulette,
}

impl PhotonMapping {
    /// r²ᵢ₊₁ = r²ᵢ (i + α)/(i + 1).
    fn radius_of(&self, pass: u64) -> f32 {
        let shrink = |i: u64| (i as f32 + ALPHA) / (i as f32 + 1.0);
        self.radius * (1..=pass).map(shrink).product::<f32>().sqrt()
    }

    /// Walks from a light and leaves a photon wherever something can gather it.
    fn shoot(&self, tracer: &mut Tracer<'_>, share: f32, sampler: &mut PathSampler) -> Vec<Photon> {
        let mut photons = Vec::new();
        let Some(start) = emit(tracer, sampler) else { return photons };
        let mut power = start.throughput * share;
        let (mut wi, mut point, mut numbers) = (-start.direction, start.x1, start.numbers);
        for edges in 2.. {
            if point.model.has_smooth_part() {
                photons.push(Photon { position: point.site.position, wi, power });
            }
            let step = next_step(Walk::FromLight, &point, wi, &numbers, self.roulette, edges);
            let Some(step) = step else { break };
            numbers = sampler.vertex();
            let Some(hit) = tracer.bounce_ray(&step.ray, numbers.pass_through) else { break };
            power *= step.weight * hit.transmittance;
            (wi, point) = (-step.ray.direction, hit.point);
        }
        photons
    }

    /// Walks from the camera and gathers at every surface, as long as sharp directions lead on.
    fn gather(&self, map: &PhotonMap, t: &mut Tracer<'_>, at: Vec2, s: &mut PathSampler) -> Rgb {
        let (mut throughput, mut found) = (Rgb::WHITE, Rgb::BLACK);
        let mut ray = t.scene.camera().ray(at);
        for edges in 1.. {
            let numbers = s.vertex();
            let hit = t.edge_from_camera(edges, &ray, numbers.pass_through);
            let Some(hit) = hit else { break };
            let (wo, point) = (-ray.direction, hit.point);
            throughput *= hit.transmittance;
            found += throughput * t.scene.emitted(&point);
            found += throughput * map.radiance(&point, wo);
            let step = next_step(Walk::FromCamera, &point, wo, &numbers, self.roulette, edges + 1);
            let is_sharp = |s: &Step| s.sample.is_delta || s.sample.pdf.0 > SHARP;
            let Some(step) = step.filter(is_sharp) else { break };
            (throughput, ray) = (throughput * step.weight, step.ray);
        }
        found
    }
}

impl Integrator for PhotonMapping {
    fn light_paths(&self, pixels: u32) -> u32 {
        pixels
    }

    fn begin_pass<'a>(&'a self, scene: &'a Scene, pass: &Pass<'_>) -> Option<RenderChunk<'a>> {
        let share = 1.0 / (scene.camera().width() * scene.camera().height()) as f32;
        let photons = pass.chunks(|chunk, tracer| {
            let shoot = |path| self.shoot(tracer, share, &mut chunk.light_sampler(path));
            chunk.light_paths.clone().flat_map(shoot).collect::<Vec<Photon>>()
        });
        let map = PhotonMap::new(photons.into_iter().flatten(), self.radius_of(pass.number()));
        Some(Box::new(move |chunk: &Chunk<'_>, out: &mut ChunkOutput| {
            chunk.sample_pixels(scene, out, |tracer, at, s| self.gather(&map, tracer, at, s));
        }))
    }

    fn blind_spots(&self, _: &SceneFacts) -> Vec<BlindSpot> {
        Vec::new()
    }
}

pub(crate) fn mapping(radius: f32) -> impl Integrator {
    PhotonMapping { radius, roulette: Roulette::default() }
}

fn main() -> Result<(), Box<dyn Error>> {
    let loaded = load_scene("cornell")?;
    let settings = Settings { spp: 32, ..Settings::default() };
    let film = render_to_end(&loaded.scene, &mapping(0.05), &settings)?.film;
    let info = PictureInfo { exposure: loaded.settings.exposure, ..PictureInfo::default() };
    Ok(save_picture(Path::new("photon_map.png"), &film.develop(), &info)?)
}
