//! Makes a grid of water depths from surveys and from a chart. Module `survey` reads survey files, and `placed`
//! converts their coordinates. `charted` takes depths from a chart, `triangles` interpolates between points, and
//! `lattice` has the nodes of the grid.

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

/// Largest number of nodes of a grid of depths, which takes 16 MB.
const MOST_NODES: usize = 4_000_000;
/// If the user gives no cell size, a chart gets cells of such a size that the grid of depths has about this number of
/// nodes.
const USUAL_NODES: f64 = 500_000.0;
/// Smallest side of a cell that the program chooses by itself for a chart (m).
const SMALLEST_CELL_M: f64 = 1.0;
/// Side of a cell from which on a notice says that the grid is coarse for a berth (m).
const COARSE_CELL_M: f64 = 25.0;
/// A triangle between soundings counts as a hole in the survey if its longest side is more than this number of times
/// the median of all triangles' longest sides.
const HOLE: f64 = 5.0;
/// Share of the nodes in water that may lie in two depth areas of different depth without a notice to the user.
const FEW: f64 = 0.001;

/// The surveys, the chart and the options from which a grid of depths is made.
pub struct Request<'r> {
    /// File name and text of each survey. At each place, the first survey in the list that has data there counts.
    pub surveys: Vec<(&'r str, &'r str)>,
    /// The key of the scenario that names the survey files, for messages.
    pub key: &'r str,
    /// The kind of coordinates in the surveys: metres, degrees, or metres of UTM.
    pub coordinates: SurveyCoordinates,
    /// Whether the values of the surveys are depths or heights; if `None`, the sign of most values decides.
    pub values: Option<SurveyValues>,
    /// How depths are taken from the chart; `None` if no depths are taken from the chart.
    pub choice: Option<ChartDepths>,
    /// The chart.
    pub chart: &'r Chart,
    /// For a chart in longitude and latitude: its projection, the origin of the projection, and whether the projection
    /// is UTM.
    pub projected: Option<(Projected, GeographicPlace, bool)>,
    /// Side of a grid cell (m); if `None`, the program chooses the side.
    pub cell_m: Option<f64>,
}

/// A grid of depths, with notices for the user.
pub struct Made {
    /// The grid of depths.
    pub field: DepthField,
    /// The sentence of each notice, and what the notice concerns.
    pub told: Vec<(About, String)>,
}

/// The input that a notice or a mistake concerns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// The survey files.
    Survey,
    /// The coordinates of the surveys.
    Coordinates,
    /// The chart.
    Chart,
    /// The side of the cells of the grid of depths.
    Cell,
}

/// The reason why no grid of depths can be made.
pub enum Refusal {
    /// There is a mistake in a survey file.
    InFile(Box<ScenarioError>),
    /// There is a mistake in the scenario: the input that the mistake concerns, what is wrong, and advice for the user.
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
                "most values of {name} are negative: all values are taken as heights above datum, and their sign is changed to get depths"
            );
            told.push((About::Survey, text));
        }
        surveys.push(survey);
    }
    if request.choice.is_some() && charted::areas(request.chart).next().is_none() {
        return Err(without_depths(request.chart));
    }
    // A single survey that is a grid in metres is used as it is.
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
            let help = "the survey or the chart is of another place, or the survey's coordinates are not those that `survey_coordinates` says";
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
                "depth areas of the chart lie over each other in {share:.1} % of the water: where two areas overlap, the program takes the lesser depth"
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
                "a survey in degrees or in UTM needs a chart with an origin, about which its coordinates are converted to metres"
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
        "use a chart with depth areas, or give a `survey`, or one `depth` for all of the water",
    )
}

fn field(lattice: &Lattice, depths_m: &[f64]) -> Result<DepthField, Refusal> {
    let Lattice { origin_m, cell_m, columns, rows } = *lattice;
    // Depths of a chart have one decimal, so single precision is enough.
    let depths_m = depths_m.iter().map(|depth_m| *depth_m as f32).collect();
    DepthField::new(origin_m, cell_m, columns, rows, depths_m).map_err(|error| {
        Refusal::Of(About::Cell, error.to_string(), "check the survey and the key `cell`")
    })
}

/// Chooses the nodes of the grid of depths, which covers the rectangle `extent`.
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
            // A survey within a chart keeps its cell size, as long as the grid of depths does not become too large.
            true => libm::fmax(of_surveys, libm::sqrt(size.x * size.y / MOST_NODES as f64) * 1.01),
            false => of_chart_m,
        }
    };
    let cell_m = request.cell_m.unwrap_or_else(chosen_m);
    let lattice = Lattice::around(extent, cell_m);
    if lattice.nodes() > MOST_NODES {
        let least_m = round_up_m(libm::sqrt(size.x * size.y / MOST_NODES as f64));
        let message = format!(
            "with cells of {cell_m} m the grid of depths has {} nodes, but at most {MOST_NODES} are allowed: cells of {least_m} m are large enough",
            lattice.nodes()
        );
        return Err(Refusal::Of(
            About::Cell,
            message,
            "cut the chart and the surveys to the area of the exercise, or make `cell` larger",
        ));
    }
    if request.cell_m.is_none() && cell_m >= COARSE_CELL_M {
        let text = format!(
            "the grid of depths has cells of {cell_m:.0} m, chosen for an area of {:.0} km by {:.0} km, which is coarse for a berth: cut the chart to the area of the exercise, or give `cell`",
            size.x / 1e3,
            size.y / 1e3
        );
        told.push((About::Chart, text));
    }
    Ok(lattice)
}

/// A survey that is ready to give the depth at any place that it covers.
struct Source {
    kind: Kind,
    /// Distance between neighbouring points of the survey (m): the side of a cell for a grid.
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
                    return Err(Refusal::Of(
                        About::Survey,
                        message,
                        "the points of a survey must cover an area",
                    ));
                };
                // If the points lie on a square grid, the longest side of a triangle is the diagonal of a cell.
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

    /// Sets the depths of those nodes whose depth is still NaN, where the survey has data.
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
