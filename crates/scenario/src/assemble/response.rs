//! Reads how a vessel moves in waves: from a table of response amplitude operators, or from an estimate.

use fenderline_sim::Float;
use fenderline_sim::environment::waves::{BoxShip, Complex, MotionResponse, RaoTable};
use fenderline_sim::hydro::Particulars;

use super::assembly::{Assembly, Checked};
use fenderline_keys::checked::Of;
use fenderline_keys::csv::Csv;
use fenderline_keys::error::Notice;
use fenderline_keys::keys::vessel::VesselKey;

/// One of the six motions in a table of response amplitude operators.
struct Motion {
    /// Name of the motion's column of amplitudes.
    amplitude: &'static str,
    /// Name of the motion's column of phases.
    phase: &'static str,
    /// True if the motion's amplitude is in degrees.
    is_angle: bool,
    /// True if the table must have the columns of this motion.
    is_needed: bool,
}

const HEAVE: usize = 2;

/// The six motions in the order of [`RaoTable`].
const MOTIONS: [Motion; 6] = [
    motion("surge_mpm", "surge_phase_deg", false, false),
    motion("sway_mpm", "sway_phase_deg", false, false),
    motion("heave_mpm", "heave_phase_deg", false, true),
    motion("roll_degpm", "roll_phase_deg", true, true),
    motion("pitch_degpm", "pitch_phase_deg", true, true),
    motion("yaw_degpm", "yaw_phase_deg", true, false),
];

const fn motion(
    amplitude: &'static str,
    phase: &'static str,
    is_angle: bool,
    is_needed: bool,
) -> Motion {
    Motion { amplitude, phase, is_angle, is_needed }
}

/// Tolerance for the first and the last heading of a table (deg), which must be 0 and 180 degrees.
const SLACK_DEG: f64 = 0.01;

impl Assembly<'_, '_> {
    /// Reads the table of response amplitude operators that a kind of vessel names; `None` if the kind names no table.
    pub(super) fn rao_table(&mut self, table: Of<'_, VesselKey>) -> Checked<Option<RaoTable>> {
        let Some(item) = table.item(VesselKey::WAVE_RESPONSE) else { return Ok(None) };
        let key = table.path_of(VesselKey::WAVE_RESPONSE);
        let named = MOTIONS.iter().flat_map(|motion| [motion.amplitude, motion.phase]);
        let known: Vec<&str> = ["omega_radps", "heading_deg"].into_iter().chain(named).collect();
        let csv = Csv::parse(self.files.text(item.text()), item.text(), &key, &known)?;
        let [omega, heading] = [csv.column("omega_radps")?, csv.column("heading_deg")?];
        let mut columns = [None; 6];
        for (columns, Motion { amplitude, phase, is_needed, .. }) in
            columns.iter_mut().zip(&MOTIONS)
        {
            if *is_needed || csv.has(amplitude) || csv.has(phase) {
                *columns = Some([csv.column(amplitude)?, csv.column(phase)?]);
            }
        }
        for row in 0..csv.row_count() {
            csv.number(row, omega, [1e-3, 100.0])?;
            // Waves from starboard are the mirror image of waves from port.
            csv.number(row, heading, [0.0, 180.0])?;
        }
        let grid = csv.grid(&[omega, heading])?;
        let (frequencies, headings) = (&grid.axes[0], &grid.axes[1]);
        let [first, last] = [headings[0], headings[headings.len() - 1]];
        if headings.len() < 2 || first > SLACK_DEG || last < 180.0 - SLACK_DEG {
            let message = format!(
                "the headings must reach from 0 to 180 degrees, but reach from {first} to {last}"
            );
            return Err(csv.header_error(message));
        }
        let mut operators = Vec::with_capacity(csv.row_count());
        for &row in &grid.rows {
            let mut six = [Complex::default(); 6];
            for (operator, (column, motion)) in six.iter_mut().zip(columns.iter().zip(&MOTIONS)) {
                let Some([amplitude, phase]) = *column else { continue };
                let size = csv.number(row, amplitude, [0.0, 1000.0])?;
                let size = if motion.is_angle { size.to_radians() } else { size };
                let angle = csv.number(row, phase, [-720.0, 720.0])?.to_radians();
                *operator = Complex::polar(size, angle);
            }
            operators.push(six);
        }
        // In waves much longer than the ship, the ship rises with the crest. Heave is positive down here, so the real
        // part of heave must be negative.
        let longest = &operators[..headings.len()];
        if longest.iter().all(|six| six[HEAVE].re > 0.3) {
            self.notices.push(Notice {
                place: self.sources.place(&item.span),
                key: key.clone(),
                message: format!(
                    "in the longest waves of {} the ship sinks on the crest; heave must be \
                     positive down, but may be positive up in the file",
                    item.text()
                ),
            });
        }
        let headings_rad = headings.iter().map(|heading| heading.to_radians()).collect();
        RaoTable::new(frequencies.clone(), snapped(headings_rad), operators)
            .map(Some)
            .map_err(|error| self.refused(table, item, &error))
    }
}

/// The headings of a table, with the first heading set to exactly 0 and the last to exactly π.
fn snapped(mut headings_rad: Vec<f64>) -> Vec<f64> {
    if let [first, .., last] = headings_rad.as_mut_slice() {
        (*first, *last) = (0.0, core::f64::consts::PI);
    }
    headings_rad
}

/// Estimates the motion in waves as that of a box-shaped hull of the ship's size.
pub(super) fn estimate(ship: &Particulars, float: &Float) -> MotionResponse {
    MotionResponse::Estimate(BoxShip {
        length_m: ship.length_m,
        beam_m: ship.beam_m,
        draught_m: ship.draught_m,
        block_coefficient: ship.block_coefficient(),
        roll_period_s: float.hydrostatics.roll.period_s(),
        roll_damping: float.hydrostatics.roll.damping,
    })
}
