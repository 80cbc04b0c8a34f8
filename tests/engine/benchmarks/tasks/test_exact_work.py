from pathlib import Path

import numpy as np
import pytest

from benchmarks.methods.exact_peers import Peer, peer_mesh
from benchmarks.parts.exact_cases import USUAL_LEVELS, Case, classed_cases, folder_cases
from benchmarks.run.workers import Row
from benchmarks.sheets.exact_inputs import InputKind, kept_lines, make_input
from benchmarks.tasks.exact_tables import tables, time_picture
from benchmarks.tasks.exact_work import causes, close, falsely_verified, solved
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.samples.classed import LEVEL_FACES, PartClass
from gaussiancad_core.samples.modelling import box, cut, cylinder

EXACT: Row = {
    "group": "planes", "name": "a", "input": "vectors", "status": "verified", "reasons": [],
    "valid": True, "exact": True, "iou": 1.0, "faces": 10, "true_faces": 10, "seconds": 0.5,
}  # fmt: skip
WRONG = {**EXACT, "name": "b", "exact": False, "iou": 0.9, "seconds": 1.5}
OFF = {**EXACT, "name": "c", "exact": False, "iou": 0.99}
LATE = {
    "group": "holes", "name": "d", "input": "vectors", "true_faces": 12,
    "failure": "solve-over-time",
}  # fmt: skip
DOUBTED = {
    **WRONG, "name": "e", "status": "approximate", "reasons": ["ambiguous"], "mirrored": "x",
}  # fmt: skip


def test_what_counts() -> None:
    rows = (EXACT, WRONG, OFF, LATE, DOUBTED)
    assert [solved(row) for row in rows] == [True, False, False, False, False]
    assert [close(row) for row in rows] == [True, False, True, False, False]
    assert [falsely_verified(row) for row in rows] == [False, True, True, False, False]
    assert [causes(row) for row in rows] == [
        [], ["verified-but-wrong"], ["verified-but-wrong"], ["solve-over-time"],
        ["ambiguous", "mirrored"],
    ]  # fmt: skip


def test_tables_count_by_group_and_cause() -> None:
    text = tables([EXACT, WRONG, OFF, LATE, DOUBTED])
    head, planes, holes, total, causes_line = text.strip().splitlines()
    names = head.split()
    of_planes = dict(zip(["parts", "exact", "close"], planes.split()[1:4], strict=True))
    assert of_planes == {"parts": "4", "exact": "0.250", "close": "0.500"}
    assert names[:2] == ["vectors", "parts"]
    assert planes.split()[6:8] == ["2", "1"]
    assert holes.split()[:3] == ["holes", "1", "0.000"]
    assert total.split()[1] == "5"
    assert "verified-but-wrong 2" in causes_line and "solve-over-time 1" in causes_line


def test_the_picture_has_a_mark_for_each_timed_part() -> None:
    svg = time_picture([EXACT, WRONG, OFF, LATE])
    assert svg.count("<circle") == 3 + 1
    assert svg.count('fill="none"') == 2


def test_cases_go_through_all_levels() -> None:
    classes = [PartClass.PLANES, PartClass.HOLES]
    cases = list(classed_cases(classes, 2 * USUAL_LEVELS, 0, 3, 2))
    names = {(case.group, case.name) for case in cases}
    assert len(cases) == len(names) == 4 * USUAL_LEVELS + 3 + 4
    assert {case.level for case in cases} == set(range(len(LEVEL_FACES)))
    assert {case.group for case in cases if case.level == USUAL_LEVELS} == {"planes"}


def test_odd_pairs_stay_unopened(tmp_path: Path) -> None:
    for name in ("000004.step", "000004.dxf", "000005.step", "000005.dxf", "000006.step"):
        (tmp_path / name).write_bytes(b"")
    assert [case.name for case in folder_cases(tmp_path, 9)] == ["000004"]


def test_steps_alone_are_drawn(tmp_path: Path) -> None:
    part = Case("x", "planes", 0, 0).truth()
    write_step(part, tmp_path / "one.step")
    (case,) = folder_cases(tmp_path, 9)
    assert len(faces_of(case.truth())) == len(faces_of(part))


@pytest.fixture(scope="module")
def case() -> Case:
    return Case("planes-0", "planes", 0, 0)


def test_lines_are_kept(case: Case, tmp_path: Path) -> None:
    truth = case.truth()
    first = kept_lines(case, truth, tmp_path)
    (kept,) = (tmp_path / "exact-lines").iterdir()
    stamp = kept.stat().st_mtime_ns
    assert kept_lines(case, truth, tmp_path).views == first.views
    assert kept.stat().st_mtime_ns == stamp


@pytest.mark.parametrize("kind", [InputKind.VECTORS, InputKind.JITTER, InputKind.CLEAN])
def test_every_kind_of_drawing_shows_the_same_part(
    case: Case, kind: InputKind, tmp_path: Path
) -> None:
    truth = case.truth()
    exact = make_input(case, truth, InputKind.VECTORS, tmp_path)
    made = make_input(case, truth, kind, tmp_path)
    assert set(made.views.roles) == {Role.FRONT, Role.TOP, Role.RIGHT}
    assert made.views.size == pytest.approx(exact.views.size, rel=2e-3)
    assert (made.masks is not None) == (kind is InputKind.CLEAN)
    if kind is not InputKind.VECTORS:
        assert made.views.tolerance > 100.0 * exact.views.tolerance


def test_peers_are_what_their_names_say(tmp_path: Path) -> None:
    # A plate with a through hole and a blind one: only the first can be swept out.
    plate = cut(
        box((0, 0, 0), (60, 40, 20)),
        cylinder(Axis.Z, (15, 20), 8, -1, 21),
        cylinder(Axis.Z, (45, 20), 8, 10, 21),
    )
    write_step(plate, tmp_path / "plate.step")
    (case,) = folder_cases(tmp_path, 1)
    made = make_input(case, plate, InputKind.CLEAN, tmp_path)
    volumes = [
        peer_mesh(peer, made.outlines, made.masks).volume
        for peer in (Peer.HULL, Peer.SWEEP_AND_CUT)
    ]
    block, bore = 48000.0, 64.0 * np.pi * 20.0
    assert volumes == pytest.approx([block, block - bore], rel=2e-3)
