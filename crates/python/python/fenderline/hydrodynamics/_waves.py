"""Wave numbers, and the damping that exciting forces ask for."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Complexes = npt.NDArray[np.complex128]


def wave_number_radpm(omega_radps: float, depth_m: float, gravity_mps2: float) -> float:
    """Wave number of the dispersion relation ω² = g k tanh kh, by Newton's method."""
    deep = omega_radps * omega_radps / gravity_mps2
    if not math.isfinite(depth_m) or deep * depth_m > 50.0:
        return deep
    # In x = kh: x tanh x = deep h. The start is above the root for long waves and short ones.
    target = deep * depth_m
    x = max(target, math.sqrt(target))
    for _ in range(50):
        t = math.tanh(x)
        step = (x * t - target) / (t + x * (1.0 - t * t))
        x -= step
        if abs(step) < 1e-14 * x:
            break
    return x / depth_m


def frequency_radps(wave_number: float, depth_m: float, gravity_mps2: float) -> float:
    """Frequency of the dispersion relation."""
    deep = gravity_mps2 * wave_number
    return math.sqrt(deep * math.tanh(wave_number * depth_m) if math.isfinite(depth_m) else deep)


def haskind_factor(omega_radps: float, depth_m: float, gravity_mps2: float, water_kgpm3: float) -> float:
    """k/(8πρg c), with c the group velocity: the damping is this times ∫|X|² dμ over all headings of a wave of 1 m amplitude
    (Newman 1962, recalled)."""
    k = wave_number_radpm(omega_radps, depth_m, gravity_mps2)
    twice = 2.0 * k * depth_m
    shallow = twice / math.sinh(twice) if math.isfinite(twice) and twice < 700.0 else 0.0
    group = 0.5 * omega_radps / k * (1.0 + shallow)
    return k / (8.0 * math.pi * water_kgpm3 * gravity_mps2 * group)


def resolved_radpm(headings_deg: Array, length_m: float) -> float:
    """The largest wave number at which these headings resolve |X|². The exciting force of a ship of length L has harmonics in the heading up to about
    kL/2, its square up to kL, and the trapezium takes those below the number of headings in a full turn; four are kept in hand."""
    at = np.sort(headings_deg)
    return max(0.0, 360.0 / float(np.diff(at).max()) - 4.0) / length_m if len(at) > 1 else 0.0


def over_all_headings(headings_deg: Array, forces: Complexes) -> Array | None:
    """∫|X|² dμ of each motion, by the trapezium; headings from 0 to 180 degrees stand for both sides. `None` if they leave a gap of more than
    46 degrees. `forces` has the frequency first, then the heading and the motion."""
    order = np.argsort(headings_deg)
    at, squared = np.radians(headings_deg[order]), np.abs(forces[:, order]) ** 2
    if len(at) < 2:
        return None
    widest = math.radians(46.0)
    gaps = np.diff(at)
    if gaps.max() > widest:
        return None
    inner: Array = np.einsum("h,whk->wk", gaps, 0.5 * (squared[:, 1:] + squared[:, :-1]))
    if abs(at[0]) < 1e-3 and abs(at[-1] - math.pi) < 1e-3:
        return 2.0 * inner
    rest = at[0] + 2.0 * math.pi - at[-1]
    if rest > widest:
        return None
    round_: Array = inner + rest * 0.5 * (squared[:, 0] + squared[:, -1])
    return round_
