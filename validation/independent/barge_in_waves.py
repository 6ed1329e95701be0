"""Motions of a free box barge in regular waves by the frequency-domain equation with Capytaine's numbers, and what a short beam wave pushes.

    python3 validation/independent/barge_in_waves.py

(−ω²(M + A) + iωB + C) ξ = F with the tables of hydrodynamics/barge_20m.hydro, by elimination in complex numbers. The reference point of the
file is the centre of gravity. Prints the rows of validation/seakeeping.toml.
"""

import math
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOTIONS = ["surge", "sway", "heave", "roll", "pitch", "yaw"]


def tables(path):
    """Rows of each table of a file, as dictionaries."""
    found, name, columns = {}, None, None
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("= "):
            name, columns = line[2:], None
        elif line and not line.startswith("#"):
            if columns is None:
                columns, found[name] = line.split(","), []
            else:
                found[name].append(dict(zip(columns, map(float, line.split(",")))))
    return found


def matrix(row, letter):
    full = [[0.0] * 6 for _ in range(6)]
    for i in range(6):
        for j in range(i, 6):
            full[i][j] = full[j][i] = row.get(f"{letter}{i + 1}{j + 1}", 0.0)
    return full


def solve(a, b):
    a, b = [row[:] for row in a], b[:]
    for k in range(6):
        pivot = max(range(k, 6), key=lambda i: abs(a[i][k]))
        a[k], a[pivot], b[k], b[pivot] = a[pivot], a[k], b[pivot], b[k]
        for i in range(6):
            if i != k:
                factor = a[i][k] / a[k][k]
                a[i] = [x - factor * y for x, y in zip(a[i], a[k])]
                b[i] -= factor * b[k]
    return [b[k] / a[k][k] for k in range(6)]


if __name__ == "__main__":
    data = tables(ROOT / "hydrodynamics/barge_20m.hydro")
    head = data["ship"][0]
    assert head["reference_forward_m"] == head["reference_starboard_m"] == head["reference_up_m"] == 0
    mass = [head["mass_kg"]] * 3 + [head["mass_kg"] * head[f"{name}_gyradius_m"] ** 2 for name in ("roll", "pitch", "yaw")]
    restoring = matrix({f"c{int(key[1]) + 0}{int(key[2]) + 0}": value for key, value in head.items() if key[0] == "c" and key[1].isdigit()}, "c")
    for omega, heading in [(0.6, 60), (0.9, 0), (0.9, 90), (1.2, 150)]:
        radiation = next(row for row in data["radiation"] if row["omega_radps"] == omega)
        force = next(row for row in data["excitation"] if (row["omega_radps"], row["heading_deg"]) == (omega, heading))
        added, damping = matrix(radiation, "a"), matrix(radiation, "b")
        left = [
            [complex(-omega**2 * (added[i][j] + (mass[i] if i == j else 0)) + restoring[i][j], omega * damping[i][j]) for j in range(6)]
            for i in range(6)
        ]
        motion = solve(left, [complex(force[f"re{k + 1}"], force[f"im{k + 1}"]) for k in range(6)])
        for k, name in enumerate(MOTIONS):
            size = abs(motion[k]) if k < 3 else math.degrees(abs(motion[k]))
            if size * (1 if k < 3 else math.radians(40)) > 0.02:
                print(f"{omega} rad/s, {heading}°: {name} {size:.4f} {'m' if k < 3 else '°'} for 1 m")
    print(f"total reflection of a beam wave: {0.5 * 1025 * 9.80665 * 80 / 1e3:.1f} kN for 1 m")
