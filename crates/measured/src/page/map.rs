//! The map: the berth with the way of each ship to her first touch.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Rotation, Vec2, vec2};
use fenderline_report::plot::{
    Approached, FenderBox, Frame, Harbour, Label, Outlined, Place, Plan, Stage, Use,
    approached_legend, chart_labels, charted_in, fenders_legend, fixed, shortened,
};
use fenderline_sim::{BodySetup, FenderSetup, Setup};
use maud::{Markup, html};

use crate::berthing::{Berth, Berthing, Berthings};
use crate::flag::Flag;
use crate::geometry::Lie;
use crate::run::Rerun;
use crate::table::most_used;

/// Hulls are drawn for at most this number of berthings; for more, only the hull of the hardest one.
const HULLS: usize = 3;
/// Ways are numbered for at most this number of berthings.
const NUMBERED: usize = 40;
/// Largest number of fenders with names.
const NAMED: usize = 12;
/// Longest name of a fender (characters).
const NAME_LENGTH: usize = 20;
/// Ways that would lie on each other are drawn this far apart, as a share of the length of the ship.
const ASIDE: f64 = 0.016;
/// The ways of one fender take at most this share of the distance between the fenders.
const ASIDE_OF_SPACING: f64 = 0.6;
/// Numbers of berthings that a name lists; of more berthings it gives the count.
const LISTED: usize = 6;
/// The map shows ways up to this many lengths of the ship from the middle of the fenders.
const LENGTHS: f64 = 1.2;

/// The section with the map.
pub(super) fn section(berthings: &Berthings) -> Markup {
    let Some(berth) = berthings.berths.first() else { return html! {} };
    let approached = ways(berthings);
    let Some(frame) = frame(berth, berthings, &approached) else { return html! {} };
    let setup = &berth.setup;
    let names = fender_names(setup);
    let numbers = numbers(berthings, &approached, frame);
    let of_chart = chart_labels(&setup.world.chart.features, frame);
    let plan = Plan {
        title: "The approaches, to the first touch".to_owned(),
        frame,
        outlines: fixed_bodies(setup),
        fenders: fenders(berthings, setup),
        harbour: Harbour {
            chart: charted_in(&setup.world.chart.features, frame),
            approached,
            ..Harbour::default()
        },
        tracks: Vec::new(),
        arrows: Vec::new(),
        labels: numbers.into_iter().chain(names).chain(of_chart).collect(),
        note: note(berthings),
    };
    html! {
        @if !berthings.all.is_empty() {
            h2 { "Map" }
            (plan.render())
            (approached_legend())
            (fenders_legend())
        }
    }
}

fn note(berthings: &Berthings) -> String {
    let mut note = "A line is the way of the point of the hull that touches first, by the parabolas; its number \
                    is that of the list. Colour and width are by the most used fender of the run from the measured state, \
                    as a share of its rating. Fenders have the colour of their largest use in all runs. "
        .to_owned();
    note += if berthings.all.len() <= HULLS {
        "Hulls are drawn at the touch."
    } else {
        "Only the hull of the hardest berthing is drawn, at the touch."
    };
    if berthings.all.iter().any(is_assumed) {
        note += " Two sensors do not measure the place along the quay: ways of such logs run at the assumed place, and \
                 beside each other where they would lie on each other.";
    }
    note
}

/// Whether the place along the quay was assumed.
fn is_assumed(own: &Berthing) -> bool {
    own.flags.contains(&Flag::PlaceAssumed)
}

/// Berthings whose ways would lie on each other: those of assumed places with the same first fender. Each other berthing
/// is a group of its own.
fn groups(berthings: &Berthings) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (index, own) in berthings.all.iter().enumerate() {
        let is_with = |group: &&mut Vec<usize>| {
            let other = &berthings.all[group[0]];
            is_assumed(own) && is_assumed(other) && own.touch.fender == other.touch.fender
        };
        match groups.iter_mut().find(is_with) {
            Some(group) => group.push(index),
            None => groups.push(vec![index]),
        }
    }
    groups
}

/// How far the way of each berthing is drawn along the quay from its place (m).
fn asides(berthings: &Berthings) -> Vec<f64> {
    let mut all = vec![0.0; berthings.all.len()];
    for group in groups(berthings).iter().filter(|group| group.len() > 1) {
        let axes = &berthings.berths[berthings.all[group[0]].berth].axes;
        let spacing_m = axes.length_m / greater(axes.fenders() as f64 - 1.0, 1.0);
        let step_m = lesser(
            ASIDE * axes.hull_length_m(),
            ASIDE_OF_SPACING * spacing_m / (group.len() - 1) as f64,
        );
        for (place, index) in group.iter().enumerate() {
            all[*index] = step_m * (place as f64 - 0.5 * (group.len() - 1) as f64);
        }
    }
    all
}

/// How far the most used fender of a run was used.
fn used(run: &Rerun) -> Use {
    most_used(run).map_or(Use::NotRated, |(_, _, share)| Use::Share(share))
}

fn share(own: &Berthing) -> f64 {
    let share = own.run.as_ref().ok().and_then(most_used).map(|most| most.2);
    share.unwrap_or(0.0)
}

fn ways(berthings: &Berthings) -> Vec<Approached> {
    let all = &berthings.all;
    let hardest = (0..all.len()).max_by(|one, other| {
        let key = |index: usize| (share(&all[index]), all[index].touch.speed_mps.value);
        let (one, other) = (key(*one), key(*other));
        one.0.total_cmp(&other.0).then(one.1.total_cmp(&other.1))
    });
    let asides = asides(berthings);
    let way = |(index, own): (usize, &Berthing)| {
        let axes = &berthings.berths[own.berth].axes;
        let at_touch = &own.touch.motion.lie;
        let nearest = axes.nearest(at_touch);
        let touch = nearest.map_or([own.touch.along_m.value, 0.0], |at| [at.along_m, at.off_m]);
        let point = axes.in_ship(at_touch, touch);
        let drawn = |[along_m, off_m]: [f64; 2]| axes.from_axes([along_m + asides[index], off_m]);
        let on_earth = |lie: &Lie| drawn(axes.point(lie, point));
        let has_hull = all.len() <= HULLS || hardest == Some(index);
        Approached {
            path_m: own.curves.lies.iter().map(|(_, lie)| on_earth(lie)).collect(),
            minutes_m: minutes(&own.curves.lies).iter().map(on_earth).collect(),
            hull_m: if has_hull { axes.hull_on_earth(at_touch) } else { Vec::new() },
            touch_m: drawn(touch),
            used: own.run.as_ref().map_or(Use::NotRated, used),
        }
    };
    all.iter().enumerate().map(way).collect()
}

/// Lies at whole minutes before the touch, straight between their neighbours.
fn minutes(lies: &[(f64, Lie)]) -> Vec<Lie> {
    let mut all = Vec::new();
    for two in lies.windows(2) {
        let [(from_s, from), (to_s, to)] = two else { continue };
        let minute_s = 60.0 * libm::ceil(from_s / 60.0);
        if minute_s < *to_s && minute_s < -1.0 {
            let share = (minute_s - from_s) / (to_s - from_s);
            let between = |one: f64, other: f64| one + share * (other - one);
            all.push(Lie {
                along_m: between(from.along_m, to.along_m),
                off_m: between(from.off_m, to.off_m),
                angle_rad: between(from.angle_rad, to.angle_rad),
            });
        }
    }
    all
}

/// Around the fenders, the hulls and the ways near them.
fn frame(berth: &Berth, berthings: &Berthings, ways: &[Approached]) -> Option<Frame> {
    let lengths = berthings.all.iter().map(|own| berthings.berths[own.berth].axes.hull_length_m());
    let near_m = LENGTHS * greater(lengths.fold(0.0, greater), berth.axes.length_m);
    let middle = berth.axes.from_axes([0.0, 0.0]);
    let of_ways = ways.iter().flat_map(|way| way.path_m.iter().chain(&way.hull_m));
    let near = of_ways.filter(|at| (**at - middle).length() < near_m).copied();
    let mounts = berth.setup.fenders.iter().map(|own| placed(&berth.setup, own).mount_m);
    let at_berth = mounts.filter(|at| (*at - middle).length() < near_m);
    let all = Frame::around(near.chain(at_berth))?;
    // Some of the quay, so that land and water can be told apart.
    let room_m = 0.04 * greater(all.size().x, all.size().y);
    Some(all.with(Frame::between(all.low - vec2(room_m, room_m), all.high + vec2(room_m, room_m))))
}

fn fixed_bodies(setup: &Setup) -> Vec<Outlined> {
    let drawn = |body: &&BodySetup| body.is_fixed() && !body.outline.is_of_parts();
    let outlined = |body: &BodySetup| {
        let turned = Rotation::from_angle(body.heading_rad);
        let corner = |at: &Vec2| body.position_m + turned.apply(*at);
        Outlined {
            vertices_m: body.outline.vertices().iter().map(corner).collect(),
            stage: Stage::Fixed,
            style: 0,
        }
    };
    setup.bodies.iter().filter(drawn).map(outlined).collect()
}

/// The fenders of fixed bodies with their largest use in all runs.
fn fenders(berthings: &Berthings, setup: &Setup) -> Vec<FenderBox> {
    let of = |(index, fender): (usize, &FenderSetup)| {
        let uses = berthings.all.iter().filter_map(|own| own.run.as_ref().ok());
        let uses = uses.flat_map(|run| run.fenders.iter()).filter(|own| own.fender == index);
        let mut used = Use::Untouched;
        for own in uses {
            used = match (used, own.governing) {
                (Use::Share(known), Some((_, share))) => Use::Share(greater(known, share)),
                (_, Some((_, share))) => Use::Share(share),
                (Use::Untouched, None) => Use::NotRated,
                (other, None) => other,
            };
        }
        setup.bodies[fender.body].is_fixed().then(|| FenderBox { used, ..placed(setup, fender) })
    };
    setup.fenders.iter().enumerate().filter_map(of).collect()
}

fn placed(setup: &Setup, fender: &FenderSetup) -> FenderBox {
    let body = &setup.bodies[fender.body];
    let turned = Rotation::from_angle(body.heading_rad);
    let outward = turned.apply(Rotation::from_angle(fender.facing_rad).apply(vec2(1.0, 0.0)));
    FenderBox {
        mount_m: body.position_m + turned.apply(fender.position_m),
        out_m: outward * fender.projection_m,
        half_width_m: outward.quarter_turn() * (0.5 * fender.width_m),
        used: Use::Untouched,
    }
}

/// Names behind the fenders; none if so many would cover the view.
fn fender_names(setup: &Setup) -> Vec<Label> {
    if setup.fenders.len() > NAMED {
        return Vec::new();
    }
    let named = |fender: &FenderSetup| {
        let at = placed(setup, fender);
        let length_m = at.out_m.length();
        let side = if length_m > 0.0 { at.out_m * (-1.0 / length_m) } else { vec2(0.0, 1.0) };
        Label {
            text: shortened(&fender.name, NAME_LENGTH),
            place: Place::Beside { point_m: at.mount_m, side },
        }
    };
    setup.fenders.iter().map(named).collect()
}

/// Numbers and speeds of the berthings where their ways begin in the view.
fn numbers(berthings: &Berthings, ways: &[Approached], frame: Frame) -> Vec<Label> {
    if berthings.all.len() > NUMBERED {
        return Vec::new();
    }
    let is_in = |at: &Vec2| {
        (frame.low.x..=frame.high.x).contains(&at.x) && (frame.low.y..=frame.high.y).contains(&at.y)
    };
    let speed = |index: &usize| 100.0 * berthings.all[*index].touch.speed_mps.value;
    let label = |group: Vec<usize>| {
        let longest = group.iter().copied().max_by(|one, other| {
            let length_m = |index: usize| {
                let way = &ways[index];
                way.path_m.first().map_or(0.0, |from| (*from - way.touch_m).length())
            };
            length_m(*one).total_cmp(&length_m(*other))
        })?;
        let way = &ways[longest];
        let at_m = *way.path_m.iter().find(|at| is_in(at))?;
        let back = at_m - way.touch_m;
        let side = if back.length() > 0.0 { back * (1.0 / back.length()) } else { vec2(0.0, 1.0) };
        let names: Vec<String> = group.iter().map(|index| (index + 1).to_string()).collect();
        let names = match group.len() {
            count if count > LISTED => format!("{count} berthings"),
            _ => names.join(", "),
        };
        let slowest = fixed(group.iter().map(speed).fold(f64::INFINITY, lesser), 1);
        let fastest = fixed(group.iter().map(speed).fold(0.0, greater), 1);
        let speeds = if slowest == fastest { fastest } else { format!("{slowest} to {fastest}") };
        Some(Label {
            text: format!("{names}: {speeds} cm/s"),
            place: Place::Beside { point_m: at_m, side },
        })
    };
    groups(berthings).into_iter().filter_map(label).collect()
}
