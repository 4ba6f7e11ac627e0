//! Common random numbers: a technique that is switched off takes nothing from the
//! others.

use std::ops::ControlFlow;
use traylib_integrators::{
    Bdpt, Control, LightSampling, Rendering, Report, Settings, Technique, Techniques, render,
};
use traylib_math::Rgb;
use traylib_tests::findings::{Finding, settle};
use traylib_tests::laws::verdict::same_bits;
use traylib_tests::still_life::still_life;

/// The pictures of all techniques, by these techniques together.
fn pictures(techniques: Techniques) -> Rendering {
    let bdpt = Bdpt { techniques, report: Report::Techniques, ..Bdpt::default() };
    let settings = Settings { spp: 2, seed: 201, threads: 1, ..Settings::default() };
    let observe = &mut |_: &traylib_integrators::Progress<'_>| ControlFlow::Continue(());
    render(&still_life(1.0), &bdpt, &settings, &Control::default(), observe).expect("one thread")
}

/// Tells whether the raw picture of a technique must stay as it is. Whether a
/// connection is tried depends on what the camera path has found by other
/// techniques (connection roulette), so connections are left out; light samples are, where
/// only some lamps are sampled.
fn must_stay(technique: Technique, techniques: Techniques) -> bool {
    let Technique { s, t, weighted, .. } = technique;
    let all_lamps = techniques.light_samples == LightSampling::All;
    !weighted && (s == 0 || t == 1 || (s == 1 && all_lamps))
}

/// Returns how many values of the raw pictures differ from those of all techniques together, and of
/// how many.
fn compared(all: &Rendering, techniques: Techniques) -> (usize, usize) {
    let some = pictures(techniques);
    let (mut different, mut values) = (0, 0);
    let all = all.film.develop_layers();
    for (layer, picture) in some.film.develop_layers() {
        let technique = Technique::of_layer(layer);
        if !must_stay(technique, techniques) {
            continue;
        }
        let before = all.get(&layer).expect("what a part finds, all together find");
        for (a, b) in before.values().iter().zip(picture.values()) {
            let bits = |rgb: &Rgb| rgb.to_array().map(f32::to_bits);
            different += usize::from(bits(a) != bits(b));
            values += usize::from(!b.is_black());
        }
    }
    (different, values)
}

#[test]
fn techniques_switched_off_do_not_move_the_others() {
    let all = pictures(Techniques::ALL);
    let masks = [
        ("without hits", Techniques { hits: false, ..Techniques::ALL }),
        (
            "without light samples",
            Techniques { light_samples: LightSampling::Off, ..Techniques::ALL },
        ),
        ("without connections", Techniques { connections: false, ..Techniques::ALL }),
        ("without splats", Techniques { splats: false, ..Techniques::ALL }),
        ("those of puremc", Techniques::PURE_MC),
        ("those of directlight", Techniques::COMBINED),
        ("those of particle", Techniques::PARTICLE),
    ];
    let finding = |(name, techniques): (&str, Techniques)| -> Finding {
        let (different, values) = compared(&all, techniques);
        same_bits(format!("raw pictures of techniques, {name}"), different, values)
    };
    settle(&masks.map(finding));
}
