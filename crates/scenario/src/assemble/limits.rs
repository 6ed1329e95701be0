//! Reads the statistics of motions, and the limits.

use fenderline_sim::VesselSetup;
use fenderline_sim::statistics::{LimitSetup, Limited, StatisticsSetup};

use super::assembly::{Assembly, Checked, Names};
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::limit::{LimitKey, StatisticsKey, Subject};
use fenderline_keys::keys::run::TimeKey;

impl Assembly<'_, '_> {
    pub(super) fn statistics(
        &self,
        file: Of<'_, ScenarioKey>,
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<StatisticsSetup> {
        let limits = file.given(ScenarioKey::LIMIT).named();
        let from_s = file
            .item(ScenarioKey::STATISTICS)
            .map(|item| *item.table().given(StatisticsKey::FROM).number());
        if let Some(item) = file.item(ScenarioKey::STATISTICS) {
            let from = item.table().given(StatisticsKey::FROM);
            let duration_s =
                *file.given(ScenarioKey::TIME).table().given(TimeKey::DURATION).number();
            if *from.number() >= duration_s {
                return Err(self.refused(item.table(), from, &"the run ends before this time"));
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
        table: Of<'_, LimitKey>,
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<LimitSetup> {
        let subject = table.given(LimitKey::OF);
        let motion = match subject.choice() {
            Subject::Motion(motion) => motion,
            others => {
                let word = subject.word();
                self.none_of(table, any_keys![LimitKey: VESSEL, STATISTIC, DISTANCE, ANGLE], word)?;
                self.all_of(
                    table,
                    any_keys![LimitKey: SHARE],
                    "a limit of lines or fenders needs a `share`",
                )?;
                let what = if others == Subject::Lines { Limited::Lines } else { Limited::Fenders };
                let most = *table.given(LimitKey::SHARE).number();
                return Ok(LimitSetup { name: name.to_owned(), what, most });
            }
        };
        let (key, others) = match motion.is_angle() {
            true => (LimitKey::ANGLE, any_keys![LimitKey: DISTANCE, SHARE]),
            false => (LimitKey::DISTANCE, any_keys![LimitKey: ANGLE, SHARE]),
        };
        self.none_of(table, others, subject.word())?;
        let help = "a limit of a motion needs a `statistic`, and a `distance` or an `angle`";
        self.all_of(table, &[LimitKey::STATISTIC.any(), key.any()], help)?;
        let vessel = self.vessel_that_moves(table, subject, vessels, names)?;
        let measure = table.given(LimitKey::STATISTIC).choice();
        let what = Limited::Motion { vessel, motion, measure };
        Ok(LimitSetup { name: name.to_owned(), what, most: *table.given(key).number() })
    }

    fn vessel_that_moves<V>(
        &self,
        table: Of<'_, LimitKey>,
        subject: Entry<'_, V>,
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<usize> {
        let Some(item) = table.item(LimitKey::VESSEL) else {
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
