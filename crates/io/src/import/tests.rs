use super::*;
use crate::report::{Report, SourceText};
use crate::ron_scene::{decode, syntax};
use crate::source::Location;
use std::sync::Arc;
use traylib_math::Sampler;

/// Imports a text as if it were a built-in scene file, and shows what is wrong.
fn outcome(text: String) -> Result<(), String> {
    let source = Arc::new(SourceText { name: "changed.ron".to_string(), text });
    let document = decode(&source.text)
        .map_err(|error| Report::from(syntax::problem(&source, &error)).to_string())?;
    let location = Location::BuiltIn("changed.ron".to_string());
    let files = [SceneFile { location, source, document }];
    import(&files, LoadOptions::default(), false).map(drop).map_err(|error| error.to_string())
}

/// Characters that make trouble, among others.
fn character(sampler: &mut Sampler) -> char {
    const LIKELY: [char; 18] = [
        '(', ')', '[', ']', '{', '}', '"', '\\', '/', '*', ',', ':', '-', '9', 'e', '\n', '\t', '€',
    ];
    LIKELY[(sampler.next_1d() * LIKELY.len() as f32) as usize]
}

#[test]
fn changed_texts_give_a_scene_or_a_report() {
    let texts = [
        include_str!("../../../../scenes/cornell.ron"),
        include_str!("../../../../scenes/hangar.ron"),
    ];
    let mut sampler = Sampler::numbered(4, 0);
    let mut failures = 0;
    for text in texts {
        assert_eq!(outcome(text.to_string()), Ok(()));
        for _ in 0..1500 {
            let mut changed: Vec<char> = text.chars().collect();
            for _ in 0..3 {
                let place = (sampler.next_1d() * changed.len() as f32) as usize;
                changed[place] = character(&mut sampler);
            }
            if let Err(report) = outcome(changed.into_iter().collect()) {
                failures += 1;
                assert!(report.contains("--> changed.ron"), "{report}");
            }
        }
    }
    // The test would be void if nothing failed, or everything.
    assert!((500..2900).contains(&failures), "{failures}");
}

#[test]
fn windows_line_ends_are_understood() {
    let text = include_str!("../../../../scenes/cornell.ron").replace('\n', "\r\n");
    assert_eq!(outcome(text), Ok(()));
    let report = outcome("(\r\n  spp: 0,\r\n)".to_string()).unwrap_err();
    assert!(report.contains(" --> changed.ron:2:8\n"), "{report}");
}
