#!/usr/bin/env python3
"""Stands in for a system's Python and for the one of an environment, for the installer's tests.

It makes an environment that holds a copy of itself, and notes what it is asked to do in the file
that GAUSSIANCAD_FAKE_LOG names.  What has the word in GAUSSIANCAD_FAKE_FAILS in it fails.
"""

import json
import os
import re
import shutil
import sys
import time
from pathlib import Path


def install(lock: Path) -> None:
    """Leave what installers look at: a folder for each package of a lock."""
    packages = Path(sys.argv[0]).parent.parent / "lib" / "python3" / "site-packages"
    for name, version in re.findall(r"^(\S+)==(\S+)", lock.read_text(), re.MULTILINE):
        folder = packages / f"{name.replace('-', '_')}-{version}.dist-info"
        folder.mkdir(parents=True, exist_ok=True)


def main() -> int:
    """Do what the arguments say."""
    arguments = sys.argv[1:]
    with open(os.environ["GAUSSIANCAD_FAKE_LOG"], "a", encoding="utf-8") as log:
        log.write(json.dumps(arguments) + "\n")
    words = " ".join(arguments)
    print(f"asked for {words[:60]}", flush=True)
    failing = os.environ.get("GAUSSIANCAD_FAKE_FAILS", "")
    if failing and failing in words:
        print(f"ERROR: no {failing} here", flush=True)
        return 1
    if "venv" in arguments:
        folder = Path(arguments[-1]) / "bin"
        folder.mkdir(parents=True, exist_ok=True)
        shutil.copy(__file__, folder / "python")
        (folder.parent / "pyvenv.cfg").touch()
    if "damaged_packages.py" in words:
        print(os.environ.get("GAUSSIANCAD_FAKE_DAMAGED", ""), flush=True)
    if "pip" in arguments and "--dry-run" not in arguments:
        install(Path(arguments[-1]))
    if os.environ.get("GAUSSIANCAD_FAKE") == "slow" and "pip" in arguments:
        time.sleep(60)
    return 0


if __name__ == "__main__":
    sys.exit(main())
