//! Vessels with hydrodynamic data.

use std::f64::consts::TAU;
use std::sync::Arc;

use fenderline_contact::number::greater;
use fenderline_sim::attitude::{Hydrostatics, Oscillator};
use fenderline_sim::seakeeping::{Hydrodynamics, Seakeeping};
use fenderline_sim::{Environment, Float};

use super::assembly::{Assembly, Checked};
use super::vessel::Kind;
use crate::hydrodynamics;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::Notice;
use fenderline_keys::keys::vessel::VesselKey;
use fenderline_keys::printable::printable_number;

/// Viscous damping of roll if the scenario gives none; our assumption for a hull with bilge keels.
const ROLL_DAMPING: f64 = 0.05;
/// Largest difference between the mass in the hydrodynamic data and the displacement of the vessel, divided by the
/// displacement.
const MASS: f64 = 0.03;
/// The shortest period of a motion that the time integration can follow, divided by the time step: 2π/√6.
const SHORTEST_PERIOD: f64 = 2.565;
/// Largest permitted product of the time step (s) and the highest frequency of the hydrodynamic data (rad/s). We found
/// this limit by trial with a tanker whose data end at 3.4 rad/s, in a wave of 37 s. Up to a product of 2.0 heave and
/// pitch are right; at 2.4 they are 0.6 % off, at 2.7 pitch is 9 % off, and at 3.1 heave is 15 % off.
const FINEST: f64 = 2.0;
/// There is a warning if waves with more than this share of the sea's energy are not resolved by the hydrodynamic data.
const TOLD: f64 = 0.05;
/// Hydrodynamic data are refused if they do not resolve this share of the sea's energy, because most of the ship's
/// motion would then be guessed.
const REFUSED: f64 = 0.5;

impl Assembly<'_, '_> {
    /// Reads the hydrodynamic data that a kind of vessel names, with the centre of gravity; `None` if the kind names no
    /// data.
    pub(super) fn seakeeping(
        &mut self,
        table: Of<'_, VesselKey>,
        kind: &Kind,
        environment: &Environment,
        step_s: f64,
    ) -> Checked<Option<(Seakeeping, Float)>> {
        let Some(item) = table.item(VesselKey::HYDRODYNAMICS) else {
            if table.item(VesselKey::ROLL_DAMPING).is_some() {
                let help = "`roll_damping` belongs to `hydrodynamics`";
                self.all_of(table, any_keys![VesselKey: HYDRODYNAMICS], help)?;
            }
            return Ok(None);
        };
        self.none_of(table, any_keys![VesselKey: WAVE_RESPONSE], "hydrodynamics")?;
        let key = table.path_of(VesselKey::HYDRODYNAMICS);
        let file = hydrodynamics::read(self.files.text(item.text()), item.text(), &key)?;
        self.notices.extend(file.notices);
        let (data, draught_m) = (file.data, kind.draught_m());
        if !data.is_resolved_by(step_s) {
            let message = format!(
                "a step of {step_s} s is too long for these data: heave, roll or pitch has a \
                 natural period below {} s, so that this motion would grow without bound",
                printable_number((step_s * SHORTEST_PERIOD * 100.0).round() / 100.0)
            );
            return Err(self.refused(table, item, &message).with_help(
                "take a shorter step, or check whether restoring and added mass are in kg, m, s \
                 and N",
            ));
        }
        let last_radps = data.last_frequency_radps();
        if step_s * last_radps > FINEST {
            let message = format!(
                "a step of {step_s} s is too long for these data, whose highest frequency is {} \
                 rad/s: heave, roll and pitch would be wrong",
                printable_number((last_radps * 100.0).round() / 100.0)
            );
            let longest_s = (100.0 * FINEST / last_radps).floor() / 100.0;
            return Err(self.refused(table, item, &message).with_help(format!(
                "take a step of at most {} s, or data that end at a lower frequency",
                printable_number(longest_s)
            )));
        }
        let (own_kg, hers_kg) = (data.mass_kg(), kind.mass.mass_kg);
        if (own_kg / hers_kg - 1.0).abs() > MASS {
            let message = format!(
                "the data are for a ship of {} t, but the vessel has {} t",
                printable_number((own_kg / 1e3).round()),
                printable_number((hers_kg / 1e3).round())
            );
            return Err(self.refused(table, item, &message));
        }
        let roll_damping =
            table.item(VesselKey::ROLL_DAMPING).map_or(ROLL_DAMPING, |of| *of.number());
        let seakeeping = Seakeeping { data: Arc::new(data), roll_damping };
        let data = &seakeeping.data;
        // Over a bottom by place the verdict compares with the depth at her start.
        let level_m = environment.level_m(0.0);
        let of_run_m = match environment.bottom {
            Some(_) => data.depth_m(),
            None => environment.depth_m.map(|depth_m| greater(depth_m + level_m, 0.0)),
        };
        let depths = [data.depth_m(), of_run_m];
        let [of_data_m, of_run_m] = depths.map(|depth_m| depth_m.unwrap_or(f64::INFINITY));
        if !seakeeping.is_for_depth(depths[1], draught_m) {
            let in_words = |depth_m: f64| match depth_m.is_finite() {
                true => format!("{} m of water", printable_number(depth_m)),
                false => "deep water".to_owned(),
            };
            self.notices.push(Notice {
                place: self.sources.place(&item.span),
                key: key.clone(),
                message: format!(
                    "the hydrodynamic data are for {}, but the run has {}",
                    in_words(of_data_m),
                    in_words(of_run_m)
                ),
            });
        }
        self.tell_unresolved(table, item, (&**data, kind.length_m()), environment)?;
        let (mass, restoring) = (data.total_mass(), data.restoring());
        // For reports: natural periods without coupling, with the added mass at infinite frequency.
        let oscillator = |k: usize, damping: f64| Oscillator {
            inertia: mass[k][k],
            restoring: restoring[k][k],
            damping,
        };
        let float = Float {
            hydrostatics: Hydrostatics {
                heave: oscillator(2, 0.0),
                roll: oscillator(3, roll_damping),
                pitch: oscillator(4, 0.0),
            },
            gravity_above_water_m: file.gravity_above_water_m,
            draught_m,
        };
        Ok(Some((seakeeping, float)))
    }

    /// Warns of the share of the sea's energy that the hydrodynamic data do not resolve. Refuses the sea if the data do
    /// not resolve half of its energy.
    fn tell_unresolved<V>(
        &mut self,
        table: Of<'_, VesselKey>,
        item: Entry<'_, V>,
        (data, length_m): (&Hydrodynamics, f64),
        environment: &Environment,
    ) -> Checked<()> {
        let Some(sea) = &environment.sea else { return Ok(()) };
        let unresolved = data.unresolved(sea, length_m);
        if unresolved.sum() < TOLD {
            return Ok(());
        }
        let percent = |share: f64| printable_number((100.0 * share).round());
        let mut parts = Vec::new();
        if unresolved.by_headings > 0.0 {
            parts.push(format!(
                "{} % in waves of less than {} s, for which the headings of the data are too far \
                 apart (up to {} degrees)",
                percent(unresolved.by_headings),
                printable_number((100.0 * TAU / data.resolved_to_radps(length_m)).round() / 100.0),
                printable_number(data.widest_heading_step_rad().to_degrees().round()),
            ));
        }
        if unresolved.by_frequencies > 0.0 {
            let share = percent(unresolved.by_frequencies);
            parts.push(format!(
                "{share} % in waves for which the frequencies of the data are too far apart"
            ));
        }
        if unresolved.beyond > 0.0 {
            let share = percent(unresolved.beyond);
            parts.push(format!("{share} % in waves beyond the frequencies of the data"));
        }
        let message = format!(
            "{} % of the sea's energy is in waves that the hydrodynamic data do not resolve: {}",
            percent(unresolved.sum()),
            parts.join("; ")
        );
        let help = "make hydrodynamic data with smaller steps of heading and frequency, by the \
                    rule in docs/guides/hydrodynamics.md";
        if unresolved.sum() >= REFUSED {
            return Err(self.refused(table, item, &message).with_help(help));
        }
        let message = format!("{message}; {help}");
        self.notices.push(Notice {
            place: self.sources.place(&item.span),
            key: table.path_of(VesselKey::HYDRODYNAMICS),
            message,
        });
        Ok(())
    }
}
