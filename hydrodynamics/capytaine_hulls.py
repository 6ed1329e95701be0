"""Runs Capytaine for the hulls of this folder, and writes their hydrodynamic data.

    python3 hydrodynamics/capytaine_hulls.py CASE FOLDER [--half-steps]

CASE is a key of `CASES`, or `all`; with `--half-steps` its frequencies and headings are twice as close. It needs capytaine 3.0, h5netcdf
and h5py of PyPI. FOLDER gets CASE.nc, Capytaine's results, and CASE.hydro, what `fenderline.hydrodynamics` makes of them. One thread; the run time is printed.

A quay wall is a mirror: the hull and her image behind the wall move as mirror images. The generalised forces of both are
twice those of the hull. The incident wave and its reflection by the wall are in the excitation. The wall is to starboard, and
infinitely long, down to the bottom.

Mean drift is by the momentum far away (Kochin functions), of the ship who floats freely with 5 % of the critical damping in roll.
At a wall the momentum far away is that of hull and wall, so there is none.
"""

import importlib
import sys
import time
import types
from pathlib import Path

import capytaine as cpt
import numpy as np
import xarray as xr

cpt.set_logging("ERROR")

ROOT = Path(__file__).resolve().parent.parent

DOFS = ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]
# The sign of each motion of the image: surge, heave and pitch are as those of the hull, the others opposite.
IMAGE = [1, -1, 1, -1, 1, -1]
WATER_KGPM3 = 1025.0


class ShallowWater(cpt.Delhommeau):
    """Capytaine's Green function with a closer fit of its part for a finite depth.

    Capytaine fits that part with three to five exponentials to a root mean square of 0.01, at points that are drawn anew in each run. The
    number changes from one frequency to the next: the damping in heave of the ship in 20 m of water jumps by 9 % between 0.725 and
    0.75 rad/s. Here the exponentials are the same at all frequencies, fitted by least squares: within 5e-5 of the largest value from kh = 0.3
    on, and within 0.7 % at kh = 0.1. Haskind's relation in heave then holds within 2 % throughout.
    """

    RATES = -np.geomspace(0.1, 14.0, 14)

    def find_best_exponential_decomposition(self, dimensionless_wavenumber, *, method=None):
        kh = dimensionless_wavenumber
        x = np.concatenate([np.linspace(0, 3, 600), np.linspace(3, 20, 400)[1:]])
        if kh < 1e5:
            x = x[np.abs(x - kh) > 1e-4]  # where both parts of the difference are infinite
            t, even = np.tanh(kh), np.exp(-2 * x)
            singular = (1 + t) ** 2 / (1 - t**2 + t / kh) / (x - kh)
            wanted = (x + kh * t) / (0.5 * x * (1 - even) - 0.5 * kh * t * (1 + even)) - singular - 2
        else:
            wanted = 2 - 2 / (1 + np.exp(-2 * x))
        amplitudes, *_ = np.linalg.lstsq(np.exp(np.outer(x, self.RATES)), wanted, rcond=1e-11)
        return np.stack([self.RATES, amplitudes])


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
            # Capytaine splits a panel between its first and third corner: alike on both sides, and fore and aft.
            p = p if 2 * i < nx else p[1:] + p[:1]
            panels.append(p)
            panels.append([(x, -y, z) for x, y, z in p])
    return panels


def mesh_of(panels, name):
    panels = np.round(np.array(panels, dtype=float), 6)
    # Both hulls are convex: a normal points away from the middle.
    across = np.cross(panels[:, 2] - panels[:, 0], panels[:, 3] - panels[:, 1])
    inwards = np.einsum("ij,ij->i", across, panels.mean(axis=1) - [0, 0, panels[:, :, 2].min() / 2]) < 0
    panels[inwards] = panels[inwards][:, [0, 3, 2, 1]]  # the first and the third corner stay
    vertices, index = np.unique(panels.reshape(-1, 3), axis=0, return_inverse=True)
    return cpt.Mesh(vertices=vertices, faces=index.reshape(-1, 4), name=name)


ROLL_DAMPING = 0.05
GRAVITY_MPS2 = 9.81
BARGE = {"length": 80.0, "beam": 20.0, "draught": 5.0, "above_keel": 5.0, "gyradii": (7.0, 20.0, 20.0), "name": "A box barge"}
BARGE_HULL = lambda: box(80.0, 20.0, 5.0, (24, 10, 6))
SHIP_BLOCK, SHIP_WATERPLANE = 0.7260, 0.8095
# The paper's container ship: vessels/moreno2023.toml. The height of the centre of gravity gives this hull the metacentric height of
# the vessel data, 2 m.
SHIP = {
    "length": 285.0, "beam": 46.0, "draught": 9.0, "above_keel": 20.8, "gyradii": (18.0, 71.25, 71.25),
    "name": "A hull from the main particulars of the paper's container ship",
}
SHIP_HULL = lambda: ship(285.0, 46.0, 9.0, SHIP_BLOCK, SHIP_WATERPLANE, (36, 9))


def steps(*parts):
    """Frequencies or headings: from the first number in steps of the second, up to and with the start of the next part."""
    axis = [np.arange(first, after - 0.5 * step, step) for (first, step), (after, _) in zip(parts, parts[1:])]
    return np.round(np.concatenate([*axis, [parts[-1][0]]]), 6)


# A wave of number k turns its phase along a ship of length L by kLΔμ from one heading to the next, and by LΔk from one frequency to the next.
# These are at most 4 and 2.5 up to 1.25 rad/s for the ship and 2 rad/s for the barge, beyond which they hardly move.
BARGE_OMEGAS = steps((0.1, 0.05), (2.0, 0.1), (2.4, None))
SHIP_OMEGAS = steps((0.15, 0.025), (1.25, 0.05), (1.3, 0.1), (2.0, None))
HALF = {"barge": np.radians(np.arange(0, 181, 6)), "ship": np.radians(np.arange(0, 181, 5))}
# At a wall the two sides differ.
ROUND = np.radians(np.arange(-174, 181, 6))
# Hull and image are twice as many panels.
COARSE_SHIP = lambda: ship(285.0, 46.0, 9.0, SHIP_BLOCK, SHIP_WATERPLANE, (28, 7))


def barge(depth, wall=None, **of):
    headings = HALF["barge"] if wall is None else ROUND
    return {"hull": BARGE_HULL, "size": BARGE, "omegas": BARGE_OMEGAS, "depth": depth, "wall": wall, "headings": headings} | of


def container_ship(depth, wall=None, **of):
    headings = HALF["ship"] if wall is None else ROUND
    return {"hull": SHIP_HULL, "size": SHIP, "omegas": SHIP_OMEGAS, "depth": depth, "wall": wall, "headings": headings} | of


# The water in the gap between hull and wall resonates, the barge's near 0.8 rad/s in 20 m of water and 0.6 in 10 m, her yaw's higher:
# frequencies are closer there. Beyond 2.2 rad/s waves stand in the gap, which these panels do not resolve: the damping would be
# negative. The ship's gap is narrower and her panels are longer: there they resolve waves up to 1.2 rad/s.
BARGE_AT = steps((0.1, 0.05), (0.6, 0.025), (1.0, 0.05), (1.6, 0.1), (2.2, None))
SHIP_AT = steps((0.15, 0.05), (0.4, 0.025), (0.9, 0.05), (1.2, None))
# Added mass and damping have half these steps and less: the water's memory needs them closer than the waves' forces do.
BARGE_RADIATION_AT = steps((0.1, 0.025), (0.4, 0.0125), (1.1, 0.025), (1.6, 0.05), (2.2, None))
SHIP_RADIATION_AT = steps((0.1, 0.025), (0.4, 0.0125), (0.9, 0.025), (1.2, None))
# Depth, and the distance of the wall from the centre line (m).
CASES = {
    "barge_20m": barge(20.0),
    "barge_10m": barge(10.0),
    "barge_20m_quay": barge(20.0, 16.0, omegas=BARGE_AT, radiation=BARGE_RADIATION_AT),
    "barge_10m_quay": barge(10.0, 16.0, omegas=BARGE_AT, radiation=BARGE_RADIATION_AT),
    "ship_20m": container_ship(20.0),
    "ship_15m": container_ship(15.0),
    "ship_20m_quay": container_ship(20.0, 27.0, hull=COARSE_SHIP, omegas=SHIP_AT, radiation=SHIP_RADIATION_AT),
    "ship_15m_quay": container_ship(15.0, 27.0, hull=COARSE_SHIP, omegas=SHIP_AT, radiation=SHIP_RADIATION_AT),
}


def symmetric(mesh, lid, wall):
    """Hull and lid as a quarter and its images, which take a quarter of the time: fore and aft, and to both sides. At a wall, which is then at
    y = 0, the second image is that of the whole hull."""
    halves = []
    # Panels of the lid lie across the middle lines, those of the hull do not.
    lid = lid.clipped(normal=(-1, 0, 0), origin=(0, 0, 0))
    lid = lid.clipped(normal=(0, -1, 0), origin=(0, 0, 0)) if wall is None else lid
    x, y, _ = mesh.faces_centers.T
    kept = (x > 0) & ((y > 0) | (wall is not None))
    for part in (mesh.extract_faces(np.flatnonzero(kept)), lid):
        part = part if wall is None else part.translated_y(wall)
        halves.append(cpt.ReflectionSymmetricMesh(half=cpt.ReflectionSymmetricMesh(half=part, plane="yOz"), plane="xOz"))
    return halves


def at_wall(mesh, lid, height, wall):
    """Hull and image as one body. Capytaine's y is to port, so the hull is at a positive one from the wall."""
    dofs = {}
    for index, dof in enumerate(DOFS):
        fields = []
        for part, y, sign in ((mesh.half, wall, 1), (mesh.other_half, -wall, IMAGE[index])):
            r = part.faces_centers - np.array((0, y, height))
            axis = np.eye(3)[index % 3]
            field = np.tile(axis, (len(r), 1)) if index < 3 else np.cross(axis, r)
            fields.append(sign * field)
        dofs[dof] = np.concatenate(fields)
    return cpt.FloatingBody(mesh=mesh, lid_mesh=lid, dofs=dofs)


def drift(results, data, size, volume):
    """Mean drift of the free ship over the square of the amplitude, by Capytaine's far field."""
    theta = 2 * np.pi * np.arange(-12, 373) / 360  # beyond a turn at both ends, as the derivative needs
    finite = [result for result in results if np.isfinite(float(result.omega))]
    omegas = np.array(sorted({result.omega for result in finite}))
    headings = np.array(sorted({result.wave_direction for result in finite if not hasattr(result, "radiating_dof")}))
    place = {omega: index for index, omega in enumerate(omegas)}
    radiated = np.zeros((len(omegas), len(DOFS), len(theta)), complex)
    diffracted = np.zeros((len(omegas), len(headings), len(theta)), complex)
    for result in finite:
        kochin = cpt.post_pro.kochin.compute_kochin(result, theta)
        if not hasattr(result, "radiating_dof"):
            diffracted[place[result.omega], np.searchsorted(headings, result.wave_direction)] = kochin
        else:
            radiated[place[result.omega], DOFS.index(result.radiating_dof)] = kochin
    mass = WATER_KGPM3 * volume
    inertia = np.diag([mass] * 3 + [mass * k * k for k in size["gyradii"]])
    picked = {"influenced_dof": DOFS, "radiating_dof": DOFS, "omega": omegas}
    order = ("omega", "influenced_dof", "radiating_dof")
    added = data["added_mass"].sel(picked).transpose(*order).values
    damping = data["radiation_damping"].sel(picked).transpose(*order).values.copy()
    stiffness = data["hydrostatic_stiffness"].sel(influenced_dof=DOFS, radiating_dof=DOFS).values
    damping[:, 3, 3] += ROLL_DAMPING * 2 * np.sqrt(stiffness[3, 3] * (inertia[3, 3] + added[:, 3, 3]))
    w = omegas[:, None, None]
    force = data["excitation_force"].sel(omega=omegas, influenced_dof=DOFS, wave_direction=headings)
    force = force.transpose("omega", "influenced_dof", "wave_direction").values
    motion = np.linalg.solve(-(w**2) * (inertia + added) - 1j * w * damping + stiffness, force)
    of_waves = xr.Dataset(
        {
            "kochin_radiation": (("omega", "radiating_dof", "theta"), radiated),
            "kochin_diffraction": (("omega", "wave_direction", "theta"), diffracted),
            "wavenumber": ("omega", [next(r.wavenumber for r in finite if r.omega == omega) for omega in omegas]),
            "water_depth": data["water_depth"].values.flat[0], "rho": WATER_KGPM3, "g": GRAVITY_MPS2,
        },
        coords={"omega": omegas, "radiating_dof": DOFS, "wave_direction": headings, "theta": theta},
    )
    motions = xr.DataArray(motion, coords=[("omega", omegas), ("radiating_dof", DOFS), ("wave_direction", headings)])
    return cpt.post_pro.far_field_mean_drift_force(motions.transpose("omega", "wave_direction", "radiating_dof"), of_waves).real


def converters():
    """`fenderline.hydrodynamics`, without the compiled part of the package."""
    if "fenderline" not in sys.modules:
        package = types.ModuleType("fenderline")
        package.__path__ = [str(ROOT / "crates/python/python/fenderline")]
        sys.modules["fenderline"] = package
    return importlib.import_module("fenderline.hydrodynamics")


def solve(name, omegas, headings, drifts=True):
    """The dataset of a case at frequencies (rad/s; infinite among them if wanted) and headings of Capytaine (rad), with excitation and,
    in open water, drift if it is wanted. Also the mesh, the number of panels of its lid, the displaced volume (m³) and the hydrostatic stiffness."""
    of = CASES[name]
    size, wall = of["size"], of["wall"]
    centre = (0.0, 0.0, size["above_keel"] - size["draught"])
    mesh = mesh_of(of["hull"](), name)
    lid = mesh.generate_lid()
    dofs = cpt.rigid_body_dofs(rotation_center=centre)
    body = cpt.FloatingBody(mesh=mesh, dofs=dofs, center_of_mass=centre, name=name)
    volume = body.disp_mass(rho=WATER_KGPM3) / WATER_KGPM3
    stiffness = body.compute_hydrostatic_stiffness(rho=WATER_KGPM3)
    alike, lid = symmetric(mesh, lid, wall)
    assert alike.nb_faces == mesh.nb_faces * (1 if wall is None else 2)
    if wall is None:
        factor, body = 1.0, cpt.FloatingBody(mesh=alike, lid_mesh=lid, dofs=dofs, name=name)
    else:
        factor, body = 0.5, at_wall(alike, lid, centre[2], wall)
    solver = cpt.BEMSolver(green_function=ShallowWater())
    water = {"body": body, "water_depth": of["depth"], "rho": WATER_KGPM3, "g": GRAVITY_MPS2}
    results = []
    for omega in omegas:
        problems = [cpt.RadiationProblem(radiating_dof=dof, omega=omega, **water) for dof in DOFS]
        if np.isfinite(omega):
            problems += [cpt.DiffractionProblem(wave_direction=heading, omega=omega, **water) for heading in headings]
        results += solver.solve_all(problems, progress_bar=False)
    data = cpt.assemble_dataset(results, hydrostatics=False)
    # The force of the incident wave and its reflection on the hull alone is the generalised force of both halves in one wave.
    if "excitation_force" not in data:
        data["excitation_force"] = data["Froude_Krylov_force"] + data["diffraction_force"]
    data = data[["added_mass", "radiation_damping", "excitation_force"]]
    if wall is not None:
        # The crest at the hull, not at the wall.
        numbers = {float(result.omega): float(result.wavenumber) for result in results if np.isfinite(float(result.omega))}
        number = xr.DataArray([numbers.get(float(omega), 0.0) for omega in data.omega.values], coords=[("omega", data.omega.values)])
        data["excitation_force"] = data["excitation_force"] * np.exp(-1j * number * wall * np.sin(data.wave_direction))
    for key in ["added_mass", "radiation_damping"]:
        data[key] = factor * data[key]
    data["hydrostatic_stiffness"] = stiffness
    if wall is None and drifts:
        data = data.merge(drift(results, data, size, volume), join="outer")
    return data, mesh, lid.nb_faces, volume, stiffness


def halved(axis):
    """The values of an axis, and those in the middle between them."""
    return np.sort(np.concatenate([axis, 0.5 * (axis[1:] + axis[:-1])]))


def run(name, folder, half_steps=False):
    of = CASES[name]
    if half_steps:
        of = of | {key: halved(np.asarray(of[key])) for key in ["omegas", "headings", "radiation"] if key in of}
    size, wall = of["size"], of["wall"]
    began = time.process_time()
    omegas = np.unique([*of["omegas"], *of.get("radiation", ())])
    data, mesh, lid_faces, volume, stiffness = solve(name, [*omegas, np.inf], of["headings"])
    seconds = round(time.process_time() - began)
    water = "open water" if wall is None else f"a quay wall {wall:g} m to starboard of the centre line"
    source = (
        f"{size['name']} in {of['depth']:g} m of water, {water}: Capytaine {cpt.__version__}, {mesh.nb_faces} panels\n"
        f"and a lid, by hydrodynamics/capytaine_hulls.py ({name})."
    )
    data.attrs.update(source=source, processor_s=seconds)
    path = Path(folder) / f"{name}.nc"
    cpt.export_dataset(path, data, format="netcdf")
    gravity = size["above_keel"] - size["draught"]
    ship = converters().from_capytaine(
        data, gravity_above_water_m=gravity, gyradii_m=size["gyradii"], mass_kg=WATER_KGPM3 * volume, fold=wall is None, source=source
    )
    ship.excitation = {key: forces for key, forces in ship.excitation.items() if key[0] in of["omegas"]}
    ship.write(path.with_suffix(".hydro"))
    gm = float(stiffness.sel(influenced_dof="Roll", radiating_dof="Roll")) / (WATER_KGPM3 * GRAVITY_MPS2 * volume)
    print(f"{name}: {mesh.nb_faces} panels, lid {lid_faces}, {volume:.0f} m³, GM {gm:.2f} m, {seconds} s of processor time", flush=True)


if __name__ == "__main__":
    for case_name in CASES if sys.argv[1] == "all" else [sys.argv[1]]:
        run(case_name, sys.argv[2], half_steps="--half-steps" in sys.argv)
