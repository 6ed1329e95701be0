"""What is not a number or only noise, dropped or filled."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from fenderline.hydrodynamics._panel import MOTIONS, Panel, radps
from fenderline.hydrodynamics._waves import Array

#: Damping over ω times mass and added mass below which a motion makes no waves, only noise: a body of revolution that yaws.
NO_WAVES = 1e-4


def finite(values: Any, axes: int) -> npt.NDArray[np.bool_]:
    """Whether all values beyond the first axes are finite."""
    shape = values.shape[:axes]
    return np.asarray(np.isfinite(values).reshape(*shape, -1).all(axis=-1))


def without_numbers(panel: Panel) -> None:
    """Drops frequencies at which a value is not a number."""
    dropped: dict[str, list[str]] = {}
    good: npt.NDArray[np.bool_] = np.ones(len(panel.omega), bool)
    for name, values in (("added mass", panel.added), ("damping", panel.damping)):
        own = finite(values, 1)
        good = good & own
        if not own.all():
            dropped.setdefault(radps(panel.omega[~own]), []).append(name)
    panel.omega, panel.added, panel.damping = panel.omega[good], panel.added[good], panel.damping[good]
    forces = finite(panel.force, 1)
    if not forces.all():
        dropped.setdefault(radps(panel.wave_omega[~forces]), []).append("exciting forces")
    panel.wave_omega, panel.force = panel.wave_omega[forces], panel.force[forces]
    panel.drift = None if panel.drift is None else panel.drift[forces]
    for where, names in dropped.items():
        panel.notes.append(f"Dropped: {where}: values of {', '.join(names)} are not numbers there (the panel code found no solution).")
    if panel.infinite is not None and not np.isfinite(panel.infinite).all():
        panel.notes.append("Dropped: the added mass at infinite frequency is not a number.")
        panel.infinite = None
    if panel.drift is not None:
        panel.drift = _drift_everywhere(panel, panel.drift)


def _drift_everywhere(panel: Panel, drift: Array) -> Array | None:
    """Mean drift at each frequency and heading of the excitation: filled between frequencies and, where it has died away, below them."""
    known = finite(drift, 2)
    columns: npt.NDArray[np.bool_] = np.asarray(known.any(axis=0))
    if not columns.all():
        panel.notes.append(
            f"Left out: mean drift, which has no value for {int((~columns).sum())} of the {len(columns)} headings of the exciting forces."
        )
        return None
    if known.all():
        return drift
    full = drift.copy()
    w = panel.wave_omega
    filled: set[float] = set()
    zero: set[float] = set()
    for column in range(drift.shape[1]):
        rows = np.flatnonzero(known[:, column])
        most = np.abs(drift[rows, column]).max(axis=0)
        for row in np.flatnonzero(~known[:, column]):
            if row > rows[-1] or (row < rows[0] and (np.abs(drift[rows[0], column]) > 0.1 * most + 1e-30).any()):
                panel.notes.append(
                    f"Left out: mean drift, which has no value at {w[row]:.4g} rad/s, beyond the frequencies at which it is known."
                )
                return None
            if row < rows[0]:
                full[row, column] = 0.0
                zero.add(float(w[row]))
            else:
                full[row, column] = [np.interp(w[row], w[rows], drift[rows, column, k]) for k in range(3)]
                filled.add(float(w[row]))
    if filled:
        panel.notes.append(f"Filled: mean drift at {radps(sorted(filled))}, by a line between its neighbours.")
    if zero:
        panel.notes.append(
            f"Filled: mean drift at {radps(sorted(zero))} is zero: it is not known there, and below a tenth of its maximum above."
        )
    return full


def without_noise(panel: Panel, mass: Array) -> None:
    """No damping of motions that make no waves: what a panel code gives there is noise of either sign."""
    for k in range(6):
        inertia = np.abs(mass[k, k] + panel.added[:, k, k]) * panel.omega
        share = np.abs(panel.damping[:, k, k]) / np.maximum(inertia, 1e-30)
        if panel.damping[:, k, k].any() and share.max(initial=0.0) < NO_WAVES:
            panel.damping[:, k, :] = 0.0
            panel.damping[:, :, k] = 0.0
            panel.notes.append(
                f"Filled: damping of {MOTIONS[k]} is zero: it makes no waves ({share.max():.1e} of omega times mass and added mass at most), "
                "and the values are noise of the panels."
            )
