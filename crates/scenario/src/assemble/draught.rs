//! Warnings about ships that float in too little water, or whose sides end below a fender.

use fenderline_sim::{BodySetup, FenderSetup, Setup};

use super::assembly::Assembly;
use super::plausible::FAR_FROM_WATER_M;
use super::rows::rounded;
use fenderline_keys::checked::{Of, Tables};
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::environment::EnvironmentKey;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::sources::quoted;

/// Height of a fender's lower edge above the water up to which the fender meets most ships (m). Our choice.
const LOW_M: f64 = 3.0;
/// Largest height of a ship's side above the water, as a share of her draught, for which there is no warning; loaded
/// tankers and bulk carriers have 0.4 to 0.6. Our choice.
const SIDE_OVER_DRAUGHT: f64 = 0.6;
/// The draught of a floating body, and the source of the draught.
struct Draught {
    at_least_m: f64,
    from: &'static str,
    /// True if outlines at several heights say where the body's side is.
    has_outlines: bool,
}

impl Assembly<'_, '_> {
    /// Warns of ships that draw more than the depth of the water, and of fenders above the usual height of the side of
    /// a ship with this draught.
    pub(super) fn note_draughts(
        &mut self,
        file: Of<'_, ScenarioKey>,
        fenders: Tables<'_, FenderKey>,
        setup: &Setup,
    ) {
        let draughts = draughts(setup);
        for (body, draught) in draughts.iter().enumerate() {
            if let Some(draught) = draught {
                self.note_little_water(file, setup, body, draught);
            }
        }
        self.note_high_faces(fenders, setup, &draughts);
    }

    fn note_little_water(
        &mut self,
        file: Of<'_, ScenarioKey>,
        setup: &Setup,
        body: usize,
        draught: &Draught,
    ) {
        // Over a bottom by place a run sounds the depth under each vessel.
        if setup.world.environment.bottom.is_some() {
            return;
        }
        let Some([least_m, _]) = setup.world.environment.depth_range_m() else { return };
        if least_m >= draught.at_least_m {
            return;
        }
        let environment = file.given(ScenarioKey::ENVIRONMENT).table();
        let item = environment.given(EnvironmentKey::DEPTH);
        let message = format!(
            "there are {} m of water at the lowest level, but {} draws {} m{}: more than that was \
             expected",
            rounded(least_m),
            quoted(&setup.bodies[body].name),
            rounded(draught.at_least_m),
            draught.from
        );
        self.note_at(&item.span, environment.path_of(EnvironmentKey::DEPTH), message);
    }

    fn note_high_faces(
        &mut self,
        tables: Tables<'_, FenderKey>,
        setup: &Setup,
        draughts: &[Option<Draught>],
    ) {
        let [_, highest_m] = setup.world.environment.level_range_m();
        let lower_m = |fender: &FenderSetup| {
            fender.above_water_m - level_m(setup, fender, highest_m) - 0.5 * fender.height_m
        };
        // The few high fenders first, and bodies by lists, because fenders, bodies and pairs may be very many.
        let partners = partners(setup);
        let floating: Vec<usize> =
            (0..setup.bodies.len()).filter(|body| !setup.bodies[*body].is_fixed()).collect();
        let high = tables.iter().zip(&setup.fenders).filter(|(_, fender)| {
            lower_m(fender) > LOW_M && fender.above_water_m <= FAR_FROM_WATER_M
        });
        for ((_, table), fender) in high {
            let Some(item) = table.item_if_any(FenderKey::ABOVE_WATER) else { continue };
            let lower_m = lower_m(fender);
            let met = match setup.all_other_pairs {
                Some(_) => &floating,
                None => &partners[fender.body],
            };
            for &body in met.iter().filter(|body| **body != fender.body) {
                let draught = draughts[body].as_ref().filter(|own| !own.has_outlines);
                let Some(draught) = draught else { continue };
                if lower_m <= SIDE_OVER_DRAUGHT * draught.at_least_m {
                    continue;
                }
                let message = format!(
                    "the face is {} to {} m above the water, and {} draws {} m{}: check that the \
                     ship's side is so high, or give `outlines`, which show where the side is",
                    rounded(lower_m),
                    rounded(lower_m + fender.height_m),
                    quoted(&setup.bodies[body].name),
                    rounded(draught.at_least_m),
                    draught.from
                );
                self.note_at(&item.span, table.path_to(item), message);
            }
        }
    }
}

/// The level of the water above the point from which a fender's height is measured (m).
fn level_m(setup: &Setup, fender: &FenderSetup, level_m: f64) -> f64 {
    let rides = fender.floating || !setup.bodies[fender.body].is_fixed();
    if rides { 0.0 } else { level_m }
}

/// For each body, the floating bodies that it may touch according to the named pairs.
fn partners(setup: &Setup) -> Vec<Vec<usize>> {
    let mut partners = vec![Vec::new(); setup.bodies.len()];
    for pair in &setup.pairs {
        let [one, other] = pair.bodies;
        for (own, other) in [(one, other), (other, one)] {
            if !setup.bodies[other].is_fixed() {
                partners[own].push(other);
            }
        }
    }
    partners
}

/// Draught of each body; `None` for a fixed body.
fn draughts(setup: &Setup) -> Vec<Option<Draught>> {
    let water_kgpm3 = setup.world.environment.water_density_kgpm3;
    // The volume of a hull is less than outline times draught.
    let least_m = |body: &BodySetup| {
        let mass_kg = body.mass?.mass_kg;
        Some(mass_kg / (water_kgpm3 * body.outline.area_m2()))
    };
    let of_body = |body: &BodySetup| {
        let has_outlines = body.hull.is_some();
        let (at_least_m, from) = match &body.hull {
            Some(hull) => (hull.draught_m(), ""),
            None => (
                least_m(body)?,
                " or more, which follows from her mass and the area of her outline",
            ),
        };
        body.mass.map(|_| Draught { at_least_m, from, has_outlines })
    };
    let mut all: Vec<Option<Draught>> = setup.bodies.iter().map(of_body).collect();
    let of_study = setup.berthing.iter().map(|study| (study.ship, study.draught_m));
    let vessels = setup.world.vessels.iter();
    let of_vessels = vessels.map(|vessel| (vessel.body, vessel.ship.particulars.draught_m));
    for (body, draught_m) in of_study.chain(of_vessels) {
        if let Some(own) = all[body].as_mut().filter(|own| !own.has_outlines) {
            (own.at_least_m, own.from) = (draught_m, "");
        }
    }
    all
}
