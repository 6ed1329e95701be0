//! Finds the particulars of a berthing in its table, or takes them from the vessel and the water.

use fenderline_contact::number::greater;
use fenderline_sim::hydro::Particulars;
use fenderline_sim::{BodySetup, Environment, VesselSetup};

use super::assembly::{Assembly, Checked};
use crate::assemble::plausible::figures;
use fenderline_keys::checked::Of;
use fenderline_keys::held::Number;
use fenderline_keys::keys::berthing::BerthingKey;
use fenderline_keys::sources::quoted;
use fenderline_keys::typed_key::Key;

/// There is a warning if length, beam, draught or block coefficient in the table differ from the vessel's values by
/// more than this share.
const SAME_SHIP: f64 = 0.03;
/// There is a warning if the under-keel clearance in the table differs from the clearance by the water depth by more
/// than this share of the clearance by the water depth. The share is of the clearance, because Cm depends on the
/// clearance, which is small compared with the depth.
const SAME_CLEARANCE: f64 = 0.05;

/// The particulars of a ship that the formulas of the berthing energy use.
pub(super) struct Taken {
    pub(super) length_bp_m: f64,
    pub(super) beam_m: f64,
    pub(super) draught_m: f64,
    pub(super) under_keel_clearance_m: f64,
    pub(super) block_coefficient: f64,
}

/// A particular that is known from the scenario or the library, with its value and its source; the table of the
/// berthing may give the same particular.
struct Known {
    value: f64,
    from: String,
}

impl Assembly<'_, '_> {
    /// Finds the particulars of a berthing, and warns if the table disagrees with the vessel or with the water.
    ///
    /// # Errors
    /// Fails if neither the table nor the vessel gives a particular, or if the ship is aground.
    pub(super) fn particulars(
        &mut self,
        table: Of<'_, BerthingKey>,
        ship: usize,
        (bodies, vessels): (&[BodySetup], &[VesselSetup]),
        environment: &Environment,
    ) -> Checked<Taken> {
        let body = &bodies[ship];
        let vessel = vessels.iter().find(|vessel| vessel.body == ship);
        let particulars = vessel.map(|vessel| &vessel.deep.particulars);
        let of_vessel = |value: fn(&Particulars) -> f64| {
            let from = format!("the vessel of {}", quoted(&body.name));
            particulars.map(|particulars| Known { value: value(particulars), from })
        };
        let of_hull = body.hull.as_ref().filter(|_| vessel.is_none()).map(|hull| Known {
            value: hull.draught_m(),
            from: format!("the hull of {}", quoted(&body.name)),
        });
        let why = format!("{} is no vessel: give its own", quoted(&body.name));
        let length_bp_m = self.particular(
            table,
            BerthingKey::LENGTH_BP,
            of_vessel(|ship| ship.length_m),
            " m",
            &why,
        )?;
        let beam_m =
            self.particular(table, BerthingKey::BEAM, of_vessel(|ship| ship.beam_m), " m", &why)?;
        let draught = of_vessel(|ship| ship.draught_m).or(of_hull);
        let draught_m = self.particular(table, BerthingKey::DRAUGHT, draught, " m", &why)?;
        let block = of_vessel(Particulars::block_coefficient);
        let block_coefficient =
            self.particular(table, BerthingKey::BLOCK_COEFFICIENT, block, "", &why)?;
        let under_keel_clearance_m = self.clearance_m(table, body, draught_m, environment)?;
        Ok(Taken { length_bp_m, beam_m, draught_m, under_keel_clearance_m, block_coefficient })
    }

    fn clearance_m(
        &mut self,
        table: Of<'_, BerthingKey>,
        body: &BodySetup,
        draught_m: f64,
        environment: &Environment,
    ) -> Checked<f64> {
        let key = BerthingKey::UNDER_KEEL_CLEARANCE;
        let depth_m = environment.depth_at_m(body.position_m, 0.0).map_err(|error| {
            self.sources.error(&table.span, &table.path_of(key), error.to_string())
        })?;
        if let (Some(depth_m), None) = (depth_m, table.item(key))
            && depth_m < draught_m
        {
            let path = table.path_of(key);
            let message = format!(
                "`{path}`: {} is aground: a draught of {} m in {} m of water",
                quoted(&body.name),
                figures(draught_m),
                figures(depth_m)
            );
            let error = self.sources.error(&table.span, &path, message);
            return Err(error
                .with_help("check depth and tide in [environment], and the draught of the ship"));
        }
        let Some(depth_m) = depth_m else {
            let why = "[environment] has no depth: give the depth, or this key";
            return self.particular(table, key, None, " m", why);
        };
        let [least_m, most_m] = match environment.depth_range_m() {
            Some(range_m) if environment.bottom.is_none() => range_m,
            _ => environment
                .level_range_m()
                .map(|level_m| greater(depth_m - environment.level_m(0.0) + level_m, 0.0)),
        };
        let Some(item) = table.item(key) else { return Ok(depth_m - draught_m) };
        let given_m = *item.number();
        let off_m = greater(given_m - (most_m - draught_m), (least_m - draught_m) - given_m);
        if off_m > SAME_CLEARANCE * (depth_m - draught_m).abs() {
            let depth = match least_m == most_m {
                true => format!("{} m", figures(least_m)),
                false => format!("{} to {} m", figures(least_m), figures(most_m)),
            };
            let message = format!(
                "a clearance of {0} m is given, but `environment.depth` with the tide, {depth}, \
                 less the draught of {1} m is {2} m: {0} m is used",
                figures(given_m),
                figures(draught_m),
                figures(depth_m - draught_m),
            );
            self.note_at(&item.span, table.path_of(key), message);
        }
        Ok(given_m)
    }

    /// The number in the table for a particular, or else the number that is known from the scenario or the library.
    fn particular(
        &mut self,
        table: Of<'_, BerthingKey>,
        key: Key<BerthingKey, Number>,
        known: Option<Known>,
        unit: &str,
        why: &str,
    ) -> Checked<f64> {
        let Some(item) = table.item(key) else {
            return known.map(|known| known.value).ok_or_else(|| self.missing(table, key, why));
        };
        let given = *item.number();
        if let Some(Known { value, from }) = known
            && (given - value).abs() > SAME_SHIP * value.abs()
        {
            let [given, value] = [given, value].map(figures);
            let message = format!(
                "{given}{unit} is given, but {from} has {value}{unit}: {given}{unit} is used"
            );
            self.note_at(&item.span, table.path_of(key), message);
        }
        Ok(given)
    }
}
