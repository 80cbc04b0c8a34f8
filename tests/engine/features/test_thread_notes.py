"""Threads that notes of the drawing tell of holes."""

import json
from dataclasses import replace
from pathlib import Path

from gaussiancad_core.features.as_json import solid_values
from gaussiancad_core.features.build123d_script import script_of
from gaussiancad_core.features.constraints import Numbers
from gaussiancad_core.features.feature_model import FeatureList, Holes
from gaussiancad_core.features.features_command import numbers_of_report, write_features
from gaussiancad_core.features.frames import MAIN_FRAMES
from gaussiancad_core.features.thread_notes import Thread, ThreadNote, threads_of
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.writing.callouts import thread_name
from sample_parts.modelling import box, cut, cylinder

_FOUR = tuple((float(x), 0.0) for x in (0, 10, 20, 30))
_CORES = Holes(MAIN_FRAMES[0], 0.0, _FOUR, True, 5.0, 12.0)
_BORE = Holes(MAIN_FRAMES[0], 0.0, ((50.0, 50.0),), True, 20.0, None)


_NAMES = {"M6": "M6", "4x M6 \u21a7 12": "M6", "M8 x 1": "M8x1", "M3 THRU": "M3"}
_NAMES |= {"1/4-20 UNC": "1/4-20 UNC", "\u00d86": None, "R6": None}


def test_a_note_names_a_thread() -> None:
    assert {text: thread_name(text) for text in _NAMES} == _NAMES


def test_a_thread_is_of_as_many_holes_as_its_note_says() -> None:
    note = ThreadNote("M6", 6.0, 4, 10.0)
    assert threads_of((_BORE, _CORES), [note]) == {1: Thread("M6", 10.0)}
    assert threads_of((_BORE, replace(_CORES, diameter=6.0)), [note]) == {1: Thread("M6", 10.0)}
    assert threads_of((_BORE, _CORES), [replace(note, count=3)]) == {}
    assert threads_of((_BORE, _CORES), [replace(note, diameter=12.0, name="M12")]) == {}


def test_a_thread_is_not_deeper_than_its_hole() -> None:
    note = ThreadNote("M6", 6.0, 4, 15.0)
    assert threads_of((_CORES,), [note]) == {0: Thread("M6", 12.0)}
    assert threads_of((_CORES,), [replace(note, depth=None)]) == {0: Thread("M6", None)}


def test_what_may_be_two_holes_has_no_thread() -> None:
    note = ThreadNote("M6", 6.0, 4)
    other = replace(_CORES, diameter=5.2)
    assert threads_of((_CORES, other), [note]) == {}
    assert threads_of((_CORES, replace(_CORES, height=5.0)), [note]) == {}
    assert threads_of((_CORES,), [note, ThreadNote("M5", 5.0, 4)]) == {}


def test_notes_of_one_thread_speak_of_all_its_holes_together() -> None:
    notes = [ThreadNote("M6", 6.0, 4, 10.0), ThreadNote("M6", 6.0, 4, 8.0)]
    found = threads_of((_CORES, _BORE, replace(_CORES, height=5.0)), notes)
    assert found == {0: Thread("M6", None), 2: Thread("M6", None)}


def test_values_and_the_script_name_the_thread() -> None:
    numbers = Numbers(threads=(ThreadNote("M6", 6.0, 4, 10.0),))
    values = solid_values(FeatureList((_CORES, _BORE)), numbers, None)
    cores, bore = values["features"]
    assert (cores["thread"], cores["thread_depth"], cores["diameter"]) == ("M6", 10.0, 5.0)
    assert "thread" not in bore
    assert "# Hole1: M6" in script_of([values])


def test_notes_are_those_of_the_report_beside_the_solid(tmp_path: Path) -> None:
    drills = [cylinder(Axis.Z, (x, 10.0), 2.5, 0.0, 10.0) for x in (10.0, 30.0)]
    write_step(cut(box((0, 0, 0), (40, 20, 10)), *drills), tmp_path / "solid.step")
    note = {"text": "2x M6", "kind": "thread", "value_mm": 6.0, "count": 2, "depth_mm": None}
    report = {"measures": {"uncertainty_mm": 0.01}, "dimensions": [], "notes": [note]}
    (tmp_path / "report.json").write_text(json.dumps(report), encoding="utf-8")
    assert numbers_of_report(tmp_path / "solid.step").threads == (ThreadNote("M6", 6.0, 2),)
    write_features(tmp_path / "solid.step", tmp_path / "out")
    values = json.loads((tmp_path / "out" / "features.json").read_text(encoding="utf-8"))
    (holes,) = (f for f in values["solids"][0]["features"] if f["kind"] == "hole")
    assert (holes["thread"], holes["thread_depth"], holes["diameter"]) == ("M6", None, 5.0)
