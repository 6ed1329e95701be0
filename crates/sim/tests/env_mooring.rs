//! Mooring lines, compared with MoorPy, with closed forms and with the laws of a passive line.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use fenderline_sim::constants::STANDARD_GRAVITY_MPS2 as G;
use fenderline_sim::mooring::*;
use proptest::prelude::*;

/// The cable of validation/lines_and_tugs.toml: EA 1e9 N, 200 kg/m, ø 0.1 m in sea water.
fn reference(length_m: f64) -> Cable {
    let displaced_kgpm = 1025.0 * std::f64::consts::PI * 0.1 * 0.1 / 4.0;
    Cable { length_m, axial_stiffness_n: 1e9, weight_npm: (200.0 - displaced_kgpm) * G }
}

fn close(ours: f64, theirs: f64, relative: f64) {
    assert!((ours / theirs - 1.0).abs() < relative, "{ours} for {theirs}");
}

/// Values of MoorPy 3.0, and of the sums in validation/independent/ship_formulas.py. For a span of 200 m, a depth of 50
/// m and 210 m of cable they give T 577.7, H 483.6 and V 316.0 kN. The tolerance is 0.2 %.
#[test]
fn the_reference_cable_of_moorpy_and_moordyn() {
    let c = catenary(&reference(210.0), 200.0, 50.0, true);
    println!("T {} H {} V {}", c.upper_tension_n(), c.horizontal_n, c.upper_vertical_n);
    close(c.upper_tension_n(), 577.7e3, 0.002);
    close(c.horizontal_n, 483.6e3, 0.002);
    close(c.upper_vertical_n, 316.0e3, 0.002);
}

/// A cable without stretch, partly on the bottom, with the given H. Then s = h√(1 + 2a/h) with a = H/w, and the span is
/// L − s + a·asinh(s/a). EA of 1e16 N stretches 210 m by 1e-8 m.
#[test]
fn an_inextensible_cable_on_the_bottom() {
    let (w, h_n, depth_m, length_m): (f64, f64, f64, f64) = (2000.0, 1.5e5, 50.0, 210.0);
    let a_m = h_n / w;
    let s_m = depth_m * (1.0 + 2.0 * a_m / depth_m).sqrt();
    assert!(s_m < length_m);
    let span_m = length_m - s_m + a_m * (s_m / a_m).asinh();
    let cable = Cable { length_m, axial_stiffness_n: 1e16, weight_npm: w };
    let c = catenary(&cable, span_m, depth_m, true);
    close(c.horizontal_n, h_n, 1e-6);
    close(c.upper_vertical_n, w * s_m, 1e-6);
    close(c.on_bottom_m, length_m - s_m, 1e-6);
    assert_eq!(c.lower_vertical_n, 0.0);
}

/// A cable without stretch between two points at one height: L = 2a·sinh(X/2a), V = wL/2.
#[test]
fn an_inextensible_cable_between_equal_heights() {
    let (w, h_n, span_m): (f64, f64, f64) = (500.0, 4e4, 100.0);
    let a_m = h_n / w;
    let length_m = 2.0 * a_m * (span_m / (2.0 * a_m)).sinh();
    let cable = Cable { length_m, axial_stiffness_n: 1e16, weight_npm: w };
    let c = catenary(&cable, span_m, 0.0, false);
    close(c.horizontal_n, h_n, 1e-6);
    close(c.upper_vertical_n, 0.5 * w * length_m, 1e-9);
    close(c.lower_vertical_n, -0.5 * w * length_m, 1e-9);
}

/// The cable is so taut that its weight does not matter: T = EA·(X − L)/L. With T/wL = 1000 the sag changes the length
/// by (wL/T)²/24, which is 4e-8, against a stretch of 1e-3.
#[test]
fn a_taut_cable_is_a_spring() {
    let cable = Cable { length_m: 100.0, axial_stiffness_n: 1e9, weight_npm: 10.0 };
    let c = catenary(&cable, 100.1, 0.0, false);
    close(c.horizontal_n, 1e6, 1e-4);
}

/// Slack, plumb and lying cables. Their weights are computed by hand. EA is 1e9 N, so the stretch is below 1e-4.
#[test]
fn slack_cables_carry_their_own_weight_and_no_more() {
    let cable = Cable { length_m: 300.0, axial_stiffness_n: 1e9, weight_npm: 1000.0 };
    let lying = catenary(&cable, 200.0, 50.0, true);
    assert_eq!(lying.horizontal_n, 0.0);
    close(lying.upper_vertical_n, 50e3, 1e-4);
    close(lying.on_bottom_m, 250.0, 1e-4);
    let loose = catenary(&cable, 0.0, 50.0, false);
    close(loose.upper_vertical_n, 175e3, 1e-4);
    close(loose.lower_vertical_n, -125e3, 1e-4);
    let flat = catenary(&cable, 299.0, 0.0, true);
    assert_eq!(flat.upper_tension_n(), 0.0);
    // A cable on the bottom that is drawn just taut has EA·(X − L)/L.
    let drawn = catenary(&cable, 300.3, 0.0, true);
    close(drawn.horizontal_n, 1e6, 1e-6);
}

proptest! {
    /// Any cable in any place is in equilibrium. It spans its distance (the test writes the equations anew), it pulls
    /// back, and the vertical forces carry the part of its weight that does not lie on the bottom.
    #[test]
    fn any_cable_is_in_equilibrium(
        length_m in 10.0..1000.0_f64,
        stretch in -6.0..-2.0_f64,
        weight_npm in 10.0..5000.0_f64,
        reach in 0.01..1.004_f64,
        slope_rad in 0.0..1.5_f64,
        on_bottom: bool,
    ) {
        let axial_stiffness_n = weight_npm * length_m / 10.0_f64.powf(stretch);
        let cable = Cable { length_m, axial_stiffness_n, weight_npm };
        let (span_m, rise_m) = (reach * length_m * slope_rad.cos(), reach * length_m * slope_rad.sin());
        let c = catenary(&cable, span_m, rise_m, on_bottom);
        prop_assert!(c.horizontal_n >= 0.0 && c.upper_tension_n().is_finite());
        let carried_n = weight_npm * (length_m - c.on_bottom_m);
        let sum_n = c.upper_vertical_n - c.lower_vertical_n;
        prop_assert!((sum_n - carried_n).abs() <= 1e-9 * (1.0 + c.upper_tension_n().max(carried_n)));
        if c.horizontal_n > 1e-6 * weight_npm * length_m {
            // The shape is the sum of 20 000 straight pieces from the upper end.
            let n = 20_000;
            let ds_m = length_m / f64::from(n);
            let (mut x_m, mut z_m) = (0.0, 0.0);
            for k in 0..n {
                let v_n = c.upper_vertical_n - weight_npm * ds_m * (f64::from(k) + 0.5);
                let v_n = if on_bottom { v_n.max(0.0) } else { v_n };
                let t_n = c.horizontal_n.hypot(v_n);
                let piece_m = ds_m * (1.0 + t_n / axial_stiffness_n);
                x_m += piece_m * c.horizontal_n / t_n;
                z_m += piece_m * v_n / t_n;
            }
            // The midpoint rule has an error where the cable turns sharply: 1e-4 of the length.
            prop_assert!((x_m - span_m).abs() < 1e-4 * length_m, "{} {}", x_m, span_m);
            prop_assert!((z_m - rise_m).abs() < 1e-4 * length_m, "{} {}", z_m, rise_m);
        }
    }

    /// The horizontal tension H grows with the span, without a jump.
    #[test]
    fn horizontal_tension_grows_with_the_span(span_m in 150.0..204.0_f64) {
        let at = |x| catenary(&reference(210.0), x, 50.0, true).horizontal_n;
        let (one, two) = (at(span_m), at(span_m + 1e-6));
        prop_assert!(two >= one);
        // The stiffness of the taut cable, EA/L, bounds the slope.
        prop_assert!(two - one <= 1e9 / 210.0 * 1e-6 * 1.01);
    }
}

const MBL_N: f64 = 1e6;

fn rope(curve: RopeCurve) -> Rope {
    Rope { break_load_n: MBL_N, curve }
}

fn ends(distance_m: f64) -> LineEnds {
    // A triangle of 3, 4 and 5: 0.6 to the north and 0.8 up.
    LineEnds { ship_m: [0.0; 3], shore_m: [0.6 * distance_m, 0.0, 0.8 * distance_m] }
}

fn setup(kind: LineKind, inboard_end: InboardEnd, initial_length: InitialLength) -> LineSetup {
    LineSetup { name: "aft spring".into(), kind, inboard_end, initial_length }
}

fn polyester() -> LineKind {
    let details = LineDetails::default();
    LineKind::Light { main: rope(RopeCurve::polyester()), tail: None, details }
}

fn hmpe_with_tail() -> LineKind {
    let nylon = Rope { break_load_n: 1.25 * MBL_N, curve: RopeCurve::nylon() };
    LineKind::Light {
        main: rope(RopeCurve::hmpe()),
        tail: Some(Tail { rope: nylon, length_m: 11.0 }),
        details: LineDetails::default(),
    }
}

#[test]
fn curves_and_their_inverses_agree() {
    for curve in [RopeCurve::wire(), RopeCurve::hmpe(), RopeCurve::polyester(), RopeCurve::nylon()]
    {
        for k in 0..=12 {
            let share = 0.1 * f64::from(k);
            assert!((curve.share(curve.strain(share)) - share).abs() < 1e-12);
        }
        assert_eq!(curve.share(-0.1), 0.0);
    }
    // Polyester has half the break load at 6.5 %.
    assert!((RopeCurve::polyester().share(0.065) - 0.5).abs() < 1e-12);
    assert_eq!(RopeCurve::new(vec![[0.0, 0.0], [0.1, 0.5], [0.1, 1.0]]).unwrap_err().point, 2);
    assert_eq!(RopeCurve::new(vec![[0.0, 0.1]]).unwrap_err().point, 0);
    assert_eq!(RopeCurve::new(vec![[0.0, 0.0], [f64::NAN, 1.0]]).unwrap_err().point, 1);
}

/// A polyester rope of 50 m over 51 m has a strain of 2 %. Its tension is 0.5·0.02/0.065 of the break load, along the
/// line.
#[test]
fn a_light_line_pulls_along_itself() {
    let made = setup(polyester(), InboardEnd::Bitts, InitialLength::Outboard(50.0));
    let (line, mut state) = Line::new(made, &ends(50.0)).unwrap();
    let load = line.step(&mut state, &ends(51.0), WinchOrder::Hold, 0.1);
    let tension_n = MBL_N * 0.5 * 0.02 / 0.065;
    assert!((load.tension_n - tension_n).abs() < 1e-6);
    assert!((load.on_ship_n[0] - 0.6 * tension_n).abs() < 1e-6);
    assert!((load.on_ship_n[2] - 0.8 * tension_n).abs() < 1e-6);
    assert_eq!(load.on_shore_n, load.on_ship_n.map(|part| -part));
    let slack = line.step(&mut state, &ends(49.9), WinchOrder::Hold, 0.1);
    assert_eq!(slack.tension_n, 0.0);
}

/// The stretches of springs in series add up. At 100 kN, HMPE of 39 m stretches by 0.02·0.2 and nylon of 11 m by
/// 0.15·0.16.
#[test]
fn a_tail_stretches_in_series() {
    let made = setup(hmpe_with_tail(), InboardEnd::Bitts, InitialLength::Outboard(50.0));
    let (line, mut state) = Line::new(made, &ends(50.0)).unwrap();
    let stretch_m = 39.0 * 0.02 * 0.2 + 11.0 * 0.15 * 0.16;
    let load = line.step(&mut state, &ends(50.0 + stretch_m), WinchOrder::Hold, 0.1);
    assert!((load.tension_n - 100e3).abs() < 1e-5, "{}", load.tension_n);
}

#[test]
fn a_pretension_is_met() {
    let heavy = LineKind::Heavy {
        weight_npm: 500.0,
        axial_stiffness_n: 5e8,
        break_load_n: 3e6,
        on_bottom: false,
    };
    for kind in [polyester(), hmpe_with_tail(), heavy] {
        let made = setup(kind, InboardEnd::Bitts, InitialLength::FromPretension(100e3));
        let (line, mut state) = Line::new(made, &ends(60.0)).unwrap();
        let load = line.step(&mut state, &ends(60.0), WinchOrder::Hold, 0.1);
        close(load.tension_n, 100e3, 1e-6);
    }
}

/// The brake renders at 60 % of the ship design MBL, for any step and speed.
#[test]
fn a_brake_renders_at_its_setting_and_does_not_heave_in() {
    let winch = Winch::of_design(MBL_N, 100.0);
    let made = setup(polyester(), InboardEnd::Winch(winch), InitialLength::FromPretension(100e3));
    let (line, mut state) = Line::new(made, &ends(50.0)).unwrap();
    let before_m = state.length_m;
    let load = line.step(&mut state, &ends(58.0), WinchOrder::Hold, 0.1);
    close(load.tension_n, 600e3, 1e-9);
    assert!(load.winch.rendered_m > 0.0);
    assert!((state.length_m - before_m - load.winch.rendered_m).abs() < 1e-12);
    let back = line.step(&mut state, &ends(50.0), WinchOrder::Hold, 0.1);
    assert_eq!(back.tension_n, 0.0);
    assert_eq!(back.winch.rendered_m, 0.0);
}

#[test]
fn a_line_on_bitts_parts_above_its_break_load_and_stays_parted() {
    let made = setup(polyester(), InboardEnd::Bitts, InitialLength::Outboard(50.0));
    let (line, mut state) = Line::new(made, &ends(50.0)).unwrap();
    let held = line.step(&mut state, &ends(55.99), WinchOrder::Hold, 0.1);
    assert!(held.tension_n > 0.99 * MBL_N && held.parted_at_n.is_none());
    let parted = line.step(&mut state, &ends(56.01), WinchOrder::Hold, 0.1);
    assert!(parted.parted_at_n.is_some_and(|at_n| at_n > MBL_N));
    assert_eq!(parted.on_ship_n, [0.0; 3]);
    let after = line.step(&mut state, &ends(60.0), WinchOrder::Hold, 0.1);
    assert_eq!(after.tension_n, 0.0);
    assert_eq!(after.parted_at_n, None);
}

/// When the drum is empty it holds, and then the line parts.
#[test]
fn a_drum_can_be_emptied() {
    let winch = Winch::of_design(MBL_N, 2.0);
    let made = setup(polyester(), InboardEnd::Winch(winch), InitialLength::Outboard(50.0));
    let (line, mut state) = Line::new(made, &ends(50.0)).unwrap();
    let load = line.step(&mut state, &ends(57.0), WinchOrder::Hold, 0.1);
    assert!(load.winch.drum_empty && load.tension_n > 600e3);
    assert!(line.step(&mut state, &ends(60.0), WinchOrder::Hold, 0.1).parted_at_n.is_some());
}

#[test]
fn a_winch_heaves_to_its_stall_and_pays_out_at_its_rate() {
    let winch = Winch::of_design(MBL_N, 100.0);
    let made = setup(polyester(), InboardEnd::Winch(winch), InitialLength::Outboard(52.0));
    let (line, mut state) = Line::new(made, &ends(50.0)).unwrap();
    line.step(&mut state, &ends(50.0), WinchOrder::Heave(0.1), 10.0);
    assert!((state.length_m - 51.0).abs() < 1e-12);
    let load = line.step(&mut state, &ends(50.0), WinchOrder::Heave(0.25), 100.0);
    assert!(load.winch.stalled);
    close(load.tension_n, 300e3, 1e-9);
    let before_m = state.length_m;
    let load = line.step(&mut state, &ends(50.0), WinchOrder::PayOut(1e6), 1.0);
    assert!(load.winch.rate_limited);
    assert!((state.length_m - before_m - 0.25).abs() < 1e-12);
    let load = line.step(&mut state, &ends(50.0), WinchOrder::PayOut(f64::NAN), 1.0);
    assert!(load.winch.rate_limited && state.length_m.is_finite());
    let bitts = setup(polyester(), InboardEnd::Bitts, InitialLength::Outboard(52.0));
    let (line, mut state) = Line::new(bitts, &ends(50.0)).unwrap();
    assert!(line.step(&mut state, &ends(50.0), WinchOrder::Heave(0.1), 1.0).winch.no_winch);
}

#[test]
fn impossible_lines_are_refused_by_name() {
    let refused = |kind, inboard_end, initial_length| {
        Line::new(setup(kind, inboard_end, initial_length), &ends(50.0)).unwrap_err().to_string()
    };
    assert_eq!(
        refused(polyester(), InboardEnd::Bitts, InitialLength::Outboard(49.0)),
        "line `aft spring` is 49 m long, but its ends are 50 m apart; make the line longer or \
         give a pretension instead"
    );
    let error = refused(polyester(), InboardEnd::Bitts, InitialLength::FromPretension(2e6));
    assert_eq!(error, "line `aft spring` cannot have a pretension of 2000000 N");
    let error = refused(polyester(), InboardEnd::Bitts, InitialLength::Outboard(f64::NAN));
    assert!(error.starts_with("line `aft spring`: length of the line [m]"), "{error}");
    let winch = InboardEnd::Winch(Winch::of_design(MBL_N, 10.0));
    assert!(refused(polyester(), winch, InitialLength::FromPretension(700e3)).contains("700000"));
    // The weight of this cable pulls harder than the pretension.
    let heavy = LineKind::Heavy {
        weight_npm: 5000.0,
        axial_stiffness_n: 1e9,
        break_load_n: 1e7,
        on_bottom: false,
    };
    assert!(
        refused(heavy, InboardEnd::Bitts, InitialLength::FromPretension(1e3)).contains("1000 N")
    );
}

/// A cable has the forces of its catenary, with the right direction of up, from either end.
#[test]
fn a_cable_pulls_its_ends_together_and_down() {
    let kind = LineKind::Heavy {
        weight_npm: reference(1.0).weight_npm,
        axial_stiffness_n: 1e9,
        break_load_n: 1e7,
        on_bottom: true,
    };
    let anchored = LineEnds { ship_m: [0.0, 0.0, 0.0], shore_m: [0.0, -200.0, -50.0] };
    let made = setup(kind, InboardEnd::Bitts, InitialLength::Outboard(210.0));
    let (line, mut state) = Line::new(made, &anchored).unwrap();
    let load = line.step(&mut state, &anchored, WinchOrder::Hold, 0.1);
    close(load.tension_n, 577.7e3, 0.002);
    close(load.on_ship_n[1], -483.6e3, 0.002);
    close(load.on_ship_n[2], -316.0e3, 0.002);
    assert_eq!(load.on_shore_n[1], -load.on_ship_n[1]);
}

/// Work of a line on a ship that goes round a closed path. The path has many small moves; the force is taken at the
/// middle of each.
fn work_round(line: &Line, state: &mut LineState, size_m: f64, turns: u32) -> f64 {
    let place = |k: u32| {
        let angle = f64::from(k) * std::f64::consts::TAU / 2000.0;
        [size_m * (1.0 - angle.cos()), size_m * angle.sin(), 0.0]
    };
    let shore_m = [-50.0, 0.0, 5.0];
    let mut work_j = 0.0;
    for k in 0..2000 * turns {
        let (from, to) = (place(k), place(k + 1));
        let middle = std::array::from_fn(|i| 0.5 * (from[i] + to[i]));
        let at = LineEnds { ship_m: middle, shore_m };
        let load = line.step(state, &at, WinchOrder::Hold, 0.1);
        work_j += (0..3).map(|i| load.on_ship_n[i] * (to[i] - from[i])).sum::<f64>();
    }
    work_j
}

/// A line without a winch gives back all energy that it took. Round a closed path only the error of 2000 straight
/// pieces is left, 1e-5 of the energy that goes through the line. A line with a brake that renders takes energy out.
#[test]
fn a_line_is_passive_round_a_closed_path() {
    let start = LineEnds { ship_m: [0.0; 3], shore_m: [-50.0, 0.0, 5.0] };
    for kind in [polyester(), hmpe_with_tail()] {
        let made = setup(kind.clone(), InboardEnd::Bitts, InitialLength::FromPretension(50e3));
        let (line, mut state) = Line::new(made, &start).unwrap();
        let work_j = work_round(&line, &mut state, 1.0, 1);
        assert!(work_j.abs() < 1e-5 * 500e3, "{work_j}");
        let winch = InboardEnd::Winch(Winch { render_n: 200e3, ..Winch::of_design(MBL_N, 100.0) });
        let made = setup(kind, winch, InitialLength::FromPretension(50e3));
        let (line, mut state) = Line::new(made, &start).unwrap();
        let work_j = work_round(&line, &mut state, 3.0, 1);
        assert!(work_j < -50e3, "{work_j}");
        // In the second turn the line is long enough already.
        let again_j = work_round(&line, &mut state, 3.0, 1);
        assert!(again_j.abs() < 1e-4 * 500e3, "{again_j}");
    }
}

/// A constant-tension winch keeps the tension in the band if the ship moves no faster than the winch. If she moves
/// faster, the tension leaves the band until the brake renders.
#[test]
fn a_constant_tension_winch_keeps_the_band_within_its_speed_and_its_brake() {
    let automatic =
        ConstantTension { tension_n: 100e3, band: 0.1, heave_mps: 0.2, pay_out_mps: 0.2 };
    let winch = Winch { constant_tension: Some(automatic), ..Winch::of_design(MBL_N, 100.0) };
    let render_n = winch.render_n;
    let made =
        setup(hmpe_with_tail(), InboardEnd::Winch(winch), InitialLength::FromPretension(100e3));
    let (line, start) = Line::new(made, &ends(50.0)).unwrap();
    let tensions = |speed_mps: f64| {
        let (mut state, mut all_n) = (start, Vec::new());
        for k in 0..200 {
            let gone_m = 5.0 * (speed_mps / 5.0 * 0.1 * f64::from(k)).sin();
            let load = line.step(&mut state, &ends(50.0 + gone_m), WinchOrder::Hold, 0.1);
            all_n.push(load.tension_n);
        }
        all_n
    };
    let slow = tensions(0.15);
    assert!(slow.iter().all(|n| (89.99e3..110.01e3).contains(n)), "{slow:?}");
    // Both edges of the band are reached, on the way out and on the way in.
    assert!(slow.iter().any(|n| (n - 110e3).abs() < 1.0));
    assert!(tensions(-0.15).iter().any(|n| (n - 90e3).abs() < 1.0));
    let fast = tensions(2.0);
    let most_n = fast.iter().fold(0.0_f64, |most, &n| most.max(n));
    assert!(most_n > 150e3 && most_n <= render_n * (1.0 + 1e-9), "{most_n} {render_n}");
    // An order of the crew overrides the automatic control.
    let mut state = start;
    line.step(&mut state, &ends(50.0), WinchOrder::Heave(0.1), 0.1);
    assert!(state.length_m < start.length_m);
}

#[test]
fn numbers_of_a_constant_tension_winch_out_of_range_are_refused() {
    let good = ConstantTension { tension_n: 100e3, band: 0.1, heave_mps: 0.2, pay_out_mps: 0.2 };
    let refused = |automatic: ConstantTension| {
        let winch = Winch { constant_tension: Some(automatic), ..Winch::of_design(MBL_N, 100.0) };
        let made = setup(hmpe_with_tail(), InboardEnd::Winch(winch), InitialLength::Outboard(60.0));
        Line::new(made, &ends(50.0)).unwrap_err().to_string()
    };
    for (bad, what) in [
        (ConstantTension { tension_n: f64::NAN, ..good }, "set tension"),
        (ConstantTension { band: 0.95, ..good }, "band"),
        (ConstantTension { tension_n: 0.6 * MBL_N, ..good }, "upper edge"),
        (ConstantTension { heave_mps: -1.0, ..good }, "heaving"),
        (ConstantTension { pay_out_mps: 1e9, ..good }, "paying out"),
    ] {
        let message = refused(bad);
        assert!(message.contains(what), "{message}");
    }
}

#[test]
fn a_copied_state_replays_to_the_bit() {
    let winch = InboardEnd::Winch(Winch::of_design(MBL_N, 100.0));
    let made = setup(hmpe_with_tail(), winch, InitialLength::FromPretension(50e3));
    let (line, state) = Line::new(made, &ends(50.0)).unwrap();
    let run = |mut state: LineState| -> Vec<u64> {
        let at = |k: u32| ends(50.0 + 3.0 * (0.1 * f64::from(k)).sin());
        (0..200)
            .map(|k| line.step(&mut state, &at(k), WinchOrder::Hold, 0.1).tension_n.to_bits())
            .collect()
    };
    assert_eq!(run(state), run(state));
}

/// A rope with EA of 30 MN on bitts, with the given details, and its ends.
fn rope_of_ones_own(details: LineDetails, length_m: f64) -> (Line, LineState) {
    let curve = RopeCurve::of_stiffness(30e6, MBL_N).unwrap();
    let setup = LineSetup {
        name: "own".into(),
        kind: LineKind::Light { main: rope(curve), tail: None, details },
        inboard_end: InboardEnd::Bitts,
        initial_length: InitialLength::Outboard(length_m),
    };
    Line::new(setup, &LineEnds { ship_m: [0.0; 3], shore_m: [0.0; 3] }).unwrap()
}

#[test]
fn a_rope_with_weight_hangs_like_a_catenary_and_slack_it_keeps_a_tension() {
    let details = LineDetails { weight_npm: 60.0, ..LineDetails::default() };
    // The lengths go from a taut rope to a slack of 1 %, with a rise.
    for length_m in [99.0, 99.8, 100.0, 100.5, 101.0] {
        let (line, mut state) = rope_of_ones_own(details, length_m);
        let up_m = 100.0 * 0.06;
        let along_m = (100.0_f64 * 100.0 - up_m * up_m).sqrt();
        let ends = LineEnds { ship_m: [0.0, 0.0, up_m], shore_m: [along_m, 0.0, 0.0] };
        let load = line.step(&mut state, &ends, WinchOrder::Hold, 0.1);
        let cable = Cable { length_m, axial_stiffness_n: 30e6, weight_npm: 60.0 };
        let exact = catenary(&cable, along_m, up_m, false);
        close(load.on_ship_n[0], exact.horizontal_n, 3e-3);
        let vertical_n = load.on_ship_n[2] + exact.upper_vertical_n;
        assert!(vertical_n.abs() < 3e-3 * exact.horizontal_n, "{vertical_n}");
        // The ends together bear the weight.
        let weight_n = -(load.on_ship_n[2] + load.on_shore_n[2]);
        close(weight_n, 60.0 * length_m, 1e-12);
    }
}

/// The rope has 100 m outboard and 50 m on deck, behind a chock that leaves half of the tension. It stretches as 125 m
/// do.
#[test]
fn rope_on_deck_stretches_with_the_tension_that_reaches_it() {
    let half = OnDeck::behind_chock(50.0, std::f64::consts::LN_2, 1.0);
    for (on_deck, all_m) in
        [(None, 100.0), (Some(half), 125.0), (Some(OnDeck { share: 1.0, ..half }), 150.0)]
    {
        let (line, mut state) =
            rope_of_ones_own(LineDetails { on_deck, ..LineDetails::default() }, 100.0);
        let ends = LineEnds { ship_m: [0.0; 3], shore_m: [101.0, 0.0, 0.0] };
        let load = line.step(&mut state, &ends, WinchOrder::Hold, 0.1);
        close(load.tension_n, 30e6 / all_m, 1e-9);
    }
}

/// The pretension is that at the ship's end, also for a rope with weight and length on deck.
#[test]
fn a_pretension_is_reached_with_weight_and_rope_on_deck() {
    for weight_npm in [0.0, 80.0] {
        let on_deck = Some(OnDeck { length_m: 30.0, share: 0.7 });
        let details = LineDetails { on_deck, weight_npm, working_load_n: Some(1e5) };
        let setup = LineSetup {
            name: "own".into(),
            kind: LineKind::Light { main: rope(RopeCurve::hmpe()), tail: None, details },
            inboard_end: InboardEnd::Bitts,
            initial_length: InitialLength::FromPretension(90e3),
        };
        assert_eq!(setup.kind.working_load_n(), Some(1e5));
        let ends = LineEnds { ship_m: [0.0, 0.0, 9.0], shore_m: [60.0, 5.0, 4.0] };
        let (line, mut state) = Line::new(setup, &ends).unwrap();
        let load = line.step(&mut state, &ends, WinchOrder::Hold, 0.1);
        close(load.tension_n, 90e3, 1e-6);
    }
}
