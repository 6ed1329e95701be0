"""Added mass at infinite frequency from that of the highest frequencies."""

from __future__ import annotations

import math

import numpy as np

from fenderline.hydrodynamics._irregular import FEWEST
from fenderline.hydrodynamics._panel import MOTIONS, Panel, trapezium
from fenderline.hydrodynamics._waves import Array


def at_infinity(panel: Panel) -> str | None:
    """The added mass at infinite frequency from that of the highest frequencies, by Ogilvie's relation (1964, recalled): it is A(ω) less
    (2/π)∫(B(w) − B(ω))/(w² − ω²)dw. Gives back why it cannot be told, if so."""
    if panel.infinite is not None:
        return None
    w, n = panel.omega, len(panel.omega)
    if n < FEWEST:
        return f"the added mass at infinite frequency cannot be told from {n} frequencies"
    count = max(3, n // 3)
    fine = np.unique(np.concatenate([np.linspace(0.0, w[-1], 600), w]))
    wrong = None
    infinite = np.zeros((6, 6))
    errors = []
    for i in range(6):
        for j in range(6):
            curve = panel.damping[:, i, j]
            if not curve.any():
                values = panel.added[n - count :, i, j]
                infinite[i, j] = np.median(values)
                spread = float(values.max() - values.min())
            else:
                values = np.array([
                    [panel.added[row, i, j] - change(fine, w, curve, w[row], power) for row in range(n - count, n - 1)]
                    for power in (2.0, 6.0)
                ])
                infinite[i, j] = np.median(values)
                spread = float(np.abs(np.percentile(values, [10, 90]) - infinite[i, j]).max())
            if i == j:
                largest = max(np.abs(panel.added[:, i, i]).max(), 0.2 * panel.mass[i])
                share = spread / largest if largest > 0.0 else 0.0
                errors.append(f"{MOTIONS[i]} {100 * share:.1f} %")
                if share > 0.25 and wrong is None:
                    wrong = (
                        f"the added mass of {MOTIONS[i]} at infinite frequency follows from the last frequencies with an error of "
                        f"{100 * share:.0f} % only (Ogilvie's relation): run infinite frequency, or higher ones"
                    )
    panel.infinite = infinite
    panel.notes.append(
        "Filled: added mass at infinite frequency, which the files do not have, by Ogilvie's relation from "
        f"{w[n - count]:.4g} to {w[-1]:.4g} rad/s. Its error over the largest added mass: {', '.join(errors)}."
    )
    return wrong


def change(fine: Array, w: Array, curve: Array, at: float, power: float) -> float:
    """A(ω) − A∞ by the damping, which falls as a power of the frequency beyond the last one."""
    end = w[-1]
    axis = np.concatenate([fine, end * np.geomspace(1.0, 40.0, 200)[1:]])
    damping = np.interp(axis, np.concatenate([[0.0], w]), np.concatenate([[0.0], curve]))
    beyond = axis > end
    damping[beyond] = curve[-1] * (end / axis[beyond]) ** power
    own = float(np.interp(at, np.concatenate([[0.0], w]), np.concatenate([[0.0], curve])))
    square = axis * axis - at * at
    near = np.abs(square) < 1e-9 * at * at
    safe = np.where(near, 1.0, square)
    inner = (damping - own) / safe
    if near.any():
        slope = np.gradient(damping, axis)
        inner = np.where(near, 0.5 * slope / at, inner)
    last = axis[-1]
    rest = -own * math.log((last + at) / (last - at)) / (2.0 * at)
    return float(2.0 / math.pi * (trapezium(inner, axis) + rest))
