"""A script in FreeCAD's window, on a virtual screen, with a profile of its own.

A user's settings do not count.  FreeCAD imports the script, which ends FreeCAD itself.  What
FreeCAD says goes to standard error.
"""

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

ADDON = Path(__file__).resolve().parents[1]

WIDTH, HEIGHT = 1400, 860
"""px of the screen."""

_SETTINGS = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters>
  <FCParamGroup Name="Root">
    <FCParamGroup Name="BaseApp">
      <FCParamGroup Name="Preferences">
        <FCParamGroup Name="General">
          <FCText Name="AutoloadModule">PartWorkbench</FCText>
          <FCText Name="Language">English</FCText>
          <FCBool Name="ShowSplasher" Value="0"/>
        </FCParamGroup>
        <FCParamGroup Name="Mod">
          <FCParamGroup Name="Start">
            <FCBool Name="ShowOnStartup" Value="0"/>
          </FCParamGroup>
        </FCParamGroup>
        <FCParamGroup Name="OutputWindow">
          <FCBool Name="checkShowReportViewOnError" Value="0"/>
          <FCBool Name="checkShowReportViewOnWarning" Value="0"/>
        </FCParamGroup>
      </FCParamGroup>
    </FCParamGroup>
  </FCParamGroup>
</FCParameters>
"""
"""No start page, and no report view that opens by itself."""


def run_in_window(
    script: Path, profile: Path, variables: Mapping[str, str], limit_seconds: float
) -> int:
    """Run a script in FreeCAD's window; the exit status of FreeCAD.

    The engine is that in ``.venv``, or GAUSSIANCAD_PYTHON's.

    Args:
        script: the file that FreeCAD imports.
        profile: an empty folder for FreeCAD's settings.
        variables: of the environment, for the script.
        limit_seconds: after which FreeCAD is ended.

    Raises:
        subprocess.TimeoutExpired: it did not end in time.
    """
    (profile / "Mod").mkdir(parents=True)
    (profile / "Mod" / "GaussianCAD").symlink_to(ADDON, target_is_directory=True)
    (profile / "user.cfg").write_text(_SETTINGS, encoding="utf-8")
    engine = os.environ.get("GAUSSIANCAD_PYTHON") or str(ADDON / ".venv" / "bin" / "python")
    environment = {
        **os.environ,
        "FREECAD_USER_HOME": str(profile),
        "GAUSSIANCAD_PYTHON": engine,
        "LC_ALL": "C.UTF-8",
        "PYTHONDONTWRITEBYTECODE": "1",
        **variables,
    }
    screen = ("xvfb-run", "-a", "-s", f"-screen 0 {WIDTH}x{HEIGHT}x24")
    ended = subprocess.run(
        [*screen, "freecad", str(script)],
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=sys.stderr,
        timeout=limit_seconds,
        check=False,
    )
    return ended.returncode
