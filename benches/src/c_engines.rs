//! Box2D and Chipmunk playing a scene with their usual settings, but for gravity and sleep, which are off.

use fenderline_bench_peers::{Peer, PeerBody, PeerState};
use fenderline_contact::{BodyState, Vec2, vec2};

use fenderline_bench_scenes::scenes::{Part, Plan};
use fenderline_bench_scenes::world::World;

/// A scene in Box2D or Chipmunk.
struct InPeer<P> {
    peer: P,
    /// The floating bodies: number of each, and its position and motion at the start.
    floating: Vec<(usize, PeerState)>,
}

/// The scene as the peer `P`, Box2D or Chipmunk, plays it.
pub(crate) fn world<P: Peer + 'static>(plan: &Plan, step_s: f64) -> Box<dyn World> {
    let (bodies, floating) = bodies(plan);
    Box::new(InPeer { peer: P::new(&bodies, step_s), floating })
}

fn bodies(plan: &Plan) -> (Vec<PeerBody>, Vec<(usize, PeerState)>) {
    let bodies: Vec<PeerBody> = plan.parts.iter().map(|part| body(plan, part)).collect();
    let floating = bodies.iter().enumerate().filter(|(_, body)| body.mass.is_some());
    let floating = floating.map(|(index, body)| (index, body.state)).collect();
    (bodies, floating)
}

fn body(plan: &Plan, part: &Part) -> PeerBody {
    let BodyState { position_m, heading_rad, velocity_mps, yaw_rate_radps } = part.state;
    PeerBody {
        outline_m: part.outline_m.iter().copied().map(pair).collect(),
        mass: part.mass.map(|mass| [mass.mass_kg, mass.yaw_inertia_kgm2]),
        state: PeerState {
            position_m: pair(position_m),
            heading_rad,
            velocity_mps: pair(velocity_mps),
            yaw_rate_radps,
        },
        force_n: pair(part.load.force_n),
        friction: plan.material.friction_static,
        restitution: plan.material.restitution,
    }
}

impl<P: Peer> World for InPeer<P> {
    fn restart(&mut self) {
        for &(body, state) in &self.floating {
            self.peer.set_state(body, state);
        }
        self.peer.step();
    }

    fn step(&mut self) {
        self.peer.step();
    }

    fn load(&mut self, body: usize, force_n: Vec2) {
        self.peer.set_force(body, pair(force_n));
    }

    fn state(&self, body: usize) -> BodyState {
        let PeerState { position_m, heading_rad, velocity_mps, yaw_rate_radps } =
            self.peer.state(body);
        let [position_m, velocity_mps] = [position_m, velocity_mps].map(|[x, y]| vec2(x, y));
        BodyState { position_m, heading_rad, velocity_mps, yaw_rate_radps }
    }

    fn touching(&self) -> usize {
        self.peer.touching()
    }

    fn peaks(&self) -> Option<(f64, f64)> {
        None
    }
}

fn pair(v: Vec2) -> [f64; 2] {
    [v.x, v.y]
}
