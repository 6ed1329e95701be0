"""The laws of the simulator beside the finite elements: static curves, a tug's impact, eight fenders of a berth.

The impacts are run by the program itself (`fenderline run`); the reference is made apart from it, by the energy
balance of a head-on hit and by a small integration of the berthing ship with the finite-element curve in slices
along each fender.
"""

import csv
import json
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from . import rubber, studies

HERE = Path(__file__).resolve().parent.parent
ROOT = HERE.parent.parent
CHAPTER = ROOT / "docs" / "finite_elements.md"
ROWS = ROOT / "validation" / "finite_elements.toml"

TITLES = {
    "cylinder": "Hollow cylinder 1.0/0.5",
    "solid_d": "Solid D",
    "hollow_d": "Hollow D",
    "cone": "Cone",
}
# Fenders made from the curves: shape, height [m], length [m] (the cone has none) and hardness.
FENDERS = {
    "cylinder": (2.0, 4.0, 60),
    "solid_d": (0.3, 4.0, 60),
    "hollow_d": (0.5, 4.0, 70),
    "cone": (1.0, None, 70),
}
KNOTS = (0.1, 0.2, 0.3, 0.4, 0.5)


def curve(name, fineness=None):
    """Deflection over height, reaction and energy of a shape on its finest mesh, in units of the shear modulus."""
    fineness = fineness or studies.MESHES[name][-1]
    rows = [r for r in studies.read("pressed.csv") if r["shape"] == name and r["fineness"] == fineness]
    return tuple(np.array([row[key] for row in rows]) for key in ("deflection", "reaction", "energy"))


class Fender:
    """A fender of a shape in SI units, with the laws that represent it."""

    def __init__(self, name):
        self.name = name
        self.height, self.length, self.shore = FENDERS[name]
        modulus = rubber.shear_modulus_pa(self.shore)
        share, reaction, energy = curve(name)
        self.deflection = share * self.height
        # Width of the face: the length of a section, the panel of the cone.
        self.width = self.length or 1.5 * self.height
        # For the whole fender; sections are per metre of length.
        extent = self.length if self.length else self.height
        self.reaction = reaction * modulus * self.height * extent
        self.energy = energy * modulus * self.height**2 * extent
        self.rated = self.deflection[-1]
        # One stiffness that takes the same energy to the rated deflection.
        self.stiffness = 2 * self.energy[-1] / self.rated**2

    def at(self, deflection):
        return np.interp(deflection, self.deflection, self.reaction)

    def energy_at(self, deflection):
        return np.interp(deflection, self.deflection, self.energy)


def write_curves(fender):
    """The curve as rows for `fenderline fender fit`."""
    folder = HERE / "curves"
    folder.mkdir(exist_ok=True)
    path = folder / f"{fender.name}.csv"
    with open(path, "w", newline="") as file:
        extent = f", {fender.length} m long" if fender.length else ""
        file.write(f"# {TITLES[fender.name]}, {fender.height} m high{extent}, {fender.shore} Shore A: finite elements,\n")
        file.write("# made by validation/finite_elements/analyse.py\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["deflection_m", "reaction_kn"])
        for d, r in zip(fender.deflection, fender.reaction):
            writer.writerow([f"{d:.4f}", f"{r / 1e3:.3f}"])
    return path


def program():
    """The program: FENDERLINE, or the one that cargo builds."""
    if "FENDERLINE" in os.environ:
        return [os.environ["FENDERLINE"]]
    return ["cargo", "run", "--quiet", "--release", "--manifest-path", str(ROOT / "Cargo.toml"), "--package", "fenderline", "--"]


def run(*arguments):
    done = subprocess.run([*program(), *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, arguments))}:\n{done.stdout}{done.stderr}")
    return done.stdout


def fit(fender):
    """The fender file made from the curve."""
    path = write_curves(fender)
    out = HERE / "fenders" / f"{fender.name}.toml"
    out.parent.mkdir(exist_ok=True)
    length = ["--length", fender.length] if fender.length else []
    source = f"finite elements, docs/finite_elements.md; {fender.shore} Shore A by Gent's relation"
    name = ["--family", f"FE {fender.name.replace('_', ' ')}", "--designation", f"{fender.height} m, {fender.shore} Shore A"]
    run("fender", "fit", path, "-o", out, "--height", fender.height, *length, *name, "--tolerance", 0.2, "--source", source)
    return out


MATERIALS = """
[material.rubber]
stiffness = "{stiffness} N/m^2"
shear_stiffness = "3000 kN/m"
friction_static = 0.0
friction_dynamic = 0.0
restitution = 1

[material.concrete]
stiffness = "50 MN/m^2"
shear_stiffness = "10 MN/m"
restitution = 0.1
"""


def law_of(law, fender, path):
    """Keys of a fender for a law, and the beginning of the scenario file."""
    if law == "linear face":
        return f'stiffness = "{fender.stiffness} N/m"\n', ""
    keys = f'type = "FE {fender.name.replace("_", " ")}"\nsize = "{fender.height} m, {fender.shore} Shore A"\n'
    return keys, f'fender_files = ["{path}"]\n'


def tug(law, fender, path, speed):
    """A tug of 930 t bow-on against a quay, 0.1 m before it touches."""
    front = 16.0 + fender.height
    bow, files, pair, more = "[16, -2], [16, 2]", "", "concrete", ""
    if law == "kS by overlap":
        bow, pair = f"[16, -2], [{front}, -2], [{front}, 2], [16, 2]", "rubber"
    else:
        keys, files = law_of(law, fender, path)
        more = (
            f'\n[fender.bow]\non = "tug"\nposition = [16, 0]\nfacing = 0\nwidth = "4 m"\n'
            f'projection = "{fender.height} m"\nmaterial = "rubber"\n{keys}'
        )
    return f"""{files}title = "Tug, {law}"

[time]
step = "0.01 s"
duration = "2.5 s"

[contact]
method = "{'paper' if law == 'kS by overlap' else 'coupled'}"
{MATERIALS.format(stiffness=fender.stiffness / 4.0 if law == "kS by overlap" else 0)}
[body.quay]
fixed = true
outline = [[0, -50], [5, -50], [5, 50], [0, 50]]
position = [20, 0]

[body.tug]
outline = [[-16, -6.5], [12, -6.5], {bow}, [12, 6.5], [-16, 6.5]]
mass = "930 t"
gyradius = "8 m"
added_mass = {{ surge = 0.086, sway = 0.84, yaw = 0.4 }}
position = [{20 - front - 0.1}, 0]
velocity = {{ surge = "{speed} m/s" }}
{more}
[[pair]]
bodies = ["tug", "quay"]
material = "{pair}"
"""


SHIP = {"mass": 87.8e6, "added": 0.5, "yaw_added": 0.72, "gyradius": 74.5, "half_length": 120.0, "half_beam": 23.0}
PLACES = (-98.0, -70.0, -42.0, -14.0, 14.0, 42.0, 70.0, 98.0)


def berth(law, fender, path, speed, angle_deg):
    """A ship of 87 800 t with a straight side onto eight fenders, at a small angle."""
    sine, cosine = np.sin(np.radians(angle_deg)), np.cos(np.radians(angle_deg))
    # The last fender's far end is touched first; the side's distance from the centre along the quay's normal.
    away = fender.height + SHIP["half_beam"] / cosine + (PLACES[-1] + fender.width / 2) * sine / cosine + 0.05
    half = fender.width / 2
    parts, pairs, files = [], "", ""
    for number, x in enumerate(PLACES, 1):
        if law == "kS by overlap":
            h = fender.height
            parts.append(
                f"[body.fender_{number}]\nfixed = true\n"
                f"outline = [[{-half}, {-h}], [{half}, {-h}], [{half}, 0], [{-half}, 0]]\nposition = [{x}, 0]\n"
            )
            pairs += f'\n[[pair]]\nbodies = ["ship", "fender_{number}"]\nmaterial = "rubber"\n'
        else:
            keys, files = law_of(law, fender, path)
            parts.append(
                f'[fender.fender_{number}]\non = "quay"\nposition = [{x}, 0]\nfacing = "-90 deg"\n'
                f'width = "{fender.width} m"\nprojection = "{fender.height} m"\nmaterial = "rubber"\n{keys}'
            )
    a, b = SHIP["half_length"], SHIP["half_beam"]
    joined = "\n".join(parts)
    return f"""{files}title = "Eight fenders, {law}"

[time]
step = "0.02 s"
duration = "30 s"

[contact]
method = "{'paper' if law == 'kS by overlap' else 'coupled'}"
{MATERIALS.format(stiffness=fender.stiffness / fender.width if law == "kS by overlap" else 0)}
[body.ship]
outline = [[{-a}, {-b}], [{a}, {-b}], [{a}, {b}], [{-a}, {b}]]
mass = "{SHIP['mass']} kg"
gyradius = "{SHIP['gyradius']} m"
added_mass = {{ surge = {SHIP['added']}, sway = {SHIP['added']}, yaw = {SHIP['yaw_added']} }}
position = [0, {-away}]
heading = "{angle_deg} deg"
velocity = {{ surge = "{speed * sine} m/s", sway = "{speed * cosine} m/s" }}

[body.quay]
fixed = true
outline = [[-190, 0], [190, 0], [190, 25], [-190, 25]]
position = [0, 0]

{joined}
[[pair]]
bodies = ["ship", "quay"]
material = "concrete"
{pairs}"""


def berth_reference(fender, speed, angle_deg, slices=41, step=0.005):
    """The same ship on the finite-element curve in slices: forces normal to her side, no friction."""
    mass = SHIP["mass"] * (1 + SHIP["added"])
    inertia = SHIP["mass"] * SHIP["gyradius"] ** 2 * (1 + SHIP["yaw_added"])
    offsets = (np.arange(slices) + 0.5) / slices - 0.5
    along = np.add.outer(np.array(PLACES), offsets * fender.width)
    psi = np.radians(angle_deg)
    place = np.array([0.0, -(fender.height + SHIP["half_beam"] / np.cos(psi) + (PLACES[-1] + fender.width / 2) * np.tan(psi))])
    velocity, turn = np.array([0.0, speed]), 0.0
    peaks = np.zeros((len(PLACES), 3))
    for _ in range(int(30 / step)):
        normal = np.array([-np.sin(psi), np.cos(psi)])
        forward = np.array([np.cos(psi), np.sin(psi)])
        # Where her side crosses each slice's line: place + half_beam normal + s forward has x = along.
        s = (along - place[0] - SHIP["half_beam"] * normal[0]) / forward[0]
        side = place[1] + SHIP["half_beam"] * normal[1] + s * forward[1]
        depth = np.maximum(side + fender.height, 0.0) * (np.abs(s) <= SHIP["half_length"])
        force = fender.at(depth) / slices
        whole = force.sum(axis=1)
        # A slice's reaction is along the fender's axis; without friction the force is normal to her side.
        peaks[:, 0] = np.maximum(peaks[:, 0], whole)
        peaks[:, 1] = np.maximum(peaks[:, 1], depth.mean(axis=1))
        peaks[:, 2] = np.maximum(peaks[:, 2], fender.energy_at(depth).mean(axis=1))
        square = force / normal[1]
        velocity = velocity - step / mass * square.sum() * normal
        arm = s
        turn -= step / inertia * (arm * square).sum()
        place = place + step * velocity
        psi += step * turn
    return peaks


LAWS = ("kS by overlap", "linear face", "fitted curve")


def played(text):
    """Peaks of the most loaded fender: force [N], deflection [m], energy [J] if the law has one."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "case.toml"
        path.write_text(text)
        run("run", path, "--out", Path(folder) / "out")
        summary = json.loads((Path(folder) / "out" / "summary.json").read_text())
    if summary["fenders"]:
        worst = max(summary["fenders"], key=lambda one: one["peak_reaction_n"])
        return worst["peak_reaction_n"], worst["peak_deflection_m"], worst["peak_energy_j"]
    worst = max(summary["pairs"], key=lambda one: one["peak_normal_force_n"])
    return worst["peak_normal_force_n"], None, None


def impacts():
    """Rows of case, law, and the three peaks with their errors against the reference."""
    rows = []
    paths = {name: HERE / "fenders" / f"{name}.toml" for name in FENDERS}
    bow = Fender("hollow_d")
    for speed in (0.3, 0.6):
        taken = 0.5 * 930e3 * 1.086 * speed**2
        deflection = np.interp(taken, bow.energy, bow.deflection)
        rows += laws_beside(
            f"tug, {speed} m/s",
            (float(bow.at(deflection)), float(deflection), taken),
            bow,
            lambda law, speed=speed: tug(law, bow, paths["hollow_d"], speed),
        )
    for what, side, speed, angle in (
        ("cylinders", Fender("cylinder"), 0.15, 0.0),
        ("cylinders", Fender("cylinder"), 0.15, 2.0),
        ("cones", Fender("cone"), 0.10, 0.0),
        ("cones", Fender("cone"), 0.15, 0.0),
    ):
        peaks = berth_reference(side, speed, angle)
        worst = peaks[np.argmax(peaks[:, 0])]
        rows += laws_beside(
            f"eight {what}, {speed} m/s at {angle:.0f}°",
            tuple(map(float, worst)),
            side,
            lambda law, speed=speed, angle=angle, side=side: berth(law, side, paths[side.name], speed, angle),
        )
    return rows


def laws_beside(case, reference, fender, scenario):
    rows = [(case, "finite elements", *reference, 0.0, 0.0, 0.0)]
    for law in LAWS:
        force, deflection, energy = played(scenario(law))
        if energy is None:
            # Only the area of the overlap counts: its mean depth over the fender's width.
            deflection = force / fender.stiffness
            energy = 0.5 * fender.stiffness * deflection**2
        errors = [one / other - 1 for one, other in zip((force, deflection, energy), reference)]
        rows.append((case, law, force, deflection, energy, *errors))
        print(f"{case}, {law}: force {100 * errors[0]:+.1f} %, deflection {100 * errors[1]:+.1f} %, energy {100 * errors[2]:+.1f} %", flush=True)
    return rows


def compare():
    """Fenders, impacts, tables of the chapter and rows of `fenderline validate`."""
    from . import tables

    for name in FENDERS:
        fit(Fender(name))
    rows = impacts()
    header = ["case", "law", "force_n", "deflection_m", "energy_j", "force_error", "deflection_error", "energy_error"]
    studies.write("impacts.csv", header, rows)
    tables.write_chapter()
    tables.write_rows()
