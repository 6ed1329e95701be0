"""Fenders: a pressure on the hull's boundary within the fender's zone.

The force on a face is the gradient of an energy. With x from the face inwards and d(s) the depth of the hull behind
the face at s: the paper's foundation stores k/2 integral d^2 ds, so that the pressure is k x; for a fender of reaction
R at mean deflection S/w it is R/w. (The engine integrates over the fender's own sides instead, without the hull's
shape.)
"""

import math

from .contact import Memory, Touch
from .quantities import Curve, between, si
from .unloading import unloading_of


class Fender:
    """A face on `host` that the outlines of bodies compress."""

    def __init__(self, name, table, bodies, materials, families):
        self.name, self.host = name, bodies[table["on"]]
        self.material = materials[table["material"]]
        self.width = si(table["width"])
        facing = si(table["facing"])
        x, y = (si(value) for value in table["position"])
        self.unloading, scale = None, (1.0, 1.0)
        self.curve, self.by_time, self.by_angle, self.constant = None, [], [], 1.0
        if "type" in table:
            end, scale = self.of_catalogue(table, families)
        elif "stiffness" in table:
            end = si(table["projection"])
            self.curve = Curve([(0.0, 0.0), (1.0, si(table["stiffness"]))])
            self.rated = end
            self.stop_slope = 50.0 * si(table["stiffness"])
        elif "curve" in table:
            points = [(si(d), si(r)) for d, r in table["curve"]]
            end = points[-1][0]
            self.curve, self.rated = Curve(points), end
            self.stop_slope = 50.0 * points[-1][1] / end
        else:
            end = si(table["projection"])
            self.rated = end
            self.stop_slope = 50.0 * self.material["stiffness"] * self.width
        self.constant *= 1.0 + si(table.get("tolerance", 0.0))
        self.rated = si(table.get("rated_deflection", self.rated))
        self.projection = si(table.get("projection", getattr(self, "height", 0.0)))
        self.stop_from = end
        if "stop" in table:
            self.stop_from, self.stop_slope = si(table["stop"]["from"]), si(table["stop"]["stiffness"])
        self.unloading = unloading_of(table, families.get(table.get("type"), {}), scale, self.curve)
        out = (math.cos(facing), math.sin(facing))
        self.inward = (-out[0], -out[1])
        self.face = (x + self.projection * out[0], y + self.projection * out[1])
        self.memories = {}

    def of_catalogue(self, table, families):
        family = families[table["type"]]
        sizes = {size["designation"]: size for size in family.get("size", [])}
        if "size" in table:
            size = sizes[table["size"]]
            height, reaction = si(size["height"]), si(size["reaction"])
        else:
            height = si(table["height"])
            if "rated_reaction" in table:
                reaction = si(table["rated_reaction"])
            else:
                size = sizes[family["reference"]]
                reaction = si(size["reaction"]) * (height / si(size["height"])) ** 2
        reaction *= si(table.get("count", 1.0))
        self.height = height
        self.rated = height * si(family["rated_deflection"])
        points = [(si(d) * height, si(r) * reaction) for d, r in family["curve"]["points"]]
        self.curve = Curve(points)
        self.stop_slope = 50.0 * reaction / points[-1][0]

        def factors(name):
            return [(si(x), si(y)) for x, y in family.get(name, {}).get("points", [])]

        if "temperature" in table:
            self.constant = between(factors("temperature"), si(table["temperature"]))
        if table.get("angle_factor", True):
            self.by_angle = factors("angle_reaction")
        if table.get("velocity_factor", True):
            self.by_time = factors("velocity")
            if self.by_time and self.by_time[-1][0] < 1000.0:
                # A ship that rests on her fenders compresses them without end.
                self.by_time.append((1000.0, 1.0))
        return points[-1][0], (height, reaction)

    def first_factor(self, speed, tilt):
        time = self.rated / (0.74 * max(speed, 1e-9))
        return self.constant * between(self.by_time, time) * between(self.by_angle, tilt)

    def touches(self, hull):
        """The contact with a hull, with its memory. Without contact an empty list, and the memory is dropped."""
        boundary = self.boundary_of(hull)
        if boundary is None:
            self.memories.pop(hull.name, None)
            return []
        touch, spring, stop = self.pressed_by(hull, boundary)
        touch.grip()
        memory = touch.memory = self.memories.get(hull.name)
        if memory is None:
            memory = touch.memory = self.memories[hull.name] = Memory()
            memory.factor = self.first_factor(touch.v_n, touch.tilt)
        left = 1.0
        touch.bounded = self.unloading is None
        if self.unloading is not None:
            left = self.unloading.share_left(memory.tops, touch.depth, spring, stop, self.curve)
        touch.force = memory.factor * left * (spring[0] + stop[0])
        touch.stored = memory.factor * (spring[1] + stop[1])
        return [touch]

    def boundary_of(self, hull):
        """Integrals over the hull's boundary within the zone, in the face's frame; None without overlap."""
        host = self.host
        half, far = 0.5 * self.width, 2.0 * self.projection
        fx, fy = host.to_earth(self.face)
        ix = host.cos * self.inward[0] - host.sin * self.inward[1]
        iy = host.sin * self.inward[0] + host.cos * self.inward[1]
        # The hull's corners: x inwards from the face, s along it.
        a, b = ix * hull.cos + iy * hull.sin, iy * hull.cos - ix * hull.sin
        c = ix * (hull.x - fx) + iy * (hull.y - fy)
        xs = [a * x + b * y + c for x, y in hull.outline]
        if max(xs) <= 0.0:
            return None
        c = ix * (hull.y - fy) - iy * (hull.x - fx)
        ss = [a * y - b * x + c for x, y in hull.outline]
        sums = Boundary(fx, fy, ix, iy)
        to_x, to_s = xs[-1], ss[-1]
        for x, s in zip(xs, ss):
            x0, s0, x1, s1 = to_x, to_s, x, s
            to_x, to_s = x, s
            if (x0 <= 0.0 and x1 <= 0.0) or (s0 <= -half and s1 <= -half) or (s0 >= half and s1 >= half):
                continue
            dx, ds = x1 - x0, s1 - s0
            begin, end = 0.0, 1.0
            # Within x >= 0 and |s| <= half, as slope times the share of the side is at most the room.
            for slope, room in ((-dx, x0), (ds, half - s0), (-ds, half + s0)):
                if slope > 0.0:
                    end = min(end, room / slope)
                elif slope < 0.0:
                    begin = max(begin, room / slope)
            if begin < end:
                if max(x0 + begin * dx, x0 + end * dx) > far:
                    raise ValueError(f"{self.name}: a hull has gone through it")
                sums.add(x0 + begin * dx, s0 + begin * ds, x0 + end * dx, s0 + end * ds)
        return sums if sums.area > 1e-15 else None

    def pressed_by(self, hull, sums):
        """The contact, and (force [N], energy [J]) of loading by its spring and by its stop."""
        mean = sums.area / self.width
        if self.curve is None:
            k = self.material["stiffness"]
            gx, gs, torque = k * sums.area, k * sums.pressed_s, k * sums.pressed_torque
            stored, depth = k * sums.moment_x, sums.depth
        else:
            reaction, stored = self.curve.at(mean)
            each = reaction / self.width
            gx, gs, torque = each * sums.x, each * sums.s, each * sums.torque
            depth = mean
        past = max(mean - self.stop_from, 0.0)
        each = self.stop_slope * past / self.width
        gx, gs, torque = gx + each * sums.x, gs + each * sums.s, torque + each * sums.torque
        size = math.hypot(gx, gs)
        ux, us = gx / size, gs / size
        stop = each * (sums.x * ux + sums.s * us)
        # The point on the line of the force that is nearest to the centroid of the overlap.
        mid_x, mid_s = sums.moment_x / sums.area, sums.moment_s / sums.area
        off = (torque - (mid_x * gs - mid_s * gx)) / size
        at_x, at_s = mid_x + off * us, mid_s - off * ux
        touch = Touch()
        touch.one, touch.two, touch.material = hull, self.host, self.material
        touch.nx, touch.ny = sums.to_earth(ux, us)
        px, py = sums.to_earth(at_x, at_s)
        touch.px, touch.py = sums.fx + px, sums.fy + py
        touch.depth, touch.area = depth, sums.area
        touch.tilt = math.atan2(abs(sums.s), sums.x)
        return touch, (size - stop, stored), (stop, 0.5 * self.stop_slope * past * past)


class Boundary:
    """Integrals over the stretches of a hull's boundary in a fender's zone, of outward normal (n_x, n_s)."""

    def __init__(self, fx, fy, ix, iy):
        self.fx, self.fy, self.ix, self.iy = fx, fy, ix, iy
        # Of n and of its moment about the middle of the face; of x n, and of its moment.
        self.x = self.s = self.torque = self.pressed_s = self.pressed_torque = 0.0
        # S and its first moments: as nothing of the zone's own sides adds to them, of x n_x, x^2/2 n_x and x s n_x.
        self.area = self.moment_x = self.moment_s = 0.0
        self.depth = 0.0

    def add(self, x0, s0, x1, s1):
        # n times the length of the stretch is (ds, -dx).
        dx, ds = x1 - x0, s1 - s0
        mean_x, mean_s = 0.5 * (x0 + x1), 0.5 * (s0 + s1)
        square = (x0 * x0 + x0 * x1 + x1 * x1) / 3.0
        product = (2.0 * (x0 * s0 + x1 * s1) + x0 * s1 + x1 * s0) / 6.0
        self.x += ds
        self.s -= dx
        self.torque -= mean_x * dx + mean_s * ds
        self.pressed_s -= mean_x * dx
        self.pressed_torque -= square * dx + product * ds
        self.area += mean_x * ds
        self.moment_x += 0.5 * square * ds
        self.moment_s += product * ds
        self.depth = max(self.depth, x0, x1)

    def to_earth(self, x, s):
        return self.ix * x - self.iy * s, self.iy * x + self.ix * s
