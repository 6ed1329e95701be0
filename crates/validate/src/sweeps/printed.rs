//! Writes the tables that `validate --sweeps` prints, and the texts of their cells.

use core::fmt::Write as _;

use fenderline_report::plot::plain;

use super::check::{Compared, Finding};
use super::{Sweeps, Swept};

/// Longest line (characters).
const LINE: usize = 120;

/// Writes, for each force, its sweeps: what was checked, what failed, and the ratios to references.
pub(super) fn tables(sweeps: &Sweeps) -> String {
    let mut text = String::new();
    let mut subject = "";
    for swept in &sweeps.swept {
        if swept.sweep.subject != subject {
            subject = swept.sweep.subject;
            let _ = writeln!(text, "{}\n", subject.to_uppercase());
        }
        add_sweep(&mut text, swept, sweeps);
    }
    let (holds, checks) = count(sweeps);
    let (within, compared) = count_references(sweeps);
    let without = sweeps.references.none.len();
    let _ = writeln!(
        text,
        "{} sweeps, {without} of them with no reference found\n{within} of {compared} references within their bands\n\
         {holds} of {checks} checks hold",
        sweeps.swept.len(),
    );
    text
}

/// How many checks of all sweeps hold, and how many checks there are.
pub(super) fn count(sweeps: &Sweeps) -> (usize, usize) {
    let findings = || sweeps.swept.iter().flat_map(|swept| &swept.judged.findings);
    (findings().filter(|finding| finding.holds).count(), findings().count())
}

/// Within the bands of how many references the curves are, and how many references there are.
pub(super) fn count_references(sweeps: &Sweeps) -> (usize, usize) {
    let compared = || sweeps.swept.iter().flat_map(|swept| &swept.judged.compared);
    (compared().filter(|compared| compared.holds).count(), compared().count())
}

fn add_sweep(text: &mut String, swept: &Swept, sweeps: &Sweeps) {
    let Swept { sweep, judged } = swept;
    let _ = writeln!(text, "{}", sweep.title);
    let held = judged.findings.iter().filter(|finding| finding.holds).count();
    let curves = match sweep.curves.len() {
        1 => "1 curve".to_owned(),
        count => format!("{count} curves"),
    };
    let _ = writeln!(
        text,
        "    {} {} to {}{}, {curves}: {held} of {} checks hold",
        sweep.axis.name,
        plain(sweep.axis.from, 4),
        plain(sweep.axis.to, 4),
        spaced(sweep.axis.unit),
        judged.findings.len(),
    );
    for finding in judged.findings.iter().filter(|finding| !finding.holds) {
        add_wrapped(text, &failure_text(swept, finding));
    }
    for compared in &judged.compared {
        add_wrapped(text, &reference_text(swept, compared));
    }
    if let Some(none) = sweeps.references.none.iter().find(|none| none.sweep == sweep.key) {
        add_wrapped(text, &format!("no reference found: {}", none.looked_for));
    }
    text.push('\n');
}

/// A check that fails.
pub(super) fn failure_text(swept: &Swept, finding: &Finding) -> String {
    let Finding { curve, check, found, at, known, .. } = finding;
    let axis = &swept.sweep.axis;
    let begin = if known.is_some() { "FAILS, known" } else { "FAILS" };
    let note = known.as_deref().map_or_else(String::new, |note| format!(". {note}"));
    format!(
        "{begin}: curve {curve}, check {check}: {found}, at {}{}{note}",
        plain(*at, 4),
        spaced(axis.unit)
    )
}

/// Text about a reference with its ratio and band.
pub(super) fn reference_text(swept: &Swept, compared: &Compared) -> String {
    let Compared { curve, short, .. } = compared;
    let begin = match (compared.holds, compared.known.is_some()) {
        (true, _) => "",
        (false, true) => "OUT OF BAND, known: ",
        (false, false) => "OUT OF BAND: ",
    };
    let note = compared.known.as_deref().map_or_else(String::new, |note| format!(". {note}"));
    let at = format!("{}{}", plain(compared.worst_at, 4), spaced(swept.sweep.axis.unit));
    format!(
        "{begin}{curve} over {short}: {}, band {}, worst {} times it at {at}{note}",
        ratio_text(compared),
        band_text(compared.band),
        plain(compared.worst, 2),
    )
}

/// Ours over the reference.
pub(super) fn ratio_text(compared: &Compared) -> String {
    let [least, greatest] = compared.ratio.map(|ratio| plain(ratio, 3));
    if least == greatest { least } else { format!("{least} to {greatest}") }
}

/// Writes the width of a reference's band in per cent.
pub(super) fn band_text(band: f64) -> String {
    format!("±{} %", plain(100.0 * band, 2))
}

fn spaced(unit: &str) -> String {
    match unit.chars().next() {
        None => String::new(),
        Some('°') => unit.to_owned(),
        Some(_) => format!(" {unit}"),
    }
}

/// Adds a paragraph, wrapped to the width of a page.
fn add_wrapped(text: &mut String, paragraph: &str) {
    let mut line = String::from("    ");
    for word in paragraph.split_whitespace() {
        if line.chars().count() + word.chars().count() + 1 > LINE {
            let _ = writeln!(text, "{}", line.trim_end());
            line = String::from("      ");
        }
        line.push_str(word);
        line.push(' ');
    }
    let _ = writeln!(text, "{}", line.trim_end());
}
