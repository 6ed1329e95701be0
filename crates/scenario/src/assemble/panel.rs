//! Turns the table of a panel on several cones into the set-up of the panel.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{FenderLaw, Panel, Unloading};
use fenderline_sim::Rated;

use super::assembly::{Assembly, Checked};
use super::performance::Performance;
use crate::vessels::Belting;
use fenderline_keys::checked::Of;
use fenderline_keys::held::Number;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::keys::panel::ConeKey;
use fenderline_keys::typed_key::Key;

/// A panel on cones, and the height of the reaction above the middle of the fender's face (m).
pub(super) struct PanelParts {
    pub(super) panel: Panel,
    pub(super) reaction_above_m: f64,
}

impl Assembly<'_, '_> {
    /// Reads the panel of a fender with `cones`; `None` for a fender without `cones`.
    pub(super) fn panel(
        &self,
        table: Of<'_, FenderKey>,
        face: &Belting,
        performance: &Performance,
    ) -> Checked<Option<PanelParts>> {
        let Some(item) = table.item(FenderKey::CONES) else { return Ok(None) };
        let cones = item.list();
        let path = table.path_of(FenderKey::CONES);
        let refused = |message: String, help: &str| {
            Err(self.sources.error(&item.span, &path, message).with_help(help))
        };
        if performance.law == FenderLaw::Area {
            let message =
                format!("`{path}` is for fenders with a `type`, a `stiffness` or a `curve`");
            return refused(message, "give the cones a `type`, a `stiffness` or a `curve`");
        }
        if !(2..=Panel::MOST_CONES).contains(&cones.len()) {
            let message = format!(
                "`{path}` must be 2 to {} cones, but has {}",
                Panel::MOST_CONES,
                cones.len()
            );
            return refused(message, "write a panel on one cone as a fender without `cones`");
        }
        for cone in cones {
            self.within(cone, ConeKey::AT, face.width_m, "width")?;
            self.within(cone, ConeKey::HEIGHT, face.extent_m, "face_height")?;
        }
        let cones_m: Vec<f64> =
            cones.iter().map(|cone| *cone.given(ConeKey::AT).number()).collect();
        let (low_m, high_m) =
            cones_m.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &at| {
                (lesser(low, at), greater(high, at))
            });
        if high_m - low_m < Panel::LEAST_SPREAD_M {
            let message = format!(
                "`{path}`: all cones stand at one place along the panel and cannot hold the panel \
                 against turning"
            );
            return refused(
                message,
                "for cones one above another write `count` instead of `cones`",
            );
        }
        if let FenderLaw::Curve(points) = &performance.law
            && points[1][1] <= 0.0
        {
            let message = format!("`{path}`: the first line of the cones' curve must rise");
            return refused(
                message,
                "the slope of this line is the stiffness of a cone that the panel stretches",
            );
        }
        let height_m =
            |cone: Of<'_, ConeKey>| cone.item(ConeKey::HEIGHT).map_or(0.0, |item| *item.number());
        let reaction_above_m = cones.iter().map(height_m).sum::<f64>() / cones.len() as f64;
        Ok(Some(PanelParts {
            panel: Panel { cones_m, tension_chains: Vec::new() },
            reaction_above_m,
        }))
    }

    /// Refuses a place of a cone or chain that is outside the panel.
    pub(super) fn within<T>(
        &self,
        cone: Of<'_, T>,
        name: Key<T, Number>,
        size_m: f64,
        of: &str,
    ) -> Checked<()> {
        let Some(item) = cone.item(name) else { return Ok(()) };
        let at_m = *item.number();
        let most_m = 0.5 * size_m;
        if at_m.abs() <= most_m {
            return Ok(());
        }
        let path = cone.path_of(name);
        let message = format!(
            "`{path}` must be between {} and {most_m} m, which is half of the panel's `{of}` from \
             the middle of the panel, but is {at_m} m",
            -most_m
        );
        Err(self.sources.error(&item.span, &path, message))
    }
}

impl PanelParts {
    /// The rating of all cones behind a panel together.
    pub(super) fn rated(&self, of_cone: Option<Rated>) -> Option<Rated> {
        let cones = self.panel.cones_m.len() as f64;
        of_cone.map(|rated| Rated {
            deflection_m: rated.deflection_m,
            reaction_n: cones * rated.reaction_n,
            largest_reaction_n: cones * rated.largest_reaction_n,
            energy_j: cones * rated.energy_j,
        })
    }

    /// The unloading law of the cones behind a panel. An unloading curve counts only with the share of the energy that
    /// it returns from the rated deflection, because the energy of a panel is a sum over cones of different
    /// deflections.
    pub(super) fn unloading(
        &self,
        of_cone: Option<Unloading>,
        performance: &Performance,
    ) -> Option<Unloading> {
        match of_cone? {
            law @ Unloading::Curve(_) => {
                let rated_m = performance.rated.map_or(performance.end_m, |r| r.deflection_m);
                let share = law.returned_share(&performance.law, rated_m);
                Some(Unloading::ReturnedEnergy(bounded(share, Unloading::MIN_RETURNED_SHARE, 1.0)))
            }
            share @ Unloading::ReturnedEnergy(_) => Some(share),
        }
    }
}
