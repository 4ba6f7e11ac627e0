//! The page by its text: what it says, that it is whole, and that no result makes it
//! panic or draw nonsense.

#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]

use std::collections::BTreeSet;
use traylib_compare::judge::{no_verdict, verdict};
use traylib_compare::page::{charts as chart_files, page};
use traylib_compare::results::{Estimate, Point, Results};
use traylib_compare::sample::sample;
use traylib_compare::table::table;

fn text(results: &Results) -> String {
    page(results, &sample().1)
}

/// Returns the texts between `<svg` and `</svg>`.
fn charts(page: &str) -> Vec<&str> {
    let parts = page.split("<svg").skip(1);
    parts.map(|part| part.split("</svg>").next().unwrap()).collect()
}

/// No attribute holds what is not a number.
fn assert_sound(page: &str) {
    for chart in charts(page) {
        for nonsense in ["NaN", "inf\"", "inf,", "inf "] {
            assert!(!chart.contains(nonsense), "{nonsense} in {chart}");
        }
    }
    assert!(!page.contains("could not be drawn"));
}

#[test]
fn every_method_and_every_verdict_is_there() {
    let results = sample().0;
    let page = text(&results);
    for scene in &results.scenes {
        assert!(page.contains(&scene.verdict.sentence));
        for method in &scene.methods {
            assert!(page.contains(&method.name), "{}", method.name);
        }
        for point in &scene.outside {
            assert!(page.contains(&point.name));
        }
    }
    assert!(page.contains("is blind here"));
    assert!(page.contains("a lamp mirrored twice"));
    assert!(page.contains("<td class=\"alarm\">no variance</td>"));
    assert!(page.contains(&results.how.command));
    assert_sound(&page);
}

/// All of the methods' names in tables and figures have their badge, and so have their
/// bars, which are outlines.
#[test]
fn who_does_not_see_all_light_is_marked_everywhere() {
    let results = sample().0;
    let page = text(&results);
    for (name, badge) in [("bdpt --max-depth 6", "biased"), ("particle", "blind")] {
        let scene = page.split("<section").nth(1).unwrap();
        let marked = format!("</svg>{name}</span> <span class=\"tag\">{badge}</span>");
        assert_eq!(
            scene.matches(&format!("</svg>{name}</span>")).count(),
            scene.matches(&marked).count()
        );
        assert!(scene.matches(&marked).count() > 5);
        let bars: Vec<&str> = charts(scene).into_iter().filter(|c| c.contains("<rect")).collect();
        let marked = format!("{name} ({badge})");
        assert_eq!(bars.iter().filter(|chart| chart.contains(&marked)).count(), 3, "{name}");
    }
    // Of five bars three are filled, in each of three charts.
    let scene = page.split("<section").nth(1).unwrap();
    let bars = charts(scene).into_iter().filter(|chart| chart.contains("<rect"));
    let filled: Vec<usize> = bars.map(|chart| chart.matches("opacity=\"0.8\"").count()).collect();
    assert_eq!(filled[..3], [3; 3], "{filled:?}");
    let main = charts(page.split("class=\"main-chart\"").nth(1).unwrap())
        .into_iter()
        .find(|chart| chart.contains("relMSE"))
        .unwrap();
    assert!(main.contains("\nblind\n") && main.contains("\nbiased\n"));
}

/// The same words in the sentence of a verdict, in the tables and at the bars.
#[test]
fn a_ratio_is_the_same_number_everywhere() {
    let mut results = sample().0;
    results.scenes.truncate(1);
    results.scenes[0].methods[3].cost_ratio = Estimate { value: 1.31, low: 1.29, high: 1.33 };
    let reference = results.scenes[0].reference.clone();
    let verdict = verdict(&results.scenes[0].methods, &reference).unwrap();
    results.scenes[0].verdict = verdict;
    let sentence = &results.scenes[0].verdict.sentence;
    assert!(sentence.contains("puremc takes 1.31 times as long (1.29 to 1.33)"), "{sentence}");
    let page = text(&results);
    assert!(page.contains("<td>1.31 (1.29 to 1.33)</td>"));
    assert!(page.contains("puremc  1.31 times as long (1.29 to 1.33)"));
    let terminal = table(&results);
    assert!(terminal.contains(" 1.31 (1.29 to 1.33) "), "{terminal}");
    for name in ["bdpt --max-depth 6 (biased) ", "particle (blind) "] {
        assert!(terminal.contains(name), "{terminal}");
    }
}

/// A black reference leaves no chart and no factor, and the reason stands there twice.
#[test]
fn a_scene_without_runs_says_why() {
    let mut results = sample().0;
    let why = "the reference is black";
    for scene in &mut results.scenes {
        scene.verdict = no_verdict(why, &[], &scene.reference);
        scene.methods.clear();
        scene.outside.clear();
        scene.lengths.clear();
    }
    results.oracle = None;
    let page = page(&results, &[]);
    assert!(page.matches("Nothing can be compared: the reference is black.").count() == 4);
    assert!(charts(&page).is_empty());
    assert!(table(&results).contains(why) && !table(&results).contains("x time"));
}

#[test]
fn without_a_best_no_factor_is_drawn() {
    let mut results = sample().0;
    for scene in &mut results.scenes {
        scene.verdict.best = None;
        scene.verdict.sentence = "No factor can be told.".into();
    }
    let page = text(&results);
    assert_sound(&page);
    assert!(!page.contains(" times as long") && !page.contains("1/(error × seconds), best = 1"));
    results.oracle = None;
    let terminal = table(&results);
    let line = terminal.lines().find(|line| line.contains("puremc")).unwrap();
    assert_eq!(line.split_whitespace().nth(1), Some("-"), "{line}");
}

#[test]
fn nothing_is_asked_from_outside() {
    let page = text(&sample().0).replace("http://www.w3.org/2000/svg", "");
    for outside in ["http:", "https:", "src=\"//", "url(", "@import", "<link"] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert!(page.contains("default-src 'none'"));
}

#[test]
fn without_its_script_nothing_but_the_wipe_is_missing() {
    let page = text(&sample().0);
    assert_eq!(page.matches(" hidden").count(), page.matches("class=\"wipe\" hidden").count());
    assert_eq!(page.matches("class=\"wipe\" hidden").count(), 2);
    for pictures in sample().1 {
        assert!(page.matches("<img ").count() > 2 * pictures.methods.len());
    }
}

#[test]
fn an_interrupted_comparison_says_so() {
    let mut results = sample().0;
    assert!(text(&results).contains("Interrupted."));
    results.complete = true;
    assert!(!text(&results).contains("Interrupted."));
}

#[test]
fn names_and_sentences_are_text_not_markup() {
    let mut results = sample().0;
    for scene in &mut results.scenes {
        scene.name = "<b>\"a&b".into();
        scene.methods[0].name = "<script>x".into();
    }
    let page = text(&results);
    assert!(!page.contains("<b>\"a&b") && !page.contains("<script>x"));
    assert!(page.contains("&lt;b&gt;"));
}

#[test]
fn times_that_do_not_exist_have_a_word() {
    let page = text(&sample().0);
    let times = page.split("Time to reach an error").nth(1).unwrap();
    let times = times.split("</table>").next().unwrap();
    // Why is at the name, and the terminal has the same word.
    assert!(times.contains("<td>never</td>") && !times.contains("<td>blind</td>"), "{times}");
    assert!(times.contains("<td>210 ms (183–241)</td>"), "{times}");
    let mut results = sample().0;
    results.oracle = None;
    let terminal = table(&results);
    let line = terminal.lines().find(|line| line.contains("particle (blind)")).unwrap();
    // How sure a bias is stands beside it.
    assert!(line.contains("never") && line.contains("-41.00 % -212.0"), "{line}");
}

#[test]
fn hollow_points_have_paper_inside() {
    let paper = |page: &str| charts(page)[5].matches("#FFFFFF").count();
    let (mut solid, mut hollow) = (sample().0, sample().0);
    let set = |results: &mut Results, to: bool| {
        for method in &mut results.scenes[0].methods {
            method.points.iter_mut().chain(&mut method.budgets).for_each(|p| p.solid = to);
        }
    };
    set(&mut solid, true);
    set(&mut hollow, false);
    assert!(paper(&text(&hollow)) > paper(&text(&solid)));
}

fn spoil(point: &mut Point, value: f64) {
    point.error = Estimate { value, low: value, high: value };
    (point.low, point.high) = (value, value);
}

#[test]
fn errors_without_a_logarithm_are_left_out() {
    for value in [0.0, -1e-9, f64::NAN, f64::INFINITY] {
        let mut results = sample().0;
        for method in results.scenes.iter_mut().flat_map(|scene| &mut scene.methods) {
            spoil(&mut method.points[0], value);
            spoil(method.budgets.last_mut().unwrap(), value);
            method.cost_ratio.value = value;
            method.error_per_pass.low = value;
            method.seconds_per_pass.high = value;
        }
        results.scenes[0].outside[0].error = value;
        results.oracle.as_mut().unwrap().curves[0].points[0].theory = value;
        results.scenes[0].lengths[0].light = value;
        assert_sound(&text(&results));
    }
}

#[test]
fn all_of_a_scene_without_logarithms_still_makes_a_page() {
    let mut results = sample().0;
    for method in results.scenes.iter_mut().flat_map(|scene| &mut scene.methods) {
        method.points.iter_mut().chain(&mut method.budgets).for_each(|p| spoil(p, 0.0));
    }
    assert_sound(&text(&results));
}

#[test]
fn little_is_enough() {
    let mut results = sample().0;
    results.oracle = None;
    results.scenes.truncate(1);
    let scene = &mut results.scenes[0];
    scene.methods.truncate(1);
    scene.methods[0].points.truncate(1);
    scene.methods[0].budgets.clear();
    scene.methods[0].targets.clear();
    scene.outside.clear();
    scene.lengths.clear();
    scene.reference.agreement = None;
    let mut pictures = sample().1;
    pictures.truncate(1);
    pictures[0].techniques.clear();
    pictures[0].errors.clear();
    pictures[0].outside.clear();
    let page = page(&results, &pictures);
    assert_sound(&page);
    assert!(!page.contains("Inside bdpt"));
}

#[test]
fn nothing_at_all_is_a_page_too() {
    let mut results = sample().0;
    results.scenes[0].methods[0].points.clear();
    assert_sound(&page(&results, &[]));
    results.scenes.clear();
    results.oracle = None;
    assert!(page(&results, &[]).contains("How it was made"));
}

#[test]
fn numbers_of_any_size_fit() {
    let mut results = sample().0;
    for (i, method) in (0..).zip(&mut results.scenes[0].methods) {
        let factor = 1e3_f64.powi(i);
        for point in method.points.iter_mut().chain(&mut method.budgets) {
            point.seconds /= factor;
            point.error.value *= factor;
        }
    }
    assert_sound(&text(&results));
}

/// One rule for all intervals: where an end is not known, none is told or drawn.
#[test]
fn without_a_variance_there_is_no_high_end() {
    let page = text(&sample().0);
    let caustic = page.split("<section").nth(2).unwrap();
    let rows = caustic.split("<tr>").skip(1).map(|row| row.split("</tr>").next().unwrap());
    let rows: Vec<&str> = rows.filter(|row| row.contains("</svg>directlight</span>")).collect();
    let [times, costs, ..] = rows[..] else { panic!("{}", rows.len()) };
    // Three times, the ratio, and the error of a pass; the range of its times is no interval.
    assert_eq!((times.matches("at least").count(), times.matches('–').count()), (3, 0), "{times}");
    assert_eq!((costs.matches("at least").count(), costs.matches('–').count()), (2, 1), "{costs}");
    let whiskers = |chart: &&str| chart.matches("stroke-width=\"8\"").count();
    let bars: Vec<&str> = charts(caustic).into_iter().filter(|c| c.contains("<rect")).collect();
    // Of five: not at the best, which is one, and not here. Times of a pass are a range.
    assert_eq!(bars.iter().map(whiskers).collect::<Vec<_>>()[..3], [9, 12, 15]);
}

/// A marker over a text hides digits: `576 ms` would read `76 ms`.
#[test]
fn no_text_of_the_main_chart_lies_under_a_marker() {
    let page = text(&sample().0);
    let main = page.split("class=\"main-chart\"").nth(1).unwrap();
    let main = charts(main).into_iter().find(|chart| chart.contains("relMSE")).unwrap();
    let drawn = main.rfind("<polygon").unwrap();
    for words in ["\nblind\n", "\nother\n", "\n2.4 s\n"] {
        assert!(main.find(words).unwrap() > drawn, "{words}");
    }
    assert!(page.contains("paint-order:stroke;stroke:var(--paper)"));
}

/// For a paper: each chart is a document of its own that says what its lines are.
#[test]
fn every_chart_is_a_file_with_its_legend() {
    let results = sample().0;
    let files = chart_files(&results);
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    for name in ["cornell-error.svg", "caustic-error.svg", "cornell-efficiency.svg"] {
        assert!(names.contains(&name), "{names:?}");
    }
    assert_eq!(names.len(), 2 * 4 + 2, "{names:?}");
    for (name, chart) in &files {
        assert!(chart.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\""), "{name}");
        assert_eq!(chart.matches("<svg").count(), chart.matches("</svg>").count());
        assert!(!chart.contains("var(--"), "{name}");
        assert_sound(chart);
    }
    let error = &files[0].1;
    for method in &results.scenes[0].methods {
        assert!(error.contains(&format!("\n{}\n", method.marked_name())), "{}", method.name);
    }
}

/// As another reader of XML finds it: a chart has a line of its own colour for each method, whatever
/// that is called.
#[test]
fn every_chart_file_is_sound_xml_with_a_curve_a_method() {
    const SVG: &str = "http://www.w3.org/2000/svg";
    let mut results = sample().0;
    results.scenes[0].methods[0].name = "<script>&\"x".into();
    let files = chart_files(&results);
    for (name, chart) in &files {
        let document = roxmltree::Document::parse(chart).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(document.root_element().has_tag_name((SVG, "svg")), "{name}");
        let texts = document.descendants().filter(|node| node.has_tag_name((SVG, "text"))).count();
        assert!(texts > 5, "{name}: {texts}");
    }
    for scene in &results.scenes {
        let wanted = format!("{}-error.svg", scene.name);
        let (_, chart) = files.iter().find(|(name, _)| *name == wanted).unwrap();
        let document = roxmltree::Document::parse(chart).unwrap();
        // Curves alone are so thick.
        let curves =
            document.descendants().filter(|node| node.attribute("stroke-width") == Some("4"));
        let colours: BTreeSet<&str> = curves.filter_map(|node| node.attribute("stroke")).collect();
        assert_eq!(colours.len(), scene.methods.len(), "{wanted}: {colours:?}");
    }
}
