import pytest

from gaussiancad_core.files.file_linetypes import role_by_dashes, role_by_name, stroke_role
from gaussiancad_core.files.vectors import StrokeRole

HIDDEN, CENTRE, OTHER = StrokeRole.HIDDEN, StrokeRole.CENTRE, StrokeRole.OTHER
VISIBLE, UNKNOWN = StrokeRole.VISIBLE, StrokeRole.UNKNOWN
HATCH = StrokeRole.HATCH


@pytest.mark.parametrize(
    ("name", "role"),
    [
        (text, said)
        for said, texts in {
            HIDDEN: (
                "HIDDEN2|DASHEDX2|ACAD_ISO02W100|JIS_02_1.0|VERDECKT|Strichlinie|INVISIBLE EDGES|"
                "虚线层|Штриховая"
            ),
            CENTRE: "CENTERX2|Centre|DASHDOT2|STRICHPUNKT|ACAD_ISO04W100|AXES|中心线层",
            OTHER: "PHANTOM2|双点划线层|ACAD_ISO05W100|DIM|标注层",
            HATCH: "Hatching|Schraffur|剖面线层|Штриховка",
            VISIBLE: "VISIBLE (ISO)|轮廓实线层",
            None: "Continuous|0|",
        }.items()
        for text in texts.split("|")
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
