"""Many sheets without a window, through the script that users start."""

import csv
import io
import json
import os
import signal
import subprocess
import sys
import time
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import fake_part
import FreeCAD
import Mesh
import Part
from support import FAKE_ENGINE, FolderCase, draw_sheet

from freecad.gaussiancad.batch import main
from freecad.gaussiancad.batch_options import parse_options
from freecad.gaussiancad.engine.job import Preset, Recipe, ScaleKind
from freecad.gaussiancad.objects.exporting import write_step, write_stl
from freecad.gaussiancad.paths import ADDON_ROOT
from freecad.gaussiancad.sheet_names import folder_names

SCRIPT = ADDON_ROOT / "resources" / "scripts" / "gaussiancad_batch.py"


class Batches(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.set_variable("GAUSSIANCAD_PYTHON", FAKE_ENGINE.python)
        self.sheets = self.folder / "sheets 图"
        self.sheets.mkdir()
        self.output = self.folder / "models"

    def rows(self) -> list[dict[str, str]]:
        with open(self.output / "report.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def start(self, arguments: list[str]) -> "subprocess.Popen[bytes]":
        """Start the script the way a user does, from another Python."""
        variables = {**os.environ, "FREECADCMD": sys.executable}
        return subprocess.Popen(
            [python(), str(SCRIPT), *arguments],
            env=variables,
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )

    def test_a_folder_becomes_documents_and_exchange_files(self) -> None:
        draw_sheet(self.sheets / "bracket.png")
        draw_sheet(self.sheets / "Träger 1.5.jpg")
        (self.sheets / "notes.txt").write_text("no drawing")
        (self.sheets / "broken.png").write_text("no picture")
        process = self.start([self.sheets.name, "--output", "models", "--length", "x=60"])
        text = process.communicate(timeout=180)[0].decode("utf-8", "replace")
        self.assertEqual(process.returncode, 1, text)
        for line in ("1/3 Träger 1.5: verified", "2/3 bracket: verified"):
            self.assertIn(line, text)
        self.assertIn("3/3 broken: broken.png is no image: choose a drawing", text)
        rows = {row["name"]: row for row in self.rows()}
        self.assertEqual(sorted(rows), ["Träger 1.5", "bracket", "broken"])
        self.assertEqual(rows["broken"]["status"], "failed")
        self.assertEqual(
            (rows["broken"]["exit_code"], rows["broken"]["code"]), ("3", "not-an-image")
        )
        values = json.loads((self.output / "report.json").read_text(encoding="utf-8"))
        self.assertEqual(
            [row["name"] for row in values["sheets"]], [r["name"] for r in self.rows()]
        )
        for name in ("bracket", "Träger 1.5"):
            self.assertEqual(rows[name]["status"], "verified")
            self.check_files(self.output / name)
            self.assertTrue((self.output / name / "report.json").is_file())
        self.assertFalse((self.output / "broken.FCStd").exists())

    def check_files(self, stem: Path) -> None:
        def path(suffix: str) -> str:
            return str(stem.with_name(stem.name + suffix))

        self.assertAlmostEqual(Part.read(path(".step")).Volume, fake_part.VOLUME, places=6)
        self.assertAlmostEqual(Mesh.Mesh(path(".stl")).Volume, fake_part.VOLUME, places=2)
        document = FreeCAD.openDocument(path(".FCStd"))
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        self.assertEqual(document.getObject("Reconstruction").Status, "verified")
        volume = document.getObject("Part").Shape.Volume
        self.assertAlmostEqual(volume, fake_part.VOLUME, places=6)

    def test_all_well_is_zero_and_flat_puts_one_sheets_files_together(self) -> None:
        sheet = draw_sheet(self.sheets / "bracket.png")
        self.assertEqual(main([str(sheet), "--output", str(self.output), "--flat"]), 0)
        self.check_files(self.output / "bracket")
        report = json.loads((self.output / "report.json").read_text())
        self.assertEqual(report["status"], "verified")
        self.assertFalse((self.output / "report.csv").exists())

    def test_a_second_run_that_fails_leaves_nothing_of_the_first(self) -> None:
        sheet = draw_sheet(self.sheets / "bracket.png")
        arguments = [str(sheet), "--output", str(self.output)]
        self.assertEqual(main(arguments), 0)
        for behaviour, message in (("dies", "ended from outside"), ("half", "surface.stl")):
            self.behave(behaviour)
            self.assertEqual(main(arguments), 1)
            self.assertEqual(list(self.output.glob("bracket.*")), [])
            self.assertIn(message, self.rows()[0]["message"])

    def test_wrong_usage_is_two(self) -> None:
        sheet = str(draw_sheet(self.sheets / "a.png"))
        second = str(draw_sheet(self.sheets / "b.png"))
        empty = self.folder / "empty"
        empty.mkdir()
        blocked = self.folder / "file"
        blocked.write_text("x")
        out = ["--output", str(self.output)]
        wrong: list[list[str]] = [
            [],
            [sheet],
            [str(empty), *out],
            [sheet, second, *out, "--flat"],
            [sheet, *out, "--preset", "huge"],
            [sheet, *out, "--length", "w=3"],
            [sheet, *out, "--length", "x=-3"],
            [sheet, *out, "--length", "x=3", "--mm-per-pixel", "1"],
            [sheet, *out, "--mm-per-pixel", "nan"],
            [sheet, "--output", str(blocked)],
        ]
        for arguments in wrong:
            with redirect_stderr(io.StringIO()) as told:
                self.assertEqual(main(arguments), 2, arguments)
            self.assertIn("error: ", told.getvalue())
        with redirect_stdout(io.StringIO()) as told:
            self.assertEqual(main(["--help"]), 0)
        self.assertIn("--mm-per-pixel", told.getvalue())

    def test_no_engine_is_six(self) -> None:
        sheet = str(draw_sheet(self.sheets / "a.png"))
        self.behave("broken")
        self.assertEqual(main([sheet, "--output", str(self.output)]), 6)
        self.set_variable("GAUSSIANCAD_PYTHON", "/nowhere/python")
        self.assertEqual(main([sheet, "--output", str(self.output)]), 6)

    def test_a_missing_sheet_is_told_and_the_next_one_goes_on(self) -> None:
        sheet = str(draw_sheet(self.sheets / "a.png"))
        missing = str(self.sheets / "missing.png")
        self.assertEqual(main([missing, sheet, "--output", str(self.output)]), 1)
        self.assertEqual([row["status"] for row in self.rows()], ["failed", "verified"])

    def test_an_interrupt_ends_with_130_and_keeps_what_is_done(self) -> None:
        draw_sheet(self.sheets / "a.png")
        self.behave("slow")
        process = self.start([str(self.sheets), "--output", str(self.output)])
        console = wait_for_child(process.pid, b"gaussiancad_batch.py")
        wait_for_child(console, b"reconstruct")
        time.sleep(0.5)
        os.kill(console, signal.SIGINT)
        text = process.communicate(timeout=60)[0].decode("utf-8", "replace")
        self.assertEqual(process.returncode, 130, text)
        self.assertEqual([row["code"] for row in self.rows()], ["cancelled"])

    def test_the_console_alone_takes_its_arguments_from_the_environment(self) -> None:
        sheet = draw_sheet(self.sheets / "a.png")
        for value, code in (
            (json.dumps([str(sheet), "--output", str(self.output), "--flat"]), 0),
            ("not json", 2),
            ('{"a": 1}', 2),
            ("[1]", 2),
            (None, 2),
        ):
            self.set_variable("GAUSSIANCAD_ARGS", value)
            ended = subprocess.run(
                [sys.executable, str(SCRIPT)],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                check=False,
                timeout=120,
            )
            self.assertEqual(ended.returncode, code, value)
        self.check_files(self.output / "a")

    def test_options_become_the_job(self) -> None:
        sheet = str(draw_sheet(self.sheets / "a.png"))
        words = ["--preset", "fine", "--mm-per-pixel", "0.5", "--page", "3", "--seed", "9"]
        words += ["--recipe", "paper", "--scale-down", "4"]
        job = parse_options([sheet, "--output", str(self.output), *words]).job
        self.assertEqual((job.preset, job.page, job.seed), (Preset.FINE, 3, 9))
        self.assertEqual((job.recipe, job.scale_down), (Recipe.PAPER, 4))
        self.assertEqual((job.scale.kind, job.scale.value), (ScaleKind.MM_PER_PIXEL, 0.5))

    def test_names_are_those_of_the_engines_batch(self) -> None:
        path = ADDON_ROOT / "core" / "gaussiancad_core" / "sheet_names.py"
        engine: dict[str, Any] = {"__name__": "sheet_names"}
        exec(compile(path.read_text(encoding="utf-8"), str(path), "exec"), engine)
        stems = (
            "x",
            "X",
            "..",
            "-a",
            "nul",
            "report.csv",
            "y.1",
            "Tra\u0308ger",
            "a\nb",
            "a\udcff",
        )
        sheets = [Path(f"{folder}/{stem}.png") for folder in "ab" for stem in stems]
        self.assertEqual(folder_names(sheets), engine["folder_names"](sheets))
        self.assertEqual(len(set(folder_names(sheets))), len(sheets))

    def test_no_name_and_no_link_leads_out_of_the_folder(self) -> None:
        outside = self.folder / "outside"
        (outside / "cameras").mkdir(parents=True)
        (outside / "cameras" / "mine.txt").write_text("mine")
        sheets = [draw_sheet(self.sheets / f"{name}.png") for name in ("..", "-x", "=1+1")]
        linked = draw_sheet(self.sheets / "linked.png")
        self.output.mkdir()
        (self.output / "linked").symlink_to(outside)
        before = sorted(path for path in self.folder.rglob("*") if self.output not in path.parents)
        arguments = [*map(str, sheets), str(sheets[0]), str(linked), "--output", str(self.output)]
        self.assertEqual(main(arguments), 1)
        after = sorted(path for path in self.folder.rglob("*") if self.output not in path.parents)
        self.assertEqual(after, before)
        rows = {row["name"]: row for row in self.rows()}
        self.assertEqual(list(rows), ["_png", "_-x", "'=1+1", "linked"])
        self.assertEqual(rows.pop("linked")["code"], "output-is-link")
        self.assertEqual({row["status"] for row in rows.values()}, {"verified"})
        self.assertTrue((self.output / "=1+1.FCStd").is_file())


class Exports(FolderCase):
    def test_a_part_without_a_surface_becomes_an_stl(self) -> None:
        path = self.folder / "a.stl"
        write_stl(Part.read(str(fake_part.STEP_FILE)), path)
        mesh = Mesh.Mesh(str(path))
        self.assertTrue(mesh.isSolid())
        self.assertAlmostEqual(mesh.Volume, fake_part.VOLUME, places=2)

    def test_a_surface_without_a_part_becomes_a_step(self) -> None:
        stl = self.folder / "a.stl"
        stl.write_text(fake_part.stl_text())
        path = self.folder / "a.step"
        write_step(Mesh.Mesh(str(stl)), path)
        shape = Part.read(str(path))
        self.assertEqual(len(shape.Faces), 20)
        self.assertAlmostEqual(abs(shape.Volume), fake_part.VOLUME, places=2)


def python() -> str:
    """A Python that is not FreeCAD."""
    return "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else "python3"


def wait_for_child(parent: int, word: bytes) -> int:
    """The number of a process's child whose command line holds a word."""
    for _ in range(1200):
        for entry in filter(str.isdigit, os.listdir("/proc")):
            try:
                stat = Path(f"/proc/{entry}/stat").read_text()
                command = Path(f"/proc/{entry}/cmdline").read_bytes()
            except OSError:
                continue
            if int(stat.rsplit(")", 1)[1].split()[1]) == parent and word in command:
                return int(entry)
        time.sleep(0.05)
    raise LookupError(word)
