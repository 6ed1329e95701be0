//! The alarms that the server holds: what stands, what was acknowledged, and what went before anybody had seen it. As
//! on a bridge: an alarm that nobody acknowledged stays when its cause ends.

use crate::message::{AlarmNow, Role};
use crate::refusal::Refusal;

/// What the keys of touches begin with.
pub(crate) const TOUCH: &str = "touch";

/// How urgent an alarm is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Something to keep an eye on. It goes when its cause ends.
    Caution,
    /// Something to act upon. It stays until it is acknowledged.
    Alarm,
}

impl Level {
    fn word(self) -> &'static str {
        match self {
            Level::Caution => "caution",
            Level::Alarm => "alarm",
        }
    }
}

/// A cause that stands in this tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Alarm {
    /// How urgent.
    pub level: Level,
    /// What kind it is and of what: one of each stands at a time.
    pub key: String,
    /// In words.
    pub text: String,
    /// The bodies, tugs and lines that it is about.
    pub about: Vec<String>,
}

/// An alarm in the book.
#[derive(Clone, Debug, PartialEq)]
struct Entry {
    alarm: Alarm,
    /// When it came, or grew to an alarm (s).
    since_s: f64,
    stands: bool,
    acknowledged: bool,
}

/// All alarms that stand or want to be acknowledged, in the order in which they came.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AlarmBook(Vec<Entry>);

impl AlarmBook {
    /// Takes what stands after a tick.
    pub fn note(&mut self, standing: Vec<Alarm>, t_s: f64) {
        for entry in &mut self.0 {
            entry.stands = false;
        }
        for alarm in standing {
            match self.0.iter_mut().find(|entry| entry.alarm.key == alarm.key) {
                Some(entry) => entry.goes_on(alarm, t_s),
                None => {
                    self.0.push(Entry { alarm, since_s: t_s, stands: true, acknowledged: false })
                }
            }
        }
        self.0.retain(|entry| {
            entry.stands || entry.alarm.level == Level::Alarm && !entry.acknowledged
        });
    }

    /// Forgets everything: another run is shown, or another time of this one.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Acknowledges an alarm; its text.
    ///
    /// # Errors
    /// There is none of that key, or it is not this role's to acknowledge.
    pub fn acknowledge(&mut self, key: &str, role: &Role) -> Result<String, Refusal> {
        let at = self.0.iter().position(|entry| entry.alarm.key == key);
        let at = at.ok_or_else(|| Refusal::new("there is no such alarm any more"))?;
        let entry = &mut self.0[at];
        match role {
            Role::Instructor | Role::Pilot => {}
            Role::Tugmaster { tug } if entry.alarm.about.contains(tug) => {}
            Role::Tugmaster { tug } => {
                return Err(Refusal::new(format_args!(
                    "the master of {tug} acknowledges her alarms alone"
                )));
            }
            Role::Observer => return Err(Refusal::new("an observer acknowledges nothing")),
        }
        entry.acknowledged = true;
        let text = entry.alarm.text.clone();
        if !entry.stands {
            self.0.remove(at);
        }
        Ok(text)
    }

    /// As pages are told: alarms before cautions, then in the order in which they came.
    #[must_use]
    pub fn told(&self) -> Vec<AlarmNow> {
        let mut all: Vec<&Entry> = self.0.iter().collect();
        // Stable.
        all.sort_by_key(|entry| std::cmp::Reverse(entry.alarm.level));
        all.into_iter().map(Entry::told).collect()
    }

    /// Was a hull on something of these, and has nobody acknowledged it yet?
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
    /// Its cause stands on, or again. One that nobody acknowledged keeps the worst that it was.
    fn goes_on(&mut self, alarm: Alarm, t_s: f64) {
        self.stands = true;
        if alarm.level > self.alarm.level {
            // One that grows worse wants to be acknowledged again.
            (self.acknowledged, self.since_s) = (false, t_s);
        }
        if self.acknowledged || alarm.level >= self.alarm.level {
            self.alarm = alarm;
        }
    }

    fn told(&self) -> AlarmNow {
        AlarmNow {
            level: self.alarm.level.word(),
            key: self.alarm.key.clone(),
            text: self.alarm.text.clone(),
            since_s: self.since_s,
            stands: self.stands,
            acknowledged: self.acknowledged,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(level: Level, text: &str) -> Alarm {
        Alarm {
            level,
            key: "touch ship quay".into(),
            text: text.into(),
            about: vec!["ship".into(), "quay".into()],
        }
    }

    #[test]
    fn an_alarm_that_nobody_acknowledged_stays_when_its_cause_ends() {
        let mut book = AlarmBook::default();
        book.note(vec![of(Level::Alarm, "touches")], 1.0);
        book.note(vec![], 2.0);
        let told = book.told();
        assert_eq!(told.len(), 1);
        assert!(!told[0].stands && !told[0].acknowledged && told[0].since_s == 1.0);
        let on_quay = |name: &str| name == "quay";
        assert!(book.has_open_touch("ship", on_quay) && !book.has_open_touch("tug", on_quay));
        book.acknowledge("touch ship quay", &Role::Pilot).expect("a pilot may");
        assert!(book.told().is_empty());
        let again = book.acknowledge("touch ship quay", &Role::Pilot);
        assert!(again.expect_err("it is gone").to_string().contains("no such alarm"));
    }

    #[test]
    fn an_acknowledged_alarm_goes_with_its_cause_and_a_caution_with_its_own() {
        let mut book = AlarmBook::default();
        book.note(vec![of(Level::Alarm, "touches")], 1.0);
        book.acknowledge("touch ship quay", &Role::Instructor).expect("an instructor may");
        assert!(book.told()[0].acknowledged && book.told()[0].stands);
        book.note(vec![], 2.0);
        assert!(book.told().is_empty());
        book.note(vec![of(Level::Caution, "near")], 3.0);
        book.note(vec![], 4.0);
        assert!(book.told().is_empty());
    }

    #[test]
    fn a_caution_that_grows_to_an_alarm_wants_to_be_acknowledged_again_and_keeps_its_worst() {
        let mut book = AlarmBook::default();
        book.note(vec![of(Level::Caution, "80 %")], 1.0);
        book.acknowledge("touch ship quay", &Role::Pilot).expect("a pilot may");
        book.note(vec![of(Level::Alarm, "110 %")], 2.0);
        assert!(!book.told()[0].acknowledged);
        book.note(vec![of(Level::Caution, "90 %")], 3.0);
        assert_eq!((book.told()[0].level, &*book.told()[0].text), ("alarm", "110 %"));
        book.acknowledge("touch ship quay", &Role::Pilot).expect("a pilot may");
        book.note(vec![of(Level::Caution, "90 %")], 4.0);
        assert_eq!((book.told()[0].level, &*book.told()[0].text), ("caution", "90 %"));
        assert!(book.told()[0].acknowledged);
    }

    #[test]
    fn an_observer_and_another_ships_tugmaster_acknowledge_nothing() {
        let mut book = AlarmBook::default();
        book.note(vec![of(Level::Alarm, "touches")], 1.0);
        for role in [Role::Observer, Role::Tugmaster { tug: "forward".into() }] {
            assert!(book.acknowledge("touch ship quay", &role).is_err());
        }
        assert!(!book.told()[0].acknowledged);
        let own = Role::Tugmaster { tug: "ship".into() };
        assert!(book.acknowledge("touch ship quay", &own).is_ok());
    }
}
