//! Tables that can be read, and pasted where Markdown is.

use crate::contest::{Build, RaySet, Score};
use crate::leaks::Leaks;
use crate::statistics::Median;

pub(crate) fn print_leaks(leaks: &[Leaks]) {
    let rays = leaks.first().map_or(0, |leaks| leaks.rays);
    println!("\n## Leaks: {rays} rays at corners and edges of a closed mesh\n");
    let row = |l: &Leaks| vec![l.name.to_owned(), l.nearest.to_string(), l.any_hit.to_string()];
    print(&["", "lost, nearest", "lost, any hit"], leaks.iter().map(row));
}

pub(crate) fn print_builds(builds: &[Build], triangles: usize) {
    println!();
    let each = |x: f64| x / triangles as f64;
    let row = |build: &Build| {
        vec![
            build.name.to_owned(),
            format!("{:.2}", build.seconds.value * 1e3),
            format!("{:.0}", each(build.seconds.value * 1e9)),
            format!("{:.2}", build.bytes as f64 * 1e-6),
            format!("{:.0}", each(build.bytes as f64)),
        ]
    };
    let heads = ["build", "ms of all threads", "ns a triangle", "MB", "bytes a triangle"];
    print(&heads, builds.iter().map(row));
}

pub(crate) fn print_scores(set: &RaySet, scores: &[Score], runs: u16) {
    println!("\n{}: {} rays, {runs} times\n", set.name, set.len());
    let row = |score: &Score| {
        let [watertight, fast] = score.ours_to_it.map(interval);
        let rate = format!("{:.2}", score.rate.value);
        vec![score.name.to_owned(), rate, watertight, fast, score.wrong.to_string()]
    };
    let heads = ["", "Mrays/s", "ours, watertight : it", "ours, fast : it", "wrong"];
    print(&heads, scores.iter().map(row));
}

fn interval(Median { value, low, high }: Median) -> String {
    format!("{value:.2} [{low:.2}, {high:.2}]")
}

/// The first column to the left, all others to the right.
fn print(heads: &[&str], rows: impl Iterator<Item = Vec<String>>) {
    let heads = heads.iter().map(|&head| head.to_owned()).collect();
    let rows: Vec<Vec<String>> = std::iter::once(heads).chain(rows).collect();
    let widths: Vec<usize> = (0..rows[0].len())
        .map(|column| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0))
        .collect();
    for (number, row) in rows.iter().enumerate() {
        println!("{}", line(row, &widths));
        if number == 0 {
            let rule = |(column, &width): (usize, &usize)| {
                if column == 0 { "-".repeat(width) } else { format!("{}:", "-".repeat(width - 1)) }
            };
            let rules: Vec<_> = widths.iter().enumerate().map(rule).collect();
            println!("{}", line(&rules, &widths));
        }
    }
}

fn line(cells: &[String], widths: &[usize]) -> String {
    let cell = |(column, (text, &width)): (usize, (&String, &usize))| {
        if column == 0 { format!("{text:<width$}") } else { format!("{text:>width$}") }
    };
    let cells: Vec<_> = cells.iter().zip(widths).enumerate().map(cell).collect();
    format!("| {} |", cells.join(" | "))
}
