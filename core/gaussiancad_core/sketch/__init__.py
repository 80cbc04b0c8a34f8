"""A part sketched softly: slabs of regions of a view, chosen by all lines together."""
