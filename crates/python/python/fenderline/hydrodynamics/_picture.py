"""The picture of hydrodynamic data."""

from __future__ import annotations

import io
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from fenderline.hydrodynamics._errors import HydrodynamicsError
from fenderline.hydrodynamics._panel import MOTIONS

if TYPE_CHECKING:
    from fenderline.hydrodynamics._data import Hydrodynamics

#: Powers of ten and their names in front of a unit.
_LARGER = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""))
_MASS = ("kg", "kg m²")
_DAMPING = ("N s/m", "N m s")
_FORCE = ("N/m", "N m/m")
_DRIFT = ("N/m²", "N/m²", "N m/m²")
_COLOURS = ("#0b4f6c", "#b5452c", "#2b7a4b", "#8a5a00", "#5b3f8c", "#1c8a8a", "#a03070")
_CUT, _REPAIR = "#c9ccd1", "#e0a100"


def _as_svg(figure: Any) -> str:
    """The figure as the text of an SVG file."""
    text = io.StringIO()
    figure.savefig(text, format="svg")
    return text.getvalue()


def draw(data: Hydrodynamics, path: str | Path | None) -> Any:
    """A figure: a row for each motion with added mass, damping and exciting force over frequency, and drift below."""
    try:
        import matplotlib.figure
        from matplotlib.backends.backend_agg import FigureCanvasAgg
    except ImportError as error:
        raise ImportError("pictures need Matplotlib: pip install matplotlib") from error
    kinds = FigureCanvasAgg.get_supported_filetypes()
    if path is not None and Path(path).suffix.lstrip(".").lower() not in kinds:
        raise HydrodynamicsError(f"the picture cannot be written: the end of its name must be one of {', '.join(sorted(kinds))}", path)
    before = data.before
    with_drift = bool(data.drift)
    rows = 7 if with_drift else 6

    # A figure that belongs to no window: a notebook shows the figure once, as the result of the call. The class is made here,
    # as only a call that draws may need Matplotlib.
    picture: Any = type("Picture", (matplotlib.figure.Figure,), {"_repr_svg_": _as_svg})
    height = 1.75 * rows + 1.4
    figure = picture(figsize=(11.0, height))
    FigureCanvasAgg(figure)
    axes = figure.subplots(rows, 3, sharex=True)
    omegas = sorted(w for w in data.damping if math.isfinite(w))
    headings = _some(sorted({heading for _, heading in data.excitation}))
    waves = sorted({w for w, _ in data.excitation})
    widest = [*omegas, *waves]
    if before is not None:
        widest += [*before.omega, *before.wave_omega]
    end = max(widest, default=1.0)
    for k, name in enumerate(MOTIONS):
        added, damping, force = axes[k]
        _matrix(added, data, omegas, k, "added_mass", f"{name}: added mass", _MASS[k > 2])
        _matrix(damping, data, omegas, k, "damping", f"{name}: damping", _DAMPING[k > 2])
        amplitudes = {h: [abs(data.excitation[w, h][k]) for w in waves] for h in headings}
        _headings(force, waves, amplitudes, f"{name}: exciting force", _FORCE[k > 2])
        if before is not None and len(before.wave_omega):
            for heading in headings:
                column = int(np.argmin(np.abs(before.headings_deg - heading)))
                _grey(force, before.wave_omega, np.abs(before.force[:, column, k]), waves)
    if with_drift:
        for ax, k, name in zip(axes[6], range(3), ("surge", "sway", "yaw"), strict=True):
            values = {h: [data.drift[w, h][k] for w in waves] for h in headings}
            _headings(ax, waves, values, f"{name}: mean drift", _DRIFT[k])
            if before is not None and before.drift is not None:
                for heading in headings:
                    column = int(np.argmin(np.abs(before.headings_deg - heading)))
                    _grey(ax, before.wave_omega, before.drift[:, column, k], waves)
    for row in axes:
        for ax in row:
            _marks(ax, data, omegas or waves, end)
            ax.set_xlim(0.0, end * 1.02)
            ax.axhline(0.0, color="#888888", linewidth=0.6)
            ax.tick_params(labelsize=7)
    for ax in axes[-1]:
        ax.set_xlabel("frequency [rad/s]", fontsize=8)
    axes[0][2].legend(fontsize=6, ncols=2, title="heading [°]: 0 from astern, 180 from ahead", title_fontsize=6)
    figure.suptitle(_title(data), fontsize=10, y=1.0 - 0.12 / height)
    figure.subplots_adjust(left=0.045, right=0.99, bottom=0.5 / height, top=1.0 - 0.85 / height, hspace=0.33, wspace=0.14)
    if path is not None:
        _write(figure, Path(path))
    return figure


def _title(data: Hydrodynamics) -> str:
    depth = "deep water" if not math.isfinite(data.depth_m) else f"{data.depth_m:g} m of water"
    first = data.source.splitlines()[0] if data.source else "hydrodynamic data"
    tonnes = data.mass_kg / 1e3
    mass = f"{tonnes:,.0f} t" if tonnes >= 10.0 else f"{tonnes:.3g} t" if tonnes >= 1.0 else f"{data.mass_kg:.3g} kg"
    text = f"{first}: {mass}, {depth}"
    parts = []
    if data.before is not None:
        parts.append("grey: cut")
    if data.repairs:
        parts.append("yellow: repaired, open circles the values before")
    if math.inf in data.added_mass:
        parts.append("dashed: infinite frequency")
    if data.problems:
        parts.append("REFUSED: " + data.problems[0])
    return text + "\n" + "; ".join(parts)


def _some(headings: list[float]) -> list[float]:
    """Seven headings at most, the first and the last among them."""
    if len(headings) <= 7:
        return headings
    return [headings[round(k * (len(headings) - 1) / 6)] for k in range(7)]


def _scale(values: Any) -> tuple[float, str]:
    most = float(np.abs(np.asarray(values, float)).max(initial=0.0))
    return next(((power, prefix) for power, prefix in _LARGER if most >= power), (1.0, ""))


def _matrix(ax: Any, data: Hydrodynamics, omegas: list[float], k: int, name: str, title: str, unit: str) -> None:
    matrices = getattr(data, name)
    values = np.array([matrices[w][k][k] for w in omegas])
    known = list(values)
    before = data.before
    old = None
    if before is not None and len(before.omega):
        old = (before.added if name == "added_mass" else before.damping)[:, k, k]
    factor, prefix = _scale(known if len(known) else old if old is not None else [])
    if old is not None and before is not None:
        _grey(ax, before.omega, old / factor, omegas)
    ax.plot(omegas, values / factor, ".-", color=_COLOURS[0], markersize=2.5, linewidth=1.0)
    if name == "added_mass" and math.inf in matrices:
        ax.axhline(matrices[math.inf][k][k] / factor, color=_COLOURS[0], linewidth=0.8, linestyle="--")
    for repair in data.repairs:
        if k in repair.motions and repair.omega_radps in matrices:
            if old is not None and before is not None:
                row = int(np.argmin(np.abs(before.omega - repair.omega_radps)))
                ax.plot(before.omega[row], old[row] / factor, "o", color=_REPAIR, markersize=4.5, fillstyle="none", zorder=4)
            ax.plot(repair.omega_radps, matrices[repair.omega_radps][k][k] / factor, "o", color=_REPAIR, markersize=4.5, zorder=5)
    _named(ax, title, prefix, unit)
    # What was cut may be far off: the picture is scaled by what is used.
    _limit(ax, values / factor)


def _headings(ax: Any, waves: list[float], values: dict[float, list[float]], title: str, unit: str) -> None:
    factor, prefix = _scale([value for own in values.values() for value in own])
    ax.fenderline_factor = factor
    for colour, (heading, own) in zip(_COLOURS, values.items(), strict=False):
        ax.plot(waves, np.array(own) / factor, "-", color=colour, linewidth=0.9, label=f"{heading:g}")
    _named(ax, title, prefix, unit)
    _limit(ax, np.array([value for own in values.values() for value in own]) / factor)


def _grey(ax: Any, omegas: Any, values: Any, used: list[float]) -> None:
    factor = getattr(ax, "fenderline_factor", 1.0)
    ax.plot(omegas, np.asarray(values, float) / factor, ".-", color=_CUT, markersize=2.5, linewidth=0.7, zorder=0)


def _limit(ax: Any, values: Any) -> None:
    if len(values):
        low, high = min(0.0, float(values.min())), max(0.0, float(values.max()))
        width = (high - low) or 1.0
        ax.set_ylim(low - 0.15 * width, high + 0.12 * width)


#: Thousands of kilogrammes by their own names.
_TONNES = {"kkg": "t", "Mkg": "kt", "Gkg": "Mt"}


def _named(ax: Any, title: str, prefix: str, unit: str) -> None:
    first, *rest = f"{prefix}{unit}".split(" ")
    unit = " ".join([_TONNES.get(first, first), *rest])
    ax.set_title(f"{title} [{unit}]", fontsize=8, loc="left")


def _marks(ax: Any, data: Hydrodynamics, used: list[float], end: float) -> None:
    """Shades what was cut."""
    if data.before is None or not used:
        return
    low, high = min(used), max(used)
    if high < end * (1 - 1e-9):
        ax.axvspan(high, end * 1.05, color=_CUT, alpha=0.35, zorder=-2, linewidth=0)
    first = min([*data.before.omega, *data.before.wave_omega], default=low)
    if first < low * (1 - 1e-9):
        ax.axvspan(0.0, low, color=_CUT, alpha=0.35, zorder=-2, linewidth=0)


def _write(figure: Any, path: Path) -> None:
    try:
        figure.savefig(path)
    except OSError as error:
        raise HydrodynamicsError(f"the picture cannot be written: {error}", path) from error
