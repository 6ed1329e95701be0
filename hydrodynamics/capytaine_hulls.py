"""Runs Capytaine for the hulls of this folder, and writes NetCDF that `fenderline.hydrodynamics` converts.

    python3 hydrodynamics/capytaine_hulls.py CASE FOLDER

CASE is a key of `CASES`. It needs capytaine 3.0 and h5netcdf of PyPI. One thread; the run time is printed.

A quay wall is a mirror: the hull and her image behind the wall move as mirror images. The generalised forces of both are
twice those of the hull. The incident wave and its reflection by the wall are in the excitation.
"""

import sys
import time
from pathlib import Path

import capytaine as cpt
import numpy as np

cpt.set_logging("ERROR")

DOFS = ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]
# The sign of each motion of the image: surge, heave and pitch are as those of the hull, the others opposite.
IMAGE = [1, -1, 1, -1, 1, -1]
WATER_KGPM3 = 1025.0


def box(length, beam, draught, counts):
    """A box: `counts` panels along, across and down."""
    nx, ny, nz = counts

    def spread(a, b, n):  # closer at the edges
        return a + (b - a) * 0.5 * (1 - np.cos(np.linspace(0, np.pi, n + 1)))

    x, y = spread(-length / 2, length / 2, nx), spread(-beam / 2, beam / 2, ny)
    z = -draught * np.sin(np.linspace(0, np.pi / 2, nz + 1))
    panels = []
    for i in range(nx):
        for j in range(ny):
            panels.append([(x[i], y[j], -draught), (x[i], y[j + 1], -draught), (x[i + 1], y[j + 1], -draught), (x[i + 1], y[j], -draught)])
        for k in range(nz):
            for side in (1, -1):
                p = [(x[i], side * beam / 2, z[k]), (x[i + 1], side * beam / 2, z[k]), (x[i + 1], side * beam / 2, z[k + 1]), (x[i], side * beam / 2, z[k + 1])]
                panels.append(p if side == -1 else p[::-1])
    for j in range(ny):
        for k in range(nz):
            for end in (1, -1):
                p = [(end * length / 2, y[j], z[k]), (end * length / 2, y[j + 1], z[k]), (end * length / 2, y[j + 1], z[k + 1]), (end * length / 2, y[j], z[k + 1])]
                panels.append(p if end == 1 else p[::-1])
    return panels


def ship(length, beam, draught, block, waterplane, counts):
    """A hull from main particulars, alike fore and aft: the waterline is B/2 (1 - |2x/L|^n), a section a superellipse; the two
    exponents follow from the coefficients of block and waterplane."""
    from scipy.optimize import brentq
    from scipy.special import gamma

    nx, ng = counts
    n = waterplane / (1 - waterplane)
    area = lambda m: gamma(1 + 1 / m) ** 2 / gamma(1 + 2 / m)
    m = brentq(lambda m: area(m) - block / waterplane, 1.0, 50.0)
    x = 0.5 * length * np.sin(np.linspace(-np.pi / 2, np.pi / 2, nx + 1))
    t = np.linspace(0, np.pi / 2, ng + 1)
    half = 0.5 * beam * (1 - np.abs(2 * x / length) ** n)
    y = np.outer(half, np.cos(t) ** (2 / m))
    z = np.outer(np.ones(nx + 1), -draught * np.sin(t) ** (2 / m))
    panels = []
    for i in range(nx):
        for k in range(ng):
            p = [(x[a], y[a, b], z[a, b]) for a, b in ((i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1))]
            panels.append(p[::-1])
            panels.append([(x, -y, z) for x, y, z in p])
    return panels


def mesh_of(panels, name):
    panels = np.round(np.array(panels, dtype=float), 6)
    # Both hulls are convex: a normal points away from the middle.
    across = np.cross(panels[:, 2] - panels[:, 0], panels[:, 3] - panels[:, 1])
    inwards = np.einsum("ij,ij->i", across, panels.mean(axis=1) - [0, 0, panels[:, :, 2].min() / 2]) < 0
    panels[inwards] = panels[inwards, ::-1]
    vertices, index = np.unique(panels.reshape(-1, 3), axis=0, return_inverse=True)
    return cpt.Mesh(vertices=vertices, faces=index.reshape(-1, 4), name=name)


BARGE = {"length": 80.0, "beam": 20.0, "draught": 5.0}
BARGE_HULL = lambda: box(80.0, 20.0, 5.0, (24, 10, 6))
# The paper's container ship: vessels/moreno2023.toml.
SHIP = {"length": 285.0, "beam": 46.0, "draught": 9.0}
SHIP_HULL = lambda: ship(285.0, 46.0, 9.0, SHIP_BLOCK, SHIP_WATERPLANE, (36, 9))
SHIP_BLOCK, SHIP_WATERPLANE = 0.7260, 0.8095
BARGE_OMEGAS = np.concatenate([np.arange(0.1, 0.61, 0.05), np.arange(0.7, 2.41, 0.1)])
SHIP_OMEGAS = np.concatenate([np.arange(0.15, 1.01, 0.05), np.arange(1.1, 2.01, 0.1)])
HALF = np.radians(np.arange(0, 181, 30))
SEAWARD = np.radians(np.arange(0, 181, 30))

CASES = {
    "barge_20m": dict(hull=BARGE_HULL, size=BARGE, depth=20.0, above_keel=5.0, omegas=BARGE_OMEGAS, headings=HALF, wall=None),
    "barge_10m": dict(hull=BARGE_HULL, size=BARGE, depth=10.0, above_keel=5.0, omegas=BARGE_OMEGAS, headings=HALF, wall=None),
    "barge_20m_quay": dict(hull=BARGE_HULL, size=BARGE, depth=20.0, above_keel=5.0, omegas=BARGE_OMEGAS, headings=SEAWARD, wall=16.0),
    "ship_20m": dict(hull=SHIP_HULL, size=SHIP, depth=20.0, above_keel=None, omegas=SHIP_OMEGAS, headings=HALF, wall=None),
    "ship_15m": dict(hull=SHIP_HULL, size=SHIP, depth=15.0, above_keel=None, omegas=SHIP_OMEGAS, headings=HALF, wall=None),
    "ship_15m_quay": dict(hull=SHIP_HULL, size=SHIP, depth=15.0, above_keel=None, omegas=SHIP_OMEGAS, headings=SEAWARD, wall=27.0),
}
# The height of the centre of gravity that gives this hull the metacentric height of the vessel data, 2 m.
SHIP_ABOVE_KEEL_M = 20.8


def run(name, folder):
    case = CASES[name]
    above_keel_m = case["above_keel"] or SHIP_ABOVE_KEEL_M
    centre = (0.0, 0.0, above_keel_m - case["size"]["draught"])
    mesh = mesh_of(case["hull"](), name)
    lid = mesh.generate_lid()
    body = cpt.FloatingBody(mesh=mesh, lid_mesh=lid, dofs=cpt.rigid_body_dofs(rotation_center=centre), center_of_mass=centre, name=name)
    volume = body.disp_mass(rho=WATER_KGPM3) / WATER_KGPM3
    stiffness = body.compute_hydrostatic_stiffness(rho=WATER_KGPM3)
    print(name, "panels", mesh.nb_faces, "lid", lid.nb_faces, "volume", volume, "KG", above_keel_m, "GM", float(stiffness.sel(influenced_dof="Roll", radiating_dof="Roll")) / (WATER_KGPM3 * 9.81 * volume))
    factor = 1.0
    if case["wall"] is not None:
        # The wall is at y = -wall (Capytaine's y is to port), to starboard of the hull.
        y_wall = -case["wall"]
        image = mesh.mirrored("xOz").translated_y(2 * y_wall)
        image_lid = lid.mirrored("xOz").translated_y(2 * y_wall)
        own = cpt.rigid_body_dofs(rotation_center=centre)
        whole = mesh.join_meshes(image) if hasattr(mesh, "join_meshes") else mesh + image
        whole_lid = lid.join_meshes(image_lid) if hasattr(lid, "join_meshes") else lid + image_lid
        arm = lambda centres, c: centres - np.array(c)
        dofs = {}
        for index, dof in enumerate(DOFS):
            fields = []
            for part, place, is_image in ((mesh, centre, False), (image, (0, 2 * y_wall, centre[2]), True)):
                r = arm(part.faces_centers, place)
                zero = np.zeros(len(r))
                field = [
                    lambda r: np.stack([zero + 1, zero, zero], 1), lambda r: np.stack([zero, zero + 1, zero], 1),
                    lambda r: np.stack([zero, zero, zero + 1], 1), lambda r: np.stack([zero, -r[:, 2], r[:, 1]], 1),
                    lambda r: np.stack([r[:, 2], zero, -r[:, 0]], 1), lambda r: np.stack([-r[:, 1], r[:, 0], zero], 1),
                ][index](r)
                fields.append(IMAGE[index] * field if is_image else field)
            dofs[dof] = np.concatenate(fields)
        body = cpt.FloatingBody(mesh=whole, lid_mesh=whole_lid, dofs=dofs, name=name)
        factor = 0.5
    began = time.process_time()
    solver = cpt.BEMSolver()
    problems = [cpt.RadiationProblem(body=body, radiating_dof=dof, omega=omega, water_depth=case["depth"], rho=WATER_KGPM3) for dof in DOFS for omega in [*case["omegas"], np.inf]]
    problems += [cpt.DiffractionProblem(body=body, wave_direction=heading, omega=omega, water_depth=case["depth"], rho=WATER_KGPM3) for heading in case["headings"] for omega in case["omegas"]]
    results = solver.solve_all(problems, progress_bar=False)
    data = cpt.assemble_dataset(results, hydrostatics=False)
    seconds = time.process_time() - began
    for key in ["added_mass", "radiation_damping"]:
        data[key] = factor * data[key]
    # The force of the incident wave and its reflection on the hull alone is the generalised force of both halves in one wave.
    if "excitation_force" not in data:
        data["excitation_force"] = data["Froude_Krylov_force"] + data["diffraction_force"]
    data = data[["added_mass", "radiation_damping", "excitation_force"]]
    data["hydrostatic_stiffness"] = stiffness
    data.attrs.update(
        volume_m3=volume, centre_above_waterline_m=centre[2], processor_s=round(seconds), panels=mesh.nb_faces,
        note="hull and image at a wall" if case["wall"] else "open water",
    )
    path = Path(folder) / f"{name}.nc"
    cpt.export_dataset(path, data, format="netcdf") if hasattr(cpt, "export_dataset") else data.to_netcdf(path)
    print(name, "processor time", round(seconds), "s", path, path.stat().st_size)


if __name__ == "__main__":
    run(*sys.argv[1:3])
