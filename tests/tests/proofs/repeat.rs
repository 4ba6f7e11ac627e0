//! A picture comes again: on other numbers of threads, at another scale, by
//! another method that does the same, with other roulette.

use std::ops::ControlFlow;
use traylib_integrators::{
    Bdpt, Control, DirectLight, Integrator, Limits, Method, Progress, Roulette, Settings,
    Statistics, render,
};
use traylib_known::{each_pass, settings_by_pass};
use traylib_math::{Grid, Heuristic};
use traylib_scene::Scene;
use traylib_statistics::{Sample, sidak, tile_means, welch};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::laws::verdict::same_bits;
use traylib_tests::methods;
use traylib_tests::still_life::still_life;

/// The integrators of all methods with their names; `trace` in both of its forms.
fn integrators() -> Vec<(String, Box<dyn Integrator>)> {
    let traces = [Method::TRACE, methods::JITTERED_TRACE];
    let all = traces.into_iter().chain(methods::WALKING);
    all.map(|method| (method.to_string(), method.build())).collect()
}

fn picture(scene: &Scene, integrator: &dyn Integrator, settings: Settings) -> Grid<[f64; 3]> {
    let observe = &mut |_: &Progress<'_>| ControlFlow::Continue(());
    let rendering =
        render(scene, integrator, &settings, &Control::default(), observe).expect("a few threads");
    assert_eq!(rendering.statistics.rejected, 0);
    rendering.film.mean()
}

fn bits(image: &Grid<[f64; 3]>) -> Vec<[u64; 3]> {
    image.values().iter().map(|pixel| pixel.map(f64::to_bits)).collect()
}

/// On one thread and on more than there are chunks, and twice on as many.
#[test]
fn threads_do_not_change_a_bit() {
    let scene = still_life(1.0);
    let findings = integrators().into_iter().flat_map(|(name, integrator)| {
        let on = |threads| {
            bits(&picture(
                &scene,
                integrator.as_ref(),
                Settings { spp: 2, seed: 3, threads, ..Settings::default() },
            ))
        };
        let one = on(1);
        assert!(one.iter().flatten().any(|&bits| bits != 0), "{name}: black");
        [1, 2, 7, 16].map(|threads| {
            same_bits(
                format!("{name} on {threads} threads"),
                differing(&one, &on(threads)),
                one.len(),
            )
        })
    });
    settle(&findings.collect::<Vec<_>>());
}

fn differing(a: &[[u64; 3]], b: &[[u64; 3]]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a != b).count()
}

/// No length is compared with a constant, and powers of two scale exactly.
#[test]
fn scale_does_not_change_a_bit() {
    let settings = Settings { spp: 4, seed: 4, threads: 1, ..Settings::default() };
    let findings = integrators().into_iter().flat_map(|(name, integrator)| {
        let at = |scale| bits(&picture(&still_life(scale), integrator.as_ref(), settings));
        let plain = at(1.0);
        [10, -14, 20].map(|exponent| {
            let scaled = at(2.0_f32.powi(exponent));
            same_bits(format!("{name} at 2^{exponent}"), differing(&plain, &scaled), plain.len())
        })
    });
    settle(&findings.collect::<Vec<_>>());
}

/// Bidirectional path tracing with the techniques of another method finds the
/// same paths from the same numbers, and weighs them alike up to rounding.
#[test]
fn bdpt_with_the_techniques_of_another_method_is_that_method() {
    let scene = still_life(1.0);
    let heuristic = Heuristic::Power;
    let settings = Settings { spp: 16, seed: 5, threads: 1, ..Settings::default() };
    // Each aims at images from vertices of its own choice.
    let combine = Some(heuristic);
    let combined =
        Method::DirectLight(DirectLight { combine, no_images: true, ..DirectLight::default() });
    for method in [methods::PURE_MC, combined, methods::PARTICLE] {
        let (techniques, other) = (method.techniques(), method.build());
        let limits = method.limits().unwrap_or_default();
        let bdpt = Bdpt { techniques, limits, heuristic, aims_at_images: false, ..Bdpt::default() };
        let [bdpt, other] = [&bdpt as &dyn Integrator, other.as_ref()]
            .map(|integrator| picture(&scene, integrator, settings));
        for (i, (a, b)) in bdpt.values().iter().zip(other.values()).enumerate() {
            let close = (a[1] - b[1]).abs() <= 1e-4 * b[1];
            assert!(close, "{method}, pixel {i}: {} {}", a[1], b[1]);
        }
    }
}

/// The means of 8 × 8 blocks, over all passes.
fn blocks(integrator: &dyn Integrator, settings: Settings) -> Vec<Sample> {
    let mut blocks: Vec<Vec<f64>> = Vec::new();
    let statistics: Statistics = each_pass(&still_life(1.0), integrator, &settings, |pass| {
        let means = tile_means(pass.map(|bands| bands[1]).values(), pass.width(), 8);
        blocks.resize(means.len(), Vec::new());
        for (block, mean) in blocks.iter_mut().zip(means) {
            block.push(mean);
        }
    });
    assert_eq!(statistics.rejected, 0);
    blocks.iter().map(|values| Sample::of(values)).collect()
}

/// Roulette changes the noise and not the picture: two comparisons of 20 blocks
/// with independent numbers, false alarm 10⁻³ for all of them. The picture is
/// known to two per cent.
#[test]
fn roulette_does_not_change_the_picture() {
    const PASSES: u32 = 96;
    let render = |roulette, seed| {
        let limits = Limits { max_depth: Some(12), roulette };
        blocks(&Bdpt { limits, ..Bdpt::default() }, settings_by_pass(PASSES, seed))
    };
    let without = render(Roulette::OFF, 61);
    let level = sidak(1e-3, 2 * without.len());
    let findings = [(3, 62), (5, 63)].map(|(from_edge, seed)| {
        let with = render(Roulette { from_edge }, seed);
        let smallest = without.iter().zip(&with).map(|(a, b)| welch(a, b)).fold(1.0, f64::min);
        let widest = without
            .iter()
            .chain(&with)
            .map(|block| block.variance_of_mean.sqrt() / block.mean)
            .fold(0.0, f64::max);
        Finding {
            claim: format!("roulette from edge {from_edge}: {} blocks as without", with.len()),
            statistic: format!("smallest p {smallest:.1e}, standard errors up to {widest:.3}"),
            level: Some(level),
            samples: 40 * 30 * u64::from(PASSES),
            holds: smallest > level && widest < 0.02,
        }
    });
    settle(&findings);
}
