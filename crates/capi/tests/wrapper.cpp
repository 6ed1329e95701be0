// Checks of include/fenderline.hpp that the example does not make: `cargo xtask c` compiles and runs them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <type_traits>

#include "fenderline.hpp"

namespace fl = fenderline;

#define CHECK(condition)                                                                                               \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                                       \
            std::exit(1);                                                                                              \
        }                                                                                                              \
    } while (false)

// An index of one kind is not taken for another's, nor a bare number.
static_assert(!std::is_convertible_v<fl::body, fl::fender>);
static_assert(!std::is_convertible_v<std::uint32_t, fl::body>);
static_assert(!std::is_invocable_v<decltype(&fl::engine::mass_matrix), fl::engine&, fl::fender>);
static_assert(!std::is_copy_constructible_v<fl::engine> && std::is_nothrow_move_constructible_v<fl::engine>);

static const fl::point square[] = {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}};

static void errors_are_thrown_and_change_nothing()
{
    fl::builder builder;
    bool thrown = false;
    try {
        builder.add_fender("f", "on=quay\nmaterial=rubber");
    } catch (const fl::error& error) {
        thrown = error.status() == FL_STATUS_NO_SUCH;
        CHECK(std::string(error.what()).find("`quay`") != std::string::npos);
    }
    CHECK(thrown);
    const fl::material rubber = builder.add_material("rubber", fl_material_init());
    const fl::body quay = builder.add_body("quay", fl_body_init(), square);
    CHECK(builder.find_body("quay") == quay && builder.find_material("rubber") == rubber);
    fl::catalogue_fender wrong{quay, rubber, "conne", "1050 F1.1"};
    wrong.width_m = 2.0;
    wrong.position_m = {0, 5};
    thrown = false;
    try {
        builder.add_fender("f", wrong);
    } catch (const fl::error& error) {
        thrown = std::string(error.what()).find("type=conne") != std::string::npos;
    }
    CHECK(thrown);
    wrong.type = "cone";
    wrong.facing_rad = std::acos(-1.0) / 2;
    CHECK(builder.add_fender("f", wrong).number() == 0);
    fl::builder moved = std::move(builder);
    CHECK(moved.find_fender("f").number() == 0);
    fl::engine engine = moved.build();
    fl::engine other = std::move(engine);
    CHECK(other.name(quay) == "quay" && other.outline(quay).size() == 4 && other.fender_views().size() == 1);
    CHECK(engine.handle() == nullptr);
}

static bool near(double a, double b)
{
    return std::fabs(a - b) < 1e-9 * (1.0 + std::fabs(a));
}

// A point of a turned ship, converted, is where the game engine's own rotation puts it.
static void frames_agree_with_the_rotations_of_game_engines()
{
    fl_state ship{};
    ship.north_m = 5e6;
    ship.east_m = 7e5;
    const fl::point origin{5e6 - 300.0, 7e5 + 40.0};
    const double f = 60.0, s = 11.0, up = 4.0;
    for (const double heading_rad : {0.0, 0.4, 2.0, -2.9}) {
        ship.heading_rad = heading_rad;
        const fl::point bow = fl::to_earth(ship, {f, s});
        const fl::point middle{ship.north_m, ship.east_m};
        const double c = std::cos(heading_rad), d = std::sin(heading_rad);
        // Unity turns (x, z) to (x cos + z sin, z cos - x sin); her local axes are x starboard, z forward.
        const fl::vector3 u = fl::frames::to_unity(bow, up, origin), um = fl::frames::to_unity(middle, 0, origin);
        CHECK(near(u.x, um.x + s * c + f * d) && near(u.z, um.z + f * c - s * d) && u.y == up);
        // Godot turns likewise by minus the heading; her local axes are x starboard, z aft.
        const fl::vector3 g = fl::frames::to_godot(bow, up, origin), gm = fl::frames::to_godot(middle, 0, origin);
        CHECK(near(g.x, gm.x + s * c - (-f) * d) && near(g.z, gm.z + (-f) * c + s * d) && g.y == up);
        // Unreal turns (x, y) to (x cos - y sin, x sin + y cos), in centimetres.
        const fl::vector3 r = fl::frames::to_unreal(bow, up, origin), rm = fl::frames::to_unreal(middle, 0, origin);
        CHECK(near(r.x, rm.x + 100 * (f * c - s * d)) && near(r.y, rm.y + 100 * (f * d + s * c)) && r.z == 100 * up);
        for (const fl::point back : {fl::frames::from_unity(u, origin), fl::frames::from_godot(g, origin),
                                     fl::frames::from_unreal(r, origin)})
            CHECK(near(back.x, bow.x) && near(back.y, bow.y));
        // What is left of a coordinate of 5000 km after the origin fits into float to a tenth of a millimetre.
        CHECK(std::fabs(static_cast<double>(static_cast<float>(u.z)) - u.z) < 1e-4);
    }
}

// What the guide of game loops says of piers: one that is brought later, one that moves.
static void piers_come_later_and_move()
{
    fl::builder builder;
    fl_material rubber = fl_material_init();
    rubber.stiffness_npm2 = 5e6;
    fl_body floating = fl_body_init(), away = fl_body_init();
    floating.mass_kg = 1e6;
    floating.yaw_inertia_kgm2 = 2e7;
    away.north_m = 10e3;
    const fl::material facing = builder.add_material("facing", rubber);
    const fl::body ship = builder.add_body("ship", floating, square);
    const fl::body pier = builder.add_body("pier", away, square);
    builder.add_pair(ship, pier, facing);
    fl::engine engine = builder.build();
    std::vector<fl_state> states = engine.initial_states();
    std::vector<fl_wrench> wrenches(2);
    engine.advance(states, {}, 0.1, wrenches);
    CHECK(engine.contacts().empty());
    engine.mark_teleported(pier);
    states[pier.number()].north_m = 10.3; // 0.3 m off the ship's side
    engine.advance(states, {}, 0.1, wrenches);
    CHECK(engine.contacts().empty());
    double pushed_n = 0.0;
    for (int step = 0; step < 60; step++) { // it moves towards her at 0.1 m/s and pushes her away
        states[pier.number()].north_mps = -0.1;
        states[pier.number()].north_m -= 0.01;
        engine.advance(states, {}, 0.1, wrenches);
        pushed_n = std::min(pushed_n, wrenches[ship.number()].north_n);
        std::vector<fl_state> after(2);
        engine.states_after(after);
        states[ship.number()] = after[ship.number()];
    }
    CHECK(pushed_n < -1e3 && states[ship.number()].north_mps <= -0.1);
    CHECK(states[ship.number()].north_mps > -0.21); // an elastic blow of a moving wall gives twice its speed at most
}

int main()
{
    piers_come_later_and_move();
    errors_are_thrown_and_change_nothing();
    frames_agree_with_the_rotations_of_game_engines();
    std::puts("wrapper: good");
    return 0;
}
