"""The shapes: meshes of nine-node quadrilaterals, their supports, and the edges that planes may touch.

All have height 1 in the direction of compression; a fender of height H has H times the reaction per metre of
length and H squared times the energy (the cone, a whole ring: H squared and H cubed).
"""

from dataclasses import dataclass

import felupe as fem
import numpy as np

EDGES = ((0, 4, 1), (1, 5, 2), (2, 6, 3), (3, 7, 0))


def block(mapping, across, along):
    """Nine-node quadrilaterals over the unit square, mapped: `mapping(a, b)` gives x and y."""
    mesh = fem.Rectangle(n=(across + 1, along + 1)).add_midpoints_edges().add_midpoints_faces()
    a, b = mesh.points.T
    mesh.update(points=np.stack(mapping(a, b), axis=1))
    return mesh


def joined(blocks):
    """One mesh from several whose nodes agree at their common edges."""
    return corners_first(fem.mesh.merge_duplicate_points(fem.mesh.concatenate(blocks), decimals=9))


def corners_first(mesh):
    """Numbers the nodes so that corners come first, as FElupe's dual mesh requires."""
    corners = np.unique(mesh.cells[:, :4])
    others = np.setdiff1d(np.unique(mesh.cells), corners)
    order = np.concatenate([corners, others])
    number = np.zeros(mesh.npoints, dtype=int)
    number[order] = np.arange(len(order))
    mesh.update(points=mesh.points[order], cells=number[mesh.cells])
    return mesh


def patch(bottom, right, top, left):
    """Coons' patch between four curves, each a function of 0..1, bottom and top to the right, left and right up."""

    def mapping(a, b):
        corner = [np.array(c)[:, None] for c in (bottom(0.0), bottom(1.0), top(0.0), top(1.0))]
        curves = [np.array(c) for c in (bottom(a), top(a), left(b), right(b))]
        ruled = (1 - b) * curves[0] + b * curves[1] + (1 - a) * curves[2] + a * curves[3]
        flat = (
            (1 - a) * (1 - b) * corner[0]
            + a * (1 - b) * corner[1]
            + (1 - a) * b * corner[2]
            + a * b * corner[3]
        )
        return tuple(ruled - flat)

    return mapping


def line(one, other):
    return lambda s: tuple(one[i] + (other[i] - one[i]) * np.asarray(s, dtype=float) for i in (0, 1))


def arc(centre, radius, start_deg, end_deg):
    def at(s):
        angle = np.radians(start_deg + (end_deg - start_deg) * np.asarray(s, dtype=float))
        return centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle)

    return at


def surface(mesh, chosen):
    """Edges of the boundary (rows of three nodes, middle one second) whose nodes are all among the chosen."""
    edges = np.vstack([mesh.cells[:, edge] for edge in EDGES])
    corners = np.sort(edges[:, [0, 2]], axis=1)
    _, index, count = np.unique(corners, axis=0, return_index=True, return_counts=True)
    boundary = edges[np.sort(index[count == 1])]
    return boundary[chosen[boundary].all(axis=1)]


@dataclass
class Shape:
    """A meshed shape. `held` are the nodes that are bonded to the structure, `middle` those that stay on the
    symmetry line x = 0 (half a shape), `level` those that stay at their y (a quarter)."""

    mesh: object
    held: np.ndarray
    middle: np.ndarray
    level: np.ndarray
    outer: np.ndarray
    bore: np.ndarray
    whole: bool
    # Nodes of the cone that move with the panel.
    panel: np.ndarray | None = None

    @property
    def elements(self):
        return self.mesh.ncells

    def held_unknowns(self):
        return np.unique(
            np.concatenate([2 * self.held, 2 * self.held + 1, 2 * self.middle, 2 * self.level + 1])
        )


def nodes(condition):
    return np.flatnonzero(condition)


NONE = np.array([], dtype=int)


def cylinder_quarter(fineness):
    """A hollow cylinder of outer diameter 1 and bore 0.5 about (0, 0), a quarter of it."""
    mesh = block(
        lambda a, b: (
            (0.25 + 0.25 * a) * np.cos(np.pi / 2 * b),
            (0.25 + 0.25 * a) * np.sin(np.pi / 2 * b),
        ),
        2 * fineness,
        16 * fineness,
    )
    x, y = mesh.points.T
    radius = np.hypot(x, y)
    return Shape(
        mesh,
        held=NONE,
        middle=nodes(np.isclose(x, 0)),
        level=nodes(np.isclose(y, 0)),
        outer=surface(mesh, np.isclose(radius, 0.5)),
        bore=surface(mesh, np.isclose(radius, 0.25)),
        whole=False,
    )


def cylinder_whole(fineness, strip_deg=11.25):
    """The whole cylinder about (0, 0.5), bonded to a bracket on a strip at its back, so that it cannot roll."""
    mesh = block(
        lambda a, b: (
            (0.25 + 0.25 * a) * np.sin(2 * np.pi * b),
            0.5 - (0.25 + 0.25 * a) * np.cos(2 * np.pi * b),
        ),
        2 * fineness,
        64 * fineness,
    )
    mesh = joined([mesh])
    x, y = mesh.points.T
    radius = np.hypot(x, y - 0.5)
    outside = np.isclose(radius, 0.5)
    strip = outside & (y < 0.5) & (np.abs(np.degrees(np.arctan2(x, 0.5 - y))) < strip_deg + 1e-6)
    return Shape(
        mesh,
        held=nodes(strip),
        middle=NONE,
        level=NONE,
        outer=surface(mesh, outside),
        bore=surface(mesh, np.isclose(radius, 0.25)),
        whole=True,
    )


def mirrored(mesh):
    other = mesh.copy()
    points = other.points.copy()
    points[:, 0] = -points[:, 0]
    # In reverse order, so that areas stay positive.
    other.update(points=points, cells=other.cells[:, [1, 0, 3, 2, 4, 7, 6, 5, 8]])
    return joined([mesh, other])


def solid_d(fineness, whole=False):
    """A solid D, 1 wide and 1 high: a rectangle of 1 by 0.5 with half a disc on it, bonded at its back."""
    n = fineness
    o, a, b, c = (0, 0.5), (0.27, 0.5), (0.22, 0.72), (0, 0.77)
    d, e, f = (0.5, 0.5), (0.5 * np.cos(np.pi / 4), 0.5 + 0.5 * np.sin(np.pi / 4)), (0, 1.0)
    disc = ((0, 0.5), 0.5)
    blocks = [
        block(patch(line(o, a), line(a, b), line(c, b), line(o, c)), 2 * n, 2 * n),
        block(patch(line(a, d), arc(*disc, 0, 45), line(b, e), line(a, b)), 2 * n, 2 * n),
        block(patch(line(c, b), line(b, e), arc(*disc, 90, 45), line(c, f)), 2 * n, 2 * n),
        block(patch(line((0, 0), (0.27, 0)), line((0.27, 0), a), line(o, a), line((0, 0), o)), 2 * n, 4 * n),
        block(patch(line((0.27, 0), (0.5, 0)), line((0.5, 0), d), line(a, d), line((0.27, 0), a)), 2 * n, 4 * n),
    ]
    mesh = joined(blocks)
    if whole:
        mesh = mirrored(mesh)
    x, y = mesh.points.T
    outside = np.where(y < 0.5 - 1e-9, np.isclose(np.abs(x), 0.5), np.isclose(np.hypot(x, y - 0.5), 0.5))
    return Shape(
        mesh,
        held=nodes(np.isclose(y, 0)),
        middle=NONE if whole else nodes(np.isclose(x, 0)),
        level=NONE,
        outer=surface(mesh, outside),
        bore=np.zeros((0, 3), dtype=int),
        whole=whole,
    )


def hollow_d(fineness, whole=False):
    """A hollow D as on the bow of a tug: 1 wide, 1 high, wall and floor 0.25; the bore's floor is held down by a
    flat bar and counts as rigid."""
    n = fineness
    leg = block(lambda a, b: (0.25 + 0.25 * a, 0.5 * b), 2 * n, 6 * n)
    bow = block(
        lambda a, b: (
            (0.25 + 0.25 * a) * np.cos(np.pi / 2 * b),
            0.5 + (0.25 + 0.25 * a) * np.sin(np.pi / 2 * b),
        ),
        2 * n,
        10 * n,
    )
    mesh = joined([leg, bow])
    if whole:
        mesh = mirrored(mesh)
    x, y = mesh.points.T
    radius = np.hypot(x, y - 0.5)
    low = y < 0.5 - 1e-9
    outside = np.where(low, np.isclose(np.abs(x), 0.5), np.isclose(radius, 0.5))
    inside = np.where(low, np.isclose(np.abs(x), 0.25), np.isclose(radius, 0.25))
    return Shape(
        mesh,
        held=nodes(np.isclose(y, 0) | (inside & (y < 0.25 + 1e-9))),
        middle=NONE if whole else nodes(np.isclose(x, 0)),
        level=NONE,
        outer=surface(mesh, outside),
        bore=surface(mesh, inside & (y > 0.25 - 1e-9)),
        whole=whole,
    )


def cone(fineness, base_radius=0.72, top_radius=0.42, thickness=0.25, flare=0.05):
    """A cone fender as a ring about its axis: x along the axis, y the radius, as in FElupe. Bonded to the
    quay at x = 0 and to its panel at x = 1. The radii are those of the wall's middle. The dimensions are ours,
    not those of a maker."""
    slope = np.array([1.0, top_radius - base_radius])
    across = np.array([-slope[1], slope[0]]) / np.linalg.norm(slope)
    # Walls end flush with their plates: their radial extent is the thickness over the cosine of the slope.
    extent = thickness / across[1]

    def mapping(a, b):
        middle = base_radius + (top_radius - base_radius) * b
        near = np.clip(np.maximum(b - 0.75, 0.25 - b) / 0.25, 0, 1)
        return b, middle + (extent + 2 * flare * near**3) * (0.5 - a)

    mesh = corners_first(block(mapping, 2 * fineness, 12 * fineness))
    x, y = mesh.points.T
    near = np.clip(np.maximum(x - 0.75, 0.25 - x) / 0.25, 0, 1)
    offset = (y - (base_radius + (top_radius - base_radius) * x)) / (extent + 2 * flare * near**3)
    outer, inner = np.isclose(offset, 0.5), np.isclose(offset, -0.5)
    return Shape(
        mesh,
        held=nodes(np.isclose(x, 0) | np.isclose(x, 1)),
        middle=NONE,
        level=NONE,
        outer=surface(mesh, outer),
        bore=surface(mesh, inner),
        whole=True,
        panel=nodes(np.isclose(x, 1)),
    )
