"""Install the engine into an environment that the addon manages, after the user has agreed.

Nothing of FreeCAD's own Python is used or changed: a Python of the system makes a virtual
environment, pip fills it from the lock files in ``core/locks`` (every package checked against its
hash), and the addon's own ``core`` folder is linked into it.  The environment counts as installed
once its marker is written, which happens last.
"""

import json
import os
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from freecad.gaussiancad.engine.environment import clean_environment
from freecad.gaussiancad.engine.locate import MARKER, interpreter_of
from freecad.gaussiancad.engine.locks import EngineBuild, entries, normalised, pins
from freecad.gaussiancad.engine.managed import digest_of
from freecad.gaussiancad.engine.protocol import LineBuffer
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.paths import CORE
from freecad.gaussiancad.qt import QtCore

CPU_INDEX = "https://download.pytorch.org/whl/cpu"
"""Where PyTorch keeps its build for processors; packages from there are checked as all others."""

_DAMAGED = "damaged: "

_DAMAGED_PACKAGES = Path(__file__).with_name("damaged_packages.py")

_BEFORE = ".before"
"""What is appended to the name of an environment while another one takes its place."""

_LINK = (
    "import pathlib, sys, sysconfig; "
    "pathlib.Path(sysconfig.get_path('purelib'), 'gaussiancad_core.pth')"
    ".write_text(sys.argv[1] + '\\n', encoding='utf-8')"
)


@dataclass(frozen=True)
class Step:
    """A program to run.

    Attributes:
        title: for the user.
        program, arguments: what is run.
        may_fail: whether the installation goes on after a failure.
    """

    title: str
    program: str
    arguments: tuple[str, ...]
    may_fail: bool = False


@dataclass(frozen=True)
class InstallWatcher:
    """Who is told what happens.

    Attributes:
        on_step: the title of each step.
        on_log: every line that the programs print.
        on_finished: the end, once: an error for the user, or an empty text.
    """

    on_step: Callable[[str], None]
    on_log: Callable[[str], None]
    on_finished: Callable[[str], None]


class Installer:
    """Runs the steps of an installation, or of a repair, one after the other.

    Args:
        base: a Python of the system.
        root: where the environment is.
        build: of the engine.
        watcher: who is told.
    """

    def __init__(self, base: str, root: Path, build: EngineBuild, watcher: InstallWatcher) -> None:
        self._base = base
        self._root = root
        self._before = root.with_name(root.name + _BEFORE)
        self._build = build
        self._watcher = watcher
        self._indexes: tuple[str, ...] = ()
        self._damaged: set[str] = set()
        self._repairing = False
        self._lines = LineBuffer()
        self._last_line = ""
        self._cancelled = False
        self._finished = False
        self._process = QtCore.QProcess()
        environment = QtCore.QProcessEnvironment()
        for name, value in clean_environment(os.environ).items():
            environment.insert(name, value)
        environment.insert("PIP_NO_INPUT", "1")
        environment.insert("PIP_DISABLE_PIP_VERSION_CHECK", "1")
        self._process.setProcessEnvironment(environment)
        merged = QtCore.QProcess.ProcessChannelMode.MergedChannels
        self._process.setProcessChannelMode(merged)
        self._process.readyReadStandardOutput.connect(self._read)
        self._process.finished.connect(self._on_step_finished)
        self._process.errorOccurred.connect(self._on_process_error)
        self._step: Step | None = None
        self._next: Callable[[bool], Step | None] = self._begin_packages

    def start(self) -> None:
        """Install anew; what was there before comes back where this does not succeed."""
        try:
            self._set_aside()
        except OSError as error:
            self._repairing = True  # what is there stays
            self._end(f"{self._root}: {error.strerror or error}")
            return
        self._root.parent.mkdir(parents=True, exist_ok=True)
        self._run(self._venv())

    def repair(self) -> None:
        """Reinstall what is missing or damaged; all else stays."""
        self._repairing = True
        if interpreter_of(self._root) is None:
            self._run(self._venv("--clear"))
            return
        self._next = self._after_look
        title = translate("GaussianCAD", "Looking for damaged files")
        self._run(Step(title, self._python(), ("-I", "-u", str(_DAMAGED_PACKAGES)), may_fail=True))

    def cancel(self) -> None:
        """Stop; an installation leaves what was there before, a repair what it came to."""
        self._cancelled = True
        self._process.kill()

    def pump(self, milliseconds: int) -> None:
        """Wait for the running step where no event loop does."""
        self._process.waitForFinished(milliseconds)

    def _set_aside(self) -> None:
        if self._before.exists() and not (self._root / MARKER).is_file():
            # An installation ended with FreeCAD; the one before it is whole.
            shutil.rmtree(self._root, ignore_errors=True)
            self._before.rename(self._root)
        shutil.rmtree(self._before, ignore_errors=True)
        if self._root.exists():
            self._root.rename(self._before)

    def _venv(self, *options: str) -> Step:
        title = translate("GaussianCAD", "Making the environment")
        return Step(title, self._base, ("-I", "-m", "venv", *options, str(self._root)))

    def _run(self, step: Step) -> None:
        self._step = step
        self._watcher.on_step(step.title)
        self._process.start(step.program, list(step.arguments))

    def _read(self) -> None:
        for line in self._lines.feed(bytes(self._process.readAllStandardOutput().data())):
            self._last_line = line.strip() or self._last_line
            if line.startswith(_DAMAGED):
                self._damaged.add(normalised(line.removeprefix(_DAMAGED).strip()))
            self._watcher.on_log(line)

    def _on_process_error(self, error: QtCore.QProcess.ProcessError) -> None:
        if error == QtCore.QProcess.ProcessError.FailedToStart:
            self._end(f"{self._step.program}: {self._process.errorString()}")

    def _on_step_finished(self, *_status: object) -> None:
        self._read()
        normal = self._process.exitStatus() == QtCore.QProcess.ExitStatus.NormalExit
        succeeded = normal and self._process.exitCode() == 0
        if self._cancelled:
            self._end(self._cancelled_text())
        elif not succeeded and not self._step.may_fail:
            text = translate("GaussianCAD", "{step} failed: {reason}")
            self._end(text.format(step=self._step.title, reason=self._last_line))
        elif (step := self._next(succeeded)) is not None:
            self._run(step)
        elif not self._finished:
            self._write_marker()
            self._end("")

    def _cancelled_text(self) -> str:
        if self._repairing:
            return translate("GaussianCAD", "The repair was cancelled. Repair again to finish it.")
        return translate("GaussianCAD", "The installation was cancelled.")

    def _after_look(self, succeeded: bool) -> Step | None:
        # From here on the environment changes: it counts as installed again when that has ended.
        (self._root / MARKER).unlink(missing_ok=True)
        if succeeded:
            return self._begin_packages(True)
        self._next = self._begin_packages
        return self._venv("--clear")

    def _begin_packages(self, _succeeded: bool) -> Step | None:
        if self._build is EngineBuild.CPU:
            return self._ask_for_cpu_build(self._after_own_indexes)
        return self._mend_packages()

    def _ask_for_cpu_build(self, then: Callable[[bool], Step | None]) -> Step:
        """Ask pip whether it is offered PyTorch's small build, downloading nothing."""
        self._next = then
        title = translate("GaussianCAD", "Looking for the small build of PyTorch")
        # One that is there, though damaged, would do for pip.
        anew = ("--force-reinstall",) if "torch" in self._damaged else ()
        asked = ("--dry-run", *anew, *self._indexes, "--requirement", self._excerpt({"torch"}))
        return self._pip(title, *asked, may_fail=True)

    def _after_own_indexes(self, offered: bool) -> Step | None:
        if offered:
            return self._mend_packages()
        self._indexes = ("--extra-index-url", CPU_INDEX)
        return self._ask_for_cpu_build(self._after_torch_index)

    def _after_torch_index(self, offered: bool) -> Step | None:
        if offered:
            return self._mend_packages()
        text = translate(
            "GaussianCAD",
            "The build of PyTorch for processors was found neither in the package index that pip "
            "is set up for nor in {index}. Look whether the network is there, or choose the build "
            "for NVIDIA cards, which works without such a card, too.",
        )
        self._end(text.format(index=CPU_INDEX))
        return None

    def _mend_packages(self) -> Step | None:
        known = {one.name for one in pins(self._lock_text())}
        damaged = self._damaged & known
        if not damaged:
            return self._install_packages(True)
        self._next = self._install_packages
        title = translate("GaussianCAD", "Reinstalling damaged packages")
        what = ("--force-reinstall", *self._indexes, "--requirement", self._excerpt(damaged))
        return self._pip(title, *what)

    def _install_packages(self, _succeeded: bool) -> Step | None:
        self._next = self._link
        title = translate("GaussianCAD", "Downloading and installing packages")
        return self._pip(title, *self._indexes, "--requirement", str(self._build.lock))

    def _link(self, _succeeded: bool) -> Step | None:
        self._next = self._check
        title = translate("GaussianCAD", "Linking the engine")
        return Step(title, self._python(), ("-I", "-c", _LINK, str(CORE)))

    def _check(self, _succeeded: bool) -> Step | None:
        self._next = self._warm_up
        title = translate("GaussianCAD", "Checking the engine")
        return Step(title, self._python(), ("-I", "-u", "-m", "gaussiancad_core", "doctor"))

    def _warm_up(self, _succeeded: bool) -> Step | None:
        """Compile the kernels ahead of the first run, which would compile them itself."""
        self._next = lambda _succeeded: None
        title = translate("GaussianCAD", "Compiling the engine's kernels")
        arguments = ("-I", "-u", "-m", "gaussiancad_core", "warm-up")
        return Step(title, self._python(), arguments, may_fail=True)

    def _pip(self, title: str, *arguments: str, may_fail: bool = False) -> Step:
        fixed = ("--require-hashes", "--only-binary", ":all:", "--no-deps", "--progress-bar", "off")
        pip = ("-I", "-u", "-m", "pip", "install", *fixed, *arguments)
        return Step(title, self._python(), pip, may_fail)

    def _python(self) -> str:
        found = interpreter_of(self._root)
        return str(found) if found is not None else str(self._root / "bin" / "python")

    def _lock_text(self) -> str:
        return self._build.lock.read_text(encoding="utf-8")

    def _excerpt(self, names: set[str]) -> str:
        """A file with a part of the lock."""
        path = self._root / "packages.txt"
        path.write_text(entries(self._lock_text(), names), encoding="utf-8")
        return str(path)

    def _write_marker(self) -> None:
        digest = digest_of(self._build)
        facts = {"build": self._build.value, "lock_sha256": digest, "base": self._base}
        (self._root / MARKER).write_text(json.dumps(facts, indent=2) + "\n", encoding="utf-8")

    def _end(self, error: str) -> None:
        if self._finished:
            return
        self._finished = True
        if error and not self._repairing:
            shutil.rmtree(self._root, ignore_errors=True)
            if self._before.exists():
                self._before.rename(self._root)
        else:
            shutil.rmtree(self._before, ignore_errors=True)
        self._watcher.on_finished(error)
