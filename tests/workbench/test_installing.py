"""The managed environment: made in order, marked last, removed after a failure."""

import base64
import hashlib
import json
import os
import subprocess
from pathlib import Path

from support import FolderCase

from freecad.gaussiancad.engine import damaged_packages
from freecad.gaussiancad.engine.base_python import find_base_python
from freecad.gaussiancad.engine.installing import CPU_INDEX, Installer, InstallWatcher
from freecad.gaussiancad.engine.locate import MARKER, SearchPlaces, find_engine
from freecad.gaussiancad.engine.locks import EngineBuild, entries, pins
from freecad.gaussiancad.engine.managed import Condition, look_at, remove
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.paths import CORE

DAMAGED_PACKAGES = Path(damaged_packages.__file__)

FAKE_PYTHON = str(Path(__file__).parent / "fake_python.py")


class Installations(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.root = self.folder / "engine"
        self.asked = self.folder / "asked"
        self.set_variable("GAUSSIANCAD_FAKE_LOG", str(self.asked))
        self.set_variable("PATH", str(self.folder) + os.pathsep + "/usr/bin:/bin")
        self.ends: list[str] = []

    def install(
        self, cancel_at: str = "", build: EngineBuild = EngineBuild.CPU, repair: bool = False
    ) -> list[list[str]]:
        """Install or repair to the end; return what the fake Python was asked to do."""
        self.ends.clear()
        self.asked.write_text("")

        reached: list[str] = []

        def on_step(title: str) -> None:
            if cancel_at and cancel_at in title:
                reached.append(title)

        watcher = InstallWatcher(on_step, lambda line: None, self.ends.append)
        installer = Installer(FAKE_PYTHON, self.root, build, watcher)
        installer.repair() if repair else installer.start()
        while not self.ends:
            installer.pump(50)
            if reached:
                installer.cancel()
        return [json.loads(line) for line in self.asked.read_text().splitlines()]

    def test_the_small_build_is_installed_step_by_step(self) -> None:
        asked = self.install()
        self.assertEqual(self.ends, [""])
        self.assertEqual(asked[0], ["-I", "-m", "venv", str(self.root)])
        self.assertIn("--dry-run", asked[1])
        self.assertEqual(asked[2][-1], str(EngineBuild.CPU.lock))
        for arguments in asked[1:3]:
            self.assertIn("--require-hashes", arguments)
            self.assertIn("--no-deps", arguments)
            self.assertNotIn(CPU_INDEX, arguments)
        self.assertEqual(asked[3][-1], str(CORE))
        self.assertEqual(asked[4], ["-I", "-u", "-m", "gaussiancad_core", "doctor"])
        self.assertEqual(asked[5], ["-I", "-u", "-m", "gaussiancad_core", "warm-up"])
        self.assertEqual(len(asked), 6)
        self.assertEqual(json.loads((self.root / MARKER).read_text())["build"], "cpu")
        engine = find_engine(SearchPlaces("", "", self.root, self.folder / "none"))
        self.assertEqual(engine.python, str(self.root / "bin" / "python"))

    def test_the_small_build_that_no_index_offers_is_told_and_nothing_else_taken(self) -> None:
        self.set_variable("GAUSSIANCAD_FAKE_FAILS", "--dry-run")
        asked = self.install()
        self.assertEqual([CPU_INDEX in arguments for arguments in asked], [False, False, True])
        self.assertIn(CPU_INDEX, self.ends[0])
        self.assertFalse(self.root.exists())

    def test_pytorchs_own_index_helps_where_pips_lacks_the_small_build(self) -> None:
        # The second question is the one that names the index.
        self.set_variable("GAUSSIANCAD_FAKE_FAILS", "--dry-run --requirement")
        asked = self.install()
        self.assertEqual(self.ends, [""])
        self.assertEqual(asked[3][-4:-1], ["--extra-index-url", CPU_INDEX, "--requirement"])
        self.assertEqual(json.loads((self.root / MARKER).read_text())["build"], "cpu")

    def test_the_large_build_is_taken_where_it_was_chosen(self) -> None:
        asked = self.install(build=EngineBuild.CUDA)
        self.assertEqual(self.ends, [""])
        self.assertEqual(asked[1][-1], str(EngineBuild.CUDA.lock))
        self.assertEqual(json.loads((self.root / MARKER).read_text())["build"], "cuda")
        self.assertIs(look_at(self.root).build, EngineBuild.CUDA)

    def test_the_engine_of_solids_alone_asks_for_no_pytorch(self) -> None:
        asked = self.install(build=EngineBuild.SOLID)
        self.assertEqual(self.ends, [""])
        self.assertFalse(any("--dry-run" in arguments for arguments in asked))
        self.assertEqual(asked[1][-1], str(EngineBuild.SOLID.lock))
        names = {pin.name for pin in pins(EngineBuild.SOLID.lock.read_text(encoding="utf-8"))}
        self.assertIn("cadquery-ocp-novtk", names)
        self.assertFalse({"torch", "open3d", "open3d-cpu"} & names)
        self.assertEqual(json.loads((self.root / MARKER).read_text())["build"], "solid")
        self.assertIs(look_at(self.root).build, EngineBuild.SOLID)
        self.assertIs(look_at(self.root).condition, Condition.COMPLETE)

    def test_what_was_there_comes_back_after_a_failure_or_a_cancel(self) -> None:
        self.install()
        marker = (self.root / MARKER).read_text()
        self.set_variable("GAUSSIANCAD_FAKE_FAILS", "engine-cuda.txt")
        self.install(build=EngineBuild.CUDA)
        self.assertIn("failed", self.ends[0])
        self.install(build=EngineBuild.CUDA, cancel_at="Making")
        self.assertIn("cancelled", self.ends[0])
        self.assertEqual((self.root / MARKER).read_text(), marker)
        self.assertIs(look_at(self.root).condition, Condition.COMPLETE)
        left = sorted(path.name for path in self.root.parent.iterdir())
        self.assertEqual(left, ["asked", "engine"])

    def test_a_repair_reinstalls_what_is_damaged_and_keeps_the_rest(self) -> None:
        self.install()
        kept = self.root / "kept"
        kept.touch()
        self.set_variable("GAUSSIANCAD_FAKE_DAMAGED", "damaged: NumPy")
        asked = self.install(repair=True)
        self.assertEqual(self.ends, [""])
        self.assertIn("damaged_packages.py", asked[0][-1])
        forced = [arguments for arguments in asked if "--force-reinstall" in arguments]
        self.assertEqual(len(forced), 1)
        text = Path(forced[0][-1]).read_text()
        self.assertEqual({pin.name for pin in pins(text)}, {"numpy"})
        self.assertTrue(kept.exists())
        self.assertIs(look_at(self.root).condition, Condition.COMPLETE)

    def test_a_damaged_pytorch_is_looked_for_anew(self) -> None:
        self.install()
        self.set_variable("GAUSSIANCAD_FAKE_DAMAGED", "damaged: torch")
        asked = self.install(repair=True)
        self.assertEqual(self.ends, [""])
        looked = [arguments for arguments in asked if "--dry-run" in arguments]
        self.assertEqual(["--force-reinstall" in arguments for arguments in looked], [True])

    def test_a_repair_that_stops_can_be_taken_up_again(self) -> None:
        self.install()
        self.set_variable("GAUSSIANCAD_FAKE_FAILS", "engine-cpu.txt")
        self.install(repair=True)
        self.assertIn("failed", self.ends[0])
        self.assertIs(look_at(self.root).condition, Condition.INCOMPLETE)
        self.set_variable("GAUSSIANCAD_FAKE_FAILS", "")
        self.install(repair=True)
        self.assertIs(look_at(self.root).condition, Condition.COMPLETE)

    def test_an_environment_without_a_python_is_made_anew_by_a_repair(self) -> None:
        self.install()
        (self.root / "bin" / "python").unlink()
        self.assertIs(look_at(self.root).condition, Condition.INCOMPLETE)
        asked = self.install(repair=True)
        self.assertEqual(asked[0], ["-I", "-m", "venv", "--clear", str(self.root)])
        self.assertIs(look_at(self.root).condition, Condition.COMPLETE)

    def test_removing_takes_all_or_nothing(self) -> None:
        self.install()
        remove(self.root)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["asked"])
        self.assertIs(look_at(self.root).condition, Condition.ABSENT)
        self.root.mkdir()
        (self.root / "thesis.txt").touch()
        elsewhere = self.folder / "elsewhere"
        elsewhere.symlink_to(self.root)
        for folder in (self.root, elsewhere):
            with self.assertRaises(WorkbenchError):
                remove(folder)
        self.assertTrue((self.root / "thesis.txt").exists())

    def test_damaged_files_are_found_by_the_environments_python(self) -> None:
        packages = self.folder / "packages"
        for name in ("whole", "changed", "lacking"):
            info = packages / f"{name}-1.0.dist-info"
            info.mkdir(parents=True)
            (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
            (packages / f"{name}.py").write_text("x = 1\n")
            digest = hashlib.sha256(b"x = 1\n").digest()
            stated = base64.urlsafe_b64encode(digest).rstrip(b"=").decode()
            (info / "RECORD").write_text(
                f"{name}.py,sha256={stated},6\n{name}.pyc,sha256=other,7\n"
            )
        (packages / "changed.py").write_text("x = 2\n")
        (packages / "lacking.py").unlink()
        ended = subprocess.run(
            [find_base_python({"PATH": "/usr/bin:/bin"}), str(DAMAGED_PACKAGES)],
            env={"PYTHONPATH": str(packages)},
            capture_output=True,
            text=True,
            check=True,
            timeout=120,
        )
        found = {line for line in ended.stdout.splitlines() if line.startswith("damaged: ")}
        self.assertTrue({"damaged: changed", "damaged: lacking"} <= found, found)
        self.assertNotIn("damaged: whole", found)

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

    def test_entries_are_cut_out_of_the_lock(self) -> None:
        for build in (EngineBuild.CPU, EngineBuild.CUDA):
            entry = entries(build.lock.read_text(encoding="utf-8"), {"torch"})
            self.assertTrue(entry.startswith("torch=="))
            self.assertEqual(entry.count("=="), 1)
            self.assertIn("--hash=sha256:", entry)
        self.assertEqual(entries("a==1 \\\n    --hash=x\n", {"torch"}), "\n".join([""]))
        both = "A.b==1 ; python_version < '3.12' \\\n    --hash=x\nc==2\n"
        self.assertEqual([pin.everywhere for pin in pins(both)], [False, True])
        self.assertEqual(entries(both, {"a-b"}), both.replace("c==2\n", ""))
