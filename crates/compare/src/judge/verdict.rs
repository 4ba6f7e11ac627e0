//! The answer, in a sentence.

use crate::results::{Estimate, MethodResults, ReferenceResults, Verdict};
use traylib_tests::stability::table::short;

/// Which method to use, from methods that have been judged; `None` without any.
pub fn verdict(methods: &[MethodResults], reference: &ReferenceResults) -> Option<Verdict> {
    let best = methods.iter().find(|method| is_best(method))?;
    let rivals: Vec<&MethodResults> =
        methods.iter().filter(|m| !is_best(m) && !m.biased && m.cost_ratio.low <= 1.0).collect();
    let mut sentences = vec![lead(best, &rivals, methods)];
    sentences.extend(methods.iter().filter_map(against));
    sentences.extend(doubt(reference));
    Some(Verdict {
        best: best.name.clone(),
        rivals: rivals.iter().map(|method| method.name.clone()).collect(),
        sentence: sentences.join(" "),
    })
}

fn is_best(method: &MethodResults) -> bool {
    method.cost_ratio == Estimate { value: 1.0, low: 1.0, high: 1.0 }
}

fn lead(best: &MethodResults, rivals: &[&MethodResults], all: &[MethodResults]) -> String {
    let names: Vec<&str> =
        [best].into_iter().chain(rivals.iter().copied()).map(|m| m.name.as_str()).collect();
    let beaten: Vec<&MethodResults> = all
        .iter()
        .filter(|m| !names.contains(&m.name.as_str()) && !m.biased && !m.name.contains(':'))
        .collect();
    let first = match names.as_slice() {
        [alone] => format!("{alone} reaches a given error soonest"),
        [one, other] => format!("{one} and {other} cannot be told apart"),
        [many @ .., last] => format!("{} and {last} cannot be told apart", many.join(", ")),
        [] => String::new(),
    };
    let mut beaten = beaten;
    beaten.sort_by(|a, b| a.cost_ratio.value.total_cmp(&b.cost_ratio.value));
    let times: Vec<String> = beaten.iter().map(|method| needs(method)).collect();
    match (times.is_empty(), names.len()) {
        (true, _) => format!("{first}."),
        (false, 1) => format!("{first}: {}.", times.join(", ")),
        (false, _) => format!("{first}; against {}: {}.", best.name, times.join(", ")),
    }
}

fn needs(method: &MethodResults) -> String {
    let Estimate { value, low, high } = method.cost_ratio;
    let [value, low, high] = [value, low, high].map(short);
    format!("{} takes {value} times as long ({low} to {high})", method.name)
}

/// What stands against a method.
fn against(method: &MethodResults) -> Option<String> {
    if method.stability.alarm {
        let name = &method.name;
        return Some(format!(
            "No error bar holds for {name}: its values seem to have no variance."
        ));
    }
    let lost = (method.biased && !method.blind.is_empty()).then(|| method.blind.join(" and "))?;
    Some(format!("{} cannot produce {lost}.", method.name))
}

/// What stands against the reference.
fn doubt(reference: &ReferenceResults) -> Option<String> {
    let agreement = reference.agreement.as_ref().filter(|agreement| agreement.refused > 0)?;
    let [a, b] = &agreement.methods;
    let (refused, tiles) = (agreement.refused, agreement.tiles);
    Some(format!("Read with care: as references {a} and {b} differ in {refused} of {tiles} tiles."))
}
