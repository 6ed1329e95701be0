//! Commands of clients. The commands of clients are checked against the role and the holders of controls, then carried
//! out.

use std::time::Instant;

use fenderline_live::message::{Reply, Role};
use fenderline_live::{Action, COMMAND_LIMITS, Conduct, Control, OtherAction, Refusal, Request};

use super::Engine;
use super::client::Client;
use super::clock::unix_ms;
use crate::claims::ClientId;
use crate::file_change::Wish;
use crate::hub::Kind;
use crate::opening::{Requester, Work};
use crate::permit::{self, Needs};

/// How a client's command was carried out.
enum Done {
    /// At this tick. If `shows` is true, clients get a frame at once.
    AtTick { tick: u64, shows: bool },
    /// The answer follows later, when work on another thread has ended.
    AnswerFollows,
}

impl Engine {
    /// Carries out a client's command, or refuses it.
    pub(super) fn command(
        &mut self,
        client: ClientId,
        id: Option<i64>,
        request: Result<Request, Refusal>,
    ) {
        let Some(from) = self.clients.get(&client) else { return };
        let (role, is_nmea) = (from.role.clone(), from.kind == Kind::Nmea);
        let requester = Requester { client, label: from.label.clone(), id };
        let label = requester.label.clone();
        let done = request.and_then(|request| match request {
            Request::Action(action) => self.act(&requester, &role, action),
            Request::Conduct(conduct) => self.conduct(requester, &role, conduct),
        });
        let answer = match (done, id) {
            (Ok(Done::AtTick { tick, shows }), Some(id)) => {
                if shows {
                    self.publish_frame();
                }
                Reply::Ack { id, tick }
            }
            // A command without a number is not acknowledged.
            (Ok(_), _) => return,
            (Err(refusal), id) => {
                let reason = refusal.to_string();
                // The task of a controller logs what is refused, together with what it drops.
                if !is_nmea {
                    self.hub.log.refused(&format!("refused {label}: {reason}"));
                }
                Reply::Refused { id, reason }
            }
        };
        self.reply(client, &answer);
    }

    /// Carries out an action of a client in the simulation: an order, a fault, a change of the weather.
    fn act(&mut self, requester: &Requester, role: &Role, action: Action) -> Result<Done, Refusal> {
        let (client, label) = (requester.client, requester.label.as_str());
        let needs = self.may_give(client, role, &action)?;
        self.may_acknowledge(role, &action)?;
        let tick = self.session.command(label, unix_ms(), action)?;
        self.take_helms(&[needs], (client, label))?;
        Ok(self.has_given(tick))
    }

    /// Records a command that was given. If the session is paused, clients see the effect of the command at once.
    fn has_given(&mut self, tick: u64) -> Done {
        self.record();
        // While the session is paused, a frame and a new prediction show the effect of the order.
        if self.paused {
            self.predictor.reset();
        }
        Done::AtTick { tick, shows: self.paused }
    }

    /// Checks that a client may give a command. That depends on the client's role and on the holders of the controls.
    fn may_give(&self, client: ClientId, role: &Role, action: &Action) -> Result<Needs, Refusal> {
        let needs = permit::for_action(role, action, self.session.cast())?;
        if let Needs::Helm(control) | Needs::NobodyAt(control) = &needs {
            self.claims.may_use(control, client)?;
            if self.clients.get(&client).is_some_and(|of| of.kind == Kind::Nmea) {
                self.claims.is_free(control, client)?;
            }
        }
        Ok(needs)
    }

    fn is_program(&self, client: ClientId) -> bool {
        self.clients.get(&client).is_some_and(Client::is_program)
    }

    /// Gives a client the helms that the commands of the client take.
    fn take_helms(&mut self, needs: &[Needs], of: (ClientId, &str)) -> Result<(), Refusal> {
        let mut taken = false;
        let is_program = self.is_program(of.0);
        for needs in needs {
            if let Needs::Helm(control) = needs
                && !self.claims.holds(control, of.0)
            {
                self.claims.take(control.clone(), (of.0, of.1, is_program), false)?;
                taken = true;
            }
        }
        if taken {
            if is_program {
                self.notify_all(&format!("{} has the helm", of.1));
            }
            self.greet_all();
        }
        Ok(())
    }

    /// Starts a trial manoeuvre. A trial does not change the run, and whoever has the helm keeps it.
    fn trial(
        &mut self,
        requester: &Requester,
        role: &Role,
        (orders, horizon_s): (&[Action], f64),
    ) -> Result<Done, Refusal> {
        let client = requester.client;
        for order in orders {
            self.may_give(client, role, order)?;
        }
        let id =
            requester.id.ok_or_else(|| Refusal::new("a trial needs a command with a number"))?;
        let from = self.clients.get_mut(&client);
        let from = from.ok_or_else(|| Refusal::new("the client has left"))?;
        if !from.trials.take(Instant::now()) {
            return Err(Refusal::new("this page starts too many trials: wait a moment"));
        }
        let out = from.out.clone();
        let mut trial = self.session.trial(orders, horizon_s)?;
        trial.leave_out(&self.session.hidden_vessels(role));
        self.trials.start((client, id), trial, out)?;
        Ok(Done::AtTick { tick: self.session.tick(), shows: false })
    }

    /// Gives several orders at once. Either all of the orders are given or none of them.
    fn give(
        &mut self,
        requester: &Requester,
        role: &Role,
        orders: Vec<Action>,
    ) -> Result<Done, Refusal> {
        let (client, label) = (requester.client, requester.label.as_str());
        let needs = orders.iter().map(|order| self.may_give(client, role, order));
        let needs = needs.collect::<Result<Vec<Needs>, Refusal>>()?;
        let tick = self.session.command_all(label, unix_ms(), orders)?;
        self.take_helms(&needs, (client, label))?;
        Ok(self.has_given(tick))
    }

    /// If the action acknowledges an alarm, checks that the client's role may acknowledge the alarm.
    fn may_acknowledge(&self, role: &Role, action: &Action) -> Result<(), Refusal> {
        if let Action::Other(OtherAction::Acknowledge { key }) = action {
            self.session.alarms().may_acknowledge(key, role)?;
        }
        Ok(())
    }

    /// Carries out a client's command about the session itself: pause, rewind, load, save, claims.
    fn conduct(
        &mut self,
        requester: Requester,
        role: &Role,
        conduct: Conduct,
    ) -> Result<Done, Refusal> {
        permit::for_conduct(role, &conduct)?;
        let now = Instant::now();
        let (client, label) = (requester.client, requester.label.as_str());
        match conduct {
            Conduct::Claim { control } => self.claim(client, role, label, control)?,
            Conduct::Release { control } => {
                if !self.claims.release(&control, client) {
                    return Err(Refusal::new("you do not hold this control"));
                }
                self.greet_all();
            }
            Conduct::Pause {} => {
                (self.paused, self.starts_with_first_client) = (true, false);
                self.session.mark();
            }
            Conduct::Resume {} => {
                self.paused = false;
                self.pacer.restart(now);
            }
            Conduct::SingleStep {} => {
                self.paused = true;
                self.tick();
            }
            Conduct::Pace { pace } => {
                let [least, most] = COMMAND_LIMITS.pace;
                if !(least..=most).contains(&pace) {
                    return Err(Refusal::new(format_args!(
                        "the pace must be from {least} to {most}"
                    )));
                }
                self.pacer.set_pace(pace, now);
            }
            Conduct::Rewind { tick } => {
                let was_rewound = self.session.is_rewound();
                self.session.rewind(tick)?;
                self.paused_elsewhere();
                // The notice comes once, and not for every position while somebody drags the timeline.
                if !was_rewound && self.session.is_rewound() {
                    self.notify_all(&format!("{label} has rewound the session"));
                }
            }
            Conduct::Branch {} => {
                let id = self.session.branch()?;
                self.greet_all();
                self.notify_all(&format!("{label} has begun branch {id}"));
            }
            Conduct::ShowBranch { id } => {
                self.session.go_to_branch(id)?;
                self.paused_elsewhere();
                self.greet_all();
                self.notify_all(&format!("{label} shows branch {id}"));
            }
            Conduct::Load { file } => self.load(requester, file)?,
            Conduct::StopOpening {} => {
                if !self.work.as_ref().is_some_and(Work::stop) {
                    return Err(Refusal::new("nothing is being opened"));
                }
            }
            Conduct::History { vessel } => {
                self.send_history(client, vessel.as_deref(), now)?;
                return Ok(Done::AtTick { tick: self.session.tick(), shows: false });
            }
            Conduct::Report {} => {
                self.report(requester)?;
                return Ok(Done::AnswerFollows);
            }
            Conduct::Name { name } => self.name(client, role, &name)?,
            Conduct::Seat { key } => self.seat(client, role, key)?,
            Conduct::Trial { orders, horizon_s } => {
                return self.trial(&requester, role, (&orders, horizon_s));
            }
            Conduct::Give { orders } => return self.give(&requester, role, orders),
            Conduct::Create { of } => {
                self.create(requester, *of)?;
                return Ok(Done::AnswerFollows);
            }
            Conduct::SaveExercise { name, title, replace } => {
                self.save_exercise(requester, (&name, &title), replace)?;
                return Ok(Done::AnswerFollows);
            }
            Conduct::Rename { file, name } => {
                self.change_file(requester, &file, &Wish::Rename(name))?;
                return Ok(Done::AnswerFollows);
            }
            Conduct::Delete { file } => {
                self.change_file(requester, &file, &Wish::Delete)?;
                return Ok(Done::AnswerFollows);
            }
            Conduct::PutBack { file } => {
                self.change_file(requester, &file, &Wish::PutBack)?;
                return Ok(Done::AnswerFollows);
            }
            Conduct::Save { name } => {
                self.save(requester, &name)?;
                return Ok(Done::AnswerFollows);
            }
        }
        self.record();
        Ok(Done::AtTick { tick: self.session.tick(), shows: true })
    }

    /// Pauses the session after it has moved to another time or branch.
    fn paused_elsewhere(&mut self) {
        self.paused = true;
        self.predictor.reset();
    }

    fn claim(
        &mut self,
        client: ClientId,
        role: &Role,
        label: &str,
        control: Control,
    ) -> Result<(), Refusal> {
        let cast = self.session.cast();
        if !cast.controls().contains(&control) {
            return Err(Refusal::new("there is no control of this name"));
        }
        if !permit::may_claim(role, &control, cast) {
            return Err(Refusal::new("your link does not open this control"));
        }
        let is_program = self.is_program(client);
        let from_program = self.claims.is_held_by_program(&control) && !is_program;
        let by_force = *role == Role::Instructor || from_program;
        let holder = self.claims.holder(&control);
        let taken = self.claims.take(control, (client, label, is_program), by_force);
        if taken.is_err()
            && let Some(holder) = holder
        {
            let text =
                format!("{label} asks for the control that you hold: release it to hand it over");
            self.reply(holder, &Reply::Notice { text });
        }
        let former = taken?;
        if let Some(former) = former {
            let text = format!("{label} has taken the control from you");
            self.reply(former, &Reply::Notice { text });
        }
        if from_program {
            self.notify_all(&format!("{label} has taken the control from a program"));
        }
        self.greet_all();
        Ok(())
    }
}
