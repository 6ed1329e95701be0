"""Units of the columns of a track."""

from __future__ import annotations

import math
import re

#: For each dimension the SI value of its units; the first is the unit of a column that states none.
UNITS: dict[str, dict[str, float]] = {
    "time": {"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0},
    "length": {"m": 1.0, "km": 1e3, "cm": 1e-2, "ft": 0.3048, "nmi": 1852.0},
    "angle": {"deg": math.pi / 180.0, "°": math.pi / 180.0, "rad": 1.0},
    "share": {"1": 1.0, "%": 1e-2},
}


def factor(unit: str, dimension: str) -> float | None:
    """The SI value of a unit, or ``None`` if the dimension has no such unit.

    >>> factor("ft", "length"), factor("kn", "length")
    (0.3048, None)
    """
    return UNITS[dimension].get(unit.strip())


def quantity(value: object, dimension: str) -> float | None:
    """A number with its unit as SI value; a plain number is in SI units; ``None`` if it is neither.

    >>> quantity("2 min", "time"), quantity(3, "time"), quantity("3 kn", "time")
    (120.0, 3.0, None)
    """
    if isinstance(value, bool):
        return None
    if isinstance(value, int | float):
        return float(value) if math.isfinite(value) else None
    found = re.fullmatch(r"\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*(\S+)\s*", str(value))
    of = None if found is None else factor(found[2], dimension)
    if found is None or of is None:
        return None
    try:
        return float(found[1]) * of
    except ValueError:
        return None
