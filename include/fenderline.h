/*
 * fenderline: contact forces between ships, fenders, quays and tugs, for simulators.
 *
 * Made from crates/capi by cbindgen: change it there. docs/guides/c.md shows how it is used.
 *
 * Objects. fl_engine and fl_builder are handles: they are looked up in a table and never followed, so that one
 * that is NULL, was destroyed, is of the other kind or never was a handle is refused with a status.
 *
 * Statuses. Every call that can fail returns an fl_status. Anything but FL_STATUS_OK has changed nothing, and
 * leaves a text for people: fl_last_error() for the calling thread, fl_engine_error() and fl_builder_error()
 * for an object. No fault of the library unwinds into the caller: it is FL_STATUS_PANICKED, and the object
 * can only be destroyed.
 *
 * Pointers. NULL and pointers that are not aligned are refused where not said otherwise. A pointer must point
 * to as much memory as its type, count or length says: no library can check that. Arrays that have one
 * member a body are refused, before they are read, where `count` is another number.
 *
 * Structures that begin with `size` are refused where that is not sizeof: set it, and zero the rest. fl_state
 * and fl_wrench are as they are; a change of them would change FL_ABI_VERSION.
 *
 * Texts that are given are UTF-8 and have a length in bytes; FL_NUL for the length says that they end with a
 * NUL. Texts that are asked for go to a buffer of `capacity` bytes with a NUL behind them; `*length` gets
 * their length without it. A text that does not fit is cut, and the status is FL_STATUS_BUFFER_TOO_SMALL.
 * NULL and a capacity of 0 ask for the length alone.
 *
 * Frame. Earth-fixed north and east, headings clockwise from north, SI units throughout.
 *
 * Threads. Any function may be called from any thread. Calls on different objects run at the same time; of two
 * calls on one object the second waits for the first. An object that is destroyed while a call on it runs
 * ends with that call. Engines share nothing: two in one process give the bits that each would alone.
 */

#ifndef FENDERLINE_H
#define FENDERLINE_H

#include <stddef.h>
#include <stdint.h>

/**
 * Given for the length of a text: it ends with a NUL.
 */
#define FL_NUL SIZE_MAX


/**
 * Version of this interface. It changes when a program must be compiled anew.
 */
#define FL_ABI_VERSION 1

/**
 * No fender: two outlines touch.
 */
#define FL_NONE UINT32_MAX

/**
 * fl_settings.method: the scenario's; FL_METHOD_COUPLED where there is no scenario.
 */
#define FL_METHOD_DEFAULT 0

/**
 * fl_settings.method: all contacts of a step are solved together with the loads.
 */
#define FL_METHOD_COUPLED 1

/**
 * fl_settings.method: the paper's, each pair by itself and without loads.
 */
#define FL_METHOD_PAPER 2

/**
 * fl_settings.host: it shows the states of each step's beginning and tells all its loads. It may go on with
 * fl_engine_states_after(), or move its bodies by itself with the wrenches, in steps of any lengths: by the coupled
 * method the engine then goes on from where it was itself while bodies touch, and the wrenches keep the host beside it.
 */
#define FL_HOST_DIRECT 0

/**
 * fl_settings.host: it moves its bodies by itself, may show old states and need not tell its loads, as a
 * co-simulation master or the loop of a game. Its steps may be of any lengths. The engine finds the loads in the states, reckons the states that it is not shown yet,
 * and gives wrenches that take the host where the engine went. By the coupled method only.
 */
#define FL_HOST_COSIMULATION 1

/**
 * fl_settings.coriolis: as `fenderline run` has it with the scenario's integrator; FL_CORIOLIS_BY_ENGINE where
 * there is no scenario.
 */
#define FL_CORIOLIS_DEFAULT 0

/**
 * fl_settings.coriolis: the loads that the host tells are without the Coriolis and centripetal terms of a
 * body's added mass, which the engine adds.
 */
#define FL_CORIOLIS_BY_ENGINE 1

/**
 * fl_settings.coriolis: the loads that the host tells hold these terms.
 */
#define FL_CORIOLIS_IN_LOADS 2

/**
 * fl_settings.integration: the host moves positions with the old velocities, then changes the velocities.
 */
#define FL_INTEGRATION_FORWARD_EULER 0

/**
 * fl_settings.integration: the host changes the velocities, then moves positions with the new ones.
 */
#define FL_INTEGRATION_SEMI_IMPLICIT 1

/**
 * fl_event.kind: a patch of contact came into being.
 */
#define FL_EVENT_CONTACT_BEGAN 0

/**
 * fl_event.kind: a patch of contact ceased.
 */
#define FL_EVENT_CONTACT_ENDED 1

/**
 * fl_event.kind: one patch became several.
 */
#define FL_EVENT_PATCH_SPLIT 2

/**
 * fl_event.kind: several patches became one.
 */
#define FL_EVENT_PATCHES_MERGED 3

/**
 * fl_event.kind: one body lies wholly within the other.
 */
#define FL_EVENT_CONTAINED 4

/**
 * fl_event.kind: the overlap is deeper than half the smaller body is wide.
 */
#define FL_EVENT_DEEP_OVERLAP 5

/**
 * fl_event.kind: a body moved by a tenth of the radius of its outline more than its velocities explain, or
 * fl_engine_mark_teleported() said that it was put there; its contacts start afresh. The radius is the largest distance of a
 * vertex from the centre of gravity.
 */
#define FL_EVENT_TELEPORTED 6

/**
 * fl_event.kind: a fender is deflected beyond what it is rated for.
 */
#define FL_EVENT_FENDER_RATING_EXCEEDED 7

/**
 * fl_event.kind: a fender is in its stop, or as deep as it projects.
 */
#define FL_EVENT_FENDER_FAILED 8

/**
 * fl_event.kind: the solve of these bodies' contact did not settle within its bounded work.
 */
#define FL_EVENT_NOT_CONVERGED 9

/**
 * fl_event.kind: a body was put into another, so deep that the contact would throw it out faster: it is pressed out
 * instead, at 0.08 m/s at most.
 */
#define FL_EVENT_PLACED_IN_OVERLAP 10

/**
 * fl_event.kind: a body answers the wrenches that a following host is given otherwise than its mass in the model
 * says: the host moves it with another (fl_engine_mass_matrix()). Told once a body.
 */
#define FL_EVENT_MASS_MISMATCH 11

/**
 * fl_contact.flags: the friction slips; else it sticks.
 */
#define FL_CONTACT_SLIPS 1

/**
 * fl_contact.flags: the limit from momentum cut the normal or the tangential force.
 */
#define FL_CONTACT_LIMITED 2

/**
 * How a call ended. Anything but FL_STATUS_OK leaves the object as it was, and a text for people that
 * fl_last_error() gives.
 */
typedef enum {
    /**
     * Done.
     */
    FL_STATUS_OK = 0,
    /**
     * A pointer is NULL that may not be, or is not aligned for what it points to.
     */
    FL_STATUS_BAD_POINTER = 1,
    /**
     * The handle stands for nothing: it was destroyed, is one of another kind, or never was one.
     */
    FL_STATUS_BAD_HANDLE = 2,
    /**
     * The member `size` of a structure is not its size: the program was compiled with another header.
     */
    FL_STATUS_BAD_SIZE = 3,
    /**
     * A text that is not UTF-8, holds a NUL, or is too long.
     */
    FL_STATUS_BAD_TEXT = 4,
    /**
     * A constant, a count or settings that are none or do not go together.
     */
    FL_STATUS_BAD_ARGUMENT = 5,
    /**
     * A file that cannot be read, or a mistake in a scenario: the text says file, line and key.
     */
    FL_STATUS_BAD_SCENARIO = 6,
    /**
     * Bodies, materials, pairs and fenders that make no model: the text names which and what.
     */
    FL_STATUS_BAD_MODEL = 7,
    /**
     * A state, a load or a time step that is not finite or out of range: the text names body and field; or a
     * step so long that its results are not finite.
     */
    FL_STATUS_BAD_NUMBER = 8,
    /**
     * No body, fender, material, contact or event of that name or index.
     */
    FL_STATUS_NO_SUCH = 9,
    /**
     * A step before all floating bodies were shown, or a result before the first step.
     */
    FL_STATUS_OUT_OF_ORDER = 10,
    /**
     * Something that an engine of these settings does not have.
     */
    FL_STATUS_NOT_AVAILABLE = 11,
    /**
     * Bytes that are no saved engine: cut, changed or of another version.
     */
    FL_STATUS_BAD_BYTES = 12,
    /**
     * The saved engine is that of another model, or of other settings.
     */
    FL_STATUS_OTHER_MODEL = 13,
    /**
     * The buffer is too small; `*length` says how large it must be.
     */
    FL_STATUS_BUFFER_TOO_SMALL = 14,
    /**
     * A fault of the library itself. The handle can only be destroyed.
     */
    FL_STATUS_PANICKED = 15,
} fl_status;

/**
 * Parts from which an engine is to be made.
 */
typedef struct fl_builder fl_builder;

/**
 * An engine. Of its own, with nothing shared but the table of handles.
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
     * Coefficient of dynamic friction, at most the static one.
     */
    double friction_dynamic;
    /**
     * Coefficient of restitution, 0 to 1.
     */
    double restitution;
} fl_material;

/**
 * A body. Its outline is given apart.
 */
typedef struct {
    /**
     * sizeof(fl_body)
     */
    size_t size;
    /**
     * Displacement (kg). 0, and all other masses too: a fixed body.
     */
    double mass_kg;
    /**
     * Moment of inertia about the vertical (kg m2).
     */
    double yaw_inertia_kgm2;
    /**
     * Added mass in surge (kg).
     */
    double added_surge_kg;
    /**
     * Added mass in sway (kg).
     */
    double added_sway_kg;
    /**
     * Added moment of inertia in yaw (kg m2).
     */
    double added_yaw_kgm2;
    /**
     * Where a fixed body stands, and a floating one begins (m).
     */
    double north_m;
    /**
     * Where a fixed body stands, and a floating one begins (m).
     */
    double east_m;
    /**
     * Its heading there (rad).
     */
    double heading_rad;
} fl_body;

/**
 * A fender: a face on a body with a reaction curve, which is given apart. It touches the outlines of the
 * bodies that its own body makes a pair with.
 */
typedef struct {
    /**
     * sizeof(fl_fender)
     */
    size_t size;
    /**
     * Middle of the line where it is mounted, in the body's frame (m).
     */
    double forward_m;
    /**
     * Middle of the line where it is mounted, in the body's frame (m).
     */
    double starboard_m;
    /**
     * Direction in which it faces, in the body's frame: 0 forward, positive to starboard (rad).
     */
    double facing_rad;
    /**
     * Width of the face (m).
     */
    double width_m;
    /**
     * From the mounting to the face, uncompressed (m).
     */
    double projection_m;
    /**
     * The deflection that it is made for (m); 0: its projection. 0 where it has no curve.
     */
    double rated_deflection_m;
    /**
     * Deflection at which it begins to stiffen to a stop (m).
     */
    double stop_from_m;
    /**
     * Stiffness of the stop (N/m); 0, and its beginning too: it has none.
     */
    double stop_stiffness_npm;
    /**
     * Index of the body that carries it.
     */
    uint32_t body;
    /**
     * Index of its material: friction, restitution, damping, and stiffness where it has no curve.
     */
    uint32_t material;
    /**
     * Share of the energy taken that its rubber gives back, 0.05 to 1: its reaction falls by that law when the
     * hull retreats. 0: by its material's restitution.
     */
    double returned_energy;
} fl_fender;

/**
 * How an engine is to work; all members but `size` may be 0.
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
     * FL_CORIOLIS_..., of a host of the present; 0 for a following one, whose loads hold the turning terms.
     */
    uint32_t coriolis;
    /**
     * FL_INTEGRATION_... of a following host; else 0.
     */
    uint32_t integration;
    /**
     * Age of the states that a following host shows, in its steps, at most 1000; else 0.
     */
    uint32_t delay_steps;
} fl_settings;

/**
 * State of a body, earth-fixed, of its centre of gravity.
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
     * Rate of turn, positive to starboard (rad/s).
     */
    double yaw_rate_radps;
} fl_state;

/**
 * A force at a body's centre of gravity and a moment about it, earth-fixed.
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
 * One patch of contact in the last step. The force on body 1 is -normal_force_n times the normal and
 * tangential_force_n times the normal turned by +90 degrees (north to east); on body 2 exactly the opposite.
 * Forces are means over the step by the coupled method; peaks are the true ones, sub-steps included.
 */
typedef struct {
    /**
     * sizeof(fl_contact), to be set by the caller.
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
     * The fender that is pressed; FL_NONE: outline on outline.
     */
    uint32_t fender;
    /**
     * Number of the patch within the pair.
     */
    uint32_t patch;
    /**
     * FL_CONTACT_..., added up.
     */
    uint32_t flags;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * Area of the overlap (m2).
     */
    double area_m2;
    /**
     * Extent of the overlap along the normal, or deflection of the fender (m).
     */
    double depth_m;
    /**
     * Where the force acts (m).
     */
    double north_m;
    /**
     * Where the force acts (m).
     */
    double east_m;
    /**
     * Body 1's outward normal.
     */
    double normal_north;
    /**
     * Body 1's outward normal.
     */
    double normal_east;
    /**
     * Speed of approach along the normal (m/s).
     */
    double v_normal_mps;
    /**
     * Speed of body 1 relative to body 2 along the tangent (m/s).
     */
    double v_tangential_mps;
    /**
     * Shear of the contact (m).
     */
    double shear_m;
    /**
     * Normal force, at least 0 (N).
     */
    double normal_force_n;
    /**
     * Tangential force on body 1 (N).
     */
    double tangential_force_n;
    /**
     * Largest normal force within the step (N).
     */
    double peak_normal_force_n;
    /**
     * Largest depth within the step (m).
     */
    double peak_depth_m;
    /**
     * Of the normal force: area spring or reaction curve (N).
     */
    double spring_n;
    /**
     * Of the normal force: the stop past a fender's travel (N).
     */
    double stop_n;
    /**
     * Of the normal force: the damper (N).
     */
    double damper_n;
    /**
     * What the limit from momentum took off the normal force (N).
     */
    double limiter_n;
    /**
     * Energy in a fender's spring and stop at the step's start that it can give back (J); 0 for outline on outline.
     */
    double stored_j;
    /**
     * The largest energy within the step that loads such a fender from nothing to where it is (J).
     */
    double peak_absorbed_j;
    /**
     * Angle between a fender's face and the hull (rad).
     */
    double tilt_rad;
    /**
     * Factor on a fender's reaction.
     */
    double factor;
    /**
     * Energy that the rubber of a fender with returned_energy has turned to heat within the step (J).
     */
    double hysteresis_j;
} fl_contact;

/**
 * Something that a user should know of, told in the step in which it begins.
 */
typedef struct {
    /**
     * sizeof(fl_event), to be set by the caller.
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
     * The other body; the same where it is about one alone.
     */
    uint32_t body_2;
    /**
     * The fender; FL_NONE where it is about none.
     */
    uint32_t fender;
} fl_event;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * The interface of the library that is linked, to be held against FL_ABI_VERSION of the header.
 */
uint32_t fl_abi_version(void);

/**
 * The library's version, as in "0.1.0". The text is the library's.
 */
const char *fl_version(void);

/**
 * What a status means, in a few words. The text is the library's; any number may be asked about.
 */
const char *fl_status_text(int32_t status);

/**
 * Copies the text of the last call of this thread that failed; empty where none did. It stays until another
 * call fails. `length` may be NULL. See "Texts" in the preamble; a buffer that is too small does not count
 * as a call that failed.
 */
fl_status fl_last_error(char *buffer,
                        size_t capacity,
                        size_t *length);

/**
 * Makes an empty builder at `*builder`, to be destroyed by fl_builder_destroy().
 */
fl_status fl_builder_new(fl_builder **builder);

/**
 * Destroys a builder. The engines that it made stay. NULL is nothing to destroy, and good.
 */
fl_status fl_builder_destroy(fl_builder *builder);

/**
 * Copies the text of the last call on this builder that failed: as fl_last_error().
 */
fl_status fl_builder_error(const fl_builder *builder,
                           char *buffer,
                           size_t capacity,
                           size_t *length);

/**
 * Adds a material under a unique name; its index, counted from 0, goes to `index` where that is not NULL. Its
 * numbers are checked by fl_builder_build().
 */
fl_status fl_builder_add_material(fl_builder *builder,
                                  const char *name,
                                  size_t name_length,
                                  const fl_material *material,
                                  uint32_t *index);

/**
 * Adds a body under a unique name, with its outline: `vertices` pairs of x (forward) and y (to starboard of
 * the centre of gravity) (m), in either direction, convex or not. Its index, counted from 0, goes to `index`
 * where that is not NULL. Its masses are checked by fl_builder_build().
 */
fl_status fl_builder_add_body(fl_builder *builder,
                              const char *name,
                              size_t name_length,
                              const fl_body *body,
                              const double *outline_m,
                              size_t vertices,
                              uint32_t *index);

/**
 * Adds a fender under a unique name, with its reaction curve: `points` pairs of deflection (m) and reaction
 * (N), from (0, 0) on, the deflection rising. Without points its force is the paper's, its material's
 * stiffness times the area of the overlap. Its index, counted from 0, goes to `index` where that is not
 * NULL. Its numbers are checked by fl_builder_build().
 */
fl_status fl_builder_add_fender(fl_builder *builder,
                                const char *name,
                                size_t name_length,
                                const fl_fender *fender,
                                const double *curve,
                                size_t points,
                                uint32_t *index);

/**
 * Lets two bodies touch, with a material.
 */
fl_status fl_builder_add_pair(fl_builder *builder,
                              uint32_t body_1,
                              uint32_t body_2,
                              uint32_t material);

/**
 * Lets all pairs of bodies touch that fl_builder_add_pair() does not name, with a material.
 */
fl_status fl_builder_add_all_other_pairs(fl_builder *builder, uint32_t material);

/**
 * Makes an engine of all that was added, at `*engine`, to be destroyed by fl_engine_destroy(); NULL where
 * that fails. `settings` may be NULL: all defaults. The builder stays as it is, and can go on.
 */
fl_status fl_builder_build(fl_builder *builder,
                           const fl_settings *settings,
                           fl_engine **engine);

/**
 * Makes an engine of a scenario file, at `*engine`, to be destroyed by fl_engine_destroy(); NULL where that
 * fails. Files that the scenario names lie beside it. `overrides` replaces keys of the scenario, one
 * KEY=VALUE a line, as in "contact.method=coupled"; none: NULL and 0. `settings` may be NULL: all defaults.
 *
 * The engine takes the scenario's bodies, fenders, materials and pairs. What else acts on the bodies there,
 * loads and wind and the like, is the host's: see fl_engine_notices().
 */
fl_status fl_engine_from_file(const char *path,
                              size_t path_length,
                              const char *overrides,
                              size_t overrides_length,
                              const fl_settings *settings,
                              fl_engine **engine);

/**
 * As fl_engine_from_file(), of the text of a scenario that names no other files.
 */
fl_status fl_engine_from_text(const char *scenario,
                              size_t scenario_length,
                              const char *overrides,
                              size_t overrides_length,
                              const fl_settings *settings,
                              fl_engine **engine);

/**
 * Destroys an engine. NULL is nothing to destroy, and good.
 */
fl_status fl_engine_destroy(fl_engine *engine);

/**
 * Copies the text of the last call on this engine that failed: as fl_last_error().
 */
fl_status fl_engine_error(const fl_engine *engine, char *buffer, size_t capacity, size_t *length);

/**
 * Forgets all that happened, was shown and was told: the next step is the first.
 */
fl_status fl_engine_reset(fl_engine *engine);

/**
 * Copies what a user should know of the scenario, and what of it is left to the host; one line each, maybe
 * none. `length` may be NULL. See "Texts" in the preamble.
 */
fl_status fl_engine_notices(const fl_engine *engine,
                            char *buffer,
                            size_t capacity,
                            size_t *length);

/**
 * Number of bodies. Indices count from 0, in the order of the scenario or of the builder's calls.
 */
fl_status fl_engine_body_count(const fl_engine *engine, size_t *count);

/**
 * Copies the name of a body. `length` may be NULL. See "Texts" in the preamble.
 */
fl_status fl_engine_body_name(const fl_engine *engine,
                              uint32_t body,
                              char *buffer,
                              size_t capacity,
                              size_t *length);

/**
 * Index of the body of a name.
 */
fl_status fl_engine_find_body(const fl_engine *engine,
                              const char *name,
                              size_t name_length,
                              uint32_t *body);

/**
 * Number of fenders. Indices count from 0, in the order of the scenario or of the builder's calls.
 */
fl_status fl_engine_fender_count(const fl_engine *engine, size_t *count);

/**
 * Copies the name of a fender. `length` may be NULL. See "Texts" in the preamble.
 */
fl_status fl_engine_fender_name(const fl_engine *engine,
                                uint32_t fender,
                                char *buffer,
                                size_t capacity,
                                size_t *length);

/**
 * Index of the fender of a name.
 */
fl_status fl_engine_find_fender(const fl_engine *engine,
                                const char *name,
                                size_t name_length,
                                uint32_t *fender);

/**
 * Copies a body's mass matrix over surge, sway and yaw about its centre of gravity, added mass included, row
 * by row: 9 numbers (kg, kg m, kg m2); zeros for a fixed body. A following host must move its bodies with it.
 */
fl_status fl_engine_mass_matrix(const fl_engine *engine,
                                uint32_t body,
                                double *matrix);

/**
 * Copies the states from which the scenario or the builder lets the bodies begin; `count` is the number of
 * bodies.
 */
fl_status fl_engine_initial_states(const fl_engine *engine,
                                   fl_state *states,
                                   size_t count);

/**
 * Shows the state of one body for the next step. A fixed body need not be shown.
 */
fl_status fl_engine_set_state(fl_engine *engine, uint32_t body, const fl_state *state);

/**
 * Shows the states of all bodies for the next step: all of them, or none where one is refused. `count` is
 * the number of bodies.
 */
fl_status fl_engine_set_states(fl_engine *engine,
                               const fl_state *states,
                               size_t count);

/**
 * Says that the host has put a body where it shows it in the next step, rather than moved it there: its contacts
 * start afresh (FL_EVENT_TELEPORTED), no load is read from it, and out of another body it is pressed slowly
 * (FL_EVENT_PLACED_IN_OVERLAP, where it lies so deep that it would be thrown out). Without it the engine finds that out where the body is a tenth of the
 * radius of its outline farther than its velocities lead it. A host that shows its states some steps late calls it
 * when it first shows the new place. To go back in time, restore a saved engine.
 */
fl_status fl_engine_mark_teleported(fl_engine *engine,
                                    uint32_t body);

/**
 * Tells all that acts on each body except contact, until it is told again; `count` is the number of bodies.
 * NULL and 0: not told, as at the start. Then a host of the present has no loads, and those of a following
 * host are found in its states. By the paper's method there are no loads.
 */
fl_status fl_engine_set_loads(fl_engine *engine,
                              const fl_wrench *loads,
                              size_t count);

/**
 * Takes a step of `step_s` seconds from the states that were shown last. All floating bodies must have been
 * shown. Steps may be of any lengths. In one of 0 s, of a host that is paused, nothing goes on, and results are
 * those of the last step without its events and the contacts' work.
 */
fl_status fl_engine_step(fl_engine *engine,
                         double step_s);

/**
 * In one call: fl_engine_set_states(), fl_engine_set_loads() where `loads` is not NULL, fl_engine_step() and
 * fl_engine_wrenches(). All arrays have `count` members, which is the number of bodies. Where any of it fails
 * nothing has changed.
 */
fl_status fl_engine_advance(fl_engine *engine,
                            const fl_state *states,
                            const fl_wrench *loads,
                            size_t count,
                            double step_s,
                            fl_wrench *wrenches);

/**
 * Copies the wrenches of the last step, which the host is to add to its forces for that step: means over it, so that
 * the impulse is right, as fl_engine_peak_wrenches() are not. `count` is the number of bodies.
 */
fl_status fl_engine_wrenches(const fl_engine *engine,
                             fl_wrench *wrenches,
                             size_t count);

/**
 * Copies the greatest contact wrench on each body within the last step; `count` is the number of bodies. The wrenches
 * that move the bodies are means over the step: of a force that falls off within a long one they are much less than
 * the force that was there. Size fenders and structures by the peaks, and move bodies by fl_engine_wrenches(). Of the
 * sub-steps in which the engine takes a step it is the wrench of that in which the force was greatest; by the paper's
 * method, which knows no sub-steps, the same as fl_engine_wrenches(). The peak of each contact is
 * fl_contact.peak_normal_force_n.
 */
fl_status fl_engine_peak_wrenches(const fl_engine *engine,
                                  fl_wrench *peaks,
                                  size_t count);

/**
 * Copies the states that the engine came to at the end of the last step, for hosts that let it move the
 * bodies: by the coupled method with a host of the present. `count` is the number of bodies. Positions are those of the
 * step's end. Velocities are those of half a step before it (of half of the last sub-step, where contacts needed
 * several), as a leapfrog has them: show them again as they are; where you compare them with others, or draw them over
 * time, draw them there.
 */
fl_status fl_engine_states_after(const fl_engine *engine,
                                 fl_state *states,
                                 size_t count);

/**
 * Copies what the last step took for a following host's present states, which it will show when they are old
 * enough, and its loads, told or observed. `count` is the number of bodies.
 */
fl_status fl_engine_host_estimate(const fl_engine *engine,
                                  fl_state *states,
                                  fl_wrench *loads,
                                  size_t count);

/**
 * Number of patches that touched in the last step.
 */
fl_status fl_engine_contact_count(const fl_engine *engine, size_t *count);

/**
 * Copies a contact of the last step, counted from 0 in a fixed order. The caller sets `contact->size`.
 */
fl_status fl_engine_contact(const fl_engine *engine,
                            uint32_t index,
                            fl_contact *contact);

/**
 * Number of events of the last step.
 */
fl_status fl_engine_event_count(const fl_engine *engine, size_t *count);

/**
 * Copies an event of the last step, counted from 0 in a fixed order. The caller sets `event->size`.
 */
fl_status fl_engine_event(const fl_engine *engine, uint32_t index, fl_event *event);

/**
 * Copies all of the engine that can change as bytes, results included: they are of one version of the
 * library, the same on every machine, and check-summed. NULL and a capacity of 0 ask for `*length` alone.
 */
fl_status fl_engine_save(const fl_engine *engine,
                         uint8_t *buffer,
                         size_t capacity,
                         size_t *length);

/**
 * Becomes what fl_engine_save() saved, of this engine or of another with the same model and settings, and
 * goes on with the same bits. Any bytes may be given: those that are no such save are refused.
 */
fl_status fl_engine_restore(fl_engine *engine,
                            const uint8_t *saved,
                            size_t length);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* FENDERLINE_H */
