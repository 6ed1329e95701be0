/*
 * Random sequences of calls: any order, any numbers, any bytes for a saved engine, invalid handles.
 *
 *     fuzz SEQUENCES [FIRST]
 *
 * Each sequence depends on its own number alone, so that one that fails can be run by itself. Buffers come
 * from malloc with exactly the size that is passed, so that a sanitizer or valgrind sees an access beyond it.
 * After each failed call: its status is in the header, there is an error message, and the engine is unchanged.
 * FL_STATUS_PANICKED, a non-finite result, or 20 seconds in one sequence ends the run. It prints digests of
 * all results; another build must print the same.
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fenderline.h"

#define HELD 4
#define SECONDS 20

static uint64_t seed, digest = 0xcbf29ce484222325u, calls, contacts, refused[16];
static unsigned long long sequence;
static fl_engine *engines[HELD];
static fl_builder *builders[HELD];
static uint8_t *saved[HELD];
static size_t saved_length[HELD];

static const char *const SCENARIO =
    "title = \"Tug at a quay\"\n[time]\nstep = 0.1\nduration = 20\n[material.rubber]\n"
    "stiffness = \"500 kN/m^2\"\nshear_stiffness = \"3 MN/m\"\nfriction_static = 0.5\n"
    "friction_dynamic = 0.5\nrestitution = 0.1\n[body.tug]\n"
    "outline = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]\nmass = \"930 t\"\n"
    "gyradius = \"8 m\"\nadded_mass = { surge = 0.1, sway = 0.8, yaw = 0.4 }\n[body.quay]\n"
    "fixed = true\noutline = [[0, -50], [5, -50], [5, 50], [0, 50]]\nposition = [15, 0]\n"
    "[[pair]]\nbodies = [\"tug\", \"quay\"]\nmaterial = \"rubber\"\n";

static void fail(const char *why)
{
    char text[500] = "";
    fl_last_error(text, sizeof text, NULL);
    printf("sequence %llu: %s: %s\n", sequence, why, text);
    fflush(stdout);
    abort();
}

/* splitmix64 */
static uint64_t draw(void)
{
    uint64_t z = seed += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static uint64_t below(uint64_t n) { return draw() % n; }

static double between(double low, double high)
{
    return low + (high - low) * (double)(draw() >> 11) / 9007199254740992.0;
}

static void note(const void *bytes, size_t length)
{
    const uint8_t *b = bytes;
    for (size_t i = 0; i < length; i++)
        digest = (digest ^ b[i]) * 0x100000001b3u;
}

/* Mostly in range; sometimes not finite, huge, tiny or random bits. */
static double number(double low, double high)
{
    uint64_t bits;
    double any;
    switch (below(300)) {
    case 0: return NAN;
    case 1: return below(2) ? INFINITY : -INFINITY;
    case 2: return below(2) ? 1e300 : -1e300;
    case 3: return 1e-310;
    case 4: return 0.0;
    case 5:
        bits = draw();
        memcpy(&any, &bits, sizeof any);
        return any;
    default: return between(low, high);
    }
}

/* Mostly a valid handle; sometimes NULL, destroyed, of the wrong kind or random bits. */
static void *handle(void *const *own, void *const *other)
{
    static double somewhere;
    switch (below(40)) {
    case 0: return NULL;
    case 1: return other[below(HELD)];
    case 2: return (void *)(uintptr_t)draw();
    case 3: return &somewhere;
    case 4: return (void *)((uintptr_t)own[below(HELD)] + below(64));
    /* The first two exist from the start. */
    default: return own[below(below(4) ? 2 : HELD)];
    }
}

static fl_engine *an_engine(void) { return handle((void *const *)engines, (void *const *)builders); }
static fl_builder *a_builder(void) { return handle((void *const *)builders, (void *const *)engines); }

/* A copy of exactly this size; sometimes NULL. */
static void *copy(const void *bytes, size_t length)
{
    void *own;
    if (below(80) == 0)
        return NULL;
    own = malloc(length ? length : 1);
    if (length)
        memcpy(own, bytes, length);
    return own;
}

/* Room for an array; sometimes NULL or misaligned. The block has one byte more. */
static void *room(size_t count, size_t size, uint8_t **block)
{
    *block = calloc(count * size + 1, 1);
    if (below(80) == 0)
        return NULL;
    return *block + (below(80) == 0);
}

static fl_status checked(fl_status status)
{
    char text[64];
    size_t length = 0;
    calls++;
    if ((unsigned)status > FL_STATUS_PANICKED)
        fail("an unknown status");
    if (status == FL_STATUS_PANICKED)
        fail("a panic in the library");
    refused[status]++;
    note(&status, sizeof status);
    if (status == FL_STATUS_OK)
        return status;
    fl_last_error(text, sizeof text, &length);
    if (length == 0)
        fail("no text");
    note(text, length < sizeof text ? length : sizeof text - 1);
    return status;
}

/* All that an engine is, for a comparison; NULL where it is none. */
static uint8_t *all_of(fl_engine *engine, size_t *length)
{
    uint8_t *bytes;
    *length = 0;
    if (fl_engine_save(engine, NULL, 0, length) != FL_STATUS_OK)
        return NULL;
    bytes = malloc(*length);
    if (fl_engine_save(engine, bytes, *length, length) != FL_STATUS_OK)
        fail("saved by halves");
    return bytes;
}

static void finite(const double *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(numbers[i]))
            fail("a result that is not finite");
    note(numbers, count * sizeof *numbers);
}

static size_t bodies_of(fl_engine *engine)
{
    size_t count = 0;
    fl_engine_body_count(engine, &count);
    /* Mostly correct. */
    return below(40) ? count : below(5);
}

static fl_state a_state(void)
{
    double wide = below(8) ? 12.0 : 1e4;
    return (fl_state){number(-wide, wide), number(-wide, wide), number(-4.0, 4.0),
                      number(-3.0, 3.0), number(-3.0, 3.0), number(-0.1, 0.1)};
}

static double a_step(void)
{
    return below(60) ? between(0.01, 0.5) : below(5) ? number(-1.0, 20.0) : 1e6;
}

static void a_name(char *name)
{
    static const char *const NAMES[] = {"tug", "quay", "rubber", "a", "b", "fender", "", "gr\xc3\xbcn", "\xff\xfe"};
    strcpy(name, NAMES[below(sizeof NAMES / sizeof *NAMES)]);
}

static fl_settings some_settings(void)
{
    fl_settings s = {.size = below(40) ? sizeof s : (size_t)below(100)};
    s.method = (uint32_t)(below(3) ? 0 : below(4));
    s.host = (uint32_t)(below(2) ? 0 : below(3));
    s.coriolis = (uint32_t)(below(3) ? 0 : below(4));
    if (s.host == FL_HOST_COSIMULATION) {
        s.integration = (uint32_t)below(3) / 2 + (uint32_t)below(2);
        s.delay_steps = (uint32_t)(below(20) ? below(4) : draw());
        s.coriolis = s.coriolis > 2 ? 1 : 0;
    }
    return s;
}

static void hold(fl_engine *made, size_t place)
{
    fl_engine_destroy(engines[place]);
    engines[place] = made;
}

static void create(void)
{
    fl_settings settings = some_settings();
    fl_settings *given = below(3) ? copy(&settings, sizeof settings) : NULL;
    fl_engine *made = NULL;
    size_t place = (size_t)below(HELD);
    size_t length = strlen(SCENARIO);
    char *text = malloc(length);
    memcpy(text, SCENARIO, length);
    if (below(3) == 0)
        text[below(length)] = (char)draw();
    if (below(6) == 0)
        length = (size_t)below(length);
    text = realloc(text, length ? length : 1);
    if (below(20) == 0)
        checked(fl_engine_from_file("no/such/file.toml", FL_NUL, NULL, 0, given, &made));
    else if (below(20) == 0)
        checked(fl_engine_from_text(text, length, "contact.method=paper", FL_NUL, given, &made));
    else
        checked(fl_engine_from_text(text, length, NULL, 0, given, below(40) ? &made : NULL));
    if (made)
        hold(made, place);
    free(text);
    free(given);
}

static void build(void)
{
    fl_builder *b = a_builder();
    char name[16];
    uint32_t index, *where = below(3) ? &index : NULL;
    double points[2 * 8];
    size_t count;
    void *given, *list;
    a_name(name);
    if (below(40) == 0) {
        /* A fender by keys, with a changed byte now and then. */
        char keys[] = "on=tug\nmaterial=rubber\ntype=cone\nsize=1050 F1.1\nposition=[10, 0]\nwidth=2 m";
        if (below(2))
            keys[below(sizeof keys - 1)] = (char)draw();
        checked(fl_builder_add_fender_by_keys(b, name, FL_NUL, keys, below(3) ? FL_NUL : (size_t)below(sizeof keys), where));
        return;
    }
    if (below(20) == 0) {
        checked((below(2) ? fl_builder_find_body : below(2) ? fl_builder_find_fender : fl_builder_find_material)(
            b, name, FL_NUL, where));
        return;
    }
    switch (below(9)) {
    case 0: {
        size_t place = (size_t)below(HELD);
        fl_builder_destroy(builders[place]);
        checked(fl_builder_new(&builders[place]));
        break;
    }
    case 1: {
        fl_material m = {below(60) ? sizeof m : (size_t)below(99), number(0, 1e6), number(0, 1e5),
                         number(0, 1e7), 0.5, number(0, 0.5), number(0, 1)};
        given = copy(&m, sizeof m);
        checked(fl_builder_add_material(b, name, FL_NUL, given, where));
        free(given);
        break;
    }
    case 2: case 3: {
        fl_body body = {.size = below(60) ? sizeof body : (size_t)below(99),
                        .north_m = number(-20, 20), .east_m = number(-20, 20), .heading_rad = number(-3, 3)};
        if (below(3)) {
            body.mass_kg = number(1e5, 1e8);
            body.yaw_inertia_kgm2 = number(1e7, 1e10);
            body.added_sway_kg = number(0, 1e8);
        }
        count = (size_t)below(9);
        for (size_t i = 0; i < count; i++) {
            double angle = 6.283185307179586 * (double)i / (double)count, radius = number(5, 15);
            points[2 * i] = radius * cos(angle);
            points[2 * i + 1] = radius * sin(angle);
        }
        given = copy(&body, sizeof body);
        list = copy(points, 2 * count * sizeof *points);
        checked(fl_builder_add_body(b, name, FL_NUL, given, list,
                                 below(90) ? count : (size_t)20000 + (size_t)draw() / 4, where));
        free(given);
        free(list);
        break;
    }
    case 4: {
        fl_fender f = {.size = below(60) ? sizeof f : (size_t)below(99), .forward_m = number(-10, 10),
                       .starboard_m = number(-10, 10), .facing_rad = number(-3, 3), .width_m = number(0.5, 5),
                       .projection_m = number(0.5, 2), .body = (uint32_t)below(3), .material = (uint32_t)below(2)};
        count = (size_t)below(4);
        for (size_t i = 0; i < count; i++) {
            points[2 * i] = i ? number((double)i, (double)i + 0.5) : 0.0;
            points[2 * i + 1] = i ? number(1e5, 1e6) : 0.0;
        }
        given = copy(&f, sizeof f);
        list = copy(points, 2 * count * sizeof *points);
        checked(fl_builder_add_fender(b, name, FL_NUL, given, list, count, where));
        free(given);
        free(list);
        break;
    }
    case 5: checked(fl_builder_add_pair(b, (uint32_t)below(3), (uint32_t)below(4), (uint32_t)below(2))); break;
    case 6: checked(fl_builder_add_all_other_pairs(b, (uint32_t)below(2))); break;
    case 7: {
        char text[40];
        checked(fl_builder_error(b, text, sizeof text, NULL));
        break;
    }
    default: {
        fl_settings settings = some_settings();
        fl_engine *made = NULL;
        given = below(2) ? copy(&settings, sizeof settings) : NULL;
        checked(fl_builder_build(b, given, below(60) ? &made : NULL));
        if (made)
            hold(made, (size_t)below(HELD));
        free(given);
    }
    }
}

static void ask(fl_engine *e)
{
    uint8_t *block = NULL, *block_2 = NULL;
    size_t count = bodies_of(e), length = 0, capacity = (size_t)below(40);
    char *text = malloc(capacity + 1);
    uint32_t index = (uint32_t)(below(20) ? below(4) : draw());
    void *into;
    switch (below(16)) {
    case 0: checked(fl_engine_notices(e, text, capacity, &length)); break;
    case 1: checked(fl_engine_body_name(e, index, text, capacity, NULL)); break;
    case 2: checked(fl_engine_fender_name(e, index, text, capacity, &length)); break;
    case 3: a_name(text = realloc(text, 16)); checked(fl_engine_find_body(e, text, FL_NUL, &index)); break;
    case 4: a_name(text = realloc(text, 16)); checked(fl_engine_find_fender(e, text, FL_NUL, &index)); break;
    case 5: checked(fl_engine_fender_count(e, below(50) ? &length : NULL)); break;
    case 6:
        into = room(9, sizeof(double), &block);
        if (checked(fl_engine_mass_matrix(e, index, into)) == FL_STATUS_OK)
            finite(into, 9);
        break;
    case 7:
        into = room(count, sizeof(fl_state), &block);
        if (checked(fl_engine_initial_states(e, into, count)) == FL_STATUS_OK)
            finite(into, 6 * count);
        break;
    case 8:
        into = room(count, sizeof(fl_wrench), &block);
        if (checked((below(2) ? fl_engine_wrenches : fl_engine_peak_wrenches)(e, into, count)) == FL_STATUS_OK)
            finite(into, 3 * count);
        break;
    case 9:
        into = room(count, sizeof(fl_state), &block);
        if (checked(fl_engine_states_after(e, into, count)) == FL_STATUS_OK)
            finite(into, 6 * count);
        break;
    case 10: {
        void *loads = room(count, sizeof(fl_wrench), &block_2);
        into = room(count, sizeof(fl_state), &block);
        if (checked(fl_engine_host_estimate(e, into, loads, count)) == FL_STATUS_OK) {
            finite(into, 6 * count);
            finite(loads, 3 * count);
        }
        break;
    }
    case 11: checked(fl_engine_contact_count(e, below(50) ? &length : NULL)); break;
    case 12: case 13: {
        fl_contact *c = room(1, sizeof *c, &block);
        if (c && (uintptr_t)c % 8 == 0)
            c->size = below(50) ? sizeof *c : (size_t)draw();
        if (checked(fl_engine_contact(e, (uint32_t)below(4) / 3, c)) == FL_STATUS_OK)
            finite(&c->area_m2, 21);
        break;
    }
    case 14: checked(fl_engine_event_count(e, &length)); break;
    default: {
        fl_event *event = room(1, sizeof *event, &block);
        if (event && (uintptr_t)event % 8 == 0)
            event->size = below(50) ? sizeof *event : (size_t)draw();
        if (checked(fl_engine_event(e, (uint32_t)below(3), event)) == FL_STATUS_OK)
            note(event, sizeof *event);
    }
    }
    note(&length, sizeof length);
    free(text);
    free(block);
    free(block_2);
}

/* Reads everything of a kind in one call each. */
static void ask_for_all(fl_engine *e)
{
    uint8_t *block = NULL;
    size_t count = 0, capacity = (size_t)below(12);
    void *into;
    switch (below(5)) {
    case 0:
        into = room(2 * capacity, sizeof(double), &block);
        if (checked(fl_engine_outline(e, (uint32_t)below(3), into, capacity, &count)) == FL_STATUS_OK)
            finite(into, into ? 2 * count : 0);
        break;
    case 1: {
        fl_engine_fender_count(e, &count);
        fl_fender_view *views = room(count, sizeof *views, &block);
        if (checked(fl_engine_fender_views(e, views, below(20) ? count : capacity)) == FL_STATUS_OK)
            for (size_t i = 0; i < count; i++)
                finite(&views[i].mount_1_forward_m, 14);
        break;
    }
    case 2: {
        fl_contact *all = room(capacity, sizeof *all, &block);
        size_t size = below(20) ? sizeof *all : (size_t)below(300);
        if (checked(fl_engine_contacts(e, all, size, capacity, &count)) == FL_STATUS_OK)
            for (size_t i = 0; i < count && all; i++)
                finite(&all[i].area_m2, 21);
        break;
    }
    case 3: {
        fl_event *all = room(capacity, sizeof *all, &block);
        if (checked(fl_engine_events(e, all, sizeof *all, capacity, &count)) == FL_STATUS_OK && all)
            note(all, count * sizeof *all);
        break;
    }
    default: {
        double *points = malloc(2 * capacity * sizeof *points + 1);
        for (size_t i = 0; i < 2 * capacity; i++)
            points[i] = number(-30, 30);
        into = room(4 * capacity, sizeof(double), &block);
        if (below(3) == 0)
            checked(fl_outline_hull(points, capacity, into, 2 * capacity, &count));
        else if (below(2))
            checked(fl_outline_mirror(points, capacity, number(0, 30), into, 2 * capacity, &count));
        else
            checked(fl_outline_simplify(points, capacity, number(0, 3), into, 2 * capacity, &count));
        free(points);
    }
    }
    note(&count, sizeof count);
    free(block);
}

/* Records, or replays what was recorded: whole, with the same bits; or cut or changed, which is refused. */
static void record_or_replay(fl_engine *e)
{
    size_t length = 0, steps = 0, different = 0;
    if (below(3) == 0) {
        checked(fl_engine_record(e, (size_t)below(5)));
        return;
    }
    if (checked(fl_engine_dump(e, NULL, 0, &length)) != FL_STATUS_OK)
        return;
    uint8_t *dump = malloc(length);
    checked(fl_engine_dump(e, dump, length, &length));
    if (below(3) == 0) {
        if (below(2))
            length = (size_t)below(length);
        else
            dump[below(length)] ^= (uint8_t)(1u << below(8));
        dump = realloc(dump, length ? length : 1);
        if (checked(fl_replay_dump(dump, length, &steps, &different, NULL)) == FL_STATUS_OK)
            fail("a changed dump was replayed");
    } else if (checked(fl_replay_dump(dump, length, &steps, &different, NULL)) != FL_STATUS_OK || different)
        fail("a dump does not replay to the same bits");
    note(&steps, sizeof steps);
    free(dump);
}

/* Saves, or restores the bytes of any engine: unchanged, truncated or changed. */
static void save_or_restore(fl_engine *e)
{
    size_t place = (size_t)below(HELD);
    if (below(2) || !saved[place]) {
        free(saved[place]);
        saved[place] = all_of(e, &saved_length[place]);
        note(saved[place], saved_length[place]);
        return;
    }
    size_t length = saved_length[place];
    uint8_t *bytes = malloc(length + 16);
    memcpy(bytes, saved[place], length);
    switch (below(6)) {
    case 0: bytes[below(length)] ^= (uint8_t)(1u << below(8)); break;
    case 1: length = (size_t)below(length); break;
    case 2: memset(bytes + length, 0, 16); length += (size_t)below(16); break;
    case 3: {
        /* Changed, with a valid check sum: the content is checked too. */
        uint64_t sum = 0xcbf29ce484222325u, bits = below(2) ? draw() : 0x7ff8000000000000u;
        size_t at = (size_t)below(length - 8);
        memcpy(bytes + at, &bits, length - 8 - at < 8 ? length - 8 - at : 8);
        for (size_t i = 0; i < length - 8; i++)
            sum = (sum ^ bytes[i]) * 0x100000001b3u;
        memcpy(bytes + length - 8, &sum, 8);
        break;
    }
    default: break;
    }
    bytes = realloc(bytes, length ? length : 1);
    checked(fl_engine_restore(e, below(80) ? bytes : NULL, length));
    free(bytes);
}

/* Reads all contacts of the last step. */
static void read_contacts(fl_engine *e)
{
    size_t count = 0;
    fl_engine_contact_count(e, &count);
    for (uint32_t i = 0; i < count; i++) {
        fl_contact c = {.size = sizeof c};
        if (fl_engine_contact(e, i, &c) != FL_STATUS_OK)
            fail("a counted contact cannot be read");
        finite(&c.area_m2, 21);
        contacts++;
    }
}

static void step(fl_engine *e)
{
    uint8_t *block_w = NULL;
    size_t count = bodies_of(e);
    fl_state states[8], *given;
    fl_wrench loads[8], *given_loads;
    for (size_t i = 0; i < 8; i++) {
        states[i] = a_state();
        loads[i] = (fl_wrench){number(-1e6, 1e6), number(-1e6, 1e6), number(-1e7, 1e7)};
    }
    if (count > 8)
        count = 8;
    given = copy(states, count * sizeof *states);
    given_loads = below(2) ? copy(loads, count * sizeof *loads) : NULL;
    switch (below(8)) {
    case 0: checked(fl_engine_set_state(e, (uint32_t)below(3), count ? given : NULL)); break;
    case 1: checked(fl_engine_set_states(e, given, count)); break;
    case 2: checked(fl_engine_set_loads(e, given_loads, below(3) || given_loads ? count : 0)); break;
    case 3: case 4:
        if (checked(fl_engine_step(e, a_step())) == FL_STATUS_OK)
            read_contacts(e);
        break;
    default: {
        void *into = room(count, sizeof(fl_wrench), &block_w);
        if (checked(fl_engine_advance(e, given, given_loads, count, a_step(), into)) == FL_STATUS_OK) {
            finite(into, 3 * count);
            read_contacts(e);
        }
    }
    }
    free(given);
    free(given_loads);
    free(block_w);
}

/* Makes engines with two bodies, so that most sequences have one that can step. */
static void begin(void)
{
    const double hull[] = {-10, -4, 10, -4, 10, 4, -10, 4};
    const fl_material m = {sizeof m, 5e5, 0, 3e6, 0.5, 0.5, 0.1};
    const fl_body body = {.size = sizeof body, .mass_kg = 1e6, .yaw_inertia_kgm2 = 5e7, .added_sway_kg = 5e5};
    const fl_body wall = {.size = sizeof wall, .north_m = 15};
    fl_settings settings = some_settings();
    settings.size = sizeof settings;
    checked(fl_builder_new(&builders[0]));
    checked(fl_builder_add_material(builders[0], "rubber", FL_NUL, &m, NULL));
    checked(fl_builder_add_body(builders[0], "tug", FL_NUL, &body, hull, 4, NULL));
    checked(fl_builder_add_body(builders[0], "quay", FL_NUL, below(4) ? &wall : &body, hull, 4, NULL));
    checked(fl_builder_add_all_other_pairs(builders[0], 0));
    builders[1] = builders[0];
    checked(fl_builder_build(builders[0], NULL, &engines[0]));
    if (checked(fl_builder_build(builders[0], &settings, &engines[1])) != FL_STATUS_OK)
        checked(fl_builder_build(builders[0], NULL, &engines[1]));
}

static void play(void)
{
    uint64_t many;
    seed = sequence;
    many = 1 + below(40);
    alarm(SECONDS);
    begin();
    for (uint64_t call = 0; call < many; call++) {
        fl_engine *e = an_engine();
        uint64_t before_length = refused[FL_STATUS_OK];
        size_t length, length_after;
        uint8_t *before = all_of(e, &length);
        uint64_t which = below(100);
        if (which < 2)
            create();
        else if (which < 20)
            build();
        else if (which < 50)
            step(e);
        else if (which < 72)
            ask(e);
        else if (which < 80)
            ask_for_all(e);
        else if (which < 84)
            record_or_replay(e);
        else if (which < 95)
            save_or_restore(e);
        else if (which < 97)
            checked(fl_engine_reset(e));
        else if (which < 98)
            checked(fl_engine_error(e, NULL, 0, NULL));
        else {
            size_t place = (size_t)below(HELD);
            /* The handle is kept, so that later calls use a destroyed one. */
            if (below(2))
                checked(fl_engine_destroy(engines[place]));
            else
                checked(fl_builder_destroy(builders[place]));
        }
        if (before && refused[FL_STATUS_OK] == before_length && which >= 20 && which < 98) {
            uint8_t *after = all_of(e, &length_after);
            if (!after || length != length_after || memcmp(before, after, length))
                fail("a call that failed changed the engine");
            free(after);
        }
        free(before);
    }
    for (size_t i = 0; i < HELD; i++) {
        fl_engine_destroy(engines[i]);
        fl_builder_destroy(builders[i]);
        free(saved[i]);
        engines[i] = NULL;
        builders[i] = NULL;
        saved[i] = NULL;
    }
}

int main(int argc, char **argv)
{
    unsigned long long count = argc > 1 ? strtoull(argv[1], NULL, 10) : 1000;
    unsigned long long first = argc > 2 ? strtoull(argv[2], NULL, 10) : 0;
    for (sequence = first; sequence < first + count; sequence++) {
        play();
        if ((sequence + 1) % 5000 == 0)
            printf("digest after %llu: %016llx\n", sequence + 1, (unsigned long long)digest);
    }
    printf("%llu sequences, %llu calls, %llu contacts read; by status:", count,
           (unsigned long long)calls, (unsigned long long)contacts);
    for (size_t status = 0; status < 16; status++)
        printf(" %llu", (unsigned long long)refused[status]);
    putchar('\n');
    return 0;
}
