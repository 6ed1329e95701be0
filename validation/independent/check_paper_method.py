#!/usr/bin/env python3
"""Identities that paper_method.py must satisfy on its own, without the engine.

    python3 check_paper_method.py
"""

import copy
import math
import pathlib
import random
import tomllib
import unittest

import paper_method as pm

SCENARIO = pathlib.Path(__file__).parents[2] / "scenarios" / "oblique_hit.toml"


def oblique_hit():
    with open(SCENARIO, "rb") as file:
        return tomllib.load(file)


def columns(rows, names):
    return {name: [row[i] for row in rows] for i, name in enumerate(names)}


def contacts_of(scenario):
    return columns(pm.Simulation(scenario).run()[0], pm.CONTACT_COLUMNS)


def block_against_wall(restitution, damping, step_s):
    """A block of 1000 t, 20 m wide, at 1 m/s against a wall of 1 MN/m²: ω = √(k w / m) = √20 /s."""
    return {
        "time": {"step": step_s, "duration": 60.0, "integrator": "euler"},
        "contact": {"method": "paper"},
        "material": {"m": {"stiffness": 1e6, "damping": damping, "restitution": restitution,
                           "shear_stiffness": 1e6, "friction_static": 0.5,
                           "friction_dynamic": 0.5}},
        "body": {
            "wall": {"fixed": True, "outline": [[0, -50], [5, -50], [5, 50], [0, 50]]},
            "block": {"outline": [[-10, -10], [10, -10], [10, 10], [-10, 10]], "mass": 1e6,
                      "gyradius": 10, "position": [-10.000001, 3], "velocity": {"surge": 1.0}},
        },
        "pair": [{"bodies": ["wall", "block"], "material": "m"}],
    }


def random_convex(rng, count):
    angles = sorted(rng.uniform(0.0, math.tau) for _ in range(count))
    return [(3.0 * math.cos(a), 2.0 * math.sin(a)) for a in angles]


class Geometry(unittest.TestCase):
    def test_area_changes_by_chord_times_normal(self):
        """dS = d rotated by −90°, dotted with body 1's displacement: exact for the true overlap."""
        rng, checked, h = random.Random(1), 0, 1e-5
        while checked < 300:
            one = random_convex(rng, rng.randint(3, 9))
            shift = (rng.uniform(-4, 4), rng.uniform(-4, 4))
            other = [pm.add(v, shift) for v in random_convex(rng, rng.randint(3, 9))]
            if len(overlap := pm.clip(one, other)) < 3 or pm.area_and_centroid(overlap)[0] < 1e-2:
                continue
            d = pm.contact_line(one, other)
            for direction in ((1.0, 0.0), (0.0, 1.0)):
                ahead, back = (
                    pm.area_and_centroid(
                        pm.clip([pm.add(v, pm.scale(direction, s)) for v in one], other))[0]
                    for s in (h, -h))
                self.assertAlmostEqual((ahead - back) / (2 * h), pm.dot((d[1], -d[0]), direction),
                                       delta=5e-4)
            checked += 1

    def test_crossed_squares(self):
        square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        area, centroid = pm.area_and_centroid(pm.clip(square, [(x + 1.5, y) for x, y in square]))
        self.assertEqual((area, centroid), (1.0, (0.75, 0.0)))
        eight = pm.clip(square, [pm.turned(v, math.pi / 4) for v in square])
        self.assertAlmostEqual(pm.area_and_centroid(eight)[0], 8 * (math.sqrt(2) - 1), places=13)


class Contact(unittest.TestCase):
    def test_leaves_at_restitution_times_approach(self):
        for step_s in (0.01, 0.1, 0.5, 1.0):
            simulation = pm.Simulation(block_against_wall(0.1, 0.0, step_s))
            simulation.run()
            self.assertIsNone(simulation.pairs[0].memory)
            self.assertAlmostEqual(simulation.bodies[1].velocity[0], -0.1, places=12)

    def test_flat_head_on_is_a_half_sine(self):
        """Fully elastic, so that the limiter acts at the end only: depth v/ω, duration π/ω."""
        step_s = 1e-4
        scenario = block_against_wall(1.0, 0.0, step_s)
        scenario["time"]["duration"] = 1.0
        rows = contacts_of(scenario)
        omega = math.sqrt(20.0)
        self.assertAlmostEqual(max(rows["depth_m"]) * omega, 1.0, delta=2e-3)
        self.assertAlmostEqual(max(rows["normal_force_n"]) / (1e6 * omega), 1.0, delta=2e-3)
        self.assertAlmostEqual((rows["t_s"][-1] - rows["t_s"][0]) * omega / math.pi, 1.0,
                               delta=5e-3)
        self.assertAlmostEqual(rows["normal_x"][0], -1.0, places=12)

    def test_damper_takes_energy(self):
        speeds = []
        for damping in (0.0, 2e4, 1e5):
            simulation = pm.Simulation(block_against_wall(1.0, damping, 1e-3))
            simulation.run()
            speeds.append(-simulation.bodies[1].velocity[0])
        self.assertLessEqual(speeds[0], 1.0 + 1e-12)
        self.assertLess(speeds[1], 0.95 * speeds[0])
        self.assertLess(speeds[2], 0.8 * speeds[1])

    def test_pair_forces_balance(self):
        """Forces and moments on tug and ship cancel while no third body touches."""
        scenario = oblique_hit()
        del scenario["load"], scenario["body"]["dolphin"], scenario["pair"][1]
        simulation = pm.Simulation(scenario)
        momentum = pm.add(*(pm.scale(b.velocity, 1.0 / b.inverse_mass) for b in simulation.bodies))
        rows = simulation.run()[1]
        for ship, tug in zip(rows[0::2], rows[1::2]):
            self.assertEqual((ship[8], ship[9]), (-tug[8], -tug[9]))
            about_origin = sum(r[2] * r[9] - r[3] * r[8] + r[10] for r in (ship, tug))
            self.assertAlmostEqual(about_origin, 0.0, delta=1e-12 * 200.0 * 2e6)
        after = pm.add(*(pm.scale(b.velocity, 1.0 / b.inverse_mass) for b in simulation.bodies))
        for before, now in zip(momentum, after):
            self.assertAlmostEqual(now / before, 1.0, places=12)


class Frames(unittest.TestCase):
    """The oblique hit is the same in other axes."""

    def compare(self, other, signs):
        rows, others = contacts_of(oblique_hit()), contacts_of(other)
        self.assertEqual(rows["t_s"], others["t_s"])
        for name, factor in signs.items():
            largest = max(abs(value) for value in rows[name])
            for a, b in zip(rows[name], others[name]):
                self.assertAlmostEqual(a, factor * b, delta=1e-9 * largest, msg=name)

    SAME = {"area_m2": 1, "depth_m": 1, "v_normal_mps": 1, "normal_force_n": 1}

    def test_bodies_swapped(self):
        other = oblique_hit()
        order = ("dolphin", "tug", "ship")  # the pairs keep their order
        other["body"] = {name: other["body"][name] for name in order}
        self.compare(other, self.SAME | {"v_tangential_mps": 1, "tangential_force_n": 1,
                                         "shear_m": 1})

    def test_mirrored(self):
        other = copy.deepcopy(oblique_hit())
        for body in other["body"].values():
            body["outline"] = [[x, -y] for x, y in reversed(body["outline"])]
            body["position"][1] *= -1
            body["heading"] = -pm.si(body["heading"])
            for key in ("sway", "yaw"):
                if "velocity" in body:
                    body["velocity"][key] = -pm.si(body["velocity"][key])
        for load in other["load"]:
            load["force"][1] = -pm.si(load["force"][1])
            load["moment"] = -pm.si(load["moment"])
        self.compare(other, self.SAME | {"v_tangential_mps": -1, "tangential_force_n": -1,
                                         "shear_m": -1})

    def test_rotated(self):
        other = copy.deepcopy(oblique_hit())
        for body in other["body"].values():
            body["position"] = list(pm.turned(body["position"], 1.0))
            body["heading"] = pm.si(body["heading"]) + 1.0
        for load in other["load"]:
            load["force"] = list(pm.turned([pm.si(f) for f in load["force"]], 1.0))
        self.compare(other, self.SAME | {"v_tangential_mps": 1, "tangential_force_n": 1,
                                         "shear_m": 1})


class Coverage(unittest.TestCase):
    def test_oblique_hit_passes_through_every_branch(self):
        rows = contacts_of(oblique_hit())
        branches = set(zip(rows["state"], rows["limited"]))
        self.assertEqual(len(branches), 4)
        for name in ("shear_m", "tangential_force_n", "v_normal_mps", "v_tangential_mps",
                     "normal_x", "normal_y"):
            self.assertTrue(min(rows[name]) < 0.0 < max(rows[name]), name)


if __name__ == "__main__":
    unittest.main()
