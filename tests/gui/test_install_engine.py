"""*Install Engine…* in a real window, with a fake Python."""

import os
import shutil
from pathlib import Path

import support
from window import WindowCase, open_windows, spin

from freecad.gaussiancad.engine.locate import MARKER, SearchPlaces, find_engine
from freecad.gaussiancad.engine.managed import engine_version
from freecad.gaussiancad.panels.check_engine import DIALOG_NAME as CHECK_NAME
from freecad.gaussiancad.panels.install_engine import DIALOG_NAME, QUESTION_NAME
from freecad.gaussiancad.qt import QtWidgets

FAKE_PYTHON = Path(support.__file__).parent / "fake_python.py"


class Dialog(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.asked = self.folder / "asked"
        self.root = self.folder / "data" / "GaussianCAD" / "engine"
        self.set_variable("XDG_DATA_HOME", str(self.folder / "data"))
        self.set_variable("GAUSSIANCAD_FAKE_LOG", str(self.asked))
        (self.folder / "python3.13").symlink_to(FAKE_PYTHON)
        self.set_variable("PATH", os.pathsep.join([str(self.folder), "/usr/bin", "/bin"]))
        self.set_variable("GAUSSIANCAD_PYTHON", "/nowhere/python")

    def shown(self, name: str) -> QtWidgets.QDialog:
        return open_windows(name)[0]

    def open(self) -> tuple[QtWidgets.QDialog, QtWidgets.QLabel, QtWidgets.QPushButton]:
        """From *Check Engine…*, where a user comes from."""
        self.open_panel("GaussianCAD_CheckEngine")
        self.shown(CHECK_NAME).findChild(QtWidgets.QPushButton, "install").click()
        spin(200)
        dialog = self.shown(DIALOG_NAME)
        headline = dialog.findChild(QtWidgets.QLabel, "headline")
        return dialog, headline, self.button(dialog, "install")

    def button(self, dialog: QtWidgets.QDialog, name: str) -> QtWidgets.QPushButton:
        return dialog.findChild(QtWidgets.QPushButton, name)

    def enabled(self, dialog: QtWidgets.QDialog) -> list[str]:
        names = ("install", "repair", "remove")
        return [name for name in names if self.button(dialog, name).isEnabled()]

    def installed(self) -> tuple[QtWidgets.QDialog, QtWidgets.QLabel]:
        dialog, headline, button = self.open()
        button.click()
        self.wait_for(lambda: "complete" in headline.text())
        return dialog, headline

    def test_nothing_happens_before_consent_and_then_everything(self) -> None:
        dialog, headline, button = self.open()
        self.picture("install-engine")
        self.assertIn(str(self.folder / "data"), headline.text())
        self.assertTrue(dialog.findChild(QtWidgets.QRadioButton, "cpu").isChecked())
        self.assertEqual(self.enabled(dialog), ["install"])
        self.assertFalse(self.asked.exists())
        button.click()
        self.assertEqual(self.enabled(dialog), [])
        self.wait_for(lambda: "complete" in headline.text())
        self.assertTrue((self.root / MARKER).is_file())
        engine = find_engine(SearchPlaces.of_this_machine("", {}))
        self.assertEqual(engine.python, str(self.root / "bin" / "python"))
        dialog.reject()
        self.wait_for(lambda: not dialog_is_open())

    def test_an_engine_that_is_there_is_told_and_nothing_offered_for_download(self) -> None:
        dialog, _ = self.installed()
        dialog.reject()
        spin(200)
        dialog, headline, _ = self.open()
        self.assertIn("The engine is complete.", headline.text())
        details = dialog.findChild(QtWidgets.QLabel, "details").text()
        self.assertIn(f"Version {engine_version()}", details)
        self.assertIn("MB on disk", details)
        self.assertEqual(self.enabled(dialog), ["repair", "remove"])
        self.picture("install-engine-complete")
        dialog.findChild(QtWidgets.QRadioButton, "cuda").click()
        self.assertEqual(self.enabled(dialog), ["install", "remove"])
        dialog.reject()

    def test_an_nvidia_card_suggests_its_build(self) -> None:
        card = self.folder / "nvidia-smi"
        card.write_text("#!/bin/sh\n")
        card.chmod(0o755)
        dialog, headline, button = self.open()
        cuda = dialog.findChild(QtWidgets.QRadioButton, "cuda")
        self.assertTrue(cuda.isChecked())
        self.assertIn("an NVIDIA card was found", cuda.text())
        button.click()
        self.wait_for(lambda: "complete" in headline.text())
        self.assertIn('"cuda"', (self.root / MARKER).read_text())
        dialog.reject()

    def test_an_engine_of_solids_alone_can_be_chosen(self) -> None:
        dialog, headline, button = self.open()
        solid = dialog.findChild(QtWidgets.QRadioButton, "solid")
        self.assertIn("Exact solids only", solid.text())
        solid.click()
        button.click()
        self.wait_for(lambda: "complete" in headline.text())
        self.assertIn('"solid"', (self.root / MARKER).read_text())
        details = dialog.findChild(QtWidgets.QLabel, "details").text()
        self.assertIn("for exact solids only", details)
        self.assertNotIn("PyTorch", details)
        self.picture("install-engine-solid")
        dialog.reject()

    def test_what_is_missing_is_told_and_repaired(self) -> None:
        dialog, _ = self.installed()
        dialog.reject()
        spin(200)
        (torch,) = self.root.glob("lib/python*/site-packages/torch-*.dist-info")
        shutil.rmtree(torch)
        dialog, headline, _ = self.open()
        self.assertIn("not complete", headline.text())
        self.assertIn("torch", dialog.findChild(QtWidgets.QLabel, "details").text())
        self.assertEqual(self.enabled(dialog), ["install", "repair", "remove"])
        self.picture("install-engine-incomplete")
        self.button(dialog, "repair").click()
        self.wait_for(lambda: "is complete" in headline.text())
        self.assertTrue(torch.is_dir())
        dialog.reject()

    def test_a_repair_that_was_cancelled_can_be_taken_up_again(self) -> None:
        dialog, headline = self.installed()
        self.behave("slow")
        self.button(dialog, "repair").click()
        self.wait_for(lambda: "small build" in headline.text())
        dialog.reject()
        self.wait_for(lambda: "Repair again" in headline.text())
        self.assertEqual(self.enabled(dialog), ["install", "repair", "remove"])
        self.behave("ok")
        self.button(dialog, "repair").click()
        self.wait_for(lambda: "is complete" in headline.text())
        dialog.reject()

    def test_removing_asks_first_and_takes_the_environment_alone(self) -> None:
        dialog, headline = self.installed()
        neighbour = self.root.parent / "mine.txt"
        neighbour.write_text("kept")
        self.button(dialog, "remove").click()
        spin(200)
        self.picture("remove-engine")
        self.shown(QUESTION_NAME).reject()
        spin(100)
        self.assertTrue((self.root / MARKER).is_file())
        self.button(dialog, "remove").click()
        spin(200)
        self.button(self.shown(QUESTION_NAME), "removeNow").click()
        spin(200)
        self.assertEqual([path.name for path in self.root.parent.iterdir()], ["mine.txt"])
        self.assertIn("can download", headline.text())
        self.assertEqual(self.enabled(dialog), ["install"])
        dialog.reject()

    def test_closing_stops_first(self) -> None:
        self.behave("slow")
        dialog, headline, button = self.open()
        button.click()
        self.wait_for(lambda: "small build" in headline.text())
        dialog.reject()
        self.wait_for(lambda: "cancelled" in headline.text())
        self.assertFalse(self.root.exists())
        dialog.reject()

    def test_a_failure_is_told_and_can_be_tried_again(self) -> None:
        self.set_variable("GAUSSIANCAD_FAKE_FAILS", "engine-cpu.txt")
        dialog, headline, button = self.open()
        button.click()
        self.wait_for(lambda: "failed" in headline.text())
        self.assertIn("ERROR: no engine-cpu.txt here", headline.text())
        self.assertTrue(button.isEnabled())
        dialog.reject()


def dialog_is_open() -> bool:
    return bool(open_windows(DIALOG_NAME))
