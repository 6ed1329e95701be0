//! The simulation's thread. The simulation's thread steps the session at the pace of wall time, carries out the
//! commands of clients and publishes the latest frame, which is the message with the present state. The simulation's
//! thread waits for nothing except the clock: a slow client misses frames, and a flood of commands is refused.

mod chart_output;
mod client;
mod clients;
mod clock;
mod commands;
mod crowd;
mod event_log;
mod files;
mod history;
mod kept_history;
mod names;
mod predictor;
mod recording;
mod seats;
mod steering;
mod trials;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use fenderline_live::message::{self, Frame, PlannedNow, Reply, Role, RunState};
use fenderline_live::{Session, StepError};
use fenderline_nautical::ChartOrigin;

use self::chart_output::ChartOutput;
use self::client::Client;
use self::clock::unix_ms;
use self::crowd::Crowd;
use self::event_log::EventLog;
use self::kept_history::KeptHistory;
use self::predictor::Predictor;
use self::trials::Trials;
use super::claims::{Claims, ClientId};
use super::gallery::{Gallery, Opened};
use super::hub::{Hub, InFog, Published, Text, ToEngine};
use super::kept_seats::Keeper;
use super::opening::{MakeReport, Work};
use super::pacer::Pacer;
use super::recorder::Recorder;

/// Least wall time between two frames (messages with the present state) for the pages, even if the simulation runs
/// faster.
const BETWEEN_FRAMES: Duration = Duration::from_millis(33);
/// Wall time between two frames of a paused session. A paused session still sends frames, so that a page knows
/// that the server is running.
/// While a file is being opened, frames come more often, to show the progress.
const BETWEEN_PAUSED_FRAMES: Duration = Duration::from_secs(1);
const BETWEEN_PROGRESS_FRAMES: Duration = Duration::from_millis(200);

/// Everything that the simulation's thread holds.
pub(crate) struct Engine {
    hub: Arc<Hub>,
    session: Session,
    gallery: Gallery,
    /// Folder of the recordings.
    sessions: PathBuf,
    make_report: MakeReport,
    recorder: Recorder,
    /// Files of the recordings of earlier sessions.
    ended: Vec<PathBuf>,
    recording_failed: bool,
    /// Keeps the links and the holders of controls in a file beside the session's recording.
    keeper: Keeper,
    /// Work that runs on another thread: opening a scenario or a session, saving a session, or making a report.
    work: Option<Work>,
    pacer: Pacer,
    paused: bool,
    /// True if the session is paused until the first client joins.
    starts_with_first_client: bool,
    claims: Claims,
    clients: BTreeMap<ClientId, Client>,
    crowd: Crowd,
    events: EventLog,
    /// Time at which the last frame was published.
    published: Instant,
    predictor: Predictor,
    trials: Trials,
    history: KeptHistory,
    /// The planned events that the last message to the instructors had.
    planned: Vec<PlannedNow>,
    /// Output for chart programs; `None` if no chart programs are served.
    chart: Option<ChartOutput>,
}

impl Engine {
    /// Makes an engine that is ready to run, and begins the recording. `chart` is `None` if no chart programs are
    /// served; otherwise it contains the origin of positions that the user gave for them.
    ///
    /// # Errors
    /// Fails if the recording's file cannot be written, or if the system gives no random numbers.
    pub(crate) fn new(
        hub: Arc<Hub>,
        mut opened: Opened,
        gallery: Gallery,
        sessions: PathBuf,
        make_report: MakeReport,
        paused: bool,
        chart: (bool, Option<ChartOrigin>),
    ) -> Result<Engine, String> {
        let file = opened.session.source().file.clone();
        let recorder = Recorder::begin(&sessions, &file, &mut opened)?;
        let (session, seats) = (opened.session, opened.seats);
        let now = Instant::now();
        let keeper = Keeper::start(hub.log.notify_function());
        let mut engine = Engine {
            pacer: Pacer::new(session.simulation().setup().step_s, now),
            hub,
            session,
            gallery,
            sessions,
            make_report,
            recorder,
            ended: Vec::new(),
            recording_failed: false,
            keeper: keeper.map_err(|e| format!("there is no thread that keeps the links: {e}"))?,
            work: None,
            paused: true,
            starts_with_first_client: !paused,
            claims: Claims::default(),
            clients: BTreeMap::new(),
            crowd: Crowd::new(now),
            events: EventLog::new(),
            published: now,
            predictor: Predictor::default(),
            trials: Trials::default(),
            history: KeptHistory::default(),
            planned: Vec::new(),
            chart: chart.0.then(|| ChartOutput::new(chart.1)),
        };
        if let Some(seats) = seats {
            engine.take_seats(&seats);
        }
        engine
            .make_tokens()
            .map_err(|e| format!("there are no random numbers for the links: {e}"))?;
        engine.show_models();
        engine.keep_seats();
        Ok(engine)
    }

    /// The file to which the present session is recorded.
    pub(crate) fn recording(&self) -> &Path {
        self.recorder.path()
    }

    /// Runs the session until a message stops the thread. Returns the files of the recordings that the thread has made,
    /// in their order.
    pub(crate) fn run(mut self, messages: &Receiver<ToEngine>) -> Vec<PathBuf> {
        self.publish_frame();
        loop {
            match messages.recv_timeout(self.wait()) {
                Ok(ToEngine::Stop) | Err(RecvTimeoutError::Disconnected) => break,
                Ok(message) => self.take(message),
                Err(RecvTimeoutError::Timeout) => {
                    if self.paused && self.published.elapsed() >= self.between_paused_frames() {
                        self.publish_frame();
                    }
                }
            }
            // The time is read again after each message, so that a flood of messages delays no tick.
            let now = Instant::now();
            if !self.paused && self.pacer.is_due(now) {
                self.pacer.begin(now);
                self.tick();
            }
            self.show_crowd();
            if !self.clients.is_empty() {
                self.predictor.start_if_due(now, self.paused, &self.session, &self.hub);
            }
            if let Some(chart) = &mut self.chart {
                chart.send_if_due(now, &self.session, &self.hub);
            }
        }
        self.end_recording();
        if let Some(work) = self.work.take() {
            work.finish();
        }
        self.ended.push(self.recorder.path().to_owned());
        self.ended
    }

    /// Longest time to wait for a message of clients.
    fn wait(&self) -> Duration {
        let now = Instant::now();
        let wait =
            if self.paused { self.between_paused_frames() / 2 } else { self.pacer.wait(now) };
        match self.crowd.due_at(self.published) {
            Some(at) => wait.min(at.saturating_duration_since(now)),
            None => wait,
        }
    }

    fn between_paused_frames(&self) -> Duration {
        if self.work.is_some() { BETWEEN_PROGRESS_FRAMES } else { BETWEEN_PAUSED_FRAMES }
    }

    fn take(&mut self, message: ToEngine) {
        match message {
            ToEngine::Join { client, role, kind, hello, out } => {
                self.join(client, (role, kind), hello, out);
            }
            ToEngine::Leave { client } => self.leave(client),
            ToEngine::Command { client, id, request } => {
                self.hub.command_taken();
                self.command(client, id, request);
            }
            ToEngine::Steer { client, order } => {
                self.hub.command_taken();
                self.steer(client, order);
            }
            ToEngine::Silent { client } => self.silent(client),
            ToEngine::WorkDone(outcome) => self.work_done(outcome),
            ToEngine::Stop => {}
        }
    }

    /// Takes one step of the session.
    fn tick(&mut self) {
        let was_rewound = self.session.is_rewound();
        let was_open = self.exercise_is_open();
        if let Err(e) = self.session.step() {
            self.paused = true;
            let hint = match &e {
                StepError::Simulation(_) => "Rewind it.",
                StepError::Full(_) => "Save the session, and open its scenario anew.",
            };
            self.notify_all(&format!("The simulation cannot go on: {e}. {hint}"));
        }
        if was_rewound && !self.session.is_rewound() {
            self.paused = true;
            self.notify_all("The recorded part has ended: resume to go on from its end.");
        }
        if was_open && !was_rewound && !self.exercise_is_open() {
            // Without an instructor nobody could resume, and the tugs would push for ever.
            let instructed = self.clients.values().any(|client| client.role == Role::Instructor);
            self.paused = self.paused || instructed;
            self.notify_all(match instructed {
                true => "The exercise has ended: the instructor resumes to go on without marks.",
                false => "The exercise has ended, and the run goes on without marks.",
            });
        }
        self.record();
        if self.paused || self.published.elapsed() >= BETWEEN_FRAMES {
            self.publish_frame();
        }
    }

    /// True while an exercise goes on.
    fn exercise_is_open(&self) -> bool {
        self.session.exercise().is_some_and(|exercise| exercise.state().ended_s().is_none())
    }

    /// Publishes the present state to all clients.
    fn publish_frame(&mut self) {
        for (t_s, text) in self.session.take_events() {
            self.events.add(t_s, text);
        }
        let frame = self.frame();
        let mut roles: Vec<Role> =
            self.clients.values().map(|client| client.role.clone()).collect();
        roles.sort();
        roles.dedup();
        // A role does not receive what fog hides from it.
        let in_fog = roles.iter().filter_map(|role| {
            let seen = self.session.in_fog(&frame, role)?;
            let hidden = self.session.hidden_vessels(role);
            Some(InFog { role: role.clone(), frame: message::text(&seen).into(), hidden })
        });
        let in_fog = in_fog.collect();
        let frame = message::text(&frame).into();
        let events = self.events.latest();
        let (roles, marks) = (roles.into(), self.marks());
        self.hub.frames.send_replace(Some(Published { frame, roles, in_fog, events, marks }));
        self.crowd.is_shown();
        self.published = Instant::now();
        self.tell_planned();
    }

    /// The frame of the present state for roles from which nothing is hidden.
    fn frame(&self) -> Frame {
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
        self.session.frame(unix_ms(), run)
    }

    /// The score and the deductions of the exercise, as JSON; `None` without an exercise.
    fn marks(&self) -> Option<Text> {
        self.session.exercise_marks().map(|marks| message::text(&marks).into())
    }

    /// Sends the planned events to the instructors if they have changed. Only instructors may know the planned events.
    fn tell_planned(&mut self) {
        let events = self.session.planned();
        if events != self.planned {
            self.planned = events;
            let instructors = self.clients.iter().filter(|(_, of)| of.role == Role::Instructor);
            let instructors: Vec<ClientId> = instructors.map(|(id, _)| *id).collect();
            instructors.into_iter().for_each(|id| self.tell_planned_to(id));
        }
    }

    /// Sends the planned events to one instructor.
    fn tell_planned_to(&self, client: ClientId) {
        self.reply(client, &Reply::Planned { events: self.planned.clone() });
    }
}
