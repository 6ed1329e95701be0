//! The verdict on the run up to the present tick. The words of the verdict are the same in every other output of the
//! program.

use fenderline_sim::{Finding, Simulation, Verdict};

use crate::message::{FindingNow, VerdictNow};

/// The verdict on the run and its findings, the worst first.
pub(crate) fn now(simulation: &Simulation) -> VerdictNow {
    let (setup, findings) = (simulation.setup(), simulation.findings());
    let verdict = Verdict::of(&findings);
    let finding = |finding: &Finding| FindingNow {
        key: finding.verdict().key(),
        gravity: finding.verdict().gravity().key(),
        text: finding.sentence(setup),
    };
    VerdictNow {
        key: verdict.key(),
        text: verdict.text(),
        gravity: verdict.gravity().key(),
        findings: findings.iter().map(finding).collect(),
    }
}
