#!/usr/bin/env python3
"""The paper method of Moreno et al. (TransNav 17(4), 2023), corrected, written a second time.

An independent implementation of sections 1 to 4 of docs/contact_model.md, in plain Python, as simply as
we could. It shares no code with the engine and computes the same definitions in other ways: geometry in
world axes about the midpoint of the two bodies, Sutherland-Hodgman clipping of every edge against
every edge, crossing points by segment-segment tests, no caching, no warm start. Convex outlines,
forward Euler and the paper method only; the standard library only.

    python3 paper_method.py SCENARIO.toml --out DIR     writes DIR/contacts.csv and DIR/bodies.csv

Axes: x north, y east, headings clockwise (from x to y); SI units. "Eq. n" is the paper's numbering.
"""

import argparse
import csv
import math
import pathlib
import tomllib

CONTACT_COLUMNS = (
    "t_s body_1 body_2 area_m2 depth_m point_x_m point_y_m normal_x normal_y v_normal_mps "
    "v_tangential_mps shear_m normal_force_n tangential_force_n state limited"
).split()
BODY_COLUMNS = (
    "t_s body x_m y_m heading_rad u_mps v_mps r_radps force_x_n force_y_n moment_z_nm"
).split()

# ---------------------------------------------------------------------------------------------
# Plane vectors: pairs of floats.


def add(a, b):
    return (a[0] + b[0], a[1] + b[1])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1])


def scale(a, factor):
    return (a[0] * factor, a[1] * factor)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def turned(a, angle_rad):
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    return (c * a[0] - s * a[1], s * a[0] + c * a[1])


def sign(value):
    return (value > 0.0) - (value < 0.0)


# ---------------------------------------------------------------------------------------------
# Geometry of one contact (section 1). Polygons are convex, in the order from x towards y.


def area_and_centroid(polygon):
    """Area and centroid, about the polygon's own first vertex."""
    origin = polygon[0]
    twice_area, sum_x, sum_y = 0.0, 0.0, 0.0
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        a, b = sub(a, origin), sub(b, origin)
        part = cross(a, b)
        twice_area += part
        sum_x += part * (a[0] + b[0])
        sum_y += part * (a[1] + b[1])
    if twice_area <= 0.0:
        return 0.0, origin
    return 0.5 * twice_area, add(origin, (sum_x / (3.0 * twice_area), sum_y / (3.0 * twice_area)))


def edges(polygon):
    return list(zip(polygon, polygon[1:] + polygon[:1]))


def clip(subject, clipper):
    """The part of `subject` inside the convex `clipper` (Sutherland-Hodgman)."""
    for c, d in edges(clipper):
        kept = []
        for a, b in edges(subject):
            side_a, side_b = cross(sub(d, c), sub(a, c)), cross(sub(d, c), sub(b, c))
            if side_a >= 0.0:
                kept.append(a)
            if (side_a > 0.0 > side_b) or (side_a < 0.0 < side_b):
                kept.append(add(a, scale(sub(b, a), side_a / (side_a - side_b))))
        subject = kept
        if not subject:
            break
    return subject


def contact_line(polygon_1, polygon_2):
    """d = sum of (P_out - P_in): where body 1's boundary leaves and enters body 2."""
    d = (0.0, 0.0)
    for a, b in edges(polygon_1):
        for p, q in edges(polygon_2):
            side_a, side_b = cross(sub(q, p), sub(a, p)), cross(sub(q, p), sub(b, p))
            side_p, side_q = cross(sub(b, a), sub(p, a)), cross(sub(b, a), sub(q, a))
            if (side_a > 0.0) == (side_b > 0.0) or (side_p > 0.0) == (side_q > 0.0):
                continue
            point = add(a, scale(sub(b, a), side_a / (side_a - side_b)))
            d = sub(d, point) if side_b > 0.0 else add(d, point)
    return d


class Overlap:
    """Area, centroid, normal and depth of B1 and B2 where they overlap."""

    def __init__(self, body_1, body_2, last_normal):
        # A local origin half-way between the bodies, for precision far from the world's origin.
        origin = scale(add(body_1.position, body_2.position), 0.5)
        polygon_1, polygon_2 = body_1.polygon(origin), body_2.polygon(origin)
        overlap = clip(polygon_1, polygon_2)
        self.area, centroid = area_and_centroid(overlap) if len(overlap) > 2 else (0.0, None)
        if self.area <= 0.0:
            return
        d = contact_line(polygon_1, polygon_2)
        length = math.hypot(d[0], d[1])
        if length > 0.0:
            self.normal = (d[1] / length, -d[0] / length)
        elif last_normal is not None:
            self.normal = last_normal
        else:
            raise ValueError("one body lies inside the other and there is no earlier normal")
        self.tangent = (-self.normal[1], self.normal[0])
        along = [dot(vertex, self.normal) for vertex in overlap]
        self.depth = max(along) - min(along)
        self.point = add(origin, centroid)


# ---------------------------------------------------------------------------------------------
# Bodies.


class Body:
    def __init__(self, name, outline, fixed, mass, inertia, position, heading, velocity, yaw_rate):
        self.name, self.outline, self.fixed = name, outline, fixed
        self.inverse_mass = 0.0 if fixed else 1.0 / mass
        self.inverse_inertia = 0.0 if fixed else 1.0 / inertia
        self.position, self.heading = position, heading
        self.velocity, self.yaw_rate = velocity, yaw_rate  # earth-fixed
        self.last_position, self.last_heading = position, heading
        self.force, self.moment = (0.0, 0.0), 0.0  # of the contacts, this step

    def polygon(self, origin):
        shift = sub(self.position, origin)
        return [add(turned(vertex, self.heading), shift) for vertex in self.outline]

    def velocity_at(self, point):
        r = sub(point, self.position)
        return add(self.velocity, (-self.yaw_rate * r[1], self.yaw_rate * r[0]))

    def carried(self, last_point):
        """The displacement since the last step of the material point that was then at `last_point`."""
        in_body = turned(sub(last_point, self.last_position), -self.last_heading)
        return sub(add(self.position, turned(in_body, self.heading)), last_point)

    def push(self, force, point):
        self.force = add(self.force, force)
        self.moment += cross(sub(point, self.position), force)

    def advance(self, step_s, load_force, load_moment):
        """Forward Euler: position with the old velocity, velocity with the step's forces."""
        self.last_position, self.last_heading = self.position, self.heading
        if self.fixed:
            return
        self.position = add(self.position, scale(self.velocity, step_s))
        self.heading += step_s * self.yaw_rate
        force = add(self.force, load_force)
        self.velocity = add(self.velocity, scale(force, step_s * self.inverse_mass))
        self.yaw_rate += step_s * (self.moment + load_moment) * self.inverse_inertia


# ---------------------------------------------------------------------------------------------
# The contact law (sections 2 to 4) and its memory.


class PairOfBodies:
    def __init__(self, body_1, body_2, material):
        self.bodies, self.material = (body_1, body_2), material
        self.memory = None  # while they do not touch

    def step(self, step_s):
        """Force on both bodies from the states at the start of the step, with its row of contacts.csv."""
        body_1, body_2 = self.bodies
        material, memory = self.material, self.memory
        overlap = Overlap(body_1, body_2, memory["normal"] if memory else None)
        if overlap.area <= 0.0:
            self.memory = None
            return None
        normal, tangent, point = overlap.normal, overlap.tangent, overlap.point

        relative = sub(body_1.velocity_at(point), body_2.velocity_at(point))
        v_n, v_t = dot(relative, normal), dot(relative, tangent)

        if memory is None:
            memory = {"v_n0": v_n, "v_t0": v_t, "shear": 0.0, "area": 0.0}
        else:
            slipped = sub(body_1.carried(memory["point"]), body_2.carried(memory["point"]))
            memory["shear"] += dot(slipped, tangent)

        # Effective inverse masses at the contact (eq. 23 and the cross term of eq. 22 and 25).
        inverse_x, inverse_y, k_nt = 0.0, 0.0, 0.0
        for body in self.bodies:
            r = sub(point, body.position)
            r_n, r_t = dot(r, normal), dot(r, tangent)
            inverse_x += body.inverse_mass + r_t * r_t * body.inverse_inertia
            inverse_y += body.inverse_mass + r_n * r_n * body.inverse_inertia
            k_nt -= r_n * r_t * body.inverse_inertia

        # Normal force (eq. 3 with the damper's sign corrected), limited (eq. 26).
        area_rate = (overlap.area - memory["area"]) / step_s
        n_trial = max(0.0, material["stiffness"] * overlap.area + material["damping"] * area_rate)
        leave_at = material["restitution"] * max(memory["v_n0"], 0.0)
        n_max = max(0.0, v_n + leave_at) / (inverse_x * step_s)
        n_force = min(n_trial, n_max)

        # Friction (eq. 4 to 8), with the limited normal force.
        k_s, shear = material["shear_stiffness"], memory["shear"]
        slips = abs(k_s * shear) > material["friction_static"] * n_force
        if slips:
            friction = material["friction_dynamic"] * n_force
            t_trial = -sign(shear) * friction
            memory["shear"] = sign(shear) * friction / k_s
        else:
            t_trial = -k_s * shear

        # Tangential limiter (eq. 26): T may decrease but not change its sign.
        leave_at = material["restitution"] * abs(memory["v_t0"])

        def force_that_gives(v_t_after):
            return ((v_t_after - v_t) / step_s + k_nt * n_force) / inverse_y

        if t_trial > 0.0:
            t_force = max(0.0, min(t_trial, force_that_gives(max(v_t, leave_at))))
        elif t_trial < 0.0:
            t_force = min(0.0, max(t_trial, force_that_gives(min(v_t, -leave_at))))
        else:
            t_force = t_trial
        limited = n_trial > n_max or t_force != t_trial

        force = add(scale(normal, -n_force), scale(tangent, t_force))
        body_1.push(force, point)
        body_2.push(scale(force, -1.0), point)

        memory["area"], memory["point"], memory["normal"] = overlap.area, point, normal
        self.memory = memory
        return [
            body_1.name,
            body_2.name,
            overlap.area,
            overlap.depth,
            *point,
            *normal,
            v_n,
            v_t,
            memory["shear"],
            n_force,
            t_force,
            "slip" if slips else "stick",
            "true" if limited else "false",
        ]


# ---------------------------------------------------------------------------------------------
# The scenario file.

UNITS = {
    "m": 1.0,
    "s": 1.0,
    "kg": 1.0,
    "t": 1000.0,
    "N": 1.0,
    "kN": 1000.0,
    "kn": 1852.0 / 3600.0,
    "rad": 1.0,
    "deg": math.pi / 180.0,
}


def si(value):
    """A number in SI; a string carries its unit: "500 kN/m^2", "20 kN.s/m^2", "3 deg/s"."""
    if not isinstance(value, str):
        return float(value)
    number, _, unit = value.strip().partition(" ")
    over, *under = unit.strip().split("/")
    factor = 1.0
    for group, direction in [(over, 1)] + [(part, -1) for part in under]:
        for name in group.split("."):
            name, _, power = name.partition("^")
            factor *= UNITS[name] ** (direction * int(power or 1))
    return float(number) * factor


def read_body(name, table):
    outline = [(si(x), si(y)) for x, y in table["outline"]]
    heading = si(table.get("heading", 0.0))
    position = tuple(si(value) for value in table.get("position", [0.0, 0.0]))
    if table.get("fixed", False):
        return Body(name, outline, True, None, None, position, heading, (0.0, 0.0), 0.0)
    added = table.get("added_mass", {})
    displacement = si(table["mass"])
    mass = displacement * (1.0 + min(added.get("surge", 0.0), added.get("sway", 0.0)))
    inertia = displacement * si(table["gyradius"]) ** 2 * (1.0 + added.get("yaw", 0.0))
    speed = {key: si(value) for key, value in table.get("velocity", {}).items()}
    velocity = turned((speed.get("surge", 0.0), speed.get("sway", 0.0)), heading)
    yaw_rate = speed.get("yaw", 0.0)
    return Body(name, outline, False, mass, inertia, position, heading, velocity, yaw_rate)


def check_convex(body):
    sides = [cross(sub(b, a), sub(d, c)) for (a, b), (c, d) in
             zip(edges(body.outline), edges(body.outline)[1:] + edges(body.outline)[:1])]
    if min(sides) < 0.0:
        raise ValueError(f"{body.name}: outline is not convex, or not walked from x towards y")


class Simulation:
    def __init__(self, scenario):
        if scenario["contact"]["method"] != "paper" or scenario["time"]["integrator"] != "euler":
            raise ValueError("this script knows the paper method and forward Euler only")
        self.step_s = si(scenario["time"]["step"])
        self.steps = math.ceil(si(scenario["time"]["duration"]) / self.step_s)
        self.bodies = [read_body(name, table) for name, table in scenario["body"].items()]
        for body in self.bodies:
            check_convex(body)
        self.loads = scenario.get("load", [])
        materials = {
            name: {key: si(table.get(key, 0.0)) for key in (
                "stiffness", "damping", "shear_stiffness", "friction_static", "friction_dynamic",
                "restitution")}
            for name, table in scenario["material"].items()
        }
        named = {frozenset(pair["bodies"]): materials[pair["material"]]
                 for pair in scenario["pair"]}
        self.pairs = [
            PairOfBodies(one, other, named[frozenset((one.name, other.name))])
            for i, one in enumerate(self.bodies)
            for other in self.bodies[i + 1:]
            if frozenset((one.name, other.name)) in named
        ]

    def load_on(self, body, t_s):
        force, moment = (0.0, 0.0), 0.0
        for load in self.loads:
            start, end = si(load.get("from", 0.0)), si(load.get("until", math.inf))
            if load["body"] == body.name and start <= t_s < end:
                force = add(force, tuple(si(value) for value in load.get("force", [0.0, 0.0])))
                moment += si(load.get("moment", 0.0))
        return force, moment

    def run(self):
        """Rows of contacts.csv and of bodies.csv."""
        contact_rows, body_rows = [], []
        for index in range(self.steps):
            t_s = index * self.step_s
            for body in self.bodies:
                body.force, body.moment = (0.0, 0.0), 0.0
            for pair in self.pairs:
                row = pair.step(self.step_s)
                if row is not None:
                    contact_rows.append([t_s] + row)
            for body in self.bodies:
                u, v = turned(body.velocity, -body.heading)
                body_rows.append([t_s, body.name, *body.position, body.heading, u, v,
                                  body.yaw_rate, *body.force, body.moment])
            for body in self.bodies:
                body.advance(self.step_s, *self.load_on(body, t_s))
        return contact_rows, body_rows


def write_csv(path, columns, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        # repr gives the shortest digits that read back as the same double.
        writer.writerows([repr(v) if isinstance(v, float) else v for v in row] for row in rows)


def main():
    parser = argparse.ArgumentParser(description="The paper method, written independently.")
    parser.add_argument("scenario", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    with open(arguments.scenario, "rb") as file:
        contacts, bodies = Simulation(tomllib.load(file)).run()
    arguments.out.mkdir(parents=True, exist_ok=True)
    write_csv(arguments.out / "contacts.csv", CONTACT_COLUMNS, contacts)
    write_csv(arguments.out / "bodies.csv", BODY_COLUMNS, bodies)


if __name__ == "__main__":
    main()
