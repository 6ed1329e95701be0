/*
 * A tug pushes against a fender on a quay for ten minutes; the engine is made by calls. The host is like a
 * co-simulation master: it passes her state one step late and never passes her thrust. She comes to rest at
 * the static deflection: 500 kN / 6.5 MN/m = 0.0769 m.
 */
#include <stdio.h>
#include <stdlib.h>

#include "fenderline.h"

#define STEP_S 0.1
#define MASS_KG 1e6
#define THRUST_N 500e3
#define STIFFNESS_NPM 6.5e6

static void must(fl_status status)
{
    char text[1000];
    if (status == FL_STATUS_OK)
        return;
    fl_last_error(text, sizeof text, NULL);
    fprintf(stderr, "%s\n", text);
    exit(1);
}

static fl_engine *tug_at_a_quay(uint32_t *tug)
{
    const double hull[] = {-16, -6.5, 16, -6.5, 16, 6.5, -16, 6.5};
    const double wall[] = {-5, -50, 5, -50, 5, 50, -5, 50};
    const double curve[] = {0, 0, 1, STIFFNESS_NPM};
    fl_material rubber = fl_material_init();
    fl_body floating = fl_body_init(), fixed = fl_body_init();
    fl_fender fender = fl_fender_init();
    fl_settings late = fl_settings_init();
    fl_builder *builder;
    fl_engine *engine;
    rubber.stiffness_npm2 = 50e6;
    rubber.shear_stiffness_npm = 3e6;
    rubber.friction_static = rubber.friction_dynamic = 0.5;
    rubber.restitution = 0.1;
    floating.mass_kg = MASS_KG;
    floating.yaw_inertia_kgm2 = 6.4e7;
    fixed.north_m = 22;
    fender.forward_m = -5;
    fender.facing_rad = 3.14159265358979;
    fender.width_m = 10;
    fender.projection_m = 1;
    late.host = FL_HOST_COSIMULATION;
    late.delay_steps = 1;
    must(fl_builder_new(&builder));
    must(fl_builder_add_material(builder, "rubber", FL_NUL, &rubber, &fender.material));
    must(fl_builder_add_body(builder, "tug", FL_NUL, &floating, hull, 4, tug));
    must(fl_builder_add_body(builder, "quay", FL_NUL, &fixed, wall, 4, &fender.body));
    must(fl_builder_add_fender(builder, "fender", FL_NUL, &fender, curve, 2, NULL));
    must(fl_builder_add_pair(builder, *tug, fender.body, fender.material));
    must(fl_builder_build(builder, &late, &engine));
    must(fl_builder_destroy(builder));
    return engine;
}

int main(void)
{
    uint32_t tug;
    fl_engine *engine = tug_at_a_quay(&tug);
    fl_state now = {0, 0, 0, 0, 0, 0}, previous = now;
    fl_contact contact = fl_contact_init();
    for (int step = 0; step < 6000; step++) {
        fl_wrench wrenches[2];
        must(fl_engine_set_state(engine, tug, &previous));
        must(fl_engine_step(engine, STEP_S));
        must(fl_engine_wrenches(engine, wrenches, 2));
        previous = now;
        now.north_m += now.north_mps * STEP_S;
        now.north_mps += (THRUST_N + wrenches[tug].north_n) / MASS_KG * STEP_S;
    }
    must(fl_engine_contact(engine, 0, &contact));
    printf("deflection_m,reaction_n\n%.17g,%.17g\n", contact.depth_m, contact.normal_force_n);
    must(fl_engine_destroy(engine));
    return 0;
}
