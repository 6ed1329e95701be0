"""Contact of a surface with itself, when a bore closes: no friction, pressure by penalty."""

import numpy as np
from scipy.sparse import coo_matrix

from .plane_contact import SHAPE, SLOPE, WEIGHTS, soft_start


class SelfContact:
    """Gauss points along the edges of a surface against the straight pieces between its nodes.

    A point touches only pieces that are farther than `apart` along the undeformed surface, and only if it penetrates
    them by less than `deepest`.
    """

    def __init__(self, points, edges, penalty, apart=0.12, deepest=0.05, axisymmetric=False):
        self.edges = np.asarray(edges)
        self.reference_points = points
        self.reference = points[self.edges]
        self.penalty = penalty
        self.apart, self.deepest = apart, deepest
        tangent = np.einsum("ap,ead->epd", SLOPE, self.reference)
        self.weight = np.linalg.norm(tangent, axis=2) * WEIGHTS
        if axisymmetric:
            radius = np.einsum("ap,ea->ep", SHAPE, self.reference[:, :, 1])
            self.weight = self.weight * 2 * np.pi * radius
        self.pieces = np.vstack([self.edges[:, :2], self.edges[:, 1:]])
        here = np.einsum("ap,ead->epd", SHAPE, self.reference)
        middle = points[self.pieces].mean(axis=1)
        # The straight distance: no surface here is near itself when undeformed.
        distance = np.linalg.norm(here[:, :, None] - middle[None, None], axis=3)
        self.may_meet = distance > apart

    def assemble(self, displacements, size):
        at = np.einsum("ap,ead->epd", SHAPE, self.reference + displacements[self.edges])
        ends = self.reference_points[self.pieces] + displacements[self.pieces]
        along = ends[:, 1] - ends[:, 0]
        length = np.linalg.norm(along, axis=1)
        along = along / length[:, None]
        # Edges run with the rubber on their left: the right side is free.
        normal = np.stack([along[:, 1], -along[:, 0]], axis=1)
        offset = at[:, :, None] - ends[None, None, :, 0]
        gap = np.einsum("epsd,sd->eps", offset, normal)
        share = np.einsum("epsd,sd->eps", offset, along) / length
        meets = self.may_meet & (gap < 0) & (gap > -self.deepest) & (share >= 0) & (share < 1)
        edge, point, piece = np.nonzero(meets)
        residual = np.zeros(size)
        if not len(edge):
            return residual, coo_matrix((size, size)).tocsr()
        n, xi = normal[piece], share[edge, point, piece]
        factors = np.concatenate([SHAPE[:, point].T, -(1 - xi)[:, None], -xi[:, None]], axis=1)
        vector = (factors[:, :, None] * n[:, None, :]).reshape(len(edge), -1)
        nodes = np.concatenate([self.edges[edge], self.pieces[piece]], axis=1)
        unknowns = (2 * nodes[:, :, None] + np.arange(2)).reshape(len(edge), -1)
        pressure, rise = soft_start(gap[edge, point, piece], self.penalty)
        force = -(self.weight[edge, point] * pressure)[:, None] * vector
        strength = self.weight[edge, point] * rise
        np.add.at(residual, unknowns.ravel(), force.ravel())
        matrix = strength[:, None, None] * vector[:, :, None] * vector[:, None, :]
        rows = np.repeat(unknowns, unknowns.shape[1], axis=1).ravel()
        columns = np.tile(unknowns, (1, unknowns.shape[1])).ravel()
        return residual, coo_matrix((matrix.ravel(), (rows, columns)), shape=(size, size)).tocsr()

    def accept(self):
        pass
