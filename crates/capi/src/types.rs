//! Structures and constants of the C interface.

use fenderline_contact::{
    BodyState, Contact, Event, EventKind, FenderLaw, Friction, HostIntegration, HostSettings,
    Material, Stop, Unloading, Vec2, Wrench, vec2,
};
use fenderline_embed::{CoriolisTerms, Host, Settings};
use fenderline_sim::{MassProperties, Method};

use crate::failure::{FlStatus, Outcome, failure};

/// The length to pass for a text that ends with a NUL. cbindgen cannot write the value; its line in the header is in
/// cbindgen.toml.
/// cbindgen:ignore
pub const FL_NUL: usize = usize::MAX;

/// Stands for no fender, where the outline of one body meets the outline of another.
pub const FL_NONE: u32 = u32::MAX;

/// fl_settings.method: the method of the scenario; FL_METHOD_COUPLED if there is no scenario.
pub const FL_METHOD_DEFAULT: u32 = 0;
/// fl_settings.method: all contacts of a step are solved together with the loads.
pub const FL_METHOD_COUPLED: u32 = 1;
/// fl_settings.method: the method of the TransNav paper (Moreno et al. 2023), which treats each pair of bodies by
/// itself and without loads.
pub const FL_METHOD_PAPER: u32 = 2;

/// fl_settings.host: a direct host. A direct host passes the states at the start of each step, and all loads. A direct
/// host may take the states of fl_engine_states_after(), or integrate the bodies itself with the wrenches, in steps of
/// any length. If a direct host integrates the bodies itself by the coupled method, the engine continues the motion
/// that it has computed while bodies touch, and the wrenches keep the host on this motion.
pub const FL_HOST_DIRECT: u32 = 0;
/// fl_settings.host: a co-simulation host, such as a co-simulation master or the loop of a game. A co-simulation host
/// integrates the bodies itself in steps of any length, may pass states that are some steps old, and need not report
/// loads. For a co-simulation host the engine infers the loads from the states, predicts the present states, and
/// returns wrenches with which the host follows the engine's motion. Coupled method only.
pub const FL_HOST_COSIMULATION: u32 = 1;

/// fl_settings.coriolis: the engine or the host's loads have the Coriolis terms, as in `fenderline run` with the
/// scenario's integrator; without a scenario, FL_CORIOLIS_BY_ENGINE is taken.
pub const FL_CORIOLIS_DEFAULT: u32 = 0;
/// fl_settings.coriolis: the host's loads do not contain the Coriolis and centripetal terms of a body's added mass; the
/// engine adds them.
pub const FL_CORIOLIS_BY_ENGINE: u32 = 1;
/// fl_settings.coriolis: the host's loads contain the Coriolis and centripetal terms of a body's added mass.
pub const FL_CORIOLIS_IN_LOADS: u32 = 2;

/// fl_settings.integration: the host moves positions with the old velocities, then changes the velocities.
pub const FL_INTEGRATION_FORWARD_EULER: u32 = 0;
/// fl_settings.integration: the host changes the velocities, then moves positions with the new velocities.
pub const FL_INTEGRATION_SEMI_IMPLICIT: u32 = 1;

/// fl_event.kind: a contact patch began.
pub const FL_EVENT_CONTACT_BEGAN: u32 = 0;
/// fl_event.kind: a contact patch ended.
pub const FL_EVENT_CONTACT_ENDED: u32 = 1;
/// fl_event.kind: one patch split into several.
pub const FL_EVENT_PATCH_SPLIT: u32 = 2;
/// fl_event.kind: several patches merged into one.
pub const FL_EVENT_PATCHES_MERGED: u32 = 3;
/// fl_event.kind: one body lies wholly within the other.
pub const FL_EVENT_CONTAINED: u32 = 4;
/// fl_event.kind: the overlap is more than half the smaller body's area.
pub const FL_EVENT_DEEP_OVERLAP: u32 = 5;
/// fl_event.kind: a body was displaced by a tenth of its outline's radius more than its velocities explain, or
/// fl_engine_mark_teleported() was called for it; its contacts begin anew. The radius of an outline is the largest
/// distance of one of its vertices from the centre of gravity.
pub const FL_EVENT_TELEPORTED: u32 = 6;
/// fl_event.kind: a fender is deflected beyond its rated deflection.
pub const FL_EVENT_FENDER_RATING_EXCEEDED: u32 = 7;
/// fl_event.kind: a fender is pressed until its stop takes load, or by its whole projection.
pub const FL_EVENT_FENDER_FAILED: u32 = 8;
/// fl_event.kind: the solver of the contact between these bodies did not converge within its limit of iterations.
pub const FL_EVENT_NOT_CONVERGED: u32 = 9;
/// fl_event.kind: a body was placed so deep in another body that the contact would eject it. A body that was placed
/// deep in another body is pushed out slowly, at 0.08 m/s at most.
pub const FL_EVENT_PLACED_IN_OVERLAP: u32 = 10;
/// fl_event.kind: a body of a co-simulation host does not accelerate as its mass in the model says: the host uses another
/// mass (see fl_engine_mass_matrix()). Reported once per body.
pub const FL_EVENT_MASS_MISMATCH: u32 = 11;

/// fl_contact.flags: the contact slips; otherwise it sticks.
pub const FL_CONTACT_SLIPS: u32 = 1;
/// fl_contact.flags: the limit by the momentum of the bodies reduced the normal or the tangential force of the contact.
pub const FL_CONTACT_LIMITED: u32 = 2;

/// Position and velocity of a body's centre of gravity, earth-fixed.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct FlState {
    /// Position (m).
    pub north_m: f64,
    /// Position (m).
    pub east_m: f64,
    /// Clockwise from north (rad).
    pub heading_rad: f64,
    /// Velocity (m/s).
    pub north_mps: f64,
    /// Velocity (m/s).
    pub east_mps: f64,
    /// Rate of turn of the body, positive to starboard (rad/s).
    pub yaw_rate_radps: f64,
}

/// A force at a body's centre of gravity and a moment about the centre of gravity, earth-fixed.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FlWrench {
    /// Force (N).
    pub north_n: f64,
    /// Force (N).
    pub east_n: f64,
    /// Moment about the vertical, positive to starboard (N m).
    pub moment_nm: f64,
}

/// Settings of an engine; every member except `size` may be 0, which means the default.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct FlSettings {
    /// sizeof(fl_settings)
    pub size: usize,
    /// FL_METHOD_...
    pub method: u32,
    /// FL_HOST_...
    pub host: u32,
    /// One of the constants FL_CORIOLIS_... for a direct host; 0 for a co-simulation host, whose loads always contain
    /// the Coriolis terms.
    pub coriolis: u32,
    /// One of the constants FL_INTEGRATION_... for a co-simulation host; 0 for a direct host.
    pub integration: u32,
    /// Age of the states that a co-simulation host passes (steps), at most 1000; 0 for a direct host.
    pub delay_steps: u32,
}

/// Contact parameters of a pair of bodies.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct FlMaterial {
    /// sizeof(fl_material)
    pub size: usize,
    /// Area stiffness (N/m2).
    pub stiffness_npm2: f64,
    /// Area damping (N s/m2).
    pub damping_nspm2: f64,
    /// Shear stiffness (N/m).
    pub shear_stiffness_npm: f64,
    /// Coefficient of static friction.
    pub friction_static: f64,
    /// Coefficient of dynamic friction, at most the coefficient of static friction.
    pub friction_dynamic: f64,
    /// Coefficient of restitution, 0 to 1.
    pub restitution: f64,
}

/// A body. The body's outline is a separate argument.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct FlBody {
    /// sizeof(fl_body)
    pub size: usize,
    /// Displacement (kg). A fixed body has 0 as displacement and for all other masses.
    pub mass_kg: f64,
    /// Moment of inertia of the body about the vertical (kg m2).
    pub yaw_inertia_kgm2: f64,
    /// Added mass of the body in surge (kg).
    pub added_surge_kg: f64,
    /// Added mass of the body in sway (kg).
    pub added_sway_kg: f64,
    /// Added moment of inertia of the body in yaw (kg m2).
    pub added_yaw_kgm2: f64,
    /// North coordinate of a fixed body, or of a floating body at the start (m).
    pub north_m: f64,
    /// East coordinate of a fixed body, or of a floating body at the start (m).
    pub east_m: f64,
    /// Heading of a fixed body; initial heading of a floating body (rad).
    pub heading_rad: f64,
}

/// A fender: a face on a body. The fender's reaction curve is a separate argument. The fender touches the outlines of
/// all bodies that form a pair with the fender's body.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct FlFender {
    /// sizeof(fl_fender)
    pub size: usize,
    /// Forward coordinate of the middle of the fender's mounting line, in the body's frame (m).
    pub forward_m: f64,
    /// Starboard coordinate of the middle of the fender's mounting line, in the body's frame (m).
    pub starboard_m: f64,
    /// Direction of the fender's outward normal, in the body's frame: 0 forward, positive to starboard (rad).
    pub facing_rad: f64,
    /// Width of the fender's face (m).
    pub width_m: f64,
    /// Distance from the fender's mounting to its uncompressed face (m).
    pub projection_m: f64,
    /// Rated deflection of the fender (m); 0 means that it equals the projection. The rated deflection must be 0 for a
    /// fender without a reaction curve.
    pub rated_deflection_m: f64,
    /// Deflection at which the fender's stop begins to take load (m).
    pub stop_from_m: f64,
    /// Stiffness of the fender's stop (N/m). A fender without a stop has 0 for the stop's deflection and stiffness.
    pub stop_stiffness_npm: f64,
    /// Index of the body on which the fender is mounted.
    pub body: u32,
    /// Index of the fender's material: friction, restitution, damping, and, without a curve, stiffness.
    pub material: u32,
    /// Share of the absorbed energy that the fender returns when it is unloaded by an unloading law, 0.05 to 1. The
    /// value 0 means that the fender unloads by the restitution of its material.
    pub returned_energy: f64,
}

/// One contact patch in the last step. The force on body 1 is -normal_force_n times the normal and tangential_force_n
/// times the normal turned by +90 degrees (north to east); on body 2 exactly the opposite. By the coupled method the
/// forces of a contact are means over the step; its peaks cover all sub-steps.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct FlContact {
    /// Size of the structure, sizeof(fl_contact), which the caller must set.
    pub size: usize,
    /// The body added first.
    pub body_1: u32,
    /// The body added later.
    pub body_2: u32,
    /// Index of the fender that is compressed; FL_NONE if outline meets outline.
    pub fender: u32,
    /// Number of the contact patch within its pair of bodies.
    pub patch: u32,
    /// Sum of FL_CONTACT_...
    pub flags: u32,
    /// Always 0.
    pub reserved: u32,
    /// Area of the overlap of the two outlines (m2).
    pub area_m2: f64,
    /// Extent of the overlap of the outlines along the normal, or deflection of the fender (m).
    pub depth_m: f64,
    /// North coordinate of the point where the contact force acts (m).
    pub north_m: f64,
    /// East coordinate of the point where the contact force acts (m).
    pub east_m: f64,
    /// North component of body 1's outward unit normal.
    pub normal_north: f64,
    /// East component of body 1's outward unit normal.
    pub normal_east: f64,
    /// Speed at which the two bodies approach each other along the normal (m/s).
    pub v_normal_mps: f64,
    /// Speed of body 1 relative to body 2 along the tangent (m/s).
    pub v_tangential_mps: f64,
    /// Deflection of the contact's shear spring, from which friction is computed (m).
    pub shear_m: f64,
    /// Normal force of the contact, at least 0 (N).
    pub normal_force_n: f64,
    /// Tangential force of the contact on body 1 (N).
    pub tangential_force_n: f64,
    /// Largest normal force of the contact within the step (N).
    pub peak_normal_force_n: f64,
    /// Largest depth of the contact within the step (m).
    pub peak_depth_m: f64,
    /// Part of the normal force that the area spring or the reaction curve gives (N).
    pub spring_n: f64,
    /// Part of the normal force that the stop at the end of a fender's travel gives (N).
    pub stop_n: f64,
    /// Part of the normal force that the damper gives (N).
    pub damper_n: f64,
    /// Part of the normal force that the momentum limit took away (N).
    pub limiter_n: f64,
    /// Energy that the fender's spring and stop hold at the start of the step and can return (J); 0 if outline meets
    /// outline.
    pub stored_j: f64,
    /// Largest energy within the step that it takes to load the fender to its deflection (J).
    pub peak_absorbed_j: f64,
    /// Angle between a fender's face and the hull (rad).
    pub tilt_rad: f64,
    /// Factor by which a fender's reaction is multiplied, set when the contact began.
    pub factor: f64,
    /// Energy that a fender with the member returned_energy set has dissipated within the step (J).
    pub hysteresis_j: f64,
}

/// An event, reported in the step in which it begins.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct FlEvent {
    /// Size of the structure, sizeof(fl_event), which the caller must set.
    pub size: usize,
    /// FL_EVENT_...
    pub kind: u32,
    /// The body.
    pub body_1: u32,
    /// Index of the second body of the event; equal to body_1 if the event concerns only one body.
    pub body_2: u32,
    /// Index of the fender of the event; FL_NONE if the event concerns no fender.
    pub fender: u32,
}

/// Drawing data of a fender, in the frame of the body that carries the fender (forward, starboard of the body's centre
/// of gravity): draw the fender as a child of this body. Seen when looking out from the body, end 1 of the mounting
/// line and of the face is left, and end 2 is right.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct FlFenderView {
    /// Index of the body that carries the fender.
    pub body: u32,
    /// Index of the body that presses the fender; if several do, of the body that presses deepest. FL_NONE means that
    /// no body presses the fender.
    pub hull: u32,
    /// Forward coordinate of end 1 of the line where the fender is mounted (m).
    pub mount_1_forward_m: f64,
    /// Starboard coordinate of end 1 of the line where the fender is mounted (m).
    pub mount_1_starboard_m: f64,
    /// Forward coordinate of end 2 of the line where the fender is mounted (m).
    pub mount_2_forward_m: f64,
    /// Starboard coordinate of end 2 of the line where the fender is mounted (m).
    pub mount_2_starboard_m: f64,
    /// Forward coordinate of end 1 of the fender's face in its present compression and turn (m).
    pub face_1_forward_m: f64,
    /// Starboard coordinate of end 1 of the fender's face (m).
    pub face_1_starboard_m: f64,
    /// Forward coordinate of end 2 of the fender's face in its present compression and turn (m).
    pub face_2_forward_m: f64,
    /// Starboard coordinate of end 2 of the fender's face (m).
    pub face_2_starboard_m: f64,
    /// Deflection of the fender in the last step (m); 0 if no body presses the fender.
    pub deflection_m: f64,
    /// Rated deflection (m).
    pub rated_deflection_m: f64,
    /// Mean normal force of all bodies on the fender over the last step (N), for an instrument to show.
    pub normal_force_n: f64,
    /// Largest normal force of a single body on the fender within the last step (N), for an alarm.
    pub peak_normal_force_n: f64,
    /// Largest deflection of the fender within the last step (m).
    pub peak_deflection_m: f64,
    /// Turn of a panel on several cones about the vertical (rad), positive if the right end, as you look at the
    /// face, is deflected more; 0 for other fenders.
    pub panel_turn_rad: f64,
}

impl FlState {
    pub(crate) fn inward(self) -> BodyState {
        BodyState {
            position_m: vec2(self.north_m, self.east_m),
            heading_rad: self.heading_rad,
            velocity_mps: vec2(self.north_mps, self.east_mps),
            yaw_rate_radps: self.yaw_rate_radps,
        }
    }

    pub(crate) fn outward(state: BodyState) -> FlState {
        FlState {
            north_m: state.position_m.x,
            east_m: state.position_m.y,
            heading_rad: state.heading_rad,
            north_mps: state.velocity_mps.x,
            east_mps: state.velocity_mps.y,
            yaw_rate_radps: state.yaw_rate_radps,
        }
    }
}

impl FlWrench {
    pub(crate) fn inward(self) -> Wrench {
        Wrench { force_n: vec2(self.north_n, self.east_n), moment_nm: self.moment_nm }
    }

    pub(crate) fn outward(wrench: Wrench) -> FlWrench {
        let Wrench { force_n, moment_nm } = wrench;
        FlWrench { north_n: force_n.x, east_n: force_n.y, moment_nm }
    }
}

impl FlMaterial {
    pub(crate) fn inward(&self) -> Material {
        Material {
            stiffness_npm2: self.stiffness_npm2,
            damping_nspm2: self.damping_nspm2,
            shear_stiffness_npm: self.shear_stiffness_npm,
            friction_static: self.friction_static,
            friction_dynamic: self.friction_dynamic,
            restitution: self.restitution,
        }
    }
}

impl FlBody {
    /// Mass and added mass of the body; `None` for a fixed body.
    pub(crate) fn mass(&self) -> Option<MassProperties> {
        let mass = MassProperties {
            mass_kg: self.mass_kg,
            yaw_inertia_kgm2: self.yaw_inertia_kgm2,
            added_surge_kg: self.added_surge_kg,
            added_sway_kg: self.added_sway_kg,
            added_yaw_kgm2: self.added_yaw_kgm2,
        };
        (mass != MassProperties::default()).then_some(mass)
    }
}

impl FlFender {
    pub(crate) fn position_m(&self) -> Vec2 {
        vec2(self.forward_m, self.starboard_m)
    }

    pub(crate) fn law(curve: Vec<[f64; 2]>) -> FenderLaw {
        if curve.is_empty() { FenderLaw::Area } else { FenderLaw::Curve(curve) }
    }

    pub(crate) fn unloading(&self) -> Option<Unloading> {
        (self.returned_energy != 0.0).then_some(Unloading::ReturnedEnergy(self.returned_energy))
    }

    pub(crate) fn rated_deflection_m(&self) -> Option<f64> {
        (self.rated_deflection_m != 0.0).then_some(self.rated_deflection_m)
    }

    pub(crate) fn stop(&self) -> Option<Stop> {
        let stop = Stop { from_m: self.stop_from_m, stiffness_npm: self.stop_stiffness_npm };
        (stop.from_m != 0.0 || stop.stiffness_npm != 0.0).then_some(stop)
    }
}

impl FlSettings {
    pub(crate) fn inward(&self) -> Outcome<Settings> {
        let method = match self.method {
            FL_METHOD_DEFAULT => None,
            FL_METHOD_COUPLED => Some(Method::Coupled),
            FL_METHOD_PAPER => Some(Method::Paper),
            other => return unknown("method", other),
        };
        let coriolis = match self.coriolis {
            FL_CORIOLIS_DEFAULT => None,
            FL_CORIOLIS_BY_ENGINE => Some(CoriolisTerms::ByEngine),
            FL_CORIOLIS_IN_LOADS => Some(CoriolisTerms::InLoads),
            other => return unknown("coriolis", other),
        };
        let integration = match self.integration {
            FL_INTEGRATION_FORWARD_EULER => HostIntegration::ForwardEuler,
            FL_INTEGRATION_SEMI_IMPLICIT => HostIntegration::SemiImplicit,
            other => return unknown("integration", other),
        };
        let host = match self.host {
            FL_HOST_DIRECT => {
                if self.integration != 0 || self.delay_steps != 0 {
                    let text =
                        "`integration` and `delay_steps` are settings of a co-simulation host only";
                    return failure(FlStatus::BadArgument, text);
                }
                Host::Direct { coriolis }
            }
            FL_HOST_COSIMULATION => {
                if self.coriolis != 0 {
                    let text = "`coriolis` is a setting of a direct host only";
                    return failure(FlStatus::BadArgument, text);
                }
                Host::CoSimulation(HostSettings { delay_steps: self.delay_steps, integration })
            }
            other => return unknown("host", other),
        };
        Ok(Settings { method, host })
    }
}

fn unknown<T>(member: &str, value: u32) -> Outcome<T> {
    failure(FlStatus::BadArgument, format_args!("fl_settings.{member} cannot be {value}"))
}

impl FlContact {
    pub(crate) fn outward(c: &Contact) -> FlContact {
        FlContact {
            size: size_of::<FlContact>(),
            body_1: c.body_1.0,
            body_2: c.body_2.0,
            fender: c.fender.map_or(FL_NONE, |fender| fender.0),
            patch: c.patch,
            flags: if c.friction == Friction::Slip { FL_CONTACT_SLIPS } else { 0 }
                + if c.limited { FL_CONTACT_LIMITED } else { 0 },
            reserved: 0,
            area_m2: c.area_m2,
            depth_m: c.depth_m,
            north_m: c.point_m.x,
            east_m: c.point_m.y,
            normal_north: c.normal.x,
            normal_east: c.normal.y,
            v_normal_mps: c.v_normal_mps,
            v_tangential_mps: c.v_tangential_mps,
            shear_m: c.shear_m,
            normal_force_n: c.normal_force_n,
            tangential_force_n: c.tangential_force_n,
            peak_normal_force_n: c.peak_normal_force_n,
            peak_depth_m: c.peak_depth_m,
            spring_n: c.parts.spring_n,
            stop_n: c.parts.stop_n,
            damper_n: c.parts.damper_n,
            limiter_n: c.parts.limiter_n,
            stored_j: c.energy.stored_j,
            peak_absorbed_j: c.energy.peak_absorbed_j,
            hysteresis_j: c.energy.hysteresis_j,
            tilt_rad: c.tilt_rad,
            factor: c.factor,
        }
    }
}

impl FlEvent {
    pub(crate) fn outward(event: &Event) -> FlEvent {
        let (kind, fender) = match event.kind {
            EventKind::ContactBegan => (FL_EVENT_CONTACT_BEGAN, FL_NONE),
            EventKind::ContactEnded => (FL_EVENT_CONTACT_ENDED, FL_NONE),
            EventKind::PatchSplit => (FL_EVENT_PATCH_SPLIT, FL_NONE),
            EventKind::PatchesMerged => (FL_EVENT_PATCHES_MERGED, FL_NONE),
            EventKind::Contained => (FL_EVENT_CONTAINED, FL_NONE),
            EventKind::DeepOverlap => (FL_EVENT_DEEP_OVERLAP, FL_NONE),
            EventKind::Teleported => (FL_EVENT_TELEPORTED, FL_NONE),
            EventKind::FenderRatingExceeded(fender) => (FL_EVENT_FENDER_RATING_EXCEEDED, fender.0),
            EventKind::FenderFailed(fender) => (FL_EVENT_FENDER_FAILED, fender.0),
            EventKind::NotConverged => (FL_EVENT_NOT_CONVERGED, FL_NONE),
            EventKind::PlacedInOverlap => (FL_EVENT_PLACED_IN_OVERLAP, FL_NONE),
            EventKind::MassMismatch => (FL_EVENT_MASS_MISMATCH, FL_NONE),
        };
        let [body_1, body_2] = event.bodies.map(|body| body.0);
        FlEvent { size: size_of::<FlEvent>(), kind, body_1, body_2, fender }
    }
}
