//! The docking board's report of each end of a ship over a sweep of poses. The report follows from the contacts and the
//! berth, not from distance alone.

use crate::support;

use fenderline_live::message::{BerthEnd, BerthNow, Frame, Role, RunState};
use fenderline_live::{Light, OtherAction, Session};

/// East coordinate of the line of the fenders in the scenario (m). The concrete is 1.9 m behind this line.
const FENDERS_M: f64 = 28.5;
/// Position of midship along the quay when the ship's parallel side lies at the eight fenders. The fenders are 20 m
/// apart, from −98 m to 42 m.
const MIDDLE_M: f64 = 0.0;

/// The ship at rest. Her midship is at `along_m` along the quay, and her parallel side is `off_m` off the fenders.
fn lying(along_m: f64, off_m: f64, heading_deg: f64) -> Session {
    lying_with(along_m, off_m, heading_deg, "{ surge = \"0 kn\" }")
}

/// The same ship with a velocity.
fn lying_with(along_m: f64, off_m: f64, heading_deg: f64, velocity: &str) -> Session {
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
            &format!("body.ship.velocity={velocity}"),
        ],
    )
}

/// A session whose alarms are updated every tick, as in the server.
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
    let ok = |text| (Light::Ok, text);
    let amber = |text| (Light::Caution, text);
    let red = |text| (Light::Alarm, text);
    for (pose, along_m, off_m, heading_deg, [bow, stern], [bow_lamp, stern_lamp]) in [
        ("off", MIDDLE_M, 10.0, 0.0, [Off, Off], [ok("OK"), ok("OK")]),
        ("off at an angle", MIDDLE_M, 60.0, 8.0, [Off, Off], [ok("OK"), ok("OK")]),
        (
            "alongside, starboard side to",
            MIDDLE_M,
            -0.3,
            0.0,
            [AtFenders, AtFenders],
            [ok("AT FENDERS"), ok("AT FENDERS")],
        ),
        (
            "at an angle, her bow on the fenders",
            MIDDLE_M,
            2.27,
            3.0,
            [AtFenders, Off],
            [ok("AT FENDERS"), ok("OK")],
        ),
        (
            "a fender beyond its rating",
            MIDDLE_M,
            -1.35,
            0.0,
            [OverRated, OverRated],
            [red("FENDER LIMIT"), red("FENDER LIMIT")],
        ),
        (
            "steel on concrete",
            MIDDLE_M,
            -2.0,
            0.0,
            [Structure, Structure],
            [red("STRUCTURE"), red("STRUCTURE")],
        ),
        (
            "on concrete where there is no fender",
            190.0,
            -2.0,
            0.0,
            [Structure, Structure],
            [red("STRUCTURE"), red("STRUCTURE")],
        ),
        (
            "her bow past the last fender, her stern at it",
            150.0,
            -1.0,
            0.0,
            [PastEnd, AtFenders],
            [amber("BEYOND FENDERS"), ok("AT FENDERS")],
        ),
        (
            "far past the quay's end",
            400.0,
            19.9,
            0.0,
            [PastEnd, PastEnd],
            [amber("BEYOND FENDERS"), amber("BEYOND FENDERS")],
        ),
        (
            "her bow past the last fender",
            80.0,
            10.0,
            0.0,
            [PastEnd, Off],
            [amber("BEYOND FENDERS"), ok("OK")],
        ),
        (
            "past the end and behind the line",
            400.0,
            -5.0,
            0.0,
            [PastEnd, PastEnd],
            [amber("BEYOND FENDERS"), amber("BEYOND FENDERS")],
        ),
    ] {
        let now = Run::of(lying(along_m, off_m, heading_deg)).step();
        assert_eq!([now.bow, now.stern], [bow, stern], "{pose}: {now:?}");
        let lamps = [now.bow_lamp, now.stern_lamp].map(|lamp| (lamp.light, lamp.text));
        assert_eq!(lamps, [bow_lamp, stern_lamp], "{pose}");
    }
}

/// True for each of bow and stern if its lamp may be green. The result follows from the frame and the geometry of the
/// scenario, without the code of the board.
fn may_be_green(frame: &Frame, session: &Session, heading_deg: f64) -> [bool; 2] {
    let setup = session.simulation().setup();
    let quay = setup.bodies.iter().position(|body| body.name == "quay").expect("a quay");
    let on_quay = |bodies: [usize; 2]| bodies.contains(&0) && bodies.contains(&quay);
    let touches = frame.contacts.iter().any(|c| c.fender.is_none() && on_quay(c.bodies));
    let touched = session.alarms().messages().iter().any(|alarm| {
        alarm.key == "touch ship quay" && alarm.level == "alarm" && !alarm.acknowledged
    });
    // The fenders stand from -98 to 42 m, 20 m apart. The flat of the ship's starboard side is where her outline is
    // widest.
    let outline = setup.bodies[0].outline.vertices();
    let ys = outline.iter().map(|at| at.y);
    let widest_m = ys.max_by(f64::total_cmp).expect("corners");
    let flat: Vec<_> = outline.iter().filter(|at| at.y >= 0.98 * widest_m).collect();
    let heading_rad = heading_deg.to_radians();
    let (sin, cos) = (libm::sin(heading_rad), libm::cos(heading_rad));
    let midship_m = session.simulation().states()[0].position_m.x;
    let along_m = |x: f64, y: f64| midship_m + x * cos - y * sin;
    let bow = flat.iter().max_by(|a, b| a.x.total_cmp(&b.x)).expect("a flat");
    let stern = flat.iter().min_by(|a, b| a.x.total_cmp(&b.x)).expect("a flat");
    let ways_m = [along_m(bow.x, bow.y), along_m(stern.x, stern.y)];
    std::array::from_fn(|end| {
        let is_off_the_berth = !(-118.0..=62.0).contains(&ways_m[end]);
        // The fenders in the half of this end.
        let middle_m = 0.5 * (ways_m[0] + ways_m[1]);
        let is_over = setup.fenders.iter().zip(&frame.fenders).any(|(fender, now)| {
            let way_m = fender.position_m.x + setup.bodies[quay].position_m.x;
            let is_here = if end == 0 { way_m >= middle_m } else { way_m <= middle_m };
            let is_over = now.failed || now.of_energy >= 1.0 || now.of_reaction >= 1.0;
            is_here && is_over
        });
        !(touches || touched || is_off_the_berth || is_over)
    })
}

#[test]
fn over_a_sweep_of_poses_the_board_is_never_green_where_it_must_not_be() {
    let (mut green, mut not_green) = (0, 0);
    for along_m in [-260.0, -150.0, 0.0, 55.0, 160.0] {
        for off_m in [-2.1, -1.4, -0.9, -0.3, 0.0, 20.0] {
            for heading_deg in [-4.0, 0.0, 0.4] {
                let mut session = lying(along_m, off_m, heading_deg);
                for step in 0..2 {
                    support::go(&mut session, 1);
                    let frame = session.frame(0, RunState::default());
                    let berth = frame.vessels[0].berth.expect("there is a berth");
                    let allowed = may_be_green(&frame, &session, heading_deg);
                    for (lamp, allowed) in [berth.bow_lamp, berth.stern_lamp].iter().zip(allowed) {
                        let is_green = lamp.light == Light::Ok;
                        assert!(
                            allowed || !is_green,
                            "{along_m} m along, {off_m} m off, {heading_deg} deg, step {step}: {berth:?}"
                        );
                        if is_green { green += 1 } else { not_green += 1 }
                    }
                }
            }
        }
    }
    // The sweep contains both cases.
    assert!(green > 50 && not_green > 50, "{green} green, {not_green} not");
}

/// The ship just off the fenders. She moves towards them.
fn landing(speed_mps: f64) -> Run {
    Run::of(lying_with(MIDDLE_M, 0.02, 0.0, &format!("{{ sway = {speed_mps} }}")))
}

/// The run at the step in which both ends are at fenders beyond their rating. `None` if this does not happen within ten
/// seconds.
fn beyond_its_rating(mut run: Run) -> Option<Run> {
    let found = (0..100).any(|_| run.step().bow == BerthEnd::OverRated);
    found.then_some(run)
}

#[test]
fn a_fender_that_was_beyond_its_rating_is_amber_until_that_is_acknowledged() {
    // The speed is just large enough for a load beyond the rating, so that no fender is compressed to its stop.
    let speeds_mps = (0..40).map(|step| 0.2 + 0.01 * f64::from(step));
    let mut run = speeds_mps.map(landing).find_map(beyond_its_rating).expect("at some speed");
    let frame = run.session.frame(0, RunState::default());
    assert!(frame.fenders.iter().all(|fender| !fender.failed), "{:?}", frame.fenders);
    until_over(&mut run, BerthEnd::OverRated);
    let now = run.berth();
    assert_eq!((now.bow, now.bow_lamp.light), (BerthEnd::WasOverRated, Light::Caution), "{now:?}");
    let open: Vec<String> = run.session.alarms().messages().into_iter().map(|a| a.key).collect();
    for key in open {
        support::command(&mut run.session, OtherAction::Acknowledge { key }.into());
    }
    let now = run.berth();
    assert!(now.bow < BerthEnd::Touched && now.bow_lamp.light < Light::Alarm, "{now:?}");
}

/// Takes steps until neither end reports `what`.
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
    // The contact pushes the ship off the concrete. The fenders have failed and stay failed.
    until_over(&mut run, BerthEnd::Structure);
    let now = run.berth();
    assert_eq!((now.bow, now.stern), (BerthEnd::OverRated, BerthEnd::OverRated), "{now:?}");
}

#[test]
fn a_contact_with_the_quay_stays_on_the_board_until_it_is_acknowledged() {
    // The ship lies at a part of the quay without fenders.
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
