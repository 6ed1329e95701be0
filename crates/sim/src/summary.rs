//! Running totals of a run, per pair of bodies.

use fenderline_contact::Contact;

use crate::record::StepRecord;

/// What happened between two bodies in a run. Peaks are the true ones of every step.
#[derive(Clone, Debug, PartialEq)]
pub struct PairSummary {
    /// Indices into the set-up's bodies.
    pub bodies: [usize; 2],
    /// Start of the first step in which they touched (s).
    pub first_touch_s: f64,
    /// Start of the last step in which they touched (s).
    pub last_touch_s: f64,
    /// Largest sum over the patches of their peak N (N), sub-steps included.
    pub peak_normal_force_n: f64,
    /// When (s).
    pub peak_normal_force_at_s: f64,
    /// Largest depth of a patch (m).
    pub peak_depth_m: f64,
    /// When (s).
    pub peak_depth_at_s: f64,
    /// ∫ N dt (N·s): what the normal forces changed of the bodies' momentum.
    pub impulse_ns: f64,
    /// V_n in the first touching step, positive approaching (m/s).
    pub approach_speed_mps: f64,
    /// −V_n at the end of the last touching step, along that step's normal: positive leaving (m/s).
    pub final_speed_mps: f64,
    /// Work of the normal forces on the two bodies (J).
    pub normal_work_j: f64,
    /// Work of the tangential forces on the two bodies (J).
    pub tangential_work_j: f64,
    /// True when they touch in the run's last step.
    pub touching_at_end: bool,
}

/// Collects [`PairSummary`]s step by step, in the order of first touch.
#[derive(Clone, Debug, Default)]
pub(crate) struct Summaries {
    pub(crate) pairs: Vec<PairSummary>,
}

impl Summaries {
    /// Books one step.
    pub(crate) fn book(&mut self, record: &StepRecord<'_>) {
        for pair in &mut self.pairs {
            pair.touching_at_end = false;
        }
        let mut contacts = record.contacts;
        while let Some(first) = contacts.first() {
            // A pair's patches stand together.
            let bodies = [first.body_1.0 as usize, first.body_2.0 as usize];
            let count = contacts.iter().take_while(|c| same_pair(c, first)).count();
            let (own, rest) = contacts.split_at(count);
            contacts = rest;
            let pair = self.pair(bodies, record.t_s, first.v_normal_mps);
            book_touch(pair, own, record);
        }
        for work in record.contact_energies {
            let Some(pair) = self.pairs.iter_mut().find(|p| p.bodies == work.bodies) else {
                continue; // touched only at a later stage of Runge-Kutta; the next step sees it
            };
            pair.impulse_ns += work.normal_impulse_ns;
            pair.normal_work_j += work.normal_j;
            pair.tangential_work_j += work.tangential_j;
        }
    }

    fn pair(&mut self, bodies: [usize; 2], t_s: f64, approach_speed_mps: f64) -> &mut PairSummary {
        let index = self.pairs.iter().position(|p| p.bodies == bodies).unwrap_or_else(|| {
            self.pairs.push(PairSummary {
                bodies,
                first_touch_s: t_s,
                last_touch_s: t_s,
                peak_normal_force_n: 0.0,
                peak_normal_force_at_s: t_s,
                peak_depth_m: 0.0,
                peak_depth_at_s: t_s,
                impulse_ns: 0.0,
                approach_speed_mps,
                final_speed_mps: 0.0,
                normal_work_j: 0.0,
                tangential_work_j: 0.0,
                touching_at_end: false,
            });
            self.pairs.len() - 1
        });
        &mut self.pairs[index]
    }
}

fn same_pair(a: &Contact, b: &Contact) -> bool {
    (a.body_1, a.body_2) == (b.body_1, b.body_2)
}

fn book_touch(pair: &mut PairSummary, own: &[Contact], record: &StepRecord<'_>) {
    pair.last_touch_s = record.t_s;
    pair.touching_at_end = true;
    let force_n: f64 = own.iter().map(|c| c.peak_normal_force_n).sum();
    if force_n > pair.peak_normal_force_n {
        pair.peak_normal_force_n = force_n;
        pair.peak_normal_force_at_s = record.t_s;
    }
    for contact in own {
        if contact.peak_depth_m > pair.peak_depth_m {
            pair.peak_depth_m = contact.peak_depth_m;
            pair.peak_depth_at_s = record.t_s;
        }
    }
    // Of the patch that presses hardest, with the bodies' speeds at the end of the step.
    let main = own
        .iter()
        .fold(own[0], |main, c| if c.normal_force_n > main.normal_force_n { *c } else { main });
    let [after_1, after_2] = pair.bodies.map(|body| record.states_after[body]);
    let closing = (after_1.velocity_mps + main.arm_1_m.spun_by(after_1.yaw_rate_radps))
        - (after_2.velocity_mps + main.arm_2_m.spun_by(after_2.yaw_rate_radps));
    pair.final_speed_mps = -closing.dot(main.normal);
}
