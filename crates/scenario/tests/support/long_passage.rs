//! Makes up a long passage: a channel that winds between two ragged coasts, with chart, survey and passage plan, and a
//! pilot who keeps a ship on the plan. The test `long_passage` and the example `passage` of `crates/embed` have this module in common.

use std::fmt::Write as _;

use fenderline_contact::number::bounded;
use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::{Action, Order, Simulation, VesselAction};

/// Size of a made-up passage.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Size {
    /// Numbers of nodes of the survey to the east and to the north.
    pub(crate) nodes: [usize; 2],
    /// Side of a cell of the survey (m).
    pub(crate) cell_m: f64,
    /// Number of corners of the coasts to the north and to the south together.
    pub(crate) corners: usize,
    /// Number of legs of the passage plan.
    pub(crate) legs: usize,
}

/// The sheet's passage: 10 nautical miles, 4 million cells, 20,000 corners of coast.
#[allow(dead_code, reason = "the test runs a small passage only")]
pub(crate) const WHOLE: Size = Size { nodes: [3960, 1010], cell_m: 5.0, corners: 20_000, legs: 6 };

/// The files of a made-up passage.
pub(crate) struct Files {
    pub(crate) scenario: String,
    pub(crate) chart: String,
    pub(crate) survey: String,
}

/// Half of the width of the channel's level bottom (m), the depth there (m), and the slope of its sides.
const CHANNEL: (f64, f64, f64) = (90.0, 14.5, 1.0 / 8.0);
/// How far the channel's middle line swings to the north and to the south (m).
const SWING_M: f64 = 350.0;
/// Distance of the first and the last waypoint from the ends of the survey (m).
const END_M: f64 = 600.0;
/// Speed that the pilot orders (m/s): 10 knots.
pub(crate) const SPEED_MPS: f64 = 10.0 * 1852.0 / 3600.0;

impl Size {
    fn length_m(&self) -> f64 {
        (self.nodes[0] - 1) as f64 * self.cell_m
    }

    /// Half of the survey's extent to the north (m). The origin is in the middle of the western side.
    fn half_m(&self) -> f64 {
        0.5 * (self.nodes[1] - 1) as f64 * self.cell_m
    }

    /// The waypoints, east and north (m).
    fn waypoints(&self) -> Vec<[f64; 2]> {
        let leg_m = (self.length_m() - 2.0 * END_M) / self.legs as f64;
        let north_m = |index: usize| match index {
            0 => 0.0,
            _ if index == self.legs => 0.0,
            _ if index % 2 == 1 => SWING_M,
            _ => -SWING_M,
        };
        (0..=self.legs).map(|index| [END_M + index as f64 * leg_m, north_m(index)]).collect()
    }

    /// Depth below datum (m): the channel, dredged into a bottom with shoals that rises to the coasts.
    fn depth_m(&self, waypoints: &[[f64; 2]], [east_m, north_m]: [f64; 2]) -> f64 {
        let leg_m = waypoints[1][0] - waypoints[0][0];
        let leg = bounded(libm::floor((east_m - END_M) / leg_m), 0.0, (self.legs - 1) as f64);
        // Beside the ends of a leg the nearest place of the channel may be on the next leg.
        let legs = (leg as usize).saturating_sub(1)..(leg as usize + 2).min(self.legs);
        let off_m = legs
            .map(|leg| {
                let ([a, b], [c, d]) = (waypoints[leg], waypoints[leg + 1]);
                let (along, across) = (c - a, d - b);
                let (x, y) = (east_m - a, north_m - b);
                let share = (x * along + y * across) / (along * along + across * across);
                // The first and the last leg go on to the ends of the survey.
                let low = if leg == 0 { -1.0 } else { 0.0 };
                let high = if leg + 1 == self.legs { 2.0 } else { 1.0 };
                let share = bounded(share, low, high);
                libm::hypot(x - share * along, y - share * across)
            })
            .fold(f64::INFINITY, libm::fmin);
        let (half_width_m, dredged_m, slope) = CHANNEL;
        let shoals_m = 1.5 * libm::sin(east_m / 310.0) * libm::cos(north_m / 170.0);
        let natural_m = 9.0 + shoals_m - 9.0 * libm::pow(north_m.abs() / self.half_m(), 4.0);
        libm::fmax(natural_m, dredged_m - slope * libm::fmax(off_m - half_width_m, 0.0))
    }

    /// The chart: two areas of land with ragged borders, in metres.
    fn chart(&self) -> String {
        let mut features = Vec::new();
        for side in [1.0, -1.0] {
            // Three corners of each area lie behind its border.
            let count = self.corners / 2 - 2;
            let (far_m, length_m) = (side * (self.half_m() + 500.0), self.length_m());
            let mut ring = format!("[-400, {far_m}]");
            for corner in 0..count {
                let east_m = -400.0 + (length_m + 800.0) * corner as f64 / (count - 1) as f64;
                let ragged =
                    libm::sin(0.7 * corner as f64) * libm::cos(0.013 * corner as f64 + side);
                let north_m = side * (self.half_m() - 60.0 + 40.0 * ragged);
                let _ = write!(ring, ", [{east_m:.2}, {north_m:.2}]");
            }
            let _ = write!(ring, ", [{:.2}, {far_m}], [-400, {far_m}]", length_m + 400.0);
            features.push(format!(
                "{{ \"type\": \"Feature\", \"properties\": {{ \"OBJL\": 71, \"OBJNAM\": \"Coast\" }}, \
                 \"geometry\": {{ \"type\": \"Polygon\", \"coordinates\": [[{ring}]] }} }}"
            ));
        }
        let features = features.join(",\n");
        format!("{{ \"type\": \"FeatureCollection\", \"features\": [\n{features}\n] }}\n")
    }

    /// The survey, an ESRI ASCII grid of depths with two decimals.
    fn survey(&self) -> String {
        let ([columns, rows], cell_m) = (self.nodes, self.cell_m);
        let mut text = format!(
            "ncols {columns}\nnrows {rows}\nxllcenter 0\nyllcenter {}\ncellsize {cell_m}\nNODATA_value -9999\n",
            -self.half_m()
        );
        text.reserve(7 * columns * rows);
        let waypoints = self.waypoints();
        for row in (0..rows).rev() {
            for column in 0..columns {
                let at_m = [column as f64 * cell_m, row as f64 * cell_m - self.half_m()];
                let _ = write!(text, "{:.2} ", self.depth_m(&waypoints, at_m));
            }
            text.pop();
            text.push('\n');
        }
        text
    }

    /// The scenario: the bulk carrier of scenarios/harbours, with banks, squat in a channel, and coasts that are solid.
    fn scenario(&self) -> String {
        let waypoints = self.waypoints();
        let mut plan = String::from("[plan.passage]\nvessel = \"ship\"\n");
        for (index, [east_m, north_m]) in waypoints.iter().enumerate() {
            let _ = write!(
                plan,
                "\n[[plan.passage.waypoint]]\nname = \"W{index}\"\nposition = [{north_m}, {east_m}]\n"
            );
            if index > 0 {
                plan.push_str("speed = \"10 kn\"\nhalf_width = \"60 m\"\n");
            }
            if index > 0 && index < self.legs {
                plan.push_str("turning_radius = \"900 m\"\n");
            }
        }
        let [first, second] = [waypoints[0], waypoints[1]];
        let course_deg = libm::atan2(second[0] - first[0], second[1] - first[1]).to_degrees();
        format!(
            r#"title = "A made-up passage"

[time]
step = "0.1 s"
duration = "2 h"

[environment]
tide = {{ level = "0.5 m" }}
squat = "icorels_channel"

[environment.bottom]
survey = ["passage.asc"]
banks = "norrbin"

[chart]
files = ["passage.geojson"]
coordinates = "metres"
solid = ["LNDARE"]
solid_material = "rock"

[material.rock]
stiffness = "5 MN/m^2"
shear_stiffness = "3 MN/m"
friction_static = 0.3
friction_dynamic = 0.3

[vessel.bulker]
length_bp = "180 m"
beam = "30 m"
draught = "10.5 m"
block_coefficient = 0.82
propeller = {{ diameter = "6 m", full = "110 rpm" }}
rudder = {{ area = "34 m^2", span = "7.5 m" }}

[body.ship]
vessel = "bulker"
outline = [
    [-93, -9], [-84, -13.5], [-68, -15], [58, -15], [74, -12.5], [86, -6.5], [92, 0], [86, 6.5], [74, 12.5],
    [58, 15], [-68, 15], [-84, 13.5], [-93, 9],
]
position = [{}, {}]
heading = "{course_deg:.3} deg"
velocity = {{ surge = "10 kn" }}
running = 0.8

{plan}"#,
            first[1], first[0]
        )
    }

    /// Makes the files of the passage.
    pub(crate) fn files(&self) -> Files {
        Files { scenario: self.scenario(), chart: self.chart(), survey: self.survey() }
    }
}

impl Files {
    /// Reads the scenario from the texts.
    #[allow(dead_code, reason = "the example reads the files from the disk")]
    pub(crate) fn read(&self) -> Result<Scenario, ScenarioError> {
        Scenario::parse_among(&self.scenario, "passage.toml", &[], &mut |name| match name {
            "passage.asc" => Ok(self.survey.clone()),
            "passage.geojson" => Ok(self.chart.clone()),
            _ => Err(format!("{name}: there is no such file")),
        })
    }
}

/// What the pilot did with the ship.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sailed {
    pub(crate) steps: u64,
    /// Length of the passage plan (m).
    pub(crate) along_m: f64,
    /// Largest cross-track distance from the plan (m).
    pub(crate) off_m: f64,
    /// Least depth under the ship (m).
    pub(crate) least_m: f64,
}

/// Sails a ship along her passage plan to its end, at most for `most_steps`. Every 10 steps the pilot orders a course
/// from the cross-track distance of a place ahead of the ship.
pub(crate) fn sail(simulation: &mut Simulation, most_steps: u64) -> Sailed {
    /// Distance ahead of the ship at which the pilot looks at the plan (m).
    const LOOK_M: f64 = 350.0;
    let plan = simulation.setup().world.vessels[0].plan.clone().expect("the ship has a plan");
    let body = simulation.setup().world.vessels[0].body;
    let order = |action: VesselAction| Order { at_s: 0.0, action: Action::Vessel(0, action) };
    simulation.order(order(VesselAction::Speed(SPEED_MPS))).expect("the ship has an engine");
    let mut sailed = Sailed { least_m: f64::INFINITY, ..Sailed::default() };
    while sailed.steps < most_steps {
        if sailed.steps.is_multiple_of(10) {
            let pose = simulation.states()[body].pose();
            let on = plan.at(pose.position_m);
            (sailed.along_m, sailed.off_m) =
                (on.along_m, libm::fmax(sailed.off_m, on.cross_track_m.abs()));
            if on.along_m >= plan.length_m() {
                break;
            }
            let ahead = plan.at(pose.apply(fenderline_contact::vec2(LOOK_M, 0.0)));
            let back_rad = bounded(ahead.cross_track_m / 500.0, -0.5, 0.5);
            let course = VesselAction::Course(ahead.course_rad - back_rad);
            simulation.order(order(course)).expect("the ship has a rudder");
        }
        let record = simulation.step().expect("the ship is where the depth is known");
        if let Some(least_m) = record.soundings[0].least_m {
            sailed.least_m = libm::fmin(sailed.least_m, least_m);
        }
        sailed.steps += 1;
    }
    sailed
}
