"""What is wrong with files of panel codes, with file and line."""

from __future__ import annotations

from pathlib import Path

from fenderline._errors import Error


class HydrodynamicsError(Error, ValueError):
    """Files of a panel code from which no data can be made, with the place and the reason."""

    file: str | None
    """The file, if the mistake is in a single one."""
    line: int | None
    """The line of the file, from 1, if the mistake is in a single line."""
    message: str
    """The mistake, without its place."""

    def __init__(self, message: str, file: str | Path | None = None, line: int | None = None) -> None:
        self.file = None if file is None else str(file)
        self.line, self.message = line, message
        place = "" if file is None else f"{file}: " if line is None else f"{file}:{line}: "
        super().__init__(place + message)


class HydrodynamicsWarning(UserWarning):
    """What was cut, filled, repaired or left out of the data of a panel code, and doubts about them."""
