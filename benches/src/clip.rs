//! Our clip of two convex polygons timed beside those of parry2d and i_overlay.

use fenderline_contact::{ConvexPolygon, PairClip};

use crate::ours;
use crate::paths::{Approach, CALLS, Path, path};
use crate::peers::{Gjk, Overlay, Parry, ParryPath, parry_path};
use crate::rounds::{Contender, median, median_ratio, nanoseconds_a_call};
use crate::shapes;
use fenderline_bench_scenes::table::Table;

/// For polygons that overlap a little: corners of the fender, corners of the hull, and how many times as fast as
/// parry2d our clip must be.
const SIZES: [(usize, usize, f64); 4] =
    [(4, 4, 4.0), (8, 24, 12.0), (24, 24, 13.0), (64, 64, 16.0)];

/// Corners of the fender and of the hull in further rows of the table, whose polygons are apart and were not near each
/// other in any earlier call.
const LARGE: [(usize, usize); 3] = [(4, 1000), (200, 200), (1000, 1000)];

/// How many times as fast as parry2d's search for the distance our clip has to be for polygons that are apart.
const APART_TO_REACH: f64 = 12.0;

/// Never slower than parry2d.
const ELSE_TO_REACH: f64 = 1.0;

/// i_overlay takes long, so that it makes only one call while the others make this number of calls.
const OVERLAY_EVERY: usize = 8;

/// One row of the table that this bench prints.
#[derive(Clone, Copy)]
struct Case {
    name: &'static str,
    approach: Approach,
    cold: bool,
    peer: Peer,
    to_reach: Option<f64>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Peer {
    Overlap,
    Distance,
    Apart,
}

pub(crate) fn bench(rounds: usize) -> Table {
    let mut table = Table::new(&[
        "fender, hull",
        "case",
        "ours [ns]",
        "parry2d [ns]",
        "i_overlay [ns]",
        "parry2d/ours",
        "to reach",
        "",
        "area differs by",
    ]);
    for (fender, hull, shallow) in SIZES {
        for case in cases(shallow) {
            table.row(row(fender, hull, case, rounds));
        }
    }
    for (fender, hull) in LARGE {
        table.row(row(fender, hull, apart_and_cold(), rounds));
    }
    table.note("Times are medians; ratios of times are taken round by round.");
    table.note("parry2d: the function `convex_polygons_intersection_points` of that library finds the overlap.");
    table.note("In the rows `apart`, and in the row `cold`, parry2d stands for its GJK search, which starts with the \
                direction that its last call found.");
    table.note("In the rows `apart`, each library finds the distance of the two polygons, or finds only that they do not touch.");
    table.note("area differs by: the largest relative difference between our area of the overlap and parry2d's.");
    table.note(
        "parry2d counts a corner that lies on an edge as inside or outside, as rounding decides.",
    );
    table
}

fn cases(shallow: f64) -> [Case; 7] {
    let case = |name, approach, cold, peer, to_reach| Case { name, approach, cold, peer, to_reach };
    use Approach::{Deep, Near, Shallow};
    use Peer::{Apart, Distance, Overlap};
    [
        case("shallow", Shallow, false, Overlap, Some(shallow)),
        case("shallow, cold", Shallow, true, Overlap, Some(ELSE_TO_REACH)),
        case("deep", Deep, false, Overlap, Some(ELSE_TO_REACH)),
        case("deep, cold", Deep, true, Overlap, Some(ELSE_TO_REACH)),
        case("apart: distance", Near, false, Distance, Some(APART_TO_REACH)),
        case("apart: no more", Near, false, Apart, None),
        apart_and_cold(),
    ]
}

/// The row of polygons that are apart, where our clip forgets the last call; parry2d's search keeps its last direction.
fn apart_and_cold() -> Case {
    Case {
        name: "apart: distance, cold",
        approach: Approach::Near,
        cold: true,
        peer: Peer::Distance,
        to_reach: Some(ELSE_TO_REACH),
    }
}

fn row(fender: usize, hull: usize, case: Case, rounds: usize) -> Vec<String> {
    let first = shapes::hull(hull);
    let second = match case.approach {
        Approach::Deep => shapes::vessel(fender),
        Approach::Shallow | Approach::Near => shapes::fender(fender),
    };
    let path = path(case.approach, &first, &second);
    let sparse: Path = path.iter().copied().step_by(OVERLAY_EVERY).collect();
    let for_parry = parry_path(&path);
    let mut contenders = [
        our_contender(case, &first, &second, &path),
        parry_contender(case, &first, &second, &for_parry),
        overlay_contender(&first, &second, &sparse),
    ];
    let times = nanoseconds_a_call(&mut contenders, rounds);
    let ratio = median_ratio(&times[1], &times[0]);
    let difference = match case.peer {
        Peer::Overlap => format!("{:.1e}", largest_difference(&first, &second, &path)),
        Peer::Distance | Peer::Apart => String::new(),
    };
    vec![
        format!("({fender}, {hull})"),
        case.name.to_owned(),
        format!("{:.1}", median(&times[0])),
        format!("{:.0}", median(&times[1])),
        format!("{:.0}", median(&times[2])),
        format!("{ratio:.1}"),
        case.to_reach.map_or(String::from("-"), |least| format!("≥ {least}")),
        case.to_reach.map_or("", |least| if ratio >= least { "✓" } else { "✗" }).to_owned(),
        difference,
    ]
}

fn our_contender<'a>(
    case: Case,
    first: &'a ConvexPolygon,
    second: &'a ConvexPolygon,
    path: &'a Path,
) -> Contender<'a> {
    let mut pair = PairClip::default();
    let round = move || ours::round(&mut pair, first, second, path, case.cold);
    Contender::clocked(round, CALLS)
}

fn parry_contender<'a>(
    case: Case,
    first: &ConvexPolygon,
    second: &ConvexPolygon,
    path: &'a ParryPath,
) -> Contender<'a> {
    let round: Box<dyn FnMut() + 'a> = match case.peer {
        Peer::Overlap => {
            let mut parry = Parry::new(first, second);
            Box::new(move || parry.round(path))
        }
        Peer::Distance => {
            let mut gjk = Gjk::new(first, second);
            Box::new(move || gjk.distance_round(path))
        }
        Peer::Apart => {
            let mut gjk = Gjk::new(first, second);
            Box::new(move || gjk.apart_round(path))
        }
    };
    Contender::clocked(round, CALLS)
}

fn overlay_contender<'a>(
    first: &ConvexPolygon,
    second: &ConvexPolygon,
    path: &'a Path,
) -> Contender<'a> {
    let mut overlay = Overlay::new(first.vertices(), second.vertices());
    Contender::clocked(move || overlay.round(path), path.len())
}

fn largest_difference(first: &ConvexPolygon, second: &ConvexPolygon, path: &Path) -> f64 {
    let mut parry = Parry::new(first, second);
    let ours = ours::areas_m2(first, second, path);
    parry_path(path)
        .iter()
        .zip(ours)
        .map(|(&[one, two], our_m2)| (parry.overlap(one, two).0 - our_m2).abs() / our_m2)
        .fold(0.0, f64::max)
}
