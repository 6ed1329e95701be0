//! Loading, saving, renaming and deleting sessions and exercises, and making reports. All of these tasks take a while,
//! and therefore run on another thread. The simulation's thread begins each such task and takes its result.

use std::mem;
use std::path::Path;
use std::sync::{Arc, PoisonError};
use std::time::Instant;

use fenderline_live::message::{GalleryEntry, Reply};
use fenderline_live::{Creation, PresentFile, Refusal};

use super::Engine;
use super::kept_history::KeptHistory;
use crate::file_change::{FileChange, InUse, Wish};
use crate::gallery::Changed;
use crate::hub::ToEngine;
use crate::new_file::{Content, NewFile};
use crate::opening::{Outcome, Ready, Requester, Task, Work};
use crate::pacer::Pacer;
use crate::saved::ENDING;

/// Longest title of an exercise (bytes).
const LONGEST_TITLE: usize = 200;

impl Engine {
    /// Begins to open an entry of the gallery. The present session goes on until the new session is open.
    pub(super) fn load(&mut self, requester: Requester, file: String) -> Result<(), Refusal> {
        self.check_no_work()?;
        let path = self.gallery.path(&file);
        let path = path.ok_or_else(|| Refusal::new("the gallery has no scenario of this name"))?;
        let (path, former) = (path.to_owned(), self.recorder.path().to_owned());
        let recordings = (self.sessions.clone(), former);
        let work = Work::open(self.send_outcome(), requester, file, path, recordings);
        self.work = Some(work.map_err(Refusal::new)?);
        Ok(())
    }

    /// Begins to save a copy of the recording up to now.
    pub(super) fn save(&mut self, requester: Requester, name: &str) -> Result<(), Refusal> {
        self.check_no_work()?;
        self.session.mark();
        self.record();
        if self.recording_failed {
            return Err(Refusal::new("the session is no longer recorded"));
        }
        let copy = self.recorder.copy(name, self.session.end_line()).map_err(Refusal::new)?;
        self.work = Some(Work::save(self.send_outcome(), requester, copy).map_err(Refusal::new)?);
        Ok(())
    }

    /// Begins to save a new exercise that was made from choices.
    pub(super) fn create(&mut self, requester: Requester, of: Creation) -> Result<(), Refusal> {
        self.check_no_work()?;
        let Creation { name, exercise, replace } = of;
        let berth = match &exercise.berth_of {
            None => None,
            Some(file) => {
                let path = self.gallery.path(file).map(Path::to_owned);
                Some(path.ok_or_else(|| {
                    Refusal::new(format_args!("the gallery has no scenario {file}"))
                })?)
            }
        };
        let choices = Content::Choices(Box::new(exercise), berth);
        let file = NewFile::new(self.gallery.folder(), &name, choices, replace);
        let file = file.map_err(Refusal::new)?;
        self.work = Some(Work::create(self.send_outcome(), requester, file).map_err(Refusal::new)?);
        Ok(())
    }

    /// Begins to save the present state of the session as an exercise. A notice tells the instructor what the
    /// exercise's file leaves out.
    pub(super) fn save_exercise(
        &mut self,
        requester: Requester,
        (name, title): (&str, &str),
        replace: bool,
    ) -> Result<(), Refusal> {
        self.check_no_work()?;
        let title = title.trim();
        if title.is_empty() || title.len() > LONGEST_TITLE || title.contains(char::is_control) {
            return Err(Refusal::new(format_args!(
                "an exercise needs a title: one line of at most {LONGEST_TITLE} bytes"
            )));
        }
        let PresentFile { text, notes } = self.session.present_file(title)?;
        let content = Content::Text(text, self.session.source().files.clone());
        let file = NewFile::new(self.gallery.folder(), name, content, replace);
        let file = file.map_err(Refusal::new)?;
        let client = requester.client;
        self.work = Some(Work::create(self.send_outcome(), requester, file).map_err(Refusal::new)?);
        for text in notes {
            self.reply(client, &Reply::Notice { text });
        }
        Ok(())
    }

    /// Begins to rename, delete or put back a file of the gallery.
    pub(super) fn change_file(
        &mut self,
        requester: Requester,
        file: &str,
        wish: &Wish,
    ) -> Result<(), Refusal> {
        self.check_no_work()?;
        let (recording, scenario) = (self.recorder.path(), self.session.source().file.as_str());
        let in_use = InUse { recording, scenario };
        let change = FileChange::new(&self.gallery, in_use, file, wish).map_err(Refusal::new)?;
        let work = Work::change(self.send_outcome(), requester, change);
        self.work = Some(work.map_err(Refusal::new)?);
        Ok(())
    }

    /// Begins to make the report of the session up to now, for the branch that is shown.
    pub(super) fn report(&mut self, requester: Requester) -> Result<(), Refusal> {
        self.check_no_work()?;
        if self.session.branches()[self.session.current_branch()].ends_tick == 0 {
            return Err(Refusal::new("nothing is recorded yet: the session has no steps"));
        }
        self.session.mark();
        self.record();
        if self.recording_failed {
            return Err(Refusal::new("the session is no longer recorded"));
        }
        let recording = self.recorder.so_far(self.session.end_line());
        let of = (recording, self.session.current_branch());
        let work = Work::report(self.send_outcome(), requester, of, self.make_report);
        self.work = Some(work.map_err(Refusal::new)?);
        Ok(())
    }

    /// The function with which work on another thread sends its outcome to the simulation's thread.
    fn send_outcome(&self) -> impl FnOnce(Outcome) + Send + 'static {
        let hub = Arc::clone(&self.hub);
        move |outcome| {
            hub.send_to_engine(ToEngine::WorkDone(outcome));
        }
    }

    fn check_no_work(&self) -> Result<(), Refusal> {
        match &self.work {
            None => Ok(()),
            Some(work) => Err(Refusal::new(match &work.task {
                Task::Open(file) => format!("{file} is still being opened"),
                Task::Save => "the session is still being saved".to_owned(),
                Task::Report => "a report is still being made".to_owned(),
                Task::Create => "an exercise is still being saved".to_owned(),
                Task::Change => "a file is still being renamed or deleted".to_owned(),
            })),
        }
    }

    /// Takes the result of work on another thread.
    pub(super) fn work_done(&mut self, outcome: Outcome) {
        let Some(work) = self.work.take() else { return };
        let done = match outcome {
            Outcome::Opened(opened) => match *opened {
                Ok(ready) if work.is_stopped() => {
                    ready.recorder.discard();
                    Err(format!("{}: stopped", work.file().unwrap_or_default()))
                }
                Ok(ready) => self.take_over(&work.requester, ready),
                Err(why) => Err(why),
            },
            Outcome::Saved(saved) => {
                saved.map(|(path, entry)| self.saved(&work.requester, &path, entry))
            }
            Outcome::Created(created) => {
                created.map(|(path, entry)| self.created(&work.requester, &path, entry))
            }
            Outcome::Changed(changed) => {
                changed.map(|changed| self.file_changed(&work.requester, changed))
            }
            Outcome::Reported(report) => {
                report.map(|report| self.reported(&work.requester, report))
            }
            Outcome::Panicked => {
                Err("this program has a bug: see the server's standard error".to_owned())
            }
        };
        if let Err(reason) = done {
            let is_opening = work.file().is_some();
            let Requester { client, label, id } = work.requester;
            self.hub.log.refused(&format!("refused {label}: {reason}"));
            // The start of an opening was acknowledged already, so its number must not be used again.
            let id = id.filter(|_| !is_opening);
            self.reply(client, &Reply::Refused { id, reason });
        }
        self.publish_frame();
    }

    /// Keeps a report for the page that asked for it.
    fn reported(&self, requester: &Requester, report: String) {
        *self.hub.report.write().unwrap_or_else(PoisonError::into_inner) = Some(report.into());
        if let Some(id) = requester.id {
            self.reply(requester.client, &Reply::Ack { id, tick: self.session.tick() });
        }
    }

    /// Adds a new exercise to the gallery.
    fn created(&mut self, requester: &Requester, path: &Path, entry: GalleryEntry) {
        let text = format!("{} has saved the exercise {}", requester.label, entry.title);
        self.gallery.renew(path, entry);
        if let Some(id) = requester.id {
            self.reply(requester.client, &Reply::Ack { id, tick: self.session.tick() });
        }
        self.greet_all();
        self.notify_all(&text);
    }

    /// Shows a renamed file of the gallery under its new name, a deleted file among the deleted files, and a file that
    /// was put back in the list.
    fn file_changed(&mut self, requester: &Requester, changed: Changed) {
        for ended in self.ended.iter_mut().filter(|ended| **ended == changed.from) {
            ended.clone_from(&changed.to);
        }
        self.gallery.moved(changed);
        if let Some(id) = requester.id {
            self.reply(requester.client, &Reply::Ack { id, tick: self.session.tick() });
        }
        self.greet_all();
    }

    /// Adds a saved session to the gallery.
    fn saved(&mut self, requester: &Requester, path: &Path, entry: Option<GalleryEntry>) {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if let Some(entry) = entry {
            self.gallery.put(path, entry);
        }
        if let Some(id) = requester.id {
            self.reply(requester.client, &Reply::Ack { id, tick: self.session.tick() });
        }
        self.greet_all();
        let name = name.strip_suffix(ENDING).unwrap_or(&name);
        self.notify_all(&format!("saved as {name}"));
    }

    /// Ends the present session and continues with an opened session, which is paused.
    fn take_over(
        &mut self,
        requester: &Requester,
        Ready { opened, recorder, former }: Ready,
    ) -> Result<(), String> {
        self.end_recording();
        // If the ended session had a run, its recording can be opened again.
        let ended = mem::replace(&mut self.recorder, recorder).path().to_owned();
        if self.session.branches().iter().any(|branch| branch.ends_tick > 0)
            && let Some(entry) = former
        {
            self.gallery.put(&ended, entry);
        }
        self.ended.push(ended);
        self.session = opened.session;
        self.recording_failed = false;
        self.claims.clear();
        self.show_models();
        self.make_tokens().map_err(|e| e.to_string())?;
        self.events.clear();
        self.history = KeptHistory::default();
        self.predictor.reset();
        self.paused = true;
        // The former pace belonged to the former exercise.
        self.pacer = Pacer::new(self.session.simulation().setup().step_s, Instant::now());
        self.greet_all();
        let label = &requester.label;
        self.notify_all(&format!("{label} has loaded {}; it is paused", self.session.title()));
        // Long sentences over everybody's chart would hide the ship that is about to start.
        let t_s = self.session.simulation().time_s();
        for notice in &opened.notices {
            self.events.add(t_s, notice.clone());
        }
        match opened.notices.len() {
            0 => {}
            1 => self.notify_all(
                "There is a notice about the scenario: the log of the tab Alarms has it.",
            ),
            many => self.notify_all(&format!(
                "There are {many} notices about the scenario: the log of the tab Alarms has them."
            )),
        }
        Ok(())
    }
}
