//! From checked tables to a simulation set-up: what the key table cannot say, because it holds
//! between keys.

mod azimuth;
mod current;
mod environment;
mod fenders;
mod orders;
mod providers;
mod response;
mod vessel;
mod windage;
mod world;

use std::collections::{BTreeMap, BTreeSet};

use fenderline_contact::{Material, Outline, Vec2};
use fenderline_sim::environment::wind::ShipWindage;
use fenderline_sim::hydro::Particulars;
use fenderline_sim::{
    BodySetup, BodyVelocity, FenderSetup, Integrator, Load, MassProperties, NamedMaterial, Order,
    PairSetup, Setup, WorldSetup,
};

use crate::checked::{Item, Table};
use crate::error::{Notice, ScenarioError};
use crate::files::Files;
use crate::library::FenderLibrary;
use crate::sources::{Sources, quoted};
use crate::suggest::nearest;
use crate::vessels::VesselLibrary;

pub(crate) use self::azimuth::azimuths;
use self::orders::OrderNames;
use self::vessel::Decks;

type Checked<T> = Result<T, ScenarioError>;

/// Friction beyond which a scenario is told that it is unusual. Rubber on dry steel or concrete comes to about 1,
/// facings of polyethylene to 0.2 (recalled, not read in a source); the rest is for what is wet, new or rough.
const HIGHEST_USUAL_FRICTION: f64 = 1.5;

/// Most steps of a run.
const MOST_STEPS: f64 = 1e9;

/// The data that a scenario may name.
pub(crate) struct Libraries {
    pub(crate) fenders: FenderLibrary,
    pub(crate) vessels: VesselLibrary,
}

/// Wind areas of a vessel, whose table is of these sources.
pub(crate) fn windage(
    sources: &Sources<'_>,
    table: &Table,
    ship: &Particulars,
) -> Checked<Option<ShipWindage>> {
    let files = Files::default();
    Assembly { sources, files: &files, notices: &mut Vec::new() }.windage(table, ship)
}

/// Builds the set-up from the checked file; notices are added to `notices` in the order of the file.
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
    let decks = vessel::decks(file.given("body").named(), &kinds);
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

/// An order to the vessels, tugs and lines of a set-up.
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

struct Pairs {
    named: Vec<PairSetup>,
    every_other: Option<usize>,
    /// The bodies of the named ones, the lower index first.
    touching: BTreeSet<[usize; 2]>,
}

impl Pairs {
    fn new(named: Vec<PairSetup>, every_other: Option<usize>) -> Pairs {
        let touching = named.iter().map(|pair| ordered(pair.bodies)).collect();
        Pairs { named, every_other, touching }
    }
}

fn ordered([one, other]: [usize; 2]) -> [usize; 2] {
    [one.min(other), one.max(other)]
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

    fn materials(&mut self, materials: &[(String, Table)]) -> Checked<Vec<NamedMaterial>> {
        let mut read = |(name, table): &(String, Table)| {
            Ok(NamedMaterial { name: name.clone(), material: self.material(table)? })
        };
        materials.iter().map(&mut read).collect()
    }

    fn material(&mut self, table: &Table) -> Checked<Material> {
        let friction_static = *table.given("friction_static").number();
        let dynamic = table.item("friction_dynamic");
        let friction_dynamic = dynamic.map_or(friction_static, |item| *item.number());
        if let Some(item) = dynamic.filter(|_| friction_dynamic > friction_static) {
            let path = table.path_of("friction_dynamic");
            let message = format!(
                "`{path}` must be at most `friction_static`, which is {friction_static}, but is \
                 {friction_dynamic}"
            );
            return Err(self.sources.error(&item.span, &path, message));
        }
        let item = table.given("friction_static");
        if friction_static > HIGHEST_USUAL_FRICTION {
            self.notices.push(Notice {
                place: self.sources.place(&item.span),
                key: table.path_of("friction_static"),
                message: format!(
                    "{friction_static} is more than the {HIGHEST_USUAL_FRICTION} that facings, rubber, steel and \
                     concrete have on each other (most have 0.1 to 1): hulls will lock rather than slide"
                ),
            });
        }
        Ok(Material {
            stiffness_npm2: *table.given("stiffness").number(),
            damping_nspm2: *table.given("damping").number(),
            shear_stiffness_npm: *table.given("shear_stiffness").number(),
            friction_static,
            friction_dynamic,
            restitution: *table.given("restitution").number(),
        })
    }

    fn bodies(&mut self, item: &Item, kinds: &vessel::Kinds) -> Checked<Vec<BodySetup>> {
        let bodies = item.named();
        if bodies.is_empty() {
            let error = self.sources.error(&item.span, "body", "the scenario has no bodies");
            return Err(error.with_help("write [body.NAME] with its keys below"));
        }
        bodies.iter().map(|(name, table)| self.body(name, table, kinds)).collect()
    }

    fn body(&mut self, name: &str, table: &Table, kinds: &vessel::Kinds) -> Checked<BodySetup> {
        let kind = table.item("vessel").map(|item| kinds.named(item));
        let outline = self.outline(table, kind)?;
        let mass = if *table.given("fixed").flag() {
            self.refuse_keys_of_floating_bodies(table)?;
            None
        } else if let Some(kind) = kind {
            self.refuse_keys_of_plain_bodies(table)?;
            Some(kind.mass)
        } else {
            self.refuse_keys_of_vessels(table)?;
            Some(self.mass(table)?)
        };
        Ok(BodySetup {
            name: name.to_owned(),
            outline,
            mass,
            position_m: *table.given("position").vector(),
            heading_rad: *table.given("heading").number(),
            velocity: table.item("velocity").map_or(BodyVelocity::default(), velocity),
        })
    }

    /// A body's own outline, or that of her vessel.
    fn outline(&mut self, table: &Table, kind: Option<&vessel::Kind>) -> Checked<Outline> {
        let path = table.path_of("outline");
        let own = table.item("outline");
        let (points, span) = match (own, kind.and_then(vessel::Kind::outline_m)) {
            (Some(item), _) => (item.outline().to_vec(), &item.span),
            (None, Some(points)) => (points, &table.given("vessel").span),
            (None, None) => {
                let error = self.sources.error(&table.span, &path, format!("`{path}` is missing"));
                return Err(error.with_help(match kind {
                    Some(_) => "her vessel has none: give it here",
                    None => "write outline = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]",
                }));
            }
        };
        let (outline, outline_notices) = Outline::new(&points)
            .map_err(|error| self.sources.error(span, &path, format!("`{path}`: {error}")))?;
        self.notices.extend(outline_notices.iter().map(|notice| Notice {
            place: self.sources.place(span),
            key: path.clone(),
            message: notice.to_string(),
        }));
        if let (Some(_), Some([length_m, beam_m])) = (own, kind.map(vessel::Kind::size_m)) {
            let (low, high) = outline.bounds();
            let size = high - low;
            // An outline may leave out a bulb or a flare, but is hardly of another ship.
            let fits = |of: f64, is: f64| (0.8..=1.25).contains(&(is / of));
            if !(fits(length_m, size.x) && fits(beam_m, size.y)) {
                let message = format!(
                    "it is {} m by {} m, but her vessel is {length_m} m by {beam_m} m",
                    size.x, size.y
                );
                let place = self.sources.place(span);
                self.notices.push(Notice { place, key: path, message });
            }
        }
        Ok(outline)
    }

    fn refuse_keys_of_floating_bodies(&self, table: &Table) -> Checked<()> {
        const FLOATING: [&str; 7] =
            ["vessel", "running", "mass", "gyradius", "yaw_inertia", "added_mass", "velocity"];
        match table.items.iter().find(|item| FLOATING.contains(&item.name)) {
            None => Ok(()),
            Some(item) => {
                let path = table.path_of(item.name);
                let message = format!("`{path}` is for floating bodies, but this one is fixed");
                let error = self.sources.error(&item.key_span, &path, message);
                Err(error.with_help(format!("remove `{}` or `fixed`", item.name)))
            }
        }
    }

    fn refuse_keys_of_vessels(&self, table: &Table) -> Checked<()> {
        let Some(item) = table.item("running") else { return Ok(()) };
        let path = table.path_of(item.name);
        let message = format!("`{path}` is for a body with a `vessel`");
        Err(self.sources.error(&item.key_span, &path, message))
    }

    fn refuse_keys_of_plain_bodies(&self, table: &Table) -> Checked<()> {
        const PLAIN: [&str; 4] = ["mass", "gyradius", "yaw_inertia", "added_mass"];
        match table.items.iter().find(|item| PLAIN.contains(&item.name)) {
            None => Ok(()),
            Some(item) => {
                let path = table.path_of(item.name);
                let message = format!("`{path}` is not for a vessel, whose model gives it");
                let error = self.sources.error(&item.key_span, &path, message);
                Err(error.with_help(format!("remove `{}` or `vessel`", item.name)))
            }
        }
    }

    fn mass(&self, table: &Table) -> Checked<MassProperties> {
        let missing = |name: &str, help: &str| {
            let path = table.path_of(name);
            let message = format!("`{path}` is missing");
            self.sources.error(&table.span, &path, message).with_help(help)
        };
        let mass_kg = *table
            .item("mass")
            .ok_or_else(|| missing("mass", "write mass = \"87800 t\", or fixed = true for a quay"))?
            .number();
        let yaw_inertia_kgm2 = match (table.item("gyradius"), table.item("yaw_inertia")) {
            (Some(gyradius), None) => mass_kg * gyradius.number() * gyradius.number(),
            (None, Some(inertia)) => *inertia.number(),
            (Some(_), Some(inertia)) => {
                let path = table.path_of("yaw_inertia");
                let message = format!("`{path}` and `gyradius` both give the yaw inertia");
                let error = self.sources.error(&inertia.key_span, &path, message);
                return Err(error.with_help("keep one of the two"));
            }
            (None, None) => {
                return Err(missing("gyradius", "write gyradius = \"74.5 m\", or yaw_inertia"));
            }
        };
        let added = |name: &str| {
            let fractions = table.item("added_mass").map(Item::table);
            fractions.map_or(0.0, |fractions| *fractions.given(name).number())
        };
        Ok(MassProperties {
            mass_kg,
            yaw_inertia_kgm2,
            added_surge_kg: added("surge") * mass_kg,
            added_sway_kg: added("sway") * mass_kg,
            added_yaw_kgm2: added("yaw") * yaw_inertia_kgm2,
        })
    }

    fn pairs(&self, pairs: &[Table], bodies: &[BodySetup], names: &Names) -> Checked<Pairs> {
        let mut read = Pairs::new(Vec::with_capacity(pairs.len()), None);
        for table in pairs {
            let item = table.given("bodies");
            let material_item = table.given("material");
            let two = item.two_names();
            if let [true, true] = two.each_ref().map(|name| name == "*") {
                let material = self.material_named(table, material_item, names)?;
                if read.every_other.replace(material).is_some() {
                    return Err(self.pair_error(table, item, "[\"*\", \"*\"] is given twice"));
                }
                continue;
            }
            let [one, other] = self.two_bodies(table, item, bodies, names)?;
            if !read.touching.insert(ordered([one, other])) {
                let message = format!(
                    "the pair of {} and {} is given twice",
                    quoted(&two[0]),
                    quoted(&two[1])
                );
                return Err(self.pair_error(table, item, &message));
            }
            let material = self.material_named(table, material_item, names)?;
            read.named.push(PairSetup { bodies: [one, other], material });
        }
        Ok(read)
    }

    fn two_bodies(
        &self,
        table: &Table,
        item: &Item,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<[usize; 2]> {
        let two = item.two_names();
        if two.iter().any(|name| name == "*") {
            let error = self.pair_error(table, item, "\"*\" stands for both bodies or for none");
            return Err(error.with_help("write [\"*\", \"*\"] for every pair not named otherwise"));
        }
        let [one, other] = two.each_ref().map(|name| self.body_named(table, item, name, names));
        let [one, other] = [one?, other?];
        if one == other {
            let message = format!("body {} cannot touch itself", quoted(&two[0]));
            return Err(self.pair_error(table, item, &message));
        }
        if bodies[one].mass.is_none() && bodies[other].mass.is_none() {
            let message = format!(
                "bodies {} and {} are both fixed: nothing could happen between them",
                quoted(&two[0]),
                quoted(&two[1])
            );
            return Err(self.pair_error(table, item, &message));
        }
        Ok([one, other])
    }

    fn pair_error(&self, table: &Table, item: &Item, message: &str) -> ScenarioError {
        let path = table.path_of(item.name);
        self.sources.error(&item.span, &path, format!("`{path}`: {message}"))
    }

    fn loads(&self, loads: &[Table], bodies: &[BodySetup], names: &Names) -> Checked<Vec<Load>> {
        loads.iter().map(|table| self.load(table, bodies, names)).collect()
    }

    fn load(&self, table: &Table, bodies: &[BodySetup], names: &Names) -> Checked<Load> {
        let body_item = table.given("body");
        let body = self.body_named(table, body_item, body_item.name(), names)?;
        if bodies[body].mass.is_none() {
            let path = table.path_of("body");
            let message =
                format!("`{path}`: body {} is fixed, no load moves it", quoted(body_item.name()));
            return Err(self.sources.error(&body_item.span, &path, message));
        }
        let (force, moment) = (table.item("force"), table.item("moment"));
        if force.is_none() && moment.is_none() {
            let path = table.path_of("force");
            let message = format!("`{path}` is missing, and so is `moment`");
            let error = self.sources.error(&table.span, &path, message);
            return Err(error.with_help("write force = [\"0 kN\", \"-500 kN\"]"));
        }
        let from_s = *table.given("from").number();
        let until = table.item("until");
        let until_s = until.map_or(f64::INFINITY, |item| *item.number());
        if let Some(item) = until.filter(|_| until_s <= from_s) {
            let path = table.path_of("until");
            let message = format!(
                "`{path}` must be later than `from`, which is {from_s} s, but is {until_s} s"
            );
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(Load {
            body,
            force_n: force.map_or(Vec2::ZERO, |item| *item.vector()),
            moment_nm: moment.map_or(0.0, |item| *item.number()),
            from_s,
            until_s,
        })
    }

    fn body_named(&self, table: &Table, item: &Item, name: &str, names: &Names) -> Checked<usize> {
        self.reference("body", "bodies", &names.bodies, table, item, name)
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

    /// Bodies that touch nothing, and materials that nothing uses; one notice where there is no pair at all.
    fn note_unused(
        &mut self,
        file: &Table,
        bodies: &[BodySetup],
        pairs: &Pairs,
        fenders: &[FenderSetup],
    ) {
        if pairs.named.is_empty() && pairs.every_other.is_none() && bodies.len() > 1 {
            self.notices.push(Notice {
                place: self.sources.place(&file.given("body").span),
                key: "pair".to_owned(),
                message: "the scenario has none: nothing can touch".to_owned(),
            });
            return;
        }
        let mut used_materials: BTreeSet<usize> =
            pairs.named.iter().map(|pair| pair.material).collect();
        used_materials.extend(pairs.every_other);
        used_materials.extend(fenders.iter().map(|fender| fender.material));
        for (index, (_, table)) in file.given("material").named().iter().enumerate() {
            if !used_materials.contains(&index) {
                self.note(table, "no pair or fender uses this material");
            }
        }
        if pairs.every_other.is_some() {
            return;
        }
        let paired: BTreeSet<usize> = pairs.named.iter().flat_map(|pair| pair.bodies).collect();
        for (index, (_, table)) in file.given("body").named().iter().enumerate() {
            if !paired.contains(&index) && bodies.len() > 1 {
                self.note(table, "no pair names this body: it touches nothing");
            }
        }
        for (fender, (_, table)) in fenders.iter().zip(file.given("fender").named()) {
            if !paired.contains(&fender.body) {
                self.note(
                    table,
                    "no pair names the body that carries this fender: nothing touches it",
                );
            }
        }
    }

    fn note(&mut self, table: &Table, message: &str) {
        self.notices.push(Notice {
            place: self.sources.place(&table.span),
            key: table.path.clone(),
            message: message.to_owned(),
        });
    }
}

fn velocity(item: &Item) -> BodyVelocity {
    let table = item.table();
    BodyVelocity {
        surge_mps: *table.given("surge").number(),
        sway_mps: *table.given("sway").number(),
        yaw_radps: *table.given("yaw").number(),
    }
}

/// The first few names, in quotes.
fn listed<'n>(names: impl Iterator<Item = &'n str> + Clone) -> String {
    const SHOWN: usize = 8;
    let left_out = names.clone().count().saturating_sub(SHOWN);
    let shown = names.take(SHOWN).map(quoted).collect::<Vec<_>>().join(", ");
    if left_out == 0 { shown } else { format!("{shown} and {left_out} more") }
}
