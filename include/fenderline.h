/*
 * fenderline: contact forces between ships, fenders, quays and tugs, for simulators.
 *
 * Generated from crates/capi by cbindgen: make changes there. docs/guides/c.md shows how to use it.
 *
 * Objects. fl_engine and fl_builder are handles. They are looked up in a table and never dereferenced, so a handle that
 * is NULL, destroyed, of the wrong kind or invalid is refused with a status.
 *
 * Statuses. Every call that can fail returns an fl_status. If it is not FL_STATUS_OK, the call has changed nothing, and
 * an error message is available: from fl_last_error() for the calling thread, from fl_engine_error() and
 * fl_builder_error() for an object. A bug in the library does not unwind into the caller: the status is
 * FL_STATUS_PANICKED, and the object can only be destroyed.
 *
 * Pointers. NULL and misaligned pointers are refused unless stated otherwise. A pointer must point to as much memory as
 * its type, count or length requires; the library cannot check that. For arrays with one element per body, `count` must
 * be the number of bodies.
 *
 * Structures that begin with `size` are refused if it is not their sizeof: fl_settings_init(), fl_body_init() and the like at
 * the end of this file set it, and zero the rest. fl_state, fl_wrench and fl_fender_view have no size member; a change of
 * their layout would change FL_ABI_VERSION.
 *
 * Texts passed in are UTF-8 with a length in bytes; the length FL_NUL means that the text is NUL-terminated. Texts
 * returned are copied to a buffer of `capacity` bytes and NUL-terminated; `*length` gets their length without the NUL. A
 * text that does not fit is truncated, and the status is FL_STATUS_BUFFER_TOO_SMALL. NULL and a capacity of 0 query the
 * length alone.
 *
 * Frame. Earth-fixed north and east, headings clockwise from north, SI units throughout.
 *
 * Threads. Any function may be called from any thread. Calls on different objects run concurrently; of two calls on one
 * object the second waits for the first. An object that is destroyed during a call lives until the call returns. Engines
 * share no state: two in one process give the same bits as each alone.
 */

#ifndef FENDERLINE_H
#define FENDERLINE_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/**
 * Length of a text that is NUL-terminated.
 */
#define FL_NUL SIZE_MAX


/**
 * Version of this interface. The interface version changes when programs must be compiled anew.
 */
#define FL_ABI_VERSION 1

/**
 * Stands for no fender, where the outline of one body meets the outline of another.
 */
#define FL_NONE UINT32_MAX

/**
 * fl_settings.method: the method of the scenario; FL_METHOD_COUPLED if there is no scenario.
 */
#define FL_METHOD_DEFAULT 0

/**
 * fl_settings.method: all contacts of a step are solved together with the loads.
 */
#define FL_METHOD_COUPLED 1

/**
 * fl_settings.method: the method of the TransNav paper (Moreno et al. 2023), which treats each pair of bodies by
 * itself and without loads.
 */
#define FL_METHOD_PAPER 2

/**
 * fl_settings.host: a direct host. A direct host passes the states at the start of each step, and all loads. A direct
 * host may take the states of fl_engine_states_after(), or integrate the bodies itself with the wrenches, in steps of
 * any length. If a direct host integrates the bodies itself by the coupled method, the engine continues the motion
 * that it has computed while bodies touch, and the wrenches keep the host on this motion.
 */
#define FL_HOST_DIRECT 0

/**
 * fl_settings.host: a co-simulation host, such as a co-simulation master or the loop of a game. A co-simulation host
 * integrates the bodies itself in steps of any length, may pass states that are some steps old, and need not report
 * loads. For a co-simulation host the engine infers the loads from the states, predicts the present states, and
 * returns wrenches with which the host follows the engine's motion. Coupled method only.
 */
#define FL_HOST_COSIMULATION 1

/**
 * fl_settings.coriolis: the engine or the host's loads have the Coriolis terms, as in `fenderline run` with the
 * scenario's integrator; without a scenario, FL_CORIOLIS_BY_ENGINE is taken.
 */
#define FL_CORIOLIS_DEFAULT 0

/**
 * fl_settings.coriolis: the host's loads do not contain the Coriolis and centripetal terms of a body's added mass; the
 * engine adds them.
 */
#define FL_CORIOLIS_BY_ENGINE 1

/**
 * fl_settings.coriolis: the host's loads contain the Coriolis and centripetal terms of a body's added mass.
 */
#define FL_CORIOLIS_IN_LOADS 2

/**
 * fl_settings.integration: the host moves positions with the old velocities, then changes the velocities.
 */
#define FL_INTEGRATION_FORWARD_EULER 0

/**
 * fl_settings.integration: the host changes the velocities, then moves positions with the new velocities.
 */
#define FL_INTEGRATION_SEMI_IMPLICIT 1

/**
 * fl_event.kind: a contact patch began.
 */
#define FL_EVENT_CONTACT_BEGAN 0

/**
 * fl_event.kind: a contact patch ended.
 */
#define FL_EVENT_CONTACT_ENDED 1

/**
 * fl_event.kind: one patch split into several.
 */
#define FL_EVENT_PATCH_SPLIT 2

/**
 * fl_event.kind: several patches merged into one.
 */
#define FL_EVENT_PATCHES_MERGED 3

/**
 * fl_event.kind: one body lies wholly within the other.
 */
#define FL_EVENT_CONTAINED 4

/**
 * fl_event.kind: the overlap is more than half the smaller body's area.
 */
#define FL_EVENT_DEEP_OVERLAP 5

/**
 * fl_event.kind: a body was displaced by a tenth of its outline's radius more than its velocities explain, or
 * fl_engine_mark_teleported() was called for it; its contacts begin anew. The radius of an outline is the largest
 * distance of one of its vertices from the centre of gravity.
 */
#define FL_EVENT_TELEPORTED 6

/**
 * fl_event.kind: a fender is deflected beyond its rated deflection.
 */
#define FL_EVENT_FENDER_RATING_EXCEEDED 7

/**
 * fl_event.kind: a fender is pressed until its stop takes load, or by its whole projection.
 */
#define FL_EVENT_FENDER_FAILED 8

/**
 * fl_event.kind: the solver of the contact between these bodies did not converge within its limit of iterations.
 */
#define FL_EVENT_NOT_CONVERGED 9

/**
 * fl_event.kind: a body was placed so deep in another body that the contact would eject it. A body that was placed
 * deep in another body is pushed out slowly, at 0.08 m/s at most.
 */
#define FL_EVENT_PLACED_IN_OVERLAP 10

/**
 * fl_event.kind: a body of a co-simulation host does not accelerate as its mass in the model says: the host uses another
 * mass (see fl_engine_mass_matrix()). Reported once per body.
 */
#define FL_EVENT_MASS_MISMATCH 11

/**
 * fl_contact.flags: the contact slips; otherwise it sticks.
 */
#define FL_CONTACT_SLIPS 1

/**
 * fl_contact.flags: the limit by the momentum of the bodies reduced the normal or the tangential force of the contact.
 */
#define FL_CONTACT_LIMITED 2

/**
 * Result of a call. If the status is not FL_STATUS_OK, the object is unchanged, and fl_last_error() has a message.
 */
typedef enum {
    /**
     * Success.
     */
    FL_STATUS_OK = 0,
    /**
     * A pointer is NULL but must not be, or is misaligned.
     */
    FL_STATUS_BAD_POINTER = 1,
    /**
     * The handle is invalid, was destroyed or is of another kind.
     */
    FL_STATUS_BAD_HANDLE = 2,
    /**
     * The member `size` of a structure is wrong: the program was compiled with another header.
     */
    FL_STATUS_BAD_SIZE = 3,
    /**
     * A text is not UTF-8, contains a NUL, or is too long.
     */
    FL_STATUS_BAD_TEXT = 4,
    /**
     * An argument is an unknown constant or a wrong count, or settings conflict.
     */
    FL_STATUS_BAD_ARGUMENT = 5,
    /**
     * A file cannot be read, or a scenario or the keys of a fender have an error: the message names file, line and key.
     */
    FL_STATUS_BAD_SCENARIO = 6,
    /**
     * Bodies, materials, pairs or fenders are not valid: the message names the part and the field.
     */
    FL_STATUS_BAD_MODEL = 7,
    /**
     * A state, a load or a time step is not finite or out of range: the message names body and field. Also: the step
     * is so long that its results are not finite.
     */
    FL_STATUS_BAD_NUMBER = 8,
    /**
     * No body, fender, material, contact or event has this name or index.
     */
    FL_STATUS_NO_SUCH = 9,
    /**
     * A step was asked for before the states of all floating bodies were set, or a result before the first step.
     */
    FL_STATUS_OUT_OF_ORDER = 10,
    /**
     * The result that the call asks for is not available with the engine's settings.
     */
    FL_STATUS_NOT_AVAILABLE = 11,
    /**
     * The bytes are not a saved engine or not a dump: truncated, changed or of another version.
     */
    FL_STATUS_BAD_BYTES = 12,
    /**
     * The saved engine belongs to another model or to other settings.
     */
    FL_STATUS_OTHER_MODEL = 13,
    /**
     * The buffer is too small; `*length` says how large the buffer must be.
     */
    FL_STATUS_BUFFER_TOO_SMALL = 14,
    /**
     * The call met a bug in the library. After a bug in the library the handle can only be destroyed.
     */
    FL_STATUS_PANICKED = 15,
} fl_status;

/**
 * A builder object: the parts from which engines are made.
 */
typedef struct fl_builder fl_builder;

/**
 * A contact engine. Engines share nothing but the table of handles.
 */
typedef struct fl_engine fl_engine;

/**
 * Contact parameters of a pair of bodies.
 */
typedef struct {
    /**
     * sizeof(fl_material)
     */
    size_t size;
    /**
     * Area stiffness (N/m2).
     */
    double stiffness_npm2;
    /**
     * Area damping (N s/m2).
     */
    double damping_nspm2;
    /**
     * Shear stiffness (N/m).
     */
    double shear_stiffness_npm;
    /**
     * Coefficient of static friction.
     */
    double friction_static;
    /**
     * Coefficient of dynamic friction, at most the coefficient of static friction.
     */
    double friction_dynamic;
    /**
     * Coefficient of restitution, 0 to 1.
     */
    double restitution;
} fl_material;

/**
 * A body. The body's outline is a separate argument.
 */
typedef struct {
    /**
     * sizeof(fl_body)
     */
    size_t size;
    /**
     * Displacement (kg). A fixed body has 0 as displacement and for all other masses.
     */
    double mass_kg;
    /**
     * Moment of inertia of the body about the vertical (kg m2).
     */
    double yaw_inertia_kgm2;
    /**
     * Added mass of the body in surge (kg).
     */
    double added_surge_kg;
    /**
     * Added mass of the body in sway (kg).
     */
    double added_sway_kg;
    /**
     * Added moment of inertia of the body in yaw (kg m2).
     */
    double added_yaw_kgm2;
    /**
     * North coordinate of a fixed body, or of a floating body at the start (m).
     */
    double north_m;
    /**
     * East coordinate of a fixed body, or of a floating body at the start (m).
     */
    double east_m;
    /**
     * Heading of a fixed body; initial heading of a floating body (rad).
     */
    double heading_rad;
} fl_body;

/**
 * A fender: a face on a body. The fender's reaction curve is a separate argument. The fender touches the outlines of
 * all bodies that form a pair with the fender's body.
 */
typedef struct {
    /**
     * sizeof(fl_fender)
     */
    size_t size;
    /**
     * Forward coordinate of the middle of the fender's mounting line, in the body's frame (m).
     */
    double forward_m;
    /**
     * Starboard coordinate of the middle of the fender's mounting line, in the body's frame (m).
     */
    double starboard_m;
    /**
     * Direction of the fender's outward normal, in the body's frame: 0 forward, positive to starboard (rad).
     */
    double facing_rad;
    /**
     * Width of the fender's face (m).
     */
    double width_m;
    /**
     * Distance from the fender's mounting to its uncompressed face (m).
     */
    double projection_m;
    /**
     * Rated deflection of the fender (m); 0 means that it equals the projection. The rated deflection must be 0 for a
     * fender without a reaction curve.
     */
    double rated_deflection_m;
    /**
     * Deflection at which the fender's stop begins to take load (m).
     */
    double stop_from_m;
    /**
     * Stiffness of the fender's stop (N/m). A fender without a stop has 0 for the stop's deflection and stiffness.
     */
    double stop_stiffness_npm;
    /**
     * Index of the body on which the fender is mounted.
     */
    uint32_t body;
    /**
     * Index of the fender's material: friction, restitution, damping, and, without a curve, stiffness.
     */
    uint32_t material;
    /**
     * Share of the absorbed energy that the fender returns when it is unloaded by an unloading law, 0.05 to 1. The
     * value 0 means that the fender unloads by the restitution of its material.
     */
    double returned_energy;
} fl_fender;

/**
 * Settings of an engine; every member except `size` may be 0, which means the default.
 */
typedef struct {
    /**
     * sizeof(fl_settings)
     */
    size_t size;
    /**
     * FL_METHOD_...
     */
    uint32_t method;
    /**
     * FL_HOST_...
     */
    uint32_t host;
    /**
     * One of the constants FL_CORIOLIS_... for a direct host; 0 for a co-simulation host, whose loads always contain
     * the Coriolis terms.
     */
    uint32_t coriolis;
    /**
     * One of the constants FL_INTEGRATION_... for a co-simulation host; 0 for a direct host.
     */
    uint32_t integration;
    /**
     * Age of the states that a co-simulation host passes (steps), at most 1000; 0 for a direct host.
     */
    uint32_t delay_steps;
} fl_settings;

/**
 * Position and velocity of a body's centre of gravity, earth-fixed.
 */
typedef struct {
    /**
     * Position (m).
     */
    double north_m;
    /**
     * Position (m).
     */
    double east_m;
    /**
     * Clockwise from north (rad).
     */
    double heading_rad;
    /**
     * Velocity (m/s).
     */
    double north_mps;
    /**
     * Velocity (m/s).
     */
    double east_mps;
    /**
     * Rate of turn of the body, positive to starboard (rad/s).
     */
    double yaw_rate_radps;
} fl_state;

/**
 * A force at a body's centre of gravity and a moment about the centre of gravity, earth-fixed.
 */
typedef struct {
    /**
     * Force (N).
     */
    double north_n;
    /**
     * Force (N).
     */
    double east_n;
    /**
     * Moment about the vertical, positive to starboard (N m).
     */
    double moment_nm;
} fl_wrench;

/**
 * One contact patch in the last step. The force on body 1 is -normal_force_n times the normal and tangential_force_n
 * times the normal turned by +90 degrees (north to east); on body 2 exactly the opposite. By the coupled method the
 * forces of a contact are means over the step; its peaks cover all sub-steps.
 */
typedef struct {
    /**
     * Size of the structure, sizeof(fl_contact), which the caller must set.
     */
    size_t size;
    /**
     * The body added first.
     */
    uint32_t body_1;
    /**
     * The body added later.
     */
    uint32_t body_2;
    /**
     * Index of the fender that is compressed; FL_NONE if outline meets outline.
     */
    uint32_t fender;
    /**
     * Number of the contact patch within its pair of bodies.
     */
    uint32_t patch;
    /**
     * Sum of FL_CONTACT_...
     */
    uint32_t flags;
    /**
     * Always 0.
     */
    uint32_t reserved;
    /**
     * Area of the overlap of the two outlines (m2).
     */
    double area_m2;
    /**
     * Extent of the overlap of the outlines along the normal, or deflection of the fender (m).
     */
    double depth_m;
    /**
     * North coordinate of the point where the contact force acts (m).
     */
    double north_m;
    /**
     * East coordinate of the point where the contact force acts (m).
     */
    double east_m;
    /**
     * North component of body 1's outward unit normal.
     */
    double normal_north;
    /**
     * East component of body 1's outward unit normal.
     */
    double normal_east;
    /**
     * Speed at which the two bodies approach each other along the normal (m/s).
     */
    double v_normal_mps;
    /**
     * Speed of body 1 relative to body 2 along the tangent (m/s).
     */
    double v_tangential_mps;
    /**
     * Deflection of the contact's shear spring, from which friction is computed (m).
     */
    double shear_m;
    /**
     * Normal force of the contact, at least 0 (N).
     */
    double normal_force_n;
    /**
     * Tangential force of the contact on body 1 (N).
     */
    double tangential_force_n;
    /**
     * Largest normal force of the contact within the step (N).
     */
    double peak_normal_force_n;
    /**
     * Largest depth of the contact within the step (m).
     */
    double peak_depth_m;
    /**
     * Part of the normal force that the area spring or the reaction curve gives (N).
     */
    double spring_n;
    /**
     * Part of the normal force that the stop at the end of a fender's travel gives (N).
     */
    double stop_n;
    /**
     * Part of the normal force that the damper gives (N).
     */
    double damper_n;
    /**
     * Part of the normal force that the momentum limit took away (N).
     */
    double limiter_n;
    /**
     * Energy that the fender's spring and stop hold at the start of the step and can return (J); 0 if outline meets
     * outline.
     */
    double stored_j;
    /**
     * Largest energy within the step that it takes to load the fender to its deflection (J).
     */
    double peak_absorbed_j;
    /**
     * Angle between a fender's face and the hull (rad).
     */
    double tilt_rad;
    /**
     * Factor by which a fender's reaction is multiplied, set when the contact began.
     */
    double factor;
    /**
     * Energy that a fender with the member returned_energy set has dissipated within the step (J).
     */
    double hysteresis_j;
} fl_contact;

/**
 * An event, reported in the step in which it begins.
 */
typedef struct {
    /**
     * Size of the structure, sizeof(fl_event), which the caller must set.
     */
    size_t size;
    /**
     * FL_EVENT_...
     */
    uint32_t kind;
    /**
     * The body.
     */
    uint32_t body_1;
    /**
     * Index of the second body of the event; equal to body_1 if the event concerns only one body.
     */
    uint32_t body_2;
    /**
     * Index of the fender of the event; FL_NONE if the event concerns no fender.
     */
    uint32_t fender;
} fl_event;

/**
 * Drawing data of a fender, in the frame of the body that carries the fender (forward, starboard of the body's centre
 * of gravity): draw the fender as a child of this body. Seen when looking out from the body, end 1 of the mounting
 * line and of the face is left, and end 2 is right.
 */
typedef struct {
    /**
     * Index of the body that carries the fender.
     */
    uint32_t body;
    /**
     * Index of the body that presses the fender; if several do, of the body that presses deepest. FL_NONE means that
     * no body presses the fender.
     */
    uint32_t hull;
    /**
     * Forward coordinate of end 1 of the line where the fender is mounted (m).
     */
    double mount_1_forward_m;
    /**
     * Starboard coordinate of end 1 of the line where the fender is mounted (m).
     */
    double mount_1_starboard_m;
    /**
     * Forward coordinate of end 2 of the line where the fender is mounted (m).
     */
    double mount_2_forward_m;
    /**
     * Starboard coordinate of end 2 of the line where the fender is mounted (m).
     */
    double mount_2_starboard_m;
    /**
     * Forward coordinate of end 1 of the fender's face in its present compression and turn (m).
     */
    double face_1_forward_m;
    /**
     * Starboard coordinate of end 1 of the fender's face (m).
     */
    double face_1_starboard_m;
    /**
     * Forward coordinate of end 2 of the fender's face in its present compression and turn (m).
     */
    double face_2_forward_m;
    /**
     * Starboard coordinate of end 2 of the fender's face (m).
     */
    double face_2_starboard_m;
    /**
     * Deflection of the fender in the last step (m); 0 if no body presses the fender.
     */
    double deflection_m;
    /**
     * Rated deflection (m).
     */
    double rated_deflection_m;
    /**
     * Mean normal force of all bodies on the fender over the last step (N), for an instrument to show.
     */
    double normal_force_n;
    /**
     * Largest normal force of a single body on the fender within the last step (N), for an alarm.
     */
    double peak_normal_force_n;
    /**
     * Largest deflection of the fender within the last step (m).
     */
    double peak_deflection_m;
    /**
     * Turn of a panel on several cones about the vertical (rad), positive if the right end, as you look at the
     * face, is deflected more; 0 for other fenders.
     */
    double panel_turn_rad;
} fl_fender_view;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * The interface version of the linked library; a program compares it with the header's FL_ABI_VERSION.
 */
uint32_t fl_abi_version(void);

/**
 * The library's version, such as "0.1.0". The text is static.
 */
const char *fl_version(void);

/**
 * Short description of a status of the interface; any number is accepted. The text is static.
 */
const char *fl_status_text(int32_t status);

/**
 * Copies the message of the last failed call on this thread; empty if no call has failed. The message of a failed call
 * stays until another call fails; a call of fl_last_error() with too small a buffer does not count as a failed call.
 * `length` may be NULL. For the buffer see "Texts" in the preamble of this header.
 */
fl_status fl_last_error(char *buffer,
                        size_t capacity,
                        size_t *length);

/**
 * Copies the convex hull of points, such as all vertices of a ship's mesh seen from above: pairs of x (forward) and y
 * (to starboard) (m). `capacity` counts vertices; `*vertices` gets their number, at most `points`. NULL `vertices`
 * with a capacity of 0 only ask for the number of vertices.
 */
fl_status fl_outline_hull(const double *points_m,
                          size_t points,
                          double *outline_m,
                          size_t capacity,
                          size_t *vertices);

/**
 * Copies the outline of a ship that is made from the points of her starboard side, from bow to stern or from stern to
 * bow: these points and their mirror images. Points within `tolerance_m` of the centreline (y = 0) count as points on
 * the centreline, and are not repeated. The outline has at most twice as many vertices as there are `points`. The
 * other arguments are as in fl_outline_hull().
 */
fl_status fl_outline_mirror(const double *side_m,
                            size_t points,
                            double tolerance_m,
                            double *outline_m,
                            size_t capacity,
                            size_t *vertices);

/**
 * Copies a given outline, thinned to fewer vertices. No vertex of the given outline is farther than `tolerance_m` from
 * the new outline. The other arguments are as in fl_outline_hull().
 */
fl_status fl_outline_simplify(const double *points_m,
                              size_t points,
                              double tolerance_m,
                              double *outline_m,
                              size_t capacity,
                              size_t *vertices);

/**
 * Makes an empty builder at `*builder`, to be destroyed by fl_builder_destroy().
 */
fl_status fl_builder_new(fl_builder **builder);

/**
 * Destroys a builder. Engines that a destroyed builder has built stay valid. A NULL builder is allowed and does
 * nothing.
 */
fl_status fl_builder_destroy(fl_builder *builder);

/**
 * Copies the message of the last failed call on this builder, in the way of fl_last_error().
 */
fl_status fl_builder_error(const fl_builder *builder,
                           char *buffer,
                           size_t capacity,
                           size_t *length);

/**
 * Adds a material under a unique name. The index of the material, counted from 0, is stored to `*index` unless `index`
 * is NULL. fl_builder_build() checks the material's numbers.
 */
fl_status fl_builder_add_material(fl_builder *builder,
                                  const char *name,
                                  size_t name_length,
                                  const fl_material *material,
                                  uint32_t *index);

/**
 * Adds a body under a unique name, with its outline: `vertices` pairs of x (forward) and y (to starboard) from the
 * centre of gravity (m), in either sense, convex or not. The index of the body, counted from 0, is stored to `*index`
 * unless `index` is NULL. fl_builder_build() checks the body's masses.
 */
fl_status fl_builder_add_body(fl_builder *builder,
                              const char *name,
                              size_t name_length,
                              const fl_body *body,
                              const double *outline_m,
                              size_t vertices,
                              uint32_t *index);

/**
 * Adds a fender under a unique name, with its reaction curve: `points` pairs of deflection (m) and reaction (N), which
 * begin with (0, 0), with rising deflections. Without points the force follows the law of the TransNav paper (Moreno
 * et al. 2023): the material's stiffness times the area of the overlap. The index of the fender, counted from 0, is
 * stored to `*index` unless `index` is NULL. fl_builder_build() checks the fender's numbers.
 */
fl_status fl_builder_add_fender(fl_builder *builder,
                                const char *name,
                                size_t name_length,
                                const fl_fender *fender,
                                const double *curve,
                                size_t points,
                                uint32_t *index);

/**
 * Adds a fender under a unique name by the keys of a scenario file's `[fender.NAME]`, one KEY=VALUE per line: a fender
 * of the catalogue by type and size, its temperature, several cones behind one panel, chains. Values carry units. The
 * key `on` names the body that carries the fender, and `material` its material; add body and material before the
 * fender. The key reference of scenario files lists all other keys of a fender. Example of the keys of a fender:
 * "on=quay\nmaterial=rubber\ntype=cone\nsize=1050 F1.1\nposition=[0, 12]\nwidth=2 m\ntemperature=40 degC". The index
 * of the fender, counted from 0, is stored to `*index` unless `index` is NULL.
 */
fl_status fl_builder_add_fender_by_keys(fl_builder *builder,
                                        const char *name,
                                        size_t name_length,
                                        const char *keys,
                                        size_t keys_length,
                                        uint32_t *index);

/**
 * Finds the index of a material of a builder by its name.
 */
fl_status fl_builder_find_material(const fl_builder *builder,
                                   const char *name,
                                   size_t name_length,
                                   uint32_t *material);

/**
 * Finds the index of a body of a builder by its name.
 */
fl_status fl_builder_find_body(const fl_builder *builder,
                               const char *name,
                               size_t name_length,
                               uint32_t *body);

/**
 * Finds the index of a fender of a builder by its name.
 */
fl_status fl_builder_find_fender(const fl_builder *builder,
                                 const char *name,
                                 size_t name_length,
                                 uint32_t *fender);

/**
 * Enables contact between two bodies, with a material.
 */
fl_status fl_builder_add_pair(fl_builder *builder,
                              uint32_t body_1,
                              uint32_t body_2,
                              uint32_t material);

/**
 * Enables contact between all pairs of bodies that fl_builder_add_pair() does not name, with a material.
 */
fl_status fl_builder_add_all_other_pairs(fl_builder *builder,
                                         uint32_t material);

/**
 * Builds an engine from the parts added so far and stores it to `*engine`; if building fails, stores NULL. The program
 * destroys the built engine with fl_engine_destroy() when it no longer needs it. `settings` may be NULL: the engine
 * then has the default settings. The builder stays as it was, and can be used further.
 */
fl_status fl_builder_build(fl_builder *builder,
                           const fl_settings *settings,
                           fl_engine **engine);

/**
 * Makes an engine from a scenario file and stores the engine to `*engine`; stores NULL if the file has an error. The
 * program destroys the engine with fl_engine_destroy() when it no longer needs it. Names of files in the scenario are
 * relative to the folder of the scenario file. `overrides` replaces keys of the scenario, with one KEY=VALUE per line,
 * such as "contact.method=coupled"; pass NULL and 0 to replace none. `settings` may be NULL: the engine then has the
 * default settings.
 *
 * The engine takes the scenario's bodies, fenders, materials and pairs. All other forces of the scenario, such as loads
 * and wind, are left to the host: see fl_engine_notices().
 */
fl_status fl_engine_from_file(const char *path,
                              size_t path_length,
                              const char *overrides,
                              size_t overrides_length,
                              const fl_settings *settings,
                              fl_engine **engine);

/**
 * Makes an engine as fl_engine_from_file() does, but from the text of a scenario; the scenario may name no other
 * files.
 */
fl_status fl_engine_from_text(const char *scenario,
                              size_t scenario_length,
                              const char *overrides,
                              size_t overrides_length,
                              const fl_settings *settings,
                              fl_engine **engine);

/**
 * Destroys an engine. Destroying a NULL engine is allowed and does nothing.
 */
fl_status fl_engine_destroy(fl_engine *engine);

/**
 * Copies the message of the last failed call on this engine, in the way of fl_last_error().
 */
fl_status fl_engine_error(const fl_engine *engine, char *buffer, size_t capacity, size_t *length);

/**
 * Resets the engine to its start: it forgets its memory of contacts, the states and the loads. After the reset, the
 * next step counts as the first step.
 */
fl_status fl_engine_reset(fl_engine *engine);

/**
 * Copies the notices about the scenario and the list of the scenario's forces that are left to the host, one per line.
 * The text of the notices may be empty. `length` may be NULL. For the buffer see "Texts" in the preamble of this
 * header.
 */
fl_status fl_engine_notices(const fl_engine *engine,
                            char *buffer,
                            size_t capacity,
                            size_t *length);

/**
 * Number of bodies. Indices of bodies count from 0, in the order of the scenario or of the calls that built the
 * engine.
 */
fl_status fl_engine_body_count(const fl_engine *engine,
                               size_t *count);

/**
 * Copies the name of a body. `length` may be NULL. For the buffer see "Texts" in the preamble of this header.
 */
fl_status fl_engine_body_name(const fl_engine *engine,
                              uint32_t body,
                              char *buffer,
                              size_t capacity,
                              size_t *length);

/**
 * Finds the index of a body by its name.
 */
fl_status fl_engine_find_body(const fl_engine *engine,
                              const char *name,
                              size_t name_length,
                              uint32_t *body);

/**
 * Number of fenders. Indices of fenders count from 0, in the order of the scenario or of the calls that built the
 * engine.
 */
fl_status fl_engine_fender_count(const fl_engine *engine,
                                 size_t *count);

/**
 * Copies the name of a fender. `length` may be NULL. For the buffer see "Texts" in the preamble of this header.
 */
fl_status fl_engine_fender_name(const fl_engine *engine,
                                uint32_t fender,
                                char *buffer,
                                size_t capacity,
                                size_t *length);

/**
 * Finds the index of a fender by its name.
 */
fl_status fl_engine_find_fender(const fl_engine *engine,
                                const char *name,
                                size_t name_length,
                                uint32_t *fender);

/**
 * Copies a body's mass matrix over surge, sway and yaw about its centre of gravity, added mass included, row by row: 9
 * numbers (kg, kg m, kg m2); zeros for a fixed body. A co-simulation host must use this mass matrix to move the body.
 */
fl_status fl_engine_mass_matrix(const fl_engine *engine,
                                uint32_t body,
                                double *matrix);

/**
 * Copies the initial states of the scenario or the builder; `count` is the number of bodies.
 */
fl_status fl_engine_initial_states(const fl_engine *engine, fl_state *states, size_t count);

/**
 * Sets the state of one body for the next step. Fixed bodies need no state.
 */
fl_status fl_engine_set_state(fl_engine *engine, uint32_t body, const fl_state *state);

/**
 * Sets the states of all bodies for the next step; if one state is refused, no state is set. `count` is the number of
 * bodies.
 */
fl_status fl_engine_set_states(fl_engine *engine,
                               const fl_state *states,
                               size_t count);

/**
 * Marks the next state of a body as a teleport: the host sets the body to a new place rather than moving it there. The
 * contacts of a teleported body begin anew (FL_EVENT_TELEPORTED), and no load is inferred from its displacement. A
 * teleported body that overlaps another body is pushed out slowly, with FL_EVENT_PLACED_IN_OVERLAP if the overlap is
 * so deep that the contact would eject the body. Without this call the engine detects a teleport only if the body's
 * displacement differs from what the velocities explain by a tenth of the outline's radius. A host whose states are
 * some steps old makes this call when it first passes the new place of the body. To go back in time, restore a saved
 * engine instead of teleporting its bodies.
 */
fl_status fl_engine_mark_teleported(fl_engine *engine,
                                    uint32_t body);

/**
 * Sets the loads, all forces on each body except contact, until the next call; `count` is the number of bodies. NULL
 * with a count of 0 removes the loads, as at the start: a direct host then has no loads, and the loads of a
 * co-simulation host are inferred from its states. The paper's method does not use loads.
 */
fl_status fl_engine_set_loads(fl_engine *engine,
                              const fl_wrench *loads,
                              size_t count);

/**
 * Takes a step of `step_s` seconds from the states that were set last. Before a step, all floating bodies must have a
 * state. Consecutive steps may have different lengths. A step of 0 s is a pause: nothing moves, and the results are
 * those of the last step, but without events and without the work of the contacts.
 */
fl_status fl_engine_step(fl_engine *engine,
                         double step_s);

/**
 * Does in one call what these do: fl_engine_set_states(), fl_engine_set_loads() if `loads` is not NULL,
 * fl_engine_step() and fl_engine_wrenches(). All arrays of fl_engine_advance() have `count` elements, the number of
 * bodies. If any part of fl_engine_advance() fails, nothing has changed.
 */
fl_status fl_engine_advance(fl_engine *engine,
                            const fl_state *states,
                            const fl_wrench *loads,
                            size_t count,
                            double step_s,
                            fl_wrench *wrenches);

/**
 * Copies the contact wrenches of the last step, which the host adds to its own forces. The wrenches are means over the
 * step, so that they give the bodies the right impulse; for the largest wrenches see fl_engine_peak_wrenches().
 * `count` is the number of bodies.
 */
fl_status fl_engine_wrenches(const fl_engine *engine,
                             fl_wrench *wrenches,
                             size_t count);

/**
 * Copies the largest contact wrench on each body within the last step: the wrench of the sub-step with the largest
 * force. With the paper's method, which has no sub-steps, the largest wrenches are those of fl_engine_wrenches(). Use
 * the largest wrench to size fenders and structures: in a long step the mean wrench may be much smaller. Use
 * fl_engine_wrenches() to move the bodies. The largest force of each single contact is fl_contact.peak_normal_force_n.
 * `count` is the number of bodies.
 */
fl_status fl_engine_peak_wrenches(const fl_engine *engine,
                                  fl_wrench *peaks,
                                  size_t count);

/**
 * Copies the engine's states at the end of the last step, for direct hosts that let the engine move the bodies by the
 * coupled method. `count` is the number of bodies. The positions of these states belong to the end of the step. The
 * velocities of these states belong to the time half a step before the end (half of the last sub-step, if there were
 * several), as in a leapfrog integrator. Pass the velocities back unchanged in the next step; when you compare or plot
 * velocities, use the time to which they belong.
 */
fl_status fl_engine_states_after(const fl_engine *engine,
                                 fl_state *states,
                                 size_t count);

/**
 * Copies the engine's estimate of the present states of a co-simulation host, and the loads on the host's bodies,
 * reported by the host or observed by the engine. `count` is the number of bodies.
 */
fl_status fl_engine_host_estimate(const fl_engine *engine,
                                  fl_state *states,
                                  fl_wrench *loads,
                                  size_t count);

/**
 * Number of contact patches in the last step.
 */
fl_status fl_engine_contact_count(const fl_engine *engine, size_t *count);

/**
 * Copies one contact of the last step; contacts count from 0 in a fixed order. The caller sets `contact->size`.
 */
fl_status fl_engine_contact(const fl_engine *engine,
                            uint32_t index,
                            fl_contact *contact);

/**
 * Copies all contacts of the last step, in their fixed order. `element_size` is sizeof(fl_contact); the member `size`
 * of the elements need not be set. `*count` gets the number of contacts. A NULL array with a capacity of 0 only asks
 * for the number of contacts; if the capacity is too small, nothing is copied, and the status is
 * FL_STATUS_BUFFER_TOO_SMALL.
 */
fl_status fl_engine_contacts(const fl_engine *engine,
                             fl_contact *contacts,
                             size_t element_size,
                             size_t capacity,
                             size_t *count);

/**
 * Number of events of the last step.
 */
fl_status fl_engine_event_count(const fl_engine *engine, size_t *count);

/**
 * Copies one event of the last step; events count from 0 in a fixed order. The caller sets `event->size`.
 */
fl_status fl_engine_event(const fl_engine *engine,
                          uint32_t index,
                          fl_event *event);

/**
 * Copies all events of the last step, in their fixed order. `element_size` is sizeof(fl_event). The other arguments
 * are as in fl_engine_contacts().
 */
fl_status fl_engine_events(const fl_engine *engine,
                           fl_event *events,
                           size_t element_size,
                           size_t capacity,
                           size_t *count);

/**
 * Saves all of the engine that steps change, its results included, as bytes. The bytes of a saved engine have a
 * version and a checksum, and are the same on every machine. A NULL buffer with a capacity of 0 only asks for the
 * number of bytes, in `*length`.
 */
fl_status fl_engine_save(const fl_engine *engine,
                         uint8_t *buffer,
                         size_t capacity,
                         size_t *length);

/**
 * Restores an engine from bytes that fl_engine_save() made, of this engine or of another engine with the same model
 * and settings. The restored engine continues to the same bits as the saved engine. Any bytes may be passed: bytes
 * that are not a saved engine are refused.
 */
fl_status fl_engine_restore(fl_engine *engine,
                            const uint8_t *saved,
                            size_t length);

/**
 * Copies the outline of a body: `vertices` gets pairs of x (forward) and y (to starboard) from the centre of gravity
 * (m), in the sense of rotation from x to y. `capacity` is the room in `vertices`; `*vertices` gets the number of
 * vertices of the outline. NULL `vertices` with a capacity of 0 only ask for the number of vertices. If the capacity
 * is too small for the outline, nothing is copied, and the status is FL_STATUS_BUFFER_TOO_SMALL. Outlines of bodies do
 * not change, so that a program need read them only once.
 */
fl_status fl_engine_outline(const fl_engine *engine,
                            uint32_t body,
                            double *outline_m,
                            size_t capacity,
                            size_t *vertices);

/**
 * Copies the drawing data of all fenders after the last step. A fender counts as uncompressed before the first step,
 * and while nothing presses it. `count` is the number of fenders of the engine.
 */
fl_status fl_engine_fender_views(const fl_engine *engine,
                                 fl_fender_view *views,
                                 size_t count);

/**
 * Records the engine's steps from now on, and keeps at least the last `steps` steps (at most 1 000 000); `steps` = 0
 * ends the recording. A step takes longer while the engine records.
 */
fl_status fl_engine_record(fl_engine *engine,
                           size_t steps);

/**
 * Copies the recorded steps with all that is needed to replay them: model, settings, and the engine before the first
 * recorded step. fl_engine_dump() also works after a failed step, even after FL_STATUS_PANICKED. Write the bytes of
 * the dump to a file and send the file with your report of a bug: `fenderline replay FILE` takes the same steps. A
 * NULL buffer with a capacity of 0 only asks for the length of the dump, in `*length`.
 */
fl_status fl_engine_dump(const fl_engine *engine,
                         uint8_t *buffer,
                         size_t capacity,
                         size_t *length);

/**
 * Replays a dump: makes an engine, takes the recorded steps and stores the engine after the last step to `*engine`,
 * unless `engine` is NULL. `*different` gets the number of replayed steps that did not end as recorded, bit for bit;
 * it is 0 with the same version of the library. `*steps` gets the number of all steps in the dump. The pointers
 * `different` and `steps` may be NULL. The `dump` may consist of any bytes: the call refuses bytes that are not a
 * dump.
 */
fl_status fl_replay_dump(const uint8_t *dump,
                         size_t length,
                         size_t *steps,
                         size_t *different,
                         fl_engine **engine);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* FENDERLINE_H */

/*
 * Structures with `size` set and all else 0, ready to be filled in: C99 and C++11.
 */
static inline fl_settings fl_settings_init(void)
{
    fl_settings made;
    memset(&made, 0, sizeof made);
    made.size = sizeof made;
    return made;
}
static inline fl_material fl_material_init(void)
{
    fl_material made;
    memset(&made, 0, sizeof made);
    made.size = sizeof made;
    return made;
}
static inline fl_body fl_body_init(void)
{
    fl_body made;
    memset(&made, 0, sizeof made);
    made.size = sizeof made;
    return made;
}
static inline fl_fender fl_fender_init(void)
{
    fl_fender made;
    memset(&made, 0, sizeof made);
    made.size = sizeof made;
    return made;
}
static inline fl_contact fl_contact_init(void)
{
    fl_contact made;
    memset(&made, 0, sizeof made);
    made.size = sizeof made;
    return made;
}
static inline fl_event fl_event_init(void)
{
    fl_event made;
    memset(&made, 0, sizeof made);
    made.size = sizeof made;
    return made;
}
