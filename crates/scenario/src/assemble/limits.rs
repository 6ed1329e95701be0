//! Statistics of motions, and limits.

use fenderline_sim::VesselSetup;
use fenderline_sim::statistics::{LimitSetup, Limited, StatisticsSetup};

use super::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::keys::limit::Subject;

impl Assembly<'_, '_> {
    pub(super) fn statistics(
        &self,
        file: &Table,
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<StatisticsSetup> {
        let limits = file.given("limit").named();
        let from_s = file.item("statistics").map(|item| *item.table().given("from").number());
        if let Some(item) = file.item("statistics") {
            let from = item.table().given("from");
            let duration_s = *file.given("time").table().given("duration").number();
            if *from.number() >= duration_s {
                return Err(self.refused(item.table(), from, &"the run has ended by then"));
            }
        }
        let limits =
            limits.iter().map(|(name, table)| self.motion_limit(name, table, vessels, names));
        let limits = limits.collect::<Checked<Vec<LimitSetup>>>()?;
        let from_s = from_s.or((!limits.is_empty()).then_some(0.0));
        Ok(StatisticsSetup { from_s, limits })
    }

    fn motion_limit(
        &self,
        name: &str,
        table: &Table,
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<LimitSetup> {
        let subject = table.given("of");
        let motion = match subject.choice() {
            Subject::Motion(motion) => motion,
            others => {
                let word = subject.word();
                self.none_of(table, &["vessel", "statistic", "distance", "angle"], word)?;
                self.all_of(table, &["share"], "a limit of lines or fenders has a `share`")?;
                let what = if others == Subject::Lines { Limited::Lines } else { Limited::Fenders };
                let most = *table.given("share").number();
                return Ok(LimitSetup { name: name.to_owned(), what, most });
            }
        };
        let (key, others) = match motion.is_angle() {
            true => ("angle", ["distance", "share"]),
            false => ("distance", ["angle", "share"]),
        };
        self.none_of(table, &others, subject.word())?;
        let help = "a limit of a motion has a `statistic`, and a `distance` or an `angle`";
        self.all_of(table, &["statistic", key], help)?;
        let vessel = self.vessel_that_moves(table, subject, vessels, names)?;
        let measure = table.given("statistic").choice();
        let what = Limited::Motion { vessel, motion, measure };
        Ok(LimitSetup { name: name.to_owned(), what, most: *table.given(key).number() })
    }

    fn vessel_that_moves(
        &self,
        table: &Table,
        subject: &Item,
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<usize> {
        let Some(item) = table.item("vessel") else {
            if !vessels.is_empty() {
                return Ok(0);
            }
            let message = "only vessels have motions, and no body has a `vessel`";
            return Err(self.refused(table, subject, &message));
        };
        let body = self.body_named(table, item, item.name(), names)?;
        let found = vessels.iter().position(|vessel| vessel.body == body);
        found.ok_or_else(|| self.refused(table, item, &"this body is not a vessel"))
    }
}
