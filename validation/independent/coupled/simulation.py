"""The steps of a run."""

import math
import pathlib
import tomllib

from .bodies import Body
from .fenders import Fender
from .outlines import Outlines
from .quantities import si
from .rows import fenders

FENDER_FILES = pathlib.Path(__file__).parents[3] / "fenders"

# Share of the speed of unheld energy that a contact may come apart with.
LET_GO = 0.8

# Coordinate descent ends where no contact changes its speed by more [m/s], and never after more rounds.
SETTLED_MPS = 1e-12
MOST_ROUNDS = 20000


class Simulation:
    """A scenario in fixed steps of `step_s` seconds."""

    def __init__(self, scenario, step_s):
        check(scenario)
        self.h = step_s
        self.duration = si(scenario["time"]["duration"])
        self.bodies = [Body(name, table) for name, table in scenario["body"].items()]
        by_name = {body.name: body for body in self.bodies}
        materials = {name: read_material(table) for name, table in scenario["material"].items()}
        self.outlines = []
        for i, one in enumerate(self.bodies):
            for two in self.bodies[i + 1:]:
                pairs = [pair for pair in scenario.get("pair", []) if fits(pair["bodies"], one.name, two.name)]
                if pairs and not (one.fixed and two.fixed):
                    self.outlines.append(Outlines(one, two, materials[pairs[-1]["material"]]))
        families = read_families()
        self.fenders = []
        for name, table in fenders(scenario):
            fender = Fender(name, table, by_name, materials, families)
            pairs = [pair for pair in self.outlines if fender.host in (pair.one, pair.two)]
            self.fenders.append((fender, [pair.two if pair.one is fender.host else pair.one for pair in pairs]))
        self.loads = [read_load(load, by_name) for load in scenario.get("load", [])]
        self.t, self.count, self.most_rounds = 0.0, 0, 0
        # By name of fender or pair: first touch, largest normal force, when, largest depth, when.
        self.peaks = {}
        # By name of body: the largest speed [m/s].
        self.fastest = {body.name: 0.0 for body in self.bodies if not body.fixed}
        # And the largest yaw rate [rad/s].
        self.most_turning = dict(self.fastest)

    def run(self):
        steps = math.ceil(self.duration / self.h - 1e-9)
        while self.count < steps:
            self.step()

    def step(self):
        """Symplectic Euler: forces of the places, momentum, then places with the new velocities."""
        h = self.h
        floating = [body for body in self.bodies if not body.fixed]
        named = [(pair.name, touch) for pair in self.outlines for touch in pair.touches()]
        for fender, hulls in self.fenders:
            named += [(fender.name, touch) for hull in hulls for touch in fender.touches(hull)]
        touches = [touch for _, touch in named]
        for touch in touches:
            begin(touch, h)
        let_go(touches)
        for touch in touches:
            bound(touch, h)
        for body, (fx, fy), moment, start, end in self.loads:
            share = min(max((min(end, self.t + h) - max(start, self.t)) / h, 0.0), 1.0)
            body.px += share * h * fx
            body.py += share * h * fy
            body.spin += share * h * moment
        for body in floating:
            # The impulse of the water is carried along sideways.
            body.spin -= h * (body.vx * body.py - body.vy * body.px)
            body.set_velocity()
        for touch in touches:
            touch.shear = shear_force(touch, touch.guess)
            touch.push(0.0, h * touch.shear)
        self.most_rounds = max(self.most_rounds, solve_normal(touches, h))
        for touch in touches:
            # With the N of this step, which the solve did not know.
            shear = shear_force(touch, touch.normal)
            touch.push(0.0, h * (shear - touch.shear))
            touch.shear = shear
        for touch in touches:
            remember(touch, h)
        self.watch(named, floating)
        for body in floating:
            body.x += h * body.vx
            body.y += h * body.vy
            body.heading += h * body.rate
            body.turn_axes()
            body.set_velocity()
        self.count += 1
        self.t = self.count * h

    def watch(self, named, floating):
        for body in floating:
            self.fastest[body.name] = max(self.fastest[body.name], math.hypot(body.vx, body.vy))
            self.most_turning[body.name] = max(self.most_turning[body.name], abs(body.rate))
        sums = {}
        for name, touch in named:
            force, depth = sums.get(name, (0.0, 0.0))
            sums[name] = force + touch.normal, max(depth, touch.depth)
        for name, (force, depth) in sums.items():
            peak = self.peaks.setdefault(name, [self.t, 0.0, self.t, 0.0, self.t])
            if force > peak[1]:
                peak[1:3] = force, self.t
            if depth > peak[3]:
                peak[3:5] = depth, self.t


# --------------------------------------------------------------------------------------------------
# One contact.


def begin(touch, h):
    """f, and v_ref: the fastest approach since V_n last changed its sign."""
    memory = touch.memory
    growth = (touch.area - memory.area) / h
    touch.law = max(0.0, touch.force + touch.material["damping"] * growth)
    if touch.v_n > 0.0:
        memory.v_ref = max(memory.v_ref, touch.v_n) if memory.approaching else touch.v_n
    memory.approaching = touch.v_n > 0.0


def bound(touch, h):
    """The speed that it may part with; any, where its rubber unloads by a law of its own. Between outlines, whose
    chord's normal has no potential, no more work than it took."""
    memory = touch.memory
    touch.limit = touch.material["restitution"] * memory.v_ref if touch.bounded else math.inf
    if touch.stored is None and touch.v_n < 0.0:
        touch.law = min(touch.law, memory.taken_j / (-touch.v_n * h))
    touch.guess = touch.law if memory.new else min(memory.normal_n, touch.law)


def shear_force(touch, normal_n):
    """T on `one`: a spring with memory and Coulomb's limit on it, the sliding one as long as it slides."""
    material, memory = touch.material, touch.memory
    force = -material["shear_stiffness"] * memory.shear_m
    held = "friction_dynamic" if memory.slides else "friction_static"
    touch.slides = abs(force) > material[held] * normal_n
    if touch.slides:
        force = math.copysign(material["friction_dynamic"] * normal_n, force)
    return force


def remember(touch, h):
    memory, stiffness = touch.memory, touch.material["shear_stiffness"]
    v_n, v_t = touch.speeds()
    # A slide ends where it is turned back, not where N rises. The step of the first touch, when N is that of next to no
    # depth, begins none.
    on = touch.slides or (memory.slides and memory.shear_m * v_t > 0.0)
    memory.slides = on and not memory.new
    if touch.slides and stiffness > 0.0:
        memory.shear_m = -touch.shear / stiffness
    memory.shear_m += h * v_t
    memory.taken_j = max(memory.taken_j + 0.5 * h * touch.normal * (touch.v_n + v_n), 0.0)
    memory.normal_n, memory.area, memory.new = touch.normal, touch.area, False


# --------------------------------------------------------------------------------------------------
# All contacts.


def let_go(touches):
    """Energy that no load holds raises v_ref: what a contact stores at f and bore only N of in the last step has
    U (1 - N/f)^2 too much; between outlines, of which no potential is known, U is f depth/3. Contacts of the same two
    bodies, or of one body with all that is fixed, let go together."""
    unheld = {}
    for touch in touches:
        memory = touch.memory
        if memory.new or not touch.bounded or memory.normal_n >= touch.law:
            continue
        stored = touch.stored if touch.stored is not None else touch.law * touch.depth / 3.0
        bodies = joined(touch)
        unheld[bodies] = unheld.get(bodies, 0.0) + stored * (1.0 - memory.normal_n / touch.law) ** 2
    for touch in touches:
        energy = unheld.get(joined(touch), 0.0)
        if energy > 0.0:
            touch.memory.v_ref = max(touch.memory.v_ref, LET_GO * math.sqrt(2.0 * energy * touch.linear))


def joined(touch):
    if touch.one.fixed:
        return touch.two.name
    return touch.one.name if touch.two.fixed else (touch.one.name, touch.two.name)


def solve_normal(touches, h):
    """N of all contacts, of bodies that moved without them: 0 <= N <= f and V_n >= -limit, N < f only where that is
    tight. That is the minimum of a convex quadratic over a box; coordinate descent. Returns the number of rounds."""
    for touch in touches:
        touch.normal = touch.law
        touch.push(h * touch.law, 0.0)
    if all(touch.speeds()[0] >= -touch.limit for touch in touches):
        return 0
    for touch in touches:
        touch.push(h * (touch.guess - touch.normal), 0.0)
        touch.normal = touch.guess
    start = [touch.normal for touch in touches]
    columns = [touch.column(h) for touch in touches]
    rounds, largest = 0, math.inf
    while largest > SETTLED_MPS:
        if rounds == MOST_ROUNDS:
            raise ArithmeticError(f"contacts have not settled in {MOST_ROUNDS} rounds")
        rounds, largest = rounds + 1, 0.0
        for touch, (a, b, nx, ny, an, bn, ax, ay, ar, bx, by, br, per_n) in zip(touches, columns):
            closing = nx * (a.vx - b.vx) + ny * (a.vy - b.vy) + an * a.rate - bn * b.rate
            force = min(max(touch.normal + (closing + touch.limit) / per_n, 0.0), touch.law)
            change = force - touch.normal
            if change != 0.0:
                touch.normal = force
                a.vx -= change * ax
                a.vy -= change * ay
                a.rate -= change * ar
                b.vx += change * bx
                b.vy += change * by
                b.rate += change * br
                largest = max(largest, abs(change) * per_n)
    # Momentum follows, and velocities from it.
    for touch, before in zip(touches, start):
        touch.push(h * (touch.normal - before), 0.0)
    return rounds


# --------------------------------------------------------------------------------------------------
# The scenario.


def check(scenario):
    """Refuses what this implementation does not know, rather than leave it out."""
    if scenario.get("contact", {}).get("method", "coupled") != "coupled":
        raise ValueError("this is the coupled method only")
    if scenario["time"].get("integrator", "semi_implicit") != "semi_implicit":
        raise ValueError("the bodies are moved by the engine's own integrator only")
    for key in ("vessel", "line", "tug", "order", "environment", "provider", "fender_files"):
        if key in scenario:
            raise ValueError(f"`{key}` is not known here")


def read_material(table):
    material = {key: si(table.get(key, 0.0)) for key in ("stiffness", "damping", "shear_stiffness", "restitution")}
    material["friction_static"] = si(table.get("friction_static", 0.0))
    material["friction_dynamic"] = si(table.get("friction_dynamic", material["friction_static"]))
    return material


def read_families():
    families = {}
    for path in sorted(FENDER_FILES.glob("*.toml")):
        with open(path, "rb") as file:
            families.update(tomllib.load(file).get("family", {}))
    return families


def read_load(load, by_name):
    force = tuple(si(value) for value in load.get("force", (0.0, 0.0)))
    start, end = si(load.get("from", 0.0)), si(load.get("until", math.inf))
    return by_name[load["body"]], force, si(load.get("moment", 0.0)), start, end


def fits(names, one, two):
    """Does a pair of a scenario, which may have wildcards, mean these two bodies?"""
    a, b = ((name, "*") for name in (one, two))
    return (names[0] in a and names[1] in b) or (names[0] in b and names[1] in a)
