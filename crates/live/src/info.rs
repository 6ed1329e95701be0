//! The data of a scenario that do not change during a session, for pages: hulls, machinery, fenders, lines, anchors,
//! tugs, orders.

use fenderline_contact::Vec2;
use fenderline_contact::number::lesser;
use fenderline_sim::berth::Berth;
use fenderline_sim::environment::waves::Sea;
use fenderline_sim::mooring::InboardEnd;
use fenderline_sim::order::{OrderName, SidePlace, TargetKind, Word, towline};
use fenderline_sim::passing::PassingSetup;
use fenderline_sim::{
    AnchorSetup, BollardSetup, HullByHeight, Level, LineEnd, LineHandling, MooringSetup, Rain,
    Setup, ShipType, TugSetup, VesselSetup,
};

use crate::berth;
use crate::cast::Cast;
use crate::chart_info::chart_infos;
use crate::message::{
    AnchorInfo, AzimuthInfo, BodyInfo, BollardInfo, ChartInfo, ConningInfo, DaylightInfo,
    FenderInfo, LevelInfo, LineEndInfo, LineInfo, ModelInfo, OrderInfo, TelegraphInfo,
    ThrusterInfo, TrafficInfo, TugInfo, VesselInfo,
};
use crate::order_info::{order_infos, telegraph};
use crate::pair::pair;
use crate::plan;

/// The working load of a cable as a share of its breaking load. The guideline for ropes gives no working load of
/// cables, so that the share is our choice.
const CABLE_WORKING_SHARE: f64 = 0.5;
/// Rate at which a winch runs in a manual order, if it can run so fast (m/s): a usual speed for warping under load.
const MANUAL_WINCH_MPS: f64 = 0.15;

/// The data of a scenario that do not change during a session.
#[derive(Clone, Debug, PartialEq)]
pub struct Info {
    /// The field `bodies` of [`crate::message::Hello`].
    pub bodies: Vec<BodyInfo>,
    /// The field `vessels` of [`crate::message::Hello`].
    pub vessels: Vec<VesselInfo>,
    /// The field `fenders` of [`crate::message::Hello`].
    pub fenders: Vec<FenderInfo>,
    /// The field `lines` of [`crate::message::Hello`].
    pub lines: Vec<LineInfo>,
    /// The field `anchors` of [`crate::message::Hello`].
    pub anchors: Vec<AnchorInfo>,
    /// The field `bollards` of [`crate::message::Hello`].
    pub bollards: Vec<BollardInfo>,
    /// The field `tugs` of [`crate::message::Hello`].
    pub tugs: Vec<TugInfo>,
    /// The field `traffic` of [`crate::message::Hello`].
    pub traffic: Vec<TrafficInfo>,
    /// The field `orders` of [`crate::message::Hello`].
    pub orders: Vec<OrderInfo>,
    /// The field `telegraph` of [`crate::message::Hello`].
    pub telegraph: Vec<TelegraphInfo>,
    /// The berth from which distances are measured.
    pub berth: Option<Berth>,
    /// Depth of the water (m).
    pub depth_m: Option<f64>,
    /// The field `highest_water_m` of [`crate::message::Hello`].
    pub highest_water_m: f64,
    /// The field `clearance_datum_m` of [`crate::message::Hello`].
    pub clearance_datum_m: Option<f64>,
    /// The field `sea` of [`crate::message::Hello`]: for each harmonic its amplitude (m), wave number north and east
    /// (rad/m), angular frequency (rad/s), and phase at the origin at time 0 (rad).
    pub sea: Vec<[f64; 5]>,
    /// The field `daylight` of [`crate::message::Hello`].
    pub daylight: Option<DaylightInfo>,
    /// The field `rain` of [`crate::message::Hello`].
    pub rain: Option<&'static str>,
    /// The field `chart` of [`crate::message::Hello`].
    pub chart: Vec<ChartInfo>,
}

impl Info {
    /// Collects, from a scenario's set-up, the data that do not change during a session.
    #[must_use]
    pub fn of(setup: &Setup, cast: &Cast) -> Info {
        let world = &setup.world;
        let bodies = setup.bodies.iter().map(|body| BodyInfo {
            name: body.name.clone(),
            fixed: body.mass.is_none(),
            // The shore is on the chart already.
            outline: match body.outline.is_of_parts() {
                true => Vec::new(),
                false => pairs(body.outline.vertices()),
            },
            levels: body.hull.as_ref().map_or_else(Vec::new, level_infos),
        });
        let fenders = setup.fenders.iter().map(|fender| FenderInfo {
            name: fender.name.clone(),
            body: fender.body,
            at_m: pair(fender.position_m),
            facing_rad: fender.facing_rad,
            width_m: fender.width_m,
            projection_m: fender.projection_m,
            height_m: fender.height_m,
            above_water_m: fender.above_water_m,
            floating: fender.floating,
            family: fender.source.as_ref().and_then(|source| source.family.clone()),
            cones_m: fender.panel.as_ref().map_or_else(Vec::new, |panel| panel.cones_m.clone()),
            rated_deflection_m: fender.rated.map(|rated| rated.deflection_m),
            rated_reaction_n: fender.rated.map(|rated| rated.reaction_n),
            rated_energy_j: fender.rated.map(|rated| rated.energy_j),
        });
        Info {
            bodies: bodies.collect(),
            vessels: (0..world.vessels.len())
                .map(|index| vessel_info(setup, cast, index))
                .collect(),
            fenders: fenders.collect(),
            lines: world
                .lines
                .iter()
                .map(|line| line_info(line, is_towline(line, setup, cast), &world.line_handling))
                .collect(),
            anchors: world.anchors.iter().map(|anchor| anchor_info(anchor, setup)).collect(),
            bollards: world.bollards.iter().map(bollard_info).collect(),
            tugs: world.tugs.iter().map(|tug| tug_info(tug, &world.vessels)).collect(),
            traffic: world.flow.passing.iter().map(traffic_info).collect(),
            orders: order_infos(),
            telegraph: telegraph(),
            berth: berth::of(setup, cast),
            depth_m: world.environment.depth_m,
            highest_water_m: world.environment.level_range_m()[1],
            clearance_datum_m: world.overhead.clearance_datum_m,
            sea: world.environment.sea.as_ref().map_or_else(Vec::new, harmonics),
            daylight: world.environment.daylight.map(|daylight| DaylightInfo {
                start_unix_s: daylight.start_unix_s,
                latitude_rad: daylight.place.latitude_rad,
                longitude_rad: daylight.place.longitude_rad,
            }),
            rain: world.environment.rain.map(Rain::word),
            chart: chart_infos(&world.chart),
        }
    }
}

fn pairs(corners_m: &[Vec2]) -> Vec<[f64; 2]> {
    corners_m.iter().map(|&at| pair(at)).collect()
}

/// The outlines of a hull; none if the hull has upright sides.
fn level_infos(hull: &HullByHeight) -> Vec<LevelInfo> {
    let levels = hull.levels();
    if levels.windows(2).all(|two| two[0].vertices_m == two[1].vertices_m) {
        return Vec::new();
    }
    let info = |level: &Level| LevelInfo {
        height_m: level.height_m - hull.draught_m(),
        outline: pairs(&level.vertices_m),
    };
    levels.iter().map(info).collect()
}

/// The harmonics of a sea that have a height.
fn harmonics(sea: &Sea) -> Vec<[f64; 5]> {
    let there = sea.components().iter().filter(|wave| wave.amplitude_m > 0.0);
    there
        .map(|wave| {
            let Vec2 { x: north_radpm, y: east_radpm } = wave.number_radpm;
            [wave.amplitude_m, north_radpm, east_radpm, wave.frequency_radps, wave.phase_rad]
        })
        .collect()
}

fn traffic_info(ship: &PassingSetup) -> TrafficInfo {
    TrafficInfo { name: ship.name.clone(), outline: pairs(&ship.outline_m) }
}

fn vessel_info(setup: &Setup, cast: &Cast, index: usize) -> VesselInfo {
    let (vessel, is_tug) = (&setup.world.vessels[index], cast.is_tug[index]);
    let served = cast.serves[index].map(|ship| setup.world.vessels[ship].body);
    let has_gear = |order: &&OrderName| {
        let spec = order.spec();
        spec.target == TargetKind::Vessel && spec.gear.is_on(index, setup)
    };
    let orders = OrderName::ALL.iter().filter(has_gear).map(|order| order.spec().word);
    let has_towline = served.is_some_and(|ship| towline(setup, vessel.body, ship).is_some());
    let hull = &vessel.ship.particulars;
    let name = setup.bodies[vessel.body].name.clone();
    let title = if vessel.origin.title.is_empty() { &name } else { &vessel.origin.title };
    let propelled = vessel.ship.propulsion.is_some();
    // Distance of the centre of gravity ahead of midship. The body's origin is its centre of gravity.
    let ahead_m = hull.centre_of_gravity_m;
    let thrusters = vessel.thrusters.iter().map(|thruster| ThrusterInfo {
        name: thruster.name.clone(),
        along_m: thruster.tunnel.along_m - ahead_m,
        force_n: thruster.tunnel.bollard_n,
    });
    let azimuths = vessel.azimuths.iter().map(|azimuth| AzimuthInfo {
        name: azimuth.name.clone(),
        at_m: [azimuth.unit.along_m - ahead_m, azimuth.unit.across_m],
        bollard_n: azimuth.bollard_n,
    });
    VesselInfo {
        title: title.clone(),
        name,
        body: vessel.body,
        length_m: hull.length_m,
        beam_m: hull.beam_m,
        draught_m: hull.draught_m,
        kind: vessel.looks.ship_type.map(ShipType::word),
        conning: vessel.looks.conning.map(|conning| ConningInfo {
            at_m: [conning.at_m.x - ahead_m, conning.at_m.y],
            eye_above_water_m: conning.eye_above_water_m,
        }),
        model: vessel.looks.model.as_ref().map(|model| ModelInfo {
            file: model.file.clone(),
            crc32: crc32fast::hash(&model.bytes),
            origin_m: [-ahead_m, 0.0],
        }),
        under_keel_limit_m: vessel.under_keel_caution_m(),
        rudder_stop_rad: propelled.then_some(vessel.rudder.stop),
        full_rps: propelled.then_some(vessel.shaft.stop),
        thrusters: thrusters.collect(),
        azimuths: azimuths.collect(),
        is_tug,
        serves: cast.serves[index],
        has_towline,
        places: if is_tug { Vec::new() } else { places(setup, vessel) },
        orders: orders.collect(),
        plan: vessel.plan.as_ref().map(plan::info),
    }
}

/// Named places at a ship's side for orders to tugs, the nearest first.
fn places(setup: &Setup, ship: &VesselSetup) -> Vec<&'static str> {
    let (outline, length_m) = (&setup.bodies[ship.body].outline, ship.ship.particulars.length_m);
    let has_side =
        |place: &&SidePlace| **place == SidePlace::Nearest || place.on(outline, length_m).is_some();
    SidePlace::ALL.iter().filter(has_side).map(|place| place.word()).collect()
}

/// Whether a line goes from a tug to another vessel.
fn is_towline(line: &MooringSetup, setup: &Setup, cast: &Cast) -> bool {
    let Some(LineEnd::OnBody { body: far, .. }) = line.end else { return false };
    let vessels = || setup.world.vessels.iter().zip(&cast.is_tug);
    let is_tug = |body: usize| vessels().any(|(vessel, is_tug)| *is_tug && vessel.body == body);
    let is_vessel = |body: usize| vessels().any(|(vessel, _)| vessel.body == body);
    is_vessel(line.ship) && is_vessel(far) && (is_tug(line.ship) || is_tug(far))
}

fn line_info(line: &MooringSetup, is_towline: bool, handling: &LineHandling) -> LineInfo {
    let rope_m = line.reach_m();
    let (reach_m, reach_by) = match handling.boat_mps {
        None if handling.heaving_line_m < rope_m => (handling.heaving_line_m, "a heaving line"),
        _ => (rope_m, "the rope"),
    };
    let breaking_n = line.line.kind.break_load_n();
    LineInfo {
        name: line.line.name.clone(),
        ship: line.ship,
        fairlead_m: pair(line.fairlead_m),
        fairlead_above_water_m: line.fairlead_above_water_m,
        end: line.end.map(|end| match end {
            LineEnd::Fixed([north_m, east_m, above_datum_m]) => {
                LineEndInfo::Fixed { place_m: [north_m, east_m], above_datum_m }
            }
            LineEnd::OnBody { body, at_m, above_water_m } => {
                LineEndInfo::OnBody { body, at_m: pair(at_m), above_water_m }
            }
        }),
        is_towline,
        breaking_n,
        working_n: line.line.kind.working_load_n().unwrap_or(CABLE_WORKING_SHARE * breaking_n),
        winch_mps: match line.line.inboard_end {
            InboardEnd::Winch(winch) => Some(lesser(MANUAL_WINCH_MPS, winch.rate_mps)),
            InboardEnd::Bitts => None,
        },
        reach_m,
        reach_by,
    }
}

fn anchor_info(anchor: &AnchorSetup, setup: &Setup) -> AnchorInfo {
    let gear = &anchor.gear;
    AnchorInfo {
        name: gear.name.clone(),
        ship: setup.world.vessels[anchor.vessel].body,
        hawse_m: pair(anchor.hawse_m),
        hawse_above_water_m: anchor.hawse_above_water_m,
        chain_m: gear.chain_length_m,
        mass_kg: gear.mass_kg,
        breaking_n: gear.chain().break_load_n(),
        brake_n: gear.windlass.brake_n,
    }
}

fn bollard_info(bollard: &BollardSetup) -> BollardInfo {
    BollardInfo {
        name: bollard.name.clone(),
        body: bollard.body,
        at_m: pair(bollard.at_m),
        above_water_m: bollard.above_water_m,
        most_lines: bollard.most_lines,
    }
}

fn tug_info(tug: &TugSetup, vessels: &[VesselSetup]) -> TugInfo {
    let ahead_m = vessels[tug.vessel].ship.particulars.centre_of_gravity_m;
    let from_gravity = |at_m: Vec2| [at_m.x - ahead_m, at_m.y];
    TugInfo {
        name: tug.tug.name.clone(),
        vessel: tug.vessel,
        length_m: tug.tug.envelope.length_m,
        beam_m: tug.tug.envelope.beam_m,
        bollard_pull_n: tug.tug.envelope.bollard_pull_n,
        push_at_m: from_gravity(tug.tug.push_at_m),
        pull_at_m: from_gravity(tug.tug.pull_at_m),
    }
}
