//! Reads passing ships, and the flow between vessels.

use fenderline_contact::number::bounded;
use fenderline_contact::{Outline, Pose, Vec2, vec2};
use fenderline_sim::environment::{Bank, BankMethod};
use fenderline_sim::hydro::critical_mps;
use fenderline_sim::passing::{
    Berth, DepthFactors, FlowHull, FlowSetup, HARDLY_SLENDER, NEARLY_CRITICAL, PassingSetup,
};
use fenderline_sim::track::{Pace, Path, Track};
use fenderline_sim::{BodySetup, Environment, Setup, VesselSetup, shallowest_on_track_m};

use super::assembly::{Assembly, Checked};
use super::rows::rounded;
use super::vessel::Kinds;
use crate::vessels::{VesselData, VesselLibrary};
use fenderline_keys::any_keys;
use fenderline_keys::checked::Of;
use fenderline_keys::held::Number;
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::environment::EnvironmentKey;
use fenderline_keys::keys::passing::{InteractionKey, PassingKey, SectionsBy, SectionsKey};
use fenderline_keys::sources::quoted;
use fenderline_keys::typed_key::Key;

/// Clear distance at the start, as a share of the passing ship's length, within which her force begins suddenly; our
/// choice.
const SUDDEN: f64 = 1.0;
/// Angle between a track and a vessel from which a warning says that the factors are for parallel passing (rad); our
/// choice.
const ASKEW_RAD: f64 = 0.35;

impl Assembly<'_, '_> {
    /// Reads the flow between ships: the passing ships, and the hulls of the vessels if passing ships,
    /// `between_vessels` or banks need these hulls.
    pub(super) fn flow(
        &mut self,
        file: Of<'_, ScenarioKey>,
        library: &VesselLibrary,
        (kinds, vessels, bodies): (&Kinds, &[VesselSetup], &[BodySetup]),
        environment: &Environment,
    ) -> Checked<FlowSetup> {
        let passing = file.given(ScenarioKey::PASSING).named();
        let interaction =
            file.given(ScenarioKey::ENVIRONMENT).table().given(EnvironmentKey::INTERACTION).table();
        let between_vessels = *interaction.given(InteractionKey::BETWEEN_VESSELS).flag();
        let by_image = |bank: &&Bank| bank.method() == BankMethod::Image;
        let images = environment.banks.iter().filter(by_image).count();
        let of_bottom = environment.bottom.as_ref().and_then(|bottom| bottom.banks);
        let by_bottom = of_bottom == Some(BankMethod::Image);
        if passing.is_empty() && !between_vessels && images == 0 && !by_bottom {
            return Ok(FlowSetup::default());
        }
        if let (Some((_, table)), true) = (passing.iter().next(), vessels.is_empty()) {
            let message = format!(
                "`{}`: passing ships act on vessels, and no body has a `vessel`",
                table.path
            );
            let error = self.sources.error(&table.span, &table.path, message);
            return Err(error.with_help("give the moored ship a `vessel`"));
        }
        let hulls = vessels.iter().map(|vessel| {
            let ship = &vessel.ship.particulars;
            let ahead = vec2(ship.centre_of_gravity_m, 0.0);
            let outline = bodies[vessel.body].outline.vertices().iter();
            let outline: Vec<Vec2> = outline.map(|point| *point + ahead).collect();
            let size_m = [ship.length_m, ship.beam_m, ship.draught_m];
            self.flow_hull(interaction.read_as(), size_m, &outline)
        });
        let hulls = hulls.collect::<Checked<Vec<FlowHull>>>()?;
        if between_vessels {
            self.note_between_vessels(interaction, &hulls, (vessels, bodies), environment);
        }
        if images > 0 || by_bottom {
            let surroundings = file.given(ScenarioKey::ENVIRONMENT).table();
            let banks = surroundings.given(EnvironmentKey::BANK).list();
            let first = banks.iter().zip(&environment.banks).find(|(_, bank)| by_image(bank));
            let of_bottom =
                surroundings.item(EnvironmentKey::BOTTOM).map(|item| item.table().any());
            let place = first.map(|(bank, _)| bank.any()).or(of_bottom);
            self.note_images(
                place.unwrap_or(interaction.any()),
                if by_bottom { images + 2 } else { images },
                &hulls,
                (vessels, bodies),
            );
        }
        let passing =
            passing.iter().map(|(name, table)| self.passing_ship(name, table, (library, kinds)));
        Ok(FlowSetup { passing: passing.collect::<Checked<_>>()?, hulls, between_vessels })
    }

    /// The sectional areas of a hull, from its outline or from its midship coefficient alone, as the table `table`
    /// says.
    fn flow_hull(
        &self,
        table: Of<'_, SectionsKey>,
        size_m: [f64; 3],
        outline_m: &[Vec2],
    ) -> Checked<FlowHull> {
        let coefficient = *table.given(SectionsKey::MIDSHIP_COEFFICIENT).number();
        let by_outline = table.given(SectionsKey::SECTIONS).choice() == SectionsBy::Outline;
        FlowHull::new(size_m, coefficient, by_outline.then_some(outline_m))
            .map_err(|error| self.wrong(table, &error))
    }

    fn note_between_vessels<T>(
        &mut self,
        table: Of<'_, T>,
        hulls: &[FlowHull],
        (vessels, bodies): (&[VesselSetup], &[BodySetup]),
        environment: &Environment,
    ) {
        let mut message = String::from(
            "the flow between vessels is for slender ships in deep water, without lift; for \
             vessels nearer to each other than a quarter of their mean beam the force is left out",
        );
        if !environment.is_deep() {
            message += ", and the depth is not taken into account";
        }
        message += &none_for_short(hulls, (vessels, bodies));
        self.note(table, &message);
    }

    /// Adds a warning that says what the flow of images behind banks leaves out.
    fn note_images<T>(
        &mut self,
        table: Of<'_, T>,
        images: usize,
        hulls: &[FlowHull],
        ships: (&[VesselSetup], &[BodySetup]),
    ) {
        let mut message = String::from(
            "the pull of a bank by the image of the ship is for slender ships, without waves and \
             lift: the pull is 12 to 63 % less than by a panel method, has no moment that turns \
             the bow away, and was not compared with measurements; nearer to the bank than an \
             eighth of the beam and at more than 30 degrees to the bank the pull is left out",
        );
        if images > 1 {
            message += "; between two banks the images of the images are left out";
        }
        message += &none_for_short(hulls, ships);
        self.note(table, &message);
    }

    fn passing_ship(
        &self,
        name: &str,
        table: Of<'_, PassingKey>,
        (library, kinds): (&VesselLibrary, &Kinds),
    ) -> Checked<PassingSetup> {
        let data = match table.item(PassingKey::VESSEL) {
            None => None,
            Some(item) => {
                self.none_of(table, any_keys![PassingKey: LENGTH, BEAM, DRAUGHT], "vessel")?;
                let known = kinds.data(item.text());
                Some(match known.or_else(|| library.vessel(item.text()).ok()) {
                    Some(data) => data,
                    None => {
                        let known = library.vessels().iter().map(|known| known.name.as_str());
                        return Err(self.unknown("vessel", table, item, item.text(), known));
                    }
                })
            }
        };
        let size_m = match data {
            Some(data) => {
                let ship = &data.ship.particulars;
                [ship.length_m, ship.beam_m, ship.draught_m]
            }
            None => {
                let help = "a passing ship needs a `vessel`, or `length`, `beam` and `draught`";
                self.all_of(table, any_keys![PassingKey: LENGTH, BEAM, DRAUGHT], help)?;
                [PassingKey::LENGTH, PassingKey::BEAM, PassingKey::DRAUGHT]
                    .map(|key: Key<_, Number>| *table.given(key).number())
            }
        };
        let outline_m = self.outline_of(table, data, size_m)?;
        let hull = self.flow_hull(table.read_as(), size_m, &outline_m)?;
        let track = self.track(table, size_m[0])?;
        let depth = table.given(PassingKey::DEPTH_FACTORS).choice();
        let berth = table.given(PassingKey::BERTH).choice();
        Ok(PassingSetup { name: name.to_owned(), hull, outline_m, track, depth, berth })
    }

    /// Outline of a passing ship relative to midship, from her table or from her vessel, or else a rectangle.
    fn outline_of(
        &self,
        table: Of<'_, PassingKey>,
        data: Option<&VesselData>,
        [length_m, beam_m, _]: [f64; 3],
    ) -> Checked<Vec<Vec2>> {
        let own = table.item(PassingKey::OUTLINE);
        let known = data.and_then(|data| data.outline_m.as_ref());
        let Some(item) = own else {
            let (l, b) = (0.5 * length_m, 0.5 * beam_m);
            let box_m = || vec![vec2(-l, -b), vec2(l, -b), vec2(l, b), vec2(-l, b)];
            return Ok(known.map_or_else(box_m, Vec::clone));
        };
        let outline = Outline::new(item.outline());
        let (outline, _) = outline.map_err(|error| self.refused(table, item, &error))?;
        Ok(outline.vertices().to_vec())
    }

    fn track(&self, table: Of<'_, PassingKey>, length_m: f64) -> Checked<Track> {
        let path = match table.item(PassingKey::WAYPOINTS) {
            Some(item) => {
                self.none_of(table, any_keys![PassingKey: POSITION, HEADING], "waypoints")?;
                let radius_m =
                    table.item(PassingKey::TURNING_RADIUS).map(|radius| *radius.number());
                let path = Path::through(item.outline(), radius_m.unwrap_or(3.0 * length_m));
                path.map_err(|error| self.refused(table, item, &error))?
            }
            None => {
                self.none_of(table, any_keys![PassingKey: TURNING_RADIUS], "a straight track")?;
                let help = "a track needs a `position` and a `heading`, or `waypoints`";
                self.all_of(table, any_keys![PassingKey: POSITION, HEADING], help)?;
                let heading = table.given(PassingKey::HEADING);
                let path =
                    Path::straight(*table.given(PassingKey::POSITION).vector(), *heading.number());
                path.map_err(|error| self.refused(table, heading, &error))?
            }
        };
        let at_s = *table.given(PassingKey::TIME).number();
        let pace = match table.item(PassingKey::SPEEDS) {
            Some(item) => {
                self.none_of(table, any_keys![PassingKey: SPEED], "speeds")?;
                Pace::by_time(item.curve(), at_s)
                    .map_err(|error| self.refused(table, item, &error))?
            }
            None => {
                self.all_of(
                    table,
                    any_keys![PassingKey: SPEED],
                    "a passing ship needs a `speed`, or `speeds` by time",
                )?;
                let item = table.given(PassingKey::SPEED);
                Pace::steady(*item.number(), at_s)
                    .map_err(|error| self.refused(table, item, &error))?
            }
        };
        Ok(Track { path, pace })
    }

    /// Refuses passing ships that would go through a body or faster than long waves, and warns of what the forces of
    /// passing ships leave out.
    pub(super) fn check_passing(
        &mut self,
        file: Of<'_, ScenarioKey>,
        setup: &Setup,
    ) -> Checked<()> {
        let tables = file.given(ScenarioKey::PASSING).named();
        for ((_, table), ship) in tables.iter().zip(&setup.world.flow.passing) {
            self.check_passing_track(table, ship, setup)?;
            let fastest_mps = ship.track.pace.fastest_mps();
            let environment = &setup.world.environment;
            let shallowest_m = shallowest_on_track_m(ship, environment, setup.duration_s);
            if let Some(shallowest_m) = shallowest_m {
                self.check_depth(table, ship, shallowest_m, fastest_mps)?;
            }
            self.note_formulas(table, ship, setup);
            if ship.hull.length_m < HARDLY_SLENDER * ship.hull.beam_m {
                let message = format!(
                    "the passing ship is {} beams long: the flow is for slender ships, and is less \
                     accurate for a ship of this form",
                    rounded(ship.hull.length_m / ship.hull.beam_m)
                );
                self.note(table, &message);
            }
            let most_s = 0.05 * ship.hull.length_m / fastest_mps;
            if setup.step_s > most_s {
                let message = format!(
                    "in a step of {} s the passing ship moves by more than a twentieth of her \
                     length: peaks of the force may be missed; take steps of {} s or less",
                    rounded(setup.step_s),
                    rounded(most_s)
                );
                self.note(table, &message);
            }
        }
        Ok(())
    }

    /// Checks the track of a passing ship past the bodies that do not move at the start.
    fn check_passing_track<T>(
        &mut self,
        table: Of<'_, T>,
        ship: &PassingSetup,
        setup: &Setup,
    ) -> Checked<()> {
        let mut nearest_vessel: Option<(usize, f64, f64)> = None;
        for (index, body) in setup.bodies.iter().enumerate() {
            let velocity = &body.velocity;
            let at_rest = [velocity.surge_mps, velocity.sway_mps, velocity.yaw_radps] == [0.0; 3];
            // The shore is too large for a test by its corners.
            if !(body.is_fixed() || at_rest) || body.outline.is_of_parts() {
                continue;
            }
            let pose = Pose::new(body.position_m, body.heading_rad);
            let nearest = ship.nearest(body.outline.vertices(), pose, setup.duration_s);
            if nearest.distance_m <= 0.0 {
                let message = format!(
                    "`{}`: the passing ship would go through {} at {:.0} s",
                    table.path,
                    quoted(&body.name),
                    nearest.t_s
                );
                let error = self.sources.error(&table.span, &table.path, message);
                return Err(error.with_help("move the track away, until there is a clear gap"));
            }
            if setup.world.vessels.iter().any(|vessel| vessel.body == index)
                && nearest_vessel.is_none_or(|(_, distance_m, _)| nearest.distance_m < distance_m)
            {
                nearest_vessel = Some((index, nearest.distance_m, nearest.t_s));
            }
        }
        let Some((body, distance_m, t_s)) = nearest_vessel else { return Ok(()) };
        let body = &setup.bodies[body];
        if t_s >= setup.duration_s && ship.track.pace.speed_mps(t_s) > 0.0 {
            let message = format!(
                "the run ends before the ship has passed {}: she is still coming nearer, {} m away",
                quoted(&body.name),
                rounded(distance_m)
            );
            self.note(table, &message);
        }
        let start = ship.track.at(0.0);
        let pose = Pose::new(body.position_m, body.heading_rad);
        let at_start_m = ship.nearest(body.outline.vertices(), pose, 0.0).distance_m;
        if at_start_m < SUDDEN * ship.hull.length_m && start.speed_mps > 0.0 {
            let message = format!(
                "the passing ship is {} m from {} at the start, so the force begins suddenly: let \
                 the ship come from farther away",
                rounded(at_start_m),
                quoted(&body.name)
            );
            self.note(table, &message);
        }
        if ship.depth == DepthFactors::Kriebel || ship.berth == Berth::Quay {
            let turned = ship.track.at(t_s).heading_rad - body.heading_rad;
            let askew_rad = libm::asin(bounded(libm::sin(turned), -1.0, 1.0)).abs();
            if askew_rad > ASKEW_RAD {
                let message = format!(
                    "the ship passes {} at an angle of {:.0} degrees, but the factors for depth \
                     and quay are for parallel passing",
                    quoted(&body.name),
                    askew_rad.to_degrees()
                );
                self.note(table, &message);
            }
        }
        Ok(())
    }

    fn check_depth(
        &mut self,
        table: Of<'_, PassingKey>,
        ship: &PassingSetup,
        shallowest_m: f64,
        fastest_mps: f64,
    ) -> Checked<()> {
        let item = table.first_of(any_keys![PassingKey: SPEEDS, SPEED]);
        let item = item.unwrap_or_else(|| unreachable!("the speed was read"));
        let draught_m = ship.hull.draught_m;
        if draught_m >= shallowest_m {
            let message = format!(
                "`{}`: the passing ship draws {} m, but the water is {} m deep at the lowest level",
                table.path,
                rounded(draught_m),
                rounded(shallowest_m)
            );
            return Err(self.sources.error(&table.span, &table.path, message));
        }
        let critical_mps = critical_mps(shallowest_m);
        let share = fastest_mps / critical_mps;
        if share >= 1.0 {
            let message = format!(
                "{} m/s is faster than long waves in {} m of water, {} m/s: no ship passes at that \
                 speed, and the flow has no waves",
                rounded(fastest_mps),
                rounded(shallowest_m),
                rounded(critical_mps)
            );
            return Err(self.refused(table, item, &message));
        }
        if share > NEARLY_CRITICAL {
            let message = format!(
                "the passing ship goes at {share:.2} of the speed of long waves in {} m of water: \
                 the computed flow has no waves, and the forces are too small",
                rounded(shallowest_m)
            );
            self.note_at(&item.span, table.path_to(item), message);
        }
        Ok(())
    }

    /// Adds a warning that says which factors on the forces of a passing ship are from memory or estimated, and which
    /// are missing.
    fn note_formulas<T>(&mut self, table: Of<'_, T>, ship: &PassingSetup, setup: &Setup) {
        let is_deep = setup.world.environment.is_deep();
        let mut parts = Vec::new();
        match ship.depth {
            DepthFactors::Kriebel if is_deep => {
                parts.push("the water is deep, so there are no factors for the depth");
            }
            DepthFactors::Kriebel => parts.push(
                "the factors for the depth are from memory (Kriebel 2005, which we could not \
                 read), and were compared with one worked case",
            ),
            DepthFactors::DeepWater if !is_deep => parts.push(
                "the depth is not taken into account; in model tests in shallow water the forces \
                 were several times as large",
            ),
            DepthFactors::DeepWater => {}
        }
        if ship.berth == Berth::Quay {
            parts.push("the factors for a quay are estimated (from figures of Swiegers 2011)");
        }
        if !parts.is_empty() {
            self.note(table, &parts.join("; "));
        }
    }
}

/// The part of a warning about vessels that are too short for the flow of slender ships; empty if there are no such
/// vessels.
fn none_for_short(hulls: &[FlowHull], (vessels, bodies): (&[VesselSetup], &[BodySetup])) -> String {
    let short = hulls.iter().zip(vessels).filter(|(hull, _)| !hull.is_slender());
    let short: Vec<String> = short.map(|(_, vessel)| quoted(&bodies[vessel.body].name)).collect();
    if short.is_empty() {
        return String::new();
    }
    format!("; there is no such force for {}, shorter than 3.5 beams", short.join(", "))
}
