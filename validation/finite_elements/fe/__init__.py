"""Fenders by finite elements, for `analyse.py`."""
