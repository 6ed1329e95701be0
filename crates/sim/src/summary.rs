//! Running totals of a run, per pair of bodies.

/// What happened between two bodies in a run. Peaks are the true ones of every step.
#[derive(Clone, Debug, PartialEq)]
pub struct PairSummary {
    /// Indices into the set-up's bodies.
    pub bodies: [usize; 2],
    /// Start of the first step in which they touched [s].
    pub first_touch_s: f64,
    /// Start of the last step in which they touched [s].
    pub last_touch_s: f64,
    /// Largest sum over the patches of N [N].
    pub peak_normal_force_n: f64,
    /// When [s].
    pub peak_normal_force_at_s: f64,
    /// Largest depth of a patch [m].
    pub peak_depth_m: f64,
    /// When [s].
    pub peak_depth_at_s: f64,
    /// Σ N Δt [N·s].
    pub impulse_ns: f64,
    /// V_n in the first touching step, positive approaching [m/s].
    pub approach_speed_mps: f64,
    /// −V_n at the end of the last touching step, along that step's normal: positive leaving [m/s].
    pub final_speed_mps: f64,
    /// Work of the normal forces on the two bodies [J].
    pub normal_work_j: f64,
    /// Work of the tangential forces on the two bodies [J].
    pub tangential_work_j: f64,
    /// True when they touch in the run's last step.
    pub touching_at_end: bool,
}
