//! Sums the loads and contact wrenches on each body, in a fixed order.

use fenderline_contact::Wrench;
use fenderline_contact::number::{greater, lesser};

use fenderline_world::setup::Load;

/// Mean wrench of a load over the step `[t, t + step]`. A load that begins or ends within the step counts with the
/// share of the step in which it acts. Because of this share of the step, the impulse of a load does not depend on the
/// time step. A load that acts in the whole step is returned unchanged, bit for bit.
pub(crate) fn mean_load(load: &Load, t_s: f64, step_s: f64) -> Wrench {
    if load.from_s <= t_s && load.until_s >= t_s + step_s {
        return Wrench { force_n: load.force_n, moment_nm: load.moment_nm };
    }
    let acts_s = greater(lesser(load.until_s, t_s + step_s) - greater(load.from_s, t_s), 0.0);
    let share = lesser(acts_s / step_s, 1.0);
    Wrench { force_n: load.force_n * share, moment_nm: load.moment_nm * share }
}

/// Computes the sum of the loads on each body in the step, in the given order of the loads.
pub(crate) fn gather_loads(loads: &[Load], t_s: f64, step_s: f64, into: &mut [Wrench]) {
    into.fill(Wrench::default());
    for load in loads {
        let wrench = mean_load(load, t_s, step_s);
        into[load.body].force_n += wrench.force_n;
        into[load.body].moment_nm += wrench.moment_nm;
    }
}

/// Adds the external wrench on each body. A wrench on a fixed body has no effect.
pub(crate) fn add_external(external: &[Wrench], into: &mut [Wrench]) {
    for (load, wrench) in into.iter_mut().zip(external) {
        load.force_n += wrench.force_n;
        load.moment_nm += wrench.moment_nm;
    }
}

/// Computes the sum of load and contact wrench for each body.
pub(crate) fn gather(loads: &[Wrench], contact: &[Wrench], into: &mut [Wrench]) {
    for ((sum, load), contact) in into.iter_mut().zip(loads).zip(contact) {
        sum.force_n = load.force_n + contact.force_n;
        sum.moment_nm = load.moment_nm + contact.moment_nm;
    }
}
