"""What is wrong with charts and surveys, with the file."""

from __future__ import annotations

from pathlib import Path

from fenderline._errors import Error


class ChartError(Error, ValueError):
    """A chart or survey that cannot be converted, with the file and the reason."""

    file: str | None
    """The file, if the mistake is in a single one."""
    message: str
    """The mistake, without the file."""

    def __init__(self, message: str, file: str | Path | None = None) -> None:
        self.file = None if file is None else str(file)
        self.message = message
        super().__init__(message if file is None else f"{file}: {message}")


def missing(package: str) -> ChartError:
    """The error for a package of the extra ``charts`` that is not installed."""
    return ChartError(f'the package {package} is missing: pip install "fenderline[charts]"')
