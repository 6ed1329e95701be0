"""Numbers of text files, each row with its line."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path

from fenderline.hydrodynamics._errors import HydrodynamicsError

#: Fortran leaves the letter of a three-digit exponent out: 0.123-104.
_NO_LETTER = re.compile(r"^([-+]?[0-9.]+)([-+][0-9]{3})$")


def lines(path: Path) -> list[str]:
    """The lines of a text file; bytes that are no UTF-8 (names of licensees) are replaced."""
    try:
        return path.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError as error:
        raise HydrodynamicsError(f"the file cannot be read: {error.strerror or error}", path) from None


def number(cell: str) -> float:
    """A number as Fortran and C write it. A field of asterisks is one that did not fit: not a number.

    >>> number("-1.5D+01"), number("0.5-101")
    (-15.0, 5e-102)
    """
    if cell and set(cell) == {"*"}:
        return math.nan
    text = cell.replace("D", "E").replace("d", "e")
    found = _NO_LETTER.match(text)
    return float(f"{found[1]}e{found[2]}" if found else text)


def value(cell: str, path: Path, line: int | None = None) -> float:
    """The number in a cell."""
    try:
        return number(cell)
    except ValueError:
        raise HydrodynamicsError(f"there must be a number, but there is {cell[:40]!r}", path, line) from None


def numbers(line: str) -> list[float] | None:
    """The numbers of a line, or `None` if a cell is none."""
    try:
        return [number(cell) for cell in line.replace(",", " ").split()]
    except ValueError:
        return None


def rows(path: Path, widths: tuple[int, ...]) -> Iterator[tuple[int, list[float]]]:
    """The rows of a table with their lines. Text is a header before the first row of numbers, and a mistake after it."""
    begun = False
    for index, line in enumerate(lines(path), 1):
        if not line.strip():
            continue
        row = numbers(line)
        if row is None or len(row) not in widths:
            if not begun and row is None:
                continue
            expected = " or ".join(str(width) for width in widths)
            found = "text" if row is None else f"{len(row)}"
            raise HydrodynamicsError(f"a row must have {expected} numbers, but has {found}: {line.strip()[:60]!r}", path, index)
        begun = True
        yield index, row
    if not begun:
        raise HydrodynamicsError("the file has no row of numbers", path)


def sibling(folder: Path, *names: str) -> Path | None:
    """A file of a folder, whatever the case of its name."""
    if not folder.is_dir():
        return None
    known = {entry.name.lower(): entry for entry in sorted(folder.iterdir())}
    return next((known[name.lower()] for name in names if name.lower() in known), None)


def index_of(value: float, most: int, what: str, path: Path, line: int) -> int:
    """A whole number from 1 to `most`."""
    if not (math.isfinite(value) and value == int(value) and 1 <= value <= most):
        raise HydrodynamicsError(f"{what} must be a whole number from 1 to {most}, but is {value:g}", path, line)
    return int(value)
