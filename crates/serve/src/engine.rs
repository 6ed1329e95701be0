//! The simulation's thread: it steps the session at wall time's pace, carries out what clients say, and shows them
//! the latest frame. It waits for nobody but the clock: who is slow misses frames, who is rude is refused.

use std::collections::{BTreeMap, VecDeque};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::sync::{Arc, PoisonError};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use fenderline_live::message::{
    self, EventNow, GalleryEntry, Hello, Link, Reply as Answer, Role, RunState,
};
use fenderline_live::{
    AlarmBook, COMMAND_LIMITS, Conduct, Control, Info, Refusal, Request, Session, StepError,
};
use fenderline_nautical::{ChartOrigin, Moment};
use tokio::sync::{mpsc, watch};

use super::claims::{Claims, ClientId};
use super::gallery::{Gallery, Opened};
use super::hub::{Hub, Shown, Text, Told};
use super::instruments;
use super::opening::{Asked, Outcome, Work};
use super::pacer::Pacer;
use super::permit::{self, Needs};
use super::recorder::Recorder;
use super::saved::ENDING;

/// Events that a frame carries for those who missed some.
const EVENTS: usize = 64;
/// Frames are not shown more often than this, however fast the simulation runs.
const BETWEEN_FRAMES: Duration = Duration::from_millis(33);
/// While paused a frame is shown so often; and while something is being opened, to show how far that is.
const BETWEEN_SIGNS: Duration = Duration::from_secs(1);
const BETWEEN_SIGNS_OF_OPENING: Duration = Duration::from_millis(200);
/// Wall time between two predictions, how far they look and how often they tell a place.
const BETWEEN_PREDICTIONS: Duration = Duration::from_secs(1);
const AHEAD_S: f64 = 300.0;
const EVERY_S: f64 = 10.0;
/// Wall time between two rounds of the instruments.
const BETWEEN_SENTENCES: Duration = Duration::from_secs(1);

struct Client {
    role: Role,
    label: String,
    hello: watch::Sender<Option<Text>>,
    out: mpsc::Sender<Text>,
}

/// Everything of the simulation's thread.
pub(crate) struct Engine {
    hub: Arc<Hub>,
    session: Session,
    info: Info,
    gallery: Gallery,
    sessions: PathBuf,
    recorder: Recorder,
    /// Told once.
    recording_failed: bool,
    /// What is done beside this thread: a scenario or a session is opened, or one is saved.
    work: Option<Work>,
    pacer: Pacer,
    paused: bool,
    /// Paused until somebody comes.
    waits_for_somebody: bool,
    claims: Claims,
    alarms: AlarmBook,
    clients: BTreeMap<ClientId, Client>,
    events: VecDeque<(u64, EventNow)>,
    next_event: u64,
    shown_at: Instant,
    predicted_at: Option<Instant>,
    predicting: Arc<AtomicBool>,
    /// Where the chart has the scenario's origin; `None`: the instruments are off.
    chart: Option<ChartOrigin>,
    said_at: Instant,
    /// How often the instruments have spoken.
    said: u64,
}

impl Engine {
    /// Ready to run; the recording is begun.
    ///
    /// # Errors
    /// The recording's file cannot be written, or there are no random numbers.
    pub(crate) fn new(
        hub: Arc<Hub>,
        mut opened: Opened,
        gallery: Gallery,
        sessions: PathBuf,
        paused: bool,
        chart: Option<ChartOrigin>,
    ) -> Result<Engine, String> {
        let file = opened.session.source().file.clone();
        let recorder = Recorder::begin(&sessions, &file, &mut opened)?;
        let session = opened.session;
        let info = Info::of(session.simulation().setup(), session.cast());
        let now = Instant::now();
        let mut engine = Engine {
            pacer: Pacer::new(session.simulation().setup().step_s, now),
            hub,
            session,
            info,
            gallery,
            sessions,
            recorder,
            recording_failed: false,
            work: None,
            paused: true,
            waits_for_somebody: !paused,
            claims: Claims::default(),
            alarms: AlarmBook::default(),
            clients: BTreeMap::new(),
            events: VecDeque::new(),
            next_event: 1,
            shown_at: now,
            predicted_at: None,
            predicting: Arc::new(AtomicBool::new(false)),
            chart,
            said_at: now,
            said: 0,
        };
        engine.restart_alarms();
        engine.make_tokens().map_err(|e| format!("no random numbers for the links: {e}"))?;
        Ok(engine)
    }

    /// The file that this session is recorded to.
    pub(crate) fn recording(&self) -> &std::path::Path {
        self.recorder.path()
    }

    /// Links of all roles that this scenario has.
    pub(crate) fn links(&self) -> Vec<Link> {
        let tokens = self.hub.tokens.read().unwrap_or_else(PoisonError::into_inner);
        tokens.links(&self.roles())
    }

    fn roles(&self) -> Vec<Role> {
        let tugs = self.session.cast().tug_names().into_iter();
        let tugs = tugs.map(|tug| Role::Tugmaster { tug });
        [Role::Instructor, Role::Pilot].into_iter().chain(tugs).chain([Role::Observer]).collect()
    }

    fn make_tokens(&self) -> Result<(), getrandom::Error> {
        let mut tokens = self.hub.tokens.write().unwrap_or_else(PoisonError::into_inner);
        tokens.add(&self.roles())
    }

    /// Runs until it is told to stop.
    pub(crate) fn run(mut self, told: &Receiver<Told>) {
        self.show();
        loop {
            let wait = self.wait();
            match told.recv_timeout(wait) {
                Ok(Told::Stop) | Err(RecvTimeoutError::Disconnected) => break,
                Ok(message) => self.hear(message),
                Err(RecvTimeoutError::Timeout) => {
                    // Nothing moves, but the server is there: pages tell the two apart.
                    if self.paused && self.shown_at.elapsed() >= self.between_signs() {
                        self.show();
                    }
                }
            }
            // After each message, so that no flood of them delays a tick.
            let now = Instant::now();
            if !self.paused && self.pacer.is_due(now) {
                self.pacer.begin(now);
                self.tick();
            }
            self.predict(now);
            self.say(now);
        }
        self.end_recording();
        if let Some(work) = self.work.take() {
            work.finish();
        }
    }

    fn wait(&self) -> Duration {
        let now = Instant::now();
        if self.paused { self.between_signs() / 2 } else { self.pacer.wait(now) }
    }

    fn between_signs(&self) -> Duration {
        if self.work.is_some() { BETWEEN_SIGNS_OF_OPENING } else { BETWEEN_SIGNS }
    }

    fn tick(&mut self) {
        let was_rewound = self.session.is_rewound();
        if let Err(e) = self.session.step() {
            self.paused = true;
            let hint = match &e {
                StepError::Simulation(_) => "Rewind it.",
                StepError::Full(_) => "Save it, and open its scenario anew.",
            };
            self.tell_all(&format!("The simulation cannot go on: {e}. {hint}"));
        }
        if was_rewound && !self.session.is_rewound() {
            self.paused = true;
            self.tell_all("The end of what is recorded: resume to go on from here.");
        }
        self.note_alarms();
        self.record();
        if self.paused || self.shown_at.elapsed() >= BETWEEN_FRAMES {
            self.show();
        }
    }

    /// Every tick, not every frame: what was touched for a moment alone is an alarm too.
    fn note_alarms(&mut self) {
        let causes = self.session.causes_for_alarm(&self.info);
        self.alarms.update(causes, self.session.simulation().time_s());
    }

    /// Another run is shown, or another time of this one: what stood in that one is not open here.
    fn restart_alarms(&mut self) {
        self.alarms.clear();
        self.note_alarms();
    }

    /// Adds what there is to the recording's file.
    fn record(&mut self) {
        let lines = self.session.take_lines();
        if lines.is_empty() || self.recording_failed {
            return;
        }
        if let Err(why) = self.recorder.add(&lines) {
            self.recording_failed = true;
            let text = format!("THE SESSION IS NO LONGER RECORDED: {why}");
            self.hub.log.notify(&text);
            self.tell_all(&text);
        }
    }

    /// Nothing follows in the recording.
    fn end_recording(&mut self) {
        self.session.mark();
        self.record();
        if !self.recording_failed
            && let Err(why) = self.recorder.add(&self.session.end_line())
        {
            self.hub.log.notify(&format!("the recording could not be ended: {why}"));
        }
    }

    /// Shows everybody the state.
    fn show(&mut self) {
        for (t_s, text) in self.session.take_events() {
            self.events.push_back((self.next_event, EventNow { t_s, text }));
            self.next_event += 1;
        }
        let beyond = self.events.len().saturating_sub(EVENTS);
        self.events.drain(..beyond);
        let (late_ticks, latest_ms) = self.pacer.late();
        let run = RunState {
            paused: self.paused,
            pace: self.pacer.pace(),
            late_ticks,
            latest_ms,
            clients: self.clients.len(),
            opening: self.work.as_ref().and_then(Work::now),
            ..RunState::default()
        };
        let frame =
            message::text(&self.session.frame(&self.info, now_ms(), run, &self.alarms)).into();
        let events = self.events.iter().cloned().collect();
        self.hub.frames.send_replace(Some(Shown { frame, events }));
        self.shown_at = Instant::now();
    }

    /// Looks ahead on a thread of its own, one at a time.
    fn predict(&mut self, now: Instant) {
        // Of a state that stands still once is enough.
        let is_due =
            self.predicted_at.is_none_or(|at| !self.paused && now >= at + BETWEEN_PREDICTIONS);
        if self.clients.is_empty() || !is_due || self.session.cast().own.is_none() {
            return;
        }
        if self.predicting.swap(true, Ordering::AcqRel) {
            return;
        }
        self.predicted_at = Some(now);
        let (busy, hub) = (Arc::clone(&self.predicting), Arc::clone(&self.hub));
        let Some(prediction) = self.session.prediction() else { return };
        let look = move || {
            let until = Instant::now() + BETWEEN_PREDICTIONS;
            let path = prediction.run(AHEAD_S, EVERY_S, || Instant::now() < until);
            hub.predictions.send_replace(Some(message::text(&path).into()));
            busy.store(false, Ordering::Release);
        };
        let thread = std::thread::Builder::new().name("prediction".into()).spawn(look);
        if thread.is_err() {
            self.predicting.store(false, Ordering::Release);
        }
    }

    /// Lets the instruments speak once a second of wall time, and by its clock: that is what a chart program goes by.
    fn say(&mut self, now: Instant) {
        let Some(chart) = &self.chart else { return };
        if self.said > 0 && now < self.said_at + BETWEEN_SENTENCES {
            return;
        }
        let at = Moment::from_unix(now_ms() as f64 * 1e-3);
        let all = instruments::sentences(&self.session, chart, at, self.said);
        self.hub.said.send_replace(Some(all.into()));
        self.said_at = now;
        self.said += 1;
    }

    fn hear(&mut self, told: Told) {
        match told {
            Told::Join { client, role, hello, out } => self.join(client, role, hello, out),
            Told::Leave { client } => self.leave(client),
            Told::Said { client, id, request } => {
                self.hub.taken();
                self.answer(client, id, request);
            }
            Told::Done(outcome) => self.done(outcome),
            Told::Stop => {}
        }
    }

    fn join(
        &mut self,
        client: ClientId,
        role: Role,
        hello: watch::Sender<Option<Text>>,
        out: mpsc::Sender<Text>,
    ) {
        let label = match &role {
            Role::Instructor => format!("instructor {client}"),
            Role::Pilot => format!("pilot {client}"),
            Role::Tugmaster { tug } => format!("master of {tug} {client}"),
            Role::Observer => format!("observer {client}"),
        };
        self.tell_all(&format!("{label} has come"));
        self.clients.insert(client, Client { role, label, hello, out });
        self.greet(client);
        if std::mem::take(&mut self.waits_for_somebody) {
            self.paused = false;
            self.pacer.restart(Instant::now());
        }
        self.show();
    }

    fn leave(&mut self, client: ClientId) {
        let Some(gone) = self.clients.remove(&client) else { return };
        let left = self.claims.gone(client);
        let names: Vec<&str> = left
            .iter()
            .map(|control| match control {
                Control::Vessel(name) | Control::Tug(name) => name.as_str(),
                Control::Session(_) => "the session",
            })
            .collect();
        let mut text = format!("{} has gone", gone.label);
        if !names.is_empty() {
            text += &format!(": the controls of {} stay as they are", names.join(", "));
        }
        self.tell_all(&text);
        if !left.is_empty() {
            self.greet_all();
        }
        self.show();
    }

    fn answer(&mut self, client: ClientId, id: Option<i64>, request: Result<Request, Refusal>) {
        let Some(from) = self.clients.get(&client) else { return };
        let (role, label) = (from.role.clone(), from.label.clone());
        let asked = Asked { client, label: label.clone(), id };
        let done = request.and_then(|request| match request {
            Request::Action(action) => {
                let needs = permit::for_action(&role, &action, self.session.cast())?;
                if let Needs::Helm(control) | Needs::NobodyAt(control) = &needs {
                    self.claims.may_use(control, client)?;
                }
                let tick = self.session.command(&label, now_ms(), action)?;
                if let Needs::Helm(control) = needs
                    && !self.claims.holds(&control, client)
                {
                    self.claims.take(control, (client, &label), false)?;
                    self.greet_all();
                }
                self.record();
                // Who steers a paused simulation sees that it was heard, and where it would go.
                if self.paused {
                    self.predicted_at = None;
                }
                Ok(Some((tick, self.paused)))
            }
            Request::Conduct(conduct) => {
                permit::for_conduct(&role, &conduct)?;
                if let Conduct::Save { name } = conduct {
                    self.save(asked, &name)?;
                    return Ok(None);
                }
                self.conduct(asked, &role, conduct)?;
                self.record();
                Ok(Some((self.session.tick(), true)))
            }
        });
        let answer = match (done, id) {
            (Ok(Some((tick, show))), Some(id)) => {
                if show {
                    self.show();
                }
                Answer::Ack { id, tick }
            }
            // Answered later, or by nobody's wish.
            (Ok(_), _) => return,
            (Err(refusal), id) => {
                let reason = refusal.to_string();
                self.hub.log.refused(&format!("refused {label}: {reason}"));
                Answer::Refused { id, reason }
            }
        };
        self.tell_one(client, &answer);
    }

    fn conduct(&mut self, asked: Asked, role: &Role, conduct: Conduct) -> Result<(), Refusal> {
        let now = Instant::now();
        let (client, label) = (asked.client, asked.label.as_str());
        match conduct {
            Conduct::Claim { control } => self.claim(client, role, label, control)?,
            Conduct::Release { control } => {
                if !self.claims.release(&control, client) {
                    return Err(Refusal::new("you do not hold it"));
                }
                self.greet_all();
            }
            Conduct::Pause {} => {
                (self.paused, self.waits_for_somebody) = (true, false);
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
                    return Err(Refusal::new(format_args!("a pace is from {least} to {most}")));
                }
                self.pacer.set_pace(pace, now);
            }
            Conduct::Rewind { tick } => {
                let was_rewound = self.session.is_rewound();
                self.session.rewind(tick)?;
                self.paused = true;
                self.predicted_at = None;
                self.restart_alarms();
                // Once, not for every place that a hand on the timeline comes by.
                if !was_rewound && self.session.is_rewound() {
                    self.tell_all(&format!("{label} goes back in time"));
                }
            }
            Conduct::Branch {} => {
                let id = self.session.branch()?;
                self.greet_all();
                self.tell_all(&format!("{label} has begun branch {id}"));
            }
            Conduct::ShowBranch { id } => {
                self.session.go_to_branch(id)?;
                self.paused = true;
                self.predicted_at = None;
                self.restart_alarms();
                self.greet_all();
                self.tell_all(&format!("{label} shows branch {id}"));
            }
            Conduct::Load { file } => self.load(asked, file)?,
            Conduct::StopOpening {} => {
                if !self.work.as_ref().is_some_and(Work::stop) {
                    return Err(Refusal::new("nothing is being opened"));
                }
            }
            Conduct::Acknowledge { key } => {
                let text = self.alarms.acknowledge(&key, role)?;
                let t_s = self.session.simulation().time_s();
                let text = format!("{label} acknowledges: {text}");
                self.events.push_back((self.next_event, EventNow { t_s, text }));
                self.next_event += 1;
            }
            Conduct::Save { name } => self.save(asked, &name)?,
        }
        Ok(())
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
            return Err(Refusal::new("there is no such control"));
        }
        if !permit::may_claim(role, &control, cast) {
            return Err(Refusal::new("your link does not open this control"));
        }
        let by_force = *role == Role::Instructor;
        let former = self.claims.take(control, (client, label), by_force)?;
        if let Some(former) = former {
            let text = format!("{label} has taken the control from you");
            self.tell_one(former, &Answer::Notice { text });
        }
        self.greet_all();
        Ok(())
    }

    /// Begins to open an entry of the gallery; what is shown goes on until that is there.
    fn load(&mut self, asked: Asked, file: String) -> Result<(), Refusal> {
        self.is_free()?;
        let path = self.gallery.path(&file);
        let path = path.ok_or_else(|| Refusal::new("there is no such scenario in the gallery"))?;
        let (path, sessions) = (path.to_owned(), self.sessions.clone());
        self.work = Some(
            Work::open(self.send_outcome(), asked, file, path, sessions).map_err(Refusal::new)?,
        );
        Ok(())
    }

    /// Begins to save a copy of the session as it is now.
    fn save(&mut self, asked: Asked, name: &str) -> Result<(), Refusal> {
        self.is_free()?;
        self.session.mark();
        self.record();
        if self.recording_failed {
            return Err(Refusal::new("the session is no longer recorded"));
        }
        let copy = self.recorder.copy(name, self.session.end_line()).map_err(Refusal::new)?;
        self.work = Some(Work::save(self.send_outcome(), asked, copy).map_err(Refusal::new)?);
        Ok(())
    }

    /// Hands what comes of work on another thread to this one.
    fn send_outcome(&self) -> impl FnOnce(Outcome) + Send + 'static {
        let hub = Arc::clone(&self.hub);
        move |outcome| {
            hub.tell_engine(Told::Done(outcome));
        }
    }

    fn is_free(&self) -> Result<(), Refusal> {
        match &self.work {
            None => Ok(()),
            Some(work) => Err(Refusal::new(match work.now() {
                Some(opening) => format!("{} is still being opened", opening.file),
                None => "the session is still being saved".to_owned(),
            })),
        }
    }

    /// Something that was done beside this thread is done.
    fn done(&mut self, outcome: Outcome) {
        let Some(work) = self.work.take() else { return };
        let done = match outcome {
            Outcome::Opened(opened) => match *opened {
                Ok((_, recorder)) if work.is_stopped() => {
                    recorder.discard();
                    Err(format!("{}, it was stopped", work.file.as_deref().unwrap_or_default()))
                }
                Ok((opened, recorder)) => self.take_over(&work.asked, opened, recorder),
                Err(why) => Err(why),
            },
            Outcome::Saved(saved) => {
                saved.map(|(path, entry)| self.saved(&work.asked, &path, entry))
            }
            Outcome::Lost => Err("a mistake of this program: see its standard error".to_owned()),
        };
        if let Err(reason) = done {
            let Asked { client, label, id } = work.asked;
            self.hub.log.refused(&format!("refused {label}: {reason}"));
            // That it was begun to be opened has been acknowledged already.
            let id = id.filter(|_| work.file.is_none());
            self.tell_one(client, &Answer::Refused { id, reason });
        }
        self.show();
    }

    fn saved(&mut self, asked: &Asked, path: &std::path::Path, entry: Option<GalleryEntry>) {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if let Some(entry) = entry {
            self.gallery.put(path, entry);
        }
        if let Some(id) = asked.id {
            self.tell_one(asked.client, &Answer::Ack { id, tick: self.session.tick() });
        }
        self.greet_all();
        let name = name.strip_suffix(ENDING).unwrap_or(&name);
        self.tell_all(&format!("saved as {name}"));
    }

    /// Goes on with what was opened.
    fn take_over(
        &mut self,
        asked: &Asked,
        opened: Opened,
        recorder: Recorder,
    ) -> Result<(), String> {
        self.end_recording();
        self.session = opened.session;
        self.recorder = recorder;
        self.recording_failed = false;
        self.info = Info::of(self.session.simulation().setup(), self.session.cast());
        self.claims.clear();
        self.restart_alarms();
        self.make_tokens().map_err(|e| e.to_string())?;
        self.events.clear();
        self.predicted_at = None;
        self.paused = true;
        self.pacer.set_step(self.session.simulation().setup().step_s, Instant::now());
        self.greet_all();
        let label = &asked.label;
        self.tell_all(&format!("{label} has loaded {}; it is paused", self.session.title()));
        opened.notices.iter().for_each(|notice| self.tell_all(notice));
        Ok(())
    }

    fn greet_all(&self) {
        self.clients.keys().for_each(|&client| self.greet(client));
    }

    /// Tells a client who it is, and what there is.
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
        let claims = self.claims.told(&controls);
        let hello = Hello {
            protocol: message::PROTOCOL,
            role: &of.role,
            title: self.session.title(),
            file: &self.session.source().file,
            step_s: self.session.simulation().setup().step_s,
            bodies: &self.info.bodies,
            vessels: &self.info.vessels,
            fenders: &self.info.fenders,
            lines: &self.info.lines,
            tugs: &self.info.tugs,
            orders: &self.info.orders,
            limits: COMMAND_LIMITS,
            places: &self.info.places,
            mine: controls
                .iter()
                .filter(|control| is_mine(control))
                .cloned()
                .chain(session)
                .collect(),
            claims: &claims,
            gallery: self.gallery.told(),
            berth: self.info.berth.map(|berth| berth.info()),
            depth_m: self.info.depth_m,
            links: links.as_deref(),
        };
        of.hello.send_replace(Some(message::text(&hello).into()));
    }

    fn tell_all(&self, text: &str) {
        let text: Text = message::text(&Answer::Notice { text: text.to_owned() }).into();
        for client in self.clients.values() {
            // Full: it does not read, and its connection is about to be closed for it.
            let _ = client.out.try_send(Arc::clone(&text));
        }
    }

    fn tell_one(&self, client: ClientId, answer: &Answer) {
        if let Some(client) = self.clients.get(&client) {
            let _ = client.out.try_send(message::text(answer).into());
        }
    }
}

/// Milliseconds since 1970.
fn now_ms() -> u64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    u64::try_from(since.as_millis()).unwrap_or(u64::MAX)
}
