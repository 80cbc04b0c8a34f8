"""What the public functions give, refuse, and leave behind."""

import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

import gaussiancad
from gaussiancad.engine_call import engine_python, run_command


@pytest.fixture(scope="module")
def reading(plain_picture: Path) -> gaussiancad.Reading:
    return gaussiancad.read(plain_picture)


def test_importing_loads_no_library() -> None:
    code = "import sys, gaussiancad; print(*{name.partition('.')[0] for name in sys.modules})"
    printed = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True
    ).stdout
    heavy = {"numpy", "cv2", "OCP", "torch", "open3d", "msgspec", "scipy", "shapely"}
    assert "gaussiancad" in printed.split()
    assert not heavy & set(printed.split())


def test_a_reading_has_views_with_their_strokes(reading: gaussiancad.Reading) -> None:
    assert set(reading.views) == {"front", "top", "right"}
    strokes = [stroke for view in reading.views.values() for stroke in view.strokes]
    assert {stroke.kind for stroke in strokes} >= {"visible", "hidden"}
    assert all((stroke.line is None) != (stroke.arc is None) for stroke in strokes)
    assert reading.projection == "third"


def test_a_saved_reading_is_the_same(
    reading: gaussiancad.Reading, plain_picture: Path, tmp_path: Path
) -> None:
    reading.save(tmp_path / "reading.json")
    again = gaussiancad.Reading.load(tmp_path / "reading.json", plain_picture)
    assert again.views == reading.views
    assert again.data == reading.data


def test_corrections_change_the_reading_and_the_part(
    reading: gaussiancad.Reading, tmp_path: Path
) -> None:
    scale = {"op": "scale", "axis": "x", "length_mm": 30}
    corrected = gaussiancad.correct(reading, [scale])
    assert corrected.data["scale"]["length_mm"] == 30
    assert not any(problem.code == "scale-assumed" for problem in corrected.problems)
    part = gaussiancad.solve(corrected, result="solid")
    assert part.report["solid"]["bounding_box_mm"][0] == pytest.approx(30.0, abs=1e-6)
    (tmp_path / "solid.step").write_text("mine")
    with pytest.raises(gaussiancad.UsageError) as refused:
        part.save(tmp_path)
    assert refused.value.code == "foreign-files"
    assert (tmp_path / "solid.step").read_text() == "mine"
    part.save(tmp_path, overwrite=True)
    assert (tmp_path / "solid.step").read_bytes() == part.files["solid.step"].read_bytes()


def test_a_correction_of_another_form_is_refused(reading: gaussiancad.Reading) -> None:
    with pytest.raises(gaussiancad.UnreadableError, match="nonsense") as refused:
        gaussiancad.correct(reading, [{"op": "nonsense"}])
    assert refused.value.code == "corrections-not-read"


def test_a_sheet_without_a_part_gives_a_failed_result(reading: gaussiancad.Reading) -> None:
    # One view and no thickness.
    others = (view for view in reading.views.values() if view.role != "front")
    lone = gaussiancad.correct(
        reading, [{"op": "view", "id": view.id, "role": "ignore"} for view in others]
    )
    failed = gaussiancad.solve(lone, result="solid")
    assert failed.status == "failed"
    assert failed.reasons
    assert failed.solid is None
    with pytest.raises(gaussiancad.UnreadableError, match="failed"):
        gaussiancad.compare(failed, "any.step")


@pytest.mark.parametrize(
    ("options", "kind", "code"),
    [
        ({"length": {"q": 3.0}}, gaussiancad.UsageError, "wrong-usage"),
        ({"projection": "second"}, gaussiancad.UsageError, "wrong-usage"),
        ({"page": 7}, gaussiancad.UnreadableError, "page-missing"),
    ],
)
def test_what_cannot_be_read_so_is_refused(
    options: dict[str, object], kind: type[gaussiancad.Error], code: str, plain_picture: Path
) -> None:
    with pytest.raises(kind) as refused:
        gaussiancad.read(plain_picture, **options)
    assert refused.value.code == code


def test_an_exception_of_progress_stops_the_run_and_leaves_nothing(
    plain_picture: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Enough(Exception):
        pass

    def stop(stage: str, fraction: float) -> None:
        raise Enough(stage)

    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    with pytest.raises(Enough):
        gaussiancad.reconstruct(plain_picture, result="solid", progress=stop)
    assert not list(tmp_path.iterdir())


def test_an_interpreter_that_is_none_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GAUSSIANCAD_PYTHON", "/nowhere/python")
    with pytest.raises(gaussiancad.EngineError, match="GAUSSIANCAD_PYTHON") as refused:
        engine_python()
    assert refused.value.code == "engine-missing"


def test_an_engine_that_is_no_engine_is_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    broken = tmp_path / "python"
    broken.write_text("#!/bin/sh\necho nothing here >&2\nexit 9\n")
    broken.chmod(0o755)
    monkeypatch.setenv("GAUSSIANCAD_PYTHON", str(broken))
    error = run_command(["doctor"]).error()
    assert isinstance(error, gaussiancad.EngineError)
    assert error.code == "engine-broken"
    assert "nothing here" in str(error)


def test_a_run_that_takes_too_long_is_stopped_and_says_where(plain_picture: Path) -> None:
    with pytest.raises(gaussiancad.LimitError, match=r"more than 0\.01 s, in the stage") as raised:
        gaussiancad.read(plain_picture, limit_s=0.01)
    assert raised.value.code == "takes-too-long"
