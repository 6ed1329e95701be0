//! Coefficients of hull, propeller and rudder, as published or taken from another vessel.

use fenderline_sim::hydro::{
    AddedMass, CrossFlow, DriftPolynomial, LowSpeedHull, Particulars, Polynomial,
    SternCoefficients, SwayPolynomial,
};

use super::reading::Reading;
use crate::vessels::data::{AddedMassForm, Coefficients, VesselData};
use crate::vessels::figures::digits;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::error::ScenarioError;

type Read<T> = Result<T, ScenarioError>;

impl Reading<'_, '_> {
    pub(super) fn coefficients(
        &self,
        base: Option<&VesselData>,
        ship: &Particulars,
    ) -> Read<Coefficients> {
        let table = self.table;
        let inner = |name: &str| table.item_if_any(name).map(Item::table);
        let polynomial = match (inner("sway_polynomial"), table.item_if_any("drift_polynomial")) {
            (Some(_), Some(item)) => return Err(self.together(table, item, "sway_polynomial")),
            (Some(table), None) => Some(Polynomial::Sway(sway_polynomial(table))),
            (None, Some(item)) => Some(Polynomial::Drift(drift_polynomial(item.table()))),
            (None, None) => None,
        };
        let own = Coefficients {
            added_mass: inner("added_mass")
                .map(|table| self.added_mass(table, ship))
                .transpose()?,
            polynomial,
            low_speed: inner("low_speed").map(low_speed),
            stern: stern(inner("propeller"), inner("rudder")),
        };
        let Some(base) = base.map(|base| &base.coefficients) else { return Ok(own) };
        Ok(Coefficients {
            added_mass: own.added_mass.or(base.added_mass),
            polynomial: own.polynomial.or(base.polynomial),
            low_speed: own.low_speed.or(base.low_speed),
            stern: own.stern.or(base.stern),
        })
    }

    pub(super) fn added_mass(&self, table: &Table, ship: &Particulars) -> Read<AddedMassForm> {
        const VOLUMES: [&str; 3] = ["surge_volume", "sway_volume", "yaw_volume"];
        let volumes = VOLUMES.map(|name| table.item(name));
        let coefficients = ["surge", "sway", "yaw", "yaw_with_ship"].map(|name| table.item(name));
        if let (Some(_), Some(item)) =
            (coefficients.iter().flatten().next(), volumes.iter().flatten().next())
        {
            return Err(self.together(table, item, "surge").with_help("keep one form of the two"));
        }
        if volumes.iter().any(Option::is_some) {
            let mut values = [0.0; 3];
            for (value, (item, name)) in values.iter_mut().zip(volumes.into_iter().zip(VOLUMES)) {
                let missing = || self.missing(table, name, "give all three, or none");
                *value = *item.ok_or_else(missing)?.number();
            }
            return Ok(AddedMassForm::Volumes(values, [ship.length_m, ship.draught_m]));
        }
        let [surge, sway, yaw, with_ship] = coefficients;
        let need = |item: Option<&Item>, name: &str| {
            let missing = || self.missing(table, name, "give surge, sway and yaw");
            item.map(|item| *item.number()).ok_or_else(missing)
        };
        let yaw = match (yaw, with_ship) {
            (Some(_), Some(item)) => return Err(self.together(table, item, "yaw")),
            (None, Some(item)) => {
                // Added inertia: the sum without the inertia of the ship.
                let mass = ship.volume_m3 / ship.mass_unit_m3();
                let own = mass * ship.yaw_gyradius_ratio * ship.yaw_gyradius_ratio;
                let left = item.number() - own;
                if left <= 0.0 {
                    let message = format!(
                        "it is less than the inertia of the ship without added mass, which is {}",
                        digits(own)
                    );
                    return Err(self.at(table, item, &message));
                }
                left
            }
            (yaw, None) => need(yaw, "yaw")?,
        };
        Ok(AddedMassForm::Coefficients([need(surge, "surge")?, need(sway, "sway")?, yaw]))
    }
}

impl AddedMassForm {
    /// Added mass of a ship. Coefficients are the same for every size; volumes grow with L²d and L⁴d.
    pub(super) fn of(self, ship: &Particulars) -> AddedMass {
        match self {
            AddedMassForm::Coefficients([surge, sway, yaw]) => {
                AddedMass::from_mmg(ship, surge, sway, yaw)
            }
            AddedMassForm::Volumes([surge_m3, sway_m3, yaw_m5], [length_m, draught_m]) => {
                let length = ship.length_m / length_m;
                let mass = length * length * (ship.draught_m / draught_m);
                AddedMass { surge_m3, sway_m3, yaw_m5 }.scaled(mass, mass, mass * length * length)
            }
        }
    }
}

pub(super) fn sway_polynomial(table: &Table) -> SwayPolynomial {
    let of = |name: &str| *table.given(name).number();
    SwayPolynomial {
        resistance: of("resistance"),
        x_vv: of("x_vv"),
        x_vr: of("x_vr"),
        x_rr: of("x_rr"),
        x_vvvv: of("x_vvvv"),
        y_v: of("y_v"),
        y_r: of("y_r"),
        y_vvv: of("y_vvv"),
        y_vvr: of("y_vvr"),
        y_vrr: of("y_vrr"),
        y_rrr: of("y_rrr"),
        n_v: of("n_v"),
        n_r: of("n_r"),
        n_vvv: of("n_vvv"),
        n_vvr: of("n_vvr"),
        n_vrr: of("n_vrr"),
        n_rrr: of("n_rrr"),
    }
}

pub(super) fn drift_polynomial(table: &Table) -> DriftPolynomial {
    let of = |name: &str| *table.given(name).number();
    DriftPolynomial {
        x_0: of("x_0"),
        x_bb: of("x_bb"),
        x_br: of("x_br"),
        x_rr: of("x_rr"),
        x_bbbb: of("x_bbbb"),
        y_b: of("y_b"),
        y_r: of("y_r"),
        y_bbb: of("y_bbb"),
        y_bbr: of("y_bbr"),
        y_brr: of("y_brr"),
        y_rrr: of("y_rrr"),
        n_b: of("n_b"),
        n_r: of("n_r"),
        n_bbb: of("n_bbb"),
        n_bbr: of("n_bbr"),
        n_brr: of("n_brr"),
        n_rrr: of("n_rrr"),
    }
}

pub(super) fn low_speed(table: &Table) -> LowSpeedHull {
    let of = |name: &str| *table.given(name).number();
    LowSpeedHull {
        ahead: of("ahead"),
        astern: of("astern"),
        surge_vr: of("x_vr"),
        sway_v: of("y_v"),
        sway_r: of("y_r"),
        yaw_v: of("n_v"),
        yaw_r: of("n_r"),
        cross_flow: CrossFlow {
            drag_coefficient: of("drag"),
            yaw_gain_force: of("yaw_gain_force"),
            yaw_gain_moment: of("yaw_gain_moment"),
        },
    }
}

pub(super) fn stern(propeller: Option<&Table>, rudder: Option<&Table>) -> SternCoefficients {
    let number = |table: Option<&Table>, name: &str| table?.number_if_any(name);
    fn inner<'t>(table: Option<&'t Table>, name: &str) -> Option<&'t Table> {
        Some(table?.item_if_any(name)?.table())
    }
    let of = |table: &Table, name: &str| *table.given(name).number();
    SternCoefficients {
        thrust_polynomial: inner(propeller, "thrust")
            .map(|table| ["k0", "k1", "k2"].map(|name| of(table, name))),
        series: propeller.and_then(|table| table.item_if_any("series")).map(Item::choice),
        thrust_deduction: number(propeller, "thrust_deduction"),
        thrust_deduction_astern: number(propeller, "thrust_deduction_astern"),
        wake: number(propeller, "wake"),
        wake_change: inner(propeller, "wake_change")
            .map(|table| (of(table, "c1"), [of(table, "c2_below"), of(table, "c2_above")])),
        propeller_place: number(propeller, "place"),
        lift_gradient: number(rudder, "lift_gradient"),
        wake_ratio: number(rudder, "wake_ratio"),
        race_gain: number(rudder, "race_gain"),
        straightening: inner(rudder, "straightening")
            .map(|table| ["below", "above"].map(|name| of(table, name))),
        straightening_place: number(rudder, "straightening_place"),
        resistance_deduction: number(rudder, "resistance_deduction"),
        hull_gain: number(rudder, "hull_gain"),
        hull_place: number(rudder, "hull_place"),
        rudder_place: number(rudder, "place"),
    }
}
