"""Curves, intervals and tolerances of planes, without views or solids."""
