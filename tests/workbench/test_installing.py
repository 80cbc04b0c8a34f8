"""The managed environment: made in order, marked last, removed after a failure."""

import json
import os
from pathlib import Path

from support import FolderCase

from freecad.gaussiancad.engine.installing import (
    Installer,
    InstallWatcher,
    TorchBuild,
    find_base_python,
    torch_entry,
)
from freecad.gaussiancad.engine.locate import MARKER, SearchPlaces, find_engine
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.paths import CORE

FAKE_PYTHON = str(Path(__file__).parent / "fake_python.py")


class Installations(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.root = self.folder / "engine"
        self.asked = self.folder / "asked"
        self.set_variable("GAUSSIANCAD_FAKE_LOG", str(self.asked))
        self.set_variable("PATH", str(self.folder) + os.pathsep + "/usr/bin:/bin")
        self.ends: list[str] = []

    def install(self, cancel_at: str = "") -> list[list[str]]:
        """Install to the end; return what the fake Python was asked to do."""

        reached: list[str] = []

        def on_step(title: str) -> None:
            if cancel_at and cancel_at in title:
                reached.append(title)

        watcher = InstallWatcher(on_step, lambda line: None, self.ends.append)
        installer = Installer(FAKE_PYTHON, self.root, watcher)
        installer.start()
        while not self.ends:
            installer.pump(50)
            if reached:
                installer.cancel()
        return [json.loads(line) for line in self.asked.read_text().splitlines()]

    def test_the_small_build_is_taken_where_it_is_offered(self) -> None:
        asked = self.install()
        self.assertEqual(self.ends, [""])
        self.assertEqual(asked[0], ["-I", "-m", "venv", str(self.root)])
        self.assertIn("--dry-run", asked[1])
        self.assertEqual(asked[2][-1], str(TorchBuild.CPU.lock))
        for arguments in asked[1:3]:
            self.assertIn("--require-hashes", arguments)
            self.assertIn("--no-deps", arguments)
        self.assertEqual(asked[3][-1], str(CORE))
        self.assertEqual(asked[4], ["-I", "-u", "-m", "gaussiancad_core", "doctor"])
        self.assertEqual(asked[5], ["-I", "-u", "-m", "gaussiancad_core", "warm-up"])
        self.assertEqual(len(asked), 6)
        self.assertEqual(json.loads((self.root / MARKER).read_text())["build"], "cpu")
        engine = find_engine(SearchPlaces("", "", self.root, self.folder / "none"))
        self.assertEqual(engine.python, str(self.root / "bin" / "python"))

    def test_the_large_build_is_taken_where_the_small_one_is_not_offered(self) -> None:
        self.set_variable("GAUSSIANCAD_FAKE_FAILS", "--dry-run")
        asked = self.install()
        self.assertEqual(self.ends, [""])
        self.assertEqual(asked[2][-1], str(TorchBuild.CUDA.lock))
        self.assertEqual(json.loads((self.root / MARKER).read_text())["build"], "cuda")

    def test_kernels_that_do_not_compile_ahead_are_no_failure(self) -> None:
        self.set_variable("GAUSSIANCAD_FAKE_FAILS", "warm-up")
        self.install()
        self.assertEqual(self.ends, [""])

    def test_a_failure_is_told_and_leaves_nothing(self) -> None:
        for step in ("venv", "engine-cpu.txt", "doctor"):
            self.ends.clear()
            self.set_variable("GAUSSIANCAD_FAKE_FAILS", step)
            self.install()
            (error,) = self.ends
            self.assertIn(f"ERROR: no {step} here", error)
            self.assertFalse(self.root.exists())

    def test_a_cancelled_installation_leaves_nothing(self) -> None:
        self.behave("slow")
        self.install(cancel_at="Looking")
        self.assertEqual(self.ends, ["The installation was cancelled."])
        self.assertFalse(self.root.exists())

    def test_the_systems_python_is_found_and_others_are_passed_over(self) -> None:
        self.set_variable("GAUSSIANCAD_FAKE_LOG", str(self.asked))
        with self.assertRaises(WorkbenchError) as caught:
            find_base_python({"PATH": str(self.folder)})
        self.assertIs(caught.exception.code, ErrorCode.ENGINE_NOT_FOUND)
        usable = self.folder / "python3.12"
        usable.write_text("#!/bin/sh\nexit 0\n")
        useless = self.folder / "python3.13"
        useless.write_text("#!/bin/sh\nexit 1\n")
        for program in (usable, useless):
            program.chmod(0o755)
        self.assertEqual(find_base_python({"PATH": str(self.folder)}), str(usable))

    def test_pytorchs_entry_is_cut_out_of_the_lock(self) -> None:
        for build in TorchBuild:
            entry = torch_entry(build.lock.read_text(encoding="utf-8"))
            self.assertTrue(entry.startswith("torch=="))
            self.assertEqual(entry.count("=="), 1)
            self.assertIn("--hash=sha256:", entry)
        self.assertEqual(torch_entry("a==1 \\\n    --hash=x\n"), "")
