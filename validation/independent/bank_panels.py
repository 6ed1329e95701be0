"""The suction of a wall on a ship who goes along it, by panels in potential flow without waves.

    python3 validation/independent/bank_panels.py [ALONG ACROSS DOWN]

The kinetic energy of the water is ½ A U² with A her added mass in surge, which depends on the distance of the wall from her centre line.
By Lagrange's equations the wall pulls with ½ U² |dA/dy| (Lamb, Hydrodynamics, chapter VI). Surface, wall and bottom are mirrors: sources
on the hull have images in all of them. The hull has vertical sides and parabolic waterlines, so that her sectional areas are the parabola
of the slender-body integrals, which are printed beside, as Norrbin's formulas are: Y / (ρ U² S² / L²), S the midship area.

The numbers of validation/banks.toml are from here, by 28 6 5 panels along, across and down. It needs numpy.
"""

import sys

import numpy as np

LENGTH, BEAM, DRAUGHT = 200.0, 30.0, 10.0
AREA = BEAM * DRAUGHT
UNIT = AREA**2 / LENGTH**2
# Parts of a panel each way as point sources, and images below the bottom that are summed one by one.
PARTS, IMAGES = 4, 8


def hull(nx, ny, nz):
    """The panels' corners, her centre line at y = 0."""
    x = 0.5 * LENGTH * np.sin(np.linspace(-np.pi / 2, np.pi / 2, nx + 1))
    half = 0.5 * BEAM * (1 - (2 * x / LENGTH) ** 2)
    z = -DRAUGHT * np.sin(np.linspace(0, np.pi / 2, nz + 1))
    across = np.sin(np.linspace(-np.pi / 2, np.pi / 2, ny + 1))
    panels = []
    for i in range(nx):
        for k in range(nz):
            for s in (1, -1):
                panels.append([(x[i], s * half[i], z[k]), (x[i], s * half[i], z[k + 1]), (x[i + 1], s * half[i + 1], z[k + 1]), (x[i + 1], s * half[i + 1], z[k])])
        for j in range(ny):
            a, b = across[j], across[j + 1]
            panels.append([(x[i], half[i] * a, -DRAUGHT), (x[i], half[i] * b, -DRAUGHT), (x[i + 1], half[i + 1] * b, -DRAUGHT), (x[i + 1], half[i + 1] * a, -DRAUGHT)])
    return np.array(panels)


class Panels:
    """Middles, areas and normals of panels, and their parts as point sources."""

    def __init__(self, corners):
        t = (np.arange(PARTS) + 0.5) / PARTS
        u, v = (grid.ravel() for grid in np.meshgrid(t, t))
        weights = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v])
        self.parts = np.einsum("kp,nkd->npd", weights, corners)
        along = corners[:, 2] + corners[:, 1] - corners[:, 0] - corners[:, 3]
        down = corners[:, 2] + corners[:, 3] - corners[:, 0] - corners[:, 1]
        cross = np.cross(0.5 * along, 0.5 * down)
        self.areas = np.linalg.norm(cross, axis=1)
        self.middles = corners.mean(axis=1)
        self.normals = cross / self.areas[:, None]
        inwards = np.einsum("ij,ij->i", self.normals, self.middles - [0, 0, -DRAUGHT / 2]) < 0
        self.normals[inwards] *= -1
        # The integral of 1/r over a rectangle from its middle.
        a, b = 0.5 * np.linalg.norm(along, axis=1), 0.5 * np.linalg.norm(down, axis=1)
        self.own = 2 * (a * np.arcsinh(b / a) + b * np.arcsinh(a / b))


def surge_added_mass(panels, wall, depth):
    """Over the density, of the hull alone; `wall` is the distance of the wall from the centre line."""
    n = len(panels.areas)
    potential, flow = np.zeros((n, n)), np.zeros((n, n))
    shifts = [0.0] if np.isinf(depth) else [2 * depth * k for k in range(-IMAGES, IMAGES + 1)]
    for side in (1, -1):
        for up in (1, -1):
            for p in range(PARTS * PARTS):
                source = panels.parts[:, p] * [1, side, up] + [0, 0 if side == 1 else 2 * wall, 0]
                weight = panels.areas / PARTS**2
                d = panels.middles[:, None, :] - source[None, :, :]
                plane2 = d[..., 0] ** 2 + d[..., 1] ** 2
                for shift in shifts:
                    z = d[..., 2] - shift
                    r = np.sqrt(plane2 + z * z)
                    if side == up == 1 and shift == 0.0:
                        np.fill_diagonal(r, np.inf)
                    potential += weight / r
                    r3 = weight / r**3
                    flow += r3 * (d[..., 0] * panels.normals[:, None, 0] + d[..., 1] * panels.normals[:, None, 1] + z * panels.normals[:, None, 2])
                if not np.isinf(depth):
                    # Images farther down and up, as an integral; a constant is left out of the potential.
                    a, last = 2 * depth, IMAGES + 0.5
                    far = np.sqrt(plane2 + (a * last) ** 2)
                    potential -= 2 * weight / a * np.log(0.5 * (1 + far / (a * last)))
                    tail = 2 * weight / (a * plane2 + 1e-12) * (1 - a * last / far)
                    flow += tail * (d[..., 0] * panels.normals[:, None, 0] + d[..., 1] * panels.normals[:, None, 1])
    np.fill_diagonal(potential, potential.diagonal() + panels.own)
    np.fill_diagonal(flow, flow.diagonal() + 2 * np.pi)
    sources = np.linalg.solve(flow, panels.normals[:, 0])
    return (potential @ sources * panels.normals[:, 0] * panels.areas).sum()


def slender(wall, depth):
    """(y/π) ∬ S'S' Σ 1/r³ over S²/L², the sum over images below the bottom, by Gauss's rule."""
    points, weights = np.polynomial.legendre.leggauss(96)
    x, w = 0.5 * LENGTH * points, 0.5 * LENGTH * weights
    slope = -8 * AREA * x / LENGTH**2
    apart2 = (x[:, None] - x[None, :]) ** 2 + (2 * wall) ** 2
    kernel = apart2**-1.5
    if not np.isinf(depth):
        for k in range(1, 2001):
            kernel += 2 * (apart2 + (2 * depth * k) ** 2) ** -1.5
    return wall / np.pi * (w * slope) @ kernel @ (w * slope) / UNIT


def norrbin(wall, depth):
    """The suction of Norrbin's formulas as the engine has them, recalled, over ρ U² S²/L²."""
    return 0.5 * AREA * BEAM / wall * (0.0925 + 0.372 * (DRAUGHT / depth) ** 2) / UNIT


if __name__ == "__main__":
    panels = Panels(hull(*(int(n) for n in sys.argv[1:4])) if len(sys.argv) > 3 else hull(28, 6, 5))
    print(f"{len(panels.areas)} panels")
    for depth in (np.inf, 20.0, 13.0):
        for wall in (20.0, 30.0, 45.0, 60.0, 90.0):
            step = 0.04 * wall
            masses = [surge_added_mass(panels, wall + k * step, depth) for k in (-1, 1)]
            pull = 0.5 * (masses[0] - masses[1]) / (2 * step) / UNIT
            by_slender = slender(wall, depth)
            print(f"depth {depth:4}, wall {wall}: {pull:.4f} by panels, {by_slender:.4f} slender, ratio {by_slender / pull:.3f}, "
                  f"{norrbin(wall, depth):.3f} by Norrbin's formulas", flush=True)
