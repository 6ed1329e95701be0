//! The report's section that shows the branches of a session side by side: a table of their outcomes, a plan of their
//! tracks, and charts of speeds and distances.

use fenderline_contact::Vec2;
use fenderline_results::{BranchOutcome, Outcome, WayPoint};
use maud::{Markup, html};

use super::charts::Charts;
use super::session::clock;
use super::tables::number;
use crate::plot::{
    Arrow, Axis, Frame, Harbour, Label, Outlined, Place, Plan, Point, Series, Stage, Track, fixed,
};
use crate::{Head, table_head};

/// Knot (m/s).
const KNOT_MPS: f64 = 1852.0 / 3600.0;
/// Room around the ships' tracks in the plan, as a share of their extent.
const ROOM: f64 = 0.08;

/// Shows all branches of the session side by side; empty for a session with only one branch.
pub(super) fn section(outcome: &Outcome<'_>) -> Markup {
    let Some(session) = outcome.session else { return html! {} };
    let all = session.beside.as_slice();
    if all.len() < 2 {
        return html! {};
    }
    html! {
        h2 { "Branches side by side" }
        p {
            "Each branch is shown from the start of the session to the end of the branch. This \
             report is of "
            strong { (name(session.branch)) } "."
        }
        (table(all, session.branch))
        p class="note" {
            (format!(
                "Approach: fastest closing speed of the ship's bow or stern within {} m of the \
                 fenders. ",
                fixed(BranchOutcome::NEAR_M, 0),
            ))
            "Commands: the commands that were given after the branch splits \
             off. Alarms: with cautions."
            @if session.branches > all.len() {
                " The latest " (all.len()) " of " (session.branches) " branches."
            }
        }
        (plan(outcome, all))
        (charts(outcome, all))
    }
}

fn name(id: usize) -> String {
    if id == 0 { "the first run".to_owned() } else { format!("branch {id}") }
}

/// The name of a branch in a table or a legend.
fn title(id: usize) -> String {
    if id == 0 { "First run".to_owned() } else { format!("Branch {id}") }
}

fn table(all: &[BranchOutcome], reported: usize) -> Markup {
    let none = || "–".to_owned();
    let percent = |share: Option<f64>| share.map_or_else(none, |share| fixed(100.0 * share, 0));
    let has_score = all.iter().any(|branch| branch.score.is_some());
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Branch"),
                    Head::Name("Goes off from"),
                    Head::Number("Ends", "min:s"),
                    Head::Name("Verdict"),
                    Head::Number(if has_score { "Score" } else { "Findings" }, ""),
                    Head::Number("Approach", "m/s"),
                    Head::Number("Fender", "% of rated energy"),
                    Head::Number("Line", "% of break load"),
                    Head::Number("Commands", ""),
                    Head::Number("Alarms", ""),
                ]))
                tbody {
                    @for branch in all {
                        tr class=[(branch.id == reported).then_some("strong")] {
                            td class="name" { (title(branch.id)) }
                            td class="name" { (goes_off(branch)) }
                            (number(&clock(branch.ends_s)))
                            td class="name" { (branch.verdict.text()) }
                            (number(&score(branch, has_score)))
                            (number(&branch.approach_mps.map_or_else(none, |mps| fixed(mps, 2))))
                            (number(&percent(branch.fender_share)))
                            (number(&percent(Some(branch.line_share))))
                            (number(&branch.commands.to_string()))
                            (number(&branch.alarms.to_string()))
                        }
                    }
                }
            }
        }
    }
}

fn goes_off(branch: &BranchOutcome) -> String {
    match branch.parent {
        None => "the start".to_owned(),
        Some(parent) => format!("{} at {}", name(parent), clock(branch.from_s)),
    }
}

/// The text of a branch's exercise score with its mark; without an exercise, the number of findings.
fn score(branch: &BranchOutcome, has_score: bool) -> String {
    match branch.score {
        Some((score, Some(true))) => format!("{} passed", fixed(score, 1)),
        Some((score, Some(false))) => format!("{} failed", fixed(score, 1)),
        Some((score, None)) => format!("{} so far", fixed(score, 1)),
        None if has_score => "–".to_owned(),
        None => branch.findings.len().to_string(),
    }
}

/// The plan view of the ship's tracks in all branches, with her hull at the end of each branch.
fn plan(outcome: &Outcome<'_>, all: &[BranchOutcome]) -> Markup {
    let points = || {
        all.iter().flat_map(|of| of.way.iter().map(|at| at.at_m).chain(of.hull_m.iter().copied()))
    };
    let Some(frame) = Frame::around(points()) else { return html! {} };
    let room = Vec2 { x: 1.0, y: 1.0 }
        * (ROOM * fenderline_contact::number::greater(frame.size().x, frame.size().y));
    let frame = Frame { low: frame.low - room, high: frame.high + room };
    let fixed_bodies =
        outcome.setup.bodies.iter().filter(|body| body.is_fixed() && !body.outline.is_of_parts());
    let fixed_bodies = fixed_bodies.map(|body| {
        let pose = fenderline_contact::Pose::new(body.position_m, body.heading_rad);
        let vertices_m = body.outline.vertices().iter().map(|corner| pose.apply(*corner)).collect();
        Outlined { vertices_m, stage: Stage::Fixed, style: 0 }
    });
    let hulls = all.iter().enumerate().map(|(style, of)| Outlined {
        vertices_m: of.hull_m.clone(),
        stage: Stage::End,
        style,
    });
    let tracks = all.iter().enumerate().map(|(style, of)| Track {
        points_m: of.way.iter().map(|at| at.at_m).collect(),
        style,
        is_one_of_many: false,
    });
    let labels = all.iter().filter_map(|of| {
        let side = Vec2 { x: 0.0, y: 1.0 };
        let place = Place::Beside { point_m: of.way.last()?.at_m, side };
        Some(Label { text: title(of.id), place })
    });
    let plan = Plan {
        title: "The ship in each branch: her track, and her hull at the end of the branch"
            .to_owned(),
        frame,
        outlines: fixed_bodies.chain(hulls).collect(),
        fenders: Vec::new(),
        harbour: Harbour::default(),
        tracks: tracks.collect(),
        arrows: Vec::<Arrow>::new(),
        labels: labels.collect(),
        note: String::new(),
    };
    plan.render()
}

fn charts(outcome: &Outcome<'_>, all: &[BranchOutcome]) -> Markup {
    let page = Charts::new(outcome);
    let end_s = all.iter().map(|of| of.ends_s).fold(0.0, fenderline_contact::number::greater);
    let (_, unit_s) = page.unit();
    let lines = |value: &dyn Fn(&WayPoint) -> Option<f64>| -> Vec<Series> {
        let line = |(style, of): (usize, &BranchOutcome)| {
            let points = of.way.iter().filter_map(|at| Some(Point { x: at.t_s, y: value(at)? }));
            Series::line(&title(of.id), points.collect()).styled(style)
        };
        all.iter().enumerate().map(line).collect()
    };
    let chart = |title: &str, y: Axis, series: Vec<Series>| {
        let mut chart = page.chart(title, y, series);
        chart.x = chart.x.including(end_s / unit_s);
        // The branches have separate time axes from the charts of the report.
        chart.linked = Some("branches");
        chart
    };
    let speeds = lines(&|at| Some(at.speed_mps / KNOT_MPS));
    let distances = lines(&|at| at.off_m);
    html! {
        (chart("Speed over ground", Axis::new("speed", "kn").including(0.0), speeds).render())
        @if all.iter().any(|of| of.way.iter().any(|at| at.off_m.is_some())) {
            (chart(
                "Distance of the nearer end from the fenders",
                Axis::new("distance", "m").including(0.0),
                distances,
            ).render())
        }
    }
}
