//! Connected clients: joining, leaving, greetings and notices.

use std::mem;
use std::sync::{Arc, PoisonError};
use std::time::Instant;

use fenderline_live::message::{self, Hello, Link, Reply, Role};
use fenderline_live::{COMMAND_LIMITS, Control, berth_info, library_info};
use tokio::sync::{mpsc, watch};

use super::Engine;
use super::client::Client;
use super::trials::Trials;
use crate::claims::{ClientId, Seat};
use crate::hub::{Kind, Text};
use crate::permit;
use crate::role_words::role_words;

impl Engine {
    /// Links to the pages for all roles in the scenario.
    pub(crate) fn links(&self) -> Vec<Link> {
        let tokens = self.hub.tokens.read().unwrap_or_else(PoisonError::into_inner);
        tokens.links(&self.roles())
    }

    pub(super) fn roles(&self) -> Vec<Role> {
        let tugs = self.session.cast().tug_names().into_iter();
        let tugs = tugs.map(|tug| Role::Tugmaster { tug });
        let others = self.session.cast().other_ships().into_iter();
        let others = others.map(|ship| Role::Pilot { vessel: Some(ship) });
        let pilots = [Role::Instructor, Role::PILOT].into_iter().chain(others);
        pilots.chain(tugs).chain([Role::Observer]).collect()
    }

    /// Makes links for the roles in the scenario that have no links yet.
    pub(super) fn make_tokens(&self) -> Result<(), getrandom::Error> {
        let mut tokens = self.hub.tokens.write().unwrap_or_else(PoisonError::into_inner);
        tokens.add(&self.roles())
    }

    /// Makes the models of the session's vessels known to the threads that answer requests.
    pub(super) fn show_models(&self) {
        let vessels = &self.session.simulation().setup().world.vessels;
        let models = vessels.iter().map(|vessel| vessel.looks.model.clone()).collect();
        *self.hub.models.write().unwrap_or_else(PoisonError::into_inner) = models;
    }

    pub(super) fn join(
        &mut self,
        client: ClientId,
        (role, kind): (Role, Kind),
        hello: watch::Sender<Option<Text>>,
        out: mpsc::Sender<Text>,
    ) {
        let label = label(&role, kind, client);
        let now = Instant::now();
        if role != Role::Observer || self.crowd.may_tell(now) {
            self.notify_all(&format!("{label} has joined"));
        }
        let trials = Trials::bucket(now);
        let is_instructor = role == Role::Instructor;
        self.clients.insert(
            client,
            Client { role, kind, label, seat: None, hello, out, trials, asked: None },
        );
        self.greet(client);
        if is_instructor {
            self.tell_planned_to(client);
        }
        if mem::take(&mut self.starts_with_first_client) {
            self.paused = false;
            self.pacer.restart(now);
            self.publish_frame();
        }
        self.send_first_frame(client);
        self.crowd.change();
    }

    /// Sends a new client the present frame, unless the last published frame shows what the client's role may see. The
    /// other clients see the new number of clients in their next frame.
    fn send_first_frame(&self, client: ClientId) {
        let Some(of) = self.clients.get(&client) else { return };
        if self.hub.frames.borrow().as_ref().is_some_and(|last| last.is_for(&of.role)) {
            return;
        }
        let frame = self.frame();
        let seen = self.session.in_fog(&frame, &of.role);
        let text = message::text(seen.as_ref().unwrap_or(&frame));
        let marks = self.marks().filter(|_| of.role == Role::Instructor);
        let _ = of.out.try_send(message::with_events(&text, &[], marks.as_deref()).into());
    }

    /// Publishes a frame if the changed number of clients has to be shown. Also sends the notice that counts
    /// the observers who came or went without a notice, if such a notice may be sent now.
    pub(super) fn show_crowd(&mut self) {
        let now = Instant::now();
        if self.crowd.due_at(self.published).is_some_and(|at| at <= now) {
            self.publish_frame();
        }
        if let Some(others) = self.crowd.untold(now) {
            self.notify_all(&format!("observers have joined or left {others} more times"));
        }
    }

    pub(super) fn leave(&mut self, client: ClientId) {
        let Some(gone) = self.clients.remove(&client) else { return };
        self.trials.leave(client);
        let seat = gone.seat.clone().map(|key| Seat { role: gone.role.clone(), key });
        let vacated = self.claims.gone(client, seat.as_ref());
        let text = format!("{} has left", gone.label);
        if gone.is_program() && !vacated.is_empty() {
            self.tell_all_left(&text, &vacated);
        } else if gone.role != Role::Observer || self.crowd.may_tell(Instant::now()) {
            self.notify_all(&left(&text, &vacated));
        }
        if !vacated.is_empty() {
            self.greet_all();
        }
        self.crowd.change();
    }

    /// Greets all clients after a change of roles or of holders of controls, and keeps roles and holders in the file
    /// beside the recording.
    pub(super) fn greet_all(&self) {
        self.keep_seats();
        self.clients.keys().for_each(|&client| self.greet(client));
    }

    /// Sends a client its role, the scenario, and the controls that the client may use.
    fn greet(&self, client: ClientId) {
        let Some(of) = self.clients.get(&client) else { return };
        let cast = self.session.cast();
        let controls = cast.controls();
        let is_mine = |control: &Control| {
            self.claims.holds(control, client)
                || permit::may_order(&of.role, control, cast)
                    && self.claims.may_use(control, client).is_ok()
        };
        let is_instructor = of.role == Role::Instructor;
        let session = is_instructor.then_some(Control::Session(true));
        let links = is_instructor.then(|| self.links());
        let claims = self.claims.list(&controls);
        let hello = Hello {
            protocol: message::PROTOCOL,
            role: &of.role,
            title: self.session.title(),
            file: &self.session.source().file,
            step_s: self.session.simulation().setup().step_s,
            bodies: &self.session.info().bodies,
            vessels: &self.session.info().vessels,
            fenders: &self.session.info().fenders,
            lines: &self.session.info().lines,
            anchors: &self.session.info().anchors,
            bollards: &self.session.info().bollards,
            tugs: &self.session.info().tugs,
            traffic: &self.session.info().traffic,
            orders: &self.session.info().orders,
            telegraph: &self.session.info().telegraph,
            limits: COMMAND_LIMITS,
            mine: controls
                .iter()
                .filter(|control| is_mine(control))
                .cloned()
                .chain(session)
                .collect(),
            claims: &claims,
            gallery: self.gallery.entries(),
            berth: self.session.info().berth.as_ref().map(berth_info),
            depth_m: self.session.info().depth_m,
            highest_water_m: self.session.info().highest_water_m,
            clearance_datum_m: self.session.info().clearance_datum_m,
            sea: &self.session.info().sea,
            daylight: self.session.info().daylight,
            rain: self.session.info().rain,
            chart: &self.session.info().chart,
            ghost: self.session.source().ghost.as_ref(),
            exercise: self.session.exercise_info(),
            links: links.as_deref(),
            library: is_instructor.then(library_info),
            deleted: is_instructor.then(|| self.gallery.deleted()),
        };
        of.hello.send_replace(Some(message::text(&hello).into()));
    }

    /// Tells all clients that a program has no controls any more, by a notice and by an event in the log of the pages.
    pub(super) fn tell_all_left(&mut self, why: &str, controls: &[Control]) {
        let text = left(why, controls);
        self.notify_all(&text);
        self.events.add(self.session.simulation().time_s(), text);
    }

    /// Sends a notice to all clients.
    pub(super) fn notify_all(&self, text: &str) {
        let text: Text = message::text(&Reply::Notice { text: text.to_owned() }).into();
        for client in self.clients.values() {
            // The queue is full, so the client does not read. Its connection is about to be closed for that reason.
            let _ = client.out.try_send(Arc::clone(&text));
        }
    }

    /// Sends an answer to one client.
    pub(super) fn reply(&self, client: ClientId, answer: &Reply) {
        if let Some(client) = self.clients.get(&client) {
            let _ = client.out.try_send(message::text(answer).into());
        }
    }
}

/// The label of a client that has not given a name.
fn label(role: &Role, kind: Kind, client: ClientId) -> String {
    match kind {
        Kind::Page => format!("{} {client}", role_words(role)),
        Kind::Program => format!("{} {client} (program)", role_words(role)),
        Kind::Nmea => format!("NMEA controller {client}"),
    }
}

/// A text that says why somebody has left controls, and that the orders of these controls stand.
fn left(why: &str, controls: &[Control]) -> String {
    let name = |control: &Control| match control {
        Control::Vessel(name) | Control::Tug(name) => name.clone(),
        Control::Session(_) => "the session".to_owned(),
    };
    let names: Vec<String> = controls.iter().map(name).collect();
    match names.as_slice() {
        [] => why.to_owned(),
        names => format!("{why}; the orders of {} stay as they are", names.join(", ")),
    }
}
