"""Exceptions of the client of a live session."""

from __future__ import annotations

from fenderline._errors import Error


class LiveError(Error):
    """Base class of the errors of a client of a live session."""


class LinkError(LiveError, ValueError):
    """The link is no link of a live session, or the server does not know its token."""


class FullError(LiveError):
    """The server has no seat free for another client."""


class ProtocolError(LiveError):
    """The server speaks another version of the protocol than this package."""

    def __init__(self, server: int, client: int) -> None:
        super().__init__(
            f"the server speaks version {server} of the protocol, and this package version {client}: "
            "use the package and the program of one release"
        )
        self.server = server
        """Version of the server."""
        self.client = client
        """Version of this package."""


class DisconnectedError(LiveError, ConnectionError):
    """The connection has ended, and did not come back in time: the session is over, or the network is broken."""


class SessionChangedError(LiveError):
    """The instructor has opened another scenario or session: names and numbers of ships are others now."""


class RefusedError(LiveError):
    """The server refused a command, which has changed nothing. The text is the server's."""


class RoleError(RefusedError):
    """The link does not open what was asked for, such as the helm of another ship."""


class HelmError(RefusedError):
    """Somebody else has the helm: a person has taken it, or another program holds it."""
