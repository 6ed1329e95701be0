//! Reads the coefficients of hull, propeller and rudder, which are given as published or taken from another vessel.

use fenderline_sim::hydro::{
    AddedMass, CrossFlow, DriftPolynomial, LowSpeedHull, Particulars, Polynomial,
    SternCoefficients, SwayPolynomial,
};

use super::reading::Reading;
use crate::vessels::data::{AddedMassForm, Coefficients, VesselData};
use crate::vessels::figures::digits;
use crate::vessels::keys::FileVesselKey;
use crate::vessels::keys::hull::{
    FileAddedMassKey, FileDriftPolynomialKey, FileLowSpeedKey, FileSwayPolynomialKey,
};
use crate::vessels::keys::stern::{
    FilePropellerKey, FileRudderKey, FileStraighteningKey, FileThrustKey, FileWakeChangeKey,
};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::{Number, TableOf};
use fenderline_keys::typed_key::Key;

type Read<T> = Result<T, ScenarioError>;

impl Reading<'_, '_> {
    pub(super) fn coefficients(
        &self,
        base: Option<&VesselData>,
        ship: &Particulars,
    ) -> Read<Coefficients> {
        let table = self.table;
        fn inner<'t, R>(
            table: Of<'t, FileVesselKey>,
            key: Key<FileVesselKey, TableOf<R>>,
        ) -> Option<Of<'t, R>> {
            table.item_if_any(key).map(Entry::table)
        }
        let polynomial = match (
            inner(table, FileVesselKey::SWAY_POLYNOMIAL),
            table.item_if_any(FileVesselKey::DRIFT_POLYNOMIAL),
        ) {
            (Some(_), Some(item)) => {
                return Err(self.together(table, item, FileVesselKey::SWAY_POLYNOMIAL));
            }
            (Some(table), None) => Some(Polynomial::Sway(sway_polynomial(table))),
            (None, Some(item)) => Some(Polynomial::Drift(drift_polynomial(item.table()))),
            (None, None) => None,
        };
        let own = Coefficients {
            added_mass: inner(table, FileVesselKey::ADDED_MASS)
                .map(|table| self.added_mass(table, ship))
                .transpose()?,
            polynomial,
            low_speed: inner(table, FileVesselKey::LOW_SPEED).map(low_speed),
            stern: stern(
                inner(table, FileVesselKey::PROPELLER),
                inner(table, FileVesselKey::RUDDER),
            ),
        };
        let Some(base) = base.map(|base| &base.coefficients) else { return Ok(own) };
        Ok(Coefficients {
            added_mass: own.added_mass.or(base.added_mass),
            polynomial: own.polynomial.or(base.polynomial),
            low_speed: own.low_speed.or(base.low_speed),
            stern: own.stern.or(base.stern),
        })
    }

    pub(super) fn added_mass(
        &self,
        table: Of<'_, FileAddedMassKey>,
        ship: &Particulars,
    ) -> Read<AddedMassForm> {
        const VOLUMES: [Key<FileAddedMassKey, Number>; 3] = [
            FileAddedMassKey::SURGE_VOLUME,
            FileAddedMassKey::SWAY_VOLUME,
            FileAddedMassKey::YAW_VOLUME,
        ];
        let volumes = VOLUMES.map(|name| table.item(name));
        let coefficients = [
            FileAddedMassKey::SURGE,
            FileAddedMassKey::SWAY,
            FileAddedMassKey::YAW,
            FileAddedMassKey::YAW_WITH_SHIP,
        ]
        .map(|name| table.item(name));
        if let (Some(_), Some(item)) =
            (coefficients.iter().flatten().next(), volumes.iter().flatten().next().copied())
        {
            return Err(self
                .together(table, item, FileAddedMassKey::SURGE)
                .with_help("keep only one of the two forms of added mass"));
        }
        if volumes.iter().any(Option::is_some) {
            let mut values = [0.0; 3];
            for (value, (item, name)) in values.iter_mut().zip(volumes.into_iter().zip(VOLUMES)) {
                let missing = || {
                    self.missing(
                        table,
                        name,
                        "give `surge_volume`, `sway_volume` and `yaw_volume`, or none of the three",
                    )
                };
                *value = *item.ok_or_else(missing)?.number();
            }
            return Ok(AddedMassForm::Volumes(values, [ship.length_m, ship.draught_m]));
        }
        let [surge, sway, yaw, with_ship] = coefficients;
        let need = |item: Option<Entry<'_, Number>>, name: Key<FileAddedMassKey, Number>| {
            let missing = || self.missing(table, name, "give `surge`, `sway` and `yaw`");
            item.map(|item| *item.number()).ok_or_else(missing)
        };
        let yaw = match (yaw, with_ship) {
            (Some(_), Some(item)) => return Err(self.together(table, item, FileAddedMassKey::YAW)),
            (None, Some(item)) => {
                // Added inertia: the sum without the inertia of the ship.
                let mass = ship.volume_m3 / ship.mass_unit_m3();
                let own = mass * ship.yaw_gyradius_ratio * ship.yaw_gyradius_ratio;
                let left = item.number() - own;
                if left <= 0.0 {
                    let message = format!(
                        "the sum is less than the inertia of the ship without added mass, which is \
                         {}",
                        digits(own)
                    );
                    return Err(self.at(table, item, &message));
                }
                left
            }
            (yaw, None) => need(yaw, FileAddedMassKey::YAW)?,
        };
        Ok(AddedMassForm::Coefficients([
            need(surge, FileAddedMassKey::SURGE)?,
            need(sway, FileAddedMassKey::SWAY)?,
            yaw,
        ]))
    }
}

impl AddedMassForm {
    /// The added mass of a ship, computed from the published form. The coefficients of added mass are the same for
    /// every size of ship; added mass divided by density grows with L²d and L⁴d.
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

pub(super) fn sway_polynomial(table: Of<'_, FileSwayPolynomialKey>) -> SwayPolynomial {
    let of = |name: Key<_, Number>| *table.given(name).number();
    SwayPolynomial {
        resistance: of(FileSwayPolynomialKey::RESISTANCE),
        x_vv: of(FileSwayPolynomialKey::X_VV),
        x_vr: of(FileSwayPolynomialKey::X_VR),
        x_rr: of(FileSwayPolynomialKey::X_RR),
        x_vvvv: of(FileSwayPolynomialKey::X_VVVV),
        y_v: of(FileSwayPolynomialKey::Y_V),
        y_r: of(FileSwayPolynomialKey::Y_R),
        y_vvv: of(FileSwayPolynomialKey::Y_VVV),
        y_vvr: of(FileSwayPolynomialKey::Y_VVR),
        y_vrr: of(FileSwayPolynomialKey::Y_VRR),
        y_rrr: of(FileSwayPolynomialKey::Y_RRR),
        n_v: of(FileSwayPolynomialKey::N_V),
        n_r: of(FileSwayPolynomialKey::N_R),
        n_vvv: of(FileSwayPolynomialKey::N_VVV),
        n_vvr: of(FileSwayPolynomialKey::N_VVR),
        n_vrr: of(FileSwayPolynomialKey::N_VRR),
        n_rrr: of(FileSwayPolynomialKey::N_RRR),
    }
}

pub(super) fn drift_polynomial(table: Of<'_, FileDriftPolynomialKey>) -> DriftPolynomial {
    let of = |name: Key<_, Number>| *table.given(name).number();
    DriftPolynomial {
        x_0: of(FileDriftPolynomialKey::X_0),
        x_bb: of(FileDriftPolynomialKey::X_BB),
        x_br: of(FileDriftPolynomialKey::X_BR),
        x_rr: of(FileDriftPolynomialKey::X_RR),
        x_bbbb: of(FileDriftPolynomialKey::X_BBBB),
        y_b: of(FileDriftPolynomialKey::Y_B),
        y_r: of(FileDriftPolynomialKey::Y_R),
        y_bbb: of(FileDriftPolynomialKey::Y_BBB),
        y_bbr: of(FileDriftPolynomialKey::Y_BBR),
        y_brr: of(FileDriftPolynomialKey::Y_BRR),
        y_rrr: of(FileDriftPolynomialKey::Y_RRR),
        n_b: of(FileDriftPolynomialKey::N_B),
        n_r: of(FileDriftPolynomialKey::N_R),
        n_bbb: of(FileDriftPolynomialKey::N_BBB),
        n_bbr: of(FileDriftPolynomialKey::N_BBR),
        n_brr: of(FileDriftPolynomialKey::N_BRR),
        n_rrr: of(FileDriftPolynomialKey::N_RRR),
    }
}

pub(super) fn low_speed(table: Of<'_, FileLowSpeedKey>) -> LowSpeedHull {
    let of = |name: Key<_, Number>| *table.given(name).number();
    LowSpeedHull {
        ahead: of(FileLowSpeedKey::AHEAD),
        astern: of(FileLowSpeedKey::ASTERN),
        surge_vr: of(FileLowSpeedKey::X_VR),
        sway_v: of(FileLowSpeedKey::Y_V),
        sway_r: of(FileLowSpeedKey::Y_R),
        yaw_v: of(FileLowSpeedKey::N_V),
        yaw_r: of(FileLowSpeedKey::N_R),
        cross_flow: CrossFlow {
            drag_coefficient: of(FileLowSpeedKey::DRAG),
            yaw_gain_force: of(FileLowSpeedKey::YAW_GAIN_FORCE),
            yaw_gain_moment: of(FileLowSpeedKey::YAW_GAIN_MOMENT),
        },
    }
}

pub(super) fn stern(
    propeller: Option<Of<'_, FilePropellerKey>>,
    rudder: Option<Of<'_, FileRudderKey>>,
) -> SternCoefficients {
    fn number<T>(table: Option<Of<'_, T>>, key: Key<T, Number>) -> Option<f64> {
        table?.number_if_any(key)
    }
    fn inner<'t, T, R>(table: Option<Of<'t, T>>, key: Key<T, TableOf<R>>) -> Option<Of<'t, R>> {
        Some(table?.item_if_any(key)?.table())
    }
    fn of<T>(table: Of<'_, T>, key: Key<T, Number>) -> f64 {
        *table.given(key).number()
    }
    SternCoefficients {
        thrust_polynomial: inner(propeller, FilePropellerKey::THRUST).map(|table| {
            [FileThrustKey::K0, FileThrustKey::K1, FileThrustKey::K2].map(|name| of(table, name))
        }),
        series: propeller
            .and_then(|table| table.item_if_any(FilePropellerKey::SERIES))
            .map(Entry::choice),
        thrust_deduction: number(propeller, FilePropellerKey::THRUST_DEDUCTION),
        thrust_deduction_astern: number(propeller, FilePropellerKey::THRUST_DEDUCTION_ASTERN),
        wake: number(propeller, FilePropellerKey::WAKE),
        wake_change: inner(propeller, FilePropellerKey::WAKE_CHANGE).map(|table| {
            (
                of(table, FileWakeChangeKey::C1),
                [of(table, FileWakeChangeKey::C2_BELOW), of(table, FileWakeChangeKey::C2_ABOVE)],
            )
        }),
        propeller_place: number(propeller, FilePropellerKey::PLACE),
        lift_gradient: number(rudder, FileRudderKey::LIFT_GRADIENT),
        wake_ratio: number(rudder, FileRudderKey::WAKE_RATIO),
        race_gain: number(rudder, FileRudderKey::RACE_GAIN),
        straightening: inner(rudder, FileRudderKey::STRAIGHTENING).map(|table| {
            [FileStraighteningKey::BELOW, FileStraighteningKey::ABOVE].map(|name| of(table, name))
        }),
        straightening_place: number(rudder, FileRudderKey::STRAIGHTENING_PLACE),
        resistance_deduction: number(rudder, FileRudderKey::RESISTANCE_DEDUCTION),
        hull_gain: number(rudder, FileRudderKey::HULL_GAIN),
        hull_place: number(rudder, FileRudderKey::HULL_PLACE),
        rudder_place: number(rudder, FileRudderKey::PLACE),
    }
}
