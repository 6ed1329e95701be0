//! Summaries of a run, one per pair of bodies that touched.

use fenderline_contact::Contact;

use fenderline_world::record::StepRecord;

/// Summary of the contact between two bodies. The peaks include the peaks in sub-steps, between the ends of steps.
#[derive(Clone, Debug, PartialEq)]
pub struct PairSummary {
    /// Indices of the two bodies in the list of bodies of the set-up.
    pub bodies: [usize; 2],
    /// Start of the first step in which the two bodies touched (s).
    pub first_touch_s: f64,
    /// Start of the last step in which the two bodies touched (s).
    pub last_touch_s: f64,
    /// Largest normal force (N). In each step the peak forces of all patches of the pair are added.
    pub peak_normal_force_n: f64,
    /// Start of the step with the largest normal force (s).
    pub peak_normal_force_at_s: f64,
    /// Largest penetration of a patch, or deflection of a fender (m).
    pub peak_depth_m: f64,
    /// Index into the set-up's fenders of the fender with the deflection `peak_depth_m`; `None` if `peak_depth_m` is a
    /// penetration.
    pub peak_depth_fender: Option<usize>,
    /// Start of the step with the largest penetration or deflection (s).
    pub peak_depth_at_s: f64,
    /// Impulse of the normal forces between the two bodies, ∫ N dt (N·s).
    pub impulse_ns: f64,
    /// Normal speed V_n of the two bodies at their first contact, positive when they approach each other (m/s).
    pub approach_speed_mps: f64,
    /// Normal speed −V_n of the two bodies at the end of the last step with contact, along the normal of that step,
    /// positive when they separate (m/s).
    pub final_speed_mps: f64,
    /// Work of the normal forces on the two bodies (J).
    pub normal_work_j: f64,
    /// Work of the tangential forces on the two bodies (J).
    pub tangential_work_j: f64,
    /// True if the bodies are in contact in the last step of the run.
    pub touching_at_end: bool,
}

/// Builds one [`PairSummary`] for each pair of bodies, in the order of first touch.
#[derive(Clone, Debug, Default)]
pub struct Summaries {
    /// The summaries of the pairs, in the order of first touch.
    pub pairs: Vec<PairSummary>,
}

impl Summaries {
    /// Adds one step.
    pub fn add(&mut self, record: &StepRecord<'_>) {
        for pair in &mut self.pairs {
            pair.touching_at_end = false;
        }
        let mut contacts = record.contacts;
        while let Some(first) = contacts.first() {
            // The patches of a pair are adjacent in the list.
            let bodies = [first.body_1.0 as usize, first.body_2.0 as usize];
            let count = contacts.iter().take_while(|c| same_pair(c, first)).count();
            let (own, rest) = contacts.split_at(count);
            contacts = rest;
            let pair = self.pair(bodies, record.t_s, first.v_normal_mps);
            add_touch(pair, own, record);
        }
        for work in record.contact_energies {
            let Some(pair) = self.pairs.iter_mut().find(|p| p.bodies == work.bodies) else {
                continue; // in contact only at a later Runge-Kutta stage: the next step adds the pair
            };
            pair.impulse_ns += work.normal_impulse_ns;
            pair.normal_work_j += work.normal_j;
            pair.tangential_work_j += work.tangential_j;
        }
    }

    /// The summary of a pair of bodies; the first contact of the pair creates the summary.
    fn pair(&mut self, bodies: [usize; 2], t_s: f64, approach_speed_mps: f64) -> &mut PairSummary {
        let index = self.pairs.iter().position(|p| p.bodies == bodies).unwrap_or_else(|| {
            self.pairs.push(PairSummary {
                bodies,
                first_touch_s: t_s,
                last_touch_s: t_s,
                peak_normal_force_n: 0.0,
                peak_normal_force_at_s: t_s,
                peak_depth_m: 0.0,
                peak_depth_fender: None,
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

/// Updates the summary of a pair of bodies that touch in this step.
fn add_touch(pair: &mut PairSummary, own: &[Contact], record: &StepRecord<'_>) {
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
            pair.peak_depth_fender = contact.fender.map(|fender| fender.0 as usize);
            pair.peak_depth_at_s = record.t_s;
        }
    }
    // The final speed is the speed at the patch with the largest force, from the velocities at the end of the step.
    let mut main = &own[0];
    for contact in own {
        if contact.normal_force_n > main.normal_force_n {
            main = contact;
        }
    }
    let [after_1, after_2] = pair.bodies.map(|body| record.states_after[body]);
    let closing = (after_1.velocity_mps + main.arm_1_m.spun_by(after_1.yaw_rate_radps))
        - (after_2.velocity_mps + main.arm_2_m.spun_by(after_2.yaw_rate_radps));
    pair.final_speed_mps = -closing.dot(main.normal);
}
