//! The manoeuvres themselves.

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::hydro::Model3;
use fenderline_sim::hydro::manoeuvres::{
    Approach, CrashStop, ManoeuvreError, Moment, TurningCircle, ZigZag, bollard_pull_n,
    crash_stop_observed, turning_circle_observed, zig_zag_observed,
};
use fenderline_sim::hydro::vessels::Vessel;

use super::conditions::{Conditions, Sea};
use super::crabbing::crabbing_section;
use super::imo;
use super::section::{Row, Section, Track, Unit};
use crate::cli::Manoeuvre;
use crate::failure::Failure;

/// Time step divided by the time in which the ship sails her own length (a time step of 0.08 s for KVLCC2). With half
/// this time step, no result changes by more than a thousandth (`crates/sim/tests/hydro_manoeuvres.rs`).
const STEP: f64 = 0.002;
/// Propeller revolutions at full astern divided by the revolutions of the approach.
const ASTERN: f64 = -0.7;
/// Time in which the shaft goes from the revolutions of the approach to full astern, divided by the time in which the
/// ship sails her own length (half a minute for KVLCC2).
const REVERSAL: f64 = 30.0 / (320.0 / (15.5 * KNOT_MPS));

/// Carries out a manoeuvre, to both sides if it has sides.
///
/// # Errors
/// Fails if a manoeuvre does not end, or if the propeller cannot hold the speed.
pub(super) fn carry_out(
    manoeuvre: Manoeuvre,
    vessel: &Vessel,
    model: &Model3,
    sea: &Sea,
    conditions: &Conditions,
) -> Result<Vec<Section>, Failure> {
    let trial = Trial {
        name: manoeuvre.text(),
        vessel,
        model,
        conditions,
        length_m: vessel.ship.particulars.length_m,
        has_limits: conditions.is_test_speed && !sea.is_model && conditions.shallow.is_none(),
    };
    let one = |section: Result<Section, ManoeuvreError>| section.map(|section| vec![section]);
    let sections = match manoeuvre {
        Manoeuvre::Turning => one(trial.turning()),
        Manoeuvre::Zigzag => trial.zig_zags(),
        Manoeuvre::CrashStop => one(trial.crash_stop()),
        Manoeuvre::Crabbing => one(crabbing_section(&trial.name, model, conditions.push_n)),
        Manoeuvre::BollardPull => one(trial.bollard_pull()),
    };
    sections.map_err(|error| match error {
        ManoeuvreError::NoBalance { .. } => {
            Failure::input(format_args!("error: {}: {error}", vessel.origin.title))
        }
        _ => Failure::case(format_args!("error: {}, {}: {error}", vessel.origin.title, trial.name)),
    })
}

struct Trial<'a> {
    name: String,
    vessel: &'a Vessel,
    model: &'a Model3,
    conditions: &'a Conditions,
    length_m: f64,
    has_limits: bool,
}

/// Names of the two sides, each with the sign of the rudder angle.
const SIDES: [(&str, f64); 2] = [("starboard", 1.0), ("port", -1.0)];

impl Trial<'_> {
    fn approach(&self) -> Result<Approach, ManoeuvreError> {
        self.approach_of(self.model)
    }

    fn approach_of(&self, model: &Model3) -> Result<Approach, ManoeuvreError> {
        let speed_mps = self.conditions.speed_mps;
        let step_s = STEP * self.length_m / speed_mps;
        Approach::at(model, speed_mps, self.vessel.steering, step_s)
    }

    /// The given limit if IMO's limits apply, else `None`.
    fn limit(&self, limit: f64) -> Option<f64> {
        self.has_limits.then_some(limit)
    }

    fn turning(&self) -> Result<Section, ManoeuvreError> {
        let approach = self.approach()?;
        let stop_deg = self.vessel.steering.stop.to_degrees();
        let rudder_deg = self.conditions.rudder_deg.unwrap_or(stop_deg);
        let (mut turns, mut tracks) = (Vec::new(), Vec::new());
        for (side, sign) in SIDES {
            let (turn, track) = watched(format!("turning_{side}"), |watch| {
                let rudder_rad = sign * rudder_deg.to_radians();
                turning_circle_observed(self.model, &approach, rudder_rad, watch)
            })?;
            turns.push(turn);
            tracks.push(track);
        }
        let each = |value: fn(&TurningCircle) -> f64| turns.iter().map(value).collect::<Vec<f64>>();
        let lengths = |value: fn(&TurningCircle) -> f64| {
            turns.iter().map(|turn| value(turn) / self.length_m).collect::<Vec<f64>>()
        };
        let is_hard_over = self.conditions.rudder_deg.is_none_or(|deg| deg >= stop_deg - 1e-9);
        let hard_over = |limit: f64| self.limit(limit).filter(|_| is_hard_over);
        let rows = vec![
            Row::new("advance", "advance at 90°", Unit::Lengths, lengths(|t| t.advance_m))
                .limited(hard_over(imo::ADVANCE)),
            Row::new("transfer", "transfer at 90°", Unit::Lengths, lengths(|t| t.transfer_m)),
            Row::new("time_to_90", "time to 90°", Unit::Seconds, each(|t| t.quarter_s)),
            Row::new(
                "tactical_diameter",
                "tactical diameter",
                Unit::Lengths,
                lengths(|t| t.tactical_diameter_m),
            )
            .limited(hard_over(imo::TACTICAL_DIAMETER)),
            Row::new("time_to_180", "time to 180°", Unit::Seconds, each(|t| t.half_s)),
            Row::new(
                "steady_diameter",
                "steady diameter",
                Unit::Lengths,
                lengths(|t| t.steady.diameter_m),
            ),
            Row::new(
                "steady_speed_ratio",
                "steady speed U/U₀",
                Unit::One,
                each(|t| t.steady.speed_ratio),
            ),
            Row::new(
                "steady_rate",
                "steady rate of turn r' = rL/U",
                Unit::One,
                each(|t| t.steady.yaw_rate),
            ),
            Row::new(
                "steady_drift",
                "steady drift angle β",
                Unit::Degrees,
                each(|t| t.steady.drift_rad.to_degrees()),
            ),
        ];
        Ok(Section {
            manoeuvre: self.name.clone(),
            title: format!("Turning circle, rudder {rudder_deg:.3}°").replace(".000", ""),
            columns: SIDES.map(|(side, _)| side.to_owned()).to_vec(),
            rows,
            notes: vec![
                "The track is that of midship, from the start of the rudder's turn; constant revolutions.",
            ],
            tracks,
        })
    }

    fn zig_zags(&self) -> Result<Vec<Section>, ManoeuvreError> {
        let angles_deg = self.conditions.rudder_deg.map_or(vec![10.0, 20.0], |deg| vec![deg]);
        angles_deg.into_iter().map(|angle_deg| self.zig_zag(angle_deg)).collect()
    }

    fn zig_zag(&self, angle_deg: f64) -> Result<Section, ManoeuvreError> {
        let approach = self.approach()?;
        let (mut runs, mut tracks) = (Vec::new(), Vec::new());
        for (side, sign) in SIDES {
            let (run, track) = watched(format!("zigzag_{angle_deg}_{side}"), |watch| {
                let check_rad = angle_deg.to_radians();
                zig_zag_observed(self.model, &approach, sign * check_rad, check_rad, watch)
            })?;
            runs.push(run);
            tracks.push(track);
        }
        let degrees = |value: fn(&ZigZag) -> f64| {
            runs.iter().map(|run| value(run).to_degrees()).collect::<Vec<f64>>()
        };
        let [initial, first, second] = self.zig_zag_limits(angle_deg);
        let ways = runs.iter().map(|run| run.initial_turning_m / self.length_m).collect();
        let times = runs.iter().map(|run| run.second_execute_s).collect();
        let rows = vec![
            Row::new("initial_turning", "distance to the second execute", Unit::Lengths, ways)
                .limited(initial),
            Row::new("second_execute", "time to the second execute", Unit::Seconds, times),
            Row::new(
                "first_overshoot",
                "first overshoot",
                Unit::Degrees,
                degrees(|run| run.first_overshoot_rad),
            )
            .limited(first),
            Row::new(
                "second_overshoot",
                "second overshoot",
                Unit::Degrees,
                degrees(|run| run.second_overshoot_rad),
            )
            .limited(second),
        ];
        Ok(Section {
            manoeuvre: self.name.clone(),
            title: format!("Zig-zag {angle_deg}°/{angle_deg}°, by the side of the first execute"),
            columns: SIDES.map(|(side, _)| side.to_owned()).to_vec(),
            rows,
            notes: vec![
                "Rudder orders (executes) are given at whole time steps; constant revolutions.",
            ],
            tracks,
        })
    }

    /// IMO's limits of the initial turning (ship lengths) and of both overshoots (°).
    fn zig_zag_limits(&self, angle_deg: f64) -> [Option<f64>; 3] {
        let length_over_speed_s = self.length_m / self.conditions.speed_mps;
        if angle_deg == 10.0 {
            [
                self.limit(imo::INITIAL_TURNING),
                self.limit(imo::first_overshoot_10_deg(length_over_speed_s)),
                self.limit(imo::second_overshoot_10_deg(length_over_speed_s)),
            ]
        } else if angle_deg == 20.0 {
            [None, self.limit(imo::FIRST_OVERSHOOT_20_DEG), None]
        } else {
            [None; 3]
        }
    }

    /// Carries out the crash stop with the resistance of the model tests; if that resistance contains a model's
    /// friction, also with the ship's own friction.
    fn crash_stop(&self) -> Result<Section, ManoeuvreError> {
        let mut models = vec![("ahead", *self.model)];
        let speed_mps = self.conditions.speed_mps;
        let own = self
            .vessel
            .resistance_of_model_m
            .and_then(|m| self.vessel.ship.with_ships_friction(m, speed_mps).ok());
        if let Some(own) = own {
            models = vec![
                ("as tested", *self.model),
                ("ship's friction", Model3::new(own, self.model.water())),
            ];
        }
        let reversal_s = REVERSAL * self.length_m / speed_mps;
        let (mut stops, mut tracks, mut asterns_rpm) = (Vec::new(), Vec::new(), Vec::new());
        for (column, model) in &models {
            let approach = self.approach_of(model)?;
            let astern_rps = ASTERN * approach.shaft_rps;
            let rate_rps2 = (approach.shaft_rps - astern_rps) / reversal_s;
            let name = match *column {
                "ship's friction" => "crash_stop_own_friction",
                _ => "crash_stop",
            };
            let (stop, track) = watched(name.to_owned(), |watch| {
                crash_stop_observed(model, &approach, astern_rps, rate_rps2, watch)
            })?;
            stops.push(stop);
            tracks.push(track);
            asterns_rpm.push(-60.0 * astern_rps);
        }
        let each = |value: fn(&CrashStop) -> f64| stops.iter().map(value).collect::<Vec<f64>>();
        let lengths = |value: fn(&CrashStop) -> f64| {
            stops.iter().map(|stop| value(stop) / self.length_m).collect::<Vec<f64>>()
        };
        let rows = vec![
            Row::new("astern", "revolutions astern", Unit::PerMinute, asterns_rpm),
            Row::new("track_reach", "track reach", Unit::Lengths, lengths(|s| s.track_reach_m))
                .limited(self.limit(imo::TRACK_REACH)),
            Row::new("head_reach", "head reach", Unit::Lengths, lengths(|s| s.head_reach_m)),
            Row::new("lateral", "lateral deviation", Unit::Lengths, lengths(|s| s.lateral_m)),
            Row::new(
                "heading",
                "change of heading",
                Unit::Degrees,
                each(|s| s.heading_rad.to_degrees()),
            ),
            Row::new("time", "time to standstill", Unit::Seconds, each(|s| s.time_s)),
        ];
        let mut notes = vec![
            "The revolutions are assumed to change evenly, in 30 s for a ship of 320 m at 15.5 knots.",
            "The torque for the change of revolutions is not limited: a diesel may need longer.",
            "In this model a propeller astern does not turn the ship; a real propeller does.",
        ];
        notes.push(match (models.len(), self.has_limits) {
            (2, _) => {
                "As tested: with the friction of the model, which stops a ship too soon. Ship's \
                 friction: the model's extra friction is taken off by the ITTC 1957 line, without \
                 form factor and roughness."
            }
            (_, true) => {
                "It is not known whether the resistance is from a model: a model's friction stops \
                 a ship too soon."
            }
            _ => "",
        });
        notes.retain(|note| !note.is_empty());
        Ok(Section {
            manoeuvre: self.name.clone(),
            title: format!(
                "Crash stop, full astern (70 % of the revolutions) reached within {reversal_s:.1} s"
            ),
            columns: models.iter().map(|(column, _)| (*column).to_owned()).collect(),
            rows,
            notes,
            tracks,
        })
    }

    fn bollard_pull(&self) -> Result<Section, ManoeuvreError> {
        let ahead_rps = self.approach()?.shaft_rps;
        let shafts_rps = [ahead_rps, ASTERN * ahead_rps];
        let pulls_n = shafts_rps
            .iter()
            .map(|shaft_rps| bollard_pull_n(self.model, *shaft_rps))
            .collect::<Result<Vec<f64>, ManoeuvreError>>()?;
        let pulls_kn = pulls_n.iter().map(|pull_n| pull_n / 1e3).collect();
        let revolutions = shafts_rps.iter().map(|shaft_rps| shaft_rps * 60.0).collect();
        Ok(Section {
            manoeuvre: self.name.clone(),
            title: "Bollard pull at the revolutions of the approach, and at 70 % of them astern"
                .to_owned(),
            columns: vec!["ahead".to_owned(), "astern".to_owned()],
            rows: vec![
                Row::new("revolutions", "revolutions", Unit::PerMinute, revolutions),
                Row::new("pull", "pull on the line", Unit::Kilonewtons, pulls_kn),
            ],
            notes: vec![
                "The program does not check whether the engine has the torque for this pull at rest.",
            ],
            tracks: Vec::new(),
        })
    }
}

/// Runs a manoeuvre and records the ship's track.
fn watched<T>(
    name: String,
    run: impl FnOnce(&mut dyn FnMut(&Moment)) -> Result<T, ManoeuvreError>,
) -> Result<(T, Track), ManoeuvreError> {
    let mut moments = Vec::new();
    let measures = run(&mut |moment| moments.push(*moment))?;
    Ok((measures, Track { name, moments }))
}
