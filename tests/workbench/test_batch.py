"""Many sheets without a window, through the script that users start."""

import csv
import io
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any
from unittest import mock

import fake_part
import FreeCAD
import Mesh
import Part
from support import FAKE_ENGINE, FolderCase, alive, draw_sheet

from freecad.gaussiancad import batch, batch_documents
from freecad.gaussiancad.batch import main
from freecad.gaussiancad.batch_options import parse_options
from freecad.gaussiancad.batch_report import SheetRow
from freecad.gaussiancad.engine.job import ScaleKind
from freecad.gaussiancad.engine.protocol import Preset, Recipe
from freecad.gaussiancad.objects.exporting import write_step, write_stl
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.paths import ADDON_ROOT
from freecad.gaussiancad.staging import staging
from freecad.gaussiancad.whole_files import is_whole_document, is_whole_step, is_whole_stl

SCRIPT = ADDON_ROOT / "resources" / "scripts" / "gaussiancad_batch.py"

STOPS_S = 60.0
SUFFIXES = (".FCStd", ".step", ".stl")  # beside them lie FreeCAD's backups


_OF_BODIES = ("body", "body_breaking", "body_untried")
"""What the report over documents has and the engine's table has not."""


class BatchCase(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.set_variable("GAUSSIANCAD_PYTHON", FAKE_ENGINE.python)
        for number in (signal.SIGINT, signal.SIGTERM):
            self.addCleanup(signal.signal, number, signal.getsignal(number))
        self.sheets = self.folder / "sheets 图"
        self.sheets.mkdir()
        self.output = self.folder / "models"

    def convert(self, *arguments: "str | Path") -> int:
        """Convert into the output folder, in this process."""
        return main([*map(str, arguments), "--output", str(self.output)])

    def rows(self) -> dict[str, dict[str, str]]:
        """The engine's report by the sheets' names."""
        with open(self.output / "report.csv", encoding="utf-8", newline="") as file:
            return {row["name"]: row for row in csv.DictReader(file)}

    def documents(self) -> dict[str, dict[str, Any]]:
        """The report over the documents by the sheets' names."""
        values = json.loads((self.output / "report.json").read_text(encoding="utf-8"))
        self.assertEqual(values["schema"], 2)
        return {row["name"]: row for row in values["sheets"]}

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

    def check_files(self, stem: Path) -> None:
        self.assertAlmostEqual(
            Part.read(str(file_of(stem, ".step"))).Volume, fake_part.VOLUME, places=6
        )
        mesh = Mesh.Mesh(str(file_of(stem, ".stl")))
        self.assertAlmostEqual(mesh.Volume, fake_part.VOLUME, places=2)
        document = FreeCAD.openDocument(str(file_of(stem, ".FCStd")))
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        self.assertEqual(document.getObject("Reconstruction").Status, "verified")
        volume = document.getObject("Part").Shape.Volume
        self.assertAlmostEqual(volume, fake_part.VOLUME, places=6)


class Batches(BatchCase):
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
        rows = self.rows()
        self.assertEqual(sorted(rows), ["Träger 1.5", "bracket", "broken"])
        self.assertEqual(rows["broken"]["status"], "failed")
        self.assertEqual(
            (rows["broken"]["exit_code"], rows["broken"]["code"]), ("3", "not-an-image")
        )
        documents = self.documents()
        self.assertEqual(list(documents), list(rows))
        for name, row in documents.items():
            self.assertEqual([row.pop(each) for each in _OF_BODIES], ["", [], 0])
            self.assertEqual({key: str(row[key]) for key in row}, rows[name])
        for name in ("bracket", "Träger 1.5"):
            self.assertEqual(rows[name]["status"], "verified")
            self.check_files(self.output / name)
            self.assertTrue((self.output / name / "report.json").is_file())
        self.assertFalse((self.output / "broken.FCStd").exists())
        self.assertEqual(list(self.output.glob(".gaussiancad-*")), [])

    def test_a_document_knows_the_settings_of_its_own_sheet(self) -> None:
        sheet = draw_sheet(self.sheets / "a.png")
        words = ("--length", "x=60", "--preset", "draft", "--seed", "9", "--projection", "third")
        self.assertEqual(self.convert(sheet, *words), 0)
        document = FreeCAD.openDocument(str(self.output / "a.FCStd"))
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        settings = texts_of(document.getObject("Reconstruction"), "Settings")
        stated = [settings[key] for key in ("scale", "preset", "seed", "projection", "page")]
        self.assertEqual(stated, ["x = 60", "draft", "9", "third", "1"])
        self.assertEqual(document.getObject("Reconstruction").SheetPath, str(sheet))

    def test_all_well_is_zero_and_flat_puts_one_sheets_files_together(self) -> None:
        sheet = draw_sheet(self.sheets / "bracket.png")
        self.assertEqual(self.convert(sheet, "--flat"), 0)
        self.check_files(self.output / "bracket")
        report = json.loads((self.output / "report.json").read_text())
        self.assertEqual(report["status"], "verified")
        self.assertFalse((self.output / "report.csv").exists())
        self.behave("half")
        self.assertEqual(self.convert(sheet, "--flat"), 1)
        self.assertEqual(list(self.output.glob("bracket.*")), [])

    def test_a_flat_sheet_has_a_safe_name(self) -> None:
        self.output.mkdir()
        sheet = draw_sheet(self.sheets / "...png")
        before = sorted(self.folder.iterdir())
        self.assertEqual(self.convert(sheet, "--flat"), 0)
        self.assertEqual(sorted(self.folder.iterdir()), before)
        self.check_files(self.output / "_png")

    def test_a_second_run_that_fails_leaves_nothing_of_the_first(self) -> None:
        sheet = draw_sheet(self.sheets / "bracket.png")
        self.assertEqual(self.convert(sheet), 0)
        for behaviour, message in (("dies", "ended by SIGKILL"), ("half", "surface.stl")):
            self.behave(behaviour)
            self.assertEqual(self.convert(sheet), 1)
            self.assertEqual(list(self.output.glob("bracket.*")), [])
            self.assertIn(message, self.documents()["bracket"]["message"])
            self.assertEqual(self.documents()["bracket"]["status"], "failed")

    def test_wrong_usage_is_two(self) -> None:
        sheet = str(draw_sheet(self.sheets / "a.png"))
        second = str(draw_sheet(self.sheets / "b.png"))
        blocked = self.folder / "file"
        blocked.write_text("x")
        out = ["--output", str(self.output)]
        wrong: list[list[str]] = [
            [],
            [sheet],
            [sheet, second, *out, "--flat"],
            [str(self.sheets), *out, "--flat"],
            [sheet, *out, "--flat", "--resume"],
            [sheet, *out, "--flat", "--memory", "3"],
            [sheet, *out, "--workers", "0"],
            [sheet, *out, "--preset", "huge"],
            [sheet, *out, "--length", "w=3"],
            [sheet, *out, "--length", "x=-3"],
            [sheet, *out, "--length", "x=3", "--mm-per-pixel", "1"],
            [sheet, *out, "--mm-per-pixel", "nan"],
            [sheet, "--output", str(blocked)],
        ]
        for arguments in wrong:
            with redirect_stderr(io.StringIO()) as stated:
                self.assertEqual(main(arguments), 2, arguments)
            self.assertIn("error: ", stated.getvalue())
        with redirect_stdout(io.StringIO()) as stated:
            self.assertEqual(main(["--help"]), 0)
        self.assertIn("--mm-per-pixel", stated.getvalue())

    def test_what_the_engine_refuses_is_told_with_its_exit_code(self) -> None:
        empty = self.folder / "empty"
        empty.mkdir()
        with redirect_stdout(io.StringIO()) as stated:
            self.assertEqual(self.convert(empty), 2)
            self.behave("running")
            self.assertEqual(self.convert(draw_sheet(self.sheets / "a.png")), 2)
        self.assertIn("no drawing was found", stated.getvalue())
        self.assertIn("another batch writes", stated.getvalue())
        # The report of the other batch is not touched.
        self.assertEqual(list(self.output.iterdir()), [])

    def test_no_engine_is_six(self) -> None:
        sheet = str(draw_sheet(self.sheets / "a.png"))
        for more in ([], ["--flat"]):
            self.behave("broken")
            self.assertEqual(self.convert(sheet, *more), 6)
            self.set_variable("GAUSSIANCAD_PYTHON", "/nowhere/python")
            self.assertEqual(self.convert(sheet, *more), 6)
            self.set_variable("GAUSSIANCAD_PYTHON", FAKE_ENGINE.python)

    def test_an_engine_that_dies_is_six_and_what_it_told_is_kept(self) -> None:
        sheets = [draw_sheet(self.sheets / f"{name}.png") for name in "ab"]
        self.behave("batch-dies")
        self.assertEqual(self.convert(*sheets), 6)
        self.assertEqual(list(self.documents()), ["a"])
        self.check_files(self.output / "a")

    def test_a_missing_sheet_is_told_and_the_next_one_goes_on(self) -> None:
        sheet = str(draw_sheet(self.sheets / "a.png"))
        missing = str(self.sheets / "missing.png")
        self.assertEqual(self.convert(missing, sheet), 1)
        self.assertEqual([r["status"] for r in self.rows().values()], ["failed", "verified"])

    def test_a_signal_ends_all_with_130_and_keeps_what_is_done(self) -> None:
        draw_sheet(self.sheets / "a.png")
        draw_sheet(self.sheets / "b.png")
        self.behave("slow")
        for number in (signal.SIGINT, signal.SIGTERM):
            # The console is the process that was started.
            process = self.start([str(self.sheets), "--output", str(self.output)])
            engine = wait_for_child(process.pid, b"batch")
            sheet = wait_for_child(engine, b"reconstruct")
            started = time.monotonic()
            process.send_signal(number)
            text = process.communicate(timeout=60)[0].decode("utf-8", "replace")
            self.assertLess(time.monotonic() - started, STOPS_S)
            self.assertEqual(process.returncode, 130, text)
            for pid in (engine, sheet):
                self.assertFalse(alive(pid))
            self.assertEqual({row["code"] for row in self.rows().values()}, {"cancelled"})

    def test_a_document_that_is_being_made_is_finished_and_no_other_is_begun(self) -> None:
        sheets = [draw_sheet(self.sheets / f"{name}.png") for name in "abc"]
        self.behave("batch-waits")
        manifest = self.output / "manifest.sqlite"

        def interrupted(row: SheetRow, kept: bool, bodies: None) -> SheetRow:
            engine = wait_for_child(os.getpid(), b"batch")
            wait_until(lambda: '"b"' in manifest.read_text())
            os.kill(os.getpid(), signal.SIGTERM)
            # The engine ends while FreeCAD does something else.
            wait_until(lambda: not alive(engine))
            return batch_documents.complete_sheet(row, kept, bodies)

        with mock.patch.object(batch, "complete_sheet", interrupted):
            self.assertEqual(self.convert(*sheets), 130)
        self.check_files(self.output / "a")
        self.assertEqual(list(self.output.glob("b.*")), [])
        rows = {name: (row["status"], row["code"]) for name, row in self.documents().items()}
        self.assertEqual(rows, {"a": ("verified", ""), "b": ("failed", "cancelled")})
        self.assertEqual([row["exit_code"] for row in self.rows().values()], ["0", "0", "130"])
        self.behave("ok")
        self.assertEqual(self.convert(*sheets, "--resume"), 0)
        for name in "bc":
            self.check_files(self.output / name)

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
        words += ["--workers", "2", "--memory", "1.5", "--seconds", "90", "--resume"]
        job = parse_options([sheet, "--output", str(self.output), *words]).job
        settings = job.settings
        self.assertEqual((settings.preset, settings.page, settings.seed), (Preset.FINE, 3, 9))
        self.assertEqual((settings.recipe, settings.scale_down), (Recipe.PAPER, 4))
        self.assertEqual((settings.scale.kind, settings.scale.value), (ScaleKind.MM_PER_PIXEL, 0.5))
        arguments = job.arguments()
        self.assertEqual(arguments[:3], ["batch", "--output", str(self.output)])
        self.assertEqual(arguments[-3:], ["--events", "--", sheet])
        limits = ["--workers", "2", "--memory", "1.5", "--seconds", "90", "--resume"]
        at = arguments.index("--workers")
        self.assertEqual(arguments[at : at + 7], limits)


class Resumed(BatchCase):
    def setUp(self) -> None:
        super().setUp()
        for name in "abc":
            draw_sheet(self.sheets / f"{name}.png")
        self.assertEqual(self.convert(self.sheets), 0)

    def stamps(self) -> dict[str, tuple[int, int]]:
        files = [path for path in self.output.glob("?.*") if path.suffix in SUFFIXES]
        states = {path.name: path.stat() for path in files}
        return {name: (state.st_ino, state.st_mtime_ns) for name, state in states.items()}

    def resume(self) -> set[str]:
        """Names of the files that are new."""
        before = self.stamps()
        self.assertEqual(self.convert(self.sheets, "--resume"), 0)
        after = self.stamps()
        self.assertEqual(len(after), 9)
        return {name for name in after if after[name] != before.get(name)}

    def test_only_what_is_not_whole_is_made(self) -> None:
        self.assertEqual(self.resume(), set())
        whole = (self.output / "a.FCStd").read_bytes()
        (self.output / "a.FCStd").write_bytes(whole[: len(whole) // 2])
        (self.output / "b.step").unlink()
        self.assertEqual(self.resume(), {"a.FCStd", "a.step", "a.stl", "b.step"})
        for name in "abc":
            self.check_files(self.output / name)
        self.assertEqual(self.resume(), set())

    def test_a_document_of_an_earlier_result_is_made_anew(self) -> None:
        path = self.output / "b" / "report.json"
        path.write_text(path.read_text().replace('"seed": 0', '"seed": 1'))
        self.assertEqual(self.resume(), {"b.FCStd", "b.step", "b.stl"})

    def test_what_people_did_in_a_document_stays(self) -> None:
        document = FreeCAD.openDocument(str(self.output / "c.FCStd"))
        document.addObject("Part::Box", "Mine")
        document.save()
        FreeCAD.closeDocument(document.Name)
        self.assertEqual(self.resume(), set())

    def test_what_a_killed_console_left_is_removed(self) -> None:
        child = os.fork()
        if child == 0:
            held = staging(self.output)
            held.__enter__()
            os._exit(0)
        os.waitpid(child, 0)
        self.assertEqual(len(list(self.output.glob(".gaussiancad-*"))), 1)
        self.assertEqual(self.resume(), set())
        self.assertEqual(list(self.output.glob(".gaussiancad-*")), [])

    def test_a_file_that_cannot_be_written_fails_one_sheet_only(self) -> None:
        (self.output / "b.FCStd").unlink()
        (self.output / "b.FCStd").mkdir()
        self.assertEqual(self.convert(self.sheets, "--resume"), 1)
        rows = {name: (row["status"], row["code"]) for name, row in self.documents().items()}
        self.assertEqual(rows.pop("b"), ("failed", "document-not-written"))
        self.assertEqual(set(rows.values()), {("verified", "")})

    def test_without_resume_all_is_new(self) -> None:
        before = self.stamps()
        self.assertEqual(self.convert(self.sheets), 0)
        after = self.stamps()
        self.assertEqual({name for name in after if after[name] == before[name]}, set())


class Safety(BatchCase):
    def test_no_name_and_no_link_leads_out_of_the_folder(self) -> None:
        outside = self.folder / "outside"
        (outside / "cameras").mkdir(parents=True)
        (outside / "cameras" / "mine.txt").write_text("mine")
        sheets = [draw_sheet(self.sheets / f"{name}.png") for name in ("..", "-x", "=1+1")]
        linked = draw_sheet(self.sheets / "linked.png")
        self.output.mkdir()
        (self.output / "linked").symlink_to(outside)
        mine = outside / "mine.FCStd"
        mine.write_text("mine")
        for suffix in (".FCStd", ".step", ".stl"):
            file_of(self.output / "=1+1", suffix).symlink_to(mine)
        before = tree(self.folder, self.output)
        self.assertEqual(self.convert(*sheets, sheets[0], linked), 1)
        self.assertEqual(tree(self.folder, self.output), before)
        rows = self.documents()
        self.assertEqual(list(rows), ["_png", "_-x", "=1+1", "linked"])
        self.assertEqual(rows.pop("linked")["code"], "output-is-link")
        self.assertEqual({row["status"] for row in rows.values()}, {"verified"})
        self.assertFalse((self.output / "=1+1.FCStd").is_symlink())
        self.check_files(self.output / "=1+1")

    def test_a_link_among_the_engines_files_is_not_followed(self) -> None:
        sheet = draw_sheet(self.sheets / "a.png")
        self.assertEqual(self.convert(sheet), 0)
        secret = self.folder / "secret.step"
        secret.write_bytes((self.output / "a" / "solid.step").read_bytes())
        (self.output / "a" / "solid.step").unlink()
        (self.output / "a" / "solid.step").symlink_to(secret)
        (self.output / "a.FCStd").unlink()
        self.assertEqual(self.convert(sheet, "--resume"), 1)
        self.assertEqual(self.documents()["a"]["code"], "output-is-link")
        self.assertFalse((self.output / "a.FCStd").exists())

    def test_what_is_not_written_whole_gets_no_name(self) -> None:
        sheet = draw_sheet(self.sheets / "a.png")

        def half(source: Path, target: Path) -> None:
            content = source.read_bytes()
            target.write_bytes(content[: len(content) // 2])

        with mock.patch.object(batch_documents.shutil, "copyfile", half):
            self.assertEqual(self.convert(sheet), 1)
        row = self.documents()["a"]
        self.assertEqual((row["code"], row["status"]), ("document-not-written", "failed"))
        self.assertEqual(list(self.output.glob("a.*")), [])
        self.assertEqual(list(self.output.glob(".gaussiancad-*")), [])

    def test_a_name_that_is_no_text_ends_no_batch(self) -> None:
        path = Path(os.fsdecode(os.fsencode(self.sheets) + b"/caf\xe9.png"))
        path.write_bytes(draw_sheet(self.sheets / "a.png").read_bytes())
        self.assertEqual(self.convert(self.sheets), 1)
        rows = self.documents()
        self.assertEqual(rows["a"]["status"], "verified")
        self.assertEqual(os.fsencode(rows["caf_"]["sheet"]), os.fsencode(path))
        self.assertEqual((rows["caf_"]["status"], rows["caf_"]["code"]), ("failed", "name-no-text"))
        self.assertEqual(self.rows()["caf_"]["status"], "verified")


class Wholeness(BatchCase):
    def test_files_that_are_cut_damaged_or_links_are_not_whole(self) -> None:
        sheet = draw_sheet(self.sheets / "a.png")
        self.assertEqual(self.convert(sheet), 0)
        report = (self.output / "a" / "report.json").read_text(encoding="utf-8")
        binary = self.folder / "binary.stl"
        write_stl(Part.read(str(fake_part.STEP_FILE)), binary)
        checks = {
            self.output / "a.FCStd": lambda path: is_whole_document(path, report),
            self.output / "a.step": is_whole_step,
            self.output / "a.stl": is_whole_stl,
            binary: is_whole_stl,
        }
        for path, is_whole in checks.items():
            self.assertTrue(is_whole(path), path)
            link = self.folder / "link"
            link.symlink_to(path)
            self.assertFalse(is_whole(link))
            link.unlink()
            self.assertFalse(is_whole(link))
            content = path.read_bytes()
            for share in range(8):
                path.write_bytes(content[: len(content) * share // 8])
                self.assertFalse(is_whole(path), f"{share}/8 of {path}")
            path.write_bytes(content)
        document = self.output / "a.FCStd"
        content = bytearray(document.read_bytes())
        content[len(content) // 2] ^= 1
        document.write_bytes(content)
        self.assertFalse(is_whole_document(document, report))


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


def file_of(stem: Path, suffix: str) -> Path:
    """A file that is made of a sheet; names of sheets may hold dots of their own."""
    return stem.with_name(stem.name + suffix)


def tree(root: Path, but: Path) -> dict[Path, bytes]:
    """All files under a folder but those under another one."""
    files = (path for path in root.rglob("*") if path.is_file() and but not in path.parents)
    return {path: path.read_bytes() for path in files}


def python() -> str:
    """A Python that is not FreeCAD."""
    return "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else "python3"


def wait_until(happened: Callable[[], bool]) -> None:
    """Wait for half a minute at most."""
    deadline = time.monotonic() + 30.0
    while not happened():
        if time.monotonic() > deadline:
            raise TimeoutError
        time.sleep(0.02)


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
