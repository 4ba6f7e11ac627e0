use super::*;
use crate::options::Options;
use clap::Parser;
use traylib_integrators::{Settings, render_to_end};

fn artist(arguments: &str) -> Artist {
    let words = ["realtime"].into_iter().chain(arguments.split_whitespace());
    Artist::new(Arc::new(Stage::load(&Options::parse_from(words)).unwrap())).unwrap()
}

fn wanted(artist: &Artist, method: Method) -> Wanted {
    Wanted { camera: artist.stage.loaded().scene.camera().settings(), method }
}

fn frames(artist: &mut Artist, wanted: &Wanted) -> Vec<Frame> {
    let (stale, end) = (Control::default(), Control::default());
    let mut frames = Vec::new();
    artist.draw(wanted, &stale, &end, &mut |frame| frames.push(frame)).unwrap();
    frames
}

#[test]
fn the_last_frame_is_the_picture_of_the_programs() {
    for (method, spp) in [(Method::TRACE, 1), (Method::BDPT, 3), (Method::PARTICLE, 2)] {
        let mut artist = artist(&format!("cornell --resolution 40x30 --spp {spp} --seed 5"));
        let wanted = wanted(&artist, method);
        let frames = frames(&mut artist, &wanted);
        let last = frames.last().unwrap();
        let settings = Settings { spp, seed: 5, ..Settings::default() };
        let scene = &artist.stage.loaded().scene;
        let rendering = render_to_end(scene, &*method.build(), &settings).unwrap();
        assert!(last.is_of(&wanted) && last.passes == spp, "{method}");
        assert_eq!(last.radiance, rendering.film.develop(), "{method}");
        assert_eq!(last.statistics, rendering.statistics, "{method}");
    }
}

/// A plan is made for the view, and then its choice is what is seen.
#[test]
fn a_plan_chooses_for_what_is_seen() {
    let mut artist = artist("cornell --resolution 96x72 --spp 64");
    let wanted = wanted(&artist, Method::AUTO);
    let (stale, end) = (Control::default(), Control::default());
    let mut seen = Vec::new();
    let mut show = |frame: Frame| {
        if frame.coarseness == 1 {
            stale.cancel();
        }
        seen.push((frame.coarseness, frame.method, frame.wanted == wanted));
    };
    artist.draw(&wanted, &stale, &end, &mut show).unwrap();
    let chosen = planned(&artist.stage, &wanted, &Control::default()).unwrap().unwrap();
    assert!(chosen.auto().is_none(), "{chosen}");
    assert_eq!(seen, [(8, Method::AUTO, true), (1, chosen, true)]);
}

#[test]
fn a_preview_comes_first_while_nothing_is_known_and_a_quick_picture_does_without() {
    let mut artist = artist("spheres --resolution 40x30");
    let wanted = wanted(&artist, Method::TRACE);
    let coarse = |frames: &[Frame]| frames.iter().map(|frame| frame.coarseness).collect::<Vec<_>>();
    let first = frames(&mut artist, &wanted);
    assert_eq!(coarse(&first), [8, 1]);
    assert_eq!((first[0].radiance.width(), first[0].radiance.height()), (5, 4));
    assert!(!first[0].is_of(&wanted));
    assert_eq!(artist.pace.0, Method::TRACE);
    artist.pace.1.measure(artist.stage.loaded().scene.camera(), Duration::from_millis(1));
    assert_eq!(coarse(&frames(&mut artist, &wanted)), [1]);
}

#[test]
fn stale_views_have_their_preview_alone_and_nothing_is_drawn_after_the_end() {
    let mut artist = artist("cornell --resolution 40x30");
    let wanted = wanted(&artist, Method::BDPT);
    let draw = |artist: &mut Artist, end: &Control| {
        let stale = Control::default();
        stale.cancel();
        let mut previews = Vec::new();
        artist.draw(&wanted, &stale, end, &mut |frame| previews.push(frame.coarseness)).unwrap();
        previews
    };
    let end = Control::default();
    assert_eq!(draw(&mut artist, &end), [8]);
    artist.pace.1.measure(artist.stage.loaded().scene.camera(), Duration::from_secs(1));
    assert_eq!(draw(&mut artist, &end), [5]);
    end.cancel();
    assert_eq!(draw(&mut artist, &end), [0; 0]);
}
