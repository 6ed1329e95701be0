"""A section of rubber under rigid planes: equilibrium by Newton's method, in steps as small as it needs."""

from dataclasses import dataclass

import felupe as fem
import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import splu

from .skin import stiffness


# Largest residual force on free nodes after all corrections, as a share of the largest force on a plane.
LEFT_BY_CHATTER = 1e-3


class NoEquilibrium(Exception):
    """Newton's method finds no equilibrium, however small the step."""


@dataclass
class Material:
    """Rubber in units of its shear modulus: neo-Hooke, nearly incompressible."""

    shear_modulus: float = 1.0
    bulk_over_shear: float = 1000.0

    def law(self):
        law = fem.NeoHooke(mu=self.shear_modulus)
        return fem.NearlyIncompressible(law, bulk=self.bulk_over_shear * self.shear_modulus)


class Section:
    """A mesh of nine-node quadrilaterals with continuous pressure and volume ratio on their corners (Taylor and
    Hood's element in the three-field form), its supports and the planes that compress it."""

    def __init__(self, mesh, held, contacts, material, axisymmetric=False, skin=None):
        region = fem.RegionBiQuadraticQuad(mesh)
        kind = {"axisymmetric": True} if axisymmetric else {"planestrain": True}
        self.field = fem.FieldsMixed(region, n=3, disconnect=False, **kind)
        self.solid = fem.SolidBody(material.law(), self.field)
        self.contacts = contacts
        self.held = np.asarray(held)
        self.points = mesh.npoints
        self.size = sum(f.values.size for f in self.field.fields)
        self.free = np.setdiff1d(np.arange(self.size), self.held)
        self.moved = np.zeros(len(self.held))
        self.iterations = 0
        self.skin = csr_matrix((self.size, self.size))
        if skin is not None:
            edges, bending = skin
            self.skin = stiffness(mesh.points, edges, bending, self.size)

    def unknowns(self):
        return np.concatenate([f.values.ravel() for f in self.field.fields])

    def set_unknowns(self, values):
        at = 0
        for f in self.field.fields:
            f.values[:] = values[at : at + f.values.size].reshape(f.values.shape)
            at += f.values.size

    def displacements(self):
        return self.field[0].values

    def residual(self):
        """Residual of all unknowns, and the matrices of the contacts."""
        with np.errstate(invalid="ignore"):
            total = self.solid.assemble.vector(self.field).toarray().ravel()
        total = total + self.skin @ self.unknowns()
        parts = [c.assemble(self.displacements(), self.size) for c in self.contacts]
        for part, _ in parts:
            total = total + part
        return total, [m for _, m in parts]

    def solve(self, tolerance=1e-5, most=30):
        """Equilibrium with the planes and the held nodes at their present positions."""
        start = self.unknowns()
        values = start.copy()
        # Held nodes move along with the first correction, as a linear prediction.
        step_held = self.moved - start[self.held]
        residual, contact_matrices = self.residual()
        scale = None
        for iteration in range(most):
            matrix = self.solid.assemble.matrix(self.field) + self.skin
            for m in contact_matrices:
                matrix = matrix + m
            matrix = csr_matrix(matrix)
            right = -residual[self.free]
            if np.any(step_held):
                right = right - matrix[self.free][:, self.held] @ step_held
            try:
                change = splu(matrix[self.free][:, self.free].tocsc()).solve(right)
            except RuntimeError as error:
                raise NoEquilibrium(str(error)) from None
            if not np.all(np.isfinite(change)):
                raise NoEquilibrium("a correction that is not finite")
            values[self.free] += change if iteration < 8 else 0.6 * change
            values[self.held] += step_held
            step_held = np.zeros(len(self.held))
            self.set_unknowns(values)
            residual, contact_matrices = self.residual()
            self.iterations += 1
            if not np.all(np.isfinite(residual)):
                raise NoEquilibrium("an element turned inside out")
            norm = np.linalg.norm(residual[self.free])
            scale = max(
                1e-3,
                np.linalg.norm(residual[self.held]),
                *[np.linalg.norm(c.force_on_plane(self.displacements())[0]) for c in self.contacts if hasattr(c, "force_on_plane")],
            )
            if norm < tolerance * scale:
                return
        # Points that alternate between contact and no contact leave a residual that no correction removes.
        if norm < LEFT_BY_CHATTER * scale:
            return
        raise NoEquilibrium(f"{norm / scale:.1e} after {most} iterations")

    def accept(self):
        for c in self.contacts:
            c.accept()
        self.solid.results.update_statevars()


def follow(section, place, targets, record, smallest=1 / 256):
    """Solves for each target (a number that `place(section, number)` turns into positions of planes and held nodes) and
    collects the results of `record(section, number)`. A step that fails is halved."""
    rows = []
    now = targets[0]
    for target in targets[1:]:
        share, whole = 0.0, 1.0
        begin = now
        while share < 1.0:
            ahead = min(1.0, share + whole)
            before = section.unknowns()
            number = begin + (target - begin) * ahead
            place(section, number)
            try:
                section.solve()
            except NoEquilibrium as error:
                section.set_unknowns(before)
                whole /= 2
                if whole < smallest:
                    raise NoEquilibrium(f"at {number:.4f}: {error}") from None
                continue
            section.accept()
            share = ahead
        now = target
        rows.append(record(section, target))
    return rows
