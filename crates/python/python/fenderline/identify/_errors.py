"""What is wrong with a track, a trial or a fit."""

from __future__ import annotations

from pathlib import Path

from fenderline._errors import Error


class IdentifyError(Error, ValueError):
    """An identification that cannot begin or go on: an unknown coefficient, a bad bound, a trial that does not run."""


class TrackError(IdentifyError):
    """A measured track that cannot be used, with file and line."""

    file: str
    """The file."""
    line: int | None
    """Line of the file, from 1; ``None`` if the error is not in a single line."""
    message: str
    """The mistake, without file and line."""

    def __init__(self, message: str, file: str | Path, line: int | None = None) -> None:
        self.file = str(file)
        self.line = line
        self.message = message
        place = self.file if line is None else f"{self.file}:{line}"
        super().__init__(f"{place}: {message}")


def missing() -> IdentifyError:
    """The error where SciPy is not installed."""
    return IdentifyError('identification needs SciPy: pip install "fenderline[identify]"')
