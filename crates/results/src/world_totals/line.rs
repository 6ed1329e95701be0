//! Totals of a mooring line over a run.

use fenderline_contact::number::greater;
use fenderline_sim::{BollardSetup, LineEnd, Mooring, MooringSetup};

use super::{Lasting, Peak};

/// Totals of one line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineTotals {
    /// Start of the first step in which the mooring line was made fast (s).
    pub made_fast_s: Option<f64>,
    /// Peak tension at the ship's end (N); for a parted line, the tension at which it parted.
    pub tension_n: Peak,
    /// Break load of the line (N), that of the weaker of rope and tail; `None` before the line is made fast.
    pub break_load_n: Option<f64>,
    /// Working load of the mooring line (N), if its kind has a working load.
    pub working_load_n: Option<f64>,
    /// Time for which the tension was above the working load.
    pub over_working: Lasting,
    /// Length of mooring line that the winch brake let run out under load (m).
    pub rendered_m: f64,
    /// Time at which the line parted (s).
    pub parted_s: Option<f64>,
    /// Tension of the line at the end of the run (N).
    pub last_tension_n: f64,
    /// Whether the mooring line is made fast at the end of the run.
    pub is_fast: bool,
    /// Position of the mooring line's shore end when the line was last made fast.
    pub end: Option<LineEnd>,
    /// The bollard to which an order last sent the line, as an index into
    /// [`fenderline_sim::WorldSetup::bollards`].
    pub bollard: Option<usize>,
}

impl LineTotals {
    pub(super) fn add(
        &mut self,
        (t_s, step_s): (f64, f64),
        (setup, bollards): (&MooringSetup, &[BollardSetup]),
        now: &Mooring,
    ) {
        let Some((line, state)) = &now.line else {
            (self.is_fast, self.last_tension_n) = (false, 0.0);
            return;
        };
        if self.made_fast_s.is_none() {
            self.made_fast_s = Some(t_s);
            self.break_load_n = Some(line.break_load_n());
            self.working_load_n = setup.line.kind.working_load_n();
        }
        self.is_fast = !state.parted;
        (self.end, self.bollard) = (now.end(setup, bollards), now.bollard);
        self.last_tension_n = now.load.tension_n;
        if state.parted && self.parted_s.is_none() {
            self.parted_s = Some(t_s);
        }
        self.tension_n.raise(greater(now.load.tension_n, now.load.parted_at_n.unwrap_or(0.0)), t_s);
        let is_over = self.working_load_n.is_some_and(|limit_n| now.load.tension_n > limit_n);
        self.over_working.count(is_over, step_s);
        self.rendered_m += now.load.winch.rendered_m;
    }

    /// Peak tension as a share of the break load; `None` before the line is made fast.
    pub fn share_of_break_load(&self) -> Option<f64> {
        self.break_load_n.map(|break_load_n| self.tension_n.value / break_load_n)
    }

    /// Peak tension as a share of the working load; `None` if the line has no working load.
    pub fn share_of_working_load(&self) -> Option<f64> {
        self.working_load_n.map(|load_n| self.tension_n.value / load_n)
    }

    /// The verdict on the line.
    pub fn verdict(&self) -> LineVerdict {
        if self.parted_s.is_some() {
            LineVerdict::Parted
        } else if self.over_working.s() > 0.0 {
            LineVerdict::OverWorking
        } else if self.rendered_m > 0.0 {
            LineVerdict::Rendered
        } else if self.made_fast_s.is_none() {
            LineVerdict::NotMadeFast
        } else {
            LineVerdict::Ok
        }
    }
}

/// The verdict on a line, from best to worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LineVerdict {
    /// The mooring line was never made fast in this run.
    NotMadeFast,
    /// The line was made fast, and its tension stayed within the working load.
    Ok,
    /// The brake of the winch let the line run out under load (it rendered).
    Rendered,
    /// The tension was above the working load.
    OverWorking,
    /// The line parted.
    Parted,
}

impl LineVerdict {
    /// The verdict in words.
    pub fn text(self) -> &'static str {
        match self {
            LineVerdict::NotMadeFast => "not made fast",
            LineVerdict::Ok => "OK",
            LineVerdict::Rendered => "rendered",
            LineVerdict::OverWorking => "over working load",
            LineVerdict::Parted => "PARTED",
        }
    }

    /// The verdict in `summary.json`.
    pub fn key(self) -> &'static str {
        match self {
            LineVerdict::NotMadeFast => "not_made_fast",
            LineVerdict::Ok => "ok",
            LineVerdict::Rendered => "rendered",
            LineVerdict::OverWorking => "over_working_load",
            LineVerdict::Parted => "parted",
        }
    }
}
