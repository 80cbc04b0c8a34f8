import pytest

from gaussiancad_core.files.file_linetypes import role_by_dashes, role_by_name, stroke_role
from gaussiancad_core.files.vectors import StrokeRole

HIDDEN, CENTRE, OTHER = StrokeRole.HIDDEN, StrokeRole.CENTRE, StrokeRole.OTHER
VISIBLE, UNKNOWN = StrokeRole.VISIBLE, StrokeRole.UNKNOWN
HATCH = StrokeRole.HATCH


@pytest.mark.parametrize(
    ("name", "role"),
    [
        ("HIDDEN2", HIDDEN),
        ("DASHEDX2", HIDDEN),
        ("ACAD_ISO02W100", HIDDEN),
        ("JIS_02_1.0", HIDDEN),
        ("VERDECKT", HIDDEN),
        ("Strichlinie", HIDDEN),
        ("INVISIBLE EDGES", HIDDEN),
        ("虚线层", HIDDEN),
        ("CENTERX2", CENTRE),
        ("Centre", CENTRE),
        ("DASHDOT2", CENTRE),
        ("STRICHPUNKT", CENTRE),
        ("ACAD_ISO04W100", CENTRE),
        ("AXES", CENTRE),
        ("中心线层", CENTRE),
        ("PHANTOM2", OTHER),
        ("双点划线层", OTHER),
        ("ACAD_ISO05W100", OTHER),
        ("DIM", OTHER),
        ("标注层", OTHER),
        ("Hatching", HATCH),
        ("Schraffur", HATCH),
        ("剖面线层", HATCH),
        ("Штриховка", HATCH),
        ("Штриховая", HIDDEN),
        ("VISIBLE (ISO)", VISIBLE),
        ("轮廓实线层", VISIBLE),
        ("Continuous", None),
        ("0", None),
        ("", None),
    ],
)
def test_names(name: str, role: StrokeRole | None) -> None:
    assert role_by_name(name) is role


@pytest.mark.parametrize(
    ("dashes", "role"),
    [
        ((), UNKNOWN),
        ((6, 3), HIDDEN),
        ((6, 3, 5, 3), HIDDEN),
        ((20, 3, 4, 3), CENTRE),
        ((4, 3, 20, 3), CENTRE),
        ((20, 3, 0, 3), CENTRE),
        ((20, 3, 4, 3, 20, 3, 4, 3), CENTRE),
        ((20, 3, 4, 3, 4, 3), OTHER),
        ((0, 3), OTHER),
    ],
)
def test_dashes(dashes: tuple[float, ...], role: StrokeRole) -> None:
    assert role_by_dashes(dashes) is role
    assert role_by_dashes(tuple(value / 7 for value in dashes)) is role


def test_dashed_lines_are_what_their_linetype_says_and_solid_ones_what_their_layer_says() -> None:
    assert stroke_role("X", "CENTER", (6, 3)) is HIDDEN
    assert stroke_role("CENTER", "HIDDEN", (6, 3)) is CENTRE
    assert stroke_role("Continuous", "HIDDEN", ()) is HIDDEN
    assert stroke_role("Continuous", "0", ()) is VISIBLE
