"""Drawings on a sheet that are none of the principal views: recognised by name, left out."""
