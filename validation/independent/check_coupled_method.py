#!/usr/bin/env python3
"""Identities that coupled/ must satisfy on its own, without the engine.

    python3 check_coupled_method.py
"""

import math
import random
import unittest

from coupled.polygons import area_and_centroid, overlaps
from coupled.quantities import Curve
from coupled.simulation import Simulation
from coupled.unloading import Unloading

SQUARE = [[-10, -10], [10, -10], [10, 10], [-10, 10]]


def scene(fender=None, load=None, speed=0.0, material=None, duration=60.0, others=None):
    """A block of 1000 t afloat (1800 t sideways) whose side is 20 m long, 1 mm off a fender 4 m wide of 500 kN/m^2."""
    rubber = {"stiffness": 5e5, "shear_stiffness": 3e6, "restitution": 0.1, **(material or {})}
    return {
        "time": {"duration": duration},
        "material": {"rubber": rubber, "concrete": {"stiffness": 5e7}},
        "body": {
            "block": {"outline": SQUARE, "mass": 1e6, "gyradius": 6, "added_mass": {"sway": 0.8, "yaw": 0.3},
                      "velocity": {"sway": speed}},
            "quay": {"outline": [[-50, 0], [50, 0], [50, 9], [-50, 9]], "position": [0, 11.001], "fixed": True},
            **(others or {}),
        },
        "pair": [{"bodies": ["block", "quay"], "material": "concrete"}],
        "fender": {"f": {"on": "quay", "position": [0, 0], "facing": "-90 deg", "width": 4, "projection": 1,
                         "material": "rubber", **(fender or {})}},
        "load": [{"body": "block", "force": load}] if load else [],
    }


def star(rng):
    """A polygon that is not convex, in the order from x to y."""
    count = rng.randint(5, 9)
    angles = [(k + rng.uniform(0.0, 0.9)) * math.tau / count for k in range(count)]
    return [(r * math.cos(a), 0.8 * r * math.sin(a)) for a in angles for r in (rng.uniform(1.0, 3.0),)]


class Geometry(unittest.TestCase):
    def test_area_changes_by_chord_times_normal_in_every_part(self):
        rng, checked, h = random.Random(3), 0, 1e-6
        while checked < 200:
            one, two = star(rng), star(rng)
            x, y = rng.uniform(-4, 4), rng.uniform(-4, 4)

            def parts(dx, dy):
                try:
                    return overlaps([(px + x + dx, py + y + dy) for px, py in one], two)
                except ValueError:
                    return []

            here = parts(0.0, 0.0)
            areas = [[area_and_centroid(corners)[0] for corners, _ in parts(*d)] for d in ((h, 0), (-h, 0), (0, h), (0, -h))]
            if not here or any(len(a) != len(here) for a in areas):
                continue
            chord = [sum(d[k] for _, d in here) for k in (0, 1)]
            ds = (sum(areas[0]) - sum(areas[1])) / (2 * h), (sum(areas[2]) - sum(areas[3])) / (2 * h)
            self.assertAlmostEqual(ds[0], chord[1], delta=1e-4)
            self.assertAlmostEqual(ds[1], -chord[0], delta=1e-4)
            checked += 1


class Faces(unittest.TestCase):
    def test_force_and_moment_are_the_gradient_of_what_is_stored(self):
        for law in ({}, {"stiffness": 4e6}, {"curve": [[0, 0], [0.2, 9e5], [0.5, 7e5], [0.7, 1e6]]}):
            simulation = Simulation(scene(fender=law), 0.01)
            block = simulation.bodies[0]
            fender = simulation.fenders[0][0]

            def stored(dx, dy, turn):
                block.x, block.y, block.heading = 9.5 + dx, 0.4 + dy, 0.05 + turn
                block.turn_axes()
                fender.memories.clear()
                return fender.touches(block)[0]

            touch, h = stored(0, 0, 0), 1e-6
            force = -touch.force * touch.nx, -touch.force * touch.ny
            moment = (touch.px - block.x) * force[1] - (touch.py - block.y) * force[0]
            for given, d in zip((*force, moment), ((h, 0, 0), (0, h, 0), (0, 0, h))):
                slope = (stored(*d).stored - stored(*(-v for v in d)).stored) / (2 * h)
                self.assertAlmostEqual(given, -slope, delta=1e-5 * touch.force * (10 if d[2] else 1))

    def test_a_loop_returns_its_share(self):
        loading = Curve([(0.0, 0.0), (0.3, 9e5), (0.5, 8e5), (0.7, 1e6)])
        for returned in (0.3, 0.55, 0.9):
            law, tops, work, last = Unloading(returned=returned), [], 0.0, 0.0
            steps = [0.5 * k / 4000 for k in range(4001)]
            taken = loading.at(0.5)[1]
            for before, now in zip(steps + steps[::-1], steps[1:] + steps[::-1]):
                spring = loading.at(now)
                force = spring[0] * law.share_left(tops, now, spring, (0.0, 0.0), loading) if now > 0.0 else 0.0
                work += 0.5 * (last + force) * (now - before)
                last = force
            self.assertAlmostEqual(1.0 - work / taken, returned, delta=1e-3)


class Runs(unittest.TestCase):
    def test_a_pushed_block_rests_at_its_static_depth(self):
        for load in (1e5, 2e5):
            # With friction: a ship on one fender would slip off it.
            simulation = Simulation(scene(load=[0, load], material={"friction_static": 0.3}, duration=600.0), 0.02)
            simulation.run()
            self.assertAlmostEqual(simulation.bodies[0].y - 0.001, load / 2e6, delta=1e-4)

    def test_it_leaves_with_its_restitution(self):
        for restitution in (0.1, 0.5, 1.0):
            simulation = Simulation(scene(speed=0.3, material={"restitution": restitution}, duration=10.0), 0.001)
            simulation.run()
            self.assertAlmostEqual(-simulation.bodies[0].own_speeds()[1], 0.3 * restitution, delta=1e-3)

    def test_with_an_unloading_law_it_leaves_with_the_root_of_what_is_returned(self):
        simulation = Simulation(scene(fender={"returned_energy": 0.49}, speed=0.3, duration=10.0), 0.001)
        simulation.run()
        self.assertAlmostEqual(-simulation.bodies[0].own_speeds()[1], 0.3 * 0.7, delta=1e-3)

    def test_two_bodies_alone_keep_their_momentum(self):
        """Linear momentum to rounding; angular momentum, x cross P + H, to the error of the time step."""
        barge = {"outline": SQUARE, "mass": 2e6, "gyradius": 7, "added_mass": {"surge": 0.1, "sway": 0.5, "yaw": 0.2},
                 "position": [7, 30], "heading": 0.4, "velocity": {"surge": 0.1, "sway": -0.9, "yaw": 0.01}}
        turned = []
        for step_s in (0.004, 0.002):
            data = scene(speed=0.4, material={"friction_static": 0.4}, others={"barge": barge}, duration=30.0)
            del data["body"]["quay"], data["fender"]
            data["pair"] = [{"bodies": ["*", "*"], "material": "rubber"}]
            simulation = Simulation(data, step_s)

            def sums():
                p = [sum(getattr(b, k) for b in simulation.bodies) for k in ("px", "py")]
                return (*p, sum(b.x * b.py - b.y * b.px + b.spin for b in simulation.bodies))

            before = sums()
            simulation.run()
            self.assertIn("block - barge", simulation.peaks)
            after = sums()
            self.assertAlmostEqual(after[0], before[0], delta=1e-6)
            self.assertAlmostEqual(after[1], before[1], delta=1e-6)
            turned.append(abs(after[2] - before[2]) / abs(before[2]))
        self.assertLess(turned[0], 1e-4)
        self.assertAlmostEqual(turned[1], 0.5 * turned[0], delta=0.1 * turned[0])

    def test_a_block_that_is_dragged_slides_at_dynamic_friction(self):
        data = scene(load=[9e4, 2e5], material={"friction_static": 0.3}, duration=12.0)
        # So long that friction at her side does not turn her.
        data["body"]["block"]["gyradius"] = 1e4
        simulation = Simulation(data, 0.005)
        simulation.run()
        before = simulation.bodies[0].own_speeds()[0]
        for _ in range(200):
            simulation.step()
        gained = simulation.bodies[0].own_speeds()[0] - before
        self.assertAlmostEqual(gained, (9e4 - 0.3 * 2e5) / 1e6, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
