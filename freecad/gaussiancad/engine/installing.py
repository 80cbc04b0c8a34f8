"""Install the engine into an environment that the addon manages, after the user has agreed.

Nothing of FreeCAD's own Python is used or changed: a Python of the system makes a virtual
environment, pip fills it from the lock files in ``core/locks`` (every package checked against its
hash), and the addon's own ``core`` folder is linked into it.  The environment counts as installed
once its marker is written, which happens last.
"""

import hashlib
import json
import os
import shutil
import subprocess
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from freecad.gaussiancad.engine.environment import clean_environment
from freecad.gaussiancad.engine.events import LineBuffer
from freecad.gaussiancad.engine.locate import MARKER, interpreter_of
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.paths import CORE
from freecad.gaussiancad.qt import QtCore

PYTHON_NAMES = ("python3.13", "python3.12", "python3.11", "python3.14", "python3", "python")

_USABLE = "import ensurepip, sys, venv; sys.exit(not (3, 11) <= sys.version_info < (3, 15))"

_LINK = (
    "import pathlib, sys, sysconfig; "
    "pathlib.Path(sysconfig.get_path('purelib'), 'gaussiancad_core.pth')"
    ".write_text(sys.argv[1] + '\\n', encoding='utf-8')"
)


class TorchBuild(Enum):
    """The two builds of PyTorch that there are locks for."""

    CPU = "cpu"
    CUDA = "cuda"

    @property
    def lock(self) -> Path:
        """The lock file."""
        return CORE / "locks" / f"engine-{self.value}.txt"


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


def find_base_python(variables: Mapping[str, str]) -> str:
    """A Python of the system that can make environments, 3.11 to 3.14.

    Args:
        variables: the environment variables.

    Raises:
        WorkbenchError: there is none.
    """
    clean = clean_environment(variables)
    for name in PYTHON_NAMES:
        found = shutil.which(name, path=clean.get("PATH"))
        if found and _is_usable(found, clean):
            return found
    raise WorkbenchError(
        ErrorCode.ENGINE_NOT_FOUND,
        translate(
            "GaussianCAD",
            "No Python from 3.11 to 3.14 with its venv module was found. Install one (on Debian: "
            "apt-get install python3-venv), then try again.",
        ),
    )


def torch_entry(lock_text: str) -> str:
    """The lines of a lock that pin PyTorch, with their hashes."""
    entry: list[str] = []
    for line in lock_text.splitlines():
        if line.startswith("torch=="):
            entry = [line]
        elif entry and line.startswith(" "):
            entry.append(line)
        elif entry:
            break
    return "\n".join([*entry, ""])


class Installer:
    """Runs the steps of an installation one after the other.

    Args:
        base: a Python of the system.
        root: where the environment is made; what is there is replaced.
        watcher: who is told.
    """

    def __init__(self, base: str, root: Path, watcher: InstallWatcher) -> None:
        self._base = base
        self._root = root
        self._watcher = watcher
        self._build = TorchBuild.CUDA
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
        self._next: Callable[[bool], Step | None] = self._ask_for_cpu_build

    def start(self) -> None:
        """Begin; all that follows comes through the watcher."""
        shutil.rmtree(self._root, ignore_errors=True)
        self._root.parent.mkdir(parents=True, exist_ok=True)
        title = translate("GaussianCAD", "Making the environment")
        self._run(Step(title, self._base, ("-I", "-m", "venv", str(self._root))))

    def cancel(self) -> None:
        """Stop, and remove what was made."""
        self._cancelled = True
        self._process.kill()

    def pump(self, milliseconds: int) -> None:
        """Wait for the running step where no event loop does."""
        self._process.waitForFinished(milliseconds)

    def _run(self, step: Step) -> None:
        self._step = step
        self._watcher.on_step(step.title)
        self._process.start(step.program, list(step.arguments))

    def _read(self) -> None:
        for line in self._lines.feed(bytes(self._process.readAllStandardOutput().data())):
            self._last_line = line.strip() or self._last_line
            self._watcher.on_log(line)

    def _on_process_error(self, error: QtCore.QProcess.ProcessError) -> None:
        if error == QtCore.QProcess.ProcessError.FailedToStart:
            self._end(f"{self._step.program}: {self._process.errorString()}")

    def _on_step_finished(self, *_status: object) -> None:
        self._read()
        normal = self._process.exitStatus() == QtCore.QProcess.ExitStatus.NormalExit
        succeeded = normal and self._process.exitCode() == 0
        if self._cancelled:
            self._end(translate("GaussianCAD", "The installation was cancelled."))
        elif not succeeded and not self._step.may_fail:
            text = translate("GaussianCAD", "{step} failed: {reason}")
            self._end(text.format(step=self._step.title, reason=self._last_line))
        elif (step := self._next(succeeded)) is not None:
            self._run(step)
        else:
            self._write_marker()
            self._end("")

    def _ask_for_cpu_build(self, _succeeded: bool) -> Step | None:
        """Ask pip for PyTorch's small build, unless there is an NVIDIA card."""
        if shutil.which("nvidia-smi"):
            self._next = self._link
            return self._pip_install(TorchBuild.CUDA)
        entry = self._root / "torch.txt"
        entry.write_text(torch_entry(TorchBuild.CPU.lock.read_text(encoding="utf-8")))
        self._next = self._install_packages
        title = translate("GaussianCAD", "Looking for the small build of PyTorch")
        return self._pip(title, "--dry-run", "--requirement", str(entry), may_fail=True)

    def _install_packages(self, cpu_build_is_offered: bool) -> Step | None:
        self._next = self._link
        return self._pip_install(TorchBuild.CPU if cpu_build_is_offered else TorchBuild.CUDA)

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

    def _pip_install(self, build: TorchBuild) -> Step:
        self._build = build
        title = translate("GaussianCAD", "Downloading and installing packages")
        return self._pip(title, "--requirement", str(build.lock))

    def _pip(self, title: str, *arguments: str, may_fail: bool = False) -> Step:
        fixed = ("--require-hashes", "--only-binary", ":all:", "--no-deps", "--progress-bar", "off")
        pip = ("-I", "-u", "-m", "pip", "install", *fixed, *arguments)
        return Step(title, self._python(), pip, may_fail)

    def _python(self) -> str:
        found = interpreter_of(self._root)
        return str(found) if found is not None else str(self._root / "bin" / "python")

    def _write_marker(self) -> None:
        digest = hashlib.sha256(self._build.lock.read_bytes()).hexdigest()
        facts = {"build": self._build.value, "lock_sha256": digest, "base": self._base}
        (self._root / MARKER).write_text(json.dumps(facts, indent=2) + "\n", encoding="utf-8")

    def _end(self, error: str) -> None:
        if self._finished:
            return
        self._finished = True
        if error:
            shutil.rmtree(self._root, ignore_errors=True)
        self._watcher.on_finished(error)


def _is_usable(python: str, variables: Mapping[str, str]) -> bool:
    try:
        ended = subprocess.run(
            [python, "-I", "-c", _USABLE],
            env=dict(variables),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=20,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return False
    return ended.returncode == 0
