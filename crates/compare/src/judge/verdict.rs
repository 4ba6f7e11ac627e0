//! The answer, in a sentence.

use crate::bootstrap::NOTHING_KNOWN;
use crate::page::number::rounded;
use crate::results::{Estimate, MethodResults, ReferenceResults, Verdict};

/// Which method to use, from methods that have been judged; `None` without any.
pub fn verdict(methods: &[MethodResults], reference: &ReferenceResults) -> Option<Verdict> {
    let best = methods.iter().find(|method| is_best(method))?;
    let rivals: Vec<&str> = methods
        .iter()
        .filter(|m| !is_best(m) && !m.biased && m.cost_ratio.low <= 1.0)
        .map(|m| m.name.as_str())
        .collect();
    let mut sentences = vec![lead(best, &rivals, methods)];
    sentences.extend(alarms(methods));
    sentences.extend(methods.iter().filter_map(blindness));
    sentences.extend(doubt(reference));
    Some(Verdict {
        best: best.name.clone(),
        rivals: rivals.into_iter().map(String::from).collect(),
        sentence: sentences.join(" "),
    })
}

fn is_best(method: &MethodResults) -> bool {
    method.cost_ratio == Estimate { value: 1.0, low: 1.0, high: 1.0 }
}

fn lead(best: &MethodResults, rivals: &[&str], all: &[MethodResults]) -> String {
    let mut names = vec![best.name.as_str()];
    names.extend(rivals);
    let named = listed(&names).unwrap_or_default();
    let times = times(all, &names).join(", ");
    match (rivals.is_empty(), times.is_empty()) {
        (true, true) => format!("{named} reaches a given error soonest."),
        (true, false) => format!("{named} reaches a given error soonest: {times}."),
        (false, true) => format!("{named} cannot be told apart."),
        (false, false) => format!("{named} cannot be told apart; against {}: {times}.", best.name),
    }
}

/// How much longer the other programs take, each in its plain setting, the shortest
/// time first.
fn times(all: &[MethodResults], told: &[&str]) -> Vec<String> {
    let mut others: Vec<&MethodResults> = all
        .iter()
        .filter(|m| !told.contains(&m.name.as_str()) && !m.biased && !m.name.contains(':'))
        .collect();
    others.sort_by(|a, b| a.cost_ratio.value.total_cmp(&b.cost_ratio.value));
    others.into_iter().map(needs).collect()
}

fn needs(method: &MethodResults) -> String {
    let Estimate { value, low, high } = method.cost_ratio;
    let name = &method.name;
    if method.stability.alarm || high >= NOTHING_KNOWN * value {
        return format!("{name} takes at least {} times as long", rounded(low));
    }
    let [value, low, high] = [value, low, high].map(rounded);
    format!("{name} takes {value} times as long ({low} to {high})")
}

/// Whose values seem to have no variance.
fn alarms(methods: &[MethodResults]) -> Option<String> {
    let alarming: Vec<&str> =
        methods.iter().filter(|m| m.stability.alarm).map(|m| m.name.as_str()).collect();
    let names = listed(&alarming)?;
    Some(format!("No error bar holds for {names}: such values seem to have no variance."))
}

/// What a method cannot see and others can.
fn blindness(method: &MethodResults) -> Option<String> {
    let lost = (method.biased && !method.blind.is_empty()).then(|| method.blind.join(" and "))?;
    Some(format!("{} loses light: {lost}.", method.name))
}

/// What stands against the reference.
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
