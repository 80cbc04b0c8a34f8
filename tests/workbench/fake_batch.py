"""The fake engine's ``batch``: its own ``reconstruct`` for each sheet, in a process of its own.

It names folders by the engine's own rules.  What was done is in ``manifest.sqlite``, as JSON: a
sheet whose report is there is kept with ``--resume``.
"""

import csv
import importlib.util
import itertools
import json
import os
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

Send = Callable[..., None]

_TOLD = re.compile(r"gaussiancad: (.*) \[([a-z-]+)\]")
_SUFFIXES = (".png", ".jpg")
_CSV = {"encoding": "utf-8", "errors": "backslashreplace", "newline": ""}
_COLUMNS = (
    *("name", "sheet", "folder", "status", "measures_mm", "exit_code", "code"),
    *("message", "seconds"),
)


def engine_module(name: str) -> ModuleType:
    """A module of the engine that needs nothing else of it."""
    core = Path(__file__).resolve().parents[2] / "core" / "gaussiancad_core"
    path = core / "batches" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def folder_names(sheets: list[Path]) -> list[str]:
    """The names that the engine gives."""
    return engine_module("batch_folder_names").folder_names(sheets)


class FakeBatch:
    """A batch.

    Args:
        arguments: of the command.
        send: writes an event.
    """

    def __init__(self, arguments: list[str], send: Send) -> None:
        split = arguments.index("--")
        self._options, named = arguments[:split], arguments[split + 1 :]
        self._output = Path(os.path.abspath(arguments[arguments.index("--output") + 1]))
        self._sheets = list(
            {os.path.abspath(p): p for n in named for p in _sheets(Path(n))}.values()
        )
        self._send = send
        self._manifest = self._output / "manifest.sqlite"
        self._child: subprocess.Popen[bytes] | None = None
        self._stopped = False

    def run(self, behaviour: str) -> int:
        """Reconstruct the sheets one after another."""
        signal.signal(signal.SIGTERM, lambda *_: self._stop())
        threading.Thread(target=self._watch_stdin, daemon=True).start()
        if not self._sheets:
            return self._refuse("no-sheets", "no drawing was found", 2)
        if behaviour == "running":
            return self._refuse("batch-running", f"another batch writes to {self._output}", 2)
        self._output.mkdir(parents=True, exist_ok=True)
        rows = []
        names = folder_names(self._sheets)
        done = json.loads(self._manifest.read_text()) if self._manifest.exists() else {}
        for number, (sheet, name) in enumerate(zip(self._sheets, names, strict=True), start=1):
            row = done.get(name) if "--resume" in self._options else None
            kept = row is not None and (self._output / name / "report.json").exists()
            if not kept:
                row = self._row(sheet, name)
            if not kept and row["exit_code"] != 130:
                done[name] = row
                self._manifest.write_text(json.dumps(done))
            rows.append(row)
            if row["exit_code"] != 130:
                self._send("sheet", **row, files=[], kept=kept, done=number, count=len(names))
            while behaviour == "batch-waits" and number == 2 and not self._stopped:
                time.sleep(0.02)
            if behaviour == "batch-dies":
                os.kill(os.getpid(), signal.SIGKILL)
        with open(self._output / "report.csv", "w", **_CSV) as file:
            writer = csv.DictWriter(file, _COLUMNS)
            writer.writeheader()
            writer.writerows(rows)
        if self._stopped:
            return self._refuse("cancelled", "stopped by cancel", 130)
        failed = sum(row["exit_code"] != 0 for row in rows)
        self._send("result", path=str(self._output / "report.csv"), sheets=len(rows), failed=failed)
        return int(failed > 0)

    def _row(self, sheet: Path, name: str) -> dict[str, Any]:
        folder = self._output / name
        code, said = self._reconstruct(sheet, folder)
        stated = _TOLD.search(said)
        report = _report(folder) if code == 0 else {}
        values = {
            "name": name,
            "sheet": os.path.abspath(sheet),
            "folder": str(folder),
            "status": report.get("status", "verified" if code == 0 else "failed"),
            "measures_mm": "",
            "exit_code": code if code >= 0 else 6,
            "code": stated[2] if stated else "",
            "message": stated[1] if stated else "",
            "seconds": 0.5,
        }
        if code < 0:
            values["message"] = f"its process was ended by {signal.Signals(-code).name}"
        return values

    def _reconstruct(self, sheet: Path, folder: Path) -> tuple[int, str]:
        if self._stopped:
            return 130, "gaussiancad: the batch was stopped [cancelled]"
        if folder.is_symlink():
            return 2, "gaussiancad: the sheet's folder is a link [output-is-link]"
        options = [word for word in self._options if word != "--resume"]
        options[options.index("--output") + 1] = str(folder)
        command = [sys.executable, sys.argv[0], "-m", "gaussiancad_core", "reconstruct"]
        self._child = subprocess.Popen(
            [*command, *options, "--", str(sheet)],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
        )
        if self._stopped:
            self._child.kill()
        said = self._child.stderr.read().decode("utf-8", "replace")
        code = self._child.wait()
        return self._reconstruct(sheet, folder) if self._stopped else (code, said)

    def _watch_stdin(self) -> None:
        for line in sys.stdin:
            if line.strip() == "cancel":
                break
        self._stop()

    def _stop(self) -> None:
        self._stopped = True
        if self._child is not None:
            self._child.kill()

    def _refuse(self, code: str, message: str, exit_code: int) -> int:
        self._send("error", code=code, message=message)
        sys.stderr.write(f"gaussiancad: {message} [{code}]\n")
        return exit_code


def settings_of(arguments: list[str]) -> Mapping[str, Any]:
    """The settings of a report, as far as the options tell them."""
    stated = dict(itertools.pairwise(arguments))
    names = ("projection", "preset", "result", "recipe", "colour")
    numbers = ("page", "seed", "scale-down")
    axis, _, length = stated.get("--length", "").partition("=")
    return {
        **{name: stated[f"--{name}"] for name in names if f"--{name}" in stated},
        **{n.replace("-", "_"): int(stated[f"--{n}"]) for n in numbers if f"--{n}" in stated},
        "lengths": {axis: float(length)} if length else {},
        "mm_per_pixel": float(stated["--mm-per-pixel"]) if "--mm-per-pixel" in stated else None,
    }


def _sheets(path: Path) -> list[Path]:
    if not path.is_dir():
        return [path]
    return sorted(this_path for this_path in path.rglob("*") if this_path.suffix in _SUFFIXES)


def _report(folder: Path) -> dict[str, Any]:
    path = folder / "report.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
