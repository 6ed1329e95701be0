//! Reads propeller, rudder, thrusters and azimuth units, and the speed at which standard manoeuvres begin.

use std::f64::consts::TAU;

use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::vessels::Figure;
use fenderline_sim::hydro::{Particulars, SternCoefficients, SternGear, TunnelThruster};
use fenderline_sim::{AzimuthSetup, ThrusterSetup};

use super::figure;
use super::reading::Reading;
use crate::assemble;
use crate::vessels::data::{Shaft, VesselData};
use crate::vessels::figures::digits;
use crate::vessels::keys::FileVesselKey;
use crate::vessels::keys::stern::{FilePropellerKey, FileRudderKey};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::Number;
use fenderline_keys::keys::azimuth::AzimuthKey;
use fenderline_keys::keys::vessel::ThrusterKey;
use fenderline_keys::typed_key::Key;

type Read<T> = Result<T, ScenarioError>;

/// Acceleration of gravity (m/s²) in the Froude numbers of vessel files, rounded as in published trials.
const FROUDE_GRAVITY_MPS2: f64 = 9.81;

/// Rate of a steering gear if the file gives none (rad/s): 2.32 °/s, which is IMO's 65° in 28 s.
const USUAL_RATE_RADPS: f64 = 2.32 * TAU / 360.0;

/// Largest rudder angle if the file gives none (rad): 35°.
const USUAL_STOP_RAD: f64 = 35.0 * TAU / 360.0;

/// Time from full ahead to full astern if the file gives none (s).
const USUAL_REVERSAL_S: f64 = 40.0;

impl Reading<'_, '_> {
    pub(super) fn stern_gear(
        &self,
        ship: &Particulars,
        own: &SternCoefficients,
    ) -> Read<Option<SternGear>> {
        let table = self.table;
        let (propeller, rudder) =
            match (table.item(FileVesselKey::PROPELLER), table.item(FileVesselKey::RUDDER)) {
                (Some(propeller), Some(rudder)) => (propeller.table(), rudder.table()),
                (propeller, rudder) => {
                    let (alone, other) = match (propeller, rudder) {
                        (Some(alone), _) => (alone.any(), FileVesselKey::RUDDER.any()),
                        (_, Some(alone)) => (alone.any(), FileVesselKey::PROPELLER.any()),
                        (None, None) => return Ok(None),
                    };
                    let path = table.path_to(alone);
                    let message = format!("`{path}` needs `{other}` in the same table");
                    return Err(self.sources.error(&alone.key_span, &path, message));
                }
            };
        let propeller_m = *propeller.given(FilePropellerKey::DIAMETER).number();
        let rudder_m2 = match (
            rudder.item_if_any(FileRudderKey::AREA),
            rudder.item_if_any(FileRudderKey::AREA_RATIO),
        ) {
            (Some(_), Some(item)) => return Err(self.together(rudder, item, FileRudderKey::AREA)),
            (Some(area), None) => *area.number(),
            (None, Some(ratio)) => ship.length_m * ship.draught_m / ratio.number(),
            (None, None) => {
                return Err(self.missing(rudder, FileRudderKey::AREA, "or give `area_ratio`"));
            }
        };
        let (to_span, aspect) = (
            rudder.item_if_any(FileRudderKey::PROPELLER_TO_SPAN),
            rudder.item_if_any(FileRudderKey::ASPECT_RATIO),
        );
        let (propeller_to_span, aspect_ratio) = match rudder.item_if_any(FileRudderKey::SPAN) {
            Some(span) => {
                if let Some(item) = to_span.or(aspect) {
                    return Err(self.together(rudder, item, FileRudderKey::SPAN));
                }
                let span_m = span.number();
                (propeller_m / span_m, span_m * span_m / rudder_m2)
            }
            None => {
                let need = |key: Key<FileRudderKey, Number>, help| self.missing(rudder, key, help);
                let to_span = to_span
                    .ok_or_else(|| need(FileRudderKey::SPAN, "or give `propeller_to_span`"))?;
                let aspect = aspect.map(|item| *item.number());
                if aspect.is_none() && own.lift_gradient.is_none() {
                    return Err(need(FileRudderKey::ASPECT_RATIO, "or give `lift_gradient`"));
                }
                (*to_span.number(), aspect.unwrap_or(1.0))
            }
        };
        Ok(Some(SternGear { propeller_m, rudder_m2, propeller_to_span, aspect_ratio, own: *own }))
    }

    pub(super) fn approach_mps(
        &self,
        base: Option<(&VesselData, f64)>,
        ship: &Particulars,
        scaled: &mut Vec<Figure>,
    ) -> Read<Option<f64>> {
        let table = self.table;
        match (table.item_if_any(FileVesselKey::SPEED), table.item_if_any(FileVesselKey::FROUDE)) {
            (Some(_), Some(item)) => Err(self.together(table, item, FileVesselKey::SPEED)),
            (Some(speed), None) => Ok(Some(*speed.number())),
            (None, Some(froude)) => {
                Ok(Some(froude.number() * (FROUDE_GRAVITY_MPS2 * ship.length_m).sqrt()))
            }
            (None, None) => Ok(base.and_then(|(base, time_scale)| {
                let speed_mps = base.approach_mps? / time_scale;
                scaled.push(figure("speed", &format!("{} m/s", digits(speed_mps))));
                Some(speed_mps)
            })),
        }
    }

    pub(super) fn rudder(
        &self,
        base: Option<(&VesselData, f64)>,
        scaled: &mut Vec<Figure>,
        assumed: &mut Vec<Figure>,
    ) -> RateLimited {
        let Some(gear) = self.table.item(FileVesselKey::RUDDER).map(Entry::table) else {
            return RateLimited { value: 0.0, rate_per_s: 0.0, stop: 0.0 };
        };
        let stop = gear.number_if_any(FileRudderKey::STOP).unwrap_or_else(|| {
            assumed.push(figure("rudder.stop", "35°"));
            USUAL_STOP_RAD
        });
        let rate_per_s = match (gear.item(FileRudderKey::RATE), base) {
            (Some(rate), _) => *rate.number(),
            (None, Some((base, time_scale))) => {
                let rate = base.rudder.rate_per_s * time_scale;
                scaled.push(figure("rudder.rate", &format!("{}°/s", digits(rate.to_degrees()))));
                rate
            }
            (None, None) => {
                assumed.push(figure("rudder.rate", "2.32°/s"));
                USUAL_RATE_RADPS
            }
        };
        RateLimited { value: 0.0, rate_per_s, stop }
    }

    pub(super) fn shaft(
        &self,
        base: Option<(&VesselData, f64)>,
        scaled: &mut Vec<Figure>,
        assumed: &mut Vec<Figure>,
    ) -> Read<Option<Shaft>> {
        let Some(propeller) = self.table.item(FileVesselKey::PROPELLER).map(Entry::table) else {
            return Ok(None);
        };
        let reversal_s = propeller.number_if_any(FilePropellerKey::REVERSAL).unwrap_or_else(|| {
            assumed.push(figure("propeller.reversal", "40 s"));
            USUAL_REVERSAL_S
        });
        let of_base = base.and_then(|(base, time_scale)| Some(base.shaft?.full_rps * time_scale));
        let full_rps = match (propeller.item(FilePropellerKey::FULL), of_base) {
            (Some(full), _) => full.number() / TAU,
            (None, Some(full_rps)) => {
                let text = format!("{} rpm", digits(60.0 * full_rps));
                scaled.push(figure("propeller.full", &text));
                full_rps
            }
            (None, None) => {
                return Err(self.missing(
                    propeller,
                    FilePropellerKey::FULL,
                    "write full = \"95 rpm\"",
                ));
            }
        };
        Ok(Some(Shaft { full_rps, reversal_s }))
    }

    pub(super) fn thrusters(&self, ship: &Particulars) -> Read<Vec<ThrusterSetup>> {
        let read = |(name, table): (&String, Of<'_, _>)| {
            let along = table.given(ThrusterKey::ALONG);
            let along_m = *along.number();
            if along_m.abs() > 0.6 * ship.length_m {
                let message = format!(
                    "a place {along_m} m from midship is outside a ship of {} m",
                    ship.length_m
                );
                return Err(self.at(table, along, &message));
            }
            Ok(ThrusterSetup {
                name: name.clone(),
                tunnel: TunnelThruster {
                    bollard_n: *table.given(ThrusterKey::FORCE).number(),
                    along_m,
                },
                lag_s: *table.given(ThrusterKey::LAG).number(),
            })
        };
        let thrusters = self.table.given(FileVesselKey::THRUSTER).named().iter().map(read);
        let mut thrusters: Vec<ThrusterSetup> = thrusters.collect::<Read<_>>()?;
        // Sorted by name: forces are summed in this order, so that the order in the file has no effect.
        thrusters.sort_by(|one, other| one.name.cmp(&other.name));
        Ok(thrusters)
    }

    pub(super) fn azimuths(&self, ship: &Particulars) -> Read<Vec<AzimuthSetup>> {
        let tables = self.table.given(FileVesselKey::AZIMUTH).named();
        for (_, table) in tables {
            let farthest =
                [(AzimuthKey::ALONG, 0.6 * ship.length_m), (AzimuthKey::ACROSS, 0.5 * ship.beam_m)];
            for (key, most_m) in farthest {
                let place = table.given(key);
                let place_m = *place.number();
                if place_m.abs() > most_m {
                    let message = format!("a place at {place_m} m is outside the hull");
                    return Err(self.at(table, place, &message));
                }
            }
        }
        Ok(assemble::azimuths(tables))
    }
}
