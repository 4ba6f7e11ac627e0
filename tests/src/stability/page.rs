//! The table as a page to look at.

use crate::stability::expected::METHODS;
use crate::stability::judge::Verdict;
use crate::stability::run::{Pictures, Row};
use crate::stability::table::{Agreement, Judged, short};
use maud::{DOCTYPE, Markup, html};
use std::path::Path;
use traylib_io::{PictureInfo, Tone, save_picture};
use traylib_math::{Grid, Rgb};

const STYLE: &str = "body{font:14px system-ui;margin:2em;color:#222}\
table{border-collapse:collapse}td,th{border:1px solid #ccc;padding:.4em;vertical-align:top}\
img{width:96px;image-rendering:pixelated;display:block;background:#000}\
.ok,.ok-slow,.identical{background:#e6f4e6}.V,.sparks{background:#fdf3d8}.alarm,.blind{background:#f7dcdc}\
.unsettled{background:#e33}small{color:#555;display:block}";

/// The page; it shows the pictures that [`save_pictures`] leaves beside it.
pub fn page(rows: &[Row]) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head { meta charset="utf-8"; title { "Stability" } style { (STYLE) } }
            body {
                h1 { "Method × failure scene" }
                p {
                    "Pictures of one scene took about the same time. × is the time to relMSE 10⁻² \
                     over that of the best; α the tail index from the 256 and the 64 largest \
                     values; a star marks a corrected expectation."
                }
                table {
                    tr {
                        th { "scene" } th { "reference" }
                        @for method in METHODS { th { (method) } }
                    }
                    @for row in rows { (table_row(row)) }
                }
            }
        }
    };
    page.into_string()
}

fn table_row(row: &Row) -> Markup {
    let Some(first) = row.cells.first() else { return html! {} };
    html! {
        tr {
            th { (first.scene) small { (first.title) } }
            td { @if row.pictures.is_some() { img src=(file(&first.scene, "reference")) alt=""; } }
            @for method in METHODS {
                @match row.cells.iter().find(|cell| cell.method == method) {
                    Some(cell) => (table_cell(cell)),
                    None => td {},
                }
            }
        }
    }
}

fn table_cell(cell: &Judged) -> Markup {
    let mark = match cell.agreement() {
        Agreement::Expected => "",
        Agreement::Border => " ~",
        Agreement::Corrected(_) => " *",
        Agreement::Disagrees => " — unexpected",
    };
    html! {
        td class=(cell.verdict.to_string()) {
            @if cell.figures.is_some() { img src=(file(&cell.scene, &cell.method.to_string())) alt=""; }
            b { (cell.word()) (mark) }
            @if let Agreement::Corrected(reason) = cell.agreement() { small { (reason) } }
            @if let Verdict::Unsettled(what) = &cell.verdict { small { (what) } }
            @if let Some(f) = &cell.figures {
                small { "relMSE a pass " (short(f.rel_mse_per_pass)) }
                small { "worst of 16 / median " (short(f.worst_rel_mse / f.median_rel_mse)) }
                small { "α " (alpha(f.tail)) ", " (alpha(f.far_tail)) }
                small { "fireflies " (short(f.fireflies)) }
                @if let Some(slope) = f.slope { small { "slope " (format!("{:.3}", slope.slope)) } }
            }
            @for kind in &cell.announced { small { "announced: " (kind) } }
        }
    }
}

fn alpha(index: Option<traylib_statistics::tail::TailIndex>) -> String {
    index.map_or("—".into(), |index| index.alpha.map_or("∞".into(), short))
}

fn file(scene: &str, what: &str) -> String {
    format!("{scene}-{}.png", what.replace(" --", "-"))
}

/// Writes the pictures of a row beside the page.
///
/// # Errors
/// If one cannot be written.
pub fn save_pictures(folder: &Path, row: &Row) -> Result<(), traylib_io::Error> {
    let (Some(cell), Some(pictures)) = (row.cells.first(), &row.pictures) else { return Ok(()) };
    let Pictures { reference, equal_time } = pictures;
    let exposure = (0.4 / reference.mean()) as f32;
    let save = |what: &str, pixels: &[f64], spp: u32| {
        let grey: Vec<Rgb> = pixels.iter().map(|&value| Rgb::splat(value as f32)).collect();
        let height = pixels.len() / reference.width;
        let Some(grid) = Grid::from_values(reference.width, height, grey) else { return Ok(()) };
        let info = PictureInfo {
            exposure,
            tone: Tone::Linear,
            program: "stability".into(),
            integrator: what.into(),
            command: String::new(),
            scene: cell.scene.clone(),
            seed: 1,
            spp: u64::from(spp),
            frame: None,
            rejected_samples: 0,
        };
        save_picture(&folder.join(file(&cell.scene, what)), &grid, &info)
    };
    save("reference", &reference.pixels, 0)?;
    equal_time
        .iter()
        .try_for_each(|(method, passes, pixels)| save(&method.to_string(), pixels, *passes))
}
