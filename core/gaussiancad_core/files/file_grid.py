"""How far a file's coordinates were rounded when it was written: measured, not guessed.

Programs write the ends of lines on a grid: whole steps of a plotter, or a few decimals.  What is
rounded are the numbers of the file itself, before any matrix; so lines are asked in those, all that
are drawn at one scale together.  Two lines of a part that ought to be one then lie up to a step
apart, and nothing in a view tells: views that stand in a row are rounded alike.

A design in round measures lies on a grid too, and is rounded to nothing.  These tell the two
apart.

- Lines askew: where arrow heads, letters, chords of curves and slanted edges end follows from
  angles and lengths, not from round numbers.  They are on a grid only if they were put there.
  Where a file has enough of them, they are asked first, and what they do not lie on is none.
- Size: nobody prints on a grid that one sees.  A coarser one is the design's; had a finer one
  rounded it besides, then to where it was.
- Views stand anywhere on a sheet: what is round within each is on no common grid, unless on a finer
  one.  Lengths do not depend on that: those of a round design have a step that is too long to print
  on.

Few lines, all of them along the axes, cannot tell.  Then the grid on which they lie is taken for
rounding where it is fine enough to be: the bound of measures is wider than it need be, not narrower
than it may be.  Of still fewer only the last decimal is asked, and so it is of all but the few
scales at which most is drawn: measuring takes its time.
"""

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.lattices import Fit, common_step, decimal_step
from gaussiancad_core.files.vectors import VectorStroke

Floats = npt.NDArray[np.float64]

Strokes = Callable[[float], Sequence[VectorStroke]]
"""Strokes in px of the sheet, by the px of the step to which their places were rounded."""

_FINEST_PX, _COARSEST_PX = 0.01, 0.7
"""px of steps that are looked for, at 200 dpi: finer ones are a fifth of the tolerance of exact
lines; 300 to the inch, two thirds of a px, is the coarsest that printers have, and a tenth of a
millimetre, more than that, the finest that parts are often designed in and drawn 1:1."""

_FEWEST_ASKEW, _NEAR_ASKEW, _ON_ASKEW = 24, 0.05, 0.6
"""Different places of lines askew, across and up together, that tell of a grid, steps that they may
be off, and share of them that is not: title blocks, letters and circles may have been put on the
sheet as they were.  By chance a tenth is as near, six of ten of the fewest once in 10^8 times; of
exact drawings up to a half was, on the grid that fits best."""

_FEWEST, _NEAR, _ON = 12, 0.01, 0.9
"""The same of lines along the axes, where no others tell."""

_ON_DESIGN, _CHANCE = 0.6, 1e-3
"""Share of the lengths of these that are multiples of the design's step, at least, and probability
at which so many are that were rounded to a shorter one."""

_MOST = 0.5
"""Share of the lines at a scale from which one matrix drew most of them."""

_LEVEL = 1e-3
"""px by which the ends of a line are apart in both directions that runs askew, and by which it
misses half a right angle."""

_SAME_SCALE = 4
"""Digits of the scale at which lines are asked together."""

_MOST_SCALES = 8
"""Scales whose lines are measured, a second each at most: those at which most lines are drawn."""


@dataclass(frozen=True, eq=False)
class WrittenPath:
    """What a file draws at once.

    Attributes:
        strokes: that it draws.
        ends: (n, 2, 2) both ends of its straight pieces, across and up, in the numbers of the file.
        matrix: (2, 3) from these to px.
    """

    strokes: Strokes
    ends: Floats
    matrix: Floats

    @property
    def scale(self) -> float:
        """px that a unit of the file is long."""
        return scale_of(self.matrix)


def scale_of(matrix: Floats) -> float:
    """How much longer a (2, 3) affine map makes lengths, in the geometric mean."""
    (a, b, _), (c, d, _) = matrix.tolist()
    return math.sqrt(abs(a * d - b * c))


def rounding_step(ends: Floats, scale: float) -> float:
    """px of the step to which the ends of lines were rounded, each by itself; 0 of exact ones.

    Args:
        ends: (n, 2, 2) both ends of each, across and up, in the numbers of the file.
        scale: px of the sheet that one of its units is long.
    """
    if not scale or not len(ends):
        return 0.0
    finest = _FINEST_PX / scale
    every = _places(ends, finest)
    askew = _places(ends[_askew(ends * scale)], finest)
    if _count(askew) >= _FEWEST_ASKEW:
        fit = Fit(_NEAR_ASKEW, _ON_ASKEW, finest)
        step = common_step(askew, finest, fit)
        if step and fit.share(every, step) < _ON_ASKEW:
            step = 0.0
    elif _count(every) >= _FEWEST:
        step = _step_along_axes(every, _lengths(ends, finest), scale)
    else:
        step = decimal_step(np.concatenate(every))
    return _believable(step * scale)


def _last_decimal(ends: Floats, scale: float) -> float:
    """px of the unit of the last decimal in which the ends of lines are written; 0 of exact ones.

    Args:
        ends, scale: see :func:`rounding_step`.
    """
    return _believable(decimal_step(ends.ravel()) * scale) if scale else 0.0


def _believable(length: float) -> float:
    """px of a step that files are rounded to, else 0."""
    return length if _FINEST_PX <= length <= _COARSEST_PX else 0.0


def _step_along_axes(places: tuple[Floats, Floats], lengths: Floats, scale: float) -> float:
    """The step of lines along the axes, in numbers of the file.

    Lengths do not depend on where a view stands: if most are multiples of a step that is too long
    to print on, it is the design's.
    """
    finest = _FINEST_PX / scale
    step = common_step(places, finest, Fit(_NEAR, _ON, finest))
    if not step:
        return 0.0
    # Counted from nought: with their opposites they have no other middle.
    both = [np.concatenate([-lengths[::-1], lengths])]
    fit = Fit(_NEAR, _ON_DESIGN, finest)
    design = common_step(both, finest, fit)
    if design * scale <= _COARSEST_PX:
        return step
    # Few files ask for it, and it takes longer to load than most of them to read.
    from scipy.special import bdtrc

    count = len(lengths)
    chance = bdtrc(round(fit.share(both, design) * count) - 1.0, count, step / design)
    return 0.0 if chance < _CHANCE else step


def with_steps(paths: Sequence[WrittenPath]) -> tuple[VectorStroke, ...]:
    """The strokes of a file's paths in order, each with the step to which the ends of lines were
    rounded that are drawn at its scale.

    Programs that draw most of a sheet with one matrix put some shapes on it by matrices of their
    own, exact around their middles; but those are rounded.  Then only the rest is asked.
    """
    alike: dict[str, list[WrittenPath]] = defaultdict(list)
    # Most paths share a matrix.
    names = {
        id(path.matrix): f"{path.scale:.{_SAME_SCALE}g}"
        for path in {id(path.matrix): path for path in paths}.values()
    }
    for path in paths:
        alike[names[id(path.matrix)]].append(path)
    most = sorted(alike, key=lambda name: -sum(len(path.ends) for path in alike[name]))
    asked = {name: rounding_step for name in most[:_MOST_SCALES]}
    steps = {
        name: _step(written_paths, asked.get(name, _last_decimal))
        for name, written_paths in alike.items()
    }
    drawn = ((path, steps[names[id(path.matrix)]]) for path in paths)
    return tuple(
        replace(stroke, step=step) if step else stroke
        for path, step in drawn
        for stroke in path.strokes(step)
    )


def _step(paths: Sequence[WrittenPath], stated: Callable[[Floats, float], float]) -> float:
    """px of the step of paths at one scale, as it is told by ends and scale."""
    by_matrix: dict[bytes, list[Floats]] = defaultdict(list)
    for path in paths:
        by_matrix[path.matrix.tobytes()].append(path.ends)
    groups = [np.concatenate(items) for items in by_matrix.values()]
    most = max(groups, key=len)
    every = np.concatenate(groups)
    return stated(most if len(most) > _MOST * len(every) else every, paths[0].scale)


def line_ends(pieces: Iterable[Floats]) -> Floats:
    """(n, 2, 2) the ends of the straight ones of some pieces.

    Args:
        pieces: (2, 2) the ends of lines and (4, 2) Bézier curves.
    """
    straight = [piece for piece in pieces if len(piece) == 2]
    return np.concatenate(straight).reshape(-1, 2, 2) if straight else np.zeros((0, 2, 2))


def _askew(ends: Floats) -> npt.NDArray[np.bool_]:
    """(n,) which pieces run along neither an axis nor a diagonal; px."""
    across, up = np.abs(np.diff(ends, axis=1)[:, 0]).T
    return (across > _LEVEL) & (up > _LEVEL) & (np.abs(across - up) > _LEVEL)


def _places(ends: Floats, finest: float) -> tuple[Floats, Floats]:
    """Different coordinates across and up, in order."""
    every = (np.sort(ends[:, :, k].ravel()) for k in (0, 1))
    across, up = (values[np.diff(values, prepend=-np.inf) > 0.5 * finest] for values in every)
    return across, up


def _lengths(ends: Floats, finest: float) -> Floats:
    """Different lengths of lines along the axes, in order."""
    found = np.sort(np.abs(np.diff(ends, axis=1)).ravel())
    return found[np.diff(found, prepend=0.0) > 0.5 * finest]


def _count(places: tuple[Floats, Floats]) -> int:
    return sum(len(place) for place in places)
