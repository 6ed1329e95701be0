//! From checked tables to a simulation set-up: rules that hold between keys, which the key
//! table cannot express.

mod azimuth;
mod berthing;
mod bodies;
mod current;
mod environment;
mod fenders;
mod loads;
mod materials;
mod orders;
mod pairs;
mod performance;
mod providers;
mod response;
mod unused;
mod vessel;
mod windage;
mod world;

pub(crate) use self::azimuth::azimuths;
use self::vessel::Decks;
use crate::checked::{Item, Table};
use crate::error::{Notice, ScenarioError};
use crate::files::Files;
use crate::library::FenderLibrary;
use crate::sources::{Sources, quoted};
use crate::suggest::nearest;
use crate::vessels::VesselLibrary;
use fenderline_sim::environment::wind::ShipWindage;
use fenderline_sim::hydro::Particulars;
use fenderline_sim::{BodySetup, Integrator, NamedMaterial, Order, Setup, WorldSetup};
use std::collections::BTreeMap;

use self::orders::OrderNames;
use self::unused::listed;

type Checked<T> = Result<T, ScenarioError>;

/// Most steps of a run.
const MOST_STEPS: f64 = 1e9;

/// The data that a scenario may name.
pub(crate) struct Libraries {
    pub(crate) fenders: FenderLibrary,
    pub(crate) vessels: VesselLibrary,
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

/// Builds the set-up from the checked file, and adds notices in the order of the file.
pub(crate) fn setup(
    sources: &Sources<'_>,
    file: &Table,
    files: &Files,
    libraries: &Libraries,
    notices: &mut Vec<Notice>,
) -> Checked<Setup> {
    let mut assembly = Assembly { sources, files, notices };
    let (step_s, duration_s, integrator) = assembly.time(file.given("time").table())?;
    let materials = assembly.materials(file.given("material").named())?;
    let environment = assembly.environment(file.given("environment").table())?;
    let kinds = assembly.kinds(file, &libraries.vessels, &environment)?;
    assembly.note_unvalidated(file, &environment, &kinds);
    let bodies = assembly.bodies(file.given("body"), &kinds)?;
    let names = Names::new(&bodies, &materials);
    let decks: vessel::Decks<'_> = kinds.of_bodies().collect();
    let pairs = assembly.pairs(file.given("pair").list(), &bodies, &names)?;
    let loads = assembly.loads(file.given("load").list(), &bodies, &names)?;
    let parts = FenderParts { library: &libraries.fenders, materials: &materials, decks: &decks };
    let fenders = assembly.fenders(file.given("fender").named(), &parts, &names)?;
    let vessels = assembly.vessels(file.given("body").named(), &kinds)?;
    let tugs = assembly.tugs(file.given("tug").named(), &vessels, &names)?;
    let lines =
        assembly.lines(file.given("line").named(), (&bodies, &environment.tide), &decks, &names)?;
    let providers = assembly.providers(file.given("provider").list(), &bodies, &names)?;
    let berthing = file.item("berthing").map(Item::table);
    let berthing = assembly.berthing(berthing, &bodies, &names)?;
    assembly.note_unused(file, &bodies, &pairs, &fenders);
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
        berthing,
        loads,
        world: WorldSetup { environment, vessels, orders: vec![], tugs, lines, providers },
    };
    let orders = file.given("order").list();
    setup.world.orders = assembly.orders(orders, &OrderNames::new(&setup, &names))?;
    Ok(setup)
}

/// An order to a vessel, tug or line of a set-up.
pub(crate) fn order(sources: &Sources<'_>, table: &Table, setup: &Setup) -> Checked<Order> {
    let (files, mut notices) = (Files::default(), Vec::new());
    let assembly = Assembly { sources, files: &files, notices: &mut notices };
    let names = Names::new(&setup.bodies, &setup.materials);
    assembly.order(table, &OrderNames::new(setup, &names))
}

/// The names that pairs and loads refer to.
struct Names {
    bodies: BTreeMap<String, usize>,
    materials: BTreeMap<String, usize>,
}

impl Names {
    fn new(bodies: &[BodySetup], materials: &[NamedMaterial]) -> Names {
        let numbered = |names: &mut dyn Iterator<Item = &String>| {
            names.enumerate().map(|(index, name)| (name.clone(), index)).collect()
        };
        Names {
            bodies: numbered(&mut bodies.iter().map(|body| &body.name)),
            materials: numbered(&mut materials.iter().map(|material| &material.name)),
        }
    }
}

/// What fenders refer to.
struct FenderParts<'p> {
    library: &'p FenderLibrary,
    materials: &'p [NamedMaterial],
    decks: &'p Decks<'p>,
}

struct Assembly<'s, 'a> {
    sources: &'s Sources<'a>,
    files: &'s Files,
    notices: &'s mut Vec<Notice>,
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

    fn body_named(&self, table: &Table, item: &Item, name: &str, names: &Names) -> Checked<usize> {
        self.reference("body", "bodies", &names.bodies, table, item, name)
    }

    /// The floating body that a key names; `why` says in an error what a fixed body cannot do.
    fn floating_body(
        &self,
        table: &Table,
        key: &str,
        bodies: &[BodySetup],
        names: &Names,
        why: &str,
    ) -> Checked<usize> {
        let item = table.given(key);
        let body = self.body_named(table, item, item.name(), names)?;
        if bodies[body].mass.is_none() {
            let path = table.path_of(key);
            let message = format!("`{path}`: body {} is fixed, {why}", quoted(item.name()));
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(body)
    }

    fn material_named(&self, table: &Table, item: &Item, names: &Names) -> Checked<usize> {
        self.reference("material", "materials", &names.materials, table, item, item.name())
    }

    fn reference(
        &self,
        kind: &str,
        kinds: &str,
        known: &BTreeMap<String, usize>,
        table: &Table,
        item: &Item,
        name: &str,
    ) -> Checked<usize> {
        known.get(name).copied().ok_or_else(|| {
            let path = table.path_of(item.name);
            let message = format!("`{path}`: there is no {kind} {}", quoted(name));
            let error = self.sources.error(&item.span, &path, message);
            error.with_help(match nearest(name, known.keys().map(String::as_str)) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None if known.is_empty() => format!("the scenario has no {kinds}"),
                None => format!(
                    "the scenario has the {kinds} {}",
                    listed(known.keys().map(String::as_str))
                ),
            })
        })
    }
}
