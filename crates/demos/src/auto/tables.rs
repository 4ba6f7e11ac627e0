//! A plan as text.

use serde_json::{Value, json};
use std::fmt::Write;
use traylib_integrators::planner::{Choice, Evidence, Plan, TechniqueShare};

/// Choices of a table; the rest is far behind.
const SHOWN: usize = 12;

/// Tables for people.
pub(super) fn as_text(plan: &Plan) -> String {
    let mut text = format!("plan  {}\n", plan.method);
    let Some(Evidence { choices, blind, techniques, beyond, spent }) = &plan.evidence else {
        text += "The picture has too few samples to spend any on a choice.\n";
        return text;
    };
    // Writing to a string does not fail.
    // What trials have of forecasts, as of the first: points are even, and walks long.
    let first = choices.first().and_then(|first| Some(first.tried? / first.forecast));
    let tried_over_forecast = first.unwrap_or(1.0);
    let best = choices.first().map_or(1.0, Choice::measured);
    text += "\n  noise of a sample         cost of one  time to an error\n";
    text += "  by trial  by forecast     us           times the best's\n";
    for choice in choices.iter().take(SHOWN) {
        let Choice { method, forecast, tried, cost } = choice;
        let tried_text = tried.map_or(String::from("-"), |variance| format!("{variance:.4}"));
        let (sign, time) = match tried {
            Some(_) => (' ', choice.measured()),
            None => ('~', choice.expected() * tried_over_forecast),
        };
        let (us, times) = (cost / 1000.0, time / best);
        let _ = writeln!(
            text,
            "  {tried_text:>8}  {forecast:>11.4}     {us:<11.2}  {sign}{times:<8.2}  {method}"
        );
    }
    if let Some(rest) = choices.len().checked_sub(SHOWN).filter(|rest| *rest > 0) {
        let _ = writeln!(text, "  {rest} more were forecast to take longer");
    }
    if let Some((_, spot)) = blind.first() {
        let mut names: Vec<&str> = blind.iter().map(|(method, _)| method.name()).collect();
        names.dedup();
        let _ = writeln!(text, "  no choice: {}, for they cannot produce {spot}", names.join(", "));
    }
    text += "\n  of the light  of the noise  what the plan's techniques find\n";
    for TechniqueShare { kind, light, squares } in techniques {
        let _ = writeln!(
            text,
            "  {:>10.2} %  {:>10.2} %  {}",
            100.0 * light,
            100.0 * squares,
            kind.name()
        );
    }
    text += "\n  light on paths of more than N edges\n";
    for edges in [1, 2, 3, 4, 6, 8, 12, 16] {
        if let Some(part) = beyond.get(edges) {
            let _ = writeln!(text, "  {edges:>3}  {:>8.3} %", 100.0 * part);
        }
    }
    let _ = writeln!(text, "\nspent on the plan: {:.1} % of the picture's samples", 100.0 * spent);
    text
}

/// The same for programs.
pub(super) fn as_json(plan: &Plan) -> Value {
    let evidence = plan.evidence.as_ref().map(|evidence| {
        json!({
            "choices": evidence.choices.iter().map(choice).collect::<Vec<_>>(),
            "blind": evidence.blind.iter().map(|(method, spot)| {
                json!({ "method": method.to_string(), "to": spot.to_string() })
            }).collect::<Vec<_>>(),
            "techniques": evidence.techniques.iter().map(technique).collect::<Vec<_>>(),
            "light_beyond_edges": evidence.beyond,
            "spent": evidence.spent,
        })
    });
    json!({ "plan": plan.method.to_string(), "evidence": evidence })
}

fn choice(choice: &Choice) -> Value {
    json!({
        "method": choice.method.to_string(),
        "variance_by_forecast": choice.forecast,
        "variance_by_trial": choice.tried,
        "nanoseconds": choice.cost,
    })
}

fn technique(share: &TechniqueShare) -> Value {
    json!({ "kind": share.kind.name(), "light": share.light, "squares": share.squares })
}
