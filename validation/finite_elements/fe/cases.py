"""The load cases of each shape. Forces are in units of the shear modulus times the height (times height squared for the
cone), deflections over the height."""

import time

import numpy as np

from . import rubber, sections
from .plane_contact import PlaneContact
from .press import Material, Section, follow
from .self_contact import SelfContact

# Stiffness of planes and of self-contact: pressure over depth, shear modulus over height. At a mean pressure of
# half the shear modulus the penetration is half a thousandth of the height.
PLANE = 1000.0
SELF = 300.0
# Bending stiffness of the skin that keeps surfaces from creasing, shear modulus times height cubed.
SKIN = {"cylinder": 1e-5, "solid_d": 0.0, "hollow_d": 1e-4, "cone": 2e-4}
# Largest deflection of each, over its height.
FARTHEST = {"cylinder": 0.5, "solid_d": 0.5, "hollow_d": 0.5, "cone": 0.4}
STEP = 0.02
# Height of the hollow D's floor.
FLOOR = 0.25


class Pressed:
    """A shape under its plate."""

    def __init__(self, name, fineness, whole=False, tilt_deg=0.0, skin=None):
        self.name = name
        self.whole = whole
        material = Material(bulk_over_shear=rubber.BULK_OVER_SHEAR)
        skin = SKIN[name] if skin is None else skin
        if name == "cone":
            self._cone(fineness, material, skin)
        elif name == "cylinder" and not whole:
            self._cylinder_quarter(fineness, material, skin)
        else:
            self._on_its_back(fineness, material, skin, tilt_deg)

    def _cylinder_quarter(self, fineness, material, skin):
        shape = sections.cylinder_quarter(fineness)
        self.elements = shape.elements
        points = shape.mesh.points
        self.plate = PlaneContact(points, shape.outer, [0, 0.5], [0, -1], rubber.FRICTION, PLANE)
        # The other half of the bore is the mirror image of this one.
        mirror = PlaneContact(points, shape.bore, [0, 0], [0, 1], 0.0, PLANE)
        held, coat = shape.held_unknowns(), (np.vstack([shape.outer, shape.bore]), skin)
        self.section = Section(shape.mesh, held, [self.plate, mirror], material, skin=coat)
        self.factor = 2.0
        # Two plates come towards each other.
        self.start, self.share = 0.5, 0.5

    def _on_its_back(self, fineness, material, skin, tilt_deg):
        if self.name == "cylinder":
            shape = sections.cylinder_whole(fineness)
        elif self.name == "solid_d":
            shape = sections.solid_d(fineness, self.whole)
        else:
            shape = sections.hollow_d(fineness, self.whole)
        self.elements = shape.elements
        points = shape.mesh.points
        tilt = np.radians(tilt_deg)
        normal = np.array([np.sin(tilt), -np.cos(tilt)])
        # Position of the plate's middle at the first touch.
        reach = ((points[shape.outer.ravel()] - [0, 1]) @ normal).min()
        self.start, self.share = 1 - reach / np.cos(tilt), 1.0
        friction = rubber.FRICTION
        self.plate = PlaneContact(points, shape.outer, [0, self.start], normal, friction, PLANE)
        contacts = [self.plate, PlaneContact(points, shape.outer, [0, 0], [0, 1], friction, PLANE)]
        if self.name == "hollow_d":
            contacts.append(PlaneContact(points, shape.bore, [0, FLOOR], [0, 1], friction, PLANE))
        surfaces = shape.outer
        if len(shape.bore):
            contacts.append(SelfContact(points, shape.bore, SELF))
            surfaces = np.vstack([shape.outer, shape.bore])
        held = shape.held_unknowns()
        coat = (surfaces, skin) if skin else None
        self.section = Section(shape.mesh, held, contacts, material, skin=coat)
        self.factor = 1.0 if shape.whole else 2.0

    def _cone(self, fineness, material, skin):
        shape = sections.cone(fineness)
        self.elements = shape.elements
        points = shape.mesh.points
        both = np.vstack([shape.outer, shape.bore])
        self.plate = PlaneContact(points, both, [1, 0], [-1, 0], rubber.FRICTION, PLANE, True)
        contacts = [self.plate, PlaneContact(points, both, [0, 0], [1, 0], rubber.FRICTION, PLANE, True)]
        contacts += [SelfContact(points, edges, SELF, axisymmetric=True) for edges in (shape.outer, shape.bore)]
        held = shape.held_unknowns()
        self.section = Section(shape.mesh, held, contacts, material, axisymmetric=True, skin=(both, skin))
        self.panel = shape.panel
        self.panel_unknowns = np.isin(held, 2 * shape.panel)
        self.factor, self.start, self.share = 1.0, 1.0, 1.0

    def place(self, section, deflection):
        axis = 0 if self.name == "cone" else 1
        self.plate.place[axis] = self.start - self.share * deflection
        if self.name == "cone":
            section.moved[self.panel_unknowns] = -deflection

    def forces(self):
        """Reaction, lateral force (to the right, on the plate) and moment about the plate's middle."""
        force, moment = self.plate.force_on_plane(self.section.displacements())
        if self.name == "cone":
            residual, _ = self.section.residual()
            return force[0] - residual[2 * self.panel].sum(), 0.0, 0.0
        if self.factor == 2.0:
            return 2.0 * force[1], 0.0, 0.0
        return force[1], force[0], moment

    def through(self, deflections):
        """Rows of deflection, reaction, lateral force and moment; the first row is the present deflection."""
        return follow(self.section, self.place, deflections, lambda s, d: (d, *self.forces()))


def steps(start, end):
    return np.linspace(start, end, round(abs(end - start) / STEP) + 1)


def load(name, fineness, to=None, **how):
    """One compression: rows from zero deflection on, elements, seconds."""
    began = time.process_time()
    pressed = Pressed(name, fineness, **how)
    rows = pressed.through(steps(0.0, FARTHEST[name] if to is None else to))
    return [(0.0, 0.0, 0.0, 0.0), *rows], pressed.elements, time.process_time() - began


def energy(rows):
    """Work from the first row on, by the trapezoidal rule."""
    d = np.array([row[0] for row in rows])
    r = np.array([row[1] for row in rows])
    return np.concatenate([[0.0], np.cumsum(np.diff(d) * (r[1:] + r[:-1]) / 2)])
