//! `fenderline replay` of a dump, a file in which the C interface writes the last steps of a contact engine.

use std::io::Read as _;
use std::path::Path;

use fenderline_contact::number::greater;
use fenderline_embed::{Dump, DumpedOutcome, is_dump};
use fenderline_scenario::{open_regular, read_bytes};

use crate::failure::Failure;
use crate::terminal::{say, tell};

/// The largest dump that is read (bytes).
const LARGEST: u64 = 1 << 30;

/// Whether a file begins with the mark of a dump; `false` if the file cannot be read.
pub(crate) fn is_one(path: &Path) -> bool {
    let mut begin = [0; 8];
    open_regular(path, LARGEST).is_ok_and(|mut file| file.read_exact(&mut begin).is_ok())
        && is_dump(&begin)
}

/// Repeats the steps of a dump, and names the steps that were refused, did not end, or gave other results.
///
/// # Errors
/// Fails if the bytes are not a whole dump, or if the results of a step differ from the recorded bits.
pub(crate) fn replay(path: &Path) -> Result<(), Failure> {
    let shown = path.display();
    let bytes = read_bytes(path, LARGEST).map_err(Failure::input)?;
    let mut dump =
        Dump::read(&bytes).map_err(|e| Failure::input(format_args!("error: {shown}: {e}")))?;
    let model = dump.engine().model();
    let (bodies, fenders) = (model.bodies().len(), model.fenders().len());
    let (steps, version) = (dump.steps(), dump.library_version().to_owned());
    let (mut time_s, mut peak_n, mut refused, mut different) = (0.0, 0.0, 0, 0);
    for number in 1..=steps {
        if dump.next_is_unfinished() {
            tell(&format!("step {number} of {steps} did not end when it was recorded"));
        }
        let Some(step) = dump.next_step() else { break };
        if let Some(error) = &step.error {
            tell(&format!("step {number} of {steps}, of {} s, is refused: {error}", step.step_s));
        }
        refused += usize::from(step.outcome == DumpedOutcome::Refused);
        if step.error.is_none() {
            time_s += step.step_s;
        }
        if !step.is_same && step.outcome != DumpedOutcome::Unfinished {
            different += 1;
            tell(&format!(
                "step {number} of {steps}: the results differ from the recorded results"
            ));
        }
        let results = dump.engine().results();
        let contacts = results.iter().flat_map(|results| results.contacts);
        peak_n = contacts.fold(peak_n, |peak, contact| greater(peak, contact.peak_normal_force_n));
    }
    let kilonewtons = peak_n / 1e3;
    say(&format!(
        "dump by version {version}: {bodies} bodies, {fenders} fenders; {steps} steps of {time_s:.3} s in all, {refused} refused; \
         largest contact force {kilonewtons:.0} kN\n"
    ))?;
    if different == 0 {
        return say("all steps gave the same bits as recorded\n");
    }
    Err(Failure::case(format_args!(
        "error: {different} of {steps} steps do not end with the recorded bits"
    )))
}
