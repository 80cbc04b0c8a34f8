"""Parts by chance that keep to a class of surfaces: what exact reconstruction is measured on."""

from sample_parts.classed.parts import LEVEL_FACES, PartClass, classed_part
from sample_parts.classed.surfaces import SurfaceKind, surface_kinds

__all__ = ["LEVEL_FACES", "PartClass", "SurfaceKind", "classed_part", "surface_kinds"]
