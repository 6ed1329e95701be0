//! How a vessel answers waves: by a table of her own, or by the estimate.

use fenderline_sim::Float;
use fenderline_sim::environment::waves::{BoxShip, Complex, MotionResponse, RaoTable};
use fenderline_sim::hydro::Particulars;

use super::{Assembly, Checked};
use crate::checked::Table;
use crate::csv::Csv;
use crate::error::Notice;

/// Each motion: its column of amplitudes, that of its phases, and whether the amplitude is an angle. In the order of
/// [`RaoTable`].
const MOTIONS: [(&str, &str, bool); 6] = [
    ("surge_mpm", "surge_phase_deg", false),
    ("sway_mpm", "sway_phase_deg", false),
    ("heave_mpm", "heave_phase_deg", false),
    ("roll_degpm", "roll_phase_deg", true),
    ("pitch_degpm", "pitch_phase_deg", true),
    ("yaw_degpm", "yaw_phase_deg", true),
];
/// Heave, roll and pitch have to be there.
const NEEDED: core::ops::RangeInclusive<usize> = 2..=4;
/// How far from 0 and 180 degrees a table may begin and end (deg).
const SLACK_DEG: f64 = 0.01;

impl Assembly<'_, '_> {
    /// The table that a kind of vessel names, if she does.
    pub(super) fn rao_table(&mut self, table: &Table) -> Checked<Option<RaoTable>> {
        let Some(item) = table.item("wave_response") else { return Ok(None) };
        let key = table.path_of("wave_response");
        let named = MOTIONS.iter().flat_map(|(amplitude, phase, _)| [*amplitude, *phase]);
        let known: Vec<&str> = ["omega_radps", "heading_deg"].into_iter().chain(named).collect();
        let csv = Csv::parse(self.files.text(item.text()), item.text(), &key, &known)?;
        let [omega, heading] = [csv.column("omega_radps")?, csv.column("heading_deg")?];
        let mut columns = [None; 6];
        for (index, (amplitude, phase, _)) in MOTIONS.iter().enumerate() {
            if NEEDED.contains(&index) || csv.has(amplitude) || csv.has(phase) {
                columns[index] = Some([csv.column(amplitude)?, csv.column(phase)?]);
            }
        }
        for row in 0..csv.len() {
            csv.number(row, omega, [1e-3, 100.0])?;
            // From starboard is the mirror of from port.
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
        let mut operators = Vec::with_capacity(csv.len());
        for &row in &grid.rows {
            let mut six = [Complex::default(); 6];
            for (operator, (column, (_, _, is_angle))) in
                six.iter_mut().zip(columns.iter().zip(&MOTIONS))
            {
                let Some([amplitude, phase]) = *column else { continue };
                let size = csv.number(row, amplitude, [0.0, 1000.0])?;
                let size = if *is_angle { size.to_radians() } else { size };
                let angle = csv.number(row, phase, [-720.0, 720.0])?.to_radians();
                *operator = Complex::polar(size, angle);
            }
            operators.push(six);
        }
        // In a wave much longer than she is a ship goes up on the crest: her heave, which is positive down, is
        // opposite to it.
        let longest = &operators[..headings.len()];
        if longest.iter().all(|six| six[2].re > 0.3) {
            self.notices.push(Notice {
                place: self.sources.place(&item.span),
                key: key.clone(),
                message: format!(
                    "in the longest waves of {} she goes down on the crest; is heave positive up there? \
                     Here it is positive down",
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

/// The directions with their ends where the mirror is.
fn snapped(mut headings_rad: Vec<f64>) -> Vec<f64> {
    if let [first, .., last] = headings_rad.as_mut_slice() {
        (*first, *last) = (0.0, core::f64::consts::PI);
    }
    headings_rad
}

/// How a box of her size answers.
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
