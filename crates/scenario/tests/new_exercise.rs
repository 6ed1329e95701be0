//! Exercises that are made from choices run, whatever is chosen of the library; choices that make none are refused.

use fenderline_author::{
    BerthSource, BerthingSide, NewBerth, NewExercise, NewShip, NewTugs, NewWeather, can_be_ship,
    can_be_tug,
};
use fenderline_scenario::{FenderLibrary, Scenario, VesselLibrary};
use fenderline_sim::Simulation;

fn choices() -> NewExercise {
    NewExercise {
        title: "A \"new\" berth".to_owned(),
        berth: NewBerth {
            length_m: 300.0,
            depth_m: 24.0,
            fender: "cone SPC".to_owned(),
            size: None,
            height_m: Some(1.6),
            rated_reaction_n: Some(1.5e6),
            fenders: 5,
            fender_spacing_m: 30.0,
            bollard_spacing_m: 25.0,
        },
        berth_of: None,
        ship: NewShip {
            vessel: "bulk-carrier".to_owned(),
            side: BerthingSide::Starboard,
            off_m: 60.0,
            astern_m: 200.0,
            speed_mps: 0.8,
        },
        tugs: NewTugs { vessel: "asd-tug".to_owned(), number: 2 },
        weather: NewWeather {
            wind_mps: 6.0,
            wind_from_rad: 4.5,
            gusts: true,
            current_mps: 0.2,
            current_to_rad: 0.0,
            visibility_m: Some(500.0),
        },
    }
}

/// Half a minute of an exercise: nobody may touch anybody yet.
fn runs(choices: &NewExercise) {
    let text = choices.text().unwrap_or_else(|error| panic!("{choices:?}: {error}"));
    let scenario = Scenario::parse(&text, "new.toml").expect("it was read before");
    assert_eq!(scenario.title, choices.title);
    let tugs = choices.tugs.number;
    assert_eq!(scenario.setup.bodies.len(), 2 + tugs);
    assert_eq!(scenario.setup.fenders.len(), choices.berth.fenders + tugs);
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    for _ in 0..300 {
        let record = simulation.step().expect("a good step");
        assert_eq!(record.contacts.len(), 0, "{choices:?}");
    }
}

#[test]
fn every_ship_tug_fender_and_side_of_the_library_makes_an_exercise_that_runs() {
    runs(&choices());
    let vessels = VesselLibrary::built_in();
    let (mut ships, mut tugs) = (0, 0);
    for vessel in vessels.vessels() {
        if can_be_ship(vessel) {
            ships += 1;
            let mut with = choices();
            with.ship.vessel.clone_from(&vessel.name);
            with.ship.side = BerthingSide::Port;
            runs(&with);
        }
        if can_be_tug(vessel) {
            for number in 0..=4 {
                tugs += 1;
                let mut with = choices();
                with.tugs = NewTugs { vessel: vessel.name.clone(), number };
                runs(&with);
            }
        }
    }
    assert!(ships >= 4 && tugs >= 5, "{ships} ships, {tugs} tugs");
    for family in FenderLibrary::built_in().families() {
        let mut with = choices();
        with.berth.fender.clone_from(&family.name);
        with.berth.size = family.sizes.first().map(|size| size.designation.clone());
        runs(&with);
    }
}

#[test]
fn choices_that_make_no_exercise_are_refused_with_the_reason() {
    let refused = |change: &dyn Fn(&mut NewExercise)| {
        let mut choices = choices();
        change(&mut choices);
        choices.text().expect_err("it makes none").to_string()
    };
    type Change = &'static dyn Fn(&mut NewExercise);
    let cases: [(Change, &str); 12] = [
        (&|of| of.ship.vessel = "bulk-carier".to_owned(), "no vessel named \"bulk-carier\""),
        (&|of| of.ship.vessel = "kvlcc2-model".to_owned(), "not a ship"),
        (&|of| of.ship.vessel = "asd-tug".to_owned(), "not a ship"),
        (&|of| of.tugs.vessel = "kcs".to_owned(), "no tug"),
        (&|of| of.tugs.number = 5, "5 tugs are more than the 4"),
        (&|of| of.berth.fender = "tyre".to_owned(), "tyre"),
        (&|of| of.berth.size = Some("9".to_owned()), "no size"),
        (&|of| of.berth.height_m = None, "height and rated reaction"),
        (&|of| of.berth.fenders = 0, "at least one fender"),
        (&|of| of.berth.fenders = 30, "longer than the quay"),
        (&|of| of.berth.length_m = f64::NAN, "length of the quay"),
        (&|of| of.title = "a\nb".to_owned(), "line break"),
    ];
    for (change, reason) in cases {
        let error = refused(change);
        assert!(error.contains(reason), "{error}\n{reason}");
    }
    assert!(refused(&|of| of.weather.wind_mps = 900.0).contains("environment.wind.speed"));
    assert!(refused(&|of| of.berth.depth_m = f64::INFINITY).contains("environment.depth"));
}

/// Berths with their own charts, headings and water: the ship comes to each with her chosen side, and starts clear of all.
#[test]
fn an_exercise_takes_the_berth_of_another_scenario() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios");
    for file in [
        "live/berthing.toml",
        "live/harbour.toml",
        "live/unberthing.toml",
        "live/moored_in_a_squall.toml",
        "berth/alongside_with_two_tugs.toml",
    ] {
        let path = std::path::Path::new(folder).join(file);
        let source = std::fs::read_to_string(&path).expect("a scenario");
        let mut read = |name: &str| {
            std::fs::read_to_string(path.with_file_name(name)).map_err(|why| why.to_string())
        };
        let before = Scenario::parse_among(&source, file, &[], &mut read).expect("a scenario");
        let fixed = |scenario: &Scenario| -> Vec<String> {
            let bodies = scenario.setup.bodies.iter().filter(|body| body.is_fixed());
            bodies.map(|body| body.name.clone()).collect()
        };
        for side in [BerthingSide::Port, BerthingSide::Starboard] {
            let mut with = choices();
            with.ship.side = side;
            let source = BerthSource { file, text: &source };
            let text = with.text_at(source, &mut read).unwrap_or_else(|e| panic!("{file}: {e}"));
            let after = Scenario::parse_among(&text, "new.toml", &[], &mut read).expect("good");
            assert_eq!(fixed(&after), fixed(&before), "{file}");
            assert_eq!(after.setup.world.chart, before.setup.world.chart, "{file}");
            assert_eq!(after.setup.world.bollards.len(), before.setup.world.bollards.len());
            let [berth, old] =
                [&after, &before].map(|of| fenderline_author::fixed_berth(&of.setup).unwrap());
            assert_eq!(berth.length_m(), old.length_m(), "{file}");
            let ship = after.setup.bodies.iter().position(|body| body.name == "ship").unwrap();
            let mut simulation = Simulation::new(after.setup).expect("a good set-up");
            let (states, bodies) = (simulation.states(), &simulation.setup().bodies);
            let lie = berth.lie(&states[berth.body], &bodies[ship].outline, &states[ship]);
            // Both ends of the flat of her side lie 60 m off, and she is parallel to it; a place is written to 0.1 m and a
            // heading to 0.1°, of which half is 0.1 m over half of her length.
            assert!(lie.off_m.iter().all(|off_m| (off_m - 60.0).abs() < 0.35), "{file}: {lie:?}");
            assert!(lie.angle_rad.abs() < 1e-3 * 1.75 / 2.0 + 1e-9, "{file}: {lie:?}");
            for _ in 0..100 {
                let record = simulation.step().expect("a good step");
                assert_eq!(record.contacts.len(), 0, "{file}, {side:?}");
            }
        }
    }
    let at_sea = BerthSource {
        file: "sea.toml",
        text: "[time]\nstep = 1\nduration = 9\n[body.a]\nmass = 1\ngyradius = 1\noutline = [[0, 0], [1, 0], [0, 1]]\n",
    };
    let refused = choices().text_at(at_sea, &mut |name| Err(name.to_owned())).unwrap_err();
    assert!(refused.to_string().contains("has no berth"), "{refused}");
}
