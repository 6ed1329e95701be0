//! Records the components of a normal force over time.

use fenderline_contact::ForceParts;

use crate::plot::Decimator;

/// The normal force N and its components over time: spring, stop, damper, and the part that the limiter took off (N).
#[derive(Clone, Debug, Default)]
pub(in crate::run_page) struct PartsTrace {
    pub(in crate::run_page) total_n: Decimator,
    pub(in crate::run_page) spring_n: Decimator,
    pub(in crate::run_page) stop_n: Decimator,
    pub(in crate::run_page) damper_n: Decimator,
    pub(in crate::run_page) limiter_n: Decimator,
}

impl PartsTrace {
    /// Notes that there was no force from the start of the run until `t_s`.
    pub(super) fn rest_until(&mut self, t_s: f64) {
        for part in [
            &mut self.total_n,
            &mut self.spring_n,
            &mut self.stop_n,
            &mut self.damper_n,
            &mut self.limiter_n,
        ] {
            part.rest_until(t_s);
        }
    }

    pub(super) fn push(&mut self, t_s: f64, parts: &ForceParts) {
        self.total_n.push(t_s, parts.total_n());
        self.spring_n.push(t_s, parts.spring_n);
        self.stop_n.push(t_s, parts.stop_n);
        self.damper_n.push(t_s, parts.damper_n);
        self.limiter_n.push(t_s, parts.limiter_n);
    }
}
