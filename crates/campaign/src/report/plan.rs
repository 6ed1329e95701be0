//! The report's plan view of many runs: paths and last positions of the ships.

use fenderline_contact::number::greater;
use fenderline_contact::vec2;
use fenderline_report::plot::{Frame, Harbour, Outlined, Plan, Stage, Track};
use maud::{Markup, html};

use crate::run::Seen;

/// Largest number of runs whose ships are drawn at the end of the run: more ships would cover each other.
const ENDS: usize = 25;

/// Margin of the plan view around the ships, as a share of the size of the drawn scene.
const ROOM: f64 = 0.04;

/// The section with the plan view; empty if there are no runs.
pub(super) fn section(seen: &[Seen]) -> Markup {
    let Some(first) = seen.first() else { return html! {} };
    let fixed = first.fixed_m.iter().map(|vertices_m| Outlined {
        vertices_m: vertices_m.clone(),
        stage: Stage::Fixed,
        style: 0,
    });
    let ends = seen.iter().take(ENDS).flat_map(|run| run.ends_m.iter().enumerate());
    let ends = ends.map(|(style, vertices_m)| Outlined {
        vertices_m: vertices_m.clone(),
        stage: Stage::End,
        style,
    });
    let tracks = seen.iter().flat_map(|run| run.paths_m.iter().enumerate());
    let tracks: Vec<Track> = tracks
        .map(|(style, points_m)| Track { points_m: points_m.clone(), style, is_one_of_many: true })
        .collect();
    let outlines: Vec<Outlined> = fixed.chain(ends).collect();
    let points = outlines
        .iter()
        .flat_map(|of| &of.vertices_m)
        .chain(tracks.iter().flat_map(|of| &of.points_m));
    let Some(frame) = Frame::around(points.copied()) else { return html! {} };
    let room = vec2(1.0, 1.0) * (ROOM * greater(frame.size().x, frame.size().y));
    let plan = Plan {
        title: format!("Paths of the first {} runs", seen.len()),
        frame: Frame { low: frame.low - room, high: frame.high + room },
        outlines,
        fenders: Vec::new(),
        harbour: Harbour::default(),
        tracks,
        arrows: Vec::new(),
        labels: Vec::new(),
        note: format!(
            "Lines: centres of gravity. Outlines: the ships at the end of the run, for the first {} runs.",
            seen.len().min(ENDS)
        ),
    };
    html! {
        h2 { "Tracks" }
        (plan.render())
    }
}
