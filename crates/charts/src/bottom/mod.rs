//! The depths of the bottom by place, from surveys and from a chart: `survey` reads files, `placed` has their coordinates,
//! `charted` has the areas of a chart, `triangles` the depths between points, `lattice` the nodes of the field.

mod charted;
mod lattice;
mod placed;
mod survey;
mod triangles;

use fenderline_contact::Vec2;
use fenderline_keys::error::ScenarioError;
use fenderline_keys::keys::bottom::{ChartDepths, SurveyCoordinates, SurveyValues};
use fenderline_sim::chart::{Chart, GeographicPlace};
use fenderline_sim::environment::DepthField;

use self::lattice::{Extent, Lattice, round_up_m};
use self::placed::Place;
use self::survey::{Form, Survey, Values};
use self::triangles::{Sounded, Triangles};
use crate::chart::projection::Projected;

pub use self::charted::LAND_HEIGHT_M;

/// Most nodes of a field: 16 MB.
const MOST_NODES: usize = 4_000_000;
/// A chart gets cells of such a size that the field has about this many nodes.
const USUAL_NODES: f64 = 500_000.0;
/// The smallest cell that is chosen (m).
const SMALLEST_CELL_M: f64 = 1.0;
/// Cells from this size on are coarse for a berth (m).
const COARSE_CELL_M: f64 = 25.0;
/// A triangle between soundings that is so many times longer than most is a hole in the survey.
const HOLE: f64 = 5.0;
/// Share of the nodes in the water that may lie in two areas of different depth before it is said.
const FEW: f64 = 0.001;

/// What a bottom is made of.
pub struct Request<'r> {
    /// Name and text of each survey. The first one with data at a place counts.
    pub surveys: Vec<(&'r str, &'r str)>,
    /// The key that names the surveys.
    pub key: &'r str,
    /// What the coordinates of the surveys are.
    pub coordinates: SurveyCoordinates,
    /// What the values of the surveys are; `None`: as most of their signs say.
    pub values: Option<SurveyValues>,
    /// How the depths of the chart are taken; `None`: they are not.
    pub choice: Option<ChartDepths>,
    /// The chart.
    pub chart: &'r Chart,
    /// The projection of the chart, if the chart is in longitude and latitude: about its origin, and whether it is UTM.
    pub projected: Option<(Projected, GeographicPlace, bool)>,
    /// Side of a cell (m); `None`: it is chosen.
    pub cell_m: Option<f64>,
}

/// A bottom, with what a user should know of it.
pub struct Made {
    /// The grid of depths.
    pub field: DepthField,
    /// Sentences for notices, each with what it concerns.
    pub told: Vec<(About, String)>,
}

/// What a sentence or a mistake concerns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// The files of the surveys.
    Survey,
    /// The coordinates of the surveys.
    Coordinates,
    /// The chart.
    Chart,
    /// The side of the grid's cells.
    Cell,
}

/// Why no bottom can be made.
pub enum Refusal {
    /// A mistake in a file.
    InFile(Box<ScenarioError>),
    /// A mistake of the scenario: what it concerns, what is wrong, what helps.
    Of(About, String, &'static str),
}

impl From<ScenarioError> for Refusal {
    fn from(error: ScenarioError) -> Refusal {
        Refusal::InFile(Box::new(error))
    }
}

/// Makes the grid of depths that a request asks for.
///
/// # Errors
/// [`Refusal`].
pub fn make(request: &Request<'_>) -> Result<Made, Refusal> {
    let mut told = Vec::new();
    let place = place(request)?;
    let mut surveys = Vec::new();
    for &(name, text) in &request.surveys {
        let survey = survey::read((name, text), request.key, &place, request.values)?;
        if survey.values == Values::FoundHeights {
            let text = format!(
                "most values of {name} are negative: they are taken as heights above datum, and depths are their opposites"
            );
            told.push((About::Survey, text));
        }
        surveys.push(survey);
    }
    if request.choice.is_some() && charted::areas(request.chart).next().is_none() {
        return Err(without_depths(request.chart));
    }
    // One grid of metres is the field itself.
    if let ([Survey { form: Form::Grid { origin_m, cell_m, columns, rows, depths_m }, .. }], None) =
        (surveys.as_slice(), request.choice)
        && request.cell_m.is_none_or(|wanted_m| wanted_m == *cell_m)
    {
        let lattice =
            Lattice { origin_m: *origin_m, cell_m: *cell_m, columns: *columns, rows: *rows };
        return Ok(Made { field: field(&lattice, depths_m)?, told });
    }
    let sources: Vec<Source> = surveys.into_iter().map(Source::of).collect::<Result<_, _>>()?;
    let of_surveys =
        sources.iter().map(Source::extent).fold(Extent::NONE, |all, one| all.joined(one));
    let mut extent = of_surveys;
    if request.choice.is_some() {
        let of_chart = charted::extent(request.chart);
        if !sources.is_empty() && !of_surveys.meets(of_chart) {
            let message = "the survey lies outside of the chart".to_owned();
            let help = "one of the two is of another place, or the survey's coordinates are not those that `survey_coordinates` says";
            return Err(Refusal::Of(About::Survey, message, help));
        }
        extent = extent.joined(of_chart);
    }
    let lattice = lattice(request, &sources, extent, &mut told)?;
    let mut depths_m = vec![f64::NAN; lattice.nodes()];
    for source in &sources {
        source.fill(&lattice, &mut depths_m);
    }
    if let Some(choice) = request.choice {
        let charted = charted::depths(request.chart, &lattice, choice);
        if charted.overlapping as f64 > FEW * charted.water as f64 {
            let share = 100.0 * charted.overlapping as f64 / charted.water as f64;
            let text = format!(
                "depth areas of the chart lie over each other at {share:.1} % of the water: the lesser depth counts there"
            );
            told.push((About::Chart, text));
        }
        let of_chart = depths_m.iter_mut().zip(charted.depths_m);
        of_chart
            .filter(|(own_m, _)| own_m.is_nan())
            .for_each(|(own_m, charted_m)| *own_m = charted_m);
    }
    Ok(Made { field: field(&lattice, &depths_m)?, told })
}

fn place(request: &Request<'_>) -> Result<Place, Refusal> {
    match (request.coordinates, &request.projected) {
        (SurveyCoordinates::Metres, _) => Ok(Place::Metres),
        (_, None) => {
            let message =
                "longitude and latitude, and UTM, become metres only about the origin of a chart"
                    .to_owned();
            let help = "give [chart] with coordinates = \"longitude_latitude\", a projection and an origin";
            Err(Refusal::Of(About::Coordinates, message, help))
        }
        (SurveyCoordinates::LongitudeLatitude, Some((projected, ..))) => {
            Ok(Place::Degrees(projected.clone()))
        }
        (SurveyCoordinates::Utm, Some((projected, origin, is_utm))) => {
            let origin = *origin;
            Ok(match is_utm {
                true => Place::Utm { utm: projected.clone(), own: None, origin },
                false => {
                    Place::Utm { utm: Projected::utm(origin), own: Some(projected.clone()), origin }
                }
            })
        }
    }
}

fn without_depths(chart: &Chart) -> Refusal {
    let message = match chart.read_in_words() {
        None => "there is no [chart] with features".to_owned(),
        Some(read) => format!(
            "the chart has no depth areas (DEPARE, DRGARE, depth_area, dredged_area), but {read}"
        ),
    };
    Refusal::Of(
        About::Chart,
        message,
        "take a chart with depth areas, or a `survey`, or a `depth` for all of the water",
    )
}

fn field(lattice: &Lattice, depths_m: &[f64]) -> Result<DepthField, Refusal> {
    let Lattice { origin_m, cell_m, columns, rows } = *lattice;
    // Depths of a chart have a decimal: single precision is enough.
    let depths_m = depths_m.iter().map(|depth_m| *depth_m as f32).collect();
    DepthField::new(origin_m, cell_m, columns, rows, depths_m)
        .map_err(|error| Refusal::Of(About::Cell, error.to_string(), "see the survey and `cell`"))
}

/// The nodes of the field.
fn lattice(
    request: &Request<'_>,
    sources: &[Source],
    extent: Extent,
    told: &mut Vec<(About, String)>,
) -> Result<Lattice, Refusal> {
    let size = extent.high - extent.low;
    let chosen_m = || {
        let of_surveys = sources.iter().map(|source| source.cell_m).fold(f64::INFINITY, libm::fmin);
        let usual_m = libm::sqrt(size.x * size.y / USUAL_NODES);
        let of_chart_m = round_up_m(libm::fmax(usual_m, SMALLEST_CELL_M));
        match of_surveys.is_finite() {
            true if request.choice.is_none() => of_surveys,
            // A survey in a chart keeps its detail, as long as the field stays small.
            true => libm::fmax(of_surveys, libm::sqrt(size.x * size.y / MOST_NODES as f64) * 1.01),
            false => of_chart_m,
        }
    };
    let cell_m = request.cell_m.unwrap_or_else(chosen_m);
    let lattice = Lattice::around(extent, cell_m);
    if lattice.nodes() > MOST_NODES {
        let least_m = round_up_m(libm::sqrt(size.x * size.y / MOST_NODES as f64));
        let message = format!(
            "with cells of {cell_m} m the bottom has {} nodes, but at most {MOST_NODES} are made: cells of {least_m} m are large enough",
            lattice.nodes()
        );
        return Err(Refusal::Of(
            About::Cell,
            message,
            "cut chart and surveys to the area of the exercise, or make `cell` larger",
        ));
    }
    if request.cell_m.is_none() && cell_m >= COARSE_CELL_M {
        let text = format!(
            "the cells of the bottom are {cell_m:.0} m, chosen for {:.0} km by {:.0} km: coarse for a berth; cut the chart to the area of the exercise, or give `cell`",
            size.x / 1e3,
            size.y / 1e3
        );
        told.push((About::Chart, text));
    }
    Ok(lattice)
}

/// A survey that gives depths at places.
struct Source {
    kind: Kind,
    /// The scale of the survey's detail (m).
    cell_m: f64,
}

enum Kind {
    Grid(DepthField),
    Points { triangles: Triangles, longest_m: f64, extent: Extent },
}

impl Source {
    fn of(survey: Survey) -> Result<Source, Refusal> {
        match survey.form {
            Form::Grid { origin_m, cell_m, columns, rows, depths_m } => {
                let lattice = Lattice { origin_m, cell_m, columns, rows };
                Ok(Source { kind: Kind::Grid(field(&lattice, &depths_m)?), cell_m })
            }
            Form::Points(points) => {
                let extent = Extent::around(points.iter().map(|(at_m, _)| *at_m));
                let sounded = |(at_m, depth_m): (Vec2, f64)| Sounded { at_m, depth_m };
                let triangles = Triangles::of(points.into_iter().map(sounded).collect());
                let mut sides_m = triangles.longest_sides_m();
                sides_m.sort_by(f64::total_cmp);
                let Some(&usual_m) = sides_m.get(sides_m.len() / 2) else {
                    let message = "the points of the survey lie on one line".to_owned();
                    return Err(Refusal::Of(About::Survey, message, "a survey covers an area"));
                };
                // Points on a square grid: the longest side of a triangle is the diagonal of a cell.
                let cell_m = libm::fmax(usual_m / core::f64::consts::SQRT_2, 0.1);
                let longest_m = HOLE * usual_m;
                Ok(Source { kind: Kind::Points { triangles, longest_m, extent }, cell_m })
            }
        }
    }

    fn extent(&self) -> Extent {
        match &self.kind {
            Kind::Grid(field) => Extent::around(field.corners_m().into_iter()),
            Kind::Points { extent, .. } => *extent,
        }
    }

    /// Gives depths to the nodes that have none.
    fn fill(&self, lattice: &Lattice, depths_m: &mut [f64]) {
        match &self.kind {
            Kind::Grid(field) => {
                for row in 0..lattice.rows {
                    for column in 0..lattice.columns {
                        let node = lattice.index(column, row);
                        if depths_m[node].is_nan()
                            && let Some(depth_m) = field.depth_m(lattice.place_m(column, row))
                        {
                            depths_m[node] = depth_m;
                        }
                    }
                }
            }
            Kind::Points { triangles, longest_m, .. } => {
                let own = triangles.depths_m(lattice, *longest_m);
                let nodes = depths_m.iter_mut().zip(own);
                nodes.filter(|(depth_m, _)| depth_m.is_nan()).for_each(|(to, from)| *to = from);
            }
        }
    }
}
