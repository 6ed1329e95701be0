//! Keeps the contacts and events of the last step for frames. The simulation itself does not keep contacts and events.

use fenderline_contact::{BodyId, Event, EventKind, Friction, Vec2};
use fenderline_sim::hydro::Force;
use fenderline_sim::{Job, Setup, Simulation, StepRecord, WorldEvent, WorldEventKind, called};

use super::passage::Passages;
use crate::info::Info;
use crate::message::{ContactNow, FenderNow};
use crate::pair::pair;

/// The contacts and events of the last step.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Seen {
    contacts: Vec<ContactNow>,
    /// Energy stored in each fender (J).
    stored_j: Vec<f64>,
    contact_events: Vec<Event>,
    world_events: Vec<WorldEvent>,
    /// The force on each vessel by the flow around passing ships.
    flow: Vec<Force>,
    /// Ships that pass vessels at rest.
    passages: Passages,
    /// Tugs that have touched the ship at the place where they are ordered to lie or to push.
    alongside: Vec<Ordered>,
}

/// An order to a tug to lie at a ship's side or to push there.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ordered {
    /// The tug and the ship.
    bodies: [usize; 2],
    /// The place, in the ship's frame (m).
    at_m: Vec2,
}

impl Ordered {
    fn is_of(&self, [one, two]: [usize; 2]) -> bool {
        [[one, two], [two, one]].contains(&self.bodies)
    }
}

impl Seen {
    pub(crate) fn before_the_first_step(simulation: &Simulation) -> Seen {
        Seen { stored_j: vec![0.0; simulation.setup().fenders.len()], ..Seen::default() }
    }

    /// Keeps the contacts and events of one step of the simulation.
    pub(crate) fn keep(&mut self, record: &StepRecord<'_>) {
        self.contacts.clear();
        self.stored_j.fill(0.0);
        for contact in record.contacts {
            let fender = contact.fender.map(|id| id.0 as usize);
            if let Some(fender) = fender {
                self.stored_j[fender] += contact.energy.stored_j;
            }
            self.contacts.push(ContactNow {
                bodies: [contact.body_1.0 as usize, contact.body_2.0 as usize],
                fender,
                at_m: pair(contact.point_m),
                force_n: pair(contact.force_on_body_1_n()),
                slips: contact.friction == Friction::Slip,
            });
        }
        self.contact_events.clear();
        self.contact_events.extend_from_slice(record.events);
        self.world_events.clear();
        self.world_events.extend_from_slice(record.world_events);
        self.flow.clear();
        self.flow.extend(record.vessel_forces.iter().map(|forces| forces.passing));
    }

    /// Notes the ships that pass vessels at rest, and why lines parted in the step that was kept.
    pub(crate) fn note_passages(&mut self, simulation: &Simulation, info: &Info) {
        self.passages.note(simulation, info, &self.flow, &self.world_events);
    }

    /// A tug at the side of a ship loses the contact and has it again many times. The first touch at the ordered place is
    /// an event. The others are not, until the tug has another order: then her leaving is an event.
    pub(crate) fn note_tugs(&mut self, simulation: &Simulation) {
        let vessels = simulation.setup().world.vessels.iter().zip(simulation.vessels());
        let ordered: Vec<Ordered> = vessels
            .filter_map(|(of, vessel)| match vessel.pilots.assist.as_ref()?.order.job {
                Job::Push(push) => Some(Ordered { bodies: [of.body, push.ship], at_m: push.at_m }),
                Job::Follow { .. } | Job::Pull { .. } => None,
            })
            .collect();
        self.keep_first_touches(&ordered);
    }

    fn keep_first_touches(&mut self, ordered: &[Ordered]) {
        let Seen { alongside, contact_events, contacts, .. } = self;
        let touches = |of: &Ordered| contacts.iter().any(|contact| of.is_of(contact.bodies));
        alongside.retain(|of| {
            let stays = ordered.contains(of);
            let ends = |event: &Event| {
                event.kind == EventKind::ContactEnded
                    && of.is_of(event.bodies.map(|body| body.0 as usize))
            };
            // The contact ended while the old order stood, and this was not an event then.
            if !stays && !touches(of) && !contact_events.iter().any(ends) {
                let [one, two] = of.bodies.map(|body| BodyId(body as u32));
                let bodies = if one < two { [one, two] } else { [two, one] };
                contact_events.push(Event { bodies, kind: EventKind::ContactEnded });
            }
            stays
        });
        let mut came = Vec::new();
        contact_events.retain(|event| {
            let bodies = event.bodies.map(|body| body.0 as usize);
            let Some(of) = ordered.iter().find(|of| of.is_of(bodies)) else { return true };
            match event.kind {
                EventKind::ContactBegan => {
                    came.push(*of);
                    !alongside.contains(of)
                }
                EventKind::ContactEnded => !alongside.contains(of),
                _ => true,
            }
        });
        for of in came {
            if !alongside.contains(&of) {
                alongside.push(of);
            }
        }
    }

    /// Whether the tug has touched the ship at the place of her present order; `bodies`: the tug and the ship.
    pub(crate) fn has_touched(&self, bodies: [usize; 2]) -> bool {
        self.alongside.iter().any(|of| of.bodies == bodies)
    }

    pub(crate) fn passages(&self) -> &Passages {
        &self.passages
    }

    pub(crate) fn contacts(&self) -> &[ContactNow] {
        &self.contacts
    }

    /// The present state of all fenders.
    pub(crate) fn fenders(&self, simulation: &Simulation) -> Vec<FenderNow> {
        let setup = simulation.setup();
        let mut all = vec![FenderNow::default(); setup.fenders.len()];
        for touched in simulation.fender_summaries() {
            let rated = setup.fenders[touched.fender].rated;
            let energy_j = self.stored_j[touched.fender];
            let reaction_n = touched.last_reaction_n;
            let share = |of: Option<f64>, value: f64| of.map_or(0.0, |most| value / most);
            all[touched.fender] = FenderNow {
                deflection_m: touched.last_deflection_m,
                reaction_n,
                energy_j,
                of_energy: share(touched.capacity_j, energy_j),
                of_reaction: share(
                    rated.map(|r| r.largest_reaction_n * touched.factor),
                    reaction_n,
                ),
                peak_of_energy: touched.share_of_rated_energy.unwrap_or(0.0),
                peak_of_reaction: touched.share_of_largest_reaction.unwrap_or(0.0),
                failed: touched.failed,
                over_rated: touched.share_of_rated_energy.is_some_and(|share| share > 1.0)
                    || touched.share_of_largest_reaction.is_some_and(|share| share > 1.0),
                touched: true,
            };
        }
        all
    }

    /// The texts of the last step's events. If a pair of bodies has several contacts in one step, the text appears
    /// once.
    pub(crate) fn events(&self, setup: &Setup) -> impl Iterator<Item = String> {
        let mut contact: Vec<String> = Vec::new();
        for event in &self.contact_events {
            if let Some(text) = contact_text(event, setup, &self.contacts)
                && !contact.contains(&text)
            {
                contact.push(text);
            }
        }
        let world = self.world_events.iter().map(|event| match event.kind {
            WorldEventKind::LineParted => {
                world_text(event, setup) + self.passages.why_parted(event.who)
            }
            _ => world_text(event, setup),
        });
        contact.into_iter().chain(world).chain(self.passages.ended().iter().cloned())
    }
}

fn contact_text(event: &Event, setup: &Setup, contacts: &[ContactNow]) -> Option<String> {
    let bodies = event.bodies.map(|body| body.0 as usize);
    let [one, two] = bodies.map(|body| &*setup.bodies[body].name);
    let at_fenders = || -> String {
        let between = contacts.iter().filter(|contact| contact.bodies == bodies);
        let names = between.filter_map(|contact| contact.fender);
        let names: Vec<&str> = names.map(|fender| &*setup.fenders[fender].name).collect();
        if names.is_empty() { String::new() } else { format!(" at {}", names.join(", ")) }
    };
    Some(match event.kind {
        EventKind::ContactBegan => format!("{one} touches {two}{}", at_fenders()),
        EventKind::ContactEnded => format!("{one} leaves {two}"),
        EventKind::PatchSplit | EventKind::PatchesMerged => return None,
        EventKind::Contained => format!("{one} lies wholly inside {two}"),
        EventKind::DeepOverlap => {
            format!("{one} and {two} overlap so deeply that the forces are unreliable")
        }
        EventKind::Teleported => format!("{one} was teleported"),
        EventKind::FenderRatingExceeded(fender) => {
            format!(
                "{} is over its rating",
                called("fender", &setup.fenders[fender.0 as usize].name)
            )
        }
        EventKind::FenderFailed(fender) => {
            format!("{} HAS FAILED", called("FENDER", &setup.fenders[fender.0 as usize].name))
        }
        EventKind::PlacedInOverlap => format!("{one} was placed in {two} and is pushed out slowly"),
        EventKind::MassMismatch => {
            format!("the motion of {one} does not fit its mass in the model")
        }
        EventKind::NotConverged => {
            format!("the contact forces between {one} and {two} did not converge")
        }
    })
}

fn world_text(event: &WorldEvent, setup: &Setup) -> String {
    let world = &setup.world;
    let vessel = || &*setup.bodies[world.vessels[event.who].body].name;
    let tug = || &*world.tugs[event.who].tug.name;
    let line = || &*world.lines[event.who].line.name;
    match event.kind {
        WorldEventKind::OrderClamped => format!("{}: an order was limited to its stop", vessel()),
        WorldEventKind::Aground => format!("{} IS AGROUND", vessel()),
        WorldEventKind::ShallowHeld => {
            format!(
                "{}: the water is shallower than the formulas for shallow water allow",
                vessel()
            )
        }
        WorldEventKind::TugLimited => {
            format!("tug {} cannot give the ordered force at this speed and angle", tug())
        }
        WorldEventKind::TugOrderRefused => format!("tug {} refused an order", tug()),
        WorldEventKind::LineMadeFast => format!("line {} is fast", line()),
        WorldEventKind::LineNotMadeFast => format!("line {} could not be made fast", line()),
        WorldEventKind::LineParted => format!("LINE {} HAS PARTED", line()),
        WorldEventKind::LineNotParted => {
            format!("line {} was planned to part, but is not fast", line())
        }
        WorldEventKind::LineRenders => format!("line {}: the brake of the winch renders", line()),
        WorldEventKind::Anchor(what) => {
            format!("{}: {}", called("anchor", &world.anchors[event.who].gear.name), what.text())
        }
    }
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::*;
    use crate::session::Session;
    use crate::source::Source;

    /// A ship that comes to several fenders of a quay in one step, or leaves them, touches or leaves the quay once.
    #[test]
    fn the_log_does_not_say_touches_quay_four_times_at_one_time() {
        let text = include_str!("../../../../scenarios/berth/alongside_with_two_tugs.toml");
        let none = |name: &str| Err(format!("{name}: none is needed"));
        let (source, _) =
            Source::collect("a.toml", text.to_owned(), vec![], none).expect("a scenario");
        let session = Session::open(source).expect("a set-up");
        let setup = session.simulation().setup();
        let body = |name: &str| {
            setup.bodies.iter().position(|body| body.name == name).expect("it has that body")
        };
        let bodies = [body("quay"), body("ship")];
        let event = |kind| Event { bodies: bodies.map(|body| BodyId(body as u32)), kind };
        let contact = |fender| ContactNow {
            bodies,
            fender: Some(fender),
            at_m: [0.0; 2],
            force_n: [0.0; 2],
            slips: false,
        };
        let seen = |contacts: Vec<ContactNow>, kinds: &[EventKind]| -> Vec<String> {
            let contact_events = kinds.iter().map(|kind| event(*kind)).collect();
            Seen { contacts, contact_events, ..Seen::default() }.events(setup).collect()
        };
        let touched = seen(vec![contact(0), contact(1)], &[EventKind::ContactBegan; 4]);
        let [one, two] = [0, 1].map(|fender: usize| &*setup.fenders[fender].name);
        assert_eq!(touched, [format!("quay touches ship at {one}, {two}")]);
        assert_eq!(seen(vec![], &[EventKind::ContactEnded; 4]), ["quay leaves ship"]);
    }

    const AT_SHOULDER: Ordered = Ordered { bodies: [2, 4], at_m: vec2(60.0, -16.0) };
    const AT_QUARTER: Ordered = Ordered { at_m: vec2(-60.0, -16.0), ..AT_SHOULDER };

    /// What the log says of one step with an event of a tug and a ship, while orders stand and contacts last.
    fn said(
        seen: &mut Seen,
        kind: Option<EventKind>,
        ordered: &[Ordered],
        touches: bool,
    ) -> Vec<EventKind> {
        let contact = ContactNow {
            bodies: [4, 2],
            fender: None,
            at_m: [0.0; 2],
            force_n: [0.0; 2],
            slips: false,
        };
        seen.contacts = if touches { vec![contact] } else { vec![] };
        let bodies = [BodyId(4), BodyId(2)];
        seen.contact_events = kind.into_iter().map(|kind| Event { bodies, kind }).collect();
        seen.keep_first_touches(ordered);
        seen.contact_events.iter().map(|event| event.kind).collect()
    }

    use EventKind::{ContactBegan, ContactEnded};

    /// A tug that was told to stop lay at the side of a ship, and the log had a line for each touch.
    #[test]
    fn the_log_is_not_full_of_touches_of_a_tug_that_lies_alongside() {
        let seen = &mut Seen::default();
        let ordered = [AT_SHOULDER];
        assert_eq!(
            said(seen, Some(ContactBegan), &ordered, true),
            [ContactBegan],
            "the first touch"
        );
        assert_eq!(said(seen, Some(ContactEnded), &ordered, false), []);
        assert_eq!(said(seen, Some(ContactBegan), &ordered, true), []);
        // Another order: she leaves, and this is an event.
        assert_eq!(said(seen, None, &[], true), []);
        assert_eq!(said(seen, Some(ContactEnded), &[], false), [ContactEnded]);
        assert_eq!(said(seen, Some(ContactBegan), &ordered, true), [ContactBegan], "a new order");
        // Other pairs keep all their events.
        let others = [Ordered { bodies: [1, 4], ..AT_SHOULDER }];
        for _ in 0..2 {
            assert_eq!(said(seen, Some(ContactEnded), &others, false).last(), Some(&ContactEnded));
        }
    }

    /// A tug lay at a ship's side, lost the contact, and was sent away: the log said that she touched, and never that she
    /// left.
    #[test]
    fn the_log_says_that_a_tug_leaves_although_she_had_lost_the_contact_before() {
        let seen = &mut Seen::default();
        said(seen, Some(ContactBegan), &[AT_SHOULDER], true);
        assert_eq!(said(seen, Some(ContactEnded), &[AT_SHOULDER], false), []);
        assert_eq!(said(seen, None, &[], false), [ContactEnded]);
        assert_eq!(said(seen, None, &[], false), []);
    }

    /// A tug that was sent from the shoulder to the quarter left and touched again, and the log had neither.
    #[test]
    fn the_log_says_that_a_tug_goes_to_another_place_at_the_side() {
        let seen = &mut Seen::default();
        said(seen, Some(ContactBegan), &[AT_SHOULDER], true);
        assert!(seen.has_touched([2, 4]));
        assert_eq!(said(seen, None, &[AT_QUARTER], true), []);
        assert!(!seen.has_touched([2, 4]), "not yet at the quarter");
        assert_eq!(said(seen, Some(ContactEnded), &[AT_QUARTER], false), [ContactEnded]);
        assert_eq!(said(seen, Some(ContactBegan), &[AT_QUARTER], true), [ContactBegan]);
        assert_eq!(said(seen, Some(ContactEnded), &[AT_QUARTER], false), []);
    }
}
