//! A run that nobody steers. Pages get the same messages from a watched run as from a session.

use fenderline_sim::exercise::{Assessment, ExerciseSetup};
use fenderline_sim::{SimError, Simulation, StepRecord};

use crate::action::COMMAND_LIMITS;
use crate::berth::berth_info;
use crate::cast::Cast;
use crate::exercise;
use crate::frame;
use crate::info::Info;
use crate::message::{self, EventNow, FenderNow, Hello, PROTOCOL, Role, RunState};
use crate::now::Now;

/// A simulation that pages show while it runs. A watched simulation has no commands, recording or branches.
#[derive(Clone, Debug)]
pub struct Watched {
    title: String,
    file: String,
    cast: Cast,
    info: Info,
    now: Now,
    /// The events since the last frame (message with the present state) was made.
    events: Vec<EventNow>,
}

impl Watched {
    /// Watches a simulation from before its first step. Pages show `title`, the title of the run, and `file`, the name
    /// of the scenario's file.
    #[must_use]
    pub fn new(
        simulation: Simulation,
        exercise: Option<ExerciseSetup>,
        title: String,
        file: String,
    ) -> Watched {
        let cast = Cast::of(simulation.setup());
        let info = Info::of(simulation.setup(), &cast);
        let now = Now::before_the_first_step(simulation, exercise);
        Watched { title, file, cast, info, now, events: Vec::new() }
    }

    /// The watched simulation in its present state.
    #[must_use]
    pub fn simulation(&self) -> &Simulation {
        &self.now.simulation
    }

    /// Takes one step and hands the record of the step to `each`.
    ///
    /// # Errors
    /// The errors of [`Simulation::step`]. A step that fails changes nothing.
    pub fn step(&mut self, each: impl FnOnce(&StepRecord<'_>)) -> Result<(), SimError> {
        let Now { simulation, seen, tick, .. } = &mut self.now;
        let record = simulation.step()?;
        seen.keep(&record);
        each(&record);
        *tick += 1;
        let t_s = self.now.simulation.time_s();
        let ending = self.now.mark_exercise();
        self.events.extend(ending.map(|text| EventNow { t_s, text: text.to_owned() }));
        Ok(())
    }

    /// Keeps the alarms and events of the last step for the next frame. Call this after every step of a run that pages
    /// show, because a contact during a single step raises an alarm too. A run that no page shows can leave these calls
    /// out and save their cost.
    pub fn note(&mut self) {
        frame::note_alarms(&mut self.now, &self.cast, &self.info);
        let Now { simulation, seen, .. } = &self.now;
        let t_s = simulation.time_s();
        let texts = seen.events(simulation.setup());
        self.events.extend(texts.map(|text| EventNow { t_s, text }));
    }

    /// The message `hello` from which a page is built, as text.
    #[must_use]
    pub fn hello(&self) -> String {
        let Watched { info, title, file, .. } = self;
        message::text(&Hello {
            protocol: PROTOCOL,
            role: &Role::Observer,
            title,
            file,
            step_s: self.now.simulation.setup().step_s,
            bodies: &info.bodies,
            vessels: &info.vessels,
            fenders: &info.fenders,
            lines: &info.lines,
            anchors: &info.anchors,
            bollards: &info.bollards,
            tugs: &info.tugs,
            traffic: &info.traffic,
            orders: &info.orders,
            telegraph: &info.telegraph,
            limits: COMMAND_LIMITS,
            mine: vec![],
            claims: &[],
            gallery: &[],
            berth: info.berth.as_ref().map(berth_info),
            depth_m: info.depth_m,
            highest_water_m: info.highest_water_m,
            clearance_datum_m: info.clearance_datum_m,
            sea: &info.sea,
            daylight: info.daylight,
            rain: info.rain,
            chart: &info.chart,
            ghost: None,
            exercise: self.exercise().map(|of| exercise::info(of, self.simulation().setup())),
            links: None,
            library: None,
            deleted: None,
        })
    }

    /// The JSON of the frame of the present state, with the events since the last frame. A watched run has no pace and
    /// no wall time: `at_ms` is 0 and `paused` is true.
    #[must_use]
    pub fn frame(&mut self) -> String {
        let run = RunState {
            paused: true,
            pace: 1.0,
            late_ticks: 0,
            latest_ms: 0.0,
            branch: 0,
            branches: vec![],
            last_tick: self.now.tick,
            clients: 0,
            opening: None,
        };
        let frame = frame::frame(&self.now, &self.cast, &self.info, 0, run);
        let events = std::mem::take(&mut self.events);
        let setup = self.simulation().setup();
        let marks = self.exercise().map(|of| message::text(&exercise::marks(of, setup)));
        message::with_events(&message::text(&frame), &events, marks.as_deref())
    }

    /// The exercise of the watched run, if the scenario has one.
    #[must_use]
    pub fn exercise(&self) -> Option<&Assessment> {
        self.now.exercise.as_ref()
    }

    /// The present state of all fenders of the set-up.
    #[must_use]
    pub fn fenders(&self) -> Vec<FenderNow> {
        self.now.seen.fenders(&self.now.simulation)
    }

    /// The verdict on the run up to the present state, as text.
    #[must_use]
    pub fn verdict(&self) -> String {
        message::text(&frame::verdict(&self.now.simulation))
    }

    /// The fingerprint of the present state, in hexadecimal: see [`crate::Session::bits`].
    #[must_use]
    pub fn bits(&self) -> String {
        crate::session::bits(&self.now.simulation)
    }
}
