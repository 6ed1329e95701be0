//! What a run writes.

use crate::assemble::assembly::{Assembly, Checked};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::held::{Number, Texts};
use fenderline_keys::keys::output::OutputKey;
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;
use fenderline_sim::{OutputPlan, OutputTable};

/// Largest difference between the interval and a whole number of time steps that counts as rounding error, as a share
/// of the interval.
const ROUNDING: f64 = 1e-9;

impl Assembly<'_, '_> {
    /// Reads from the table `[output]` what a run of `duration_s` in steps of `step_s` writes.
    pub(super) fn output(
        &self,
        table: Option<Of<'_, OutputKey>>,
        step_s: f64,
        duration_s: f64,
    ) -> Checked<OutputPlan> {
        let by_default = OutputPlan::of_steps(libm::ceil(duration_s / step_s));
        let Some(table) = table else { return Ok(by_default) };
        let steps_per_row = match table.item(OutputKey::INTERVAL) {
            None => by_default.steps_per_row,
            Some(item) => self.steps_per_row(table, item, step_s, duration_s)?,
        };
        let tables = match table.item(OutputKey::TABLES) {
            None => OutputPlan::default_tables(steps_per_row),
            Some(item) => self.output_tables(table, item)?,
        };
        Ok(OutputPlan { steps_per_row, tables })
    }

    fn steps_per_row<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Number>,
        step_s: f64,
        duration_s: f64,
    ) -> Checked<u64> {
        let interval_s = *item.number();
        if interval_s == 0.0 {
            return Ok(1);
        }
        let path = table.path_to(item);
        let refused = |message: String, help: String| {
            Err(self.sources.error(&item.span, &path, message).with_help(help))
        };
        if interval_s > duration_s && interval_s > step_s {
            let message = format!(
                "`{path}` of {interval_s} s is longer than `time.duration`, which is {duration_s} s"
            );
            return refused(message, "take a shorter interval".to_owned());
        }
        let steps = libm::round(interval_s / step_s);
        if steps < 1.0 || (steps * step_s - interval_s).abs() > ROUNDING * interval_s {
            let message = format!(
                "`{path}` of {interval_s} s is not a whole number of time steps of {step_s} s"
            );
            let below = libm::floor(interval_s / step_s);
            // Without the rounding of the product.
            let near = |steps: f64| format!("{} s", libm::round(steps * step_s * 1e9) / 1e9);
            let help = match below {
                0.0 => format!("take {} or 0, which both write every step", near(1.0)),
                _ => format!("take {} or {}", near(below), near(below + 1.0)),
            };
            return refused(message, help);
        }
        Ok(steps as u64)
    }

    fn output_tables<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Texts>,
    ) -> Checked<Vec<OutputTable>> {
        let mut tables = Vec::new();
        for name in item.texts() {
            let known = OutputTable::ALL.into_iter().find(|table| table.name() == name);
            let Some(known) = known else {
                let path = table.path_to(item);
                let message = format!("`{path}`: there is no result table {}", quoted(name));
                let error = self.sources.error(&item.span, &path, message);
                let names = || OutputTable::ALL.into_iter().map(OutputTable::name);
                return Err(error.with_help(match nearest(name, names()) {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("there are {}", names().collect::<Vec<_>>().join(", ")),
                }));
            };
            if !tables.contains(&known) {
                tables.push(known);
            }
        }
        Ok(tables)
    }
}
