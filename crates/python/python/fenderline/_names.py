"""Messages for names that do not exist."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


def unknown(what: str, name: object, known: Iterable[str]) -> str:
    """What to say of a name that is not known.

    >>> unknown("table", "bodys", ["bodies", "contacts"])
    "there is no table 'bodys': did you mean 'bodies'? There are: bodies, contacts"
    """
    names = list(known)
    near = difflib.get_close_matches(str(name), names, n=1)
    hint = f": did you mean {near[0]!r}? There are: " if near else "; there are: "
    return f"there is no {what} {name!r}{hint}{', '.join(names) or 'none'}"


class UnknownName(KeyError):
    """A name that does not exist; its text is not put in quotes, as that of a plain ``KeyError`` is."""

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""
