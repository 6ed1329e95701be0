//! Writes the running session to its recording.

use super::Engine;

impl Engine {
    /// Appends new lines of the session to the recording's file. After the first failure nothing more is recorded, and
    /// the users get one notice.
    pub(super) fn record(&mut self) {
        let lines = self.session.take_lines();
        if lines.is_empty() || self.recording_failed {
            return;
        }
        if let Err(why) = self.recorder.add(&lines) {
            self.recording_failed = true;
            let text = format!("THE SESSION IS NO LONGER RECORDED, for this reason: {why}");
            self.hub.log.notify(&text);
            self.notify_all(&text);
        }
    }

    /// Writes the line that ends the recording.
    pub(super) fn end_recording(&mut self) {
        self.session.mark();
        self.record();
        if !self.recording_failed
            && let Err(why) = self.recorder.add(&self.session.end_line())
        {
            self.hub.log.notify(&format!("the recording could not be ended: {why}"));
        }
    }
}
