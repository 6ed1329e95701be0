/*
 * A ship comes alongside two fenders of the catalogue, in a loop as a game has it: frames of varying length, pauses, a saved
 * game, fenders that are drawn, and a dump of the last steps. The game moves the ship; the engine gives the contact.
 *
 *     game_loop [DUMP]
 *
 * writes the last steps to DUMP, for `fenderline replay DUMP`. examples/cpp/README.md says how to compile it.
 */
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <vector>

#include "fenderline.hpp"

namespace fl = fenderline;

namespace {

/** The starboard side of a ship of 120 m from her mesh, from bow to stern. */
std::vector<fl::point> starboard_side()
{
    std::vector<fl::point> side;
    for (int i = 0; i <= 60; i++) {
        const double share = i / 60.0;
        side.push_back({60.0 - 30.0 * share, 10.0 * std::sin(1.5707963267948966 * share)});
    }
    side.push_back({-60.0, 10.0});
    return side;
}

struct berth {
    fl::body quay, ship;
    fl::engine engine;
};

berth make_berth()
{
    const fl::point wall[] = {{-60, -5}, {60, -5}, {60, 0}, {-60, 0}};
    const std::vector<fl::point> hull = fl::simplified(fl::mirrored(starboard_side()), 0.05);
    fl_material rubber = fl_material_init();
    rubber.stiffness_npm2 = 5e6;
    rubber.shear_stiffness_npm = 3e6;
    rubber.friction_static = rubber.friction_dynamic = 0.2;
    const fl_body fixed = fl_body_init();
    fl_body floating = fl_body_init();
    floating.mass_kg = 12e6;
    floating.yaw_inertia_kgm2 = 1.1e10;
    floating.added_surge_kg = 0.6e6;
    floating.added_sway_kg = 6e6;
    floating.added_yaw_kgm2 = 5e9;
    floating.east_m = 10.0 + 1.05 + 0.2; /* half her beam, the fender, a gap */

    fl::builder builder;
    const fl::material facing = builder.add_material("facing", rubber);
    const fl::body quay = builder.add_body("quay", fixed, wall);
    const fl::body ship = builder.add_body("ship", floating, hull);
    builder.add_pair(quay, ship, facing);
    fl::catalogue_fender cone{quay, facing, "cone", "1050 F1.1"};
    cone.width_m = 2.0;
    cone.temperature_c = 30.0;
    for (const double forward_m : {-20.0, 20.0}) {
        cone.position_m = {forward_m, 0.0};
        builder.add_fender(forward_m < 0 ? "aft" : "fore", cone);
    }
    fl_settings game = fl_settings_init();
    game.host = FL_HOST_COSIMULATION; /* the game moves the ship, and its frames vary */
    game.integration = FL_INTEGRATION_SEMI_IMPLICIT;
    return {quay, ship, builder.build(game)};
}

/** What a saved game holds. */
struct saved_game {
    std::vector<std::uint8_t> engine;
    fl_state ship;
    std::uint32_t random;
};

class game {
public:
    game() : berth_(make_berth()), mass_(berth_.engine.mass_matrix(berth_.ship))
    {
        states_ = berth_.engine.initial_states();
        wrenches_.resize(states_.size());
        ship().east_mps = -0.12;
        berth_.engine.record(200);
    }

    fl::engine& engine() { return berth_.engine; }
    fl_state& ship() { return states_[berth_.ship.number()]; }
    double energy_j() { return 0.5 * mass_[4] * ship().east_mps * ship().east_mps; }

    /** One frame. A paused game passes 0 s. */
    void frame(double frame_s)
    {
        berth_.engine.advance(states_, {}, frame_s, wrenches_);
        const fl_wrench& contact = wrenches_[berth_.ship.number()];
        /* Her own forces would be added here. She keeps her heading, so that surge is north and sway is east. */
        ship().north_mps += contact.north_n / mass_[0] * frame_s;
        ship().east_mps += contact.east_n / mass_[4] * frame_s;
        ship().yaw_rate_radps += contact.moment_nm / mass_[8] * frame_s;
        ship().north_m += ship().north_mps * frame_s;
        ship().east_m += ship().east_mps * frame_s;
        ship().heading_rad += ship().yaw_rate_radps * frame_s;
    }

    /** Between 8 and 40 ms. */
    double next_frame_s()
    {
        random_ = 1664525u * random_ + 1013904223u;
        return 0.008 + 0.032 * (random_ / 4294967296.0);
    }

    saved_game save() { return {berth_.engine.save(), ship(), random_}; }
    void load(const saved_game& from)
    {
        berth_.engine.restore(from.engine);
        ship() = from.ship;
        random_ = from.random;
    }

private:
    berth berth_;
    std::array<double, 9> mass_;
    std::vector<fl_state> states_;
    std::vector<fl_wrench> wrenches_;
    std::uint32_t random_ = 1;
};

int run(const char* dump_file)
{
    game own;
    const double energy_j = own.energy_j();
    double absorbed_j = 0.0, deflection_m = 0.0, gauge_n = 0.0;
    saved_game saved{};
    double t_s = 0.0;
    for (int frame = 0; t_s < 20.0; frame++) {
        const double frame_s = frame % 100 == 50 ? 0.0 : own.next_frame_s();
        own.frame(frame_s);
        t_s += frame_s;
        double now_j = 0.0;
        for (const fl_contact& contact : own.engine().contacts())
            now_j += contact.peak_absorbed_j;
        absorbed_j = std::max(absorbed_j, now_j);
        for (const fl_fender_view& fender : own.engine().fender_views()) {
            /* Draw the face from (face_1_forward_m, face_1_starboard_m) to face_2, as a child of the quay. */
            deflection_m = std::max(deflection_m, fender.deflection_m);
            gauge_n = std::max(gauge_n, fender.normal_force_n);
        }
        for (const fl_event& event : own.engine().events())
            if (event.kind == FL_EVENT_CONTACT_BEGAN)
                std::printf("%.1f s: contact\n", t_s);
        if (frame == 150)
            saved = own.save();
    }
    const fl_state end = own.ship();
    std::printf("largest deflection %.3f m, %.0f kN on the gauge\n", deflection_m, gauge_n / 1e3);
    std::printf("the fenders took %.1f %% of her energy, she leaves at %.3f m/s\n", 100.0 * absorbed_j / energy_j,
                end.east_mps);

    own.load(saved);
    game other;
    other.load(saved);
    for (int frame = 0; frame < 100; frame++) {
        own.frame(own.next_frame_s());
        other.frame(other.next_frame_s());
    }
    const bool same = own.ship().east_m == other.ship().east_m && own.engine().save() == other.engine().save();
    const std::vector<std::uint8_t> dump = own.engine().dump();
    const fl::replayed again = fl::replay(dump);
    std::printf("saved game: %s; dump: %zu steps, %zu different\n", same ? "the same bits" : "OTHER BITS", again.steps,
                again.different);
    if (dump_file != nullptr)
        std::ofstream(dump_file, std::ios::binary).write(reinterpret_cast<const char*>(dump.data()),
                                                          static_cast<std::streamsize>(dump.size()));
    /* No force but contact acted: the fenders took what she had. */
    const bool right = std::fabs(absorbed_j / energy_j - 1.0) < 0.01 && same && again.different == 0;
    return right ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc > 1 ? argv[1] : nullptr);
    } catch (const fl::error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
