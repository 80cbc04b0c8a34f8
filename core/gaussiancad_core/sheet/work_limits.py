"""How much is looked at, so that a crowded sheet takes seconds: more is no drawing of a part."""

ENDS = 400
"""Ends, or corners, of a view that are each compared with all others."""

PLACES = 4000
"""Places along one stroke, or pixels of one fit."""
