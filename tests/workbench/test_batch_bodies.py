"""Many sheets without a window, each document with a body beside the solid."""

import io
import re
import signal
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout

import FreeCAD
from support import alive, draw_sheet
from test_batch import BatchCase, wait_for_child

from freecad.gaussiancad.batch_bodies import NO_SOLID, NOT_ADDED
from freecad.gaussiancad.batch_options import parse_options
from freecad.gaussiancad.objects.body_check import check_body
from freecad.gaussiancad.objects.shown_objects import GUI_FILE
from freecad.gaussiancad.whole_files import has_body


class Bodies(BatchCase):
    def setUp(self) -> None:
        super().setUp()
        self.sheet = draw_sheet(self.sheets / "a.png")
        self.made = self.output / "a.FCStd"

    @contextmanager
    def opened(self) -> Iterator[FreeCAD.Document]:
        document = FreeCAD.openDocument(str(self.made))
        try:
            yield document
        finally:
            FreeCAD.closeDocument(document.Name)

    def words(self, *options: str) -> str:
        """What the report says of the body of a sheet that is converted well."""
        self.assertEqual(self.convert(self.sheet, *options), 0)
        row = self.documents()["a"]
        self.assertEqual((row["exit_code"], row["code"], row["message"]), (0, "", ""))
        return row["body"]

    def test_a_document_has_the_body_and_the_solid(self) -> None:
        self.assertEqual(self.words("--body"), "")
        with self.opened() as document:
            part, body = document.getObject("Part"), document.getObject("Body")
            self.assertEqual(body.TypeId, "PartDesign::Body")
            self.assertEqual(body.Label, "Body of a")
            self.assertEqual(check_body(body.Shape, part.Shape).words, "")
            self.assertEqual((len(body.NumbersFromSheet), len(body.NumbersMeasured)), (3, 2))
            self.assertEqual((body.NumbersThatBreak, body.NumbersNotTried), ([], 0))
            self.assertEqual((part.Visibility, body.Visibility), (False, True))
            hidden = document.getObject("Reconstruction").HiddenAtFirst
            self.assertLessEqual({"Part", "Pad1Sketch"}, set(hidden))
            self.assertTrue({"Body", "Pad1"}.isdisjoint(hidden))
        self.check_files(self.output / "a")
        with zipfile.ZipFile(self.made) as archive:
            seen = archive.read(GUI_FILE).decode("utf-8")
        pattern = r'ViewProvider name="(\w+)".*?Bool value="(\w+)"'
        shown = dict(re.findall(pattern, seen, re.DOTALL))
        names = ("Body", "Pad1", "Part", "Pad1Sketch", "Origin")
        self.assertEqual([shown[name] for name in names], ["true"] * 2 + ["false"] * 3)

    def test_without_the_option_there_is_none(self) -> None:
        out = ["--output", str(self.output)]
        self.assertFalse(parse_options([str(self.sheet), *out]).body)
        self.assertTrue(parse_options([str(self.sheet), "--body", *out]).body)
        self.assertEqual(self.words(), "")
        self.assertFalse(has_body(self.made))

    def test_where_none_can_be_made_the_document_is_as_before_and_the_report_says_why(self) -> None:
        self.assertEqual(self.words(), "")
        with self.opened() as document:
            names = [each.Name for each in document.Objects]
        for behaviour, reason in (
            ("differs", "% of the volume differ"),
            ("no-features", "No body was made: the model has no solid"),
        ):
            self.behave(behaviour)
            with self.subTest(behaviour), redirect_stdout(io.StringIO()) as said:
                words = self.words("--body")
                self.assertIn(reason, words)
                self.assertIn(f"1/1 a: verified. {words}", said.getvalue())
                with self.opened() as document:
                    self.assertEqual([each.Name for each in document.Objects], names)
                    self.assertTrue(document.getObject("Part").Visibility)
                self.assertEqual(self.documents()["a"]["status"], "verified")

    def test_a_surface_has_none(self) -> None:
        self.behave("surface")
        self.assertEqual(self.words("--body"), NO_SOLID)
        self.assertEqual(self.words("--body", "--resume"), NO_SOLID)

    def test_resuming_keeps_documents_and_says_which_have_none(self) -> None:
        self.assertEqual(self.words(), "")
        before = self.made.stat()
        self.assertEqual(self.words("--body", "--resume"), NOT_ADDED)
        self.assertEqual(self.made.stat().st_ino, before.st_ino)
        self.made.unlink()
        self.assertEqual(self.words("--body", "--resume"), "")
        self.assertTrue(has_body(self.made))
        before = self.made.stat()
        (self.output / "a.step").unlink()
        self.assertEqual(self.words("--body", "--resume"), "")
        self.assertEqual(self.made.stat().st_ino, before.st_ino)
        self.check_files(self.output / "a")

    def test_one_sheet_in_one_folder(self) -> None:
        for behaviour, expected in (("ok", ""), ("differs", ". No body was made of a: ")):
            self.behave(behaviour)
            with redirect_stdout(io.StringIO()) as said:
                self.assertEqual(self.convert(self.sheet, "--flat", "--body"), 0)
            self.assertIn(f"1/1 a: verified{expected}", said.getvalue())
            self.assertEqual(has_body(self.made), not expected)

    def test_what_is_stopped_before_its_body_is_made_when_it_goes_on(self) -> None:
        for options in ([], ["--flat"]):
            self.behave("features-wait")
            words = [str(self.sheet), "--output", str(self.output), "--body", *options]
            process = self.start(words)
            looking = wait_for_child(process.pid, b"features")
            process.send_signal(signal.SIGTERM)
            text = process.communicate(timeout=60)[0].decode("utf-8", "replace")
            self.assertEqual(process.returncode, 130, text)
            self.assertFalse(alive(looking))
            self.assertEqual(list(self.output.glob("a.*")), [])
            self.assertEqual(list(self.output.glob(".gaussiancad-*")), [])
            if not options:
                self.assertEqual(self.documents()["a"]["code"], "cancelled")
                self.behave("ok")
                self.assertEqual(self.words("--body", "--resume"), "")
                self.assertTrue(has_body(self.made))
