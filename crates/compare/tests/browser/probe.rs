//! A script that looks at the page from inside, and what it finds.

use serde::Deserialize;

const PROBE: &str = include_str!("probe.js");
/// Listens before anything else can fail.
const EARLY: &str = "<head><script>window.seenErrors = [];\
    addEventListener('error', (e) => seenErrors.push(String(e.message)), true);\
    addEventListener('securitypolicyviolation', (e) => seenErrors.push(e.violatedDirective));\
    </script>";

/// A wipe before and after its slider was moved and another picture chosen.
#[derive(Debug, Deserialize)]
pub(crate) struct Wipe {
    pub(crate) visible: bool,
    pub(crate) clips: [String; 2],
    pub(crate) exchanged: bool,
}

/// The findings of the script.
#[derive(Debug, Deserialize)]
pub(crate) struct Findings {
    pub(crate) wipes: Vec<Wipe>,
    /// Methods of each scene's legend that have a line in their colour.
    pub(crate) lines: Vec<usize>,
    /// Errors of scripts, and refusals by the page's own policy.
    pub(crate) errors: Vec<String>,
    /// Messages of the browser, on its console; not by the script.
    #[serde(default)]
    pub(crate) complaints: Vec<String>,
    pub(crate) requests: Vec<String>,
    /// Breadth of the window.
    pub(crate) window: u32,
    /// Breadth of all that is in it.
    pub(crate) breadth: u32,
    pub(crate) dark: bool,
    pub(crate) first_line: String,
    pub(crate) broken_pictures: u32,
}

impl Findings {
    /// From a document that the script has changed.
    pub(crate) fn read(document: &str) -> Self {
        let after = document.split("id=\"findings\">").nth(1);
        let json = after.and_then(|rest| rest.split("</script>").next());
        serde_json::from_str(json.expect("the probe left nothing")).unwrap()
    }
}

/// The page with the script at its end.
pub(crate) fn into(page: &str) -> String {
    let early = page.replacen("<head>", EARLY, 1);
    early.replacen("</body>", &format!("<script>{{{PROBE}}}</script></body>"), 1)
}

/// The page in a frame of this breadth: windows are never as narrow as a telephone.
pub(crate) fn framed(page: &str, width: u32) -> String {
    let source = page.replace('&', "&amp;").replace('"', "&quot;");
    format!(
        "<!DOCTYPE html><meta charset=\"utf-8\"><meta name=\"color-scheme\" content=\"light dark\">\
         <iframe style=\"border:0;width:{width}px;height:800px\" srcdoc=\"{source}\"></iframe>"
    )
}
