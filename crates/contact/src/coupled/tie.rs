//! One contact as the solve sees it: how it moves its two bodies, and what bounds its forces.

use crate::coupled::rows::Laws;
use crate::mass::{InverseMatrix, Seen};
use crate::number::{bounded, greater, lesser};
use crate::report::Friction;
use crate::state::Velocity;
use crate::touch::{Levers, Movers, Touch};
use crate::vec2::Vec2;

/// Sweeps of a contact that slides are damped where they would overshoot by more than this: below it they settle by
/// themselves, in less than 50.
const OVERSHOOTS: f64 = 0.5;

/// A contact's forces and all that a sweep needs, so that it reads nothing else but the bodies'
/// velocities.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tie {
    /// Ranks.
    pub(crate) a: u32,
    pub(crate) b: u32,
    /// What does not move is not pushed.
    a_floats: bool,
    b_floats: bool,
    /// What rests is not asked for its velocity.
    pub(crate) movers: Movers,
    /// As in [`Seen`].
    is_alike: bool,
    turning: f64,
    /// n, and the levers of n and t about each body's centre of gravity (m).
    pub(crate) along_n: Vec2,
    levers_a: Levers,
    levers_b: Levers,
    /// n·K n, t·K n and t·K t (1/kg).
    pub(crate) normal: f64,
    cross: f64,
    tangential: f64,
    /// n·K n without rotation (1/kg).
    pub(crate) linear: f64,
    /// κ: for how long its forces act on the velocities in this sub-step (s).
    pub(crate) kick_s: f64,
    /// ϑ: see [`implicit_share`].
    implicit: f64,
    /// The shear spring's force at V_t⁺ = 0 (N), and what it loses with V_t⁺: c = ϑ² k_s h (N·s/m).
    spring_at_rest_n: f64,
    spring_slope: f64,
    /// V_n and V_t at the start of the sub-step (m/s).
    pub(crate) normal_before_mps: f64,
    pub(crate) tangential_before_mps: f64,
    /// f, the normal law's force: N lies between 0 and it (N).
    pub(crate) law_n: f64,
    /// γ v_ref: V_n⁺ may not fall below its negative (m/s).
    pub(crate) rebound_mps: f64,
    /// The most that N may give the bodies in this sub-step (J).
    pub(crate) may_give_j: f64,
    /// And T (J).
    pub(crate) may_shear_j: f64,
    /// Stored energy that nothing holds: see [`super::let_go`] (J).
    pub(crate) unheld_j: f64,
    shear_stiffness_npm: f64,
    /// What T/N may come to while it sticks, and what it is while it slips.
    friction_holding: f64,
    friction_dynamic: f64,
    slide: Slide,
    /// The forces that sweeps begin with, until others are found (N).
    pub(crate) forces: Forces,
    /// V_n⁺ and V_t⁺ with those that are found (m/s).
    pub(crate) after_mps: (f64, f64),
}

/// N and T of a contact (N), and whether it slips.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Forces {
    pub(crate) normal_n: f64,
    pub(crate) tangential_n: f64,
    pub(crate) friction: Friction,
}

/// How a contact comes into a sub-step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Slide {
    /// It begins with it.
    #[default]
    Touches,
    Holds,
    Slides,
}

/// Where a normal force stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// At f.
    Full,
    /// Between, where V_n⁺ = −γ v_ref.
    Tight,
    /// At 0.
    Open,
}

/// Forces as lines: what they are more than now (N), and their slopes with the speeds, against which
/// they act (N·s/m).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub(crate) normal_n: f64,
    pub(crate) normal_slope: f64,
    pub(crate) tangential_n: f64,
    pub(crate) tangential_slope: f64,
}

/// Which of a contact's two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    A,
    B,
}

impl Side {
    #[inline(always)]
    pub(crate) fn other(self) -> Side {
        match self {
            Side::A => Side::B,
            Side::B => Side::A,
        }
    }

    /// 1 for A, −1 for B: velocities and forces are those of A relative to B.
    #[inline(always)]
    pub(crate) fn sign(self) -> f64 {
        match self {
            Side::A => 1.0,
            Side::B => -1.0,
        }
    }
}

/// How a contact moves one of its bodies: n and the levers of n and t.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grip {
    pub(crate) along_n: Vec2,
    pub(crate) levers: Levers,
}

impl Grip {
    /// V_n and V_t where only that body moves, as A (m/s).
    #[inline(always)]
    pub(crate) fn speeds(&self, (velocity_mps, turn_radps): Velocity) -> (f64, f64) {
        (
            velocity_mps.dot(self.along_n) + turn_radps * self.levers.n_m,
            velocity_mps.dot(self.along_n.quarter_turn()) + turn_radps * self.levers.t_m,
        )
    }

    /// −N n + T t and its moment.
    #[inline(always)]
    pub(crate) fn wrench(&self, normal_n: f64, tangential_n: f64) -> (Vec2, f64) {
        (
            self.along_n.quarter_turn() * tangential_n - self.along_n * normal_n,
            self.levers.t_m * tangential_n - self.levers.n_m * normal_n,
        )
    }
}

/// j of A and B for a direction with these levers (m): the speed along it is j·v.
#[inline]
fn rows(Vec2 { x, y }: Vec2, lever_a_m: f64, lever_b_m: f64) -> [[f64; 3]; 2] {
    [[x, y, lever_a_m], [-x, -y, -lever_b_m]]
}

impl Tie {
    /// A contact between two bodies of these ranks and inverse masses, with the forces that it begins with.
    #[cfg(test)]
    pub(crate) fn new(
        a: (u32, &InverseMatrix),
        b: (u32, &InverseMatrix),
        touch: &Touch,
        laws: &Laws,
        begins_with: Forces,
        h: f64,
    ) -> Tie {
        let mut tie = Tie::default();
        let seen_of_a = Seen::of(a.1, touch.normal, touch.levers_a);
        let seen_of_b = Seen::of(b.1, touch.normal, touch.levers_b);
        let floats = [a.1, b.1].map(InverseMatrix::floats);
        tie.join([a.0, b.0], Movers::of(floats), touch);
        tie.answer(&Seen::both(seen_of_a, seen_of_b), floats);
        tie.obey(touch, laws, (begins_with, Slide::Touches), (h, h));
        tie
    }

    /// Becomes a contact between two bodies of these ranks, of which these move, as far as neither masses nor laws
    /// matter.
    // Always inlined, and apart from the laws: what is written where it is to stay is no longer in their way.
    #[inline(always)]
    pub(crate) fn join(&mut self, [a, b]: [u32; 2], movers: Movers, touch: &Touch) {
        let Touch { normal: along_n, levers_a, levers_b, .. } = *touch;
        (self.a, self.b, self.movers) = (a, b, movers);
        (self.along_n, self.levers_a, self.levers_b) = (along_n, levers_a, levers_b);
        (self.normal_before_mps, self.tangential_before_mps) =
            (touch.v_normal_mps, touch.v_tangential_mps);
    }

    /// Its bodies answer it like this, and A and B float or not.
    #[inline(always)]
    pub(crate) fn answer(&mut self, seen: &Seen, [a_floats, b_floats]: [bool; 2]) {
        (self.a_floats, self.b_floats) = (a_floats, b_floats);
        let Seen { normal, cross, tangential, linear, is_alike, turning } = *seen;
        (self.normal, self.cross, self.tangential, self.linear) =
            (normal, cross, tangential, linear);
        (self.is_alike, self.turning) = (is_alike, turning);
    }

    /// With these laws and the forces that it begins with, in a sub-step of length h and its κ.
    ///
    /// What slides holds no more than the sliding force: see [`Tie::slides_on`].
    #[inline(always)]
    pub(crate) fn obey(
        &mut self,
        touch: &Touch,
        laws: &Laws,
        (begins_with, slide): (Forces, Slide),
        (h, kick_s): (f64, f64),
    ) {
        let material = laws.material;
        let implicit = implicit_share(material.shear_stiffness_npm * self.tangential, h);
        let explicit_m = implicit * (1.0 - implicit) * h * touch.v_tangential_mps;
        self.kick_s = kick_s;
        self.implicit = implicit;
        self.spring_at_rest_n = -material.shear_stiffness_npm * (touch.shear_m + explicit_m);
        self.spring_slope = implicit * implicit * material.shear_stiffness_npm * h;
        self.law_n = laws.law_n;
        self.rebound_mps = laws.rebound_mps;
        self.may_give_j = laws.may_give_j;
        self.may_shear_j = laws.may_shear_j;
        self.unheld_j = laws.unheld_j;
        self.shear_stiffness_npm = material.shear_stiffness_npm;
        self.friction_holding = match slide {
            Slide::Slides => material.friction_dynamic,
            Slide::Touches | Slide::Holds => material.friction_static,
        };
        self.friction_dynamic = material.friction_dynamic;
        self.slide = slide;
        self.forces = begins_with;
    }

    /// V_n and V_t of the two bodies as they move now (m/s).
    #[inline]
    pub(crate) fn speeds(&self, velocities: &[Velocity]) -> (f64, f64) {
        self.movers.speeds(
            || velocities[self.a as usize],
            || velocities[self.b as usize],
            (self.along_n, self.levers_a, self.levers_b),
        )
    }

    /// Gives the two bodies an impulse of N and T and its opposite (N·s): on A it is −N n + T t.
    // Always inlined: what asks for it has mostly just looked at the same bodies.
    #[inline(always)]
    pub(crate) fn push(
        &self,
        velocities: &mut [Velocity],
        inverses: &[InverseMatrix],
        normal_ns: f64,
        tangential_ns: f64,
    ) {
        if self.a_floats {
            let (impulse, moment) = self.grip(Side::A).wrench(normal_ns, tangential_ns);
            let (dv, dr) = self.response(inverses, self.a, impulse, moment);
            let (velocity_mps, turn_radps) = &mut velocities[self.a as usize];
            *velocity_mps += dv;
            *turn_radps += dr;
        }
        if self.b_floats {
            let (impulse, moment) = self.grip(Side::B).wrench(normal_ns, tangential_ns);
            let (dv, dr) = self.response(inverses, self.b, impulse, moment);
            let (velocity_mps, turn_radps) = &mut velocities[self.b as usize];
            *velocity_mps -= dv;
            *turn_radps -= dr;
        }
    }

    /// Change of velocity and yaw rate of one of its bodies that float by an impulse and its moment.
    #[inline(always)]
    fn response(
        &self,
        inverses: &[InverseMatrix],
        rank: u32,
        impulse: Vec2,
        moment: f64,
    ) -> Velocity {
        if self.is_alike {
            (impulse * self.linear, moment * self.turning)
        } else {
            inverses[rank as usize].response(impulse, moment)
        }
    }

    /// The speeds after a change of the forces (N).
    #[inline]
    pub(crate) fn speeds_after(
        &self,
        (normal_mps, tangential_mps): (f64, f64),
        (more_n, more_t): (f64, f64),
        h: f64,
    ) -> (f64, f64) {
        (
            normal_mps + h * (more_t * self.cross - more_n * self.normal),
            tangential_mps + h * (more_t * self.tangential - more_n * self.cross),
        )
    }

    /// Its forces given all others': N = mid(0, N at which V_n⁺ = −γ v_ref, f), or less where that gives
    /// more than it may, and then the implicit shear spring and Coulomb's limits on it. V_n and V_t are those with the
    /// forces that it has.
    #[inline]
    pub(crate) fn relaxed(&self, (normal_mps, tangential_mps): (f64, f64), h: f64) -> Forces {
        let now = &self.forces;
        let tight_n = now.normal_n + (normal_mps + self.rebound_mps) * self.force_per_speed(h);
        let normal_n = self.passive(normal_mps, greater(lesser(tight_n, self.law_n), 0.0), h);
        let normal_n = match now.friction {
            Friction::Slip => self.with_friction(normal_n),
            Friction::Stick => normal_n,
        };
        if self.shear_stiffness_npm == 0.0 {
            return Forces { normal_n, tangential_n: 0.0, friction: Friction::Stick };
        }
        // V_t⁺ with the new N if T were 0, then T from
        // T(1 + ϑ² k_s h² t·K t) = −k_s(Δs + ϑ h V̄ without T).
        let without_mps = tangential_mps
            - h * ((normal_n - now.normal_n) * self.cross + now.tangential_n * self.tangential);
        let spring_n = self.spring_n(without_mps) / (1.0 + self.spring_slope * h * self.tangential);
        // Once it slips in this sub-step it holds again only below the sliding force: else, with μ_k
        // below μ_s, the sweeps would go to and fro between the two.
        let holds = match now.friction {
            Friction::Stick => self.friction_holding,
            Friction::Slip => self.friction_dynamic,
        };
        let (wanted_n, friction) = if spring_n.abs() <= holds * normal_n {
            (spring_n, Friction::Stick)
        } else {
            ((self.friction_dynamic * normal_n).copysign(spring_n), Friction::Slip)
        };
        let tangential_n = self.passive_shear(without_mps, wanted_n, h);
        Forces { normal_n, tangential_n, friction }
    }

    /// N of a contact that slides, where it would be `normal_n` if T stayed as it is.
    ///
    /// T = ±μ_k N follows each change of N, and by n·K t changes V_n in its turn: by ρ = μ_k |n·K t| / n·K n of what the
    /// change of N does by itself, and against it where T drives the bodies apart. Sweeps would then overshoot
    /// by ρ, and above 1 go to and fro for ever; a change that is less by 1 + ρ is exact where V_n⁺ = −γ v_ref decides.
    #[inline]
    fn with_friction(&self, normal_n: f64) -> f64 {
        let follows = self.friction_dynamic * self.cross.abs();
        if follows <= OVERSHOOTS * self.normal || self.forces.tangential_n * self.cross > 0.0 {
            return normal_n;
        }
        let now_n = self.forces.normal_n;
        now_n + (normal_n - now_n) * (self.normal / (self.normal + follows))
    }

    /// 1/(h n·K n) (kg/s).
    #[inline]
    fn force_per_speed(&self, h: f64) -> f64 {
        1.0 / (h * self.normal)
    }

    /// `normal_n`, or less where it would give the bodies more than the contact may.
    ///
    /// The work of N on the bodies is N h (½ N h n·K n − s), with s the mean of V_n before the sub-step and
    /// of V_n after it were N 0.
    #[inline]
    fn passive(&self, normal_mps: f64, normal_n: f64, h: f64) -> f64 {
        let without_mps = normal_mps + self.forces.normal_n * h * self.normal;
        let mean_mps = 0.5 * (self.normal_before_mps + without_mps);
        let work_j = normal_n * h * (0.5 * normal_n * h * self.normal - mean_mps);
        if work_j <= self.may_give_j {
            return normal_n;
        }
        let root = libm::sqrt(mean_mps * mean_mps + 2.0 * self.normal * self.may_give_j);
        greater((mean_mps + root) * self.force_per_speed(h), 0.0)
    }

    /// `tangential_n`, or less where it would give the bodies more than the shear spring may.
    ///
    /// Its work on them is T h (½ T h t·K t + s), with s the mean of V_t before the sub-step and of V_t after
    /// it were T 0. The midpoint rule alone keeps to the limit; a more implicit spring does not where other
    /// forces change V_t, and neither does one whose t turns with its body.
    #[inline]
    fn passive_shear(&self, without_mps: f64, tangential_n: f64, h: f64) -> f64 {
        let mean_mps = 0.5 * (self.tangential_before_mps + without_mps);
        let work_j = tangential_n * h * (0.5 * tangential_n * h * self.tangential + mean_mps);
        if work_j <= self.may_shear_j {
            return tangential_n;
        }
        let root = libm::sqrt(mean_mps * mean_mps + 2.0 * self.tangential * self.may_shear_j);
        (root.copysign(tangential_n) - mean_mps) / (h * self.tangential)
    }

    /// The shear spring's force at a V_t⁺: −k_s(Δs + ϑ h V̄), V̄ = (1 − ϑ) V_t + ϑ V_t⁺ (N).
    #[inline]
    pub(crate) fn spring_n(&self, after_mps: f64) -> f64 {
        self.spring_at_rest_n - self.spring_slope * after_mps
    }

    /// At V_t⁺ = 0 (N).
    #[inline]
    pub(crate) fn spring_at_rest_n(&self) -> f64 {
        self.spring_at_rest_n
    }

    /// What it loses with V_t⁺ (N·s/m).
    #[inline]
    pub(crate) fn spring_slope(&self) -> f64 {
        self.spring_slope
    }

    /// T of the spring that sticks and the speeds with it, where N = f and no other force acts, from the speeds
    /// without either.
    #[inline]
    pub(crate) fn sticking(&self, free: (f64, f64), h: f64) -> (f64, (f64, f64)) {
        let normal_ns = h * self.law_n;
        let without_mps = free.1 - normal_ns * self.cross;
        let tangential_n =
            self.spring_n(without_mps) / (1.0 + self.spring_slope * h * self.tangential);
        let tangential_ns = h * tangential_n;
        let normal_mps = free.0 + (tangential_ns * self.cross - normal_ns * self.normal);
        (tangential_n, (normal_mps, without_mps + tangential_ns * self.tangential))
    }

    /// Do N = f and a T of the spring that sticks keep to all bounds, if with them, and all others' forces,
    /// the speeds become these?
    #[inline]
    pub(crate) fn is_within_bounds(
        &self,
        (normal_mps, tangential_mps): (f64, f64),
        tangential_n: f64,
        h: f64,
    ) -> bool {
        let gives_j = -0.5 * h * self.law_n * (self.normal_before_mps + normal_mps);
        let shear_gives_j = 0.5 * h * tangential_n * (self.tangential_before_mps + tangential_mps);
        normal_mps >= -self.rebound_mps
            && gives_j <= self.may_give_j
            && tangential_n.abs() <= self.friction_holding * self.law_n
            && shear_gives_j <= self.may_shear_j
    }

    /// Its forces are N = f and this T of the spring that sticks, its speeds these.
    #[inline(always)]
    pub(crate) fn stick(&mut self, speeds: (f64, f64), tangential_n: f64) {
        self.forces = Forces { normal_n: self.law_n, tangential_n, friction: Friction::Stick };
        self.after_mps = speeds;
    }

    /// The ranks of its bodies that float, A's and B's.
    #[inline(always)]
    pub(crate) fn floating(&self) -> [Option<u32>; 2] {
        [self.a_floats.then_some(self.a), self.b_floats.then_some(self.b)]
    }

    /// The rank of the one of its bodies that floats.
    #[inline(always)]
    pub(crate) fn only_floating(&self) -> Option<u32> {
        match (self.a_floats, self.b_floats) {
            (true, false) => Some(self.a),
            (false, true) => Some(self.b),
            _ => None,
        }
    }

    /// The rank of one of its bodies that float.
    #[inline(always)]
    pub(crate) fn one_floating(&self) -> u32 {
        if self.a_floats { self.a } else { self.b }
    }

    /// Where only one of its bodies floats, which one.
    #[inline(always)]
    pub(crate) fn floating_side(&self) -> Side {
        if self.a_floats { Side::A } else { Side::B }
    }

    /// Its grip on one of its bodies.
    #[inline(always)]
    pub(crate) fn grip(&self, side: Side) -> Grip {
        Grip {
            along_n: self.along_n,
            levers: match side {
                Side::A => self.levers_a,
                Side::B => self.levers_b,
            },
        }
    }

    /// V_n = j·v, with the velocities (north, east, yaw) of A and B.
    pub(crate) fn normal_row(&self) -> [[f64; 3]; 2] {
        rows(self.along_n, self.levers_a.n_m, self.levers_b.n_m)
    }

    /// V_t = j·v, in the same way.
    pub(crate) fn tangential_row(&self) -> [[f64; 3]; 2] {
        rows(self.along_n.quarter_turn(), self.levers_a.t_m, self.levers_b.t_m)
    }

    /// N where a tight contact is a stiff line through its present force, of slope κ = stiffness/(h n·K n).
    fn on_stiff_line_n(&self, normal_mps: f64, stiffness: f64, h: f64) -> f64 {
        let slope = stiffness * self.force_per_speed(h);
        self.forces.normal_n + slope * (normal_mps + self.rebound_mps)
    }

    /// Where N stands between its bounds at a V_n.
    pub(crate) fn kind(&self, normal_mps: f64, stiffness: f64, h: f64) -> Kind {
        match self.on_stiff_line_n(normal_mps, stiffness, h) {
            n if n >= self.law_n => Kind::Full,
            n if n <= 0.0 => Kind::Open,
            _ => Kind::Tight,
        }
    }

    /// What the forces are more than now at these speeds, and how they change with them. What slips does so
    /// with the present N.
    pub(crate) fn line(
        &self,
        (normal_mps, tangential_mps): (f64, f64),
        kind: Kind,
        stiffness: f64,
        h: f64,
    ) -> Line {
        let now = &self.forces;
        let (normal_n, normal_slope) = match kind {
            Kind::Full => (self.law_n, 0.0),
            Kind::Open => (0.0, 0.0),
            Kind::Tight => {
                let slope = stiffness * self.force_per_speed(h);
                (self.on_stiff_line_n(normal_mps, stiffness, h), slope)
            }
        };
        let (tangential_n, tangential_slope) = match now.friction {
            Friction::Slip => (now.tangential_n, 0.0),
            Friction::Stick => (self.spring_n(tangential_mps), self.spring_slope),
        };
        Line {
            normal_n: normal_n - now.normal_n,
            normal_slope,
            tangential_n: tangential_n - now.tangential_n,
            tangential_slope,
        }
    }

    /// The forces at these speeds, by the same lines and within all bounds.
    pub(crate) fn stiffened(
        &self,
        speeds: (f64, f64),
        kind: Kind,
        stiffness: f64,
        h: f64,
    ) -> Forces {
        let line = self.line(speeds, kind, stiffness, h);
        let now = &self.forces;
        let normal_n = greater(lesser(now.normal_n + line.normal_n, self.law_n), 0.0);
        let most_n = match now.friction {
            Friction::Stick => self.friction_holding,
            Friction::Slip => self.friction_dynamic,
        } * normal_n;
        let tangential_n = bounded(now.tangential_n + line.tangential_n, -most_n, most_n);
        Forces { normal_n, tangential_n, friction: now.friction }
    }

    /// The largest change of its own velocity by a change of its forces (m/s).
    #[inline]
    pub(crate) fn change_mps(&self, (more_n, more_t): (f64, f64), h: f64) -> f64 {
        greater((more_n * self.normal).abs(), (more_t * self.tangential).abs()) * h
    }

    /// Δs at the end of the sub-step from that at its start (m): grown by h V̄, while it slips at most what the
    /// sliding force shears.
    #[inline]
    pub(crate) fn shear_after_m(&self, shear_m: f64, after_mps: f64, h: f64) -> f64 {
        let share = self.implicit;
        let mean_mps = (1.0 - share) * self.tangential_before_mps + share * after_mps;
        let grown_m = shear_m + h * mean_mps;
        match self.forces.friction {
            Friction::Stick => grown_m,
            Friction::Slip => {
                let most_m =
                    self.friction_dynamic * self.forces.normal_n / self.shear_stiffness_npm;
                bounded(grown_m, -most_m, most_m)
            }
        }
    }

    /// Does it slide on into the next sub-step, with this Δs at the end of this one?
    ///
    /// A slide begins where the spring passes the static limit, and is over when V_t turns back against the stretched
    /// spring. That a spring is content with less than μ_k N does not end it: N can jump within a sub-step, and a
    /// slide that had to begin anew would have to pass μ_s N again. Nor does a slip in the sub-step of the first
    /// touch begin one: N is that of its start, when there was next to no depth, T that of its end.
    #[inline]
    pub(crate) fn slides_on(&self, shear_m: f64) -> bool {
        match (self.slide, self.forces.friction) {
            (Slide::Touches, _) | (Slide::Holds, Friction::Stick) => false,
            (_, Friction::Slip) => true,
            (Slide::Slides, Friction::Stick) => shear_m * self.after_mps.1 > 0.0,
        }
    }

    /// ½ k_s Δs² (J).
    #[inline]
    pub(crate) fn shear_stored_j(&self, shear_m: f64) -> f64 {
        0.5 * self.shear_stiffness_npm * shear_m * shear_m
    }
}

/// ϑ of the shear spring: how implicit it is, from k_s t·K t (1/s²). ½, the midpoint rule, keeps its energy
/// exactly, where backward Euler (1) would damp it by ωh/2 a radian: at the sub-steps that the normal law
/// needs, a tug that rolls along a ship's side would leave with a yaw rate wrong by a seventh. Where the
/// sub-step is long beside the spring's own period ϑ rises to 1, so that it does not ring at k_s h²/m ≫ 1.
/// Any ϑ ≥ ½ is stable. That it makes no energy holds at ½ alone: see [`Tie::passive_shear`].
#[inline]
pub(crate) fn implicit_share(rate_squared: f64, h: f64) -> f64 {
    let turn_squared = rate_squared * h * h;
    if turn_squared <= 1.0 { 0.5 } else { more_implicit_share(turn_squared) }
}

// Apart, so that nobody waits for the root and the quotient where they are not needed.
#[cold]
#[inline(never)]
fn more_implicit_share(turn_squared: f64) -> f64 {
    1.0 - 0.5 / libm::sqrt(turn_squared)
}

impl Forces {
    /// What they are more than others.
    #[inline]
    pub(crate) fn less(&self, other: &Forces) -> (f64, f64) {
        (self.normal_n - other.normal_n, self.tangential_n - other.tangential_n)
    }
}
