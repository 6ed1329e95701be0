//! Sweeps show every force over its whole domain, also between the points that published cases have.
//!
//! The module `force` has the sweeps, with a file for each force; `sweep` says what a sweep is; `check` judges all of
//! them: continuity, mirror image, laws of physics, growth, references. The module `reference` reads
//! `validation/sweeps.toml`: references with their bands, sweeps without a reference, and faults that are known. The
//! module `stage` simulates one step with a ship at a given place and motion. The modules `printed`, `draw` and `files`
//! write the results of the sweeps.

mod check;
mod draw;
mod files;
mod force;
mod printed;
mod reference;
mod stage;
mod sweep;

pub use check::Resolution;

use check::{Judged, judge};
use reference::References;
use sweep::Sweep;

const REFERENCES: &str = include_str!(concat!(env!("FENDERLINE_DATA"), "/validation/sweeps.toml"));

/// All sweeps, sampled and judged.
pub struct Sweeps {
    swept: Vec<Swept>,
    references: References,
}

/// A sweep, with its values and with what the checks found.
struct Swept {
    sweep: Sweep,
    judged: Judged,
}

impl std::fmt::Debug for Sweeps {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} sweeps", self.swept.len())
    }
}

impl Sweeps {
    /// The number of sweeps, up to which `progress` of [`Sweeps::run`] counts.
    #[must_use]
    pub fn count() -> usize {
        force::all().len()
    }

    /// Samples and judges all sweeps. `progress` gets the number of sweeps that are done, after each sweep.
    #[must_use]
    pub fn run(resolution: Resolution, mut progress: impl FnMut(usize)) -> Sweeps {
        let references = References::parse(REFERENCES, &crate::sources())
            .unwrap_or_else(|e| panic!("the built-in validation/sweeps.toml: {e}"));
        let mut swept = Vec::new();
        for sweep in force::all() {
            let judged = judge(&sweep, &references, resolution);
            swept.push(Swept { sweep, judged });
            progress(swept.len());
        }
        Sweeps { swept, references }
    }

    /// The tables of all sweeps, for the terminal.
    #[must_use]
    pub fn table(&self) -> String {
        printed::tables(self)
    }

    /// Names and contents of `sweeps.html`, `sweeps.csv`, `sweeps.json`, and a picture of each sweep, `sweep_NAME.svg`.
    #[must_use]
    pub fn files(&self) -> Vec<(String, String)> {
        files::files(self)
    }

    /// Complaints: for each check that fails and each reference whose band a curve leaves, unless this is known; for
    /// each known fault that does not show; and for each sweep that has no reference and does not say so.
    #[must_use]
    pub fn complaints(&self) -> Vec<String> {
        let of_sweeps = self.swept.iter().flat_map(|swept| swept.complaints(&self.references));
        of_sweeps.chain(self.idle_entries()).collect()
    }

    /// Complaints about entries of `validation/sweeps.toml` that name no sweep, curve or check.
    fn idle_entries(&self) -> Vec<String> {
        let References { references, none, known_faults } = &self.references;
        let found = |key: &str| self.swept.iter().find(|swept| swept.sweep.key == key);
        let named = references.iter().map(|reference| &reference.sweep);
        let unknown = named.chain(none.iter().map(|none| &none.sweep));
        let unknown = unknown.filter(|key| found(key).is_none());
        let unknown = unknown
            .map(|key| format!("validation/sweeps.toml: there is no sweep with the key {key}"));
        let idle = known_faults.iter().filter(|known| {
            let has_it = |swept: &Swept| {
                let mut findings = swept.judged.findings.iter();
                findings.any(|f| f.curve == known.curve && f.check == known.check)
            };
            !found(&known.sweep).is_some_and(has_it)
        });
        let idle = idle.map(|known| {
            format!(
                "validation/sweeps.toml: the known fault of {}, {}, has no such check: {}",
                known.sweep, known.curve, known.check
            )
        });
        unknown.chain(idle).collect()
    }
}

impl Swept {
    fn complaints(&self, references: &References) -> Vec<String> {
        let key = self.sweep.key;
        let mut complaints = Vec::new();
        for finding in &self.judged.findings {
            let check::Finding { curve, check, found, at, .. } = finding;
            match (finding.holds, &finding.known) {
                (false, None) => complaints.push(format!(
                    "{key}, {curve}: {check}: {found}, at {} {} {}",
                    self.sweep.axis.name,
                    fenderline_report::plot::plain(*at, 4),
                    self.sweep.axis.unit,
                )),
                (true, Some(_)) => complaints.push(format!(
                    "{key}, {curve}: {check}: the check holds, but is listed as a known fault: \
                     take the fault out of validation/sweeps.toml"
                )),
                _ => {}
            }
        }
        for compared in &self.judged.compared {
            let check::Compared { curve, short, band, worst, worst_at, .. } = compared;
            match (compared.holds, &compared.known) {
                (false, None) => complaints.push(format!(
                    "{key}, {curve}: {short}: {worst:.2} times its band of {:.0} %, at {worst_at:.4}",
                    100.0 * band
                )),
                (true, Some(_)) => complaints.push(format!(
                    "{key}, {curve}: {short}: the curve is within the band, but is listed as a \
                     known mismatch: take the mismatch out of validation/sweeps.toml"
                )),
                _ => {}
            }
        }
        let says_none = references.none.iter().any(|none| none.sweep == key);
        if self.judged.compared.is_empty() != says_none {
            complaints.push(format!(
                "{key}: validation/sweeps.toml must either have a reference for the sweep or say \
                 that there is none"
            ));
        }
        complaints
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_force_is_continuous_symmetric_and_obeys_its_laws() {
        let complaints = Sweeps::run(Resolution::Reduced, |_| ()).complaints();
        assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    }

    #[test]
    fn the_page_shows_every_sweep_and_says_where_no_reference_was_found() {
        let sweeps = Sweeps::run(Resolution::Reduced, |_| ());
        let files = sweeps.files();
        assert_eq!(files.len(), 3 + Sweeps::count());
        let page = &files[0].1;
        let before_script = page.split("<script>").next().unwrap_or_default();
        for Swept { sweep, .. } in &sweeps.swept {
            assert!(page.contains(&format!("<figcaption>{}<", sweep.title)), "{}", sweep.title);
        }
        let none = page.matches("No reference found. ").count();
        assert_eq!(none, sweeps.references.none.len());
        for (name, text) in &files {
            let text = if name == "sweeps.html" { before_script } else { text };
            for unwanted in ["NaN", "inf,", "src="] {
                assert!(!text.contains(unwanted), "{name} contains {unwanted}");
            }
        }
        let table = sweeps.table();
        assert!(table.lines().all(|line| line.chars().count() <= 120), "{table}");
        assert!(table.contains("references within their bands"));
    }

    #[test]
    fn sweeps_and_their_curves_have_names_of_their_own() {
        let sweeps = force::all();
        let mut keys: Vec<&str> = sweeps.iter().map(|sweep| sweep.key).collect();
        keys.sort_unstable();
        assert!(keys.windows(2).all(|two| two[0] != two[1]), "{keys:?}");
        for sweep in &sweeps {
            let mut names: Vec<&str> = sweep.curves.iter().map(|c| c.name.as_str()).collect();
            names.sort_unstable();
            assert!(names.windows(2).all(|two| two[0] != two[1]), "{}: {names:?}", sweep.key);
            let drawn = sweep.curves.len() + sweep.lines.len();
            assert!(drawn <= fenderline_report::plot::STYLES, "{}: too many lines", sweep.key);
        }
    }
}
