"""What lines of sight of a view meet of a solid, where the view is cut open."""

import numpy as np
import shapely

from gaussiancad_core.judging.drawn_lines import DrawnView
from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats, Numbers
from gaussiancad_core.judging.lines_of_sight import Met, crossings, cut_open


def with_cut(solid: FacetedSolid) -> Numbers:
    """The solid's surfaces, and one more for what a plane cuts."""
    return np.append(solid.smooth, len(solid.smooth))


def met_in(solid: FacetedSolid, view: DrawnView, places: Floats) -> Met:
    """What lines of sight at (n, 2) places of a view, mm (right, up), meet of a solid."""
    met = crossings(solid, view.role.frame, places)
    return opened(met, view, places, len(solid.smooth))


def opened(met: Met, view: DrawnView, places: Floats, cut: int) -> Met:
    """What is met in a view where it is cut open; ``cut`` is the number of what is cut."""
    if view.cut is None:
        return met
    return cut_open(met, cut_depths(view, places), cut)


def cut_depths(view: DrawnView, places: Floats) -> Floats:
    """(n,) mm along the look where a view is cut at places; NaN where it is not."""
    depths = np.full(len(places), np.nan)
    if view.cut is None:
        return depths
    sign = view.role.frame.look_axis[1]
    for opening in reversed(view.cut.openings):
        inside = (
            np.ones(len(places), bool)
            if opening.region is None
            else shapely.contains_xy(opening.region, places[:, 0], places[:, 1])
        )
        depths[inside] = sign * opening.at
    return depths
