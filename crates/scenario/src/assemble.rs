//! Turns checked tables into the set-up of a simulation, and checks the rules between keys that the declarations of the
//! keys cannot express.

mod anchor;
mod approach;
mod assembly;
mod azimuth;
mod berthing;
mod bodies;
mod bottom;
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
mod overhead;
mod pairs;
mod panel;
mod particulars;
mod passing;
mod performance;
mod plan;
mod plausible;
mod providers;
mod response;
mod rollers;
mod rope;
mod rows;
mod seakeeping;
mod shore;
mod start_time;
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
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::Notice;
use fenderline_keys::held::TableOf;
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::environment::EnvironmentKey;
use fenderline_keys::keys::order::OrderKey;
use fenderline_keys::keys::run::{ContactKey, TimeKey};
use fenderline_keys::keys::windage::WindageKey;
use fenderline_keys::sources::Sources;
use fenderline_keys::typed_key::Key;
use fenderline_sim::environment::current::Current;
use fenderline_sim::environment::wind::{ShipWindage, Wind};
use fenderline_sim::exercise::ExerciseSetup;
use fenderline_sim::hydro::Particulars;
use fenderline_sim::overhead::OverheadSetup;
use fenderline_sim::{Integrator, Order, OutputPlan, Setup, WorldSetup};
use std::borrow::Cow;

use self::orders::OrderNames;

/// Greatest number of time steps of a run.
const MOST_STEPS: f64 = 1e9;

/// The fender and vessel data that a scenario may use by name.
pub(crate) struct Libraries {
    pub(crate) fenders: Cow<'static, FenderLibrary>,
    pub(crate) vessels: Cow<'static, VesselLibrary>,
}

/// Reads the wind areas of a vessel from her table.
pub(crate) fn windage<T>(
    sources: &Sources<'_>,
    table: Of<'_, T>,
    key: Key<T, TableOf<WindageKey>>,
    ship: &Particulars,
) -> Checked<Option<ShipWindage>> {
    let files = Files::default();
    Assembly { sources, files: &files, notices: &mut Vec::new() }.windage(table, key, ship)
}

/// Reads the wind from a table of the environment that names no file; `None` if the wind is refused.
pub(crate) fn read_wind(
    sources: &Sources<'_>,
    environment: Of<'_, EnvironmentKey>,
) -> Option<Wind> {
    let files = Files::default();
    let assembly = Assembly { sources, files: &files, notices: &mut Vec::new() };
    assembly.wind(environment, environment.item(EnvironmentKey::WIND)?).ok()
}

/// Reads the current from a table of the environment that names no file; `None` if the current is refused.
pub(crate) fn read_current(
    sources: &Sources<'_>,
    environment: Of<'_, EnvironmentKey>,
) -> Option<Current> {
    let files = Files::default();
    let assembly = Assembly { sources, files: &files, notices: &mut Vec::new() };
    assembly.current(environment, environment.item(EnvironmentKey::CURRENT)?).ok()
}

/// Builds the set-up of the simulation from the checked file, and adds warnings in the order of the file.
pub(crate) fn setup(
    sources: &Sources<'_>,
    file: Of<'_, ScenarioKey>,
    files: &Files,
    libraries: &Libraries,
    notices: &mut Vec<Notice>,
) -> Checked<(Setup, OutputPlan, Option<ExerciseSetup>)> {
    let mut assembly = Assembly { sources, files, notices };
    let (step_s, duration_s, integrator) = assembly.time(file.given(ScenarioKey::TIME).table())?;
    let output =
        assembly.output(file.item(ScenarioKey::OUTPUT).map(Entry::table), step_s, duration_s)?;
    let mut materials = assembly.materials(file.given(ScenarioKey::MATERIAL).named())?;
    let charted = assembly.chart(file.item(ScenarioKey::CHART).map(Entry::table))?;
    let water = file.given(ScenarioKey::ENVIRONMENT).table();
    let environment = assembly.environment(water, duration_s, &charted)?;
    let mut chart = charted.chart;
    let kinds = assembly.kinds(file, &libraries.vessels, &environment, step_s)?;
    assembly.note_unvalidated(file, &environment, &kinds);
    assembly.note_long_waves(file, &environment, &kinds);
    let mut bodies = assembly.bodies(file.given(ScenarioKey::BODY), &kinds, &chart)?;
    let chart_table = file.item(ScenarioKey::CHART).map(Entry::table);
    let shore = assembly.shore(chart_table, file, &mut chart, &mut bodies)?;
    let names = Names::new(&bodies, &materials);
    let decks: vessel::Decks<'_> =
        kinds.of_bodies().chain(shore.is_some().then_some(None)).collect();
    let mut pairs = assembly.pairs(file.given(ScenarioKey::PAIR).list(), &bodies, &names)?;
    if let (Some(table), Some(_)) = (chart_table, &shore) {
        assembly.pair_with_shore(table, &bodies, &names, &mut pairs)?;
    }
    let loads = assembly.loads(file.given(ScenarioKey::LOAD).list(), &bodies, &names)?;
    let all_fenders = {
        let of_chart = rows::ChartOf { chart: &chart, table: chart_table };
        assembly.fender_tables(file, &bodies, of_chart, &names)?
    };
    let fender_tables = Tables::from(all_fenders.as_slice());
    let parts = FenderParts {
        library: &libraries.fenders,
        materials: &materials,
        decks: &decks,
        bodies: &bodies,
    };
    let mut fenders = assembly.fenders(fender_tables, &parts, &names)?;
    let of_materials = file.given(ScenarioKey::MATERIAL).named();
    assembly.roll(of_materials, fender_tables, &mut fenders, &mut materials)?;
    let of_bodies = file.given(ScenarioKey::BODY).named();
    let approaches = assembly.approaches(of_bodies, &mut bodies, &fenders, &pairs, &names)?;
    assembly.check_starts(of_bodies, &kinds, &bodies, &environment)?;
    if let Some(shore) = &shore {
        assembly.check_starts_off_shore(file, &bodies, (&chart, shore))?;
    }
    let in_water = (bodies.as_mut_slice(), &environment);
    let vessels = assembly.vessels(file.given(ScenarioKey::BODY).named(), &kinds, in_water)?;
    let flow =
        assembly.flow(file, &libraries.vessels, (&kinds, &vessels, &bodies), &environment)?;
    let statistics = assembly.statistics(file, &vessels, &names)?;
    let tugs = assembly.tugs(file.given(ScenarioKey::TUG).named(), &vessels, &names)?;
    let start_level_m = environment.level_m(0.0);
    let lines = assembly.lines(
        file.given(ScenarioKey::LINE).named(),
        (&bodies, start_level_m),
        &decks,
        &names,
    )?;
    let anchors = assembly.anchors(
        file.given(ScenarioKey::ANCHOR).named(),
        (&bodies, &vessels),
        &environment,
        &names,
    )?;
    let bollards = assembly.all_bollards(
        (file.given(ScenarioKey::BOLLARD).named(), file.given(ScenarioKey::BOLLARD_ROW).named()),
        &bodies,
        rows::ChartOf { chart: &chart, table: chart_table },
        &names,
    )?;
    let line_handling = assembly.line_handling(file.given(ScenarioKey::LINE_HANDLING).table())?;
    let providers =
        assembly.providers(file.given(ScenarioKey::PROVIDER).list(), &bodies, &names)?;
    let factor_table = file.item(ScenarioKey::FACTORS).map(Entry::table);
    let factors = assembly.factors(factor_table)?;
    assembly.note_factors(factor_table, &factors, (fenders.len(), lines.len()));
    let study = file.item(ScenarioKey::BERTHING).map(Entry::table);
    let of_ships = (bodies.as_slice(), vessels.as_slice(), fenders.as_slice());
    let berthing = assembly.berthing(study, of_ships, &approaches, &environment, &names)?;
    assembly.check_heights(fender_tables, &fenders, &environment)?;
    assembly.note_odd_fenders(fender_tables, &fenders, &libraries.fenders);
    assembly.note_overlaps(fender_tables, &fenders);
    assembly.note_masses(of_bodies, &bodies, &environment);
    if let (Some(table), Some(study)) = (study, &berthing) {
        assembly.note_particulars(table, study, &bodies, &environment);
    }
    assembly.note_unused(file, &bodies, &pairs, (&fenders, fender_tables));
    let mut setup = Setup {
        step_s,
        duration_s,
        integrator,
        method: file.given(ScenarioKey::CONTACT).table().given(ContactKey::METHOD).choice(),
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
            overhead: OverheadSetup::default(),
            factors,
        },
    };
    setup.world.overhead = assembly.overhead(file, &setup)?;
    assembly.note_outside_hulls(fender_tables, &setup);
    assembly.check_passing(file, &setup)?;
    assembly.plans(file.given(ScenarioKey::PLAN).named(), &mut setup, &names)?;
    assembly.note_holes_at_fenders(file, &setup);
    assembly.note_late_arrivals(of_bodies, &setup);
    assembly.note_draughts(file, fender_tables, &setup);
    let orders = file.given(ScenarioKey::ORDER).list();
    setup.world.orders = assembly.orders(orders, &OrderNames::new(&setup, &names))?;
    setup.world.planned = assembly.events(file.given(ScenarioKey::EVENT).list(), &setup, &names)?;
    assembly.note_idle_keys(file, &setup, fender_tables);
    let exercise = file.item(ScenarioKey::EXERCISE).map(Entry::table);
    let exercise = assembly.exercise(exercise, &setup, &names)?;
    Ok((setup, output, exercise))
}

/// Reads an order to a vessel, tug, mooring line or anchor of a set-up.
pub(crate) fn order(
    sources: &Sources<'_>,
    table: Of<'_, OrderKey>,
    setup: &Setup,
) -> Checked<Order> {
    let (files, mut notices) = (Files::default(), Vec::new());
    let assembly = Assembly { sources, files: &files, notices: &mut notices };
    let names = Names::new(&setup.bodies, &setup.materials);
    assembly.order(table, &OrderNames::new(setup, &names))
}

impl Assembly<'_, '_> {
    fn time(&self, time: Of<'_, TimeKey>) -> Checked<(f64, f64, Integrator)> {
        let (step, duration) = (time.given(TimeKey::STEP), time.given(TimeKey::DURATION));
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
        Ok((step_s, duration_s, time.given(TimeKey::INTEGRATOR).choice()))
    }
}
