"""How rubber gives back less than it took.

Loading stores U, the curve that the force comes down to stores U_u; D = U - U_u. The force is R_u + z (R - R_u), with z a
sum of plays in D (Prandtl and Ishlinskii's model of hysteresis): each falls from 1 to 0 while D loses a share of the top
that it came to, and rises the same way. No play knows of time.
"""

from .quantities import Curve, si

# (Width over the top, share in z).
WIDTHS = (1 / 10, 1 / 80, 1 / 640)
PLAYS = [(width, width / sum(WIDTHS)) for width in WIDTHS]
# Of D, what the plays give back.
GIVEN_BACK = sum(0.5 * width * share for width, share in PLAYS)


class Unloading:
    """Either a share of the energy that a whole loop returns, or the curve that the reaction comes down to."""

    def __init__(self, returned=None, points=None, loading=None):
        self.share = None if returned is None else max((returned - GIVEN_BACK) / (1.0 - GIVEN_BACK), 0.0)
        self.lower = None
        if points is not None:
            self.lower, self.end = Curve(points), points[-1][0]
            reaction, self.end_stored = loading.at(self.end)
            self.beyond = min(points[-1][1] / reaction, 1.0) if reaction > 0.0 else 1.0

    def lower_branch(self, deflection, spring, stop, loading):
        """Force and energy of the lower branch, from (force, energy) of loading by spring and by stop."""
        if self.lower is None:
            return self.share * (spring[0] + stop[0]), self.share * (spring[1] + stop[1])
        reaction, stored = loading.at(deflection)
        if deflection <= self.end:
            lower, lower_stored = self.lower.at(deflection)
            lower = min(lower, reaction)
        else:
            lower = self.beyond * reaction
            lower_stored = self.lower.at(self.end)[1] + self.beyond * (stored - self.end_stored)
        part = lower / reaction if reaction > 0.0 else 1.0
        return part * spring[0] + self.beyond * stop[0], lower_stored + self.beyond * stop[1]

    def share_left(self, tops, deflection, spring, stop, loading):
        """Force over that of loading; `tops` (one a play, empty for a new contact) move."""
        lower, lower_stored = self.lower_branch(deflection, spring, stop, loading)
        between = max(spring[1] + stop[1] - lower_stored, 0.0)
        if not tops:
            tops[:] = [between] * len(PLAYS)
        z = 0.0
        for index, (width, share) in enumerate(PLAYS):
            top = tops[index] = min(max(tops[index], between), between / (1.0 - width))
            z += share * (max(1.0 - (top - between) / (width * top), 0.0) if top > 0.0 else 1.0)
        whole = spring[0] + stop[0]
        return (lower + min(z, 1.0) * (whole - lower)) / whole


def unloading_of(table, family, scale, loading):
    """The law that a scenario's fender table asks for, or its family has; None without one."""
    if not table.get("unloading_law", True):
        return None
    if "returned_energy" in table:
        return Unloading(returned=si(table["returned_energy"]))
    if "unloading" in table:
        return Unloading(points=[(si(d), si(r)) for d, r in table["unloading"]], loading=loading)
    own = family.get("unloading", {})
    if "returned_energy" in own:
        return Unloading(returned=si(own["returned_energy"]))
    if "points" in own:
        points = [(si(d) * scale[0], si(r) * scale[1]) for d, r in own["points"]]
        return Unloading(points=points, loading=loading)
    return None
