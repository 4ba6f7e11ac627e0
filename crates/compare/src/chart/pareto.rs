//! The Pareto front of the settings: those that nothing else beats in both time and error.

use crate::chart::axis::{Decades, visible};
use crate::chart::canvas::{BREADTH, svg};
use crate::chart::colour::{INK, PALE};
use crate::chart::plot::{Plot, Stroke};
use crate::chart::styles::{MethodStyles, Style};
use crate::results::SceneResults;
use maud::Markup;

const SIZE: (u32, u32) = (BREADTH, 720);

/// A setting: time, error and who it is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Setting {
    at: (f64, f64),
    name: String,
    /// True if the reference is good enough here and its method bears no badge.
    solid: bool,
}

/// Settings by whether another is as fast and as exact.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Front {
    /// Unbeaten, fastest first.
    front: Vec<Setting>,
    /// All others.
    beaten: Vec<Setting>,
}

impl Front {
    /// Names of the methods on the front, fastest first.
    pub(crate) fn names(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for setting in &self.front {
            if !names.contains(&setting.name.as_str()) {
                names.push(&setting.name);
            }
        }
        names
    }

    fn stairs(&self) -> Vec<(f64, f64)> {
        let at: Vec<_> = self.front.iter().map(|setting| setting.at).collect();
        let steps = at.windows(2).flat_map(|pair| [(pair[1].0, pair[0].1), pair[1]]);
        at.first().copied().into_iter().chain(steps).collect()
    }
}

/// The front over all points of all methods.
pub(crate) fn front(scene: &SceneResults) -> Front {
    let mut settings: Vec<Setting> = settings(scene).collect();
    settings.sort_by(|a, b| a.at.0.total_cmp(&b.at.0).then(a.at.1.total_cmp(&b.at.1)));
    let mut found = Front::default();
    let mut least = f64::INFINITY;
    for setting in settings {
        if setting.at.1 < least {
            least = setting.at.1;
            found.front.push(setting);
        } else {
            found.beaten.push(setting);
        }
    }
    found
}

fn settings(scene: &SceneResults) -> impl Iterator<Item = Setting> {
    scene.methods.iter().flat_map(|method| {
        let points = method.points.iter().chain(&method.budgets);
        let drawn = points.filter(|point| visible(point));
        drawn.map(|point| Setting {
            at: (point.seconds, point.error.value),
            name: method.name.clone(),
            solid: point.solid && method.badge().is_none(),
        })
    })
}

/// The front as a staircase, what it beats in grey.
pub(crate) fn pareto(scene: &SceneResults, front: &Front, styles: &MethodStyles) -> Markup {
    let label =
        format!("Settings on {}: those that no other beats in both time and error", scene.name);
    svg(&label, SIZE, |area| {
        let all = || front.front.iter().chain(&front.beaten).map(|setting| setting.at);
        let x = Decades::around(all().map(|at| at.0));
        let y = Decades::around(all().map(|at| at.1));
        let plot = Plot::new(area, (x, "seconds"), (y, "relMSE"))?;
        for Setting { at, name, solid } in &front.beaten {
            let Style { shape, .. } = styles.style(name);
            plot.marker(*at, (shape, PALE), 7.0, *solid)?;
        }
        plot.line(&front.stairs(), INK, 3, Stroke::Solid)?;
        for Setting { at, name, solid } in &front.front {
            plot.marker(*at, styles.style(name).mark(), 10.0, *solid)?;
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setting(seconds: f64, error: f64) -> Setting {
        Setting { at: (seconds, error), name: format!("{seconds}"), solid: true }
    }

    #[test]
    fn stairs_go_right_then_down() {
        let front = Front { front: vec![setting(1.0, 4.0), setting(2.0, 3.0)], beaten: vec![] };
        assert_eq!(front.stairs(), [(1.0, 4.0), (2.0, 4.0), (2.0, 3.0)]);
        assert_eq!(front.names(), ["1", "2"]);
    }
}
