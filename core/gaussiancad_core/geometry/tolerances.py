"""How exactly numbers are known: the one noise model of the solver.

Numbers come from three sources, and each has its own scale.

* *Computed*: what follows from other numbers in double precision.  Lengths are in units, hundredths
  of the part's longest extent, or in mm; a sine, a component of a unit vector or an angle in
  radians counts the same.  The geometry kernel takes points for one within 1e-7.
* *Constructed*: where a point is looked up beside a curve, or how short an edge may be.  It has to
  be far above what is computed, and far below what is drawn.
* *Read*: what a line of a view shows.  Its scale is the view's tolerance, the error that hardly any
  reading exceeds: a pixel for pictures, the rounding of its numbers for a file.
"""

COMPUTED = 1e-6
"""Within which two computed numbers are one: ten times what the kernel takes for one point."""

UNIT_VECTOR = 1e-9
"""By which products of unit vectors, and distances from an axis, are off by rounding alone."""

ON_CURVE = 1e-5
"""Units within which a constructed point is on a curve: ten computed steps."""

ASIDE = 2e-5
"""Units beside a curve at which its two sides are looked up: clear of what is on it."""

SHORTEST = 1e-3
"""Units, or mm, that an edge is long at least: closer points are one."""

SAME_PLACE = 0.01
"""Units within which a computed curve is one that is drawn, and two places are one, at least."""

APART = 0.05
"""Units from which lines are two, and what lies between them is more than their noise, at least."""

FAR = 1e3
"""Units; farther than any part, which is 100 long."""

WELL_READ = 0.5
"""Tolerances within which a point that is well known lies on a line."""

SAME_READ = 1.5
"""Tolerances within which two views, or a line and a number, show the same: the difference of two
readings is the root of two of one."""

MOVED = 2.5
"""Tolerances by which adjustment moves a reading at most: an equation that asks for more is wrong.
"""

MEETING = 3.0
"""Tolerances within which ends that were read meet, or lie on a curve: the crossing of two readings
at a slant misses by more than either."""

LEVEL = 1e-3
"""Slope up to which a line runs along an axis, and share of a line within which another follows."""

TELLING = 4.0
"""Tolerances of a length, a radius or a rise from which it tells something: less may be noise."""
