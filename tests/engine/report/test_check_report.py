"""What ``check.json`` says of places: those of the sheet, and those of the model itself."""

from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.judging.difference_kinds import Kind
from gaussiancad_core.judging.difference_places import Difference
from gaussiancad_core.judging.drawn_lines import DrawnView
from gaussiancad_core.judging.faceted_solids import FacetedSolid
from gaussiancad_core.judging.laying import Laid, Pose
from gaussiancad_core.judging.misfits import Misfit
from gaussiancad_core.judging.model_edits import Edit
from gaussiancad_core.judging.sheet_judgement import SheetJudgement
from gaussiancad_core.judging.verdicts import Judgement, Reason, Verdict
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.report.check_report import check_values
from gaussiancad_protocol.codes import Code

_SIZE = (60.0, 40.0, 30.0)
"""mm of the sheet."""

_TURN = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
"""A quarter about z: the model's y runs along the sheet's x, its x against the sheet's y."""

_POSE = Pose(0.5 * _TURN, np.array([5.0, 40.0, -10.0]), 2.0, np.zeros(3))
"""Of a model twice as large, whose corner is at (0, -10, 20) mm."""


def _solid() -> FacetedSolid:
    """The corners of the sheet's box, which are all that is asked of it."""
    none = np.zeros(0, np.int64)
    corners = np.array([(0.0, 0.0, 0.0), _SIZE])
    triangles, edges = np.zeros((0, 3), np.int64), np.zeros((0, 2, 3))
    return FacetedSolid(corners, triangles, none, none, edges, none)


def _found(role: Role, pieces: list[list[list[float]]]) -> SheetJudgement:
    view = DrawnView(role, (), draws_hidden=False)
    difference = Difference(view, Kind.MISSING, 7.0, np.array(pieces), 0, -1)
    laid = Laid(_POSE, _solid(), Misfit((), 100.0))
    return SheetJudgement(Judgement(Verdict.DIFFERS), None, laid, (difference,))


def _values(found: SheetJudgement) -> dict:
    return check_values(found, lambda points: points, "given", [])


@pytest.mark.parametrize(
    ("role", "piece", "expected"),
    [
        # Two places of a view (right, up), and the same on the model: its box is 80 x 120 x 60 mm
        # with its corner at (0, -10, 20).
        (Role.FRONT, [[0, 0], [60, 30]], [[80, -10, 20], [80, 110, 80]]),
        (Role.REAR, [[0, 0], [-60, 30]], [[0, -10, 20], [0, 110, 80]]),
        (Role.TOP, [[0, 0], [60, 40]], [[80, -10, 80], [0, 110, 80]]),
        (Role.BOTTOM, [[0, 0], [60, -40]], [[80, -10, 20], [0, 110, 20]]),
        (Role.RIGHT, [[0, 0], [40, 30]], [[80, 110, 20], [0, 110, 80]]),
        (Role.LEFT, [[0, 0], [-40, 30]], [[80, -10, 20], [0, -10, 80]]),
    ],
)
def test_pieces_lie_on_the_side_of_the_model_that_is_nearest_to_the_viewer(
    role: Role, piece: list[list[float]], expected: list[list[float]]
) -> None:
    (difference,) = _values(_found(role, [piece, piece]))["differences"]
    assert difference["model"] == [expected, expected]


def test_the_pose_in_the_file_leads_from_the_model_to_the_pieces() -> None:
    found = _found(Role.FRONT, [[[12.5, 3.0], [40.0, 3.0]]])
    values = _values(found)
    (piece,) = values["differences"][0]["model"]
    matrix = np.array(values["pose"]["matrix"])
    laid = np.array([*zip(*piece, strict=True), (1.0, 1.0)])
    x, y, z, _ = matrix @ laid
    np.testing.assert_allclose([x, z], [[12.5, 40.0], [3.0, 3.0]], atol=1e-9)
    np.testing.assert_allclose(y, 0.0, atol=1e-9)


def test_a_change_has_its_places_on_the_model_and_its_diameter() -> None:
    edit = Edit("move", "hole of 10 mm", (15.0, 12.0, 15.0), (20.0, 12.0, 15.0), 8.0, 10.0)
    values = _values(replace(_found(Role.FRONT, [[[0.0, 0.0], [1.0, 0.0]]]), edits=(edit,)))
    (change,) = values["edits"]
    assert change["from"] == (15.0, 12.0, 15.0)
    assert change["model_from"] == [56.0, 20.0, 50.0]
    assert change["model_to"] == [56.0, 30.0, 50.0]
    assert change["diameter_mm"] == 10.0


def test_a_change_without_a_place_has_none_on_the_model() -> None:
    edit = Edit("mirror", "the whole part", None, None, 8.0)
    values = _values(replace(_found(Role.FRONT, [[[0.0, 0.0], [1.0, 0.0]]]), edits=(edit,)))
    (change,) = values["edits"]
    assert (change["model_from"], change["model_to"], change["diameter_mm"]) == (None, None, None)


def test_reasons_keep_the_values_of_their_sentences() -> None:
    message = Message("{factor:.4g} times as large", factor=2.0)
    judgement = Judgement(Verdict.DIFFERS, (Reason(Code.SIZE_DIFFERS, message),))
    assert _values(SheetJudgement(judgement))["reasons"] == [
        {"code": "size-differs", "message": "2 times as large", "args": {"factor": 2.0}}
    ]
