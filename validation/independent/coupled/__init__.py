"""The coupled contact method, written a second time: plain Python, small fixed steps, standard library only.

It shares no code with the engine and computes the same definitions in other ways:

- Bodies are moved by their *momentum* in earth-fixed axes, Kirchhoff's equations in impulse form (Lamb, Hydrodynamics,
  6th edition, article 124): dP/dt = F, dH/dt = Q - v x P, with v = M(heading)^-1 P. Symplectic Euler in fixed steps far
  below every natural period; no sub-steps (`bodies.py`, `simulation.py`).
- A fender is a row of springs under the hull's boundary (`fenders.py`).
- Overlaps are found by tracing both boundaries, for any simple polygons; no convex pieces (`polygons.py`, `outlines.py`).
- The normal forces of a step solve the box-constrained quadratic programme that defines the method, by
  coordinate descent to rounding (`simulation.py`).

Axes: x north, y east, angles from x to y; SI units.
"""
