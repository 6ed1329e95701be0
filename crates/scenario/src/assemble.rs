//! From checked tables to a simulation set-up: rules that hold between keys, which the key
//! table cannot express.

mod anchor;
mod approach;
mod assembly;
mod azimuth;
mod berthing;
mod bodies;
mod chains;
mod chart;
mod coefficients;
mod current;
mod dolphins;
mod draught;
mod edge;
mod environment;
mod events;
mod exercise;
mod factors;
mod fender_sense;
mod fenders;
mod flexible;
mod hull;
mod idle;
mod limits;
mod loads;
mod long_waves;
mod materials;
mod mooring;
mod orders;
mod output;
mod pairs;
mod panel;
mod particulars;
mod passing;
mod performance;
mod plausible;
mod providers;
mod response;
mod rollers;
mod rope;
mod rows;
mod seakeeping;
mod unused;
mod vessel;
mod windage;
mod world;

use self::assembly::{Assembly, Checked, Names};
pub(crate) use self::azimuth::azimuths;
pub(crate) use self::bodies::velocity as read_velocity;
pub(crate) use self::dolphins::add_dolphins;
use self::fenders::FenderParts;
use crate::files::Files;
use crate::library::FenderLibrary;
use crate::vessels::VesselLibrary;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::error::Notice;
use fenderline_keys::sources::Sources;
use fenderline_sim::environment::current::Current;
use fenderline_sim::environment::wind::{ShipWindage, Wind};
use fenderline_sim::exercise::ExerciseSetup;
use fenderline_sim::hydro::Particulars;
use fenderline_sim::{Integrator, Order, OutputPlan, Setup, WorldSetup};
use std::borrow::Cow;

use self::orders::OrderNames;

/// Most steps of a run.
const MOST_STEPS: f64 = 1e9;

/// The data that a scenario may name.
pub(crate) struct Libraries {
    pub(crate) fenders: Cow<'static, FenderLibrary>,
    pub(crate) vessels: Cow<'static, VesselLibrary>,
}

/// Wind areas of a vessel from her table.
pub(crate) fn windage(
    sources: &Sources<'_>,
    table: &Table,
    ship: &Particulars,
) -> Checked<Option<ShipWindage>> {
    let files = Files::default();
    Assembly { sources, files: &files, notices: &mut Vec::new() }.windage(table, ship)
}

/// The wind in a table of the environment that names no file; `None` if it is refused.
pub(crate) fn read_wind(sources: &Sources<'_>, environment: &Table) -> Option<Wind> {
    let files = Files::default();
    let assembly = Assembly { sources, files: &files, notices: &mut Vec::new() };
    assembly.wind(environment, environment.item("wind")?).ok()
}

/// The current in a table of the environment that names no file; `None` if it is refused.
pub(crate) fn read_current(sources: &Sources<'_>, environment: &Table) -> Option<Current> {
    let files = Files::default();
    let assembly = Assembly { sources, files: &files, notices: &mut Vec::new() };
    assembly.current(environment, environment.item("current")?).ok()
}

/// Builds the set-up from the checked file, and adds notices in the order of the file.
pub(crate) fn setup(
    sources: &Sources<'_>,
    file: &Table,
    files: &Files,
    libraries: &Libraries,
    notices: &mut Vec<Notice>,
) -> Checked<(Setup, OutputPlan, Option<ExerciseSetup>)> {
    let mut assembly = Assembly { sources, files, notices };
    let (step_s, duration_s, integrator) = assembly.time(file.given("time").table())?;
    let output = assembly.output(file.item("output").map(Item::table), step_s, duration_s)?;
    let mut materials = assembly.materials(file.given("material").named())?;
    let environment = assembly.environment(file.given("environment").table(), duration_s)?;
    let kinds = assembly.kinds(file, &libraries.vessels, &environment, step_s)?;
    assembly.note_unvalidated(file, &environment, &kinds);
    assembly.note_long_waves(file, &environment, &kinds);
    let chart = assembly.chart(file.item("chart").map(Item::table))?;
    let mut bodies = assembly.bodies(file.given("body"), &kinds, &chart)?;
    let names = Names::new(&bodies, &materials);
    let decks: vessel::Decks<'_> = kinds.of_bodies().collect();
    let pairs = assembly.pairs(file.given("pair").list(), &bodies, &names)?;
    let loads = assembly.loads(file.given("load").list(), &bodies, &names)?;
    let fender_tables = assembly.fender_tables(file, &bodies, &names)?;
    let parts = FenderParts {
        library: &libraries.fenders,
        materials: &materials,
        decks: &decks,
        bodies: &bodies,
    };
    let mut fenders = assembly.fenders(&fender_tables, &parts, &names)?;
    let of_materials = file.given("material").named();
    assembly.roll(of_materials, &fender_tables, &mut fenders, &mut materials)?;
    let of_bodies = file.given("body").named();
    let approaches = assembly.approaches(of_bodies, &mut bodies, &fenders, &pairs, &names)?;
    let vessels = assembly.vessels(file.given("body").named(), &kinds)?;
    let flow =
        assembly.flow(file, &libraries.vessels, (&kinds, &vessels, &bodies), &environment)?;
    let statistics = assembly.statistics(file, &vessels, &names)?;
    let tugs = assembly.tugs(file.given("tug").named(), &vessels, &names)?;
    let start_level_m = environment.level_m(0.0);
    let lines =
        assembly.lines(file.given("line").named(), (&bodies, start_level_m), &decks, &names)?;
    let anchors = assembly.anchors(
        file.given("anchor").named(),
        (&bodies, &vessels),
        &environment,
        &names,
    )?;
    let bollards = assembly.bollards(file.given("bollard").named(), &names)?;
    let line_handling = assembly.line_handling(file.given("line_handling").table())?;
    let providers = assembly.providers(file.given("provider").list(), &bodies, &names)?;
    let factor_table = file.item("factors").map(Item::table);
    let factors = assembly.factors(factor_table)?;
    assembly.note_factors(factor_table, &factors, (fenders.len(), lines.len()));
    let study = file.item("berthing").map(Item::table);
    let of_ships = (bodies.as_slice(), vessels.as_slice(), fenders.as_slice());
    let berthing = assembly.berthing(study, of_ships, &approaches, &environment, &names)?;
    assembly.check_heights(&fender_tables, &fenders, &environment)?;
    assembly.note_odd_fenders(&fender_tables, &fenders, &libraries.fenders);
    assembly.note_overlaps(&fender_tables, &fenders);
    assembly.note_masses(of_bodies, &bodies, &environment);
    if let (Some(table), Some(study)) = (study, &berthing) {
        assembly.note_particulars(table, study, &bodies, &environment);
    }
    assembly.note_unused(file, &bodies, &pairs, (&fenders, &fender_tables));
    let mut setup = Setup {
        step_s,
        duration_s,
        integrator,
        method: file.given("contact").table().given("method").choice(),
        bodies,
        materials,
        pairs: pairs.named,
        all_other_pairs: pairs.every_other,
        fenders,
        approaches,
        berthing,
        loads,
        world: WorldSetup {
            environment,
            vessels,
            orders: vec![],
            planned: vec![],
            tugs,
            lines,
            anchors,
            bollards,
            line_handling,
            flow,
            statistics,
            providers,
            chart,
            factors,
        },
    };
    assembly.note_outside_hulls(&fender_tables, &setup);
    assembly.check_passing(file, &setup)?;
    assembly.note_late_arrivals(of_bodies, &setup);
    assembly.note_draughts(file, &fender_tables, &setup);
    let orders = file.given("order").list();
    setup.world.orders = assembly.orders(orders, &OrderNames::new(&setup, &names))?;
    setup.world.planned = assembly.events(file.given("event").list(), &setup, &names)?;
    assembly.note_idle_keys(file, &setup, &fender_tables);
    let exercise = file.item("exercise").map(Item::table);
    let exercise = assembly.exercise(exercise, &setup, &names)?;
    Ok((setup, output, exercise))
}

/// An order to a vessel, tug, line or anchor of a set-up.
pub(crate) fn order(sources: &Sources<'_>, table: &Table, setup: &Setup) -> Checked<Order> {
    let (files, mut notices) = (Files::default(), Vec::new());
    let assembly = Assembly { sources, files: &files, notices: &mut notices };
    let names = Names::new(&setup.bodies, &setup.materials);
    assembly.order(table, &OrderNames::new(setup, &names))
}

impl Assembly<'_, '_> {
    fn time(&self, time: &Table) -> Checked<(f64, f64, Integrator)> {
        let (step, duration) = (time.given("step"), time.given("duration"));
        let (step_s, duration_s) = (*step.number(), *duration.number());
        if step_s > duration_s {
            let message = format!(
                "`time.step` of {step_s} s is longer than `time.duration`, which is {duration_s} s"
            );
            let error = self.sources.error(&step.span, "time.step", message);
            return Err(error.with_help("take a shorter step or a longer run"));
        }
        if duration_s / step_s > MOST_STEPS {
            let message = format!(
                "`time.duration` of {duration_s} s at a step of {step_s} s makes more than \
                 {MOST_STEPS:e} steps"
            );
            let error = self.sources.error(&duration.span, "time.duration", message);
            return Err(error.with_help("take a longer step or a shorter run"));
        }
        Ok((step_s, duration_s, time.given("integrator").choice()))
    }
}
