"""Tables of the chapter and rows of `fenderline validate`, from stored results."""

import numpy as np

from . import laws, rubber, studies
from .laws import KNOTS, TITLES

BEGIN, END = "<!-- {}: by validation/finite_elements/analyse.py -->", "<!-- end -->"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines)


def moduli():
    rows = [
        (shore, f"{rubber.young_modulus_pa(shore) / 1e6:.2f}", f"{rubber.shear_modulus_pa(shore) / 1e6:.2f}")
        for shore in (60, 70)
    ]
    return table(["Shore A", "E [MPa]", "G = E/3 [MPa]"], rows)


def convergence():
    rows = []
    for name, finenesses in studies.MESHES.items():
        finest = laws.curve(name)
        for fineness in finenesses:
            deflection, reaction, energy = laws.curve(name, fineness)
            elements = next(
                int(row["elements"])
                for row in studies.read("pressed.csv")
                if row["shape"] == name and row["fineness"] == fineness
            )
            off = [f"{100 * (one[-1] / other[-1] - 1):+.2f} %" for one, other in zip((reaction, energy), finest[1:])]
            only = len(finenesses) == 1
            rows.append(
                (
                    TITLES[name],
                    elements,
                    f"{100 * deflection[-1]:.0f} %",
                    f"{reaction[-1]:.4f}",
                    f"{energy[-1]:.4f}",
                    "-" if only else off[0],
                    "-" if only else off[1],
                )
            )
    header = ["shape", "elements", "deflection", "reaction", "energy", "reaction off finest", "energy off finest"]
    return table(header, rows)


def reactions():
    rows = []
    for name in TITLES:
        deflection, reaction, energy = laws.curve(name)
        peak = int(np.argmax(reaction))
        cells = [f"{np.interp(k, deflection, reaction):.3f}" if k <= deflection[-1] + 1e-9 else "-" for k in KNOTS]
        rows.append((TITLES[name], *cells, f"{reaction[peak]:.3f} at {100 * deflection[peak]:.0f} %"))
    return table(["shape", *[f"{100 * k:.0f} %" for k in KNOTS], "largest"], rows)


def static_laws():
    """Reaction of the one stiffness that takes the rated energy, over that of the finite elements."""
    rows = []
    for name in TITLES:
        deflection, reaction, energy = laws.curve(name)
        stiffness = 2 * energy[-1] / deflection[-1] ** 2
        cells = []
        for knot in KNOTS:
            if knot > deflection[-1] + 1e-9:
                cells.append("-")
                continue
            cells.append(f"{100 * (stiffness * knot / np.interp(knot, deflection, reaction) - 1):+.0f} %")
        rows.append((TITLES[name], f"{stiffness:.3f}", *cells))
    return table(["shape", "k", *[f"{100 * k:.0f} %" for k in KNOTS]], rows)


def tilted():
    rows = []
    stored = studies.read("tilted.csv")
    for name in studies.WHOLE:
        flat = {row["deflection"]: row["reaction"] for row in stored if row["shape"] == name and row["tilt_deg"] == 0}
        for tilt in studies.TILTS_DEG:
            own = {row["deflection"]: row for row in stored if row["shape"] == name and row["tilt_deg"] == tilt}
            for knot in (0.2, 0.4):
                if knot not in own or knot not in flat:
                    continue
                row = own[knot]
                rows.append(
                    (
                        TITLES[name],
                        f"{tilt}°",
                        f"{100 * knot:.0f} %",
                        f"{row['reaction']:.3f}",
                        f"{100 * (row['reaction'] / flat[knot] - 1):+.1f} %",
                        f"{row['lateral']:+.3f}",
                        f"{np.tan(np.radians(tilt)) * -row['reaction']:+.3f}",
                        f"{row['moment']:+.3f}",
                    )
                )
    header = ["shape", "tilt", "deflection", "reaction", "off flat", "lateral force", "−R tan(tilt)", "moment"]
    return table(header, rows)


def impacts():
    rows = []
    for row in studies.read("impacts.csv"):
        error = lambda key: "" if row["law"] == "finite elements" else f" ({100 * row[key]:+.1f} %)"
        rows.append(
            (
                row["case"],
                row["law"],
                f"{row['force_n'] / 1e3:.0f} kN{error('force_error')}",
                f"{1e3 * row['deflection_m']:.0f} mm{error('deflection_error')}",
                f"{row['energy_j'] / 1e3:.0f} kJ{error('energy_error')}",
            )
        )
    return table(["case", "law", "peak force", "deflection", "energy"], rows)


def cost():
    return f"The studies take {studies.read('time.csv')[0]['processor_seconds']:.0f} s of processor time; the comparison takes more."


TABLES = {
    "moduli": moduli,
    "convergence": convergence,
    "reactions": reactions,
    "static laws": static_laws,
    "tilted": tilted,
    "impacts": impacts,
    "cost": cost,
}


def write_chapter():
    """Writes the tables between their marks, and prints them."""
    text = laws.CHAPTER.read_text()
    for name, make in TABLES.items():
        begin = BEGIN.format(name)
        if begin not in text:
            raise SystemExit(f"{laws.CHAPTER} has no mark for the table {name}")
        before, rest = text.split(begin, 1)
        _, after = rest.split(END, 1)
        made = make()
        print(f"\n{name}\n{made}", flush=True)
        text = f"{before}{begin}\n{made}\n{END}{after}"
    laws.CHAPTER.write_text(text)


HEAD = """# Fenders by finite elements, for `fenderline validate`; made by validation/finite_elements/analyse.py, not to be
# edited by hand. Ours are the laws of the simulator with the fender files of validation/finite_elements/fenders.

subject = "Fenders: finite elements"

[[reference]]
short = "finite elements"
citation = "docs/finite_elements.md: FElupe 11.3.0, neo-Hookean rubber by Gent's relation, plane strain and axisymmetric."
standing = "computed"

[[uncertainty]]
name = "mesh"
share = 0.0035
from = "The last halving of the mesh changes reactions and energies by 0.1 to 0.35 %."

[[uncertainty]]
name = "manufacture"
share = 0.1
from = "Rubber fenders are made to within 10 % of their rated reaction: a stiffness need not be known better."
"""


def number(case, place, computed, published, unit, tolerance, reason, uncertainty, mismatch=None):
    text = f'\n[[number]]\ncase = "{case}"\nplace = "{place}"\ncomputed = "{computed}"\npublished = {published:.6g}\n'
    text += f'unit = "{unit}"\ntolerance = {tolerance:.4g}\nreason = "{reason}"\n{uncertainty}\n'
    if mismatch:
        text += f'known_mismatch = true\nnote = "{mismatch}"\n'
    return text


def write_rows():
    """Rows of reaction and energy of the fitted curve, and of the one stiffness, at several deflections."""
    parts = [HEAD]
    for name, finenesses in studies.MESHES.items():
        if len(finenesses) > 1:
            deflection, reaction, energy = laws.curve(name)
            for what, finest in (("reaction", reaction[-1]), ("energy", energy[-1])):
                parts.append(
                    number(
                        f"{TITLES[name]}: {what} at {100 * deflection[-1]:.0f} % of the height, mesh halved once less",
                        "results/pressed.csv, the finest mesh",
                        f"finite_elements/{name}/mesh/{what}",
                        finest,
                        "",
                        0.005,
                        "Half as much again as halving the mesh once more changes; 2 % was asked for.",
                        'uncertainty = "mesh"',
                    )
                )
    fitted = "The straight pieces of the fit are within 0.2 % of the rated reaction; the rest is the rounding of the file."

    def of_the_fit(share):
        return f'uncertainty = {share:.4g}\nuncertainty_from = "The fit: 0.2 % of the rated reaction here, and the file\'s digits."'

    one = "As of a law that stands for the fender: 10 %, the manufacturing tolerance of fenders."
    for name in TITLES:
        fender = laws.Fender(name)
        for share in (0.5, 1.0):
            deflection = share * fender.rated
            force, energy = float(fender.at(deflection)) / 1e3, float(fender.energy_at(deflection)) / 1e3
            rated = fender.reaction[-1] / 1e3
            where = f"{100 * deflection / fender.height:.0f} % of the height"
            # Relative tolerances: the fit's absolute difference over the value.
            parts.append(
                number(
                    f"{TITLES[name]}: reaction at {where}, fitted curve",
                    "results/pressed.csv",
                    f"finite_elements/{name}/curve/reaction at {share}",
                    force,
                    "kN",
                    max(0.0022 * rated / force, 0.0025),
                    fitted,
                    of_the_fit(max(0.0022 * rated / force, 0.0025)),
                )
            )
            parts.append(
                number(
                    f"{TITLES[name]}: energy at {where}, fitted curve",
                    "results/pressed.csv",
                    f"finite_elements/{name}/curve/energy at {share}",
                    energy,
                    "kJ",
                    max(0.0022 * rated * deflection / energy, 0.0025),
                    fitted,
                    of_the_fit(max(0.0022 * rated * deflection / energy, 0.0025)),
                )
            )
            linear = fender.stiffness * deflection / 1e3
            off = linear / force - 1
            parts.append(
                number(
                    f"{TITLES[name]}: reaction at {where}, one stiffness",
                    "results/pressed.csv",
                    f"finite_elements/{name}/linear/reaction at {share}",
                    force,
                    "kN",
                    0.1,
                    one,
                    'uncertainty = "manufacture"',
                    f"A straight line of the same rated energy cannot follow the curve: {100 * off:+.0f} % here." if abs(off) > 0.1 else None,
                )
            )
    laws.ROWS.write_text("".join(parts))
