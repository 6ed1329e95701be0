/*
 * A ship simulator of fifty lines with contact forces: forward Euler at 0.1 s, no other forces.
 *
 *     ship SCENARIO.toml STEPS
 *
 * prints the contact force on each body at each step. With the paper's method the bits are those of
 * `fenderline run` with the integrator "euler". examples/c/README.md says how to compile it.
 */
#include <stdio.h>
#include <stdlib.h>

#include "fenderline.h"

#define MOST 16
#define STEP_S 0.1

static void must(fl_status status)
{
    char text[1000];
    if (status == FL_STATUS_OK)
        return;
    fl_last_error(text, sizeof text, NULL);
    fprintf(stderr, "%s\n", text);
    exit(1);
}

int main(int argc, char **argv)
{
    fl_engine *engine;
    fl_state ship[MOST];
    fl_wrench contact[MOST];
    double mass[MOST][9];
    char name[MOST][80];
    size_t count;
    if (argc != 3)
        return fprintf(stderr, "usage: ship SCENARIO.toml STEPS\n"), 2;
    must(fl_engine_from_file(argv[1], FL_NUL, NULL, 0, NULL, &engine));
    must(fl_engine_body_count(engine, &count));
    if (count > MOST)
        return fprintf(stderr, "at most %d bodies\n", MOST), 2;
    must(fl_engine_initial_states(engine, ship, count));
    for (uint32_t i = 0; i < count; i++) {
        must(fl_engine_mass_matrix(engine, i, mass[i]));
        must(fl_engine_body_name(engine, i, name[i], sizeof name[i], NULL));
    }
    puts("t_s,body,force_x_n,force_y_n,moment_z_nm");
    for (int step = 0; step < atoi(argv[2]); step++) {
        must(fl_engine_advance(engine, ship, NULL, count, STEP_S, contact));
        for (size_t i = 0; i < count; i++) {
            const fl_wrench *w = &contact[i];
            printf("%.17g,%s,%.17g,%.17g,%.17g\n", step * STEP_S, name[i], w->north_n, w->east_n,
                   w->moment_nm);
            if (mass[i][0] == 0.0)
                continue; /* a quay */
            /* The ship's own forces would be added here. */
            ship[i].north_m += ship[i].north_mps * STEP_S;
            ship[i].east_m += ship[i].east_mps * STEP_S;
            ship[i].heading_rad += ship[i].yaw_rate_radps * STEP_S;
            ship[i].north_mps += w->north_n * (1.0 / mass[i][0]) * STEP_S;
            ship[i].east_mps += w->east_n * (1.0 / mass[i][0]) * STEP_S;
            ship[i].yaw_rate_radps += w->moment_nm / mass[i][8] * STEP_S;
        }
    }
    must(fl_engine_destroy(engine));
    return 0;
}
