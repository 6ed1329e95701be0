/*
 * fenderline for C++17 and later: the C interface of fenderline.h with destructors, exceptions, containers and indices that
 * cannot be mixed up. Header only; link the same library. docs/guides/game_loop.md shows how to use it.
 *
 * - A call that fails throws fenderline::error and changes nothing.
 * - body, fender and material are types of their own: a body's index does not pass for a fender's.
 * - Arrays are fenderline::span: std::span in C++20, a small equivalent in C++17.
 * - Results come in the structures of fenderline.h, with its units and its frame.
 *
 * An engine may be moved, not copied. Its calls may come from any thread; the references that contacts(), events() and
 * fender_views() return hold until the next call of the same function.
 */

#ifndef FENDERLINE_HPP
#define FENDERLINE_HPP

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "fenderline.h"

#if defined(__has_include)
#if __has_include(<version>)
#include <version>
#endif
#endif
#ifdef __cpp_lib_span
#include <span>
#endif

namespace fenderline {

#ifdef __cpp_lib_span
using std::span;
#else
/** A view of an array, as std::span of C++20. */
template <class T>
class span {
public:
    constexpr span() noexcept = default;
    constexpr span(T* data, std::size_t size) noexcept : data_(data), size_(size) {}
    template <std::size_t N>
    constexpr span(T (&array)[N]) noexcept : data_(array), size_(N) {}
    template <class Container, class = decltype(std::declval<Container&>().data())>
    constexpr span(Container& of) noexcept : data_(of.data()), size_(of.size()) {}
    template <class Container, class Element = T, class = decltype(std::declval<const Container&>().data()),
              class = std::enable_if_t<std::is_const_v<Element>>>
    constexpr span(const Container& of) noexcept : data_(of.data()), size_(of.size()) {}

    constexpr T* data() const noexcept { return data_; }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0; }
    constexpr T& operator[](std::size_t index) const { return data_[index]; }
    constexpr T* begin() const noexcept { return data_; }
    constexpr T* end() const noexcept { return data_ + size_; }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};
#endif

/** A call that the library refused. */
class error : public std::runtime_error {
public:
    explicit error(fl_status status) : std::runtime_error(text_of(status)), status_(status) {}
    /** Why. */
    fl_status status() const noexcept { return status_; }

private:
    static std::string text_of(fl_status status)
    {
        char text[2000] = "";
        fl_last_error(text, sizeof text, nullptr);
        return std::string(fl_status_text(status)) + ": " + text;
    }
    fl_status status_;
};

/** Throws unless the status is FL_STATUS_OK. */
inline void must(fl_status status)
{
    if (status != FL_STATUS_OK)
        throw error(status);
}

/** Throws if the linked library is not that of this header. */
inline void check_version()
{
    if (fl_abi_version() != FL_ABI_VERSION)
        throw std::runtime_error("fenderline: the library is not that of the header");
}

/** The position of a body, a fender or a material in its list. Each kind is a type of its own. */
template <class Kind>
class index {
public:
    constexpr explicit index(std::uint32_t number) noexcept : number_(number) {}
    /** As the C interface and arrays take it. */
    constexpr std::uint32_t number() const noexcept { return number_; }
    friend constexpr bool operator==(index a, index b) noexcept { return a.number_ == b.number_; }
    friend constexpr bool operator!=(index a, index b) noexcept { return a.number_ != b.number_; }

private:
    std::uint32_t number_;
};
using body = index<struct body_kind>;
using fender = index<struct fender_kind>;
using material = index<struct material_kind>;

/** A pair of numbers (m): x forward and y to starboard of a body's centre of gravity, or north and east. */
struct point {
    double x;
    double y;
};
static_assert(sizeof(point) == 2 * sizeof(double), "outlines are passed as pairs of numbers");

/** A fender of the catalogue, or of any kind that a scenario file can describe. */
struct catalogue_fender {
    /** The body that carries it. */
    fenderline::body on;
    /** Its material: friction and damping. */
    fenderline::material facing_material;
    /** Family, such as "cone". */
    std::string type;
    /** Designation in the family, such as "1050 F1.1". Empty: give height and, where wanted, rated_reaction in `more`. */
    std::string size;
    /** Middle of its mounting line, in the frame of its body (m). */
    point position_m{0.0, 0.0};
    /** Width of its face (m). */
    double width_m = 0.0;
    /** Direction of its outward normal, 0 forward and positive to starboard (rad). NaN: out of the edge on which it stands. */
    double facing_rad = std::nan("");
    /** Temperature of the rubber (degrees Celsius). NaN: no factor. */
    double temperature_c = std::nan("");
    /** Further keys of a scenario's [fender.NAME], one KEY=VALUE per line, such as "cones=[{ at = -1 }, { at = 1 }]". */
    std::string more = {};
};

class engine;

/** Parts from which engines are made. */
class builder {
public:
    builder()
    {
        check_version();
        must(fl_builder_new(&handle_));
    }
    builder(builder&& other) noexcept
        : handle_(std::exchange(other.handle_, nullptr)), bodies_(std::move(other.bodies_)),
          materials_(std::move(other.materials_))
    {
    }
    builder& operator=(builder&& other) noexcept
    {
        std::swap(handle_, other.handle_);
        std::swap(bodies_, other.bodies_);
        std::swap(materials_, other.materials_);
        return *this;
    }
    builder(const builder&) = delete;
    builder& operator=(const builder&) = delete;
    ~builder() { fl_builder_destroy(handle_); }

    /** Adds a material. `parts` is from fl_material_init(). */
    material add_material(std::string_view name, const fl_material& parts)
    {
        std::uint32_t number = 0;
        must(fl_builder_add_material(handle_, name.data(), name.size(), &parts, &number));
        remember(materials_, number, name);
        return material(number);
    }

    /** Adds a body. `parts` is from fl_body_init(); all masses 0: a fixed one. */
    body add_body(std::string_view name, const fl_body& parts, span<const point> outline_m)
    {
        std::uint32_t number = 0;
        const double* numbers = outline_m.empty() ? nullptr : &outline_m.data()->x;
        must(fl_builder_add_body(handle_, name.data(), name.size(), &parts, numbers, outline_m.size(), &number));
        remember(bodies_, number, name);
        return body(number);
    }

    /** Adds a fender with a reaction curve of its own: x deflection (m), y reaction (N). `parts` is from fl_fender_init();
     *  its body and material are the arguments. */
    fender add_fender(std::string_view name, body on, material of, fl_fender parts, span<const point> curve)
    {
        std::uint32_t number = 0;
        const double* numbers = curve.empty() ? nullptr : &curve.data()->x;
        parts.body = on.number();
        parts.material = of.number();
        must(fl_builder_add_fender(handle_, name.data(), name.size(), &parts, numbers, curve.size(), &number));
        return fender(number);
    }

    /** Adds a fender by the keys of a scenario's [fender.NAME]: see fl_builder_add_fender_by_keys(). */
    fender add_fender(std::string_view name, std::string_view keys)
    {
        std::uint32_t number = 0;
        must(fl_builder_add_fender_by_keys(handle_, name.data(), name.size(), keys.data(), keys.size(), &number));
        return fender(number);
    }

    /** Adds a fender of the catalogue. */
    fender add_fender(std::string_view name, const catalogue_fender& parts)
    {
        std::string keys = "on=" + bodies_.at(parts.on.number());
        keys += "\nmaterial=" + materials_.at(parts.facing_material.number());
        keys += "\ntype=" + parts.type;
        if (!parts.size.empty())
            keys += "\nsize=" + parts.size;
        keys += "\nposition=[" + text(parts.position_m.x) + ", " + text(parts.position_m.y) + "]";
        keys += "\nwidth=" + text(parts.width_m);
        if (!std::isnan(parts.facing_rad))
            keys += "\nfacing=" + text(parts.facing_rad);
        if (!std::isnan(parts.temperature_c))
            keys += "\ntemperature=" + text(parts.temperature_c) + " degC";
        return add_fender(name, std::string_view(keys + "\n" + parts.more));
    }

    /** Lets two bodies touch. */
    void add_pair(body one, body other, material of)
    {
        must(fl_builder_add_pair(handle_, one.number(), other.number(), of.number()));
    }

    /** Lets all pairs touch that add_pair() does not name. */
    void add_all_other_pairs(material of) { must(fl_builder_add_all_other_pairs(handle_, of.number())); }

    body find_body(std::string_view name) const { return body(found(fl_builder_find_body, name)); }
    fender find_fender(std::string_view name) const { return fender(found(fl_builder_find_fender, name)); }
    material find_material(std::string_view name) const { return material(found(fl_builder_find_material, name)); }

    /** Makes an engine. The builder can be used further. `settings` is from fl_settings_init(). */
    inline engine build(const fl_settings& settings = fl_settings_init()) const;

private:
    template <class Find>
    std::uint32_t found(Find find, std::string_view name) const
    {
        std::uint32_t number = 0;
        must(find(handle_, name.data(), name.size(), &number));
        return number;
    }
    static void remember(std::vector<std::string>& names, std::uint32_t number, std::string_view name)
    {
        if (names.size() <= number)
            names.resize(number + std::size_t{1});
        names[number] = std::string(name);
    }
    static std::string text(double number)
    {
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", number);
        return text;
    }

    fl_builder* handle_ = nullptr;
    /* Names by index: the keys of a fender name its body and material. */
    std::vector<std::string> bodies_;
    std::vector<std::string> materials_;
};

/** A contact engine. */
class engine {
public:
    /** Takes a handle over. */
    explicit engine(fl_engine* handle) noexcept : handle_(handle) {}
    engine(engine&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    engine& operator=(engine&& other) noexcept
    {
        std::swap(handle_, other.handle_);
        return *this;
    }
    engine(const engine&) = delete;
    engine& operator=(const engine&) = delete;
    ~engine() { fl_engine_destroy(handle_); }

    /** From a scenario file. `overrides` replaces keys, one KEY=VALUE per line. */
    static engine from_file(std::string_view path, std::string_view overrides = {},
                            const fl_settings& settings = fl_settings_init())
    {
        check_version();
        fl_engine* made = nullptr;
        must(fl_engine_from_file(path.data(), path.size(), overrides.data(), overrides.size(), &settings, &made));
        return engine(made);
    }

    /** From the text of a scenario. */
    static engine from_text(std::string_view scenario, std::string_view overrides = {},
                            const fl_settings& settings = fl_settings_init())
    {
        check_version();
        fl_engine* made = nullptr;
        must(fl_engine_from_text(scenario.data(), scenario.size(), overrides.data(), overrides.size(), &settings,
                                 &made));
        return engine(made);
    }

    /** For calls of fenderline.h. */
    fl_engine* handle() const noexcept { return handle_; }

    std::size_t body_count() const { return counted(fl_engine_body_count); }
    std::size_t fender_count() const { return counted(fl_engine_fender_count); }
    std::string name(body of) const { return named(fl_engine_body_name, of.number()); }
    std::string name(fender of) const { return named(fl_engine_fender_name, of.number()); }
    body find_body(std::string_view name) const { return body(found(fl_engine_find_body, name)); }
    fender find_fender(std::string_view name) const { return fender(found(fl_engine_find_fender, name)); }

    /** Notices of the scenario, and what of it is left to the host; one per line. */
    std::string notices() const
    {
        std::size_t length = 0;
        must(fl_engine_notices(handle_, nullptr, 0, &length));
        std::string text(length + 1, '\0');
        must(fl_engine_notices(handle_, &text[0], text.size(), &length));
        text.resize(length);
        return text;
    }

    /** Mass matrix over surge, sway and yaw, row by row. */
    std::array<double, 9> mass_matrix(body of) const
    {
        std::array<double, 9> matrix{};
        must(fl_engine_mass_matrix(handle_, of.number(), matrix.data()));
        return matrix;
    }

    /** One state per body. */
    std::vector<fl_state> initial_states() const
    {
        std::vector<fl_state> states(body_count());
        must(fl_engine_initial_states(handle_, states.data(), states.size()));
        return states;
    }

    /** The outline of a body in its own frame; constant. */
    std::vector<point> outline(body of) const
    {
        std::size_t count = 0;
        must(fl_engine_outline(handle_, of.number(), nullptr, 0, &count));
        std::vector<point> corners(count);
        must(fl_engine_outline(handle_, of.number(), &corners.data()->x, count, &count));
        return corners;
    }

    void set_state(body of, const fl_state& state) { must(fl_engine_set_state(handle_, of.number(), &state)); }
    void set_states(span<const fl_state> states)
    {
        must(fl_engine_set_states(handle_, states.data(), states.size()));
    }
    void set_loads(span<const fl_wrench> loads) { must(fl_engine_set_loads(handle_, loads.data(), loads.size())); }
    void unset_loads() { must(fl_engine_set_loads(handle_, nullptr, 0)); }
    void mark_teleported(body of) { must(fl_engine_mark_teleported(handle_, of.number())); }
    void step(double step_s) { must(fl_engine_step(handle_, step_s)); }

    /** Sets states, and loads unless they are empty, takes a step and returns the wrenches in the caller's array. */
    void advance(span<const fl_state> states, span<const fl_wrench> loads, double step_s, span<fl_wrench> wrenches)
    {
        const bool fits = wrenches.size() == states.size() && (loads.empty() || loads.size() == states.size());
        if (!fits)
            throw std::invalid_argument("fenderline: advance() takes arrays of one length");
        must(fl_engine_advance(handle_, states.data(), loads.empty() ? nullptr : loads.data(), states.size(), step_s,
                               wrenches.data()));
    }

    void wrenches(span<fl_wrench> into) const { must(fl_engine_wrenches(handle_, into.data(), into.size())); }
    void peak_wrenches(span<fl_wrench> into) const { must(fl_engine_peak_wrenches(handle_, into.data(), into.size())); }
    void states_after(span<fl_state> into) const { must(fl_engine_states_after(handle_, into.data(), into.size())); }

    /** All contacts of the last step. */
    const std::vector<fl_contact>& contacts() const { return filled(fl_engine_contacts, contacts_); }
    /** All events of the last step. */
    const std::vector<fl_event>& events() const { return filled(fl_engine_events, events_); }
    /** All fenders as they are drawn. */
    const std::vector<fl_fender_view>& fender_views() const
    {
        views_.resize(fender_count());
        must(fl_engine_fender_views(handle_, views_.data(), views_.size()));
        return views_;
    }

    std::vector<std::uint8_t> save() const { return bytes_of(fl_engine_save); }
    void restore(span<const std::uint8_t> saved) { must(fl_engine_restore(handle_, saved.data(), saved.size())); }
    void reset() { must(fl_engine_reset(handle_)); }

    /** Keeps at least the last `steps` steps for dump(); 0 ends it. */
    void record(std::size_t steps) { must(fl_engine_record(handle_, steps)); }
    /** The recorded steps as a file that `fenderline replay` reads. */
    std::vector<std::uint8_t> dump() const { return bytes_of(fl_engine_dump); }

private:
    template <class Count>
    std::size_t counted(Count of) const
    {
        std::size_t count = 0;
        must(of(handle_, &count));
        return count;
    }
    template <class Name>
    std::string named(Name of, std::uint32_t number) const
    {
        std::size_t length = 0;
        must(of(handle_, number, nullptr, 0, &length));
        std::string text(length + 1, '\0');
        must(of(handle_, number, &text[0], text.size(), &length));
        text.resize(length);
        return text;
    }
    template <class Find>
    std::uint32_t found(Find find, std::string_view name) const
    {
        std::uint32_t number = 0;
        must(find(handle_, name.data(), name.size(), &number));
        return number;
    }
    template <class Fill, class Element>
    const std::vector<Element>& filled(Fill fill, std::vector<Element>& into) const
    {
        std::size_t count = 0;
        into.resize(into.capacity());
        fl_status status = fill(handle_, into.data(), sizeof(Element), into.size(), &count);
        if (status == FL_STATUS_BUFFER_TOO_SMALL) {
            into.resize(count);
            status = fill(handle_, into.data(), sizeof(Element), into.size(), &count);
        }
        must(status);
        into.resize(count);
        return into;
    }
    template <class Copy>
    std::vector<std::uint8_t> bytes_of(Copy copy) const
    {
        std::size_t length = 0;
        must(copy(handle_, nullptr, 0, &length));
        std::vector<std::uint8_t> bytes(length);
        must(copy(handle_, bytes.data(), bytes.size(), &length));
        return bytes;
    }

    fl_engine* handle_ = nullptr;
    mutable std::vector<fl_contact> contacts_;
    mutable std::vector<fl_event> events_;
    mutable std::vector<fl_fender_view> views_;
};

inline engine builder::build(const fl_settings& settings) const
{
    fl_engine* made = nullptr;
    must(fl_builder_build(handle_, &settings, &made));
    return engine(made);
}

/** What the replay of a dump gave. */
struct replayed {
    /** The engine after the last step. */
    engine after;
    /** Number of steps. */
    std::size_t steps;
    /** Number of steps that did not end with the recorded bits. */
    std::size_t different;
};

/** Replays what engine::dump() returned. */
inline replayed replay(span<const std::uint8_t> dump)
{
    check_version();
    std::size_t steps = 0, different = 0;
    fl_engine* made = nullptr;
    must(fl_replay_dump(dump.data(), dump.size(), &steps, &different, &made));
    return {engine(made), steps, different};
}

namespace detail {
template <class Make>
std::vector<point> outline_of(span<const point> points, std::size_t most, Make make)
{
    std::vector<point> made(most);
    std::size_t count = 0;
    must(make(points.empty() ? nullptr : &points.data()->x, points.size(), made.empty() ? nullptr : &made.data()->x,
              made.size(), &count));
    made.resize(count);
    return made;
}
} // namespace detail

/** The convex hull of points, such as the vertices of a mesh seen from above. */
inline std::vector<point> hull_of(span<const point> points)
{
    return detail::outline_of(points, points.size(), fl_outline_hull);
}

/** The whole outline of a ship from her starboard side. */
inline std::vector<point> mirrored(span<const point> side, double tolerance_m = 0.01)
{
    return detail::outline_of(side, 2 * side.size(), [=](const double* p, std::size_t n, double* q, std::size_t m,
                                                         std::size_t* k) {
        return fl_outline_mirror(p, n, tolerance_m, q, m, k);
    });
}

/** The outline with fewer vertices, none of the given farther away than the tolerance. */
inline std::vector<point> simplified(span<const point> outline, double tolerance_m)
{
    return detail::outline_of(outline, outline.size(), [=](const double* p, std::size_t n, double* q, std::size_t m,
                                                           std::size_t* k) {
        return fl_outline_simplify(p, n, tolerance_m, q, m, k);
    });
}

/** A point of a body's frame in the earth's: x north, y east. */
inline point to_earth(const fl_state& of, point own)
{
    const double c = std::cos(of.heading_rad), s = std::sin(of.heading_rad);
    return {of.north_m + c * own.x - s * own.y, of.east_m + s * own.x + c * own.y};
}

/** Coordinates of a game engine. */
struct vector3 {
    double x;
    double y;
    double z;
};

/**
 * The frames of game engines. Positions are relative to an origin that the caller chooses, in double, so that what remains fits
 * into float. Heights are up. docs/guides/game_loop.md has the table.
 */
namespace frames {
/** Unity: left-handed, y up; x east, z north. Its yaw (rad) is the heading. */
inline vector3 to_unity(point earth, double up_m, point origin = {0.0, 0.0})
{
    return {earth.y - origin.y, up_m, earth.x - origin.x};
}
inline point from_unity(vector3 at, point origin = {0.0, 0.0}) { return {at.z + origin.x, at.x + origin.y}; }

/** Godot, OpenGL: right-handed, y up; x east, z south. Their yaw (rad) is minus the heading. */
inline vector3 to_godot(point earth, double up_m, point origin = {0.0, 0.0})
{
    return {earth.y - origin.y, up_m, origin.x - earth.x};
}
inline point from_godot(vector3 at, point origin = {0.0, 0.0}) { return {origin.x - at.z, at.x + origin.y}; }

/** Unreal: left-handed, z up, centimetres; x north, y east. Its yaw is the heading. */
inline vector3 to_unreal(point earth, double up_m, point origin = {0.0, 0.0})
{
    return {100.0 * (earth.x - origin.x), 100.0 * (earth.y - origin.y), 100.0 * up_m};
}
inline point from_unreal(vector3 at, point origin = {0.0, 0.0})
{
    return {at.x / 100.0 + origin.x, at.y / 100.0 + origin.y};
}
} // namespace frames

} // namespace fenderline

#endif /* FENDERLINE_HPP */
