"""Contact of a rubber surface with a rigid plane: pressure by penalty, friction by Coulomb's law.

The gap is evaluated at Gauss points along the surface's edges, not at its nodes, so that the force grows
smoothly while the contact widens. With nodes the reaction would grow in steps, one for each node that touches.
"""

import numpy as np
from scipy.sparse import coo_matrix

# Points along an edge. More than the edge's quadratic shape needs, as contact may end within it.
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(5)
SHAPE = np.stack([POINTS * (POINTS - 1) / 2, 1 - POINTS**2, POINTS * (POINTS + 1) / 2])
SLOPE = np.stack([POINTS - 0.5, -2 * POINTS, POINTS + 0.5])


# Depth over which the pressure reaches its slope. With a kink points would alternate between contact and no contact.
ONSET = 1e-3


def soft_start(gap, penalty):
    """Pressure and its slope over the depth: first a parabola, then a straight line."""
    depth = np.maximum(-gap, 0.0)
    pressure = np.where(depth < ONSET, depth**2 / (2 * ONSET), depth - ONSET / 2)
    return penalty * pressure, penalty * np.minimum(depth / ONSET, 1.0)


class PlaneContact:
    """Edges of a mesh (rows of three nodes, the middle one second) against a rigid plane.

    `normal` points from the plane into the free space where the rubber is. Forces are per metre of length, or
    of the whole ring where the section is axisymmetric (`x` is along the axis and `y` the radius, as in
    FElupe).
    """

    def __init__(self, points, edges, place, normal, friction, penalty, axisymmetric=False):
        self.edges = np.asarray(edges)
        self.reference = points[self.edges]
        self.place = np.array(place, dtype=float)
        self.normal = np.array(normal, dtype=float)
        self.tangent = np.array([-self.normal[1], self.normal[0]])
        self.friction = friction
        self.penalty = penalty
        along = np.einsum("ap,ead->epd", SLOPE, self.reference)
        self.weight = np.linalg.norm(along, axis=2) * WEIGHTS
        if axisymmetric:
            radius = np.einsum("ap,ea->ep", SHAPE, self.reference[:, :, 1])
            self.weight = self.weight * 2 * np.pi * radius
        # Position of each point along the plane without the spring of friction; it follows when the point slides.
        self.stuck_at = np.full(self.weight.shape, np.nan)
        self.trial = self.stuck_at

    def evaluate(self, displacements):
        """Force on the nodes and its derivative, at these displacements and this position of the plane."""
        at = np.einsum("ap,ead->epd", SHAPE, self.reference + displacements[self.edges])
        at = at - self.place
        gap = at @ self.normal
        slid = at @ self.tangent
        touches = gap < 0.0
        pressure, rise = soft_start(gap, self.penalty)
        # A point that touches for the first time sticks where it touches.
        anchor = np.where(np.isnan(self.stuck_at), slid, self.stuck_at)
        spring = self.penalty * (slid - anchor)
        bound = self.friction * pressure
        slips = np.abs(spring) > bound
        sign = np.sign(spring)
        shear = np.where(slips, sign * bound, spring)
        self.trial = np.where(touches, slid - shear / self.penalty, np.nan)
        self.pressure, self.shear = pressure, shear
        # On the rubber: pressure along the normal, shear against the slip.
        n, t = self.normal, self.tangent
        traction = pressure[..., None] * n - shear[..., None] * t
        force = np.einsum("ep,ap,epd->ead", self.weight, SHAPE, traction)
        nn = rise
        tt = np.where(touches & ~slips & ~np.isnan(self.stuck_at), self.penalty, 0.0)
        tn = np.where(touches & slips, -sign * self.friction * rise, 0.0)
        stiffness = (
            nn[..., None, None] * np.outer(n, n)
            + tt[..., None, None] * np.outer(t, t)
            + tn[..., None, None] * np.outer(t, n)
        )
        matrix = np.einsum("ep,ap,bp,epij->eaibj", self.weight, SHAPE, SHAPE, stiffness)
        return force, matrix

    def assemble(self, displacements, size):
        """The residual (internal less external force) and its matrix, over all unknowns."""
        force, matrix = self.evaluate(displacements)
        dofs = (2 * self.edges[:, :, None] + np.arange(2)).reshape(len(self.edges), -1)
        residual = np.zeros(size)
        np.add.at(residual, dofs.ravel(), -force.ravel())
        rows = np.repeat(dofs, 6, axis=1).ravel()
        columns = np.tile(dofs, (1, 6)).ravel()
        return residual, coo_matrix((matrix.ravel(), (rows, columns)), shape=(size, size)).tocsr()

    def accept(self):
        """Stores where points stick, at the end of a solved step."""
        self.stuck_at = self.trial

    def force_on_plane(self, displacements):
        """The force on the plane, and the moment about its position (counter-clockwise)."""
        at = np.einsum("ap,ead->epd", SHAPE, self.reference + displacements[self.edges])
        traction = -(self.pressure[..., None] * self.normal - self.shear[..., None] * self.tangent)
        each = self.weight[..., None] * traction
        arm = at - self.place
        moment = np.sum(arm[..., 0] * each[..., 1] - arm[..., 1] * each[..., 0])
        return each.sum(axis=(0, 1)), moment
