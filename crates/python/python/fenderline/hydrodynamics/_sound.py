"""The range of frequencies that is sound."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from fenderline.hydrodynamics._irregular import (
    ENDS,
    FEWEST,
    NEGATIVE,
    STEP,
    Band,
    Repair,
    bands,
    faults,
    irregular,
    is_single,
    repaired,
)
from fenderline.hydrodynamics._panel import MOTIONS, Panel, radps, trapezium

#: The largest negative damping, over the maxima, that may be taken away where nothing else is left.
SMALL = 0.15
#: The most irregular frequencies that are repaired; where there are more, the range is cut.
MANY = 4
#: The most ends of the range that are tried.
CANDIDATES = 24


def looked_through(
    panel: Panel, lowest: float | None, highest: float | None, asked: Sequence[float] | None
) -> tuple[list[Repair], list[str]]:
    """The range to use, as asked or proposed, with single irregular frequencies repaired. What is done is said; what stays wrong is given back."""
    if lowest is not None or highest is not None:
        low, high = lowest or 0.0, math.inf if highest is None else highest
        _keep(panel, low, high, f"the range to use is given as {low:g} to {high:g} rad/s")
    if not len(panel.omega) or not len(panel.wave_omega):
        return [], ["no frequency is left in the range to use"]
    if asked is not None:
        repairs = repaired(panel, _asked(panel, asked))
        return repairs, _sound_range(panel, may_repair=False)
    # From the widest range on: the first that has single irregular frequencies at most.
    found = irregular(panel)
    if not found and not any(faults(panel.damping)) and not (wrong := unsound(panel)):
        return [], wrong
    peak = int(np.argmax(panel.damping[:, 2, 2]))
    ends = sorted({band.start for band in found if band.start > max(peak, FEWEST - 1)} | {len(panel.omega)})
    if len(ends) > CANDIDATES:
        ends = [ends[round(k * (len(ends) - 1) / (CANDIDATES - 1))] for k in range(CANDIDATES)]
    doubtful: tuple[Panel, list[Repair]] | None = None
    for end in reversed(ends):
        left = _copy(panel)
        if end < len(panel.omega):
            first = next(band for band in found if band.start == end)
            _keep(left, 0.0, panel.omega[end - 1] * (1 + 1e-9), f"from {panel.omega[end]:.4g} rad/s on {first.reason}")
        own = irregular(left)
        singles = [band for band in own if is_single(left.omega, band)]
        few = len({(band.start, band.end) for band in singles}) <= MANY
        repairs = repaired(left, singles) if few else []
        if any(faults(left.damping)) or unsound(left):
            continue
        if few and not irregular(left):
            return _taken(panel, left, repairs), []
        # Ranges that are sound but for contradictions: the shortest has the fewest.
        doubtful = left, repairs
    if doubtful is not None:
        left, repairs = doubtful
        _doubt(left)
        return _taken(panel, left, repairs), []
    return [], _sound_range(panel, may_repair=True)


def _taken(panel: Panel, left: Panel, repairs: list[Repair]) -> list[Repair]:
    panel.__dict__.update(left.__dict__)
    return repairs


def _copy(panel: Panel) -> Panel:
    return replace(
        panel, notes=[*panel.notes], damping=panel.damping.copy(), added=panel.added.copy(), force=panel.force.copy()
    )


def _asked(panel: Panel, asked: Sequence[float]) -> list[Band]:
    found = []
    for omega in asked:
        row = int(np.argmin(np.abs(panel.omega - omega)))
        if abs(panel.omega[row] / omega - 1.0) > 0.01:
            panel.notes.append(f"Not repaired: {omega:g} rad/s is not a frequency of the data.")
            continue
        found += [Band(row, row + 1, k, "as asked") for k in range(6)]
    return found


def _doubt(panel: Panel) -> None:
    """Says where motions are off that cannot be cut."""
    found = irregular(panel)
    if found:
        first = found[0]
        count = len({row for band in found for row in range(band.start, band.end)})
        panel.notes.append(
            f"Doubt: from {panel.omega[first.start]:.4g} rad/s on {first.reason} (Haskind's relation): the panels do not resolve such waves, or "
            f"frequencies are irregular. So it is with one motion or another at {count} frequencies, which cannot be cut: without them the "
            "damping would not have faded. A lid in the hull or finer panels would help."
        )


def _sound_range(panel: Panel, *, may_repair: bool) -> list[str]:
    """Keeps the range without negative damping. If that is not sound and repairs are allowed, small negative parts are taken away, and irregular frequencies repaired,
    however many."""
    first: Panel | None = None
    problems: list[str] = []
    for with_small, with_singles in ((False, False), (True, False), (True, True))[: 3 if may_repair else 1]:
        left = _copy(panel)
        if with_singles:
            singles = [band for band in irregular(left) if is_single(left.omega, band)]
            if len({(band.start, band.end) for band in singles}) > max(MANY, len(left.omega) // 10):
                continue
            repaired(left, singles)
        taken = _passive(left) if with_small else {}
        wrong = _negative(left) or unsound(left)
        if not wrong:
            used = {w: share for w, share in taken.items() if w in left.omega}
            if used:
                left.notes.append(
                    f"Repaired: damping at {radps(list(used))}: the negative part, {100 * max(used.values()):.1f} % of the maxima at most, is "
                    "taken away, for without these frequencies the rest would not be sound."
                )
            _doubt(left)
            panel.__dict__.update(left.__dict__)
            return []
        if first is None:
            first, problems = left, wrong
    assert first is not None
    panel.__dict__.update(first.__dict__)
    return problems


def _negative(panel: Panel) -> list[str]:
    """Keeps the run of frequencies without negative damping that makes most of the waves."""
    for _ in range(20):
        found = faults(panel.damping)
        if not any(found):
            return []
        runs = [
            (_waves_of(panel, start, end), start, end)
            for start, end in bands(np.array([fault is None for fault in found]))
            if end - start >= FEWEST
        ]
        if not runs:
            said = next(f"at {panel.omega[row]:.4g} rad/s {fault}" for row, fault in enumerate(found) if fault)
            return [f"no {FEWEST} frequencies in a row are sound: {said}"]
        _, start, end = max(runs)
        low, high = panel.omega[start], panel.omega[end - 1]
        below = [row for row in range(start) if found[row] is not None]
        above = [row for row in range(end, len(found)) if found[row] is not None]
        reasons = [f"at {panel.omega[row]:.4g} rad/s {found[row]}" for row in (below[-1:] + above[:1])]
        more = len(below) + len(above) - len(reasons)
        reason = " and ".join(reasons) + (f", and {more} further frequencies are like that" if more else "")
        # Maxima may be others afterwards, so it is looked through again.
        _keep(panel, low * (1 - 1e-9), high * (1 + 1e-9), reason)
    return ["no range of frequencies is sound"]


def _passive(panel: Panel) -> dict[float, float]:
    """Takes small negative parts of the damping away, and gives back how large they were over the maxima, by frequency."""
    most = np.array([np.abs(panel.damping[:, k, k]).max(initial=0.0) for k in range(6)])
    root = np.sqrt(most)
    scale = np.where(most > 0.0, 1.0 / np.maximum(root, 1e-150), 0.0)
    taken = {}
    for row, matrix in enumerate(panel.damping):
        values, vectors = np.linalg.eigh(0.5 * (matrix + matrix.T) * np.outer(scale, scale))
        if -SMALL <= values[0] < -NEGATIVE:
            taken[float(panel.omega[row])] = -float(values[0])
            panel.damping[row] = (vectors * np.maximum(values, 0.0)) @ vectors.T * np.outer(root, root)
    return taken


def _waves_of(panel: Panel, start: int, end: int) -> float:
    """The share of the damping of all motions that lies in a run of frequencies."""
    w = panel.omega
    total = 0.0
    for k in range(6):
        curve = np.maximum(panel.damping[:, k, k], 0.0)
        most = curve.max(initial=0.0)
        if most > 0.0:
            total += float(trapezium(curve[start:end], w[start:end]) / most)
    return total


def _keep(panel: Panel, low: float, high: float, reason: str) -> None:
    """Cuts to a range."""
    inside = (panel.omega >= low) & (panel.omega <= high)
    waves = (panel.wave_omega >= low) & (panel.wave_omega <= high)
    said: dict[str, list[str]] = {}
    for name, own, keep in (
        ("added mass and damping", panel.omega, inside),
        ("exciting forces", panel.wave_omega, waves),
    ):
        for side, rows in (("below", own < low), ("above", own > high)):
            if rows.any():
                kept = own[keep]
                edge = (kept[0] if side == "below" else kept[-1]) if len(kept) else math.nan
                said.setdefault(f"{side} {edge:.4g} rad/s ({radps(own[rows])})", []).append(name)
    for where, names in said.items():
        panel.notes.append(f"Cut: {', and '.join(names)} {where}: {reason}.")
    panel.omega, panel.added, panel.damping = panel.omega[inside], panel.added[inside], panel.damping[inside]
    panel.wave_omega, panel.force = panel.wave_omega[waves], panel.force[waves]
    panel.drift = None if panel.drift is None else panel.drift[waves]


def unsound(panel: Panel) -> list[str]:
    """Why the simulation would refuse these frequencies."""
    w, n = panel.omega, len(panel.omega)
    if n < FEWEST:
        return [f"there are {n} frequencies, but {FEWEST} are needed"]
    wrong = []
    for k in range(6):
        curve = panel.damping[:, k, k]
        most = curve.max(initial=0.0)
        total = panel.felt[k]
        if most < 0.06 * total:
            continue
        leap = int(np.argmax(np.abs(np.diff(curve))))
        if abs(curve[leap + 1] - curve[leap]) > STEP * most:
            wrong.append(
                f"damping of {MOTIONS[k]} changes by more than {100 * STEP:.0f} % of its maximum between {w[leap]:.4g} and "
                f"{w[leap + 1]:.4g} rad/s: the frequencies are too far apart"
            )
        if curve[-1] > ENDS[1] * most:
            wrong.append(
                f"damping of {MOTIONS[k]} is still {100 * curve[-1] / most:.0f} % of its maximum at {w[-1]:.4g} rad/s, the last sound "
                "frequency: run higher ones"
            )
        if w[0] * curve[0] > 0.3 * panel.stiff[k] and curve[0] > ENDS[0] * most:
            wrong.append(
                f"damping of {MOTIONS[k]} is {100 * curve[0] / most:.0f} % of its maximum at {w[0]:.4g} rad/s, the first sound "
                "frequency: run lower ones"
            )
    return wrong
