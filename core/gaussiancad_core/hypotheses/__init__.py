"""Boundaries that may exist although no line, or another line, is drawn for them."""
