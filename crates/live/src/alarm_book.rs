//! The list of alarms. An alarm is in the list while its cause is active, and after that until somebody acknowledges
//! it, as on a ship's bridge.

use crate::message::{AlarmNow, Role};
use crate::refusal::Refusal;

/// First word of the keys of alarms for contact of hulls.
pub(crate) const TOUCH: &str = "touch";
/// First word of the keys of alarms for overloaded fenders.
pub(crate) const FENDER: &str = "fender";

/// How urgent an alarm is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// A caution needs attention. A caution is removed from the list when its cause ends.
    Caution,
    /// An alarm needs action. An alarm stays in the list until somebody acknowledges it.
    Alarm,
}

impl Level {
    pub(crate) fn word(self) -> &'static str {
        match self {
            Level::Caution => "caution",
            Level::Alarm => "alarm",
        }
    }
}

/// An alarm whose cause is active in the present tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Alarm {
    /// How urgent the alarm is.
    pub level: Level,
    /// Key of the alarm: its kind and the bodies, tugs or lines that it is about. The list holds at most one alarm of
    /// each key.
    pub key: String,
    /// The text of the alarm that people read.
    pub text: String,
    /// Names of the bodies, tugs and lines that the alarm is about.
    pub about: Vec<String>,
}

/// An alarm in the list of alarms.
#[derive(Clone, Debug, PartialEq)]
struct Entry {
    alarm: Alarm,
    /// Time at which the alarm began, or became more urgent (s).
    since_s: f64,
    /// The last time at which the cause of the alarm was active (s).
    last_s: f64,
    /// True while the cause of the alarm is active.
    active: bool,
    acknowledged: bool,
}

/// A cause that comes again after more than this time is another event: a second touch, not the first that goes on (s).
const APART_S: f64 = 10.0;

/// All alarms that are active or that nobody acknowledged, in the order in which they began.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AlarmBook(Vec<Entry>);

impl AlarmBook {
    /// Updates the list with the causes that are active after a tick.
    pub fn update(&mut self, causes: Vec<Alarm>, t_s: f64) {
        for entry in &mut self.0 {
            entry.active = false;
        }
        for alarm in causes {
            match self.0.iter_mut().find(|entry| entry.alarm.key == alarm.key) {
                Some(entry) => entry.renew(alarm, t_s),
                None => {
                    let (active, acknowledged) = (true, false);
                    self.0.push(Entry { alarm, since_s: t_s, last_s: t_s, active, acknowledged })
                }
            }
        }
        self.0.retain(|entry| {
            entry.active || entry.alarm.level == Level::Alarm && !entry.acknowledged
        });
    }

    /// Checks that a role may acknowledge the alarm that has the key `key`, and returns the alarm's text.
    ///
    /// # Errors
    /// Fails if there is no alarm with the key, if somebody has acknowledged it already, or if the role may not
    /// acknowledge it.
    pub fn may_acknowledge(&self, key: &str, role: &Role) -> Result<&str, Refusal> {
        let entry = self.0.iter().find(|entry| entry.alarm.key == key);
        let entry =
            entry.ok_or_else(|| Refusal::new("the list of alarms has no such alarm any more"))?;
        match role {
            Role::Instructor | Role::Pilot { .. } => {}
            Role::Tugmaster { tug } if entry.alarm.about.contains(tug) => {}
            Role::Tugmaster { tug } => {
                return Err(Refusal::new(format_args!(
                    "the master of {tug} may acknowledge only the alarms of {tug}"
                )));
            }
            Role::Observer => return Err(Refusal::new("an observer cannot acknowledge alarms")),
        }
        if entry.acknowledged {
            return Err(Refusal::new("somebody has acknowledged this alarm already"));
        }
        Ok(&entry.alarm.text)
    }

    /// The text of the alarm that has the key `key`.
    pub(crate) fn text(&self, key: &str) -> Option<&str> {
        let entry = self.0.iter().find(|entry| entry.alarm.key == key)?;
        Some(&entry.alarm.text)
    }

    /// Level and text of the alarms that began, or became more urgent, at the given time.
    pub(crate) fn begun_at(&self, t_s: f64) -> impl Iterator<Item = (Level, &str)> {
        let begun = self.0.iter().filter(move |entry| entry.since_s == t_s);
        begun.map(|entry| (entry.alarm.level, entry.alarm.text.as_str()))
    }

    /// Acknowledges the alarm that has the key `key`. Does nothing if there is no alarm with the key, so that a version
    /// of the program with other alarms can still replay a recording.
    pub(crate) fn acknowledge(&mut self, key: &str) {
        let Some(at) = self.0.iter().position(|entry| entry.alarm.key == key) else { return };
        self.0[at].acknowledged = true;
        if !self.0[at].active {
            self.0.remove(at);
        }
    }

    /// The list of alarms for pages: alarms before cautions, each in the order in which they began.
    #[must_use]
    pub fn messages(&self) -> Vec<AlarmNow> {
        let mut all: Vec<&Entry> = self.0.iter().collect();
        // A stable sort keeps the order within a level.
        all.sort_by_key(|entry| std::cmp::Reverse(entry.alarm.level));
        all.into_iter().map(Entry::message).collect()
    }

    /// True if the list has an alarm of the fender `name` that nobody has acknowledged. An alarm of a fender says that
    /// the fender is or was loaded beyond its rating, or has failed.
    pub(crate) fn has_open_fender(&self, fender: &str) -> bool {
        self.0.iter().any(|entry| {
            let Alarm { level, key, about, .. } = &entry.alarm;
            !entry.acknowledged
                && *level == Level::Alarm
                && key.starts_with(FENDER)
                && about.iter().any(|name| name == fender)
        })
    }

    /// True if the list has a contact alarm of `hull` with a body that `on` selects, and nobody has acknowledged this
    /// alarm.
    pub(crate) fn has_open_touch(&self, hull: &str, on: impl Fn(&str) -> bool) -> bool {
        self.0.iter().any(|entry| {
            let about = &entry.alarm.about;
            !entry.acknowledged
                && entry.alarm.key.starts_with(TOUCH)
                && about.iter().any(|name| name == hull)
                && about.iter().any(|name| on(name))
        })
    }
}

impl Entry {
    /// Updates an alarm in the list whose cause is still active, or active again. An alarm in the list that nobody
    /// acknowledged keeps its greatest level.
    fn renew(&mut self, alarm: Alarm, t_s: f64) {
        self.active = true;
        let is_another = t_s - self.last_s > APART_S && alarm.level >= self.alarm.level;
        self.last_s = t_s;
        if alarm.level > self.alarm.level || is_another {
            // If the level rises, or the cause comes a second time, the alarm has to be acknowledged again.
            (self.acknowledged, self.since_s) = (false, t_s);
        }
        if self.acknowledged || alarm.level >= self.alarm.level {
            self.alarm = alarm;
        }
    }

    fn message(&self) -> AlarmNow {
        AlarmNow {
            level: self.alarm.level.word(),
            key: self.alarm.key.clone(),
            text: self.alarm.text.clone(),
            since_s: self.since_s,
            stands: self.active,
            acknowledged: self.acknowledged,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn touch(level: Level, text: &str) -> Alarm {
        Alarm {
            level,
            key: "touch ship quay".into(),
            text: text.into(),
            about: vec!["ship".into(), "quay".into()],
        }
    }

    fn acknowledge(book: &mut AlarmBook, role: &Role) -> Result<(), Refusal> {
        book.may_acknowledge("touch ship quay", role)?;
        book.acknowledge("touch ship quay");
        Ok(())
    }

    #[test]
    fn an_alarm_that_nobody_acknowledged_stays_when_its_cause_ends() {
        let mut book = AlarmBook::default();
        book.update(vec![touch(Level::Alarm, "touches")], 1.0);
        book.update(vec![], 2.0);
        let alarms = book.messages();
        assert_eq!(alarms.len(), 1);
        assert!(!alarms[0].stands && !alarms[0].acknowledged && alarms[0].since_s == 1.0);
        let on_quay = |name: &str| name == "quay";
        assert!(book.has_open_touch("ship", on_quay) && !book.has_open_touch("tug", on_quay));
        acknowledge(&mut book, &Role::PILOT).expect("a pilot may");
        assert!(book.messages().is_empty());
        let again = acknowledge(&mut book, &Role::PILOT);
        assert!(again.expect_err("it is gone").to_string().contains("no such alarm"));
    }

    #[test]
    fn acknowledged_alarms_and_cautions_are_removed_when_their_cause_ends() {
        let mut book = AlarmBook::default();
        book.update(vec![touch(Level::Alarm, "touches")], 1.0);
        acknowledge(&mut book, &Role::Instructor).expect("an instructor may");
        assert!(book.messages()[0].acknowledged && book.messages()[0].stands);
        let again = acknowledge(&mut book, &Role::PILOT).expect_err("it is acknowledged");
        assert!(again.to_string().contains("already"));
        book.update(vec![], 2.0);
        assert!(book.messages().is_empty());
        book.update(vec![touch(Level::Caution, "near")], 3.0);
        book.update(vec![], 4.0);
        assert!(book.messages().is_empty());
    }

    #[test]
    fn a_caution_that_becomes_an_alarm_must_be_acknowledged_again_and_keeps_its_greatest_level() {
        let mut book = AlarmBook::default();
        book.update(vec![touch(Level::Caution, "80 %")], 1.0);
        acknowledge(&mut book, &Role::PILOT).expect("a pilot may");
        book.update(vec![touch(Level::Alarm, "110 %")], 2.0);
        assert!(!book.messages()[0].acknowledged);
        book.update(vec![touch(Level::Caution, "90 %")], 3.0);
        assert_eq!((book.messages()[0].level, &*book.messages()[0].text), ("alarm", "110 %"));
        acknowledge(&mut book, &Role::PILOT).expect("a pilot may");
        book.update(vec![touch(Level::Caution, "90 %")], 4.0);
        assert_eq!((book.messages()[0].level, &*book.messages()[0].text), ("caution", "90 %"));
        assert!(book.messages()[0].acknowledged);
    }

    #[test]
    fn an_observer_and_the_master_of_another_tug_cannot_acknowledge() {
        let mut book = AlarmBook::default();
        book.update(vec![touch(Level::Alarm, "touches")], 1.0);
        for role in [Role::Observer, Role::Tugmaster { tug: "forward".into() }] {
            assert!(acknowledge(&mut book, &role).is_err());
        }
        assert!(!book.messages()[0].acknowledged);
        let own = Role::Tugmaster { tug: "ship".into() };
        assert!(acknowledge(&mut book, &own).is_ok());
    }

    /// A ship landed twice, four minutes apart, and the list had the speed of the second landing at the time of the first.
    #[test]
    fn a_second_landing_is_another_alarm_with_a_time_of_its_own() {
        let mut book = AlarmBook::default();
        let mut at = |t_s: f64, text: Option<&str>| {
            book.update(text.map(|text| touch(Level::Alarm, text)).into_iter().collect(), t_s);
            let now = book.messages();
            (now[0].since_s, now[0].text.clone())
        };
        assert_eq!(at(303.0, Some("0.16 m/s")), (303.0, "0.16 m/s".to_owned()));
        // The contact is lost and comes again: still the same landing.
        at(304.0, None);
        assert_eq!(at(308.0, Some("0.14 m/s")), (303.0, "0.14 m/s".to_owned()));
        at(309.0, None);
        assert_eq!(at(576.0, Some("0.18 m/s")), (576.0, "0.18 m/s".to_owned()));
    }
}
