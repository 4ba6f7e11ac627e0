//! The answer, in a sentence.

use crate::number::{percent, ratio};
use crate::results::{Estimate, LEAST_ERROR, MethodResults, Metrics, ReferenceResults, Verdict};
use traylib_integrators::Method;

/// Chooses the method to use among methods that have been judged; `None` without any.
pub fn verdict(methods: &[MethodResults], reference: &ReferenceResults) -> Option<Verdict> {
    let first = methods.iter().find(|method| is_best(method))?;
    let exact = exact(methods, reference);
    let distrust = distrust(methods, reference);
    // Without noise, with light lost by all, or held against something wrong, no time
    // tells one from the other.
    let best = (!first.biased && exact.is_empty() && distrust.is_none()).then_some(first);
    let rivals = best.map_or_else(Vec::new, |_| rivals(methods));
    let mut sentences = vec![match best {
        Some(best) => lead(best, &rivals, methods),
        None => distrust.unwrap_or_else(|| without_best(&exact)),
    }];
    sentences.extend(methods.iter().filter_map(planned));
    sentences.extend(alarms(methods));
    sentences.extend(methods.iter().filter_map(loss));
    sentences.extend(unseen(methods));
    sentences.extend(doubt(reference));
    Some(Verdict {
        best: best.map(|best| best.name.clone()),
        rivals: rivals.into_iter().map(String::from).collect(),
        sentence: sentences.join(" "),
    })
}

/// Returns the verdict that there is no answer, and why; `unseen` is light that no method sees.
pub fn no_verdict(why: &str, unseen: &[String], reference: &ReferenceResults) -> Verdict {
    let mut sentences = vec![format!("Nothing can be compared: {why}.")];
    sentences.extend(nobody_sees(&unseen.iter().map(String::as_str).collect::<Vec<_>>()));
    sentences.extend(doubt(reference));
    Verdict { best: None, rivals: Vec::new(), sentence: sentences.join(" ") }
}

fn is_best(method: &MethodResults) -> bool {
    method.cost_ratio == Estimate { value: 1.0, low: 1.0, high: 1.0 }
}

fn rivals(methods: &[MethodResults]) -> Vec<&str> {
    let near = |m: &Estimate| !m.knows_low() || m.low <= 1.0;
    let near = methods.iter().filter(|m| !is_best(m) && !m.biased && near(&m.cost_ratio));
    near.map(|m| m.name.as_str()).collect()
}

/// Finds the methods whose pictures do not differ from the reference by more than its rounding.
fn exact<'a>(methods: &'a [MethodResults], reference: &ReferenceResults) -> Vec<&'a str> {
    let exact = |m: &&MethodResults| m.metrics.rel_mse + reference.own_error <= LEAST_ERROR;
    methods.iter().filter(exact).map(|m| m.name.as_str()).collect()
}

/// Says why the reference is not to be trusted; `None` if it is.
fn distrust(methods: &[MethodResults], reference: &ReferenceResults) -> Option<String> {
    let witness = methods.iter().find(|m| Some(&m.name) == reference.doubted_by.as_ref())?;
    let Metrics { bias, bias_z, noise_share, .. } = witness.metrics;
    let side = if bias < 0.0 { "darker" } else { "brighter" };
    let z = format!("{bias_z:+.1}").replace('-', "−");
    Some(format!(
        "No verdict: the reference is noisy or shows another scene. Of the error of {}, the \
         least where no light is lost, {} stay however often it renders, and its pictures \
         are {} {side} (z = {z}).",
        witness.name,
        percent(1.0 - noise_share),
        percent(bias.abs()),
    ))
}

fn without_best(exact: &[&str]) -> String {
    match listed(exact) {
        Some(names) => format!(
            "No factor can be told: pictures of {names} do not differ from the reference at all."
        ),
        None => "No verdict: every method here loses light, so none reaches every error.".into(),
    }
}

fn lead(best: &MethodResults, rivals: &[&str], all: &[MethodResults]) -> String {
    let mut names = vec![best.name.as_str()];
    names.extend(rivals);
    let named = listed(&names).unwrap_or_default();
    let times = times(all, &names).join(", ");
    match (rivals.is_empty(), times.is_empty()) {
        (true, true) if all.len() == 1 => format!("{named} alone was compared."),
        (true, true) => format!("{named} reaches a given error soonest."),
        (true, false) => format!("{named} reaches a given error soonest: {times}."),
        (false, true) => format!("{named} cannot be told apart."),
        (false, false) => format!("{named} cannot be told apart; against {}: {times}.", best.name),
    }
}

/// Says how much longer the other methods take, each without settings of its own, the shortest time
/// first.
fn times(all: &[MethodResults], told: &[&str]) -> Vec<String> {
    let mut others: Vec<&MethodResults> = all
        .iter()
        .filter(|m| !told.contains(&m.name.as_str()) && !m.biased && !is_set(&m.name))
        .collect();
    others.sort_by(|a, b| a.cost_ratio.value.total_cmp(&b.cost_ratio.value));
    others.into_iter().map(|m| format!("{} takes {}", m.name, ratio(m).as_long())).collect()
}

/// Tells whether a name is that of a method with settings that not every chart compares.
fn is_set(name: &str) -> bool {
    name.parse().is_ok_and(|method: Method| !Method::COMPARED.contains(&method))
}

/// Says what a plan chose and how long that took; `None` without a plan.
fn planned(method: &MethodResults) -> Option<String> {
    let plans: Vec<&str> = method.plans.iter().map(String::as_str).collect();
    let chose = format!("{} chose {}", method.name, listed(&plans)?);
    Some(if is_best(method) || method.biased {
        format!("{chose}.")
    } else {
        format!("{chose} and took {}, its plan included.", ratio(method).as_long())
    })
}

/// Names the methods whose values seem to have no variance, if any.
fn alarms(methods: &[MethodResults]) -> Option<String> {
    let alarming: Vec<&str> =
        methods.iter().filter(|m| m.stability.alarm).map(|m| m.name.as_str()).collect();
    let names = listed(&alarming)?;
    Some(format!("No error bar holds for {names}: such values seem to have no variance."))
}

/// Names the light that a method loses and others see; `None` if it loses none.
fn loss(method: &MethodResults) -> Option<String> {
    let longer = |edges: u32| {
        format!("all paths of more than {edges} edge{}", if edges == 1 { "" } else { "s" })
    };
    let blind = method.blind.iter().cloned();
    let lost: Vec<String> = blind.chain(method.longest_path.map(longer)).collect();
    method.biased.then(|| format!("{} loses light: {}.", method.name, lost.join(" and ")))
}

/// Names the light to which even the methods without bias are blind, if any.
fn unseen(methods: &[MethodResults]) -> Option<String> {
    let mut spots: Vec<&str> = Vec::new();
    for spot in methods.iter().filter(|m| !m.biased).flat_map(|m| &m.blind) {
        if !spots.contains(&spot.as_str()) {
            spots.push(spot);
        }
    }
    nobody_sees(&spots)
}

fn nobody_sees(spots: &[&str]) -> Option<String> {
    Some(format!("No method here sees {}.", listed(spots)?))
}

/// States in how many tiles the methods of the reference differ; `None` if they agree.
fn doubt(reference: &ReferenceResults) -> Option<String> {
    let agreement = reference.agreement.as_ref().filter(|agreement| agreement.refused > 0)?;
    let [a, b] = &agreement.methods;
    let (refused, tiles) = (agreement.refused, agreement.tiles);
    Some(format!("The reference is {a} alone: {b} differs from it in {refused} of {tiles} tiles."))
}

/// `a, b and c`.
fn listed(names: &[&str]) -> Option<String> {
    let (last, others) = names.split_last()?;
    if others.is_empty() {
        return Some((*last).to_string());
    }
    Some(format!("{} and {last}", others.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Other renderers, whose names spell no method, are as they are.
    #[test]
    fn settings_of_its_own_are_told_by_the_spelling() {
        let plain = ["bdpt", "directlight", "directlight --combine", "trace --jitter", "other"];
        assert!(!plain.into_iter().any(is_set));
        let set = ["bdpt --no-connections", "directlight --combine --heuristic balance"];
        assert!(set.into_iter().all(is_set));
    }
}
