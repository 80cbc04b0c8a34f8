"""Profiles end at the heights and radii that are drawn, and nowhere else."""

from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.cells.surfaces_of_revolution import ArcProfile, LineProfile
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.hypotheses.profile_ends import ProfileEnds
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype

NEAR = 0.1
WHOLE = {Role.TOP: (Interval(0.0, 6.2831, Linetype.VISIBLE, 1.0),)}
ENDS = ProfileEnds.of(
    (0.0, 20.0, 24.0),
    [Carrier(Circle((5.0, 5.0), radius), WHOLE) for radius in (4.0, 7.0)],
    NEAR,
)
OFF = st.floats(-0.09, 0.09)


@given(OFF, OFF, OFF, OFF)
def test_a_cone_between_two_circles_ends_at_them(a: float, b: float, c: float, d: float) -> None:
    read = LineProfile(20.0 + a, 24.0 + b, 4.0 + c, 7.0 + d)
    assert ENDS.met_by(read) == LineProfile(20.0, 24.0, 4.0, 7.0)


@given(OFF)
def test_a_drill_s_tip_is_on_its_axis_at_its_own_height(off: float) -> None:
    read = LineProfile(17.5, 20.0 + off, abs(off), 4.0)
    assert ENDS.met_by(read) == LineProfile(17.5, 20.0, 0.0, 4.0)


def test_what_ends_elsewhere_stays() -> None:
    for item in (LineProfile(2.0, 10.0, 1.0, 3.0), LineProfile(20.2, 23.8, 4.3, 6.7)):
        assert ENDS.met_by(item) == item
    # A cone that would become a cylinder, or a disc, is left as it was read.
    flat = LineProfile(0.0, 20.0, 4.04, 3.96)
    assert ENDS.met_by(flat) == flat
    thin = LineProfile(19.95, 20.05, 4.0, 7.0)
    assert ENDS.met_by(thin) == thin


def test_an_arc_ends_where_its_circle_says() -> None:
    read = ArcProfile(20.03, 23.98, 20.0, 3.0, 4.0, 1)
    assert ENDS.met_by(read) == read
