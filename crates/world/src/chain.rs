//! Chains of fenders, and their loads in a run.
//!
//! A tension chain is part of the panel's law in the contact engine. Shear and weight chains follow from statics: they
//! take a part of the forces that the engine computes, and do not change these forces.

use fenderline_contact::number::greater;
use fenderline_contact::{Contact, Friction, Material, PanelMotion, TensionChain};

/// The kinds of chains of a fender, by the motion or load that a chain holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChainKind {
    /// A tension chain stops the panel from moving outward at the place of the chain.
    Tension,
    /// A shear chain holds the motion of the panel along the berth, in both directions.
    Shear,
    /// A weight chain holds the weight of the panel, and the vertical friction of a hull that sinks along the panel.
    Weight,
}

impl ChainKind {
    /// The name of this kind of chain in reports.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            ChainKind::Tension => "tension",
            ChainKind::Shear => "shear",
            ChainKind::Weight => "weight",
        }
    }
}

/// A chain of a fender. Slack, stiffness and break load of the chain are measured along the direction in which the
/// chain holds the panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainSetup {
    /// The motion or load that the chain holds.
    pub kind: ChainKind,
    /// Place of the chain along the panel, measured from the middle of the panel (m); 0 for shear and weight chains.
    pub at_m: f64,
    /// Motion of the panel before the chain holds (m); 0 for a weight chain.
    pub slack_m: f64,
    /// Stiffness of the chain (N/m).
    pub stiffness_npm: f64,
    /// Break load of the chain (N).
    pub break_load_n: f64,
}

/// The tension chains among the chains of a fender, in the form that the contact engine needs.
pub fn tension_chains(chains: &[ChainSetup]) -> Vec<TensionChain> {
    let of_kind = chains.iter().filter(|chain| chain.kind == ChainKind::Tension);
    of_kind
        .map(|chain| TensionChain {
            at_m: chain.at_m,
            slack_m: chain.slack_m,
            stiffness_npm: chain.stiffness_npm,
            break_load_n: chain.break_load_n,
        })
        .collect()
}

/// The load of a chain in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainSummary {
    /// The motion or load that the chain holds.
    pub kind: ChainKind,
    /// Largest tension of the chain (N). If the chain parted, this is the tension at which the chain parted.
    pub peak_tension_n: f64,
    /// Start of the step in which the chain had its largest tension (s).
    pub peak_tension_at_s: f64,
    /// The largest tension of the chain divided by its break load.
    pub share_of_break_load: f64,
    /// Start of the step in which the chain parted (s); `None` if the chain did not part.
    pub parted_at_s: Option<f64>,
    /// Largest tension of the chain within the last step (N). The tension is 0 if the fender was not touched in the
    /// last step, or if the chain had parted before.
    pub last_tension_n: f64,
}

/// The tension of a chain in one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainTension {
    /// Index of the chain's fender in the set-up.
    pub fender: usize,
    /// Index of the chain among the fender's chains.
    pub chain: usize,
    /// The motion or load that the chain holds.
    pub kind: ChainKind,
    /// Largest tension of the chain within the step (N). If the chain parted in this step, this is the tension at which
    /// the chain parted; if the chain had parted before, it is 0.
    pub peak_tension_n: f64,
    /// The largest tension of the chain in the step divided by its break load.
    pub share_of_break_load: f64,
    /// Whether the chain has parted, in this step or before.
    pub has_parted: bool,
}

impl ChainTension {
    /// The chain tensions of a touched fender in the step that was added last.
    pub fn of<'a>(
        fender: usize,
        setups: &'a [ChainSetup],
        chains: &'a [ChainSummary],
    ) -> impl Iterator<Item = ChainTension> + 'a {
        setups.iter().zip(chains).enumerate().map(move |(chain, (setup, now))| ChainTension {
            fender,
            chain,
            kind: now.kind,
            peak_tension_n: now.last_tension_n,
            share_of_break_load: now.last_tension_n / setup.break_load_n,
            has_parted: now.parted_at_s.is_some(),
        })
    }
}

impl ChainSummary {
    /// The summary of a chain that is first loaded at the time `t_s` (s).
    pub fn new(chain: &ChainSetup, t_s: f64) -> ChainSummary {
        ChainSummary {
            kind: chain.kind,
            peak_tension_n: 0.0,
            peak_tension_at_s: t_s,
            share_of_break_load: 0.0,
            parted_at_s: None,
            last_tension_n: 0.0,
        }
    }

    fn add(&mut self, setup: &ChainSetup, tension_n: f64, parts: bool, t_s: f64) {
        if self.parted_at_s.is_some() {
            return;
        }
        self.last_tension_n = greater(self.last_tension_n, tension_n);
        if tension_n > self.peak_tension_n {
            (self.peak_tension_n, self.peak_tension_at_s) = (tension_n, t_s);
            self.share_of_break_load = tension_n / setup.break_load_n;
        }
        self.parted_at_s = parts.then_some(t_s);
    }
}

/// Adds the tensions of a panel's chains in one step to the summaries of the chains.
pub fn add_tension(
    chains: &mut [ChainSummary],
    setups: &[ChainSetup],
    motion: &PanelMotion,
    t_s: f64,
) {
    let of_kind = chains.iter_mut().zip(setups).filter(|(c, _)| c.kind == ChainKind::Tension);
    let now = motion.peak_tensions_n.iter().zip(&motion.parted);
    for ((chain, setup), (&tension_n, &parts)) in of_kind.zip(now) {
        chain.add(setup, tension_n, parts, t_s);
    }
}

/// The load that shear and weight chains must carry in a step.
#[derive(Clone, Copy, Debug, Default)]
pub struct ChainLoad {
    /// Tangential force on the panel of the fender (N).
    pub tangential_n: f64,
    /// Vertical friction on the panel of the fender, positive down (N).
    pub vertical_n: f64,
}

/// Speed (m/s) below which the vertical friction of a hull that sinks past a panel is only partly developed, so that
/// the friction changes its direction smoothly through zero speed.
const SLOW_MPS: f64 = 0.01;

impl ChainLoad {
    /// The load on the chains from a hull that sinks at the speed `sinking_mps` (m/s) along a fender of the material
    /// `material`. The load on the chains is computed with the largest normal force of the step.
    pub fn of(contact: &Contact, material: &Material, sinking_mps: f64) -> ChainLoad {
        let (normal_n, along_mps) = (contact.peak_normal_force_n, contact.v_tangential_mps);
        let sliding_n = material.friction_dynamic * normal_n;
        let along_mps = if contact.friction == Friction::Slip { along_mps } else { 0.0 };
        let speed_mps =
            libm::sqrt(sinking_mps * sinking_mps + along_mps * along_mps + SLOW_MPS * SLOW_MPS);
        ChainLoad {
            tangential_n: contact.tangential_force_n.abs(),
            vertical_n: sliding_n * sinking_mps / speed_mps,
        }
    }
}

/// Adds the loads of a fender's shear and weight chains in a step.
pub fn add_others(
    chains: &mut [ChainSummary],
    setups: &[ChainSetup],
    load: ChainLoad,
    (shear_npm, weight_n): (f64, f64),
    t_s: f64,
) {
    let displaced_m = displacement_m(chains, setups, load.tangential_n, shear_npm);
    let bears = |c: &ChainSummary| c.kind == ChainKind::Weight && c.parted_at_s.is_none();
    let weight_chains = chains.iter().filter(|c| bears(c)).count() as f64;
    for (chain, setup) in chains.iter_mut().zip(setups) {
        let tension_n = match chain.kind {
            ChainKind::Tension => continue,
            ChainKind::Shear => setup.stiffness_npm * greater(displaced_m - setup.slack_m, 0.0),
            ChainKind::Weight => {
                greater(weight_n + load.vertical_n, 0.0) / greater(weight_chains, 1.0)
            }
        };
        chain.add(setup, tension_n, tension_n >= setup.break_load_n, t_s);
    }
}

/// How far a tangential force moves the panel against the shear stiffness of the fender and of the fender's shear
/// chains (m).
fn displacement_m(
    chains: &[ChainSummary],
    setups: &[ChainSetup],
    force_n: f64,
    shear_npm: f64,
) -> f64 {
    if shear_npm <= 0.0 {
        return 0.0;
    }
    let holds = |c: &ChainSummary| c.kind == ChainKind::Shear && c.parted_at_s.is_none();
    let own = || chains.iter().zip(setups).filter(|(c, _)| holds(c)).map(|(_, setup)| setup);
    // The force rises with the displacement. The taut chains are those whose slack is less than the displacement.
    let mut displaced_m = force_n / shear_npm;
    for _ in 0..=chains.len() {
        let taut = own().filter(|setup| setup.slack_m < displaced_m);
        let (stiffness_npm, held_n) = taut.fold((shear_npm, 0.0), |(k, n), setup| {
            (k + setup.stiffness_npm, n + setup.stiffness_npm * setup.slack_m)
        });
        displaced_m = (force_n + held_n) / stiffness_npm;
    }
    displaced_m
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHEAR: ChainSetup = ChainSetup {
        kind: ChainKind::Shear,
        at_m: 0.0,
        slack_m: 0.02,
        stiffness_npm: 1e7,
        break_load_n: 3e5,
    };

    /// Rubber of 3 MN/m and a chain of 10 MN/m with a slack of 20 mm, under 320 kN: x = (320 + 200)/13 = 40 mm, and the
    /// chain takes 200 kN.
    #[test]
    fn a_shear_chain_takes_what_is_beyond_its_slack() {
        let setups = [SHEAR];
        let mut chains = [ChainSummary::new(&SHEAR, 0.0)];
        let load = |tangential_n: f64| ChainLoad { tangential_n, vertical_n: 0.0 };
        add_others(&mut chains, &setups, load(50e3), (3e6, 0.0), 1.0);
        assert_eq!(chains[0].peak_tension_n, 0.0);
        add_others(&mut chains, &setups, load(320e3), (3e6, 0.0), 2.0);
        assert!((chains[0].peak_tension_n - 200e3).abs() < 1e-6, "{chains:?}");
        assert_eq!((chains[0].parted_at_s, chains[0].peak_tension_at_s), (None, 2.0));
        // Under 480 kN: x = 680/13 mm, and the chain takes 323 kN. It parts, and takes nothing afterwards.
        add_others(&mut chains, &setups, load(480e3), (3e6, 0.0), 3.0);
        assert_eq!(chains[0].parted_at_s, Some(3.0));
        assert!((chains[0].peak_tension_n - 1e7 * (0.68 / 13.0 - 0.02)).abs() < 1e-6);
        add_others(&mut chains, &setups, load(900e3), (3e6, 0.0), 4.0);
        assert_eq!(chains[0].peak_tension_at_s, 3.0);
    }

    /// Two chains carry 60 kN of weight and the friction of a hull that sinks. The weaker chain parts, and the other
    /// carries all.
    #[test]
    fn weight_chains_share_weight_and_friction() {
        let strong = ChainSetup { kind: ChainKind::Weight, slack_m: 0.0, ..SHEAR };
        let setups = [strong, ChainSetup { break_load_n: 75e3, ..strong }];
        let mut chains = setups.map(|setup| ChainSummary::new(&setup, 0.0));
        let load = |vertical_n: f64| ChainLoad { tangential_n: 0.0, vertical_n };
        add_others(&mut chains, &setups, load(0.0), (3e6, 60e3), 1.0);
        assert_eq!(chains.map(|c| c.peak_tension_n), [30e3, 30e3]);
        add_others(&mut chains, &setups, load(100e3), (3e6, 60e3), 2.0);
        assert_eq!(
            chains.map(|c| (c.peak_tension_n, c.parted_at_s)),
            [(80e3, None), (80e3, Some(2.0))]
        );
        add_others(&mut chains, &setups, load(100e3), (3e6, 60e3), 3.0);
        assert_eq!(chains[0].peak_tension_n, 160e3);
        // A hull that rises lifts the panel.
        add_others(&mut chains, &setups, load(-100e3), (3e6, 60e3), 4.0);
        assert_eq!(chains[0].peak_tension_n, 160e3);
    }
}
