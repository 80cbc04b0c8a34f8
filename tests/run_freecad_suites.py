"""Run the FreeCAD tests in a profile of their own: ``python3 tests/run_freecad_suites.py``.

Arguments are the suites, ``workbench`` and ``gui``; both without arguments.  The addon is linked
into the profile, so that FreeCAD finds it the way it does on a user's machine.  The window runs on
a virtual screen.  Pictures go to GAUSSIANCAD_ARTIFACTS (default ``build/artifacts``).
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ADDON = Path(__file__).resolve().parent.parent
SCRIPT = str(ADDON / "tests" / "run_freecad.py")
TIME_LIMIT_SECONDS = 1200

REPORTED = 8000
"""Characters at the end of a suite's report that a failure shows."""

SKIPPED = ADDON / "build" / "skipped"
"""Folder of files that tell what was skipped, and why."""

CONSOLES = ("freecadcmd", "FreeCADCmd", "freecad-cmd")
WINDOWS = ("freecad", "FreeCAD")
SCREEN = ("xvfb-run", "-a", "-s", "-screen 0 1600x1000x24")


def program(names: tuple[str, ...]) -> str:
    """The first of the programs that is installed."""
    for name in names:
        if shutil.which(name):
            return name
    sys.exit(f"none of {', '.join(names)} is installed: run make install")


def command(suite: str) -> list[str]:
    """The command line that runs a suite."""
    if suite == "workbench":
        return [program(CONSOLES), SCRIPT]
    return [program(SCREEN[:1]), *SCREEN[1:], program(WINDOWS), SCRIPT]


def environment(profile: Path) -> dict[str, str]:
    """This process's variables, with the profile and what a virtual screen needs."""
    artifacts = os.environ.get("GAUSSIANCAD_ARTIFACTS") or str(ADDON / "build" / "artifacts")
    return {
        **os.environ,
        "FREECAD_USER_HOME": str(profile),
        "GAUSSIANCAD_ARTIFACTS": artifacts,
        "GAUSSIANCAD_SKIPPED": str(SKIPPED),
        "LC_ALL": "C.UTF-8",
        "PYTHONDONTWRITEBYTECODE": "1",
        "QTWEBENGINE_DISABLE_SANDBOX": "1",
    }


def report_of(suite: str) -> tuple[bool, str]:
    """Whether a suite passes, and the end of what it prints."""
    done = subprocess.run(
        [sys.executable, str(Path(__file__).resolve()), suite],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    return done.returncode == 0, done.stdout.decode("utf-8", "replace")[-REPORTED:]


def run_suite(suite: str) -> int:
    """Run a suite in a fresh profile; return its exit status."""
    with tempfile.TemporaryDirectory(prefix="gaussiancad-profile-") as folder:
        profile = Path(folder)
        (profile / "Mod").mkdir()
        (profile / "Mod" / "GaussianCAD").symlink_to(ADDON, target_is_directory=True)
        variables = environment(profile)
        Path(variables["GAUSSIANCAD_ARTIFACTS"]).mkdir(parents=True, exist_ok=True)
        try:
            ended = subprocess.run(
                command(suite),
                env=variables,
                stdin=subprocess.DEVNULL,
                timeout=TIME_LIMIT_SECONDS,
                check=False,
            )
        except subprocess.TimeoutExpired:
            print(f"{suite}: stopped after {TIME_LIMIT_SECONDS} s", file=sys.stderr)
            return 1
    print(f"{suite}: {'passed' if ended.returncode == 0 else 'FAILED'}", flush=True)
    return ended.returncode


def main() -> int:
    """Run the suites that the arguments name."""
    suites = sys.argv[1:] or ["workbench", "gui"]
    if unknown := set(suites) - {"workbench", "gui"}:
        sys.exit(f"unknown suite {', '.join(sorted(unknown))}: use workbench or gui")
    return max(run_suite(suite) != 0 for suite in suites)


if __name__ == "__main__":
    sys.exit(main())
