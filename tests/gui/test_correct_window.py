"""The canvas in FreeCAD, with the real engine; left out where it is not installed."""

import json
import os
import shutil
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import FreeCAD
import FreeCADGui
from test_real_engine import PLAIN, engine
from window import WindowCase, spin

from freecad.gaussiancad.canvas.corrections_storage import corrections_path, write_corrections
from freecad.gaussiancad.canvas.engine_server import Engines, Server
from freecad.gaussiancad.canvas.kinds import DOUBTFUL
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.panels import correct
from freecad.gaussiancad.panels.jobs import JobState, job_list
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

GIVEN = os.environ.get("GAUSSIANCAD_PYTHON")

_KEYS = QtCore.Qt.KeyboardModifier.NoModifier
_LENGTH = ((0.0, 0.0), (100.0, 0.0))


@unittest.skipIf(engine() is None, "the engine is not installed")
class Canvas(WindowCase):
    engines: Engines | None = None
    """Of all tests here: to start some takes longer than what most tests ask of them."""

    servers: tuple[Server, ...] = ()
    """They keep the engines while no canvas is open."""

    @classmethod
    def tearDownClass(cls) -> None:
        for server in cls.servers:
            server.close()
        super().tearDownClass()

    def setUp(self) -> None:
        super().setUp()
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        if Canvas.engines is None:
            Canvas.engines = engines = Engines.of(correct.engine_program())
            three = (engines.reader, engines.solver, engines.clerk)
            Canvas.servers = tuple(Server(item, self.window) for item in three)
        kept = SimpleNamespace(of=lambda _program: Canvas.engines)
        patched = mock.patch.object(correct, "Engines", kept)
        patched.start()
        self.addCleanup(patched.stop)
        self.copy = Path(shutil.copy(PLAIN, self.folder))
        self.document = FreeCAD.newDocument("Canvas")
        self.addCleanup(self.close_docks)
        self.dock = self.opened()

    @property
    def canvas(self) -> SheetWindow:
        return self.dock.canvas

    @property
    def part(self) -> FreeCAD.DocumentObject:
        return self.document.getObject("Part")

    def opened(self) -> correct.CanvasDock:
        """The canvas on a copy of the sample, with the sheet read and the part made."""
        dock = correct.open_sheet(self.copy)
        self.wait_for(lambda: dock.canvas.sheet is not None, 120.0)
        self.wait_for(lambda: not dock.canvas.busy, 120.0)
        spin(200)
        return dock

    def close_docks(self) -> None:
        for dock in correct.open_docks():
            dock.close()
        spin(200)

    def settled(self) -> None:
        """Wait until the part follows from what was said."""
        spin(700)
        self.wait_for(lambda: not self.canvas.busy, 120.0)
        spin(200)

    def press(self, key: QtCore.Qt.Key) -> None:
        for kind in (
            QtCore.QEvent.Type.ShortcutOverride,
            QtCore.QEvent.Type.KeyPress,
            QtCore.QEvent.Type.KeyRelease,
        ):
            QtWidgets.QApplication.sendEvent(
                self.canvas.canvas_view, QtGui.QKeyEvent(kind, key, _KEYS)
            )
        spin(50)

    def test_the_part_follows_corrections_and_undo(self) -> None:
        self.assertGreater(len(self.canvas.sheet.drawn()), 10)
        self.picture("canvas-read")
        self.assertTrue(self.canvas.problems.lines[0].colour, self.canvas.problems.lines)
        self.assertEqual(self.document.UndoNames, ["Open Drawing"])
        self.canvas.say_length(_LENGTH, 50.0)
        self.settled()
        part, first = self.part, self.part.Shape.BoundBox.XLength
        self.assertEqual(self.document.UndoNames, ["Correct Drawing", "Open Drawing"])
        self.canvas.say_length(_LENGTH, 100.0)
        self.settled()
        self.picture("canvas-corrected")
        self.assertEqual(self.part.Name, part.Name)
        self.assertAlmostEqual(self.part.Shape.BoundBox.XLength, 2.0 * first, delta=0.02 * first)
        self.document.undo()
        self.settled()
        self.assertAlmostEqual(self.part.Shape.BoundBox.XLength, first, delta=1e-6)
        self.assertEqual(len(self.canvas.operations), 1)
        self.document.redo()
        self.settled()
        self.assertAlmostEqual(self.part.Shape.BoundBox.XLength, 2.0 * first, delta=0.02 * first)
        kept = json.loads(corrections_path(self.copy).read_text(encoding="utf-8"))
        self.assertEqual(kept["ops"], self.canvas.operations)

    def test_a_stroke_in_doubt_is_orange_until_a_person_settles_it(self) -> None:
        self.canvas.say_length(_LENGTH, 50.0)
        self.settled()
        reading = json.loads(self.canvas.session.reading_file.read_text(encoding="utf-8"))
        doubtful = next(item for item in reading["strokes"] if item["kind"] == "visible")
        why = {"by": "network", "otherwise": "dimension", "margin": 0.1}
        doubtful.update(confidence=0.52, why=why)
        path = self.folder / "doubtful.json"
        path.write_text(json.dumps(reading), encoding="utf-8")
        self.canvas.session._was_read({"reading": str(path)}, [])
        self.settled()
        self.picture("canvas-doubt")
        (line,) = (
            this_line for this_line in self.canvas.problems.lines if "In doubt" in this_line.text
        )
        self.assertIn("Otherwise: dimension", line.text)
        drawn = self.canvas.canvas_view._drawing._strokes[doubtful["id"]]
        self.assertEqual(drawn.pen().color().name(), DOUBTFUL)
        codes = [item["code"] for item in self.canvas._report["reasons"]]
        self.assertEqual(codes, ["labels-doubtful"])
        self.assertEqual(self.canvas._report["status"], "approximate")
        line.buttons[0][1]()
        self.settled()
        self.picture("canvas-settled")
        self.assertEqual(self.canvas._report["reasons"], [])
        self.assertEqual(self.canvas._report["status"], "verified")

    def test_other_solids_that_fit_are_offered_until_the_next_correction(self) -> None:
        run = Path(shutil.copytree(self.dock._folder, self.folder / "run"))
        others = run / "alternatives"
        others.mkdir(exist_ok=True)
        shutil.copy(run / "solid.step", others / "1.step")
        report = json.loads((run / "report.json").read_text(encoding="utf-8"))
        why = {"code": "ambiguous", "message": "others fit", "args": {"case": "solids", "count": 1}}
        report.update(status="approximate", reasons=[why])
        self.canvas.session.solved.emit(report, str(run))
        (button,) = (
            called
            for line in self.canvas.problems.lines
            for text, called in line.buttons
            if text == "Choose among Solutions…"
        )
        button()
        names = [item.Name for item in self.part.InList[0].Group]
        self.assertIn("Alternative", names)
        self.assertTrue(FreeCADGui.Control.activeDialog())
        FreeCADGui.Control.closeDialog()
        self.canvas.say_length(_LENGTH, 100.0)
        self.assertIsNone(self.document.getObject("Alternative"))
        self.document.undo()
        self.assertIsNotNone(self.document.getObject("Alternative"))
        self.settled()

    def test_mesh_and_gaussians_follow_as_a_job(self) -> None:
        part = self.part.Name
        self.dock.make_all()
        self.dock.make_all()
        entries = job_list().entries[-2:]
        self.assertEqual(entries[1].state, JobState.WAITING)
        job_list().cancel(entries[1])
        self.assertEqual(entries[1].state, JobState.CANCELLED)
        self.close_docks()
        self.wait_for(lambda: entries[0].is_over, 300.0)
        self.assertEqual(entries[0].state, JobState.DONE, entries[0].item.text(1))
        self.picture("canvas-job")
        group = self.part.InList[0]
        names = {item.Name for item in group.Group}
        self.assertTrue({part, "Surface", "Gaussians"} <= names, names)
        self.assertEqual(self.document.UndoNames[0], "Reconstruct from Drawing")
        self.document.undo()
        self.assertEqual([item.Name for item in group.Group], [part])

    def test_a_job_that_works_is_cancelled(self) -> None:
        self.dock.make_all()
        entry = job_list().entries[-1]
        self.wait_for(lambda: "Stage" in entry.item.text(1), 60.0)
        job_list().cancel(entry)
        self.wait_for(lambda: entry.is_over, 60.0)
        self.assertEqual(entry.state, JobState.CANCELLED)
        self.assertEqual(self.document.UndoNames, ["Open Drawing"])

    def test_delete_on_the_canvas_erases_a_stroke_and_no_object(self) -> None:
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        FreeCADGui.Selection.addSelection(box)
        stroke = self.canvas.sheet.drawn()[0]
        self.canvas.canvas_view.select({stroke.id})
        self.press(QtCore.Qt.Key.Key_Delete)
        self.assertEqual([operation["op"] for operation in self.canvas.operations], ["erase"])
        for key in (QtCore.Qt.Key.Key_V, QtCore.Qt.Key.Key_F, QtCore.Qt.Key.Key_1):
            self.press(key)
        self.assertIsNotNone(self.document.getObject("Box"))
        self.document.undo()
        spin(200)
        self.assertEqual(self.canvas.operations, [])
        self.assertFalse(corrections_path(self.copy).exists())

    def test_a_document_keeps_what_was_said_and_shows_it_again(self) -> None:
        self.canvas.say_length(_LENGTH, 50.0)
        self.settled()
        length = self.part.Shape.BoundBox.XLength
        path = str(self.folder / "kept.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        spin(300)
        self.assertEqual(correct.open_docks(), [])
        self.document = FreeCAD.openDocument(path)
        spin(300)
        self.assertAlmostEqual(self.part.Shape.BoundBox.XLength, length, delta=1e-6)
        group = self.part.InList[0]
        self.assertTrue(json.loads(Path(group.Reading).read_text(encoding="utf-8"))["strokes"])
        self.dock = correct.open_canvas([group])
        self.wait_for(lambda: self.canvas.sheet is not None, 120.0)
        self.assertEqual(len(self.canvas.operations), 1)
        groups = [
            found for found in self.document.Objects if found.Name.startswith("Reconstruction")
        ]
        self.assertEqual(len(groups), 1)

    def test_corrections_of_another_version_are_left_out_and_kept(self) -> None:
        self.close_docks()
        path = corrections_path(self.copy)
        stated = [{"op": "scale", "points": [[0, 0], [100, 0]], "length_mm": 1.0}]
        write_corrections(path, "0" * 64, stated)
        self.document = FreeCAD.newDocument("Changed")
        self.dock = self.opened()
        self.assertEqual(self.canvas.operations, [])
        self.assertFalse(path.exists())
        kept = json.loads(path.with_name(path.name + ".old").read_text(encoding="utf-8"))
        self.assertEqual(kept["ops"], stated)
        texts = [line.text for line in self.canvas.problems.lines]
        self.assertTrue(any("another version" in text for text in texts), texts)
        self.assertAlmostEqual(self.part.Shape.BoundBox.XLength, 100.0, delta=0.1)

    def test_two_documents_have_a_canvas_each(self) -> None:
        other = FreeCAD.newDocument("Other")
        first = self.dock
        second = correct.open_sheet(self.copy)
        self.assertIsNot(first, second)
        self.wait_for(lambda: second.canvas.sheet is not None, 120.0)
        second.canvas.say_length(_LENGTH, 70.0)
        self.assertEqual(len(second.canvas.operations), 1)
        self.assertEqual(first.canvas.operations, [])
        self.assertIs(second.canvas.engines, first.canvas.engines)
        for document, dock in ((self.document, first), (other, second)):
            FreeCAD.setActiveDocument(document.Name)
            spin(200)
            self.assertFalse(dock.visibleRegion().isEmpty())
        FreeCAD.closeDocument(other.Name)
        spin(300)
        docks = correct.open_docks()
        self.assertEqual(docks, [first])

    def test_an_engine_that_is_killed_is_told_and_starts_again(self) -> None:
        self.canvas.solve()
        self.assertTrue(self.canvas.busy)
        self.canvas.engines.solver._process.kill()
        self.wait_for(lambda: not self.canvas.busy, 30.0)
        self.canvas.solve()
        self.wait_for(lambda: not self.canvas.busy, 120.0)
        spin(100)
        self.assertTrue(self.canvas.problems.lines[0].colour)

    def test_opening_that_is_undone_and_redone_brings_all_back(self) -> None:
        before = self.part.Shape.BoundBox.XLength
        self.canvas.say_length(_LENGTH, 80.0)
        self.settled()
        stated = self.part.Shape.BoundBox.XLength
        self.assertGreater(abs(stated - before), 1.0)
        corrections = corrections_path(self.copy)
        self.assertTrue(corrections.exists())
        for _ in self.document.UndoNames[:]:
            self.document.undo()
            spin(100)
        self.assertEqual(self.document.Objects, [])
        self.assertFalse(self.dock.isVisible())
        self.assertFalse(corrections.exists())
        while self.document.RedoNames:
            self.document.redo()
            spin(100)
        self.assertTrue(self.dock.isVisible())
        self.assertEqual(len(self.canvas.operations), 1)
        self.assertTrue(corrections.exists())
        self.wait_for(lambda: abs(self.part.Shape.BoundBox.XLength - stated) < 1e-6, 120.0)

    def test_a_closed_canvas_ends_its_engines(self) -> None:
        self.canvas.solve()
        self.assertTrue(self.canvas.busy)
        steps = list(self.document.UndoNames)
        self.close_docks()
        spin(500)
        self.assertEqual(self.document.UndoNames, steps)
        self.assertEqual(correct.open_docks(), [])
