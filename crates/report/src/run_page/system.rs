//! The report's drawings of the fender system: plan and elevation of each face with fenders, a section, and the table
//! of fenders.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{BodyState, Pose, Rotation, Vec2, vec2};
use fenderline_results::{Outcome, worst_first};
use fenderline_sim::{
    ChainKind, ChainSetup, ConeUse, FenderSetup, FenderSummary, HullPressure, Setup, called,
};
use maud::{Markup, html};

use super::fenders::{setup_table, used};
use super::recorder::Recorder;
use super::signed::signed;
use crate::plot::{
    Chain, ConeDrawn, Face, FaceFender, Hull, Level, LevelKind, PanelPlan, Section, Side, Use,
    decimals_for, fixed, shortened, significant,
};

/// Largest number of drawn faces: the faces with most fenders, each with more than one fender.
const FACES: usize = 3;
/// Faces whose directions differ by less than this count as one face (rad).
const SAME_FACING_RAD: f64 = 0.035;
/// Mountings that are farther apart than this, at right angles to the face, are not on one face (m).
const SAME_LINE_M: f64 = 6.0;
/// A hull is drawn if its distance from the line of mountings is at most this (m).
const NEAR_M: f64 = 20.0;
/// Largest number of hulls drawn at a face.
const HULLS: usize = 3;
/// Depth below which the seabed is not drawn (m).
const DEEP_M: f64 = 40.0;
/// Largest number of chains listed beside the section.
const CHAINS: usize = 6;
/// Largest number of cones listed beside the panel.
const CONES: usize = 8;
/// Longest name in a drawing (characters).
const NAME: usize = 26;

/// Writes the section with the drawings of the fender system; empty if there are no fenders.
pub(super) fn section(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let setup = outcome.setup;
    if setup.fenders.is_empty() {
        return html! {};
    }
    let states = recorder.peak.as_ref().map_or(outcome.states, |peak| &peak.states);
    let t_s = recorder.peak.as_ref().map_or(0.0, |peak| peak.t_s);
    let sight = Sight { outcome, states, level_m: setup.world.environment.level_m(t_s) };
    let mut groups = groups(setup, states);
    // The largest first; of equal ones in the order of the scenario.
    groups.sort_by_key(|group| core::cmp::Reverse(group.len()));
    let all = groups.len();
    // Beside a row of fenders, the single fender at a tug's bow is not drawn as a system.
    groups.truncate(groups.iter().filter(|group| group.len() > 1).count().clamp(1, FACES));
    let left = all - groups.len();
    html! {
        h2 { "Fender system" }
        @for group in &groups { (sight.face(group).render()) }
        @if left > 0 {
            p class="note" {
                (format!(
                    "The drawing shows the faces with the most fenders, without {left} other {} with fenders.",
                    if left == 1 { "face" } else { "faces" },
                ))
            }
        }
        (sight.section().render())
        @if let Some(plan) = panel_plan(outcome) { (plan.render()) }
        (setup_table(setup))
    }
}

/// Groups the fenders by face: a face is on one floating body, or on all fixed bodies, with fenders in one direction
/// and on one line.
fn groups(setup: &Setup, states: &[BodyState]) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for index in 0..setup.fenders.len() {
        let same = groups.iter_mut().find(|group| {
            let [one, other] = [group[0], index].map(|i| &setup.fenders[i]);
            let is_carrier = one.body == other.body
                || setup.bodies[one.body].is_fixed() && setup.bodies[other.body].is_fixed();
            is_carrier && is_one_face(&Frame::of(one, states), &Frame::of(other, states))
        });
        match same {
            Some(group) => group.push(index),
            None => groups.push(vec![index]),
        }
    }
    groups
}

fn is_one_face(one: &Frame, other: &Frame) -> bool {
    let out_m = (other.mount_m - one.mount_m).dot(one.outward);
    one.outward.dot(other.outward) > libm::cos(SAME_FACING_RAD) && out_m.abs() < SAME_LINE_M
}

/// A coordinate system at the face of a fender, earth-fixed: one axis goes to the right along the face as seen from the
/// water, the other outwards.
struct Frame {
    mount_m: Vec2,
    origin_m: Vec2,
    right: Vec2,
    outward: Vec2,
}

impl Frame {
    fn of(fender: &FenderSetup, states: &[BodyState]) -> Frame {
        let pose: Pose = states[fender.body].pose();
        let facing = Rotation::from_angle(fender.facing_rad).apply(vec2(1.0, 0.0));
        let outward = pose.rotation.apply(facing);
        Frame {
            mount_m: pose.apply(fender.position_m),
            origin_m: states[fender.body].position_m,
            // The right hand, as you look against `outward`.
            right: outward.quarter_turn_back(),
            outward,
        }
    }

    /// Coordinates of a point: along the face from the body's origin, and outwards from the mounting (m).
    fn at(&self, point_m: Vec2) -> [f64; 2] {
        [(point_m - self.origin_m).dot(self.right), (point_m - self.mount_m).dot(self.outward)]
    }
}

/// The bodies and the water level at the moment of the largest force, which the drawings show.
struct Sight<'a> {
    outcome: &'a Outcome<'a>,
    states: &'a [BodyState],
    /// Level of the water above datum (m).
    level_m: f64,
}

impl Sight<'_> {
    fn face(&self, group: &[usize]) -> Face {
        let setup = self.outcome.setup;
        let first = &setup.fenders[group[0]];
        let frame = Frame::of(first, self.states);
        let mut carriers: Vec<usize> = group.iter().map(|&i| setup.fenders[i].body).collect();
        carriers.sort_unstable();
        carriers.dedup();
        let mut fenders: Vec<FaceFender> =
            group.iter().map(|&index| self.fender(index, &frame)).collect();
        fenders.sort_by(|a, b| a.along_m.total_cmp(&b.along_m));
        let names: Vec<String> = carriers
            .iter()
            .take(3)
            .map(|&body| shortened(&setup.bodies[body].name, NAME))
            .collect();
        let others = if carriers.len() > 3 { " and others" } else { "" };
        Face {
            title: format!(
                "{} on {}{others}",
                if fenders.len() == 1 {
                    "Fender".to_owned()
                } else {
                    format!("{} fenders", fenders.len())
                },
                names.join(", ")
            ),
            fenders,
            bodies_m: carriers.iter().map(|&body| self.outline(body, &frame)).collect(),
            hulls: self.hulls(&carriers, &frame),
            levels: self.levels(first),
            heights_above: self.heights_above(first),
        }
    }

    fn fender(&self, index: usize, frame: &Frame) -> FaceFender {
        let fender = &self.outcome.setup.fenders[index];
        let mount_m = self.states[fender.body].pose().apply(fender.position_m);
        let [along_m, mounted_m] = frame.at(mount_m);
        FaceFender {
            number: index + 1,
            along_m,
            height_m: self.height_m(fender),
            face_m: [fender.width_m, fender.height_m],
            cones_m: fender.panel.as_ref().map_or_else(Vec::new, |panel| panel.cones_m.clone()),
            projection_m: fender.projection_m,
            mounted_m,
            used: used(self.outcome, index),
        }
    }

    /// Height of the middle of a fender's face (m).
    fn height_m(&self, fender: &FenderSetup) -> f64 {
        let is_fixed = self.outcome.setup.bodies[fender.body].is_fixed();
        fender.above_water_m + if is_fixed && fender.floating { self.level_m } else { 0.0 }
    }

    fn heights_above(&self, fender: &FenderSetup) -> &'static str {
        if self.outcome.setup.bodies[fender.body].is_fixed() { "datum" } else { "the water" }
    }

    fn outline(&self, body: usize, frame: &Frame) -> Vec<[f64; 2]> {
        let pose = self.states[body].pose();
        let vertices = self.outcome.setup.bodies[body].outline.vertices();
        vertices.iter().map(|vertex| frame.at(pose.apply(*vertex))).collect()
    }

    /// The side of the nearest hull at a fender; vertical for a hull without outlines at heights.
    fn side(&self, fender: &FenderSetup, frame: &Frame) -> Option<Side> {
        let carriers = [fender.body];
        let (body, hull) = self.near(&carriers, frame).into_iter().next()?;
        let of = &self.outcome.setup.bodies[body];
        let mount_m = self.states[fender.body].pose().apply(fender.position_m);
        let [along_m, _] = frame.at(mount_m);
        let pose = self.states[body].pose();
        let mut side_m = Vec::new();
        if let Some((levels, keel_m)) = of.hull.as_ref().map(|hull| hull.levels()).zip(hull.keel_m)
        {
            for level in levels {
                let outline: Vec<[f64; 2]> =
                    level.vertices_m.iter().map(|vertex| frame.at(pose.apply(*vertex))).collect();
                let out_m = nearest_m(&outline, along_m);
                side_m.extend(out_m.map(|out_m| [out_m, keel_m + level.height_m]));
            }
            // Outwards from where the fender's middle meets it.
            let at_fender_m = out_at_m(&side_m, self.height_m(fender));
            for point in &mut side_m {
                point[0] -= at_fender_m;
            }
        }
        Some(Side { name: hull.name, keel_m: hull.keel_m, side_m })
    }

    /// The hulls to draw before the face, the nearest first.
    fn hulls(&self, carriers: &[usize], frame: &Frame) -> Vec<Hull> {
        self.near(carriers, frame).into_iter().take(HULLS).map(|(_, hull)| hull).collect()
    }

    /// Indices and hulls of the floating bodies before the face, the nearest first.
    fn near(&self, carriers: &[usize], frame: &Frame) -> Vec<(usize, Hull)> {
        let bodies = &self.outcome.setup.bodies;
        let mut near: Vec<(f64, usize, Hull)> = Vec::new();
        for (body, of) in bodies.iter().enumerate() {
            if of.is_fixed() || carriers.contains(&body) {
                continue;
            }
            let outline_m = self.outline(body, frame);
            let out_m = outline_m.iter().map(|p| p[1]).fold(f64::INFINITY, lesser);
            if out_m < NEAR_M {
                let hull = Hull {
                    name: shortened(&of.name, NAME),
                    outline_m,
                    keel_m: self.keel_m(body, carriers),
                };
                near.push((greater(out_m, 0.0), body, hull));
            }
        }
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        near.into_iter().map(|(_, body, hull)| (body, hull)).collect()
    }

    /// Height of a hull's keel (m), measured as the heights of a face are, if the draught is known.
    fn keel_m(&self, body: usize, carriers: &[usize]) -> Option<f64> {
        let setup = self.outcome.setup;
        let vessel = setup.world.vessels.iter().find(|vessel| vessel.body == body);
        let berthing = setup.berthing.as_ref().filter(|berthing| berthing.ship == body);
        let draught_m = (setup.bodies[body].hull.as_ref().map(|hull| hull.draught_m()))
            .or_else(|| vessel.map(|vessel| vessel.ship.particulars.draught_m))
            .or_else(|| berthing.map(|berthing| berthing.draught_m))?;
        let is_fixed = carriers.iter().all(|&carrier| setup.bodies[carrier].is_fixed());
        Some(if is_fixed { self.level_m } else { 0.0 } - draught_m)
    }

    /// The levels that are drawn (such as water and seabed), measured as the heights of a fender's face are.
    fn levels(&self, fender: &FenderSetup) -> Vec<Level> {
        let environment = &self.outcome.setup.world.environment;
        let water = |height_m: f64, text: &str| Level {
            height_m,
            text: format!("{text} {} m", signed(height_m)),
            kind: LevelKind::Water,
        };
        if !self.outcome.setup.bodies[fender.body].is_fixed() {
            // The heights of this drawing are above the water.
            return vec![water(0.0, "water")];
        }
        let [low_m, high_m] = environment.level_range_m();
        let mut all = Vec::new();
        let body = &self.outcome.setup.bodies[fender.body];
        let face_m = Pose::new(body.position_m, body.heading_rad).apply(fender.position_m);
        let by_place_m = environment.bottom.as_ref().and_then(|bottom| bottom.depth_m(face_m));
        let depth_m = environment.depth_m.or(by_place_m);
        if let Some(depth_m) = depth_m.filter(|depth_m| *depth_m < DEEP_M) {
            let text = format!("seabed {} m", signed(-depth_m));
            all.push(Level { height_m: -depth_m, text, kind: LevelKind::Bed });
        }
        if high_m > low_m {
            all.push(water(low_m, "low water"));
            all.push(water(high_m, "high water"));
        } else {
            all.push(water(low_m, "water"));
        }
        all
    }

    /// The section through the most used fender, or through the first fender if none was touched.
    fn section(&self) -> Section {
        let (outcome, setup) = (self.outcome, self.outcome.setup);
        let worst =
            worst_first(&setup.fenders, outcome.fenders).first().map(|&i| &outcome.fenders[i]);
        let index = worst.map_or(0, |summary| summary.fender);
        let fender = &setup.fenders[index];
        let frame = Frame::of(fender, self.states);
        let hull = worst.and_then(|_| self.side(fender, &frame));
        Section {
            title: format!(
                "Section at {}, number {}",
                called("fender", &shortened(&fender.name, NAME)),
                index + 1
            ),
            height_m: self.height_m(fender),
            face_m: [fender.width_m, fender.height_m],
            projection_m: fender.projection_m,
            deflection_m: worst
                .map_or(0.0, |summary| lesser(summary.peak_deflection_m, fender.projection_m)),
            used: used(outcome, index),
            levels: self.levels(fender),
            hull,
            heights_above: self.heights_above(fender),
            chains: chains(fender, worst),
            is_round: matches!(fender.hull_pressure, HullPressure::Inner { .. }),
            is_floating: fender.floating,
        }
    }
}

/// The drawing from above of the most used fender with a panel on several cones, at its largest turn; `None` if no such
/// fender was touched.
fn panel_plan(outcome: &Outcome<'_>) -> Option<PanelPlan> {
    let setups = &outcome.setup.fenders;
    let order = worst_first(setups, outcome.fenders);
    let mut worst = order.iter().map(|&i| &outcome.fenders[i]);
    let (summary, panel) = worst.find_map(|of| of.panel.as_ref().map(|panel| (of, panel)))?;
    let fender = &setups[summary.fender];
    let decimals = decimals_for(outcome.setup.step_s);
    let share = |peak_m: f64| ConeUse::of(fender, summary, peak_m)?.share_of_rated_deflection;
    let mut cones: Vec<(ConeDrawn, f64)> = panel
        .cones
        .iter()
        .map(|cone| {
            let used = match share(cone.peak_deflection_m) {
                _ if summary.failed => used(outcome, summary.fender),
                Some(share) => Use::Share(share),
                None => Use::NotRated,
            };
            (ConeDrawn { at_m: cone.at_m, used }, cone.peak_deflection_m)
        })
        .collect();
    cones.sort_by(|a, b| a.0.at_m.total_cmp(&b.0.at_m));
    let mut texts = vec![
        format!(
            "Turn {}° at {} s, as drawn",
            fixed(panel.peak_tilt_rad.to_degrees(), 2),
            fixed(panel.peak_tilt_at_s, decimals)
        ),
        format!(
            "Largest moment {} kN·m at {} s",
            significant(panel.peak_moment_nm / 1e3, 3),
            fixed(panel.peak_moment_at_s, decimals)
        ),
    ];
    texts.extend(cones.iter().take(CONES).map(|(cone, peak_m)| {
        let share = share(*peak_m)
            .map_or_else(String::new, |share| format!(", {} % of rated", fixed(100.0 * share, 0)));
        format!("Cone at {} m: peak {} mm{share}", signed(cone.at_m), fixed(1e3 * peak_m, 0))
    }));
    texts.push("Dashed: unloaded; size of the cones not to scale".to_owned());
    let tension = fender.chains.iter().filter(|chain| chain.kind == ChainKind::Tension);
    Some(PanelPlan {
        title: format!(
            "Panel of {}, number {}, from above in its largest turn",
            called("fender", &shortened(&fender.name, NAME)),
            summary.fender + 1
        ),
        width_m: fender.width_m,
        projection_m: fender.projection_m,
        deflection_m: panel.deflection_at_peak_tilt_m,
        tilt_rad: panel.peak_tilt_rad,
        cones: cones.into_iter().map(|(cone, _)| cone).collect(),
        chains_m: tension.map(|chain| chain.at_m).collect(),
        texts,
    })
}

/// The chains of a fender, each with a text on its load in the run.
fn chains(fender: &FenderSetup, summary: Option<&FenderSummary>) -> Vec<(Chain, String)> {
    let drawn = |(index, chain): (usize, &ChainSetup)| {
        let (kind, name) = match chain.kind {
            ChainKind::Weight => (Chain::Weight, "Weight chain"),
            ChainKind::Shear => (Chain::Shear, "Shear chain"),
            ChainKind::Tension => (Chain::Tension, "Tension chain"),
        };
        let bore = summary.and_then(|summary| summary.chains.get(index)).map(|bore| {
            let parted = if bore.parted_at_s.is_some() { ", PARTED" } else { "" };
            format!(", peak {} %{parted}", fixed(100.0 * bore.share_of_break_load, 0))
        });
        let load_kn = significant(chain.break_load_n / 1e3, 3);
        (kind, format!("{name}, break load {load_kn} kN{}", bore.unwrap_or_default()))
    };
    fender.chains.iter().enumerate().map(drawn).take(CHAINS).collect()
}

/// Smallest distance of an outline from the face, at a place along the face (m); `None` if the outline does not reach
/// this place.
fn nearest_m(outline_m: &[[f64; 2]], along_m: f64) -> Option<f64> {
    let next = outline_m.iter().cycle().skip(1);
    let crossings = outline_m.iter().zip(next).filter_map(|(from, to)| {
        let (low, high) = (lesser(from[0], to[0]), greater(from[0], to[0]));
        if along_m < low || along_m > high {
            return None;
        }
        let share = if high > low { (along_m - from[0]) / (to[0] - from[0]) } else { 0.0 };
        Some(from[1] + share * (to[1] - from[1]))
    });
    crossings.min_by(f64::total_cmp)
}

/// Distance outwards of a hull's side at a height (m); above and below its points it is that of the nearest point.
fn out_at_m(side_m: &[[f64; 2]], height_m: f64) -> f64 {
    let pairs = side_m.windows(2).find(|pair| pair[1][1] >= height_m);
    match (pairs, side_m.last()) {
        (Some([from, to]), _) => {
            let share = (height_m - from[1]) / (to[1] - from[1]);
            from[0] + greater(share, 0.0) * (to[0] - from[0])
        }
        (_, Some(last)) => last[0],
        (_, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_side_is_cut_where_the_fender_is() {
        // A hull that is 2 m off at 0 and 4 m off at 10 m along.
        let outline = [[0.0, 2.0], [10.0, 4.0], [10.0, 20.0], [0.0, 20.0]];
        assert_eq!(nearest_m(&outline, 5.0), Some(3.0));
        assert_eq!(nearest_m(&outline, 10.0), Some(4.0));
        assert_eq!(nearest_m(&outline, 11.0), None);
        // A flare of 1 m over 4 m of height.
        let side = [[3.0, -8.0], [3.0, 0.0], [2.0, 4.0]];
        assert_eq!(
            [-9.0, -4.0, 2.0, 9.0].map(|height_m| out_at_m(&side, height_m)),
            [3.0, 3.0, 2.5, 2.0]
        );
    }
}
