//! The docking board's report of each end of a ship over a sweep of poses: from contacts and the berth, not from distance
//! alone.

mod support;

use fenderline_live::message::{BerthEnd, BerthNow, Role, RunState};
use fenderline_live::{OtherAction, Session};

/// The line of the fenders of the scenario is at this east coordinate (m), and the concrete 1.9 m behind it.
const FENDERS_M: f64 = 28.5;
/// Midship is here when her parallel side lies at the eight fenders, which are 20 m apart from −98 m to 42 m.
const MIDDLE_M: f64 = 0.0;

/// The ship at rest: midship at `along_m` along the quay, her parallel side `off_m` off the fenders.
fn lying(along_m: f64, off_m: f64, heading_deg: f64) -> Session {
    let half_beam_m = {
        let setup_of = support::harbour();
        setup_of.simulation().setup().bodies[0].outline.bounds().1.y
    };
    let east_m = FENDERS_M - off_m - half_beam_m;
    support::open(
        "scenarios/berth/alongside_with_two_tugs.toml",
        &[
            &format!("body.ship.position=[{along_m}, {east_m}]"),
            &format!("body.ship.heading=\"{heading_deg} deg\""),
            "body.ship.velocity={ surge = \"0 kn\" }",
        ],
    )
}

/// A session with alarms that are updated every tick, as in the server.
struct Run {
    session: Session,
}

impl Run {
    fn of(session: Session) -> Run {
        Run { session }
    }

    fn step(&mut self) -> BerthNow {
        support::go(&mut self.session, 1);
        self.berth()
    }

    fn berth(&self) -> BerthNow {
        let frame = self.session.frame(0, RunState::default());
        frame.vessels[0].berth.expect("there is a berth")
    }
}

#[test]
fn the_docking_board_reports_the_position_of_each_end() {
    use BerthEnd::{AtFenders, Off, OverRated, PastEnd, Structure};
    for (pose, along_m, off_m, heading_deg, bow, stern) in [
        ("off", MIDDLE_M, 10.0, 0.0, Off, Off),
        ("off at an angle", MIDDLE_M, 60.0, 8.0, Off, Off),
        ("alongside, starboard side to", MIDDLE_M, -0.3, 0.0, AtFenders, AtFenders),
        ("a fender beyond its rating", MIDDLE_M, -1.35, 0.0, OverRated, OverRated),
        ("steel on concrete", MIDDLE_M, -2.0, 0.0, Structure, Structure),
        ("far past the quay's end", 400.0, 19.9, 0.0, PastEnd, PastEnd),
        ("her bow past the last fender", 80.0, 10.0, 0.0, PastEnd, Off),
        ("past the end and behind the line", 400.0, -5.0, 0.0, PastEnd, PastEnd),
    ] {
        let now = Run::of(lying(along_m, off_m, heading_deg)).step();
        assert_eq!((now.bow, now.stern), (bow, stern), "{pose}: {now:?}");
    }
}

/// Steps until neither end reports this.
fn until_over(run: &mut Run, what: BerthEnd) {
    for _ in 0..6000 {
        let now = run.berth();
        if now.bow != what && now.stern != what {
            return;
        }
        run.step();
    }
    panic!("still there after ten minutes: {:?}", run.berth());
}

#[test]
fn a_hull_on_the_concrete_is_red_on_the_docking_board() {
    let mut run = Run::of(lying(MIDDLE_M, -2.0, 0.0));
    let now = run.step();
    assert!(now.bow_m < 0.0 && now.bow == BerthEnd::Structure, "{now:?}");
    // She is pushed off the concrete; the fenders have failed and stay failed.
    until_over(&mut run, BerthEnd::Structure);
    let now = run.berth();
    assert_eq!((now.bow, now.stern), (BerthEnd::OverRated, BerthEnd::OverRated), "{now:?}");
}

#[test]
fn a_contact_with_the_quay_stays_on_the_board_until_it_is_acknowledged() {
    // At a part of the quay without fenders.
    let mut run = Run::of(lying(190.0, -2.0, 0.0));
    let now = run.step();
    assert_eq!((now.bow, now.stern), (BerthEnd::Structure, BerthEnd::Structure), "{now:?}");
    until_over(&mut run, BerthEnd::Structure);
    let now = run.berth();
    assert_eq!((now.bow, now.stern), (BerthEnd::Touched, BerthEnd::Touched), "{now:?}");
    let (key, alarms) = ("touch ship quay", run.session.alarms().messages());
    assert!(alarms.iter().any(|alarm| alarm.key == key && !alarm.stands), "{alarms:?}");
    run.session.alarms().may_acknowledge(key, &Role::PILOT).expect("a pilot may");
    support::command(&mut run.session, OtherAction::Acknowledge { key: key.into() }.into());
    let now = run.berth();
    assert!(now.bow < BerthEnd::Touched && now.stern < BerthEnd::Touched, "{now:?}");
}
