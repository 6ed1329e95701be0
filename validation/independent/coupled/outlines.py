"""Outline against outline."""

import math

from .contact import Memory, Touch
from .polygons import area_and_centroid, box_of, boxes_meet, overlaps


class Outlines:
    """Two bodies whose outlines may meet: N = k S along the chord's normal, at the overlap's centroid."""

    def __init__(self, one, two, material):
        self.one, self.two, self.material = one, two, material
        self.name = f"{one.name} - {two.name}"
        self.box = box_of(two.outline)
        self.old = []

    def touches(self):
        """The patches of now; in `two`'s frame as far as the outlines go."""
        one, two = self.one, self.two
        c, s = two.cos * one.cos + two.sin * one.sin, two.cos * one.sin - two.sin * one.cos
        ox, oy = two.to_own((one.x, one.y))
        polygon = [(ox + c * x - s * y, oy + s * x + c * y) for x, y in one.outline]
        if not boxes_meet(box_of(polygon), self.box):
            self.old = []
            return []
        found = []
        for corners, (dx, dy) in overlaps(polygon, two.outline):
            area, (px, py) = area_and_centroid(corners)
            length = math.hypot(dx, dy)
            if area <= 1e-14 or length == 0.0:
                continue
            nx, ny = dy / length, -dx / length
            along = [x * nx + y * ny for x, y in corners]
            touch = Touch()
            touch.one, touch.two = one, two
            touch.nx, touch.ny = two.cos * nx - two.sin * ny, two.sin * nx + two.cos * ny
            touch.px, touch.py = two.to_earth((px, py))
            touch.depth, touch.area = max(along) - min(along), area
            touch.force, touch.stored, touch.tilt = self.material["stiffness"] * area, None, 0.0
            touch.material, touch.bounded = self.material, True
            # Where it lies on either body, by which it is known again.
            in_one = [(c * (x - ox) + s * (y - oy), c * (y - oy) - s * (x - ox)) for x, y in corners]
            touch.boxes = (box_of(in_one), box_of(corners))
            found.append(touch)
        self.inherit(found)
        return found

    def inherit(self, found):
        """Memory goes on where a patch lies where one lay, as one of the bodies sees it: shared out by area where
        one parts, its shear the mean by area where several become one."""

        def goes_on(old, boxes):
            return boxes_meet(old.boxes[0], boxes[0]) or boxes_meet(old.boxes[1], boxes[1])

        memories = []
        for touch in found:
            boxes = touch.boxes
            merged, whole = Memory(), 0.0
            for old in self.old:
                if not goes_on(old, boxes):
                    continue
                heirs = sum(other.area for other in found if goes_on(old, other.boxes))
                share = touch.area / heirs
                area = old.area * share
                merged.shear_m = (merged.shear_m * whole + old.shear_m * area) / (whole + area)
                whole += area
                merged.new = False
                merged.slides = merged.slides or old.slides
                merged.v_ref = max(merged.v_ref, old.v_ref)
                merged.approaching = merged.approaching or old.approaching
                merged.normal_n += old.normal_n * share
                merged.taken_j += old.taken_j * share
            merged.area = whole
            merged.boxes = boxes
            memories.append(merged)
        for touch, memory in zip(found, memories):
            touch.memory = memory
            touch.grip()
        self.old = memories

