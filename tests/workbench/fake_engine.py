#!/usr/bin/env python3
"""Speaks the engine's protocol and writes its files, without computing anything.

It stands in for the engine's interpreter: its arguments are ``-I -u -m gaussiancad_core COMMAND``.
The environment variable GAUSSIANCAD_FAKE says how it behaves; see :data:`BEHAVIOURS`.
"""

import json
import os
import shutil
import signal
import sys
import threading
import time
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import fake_part
from fake_batch import FakeBatch, folder_names, settings_of

BEHAVIOURS = (
    "ok",  # verified solid, surface, Gaussians
    "contradicts",  # approximate, with a line missing on the sheet
    "sketched",  # a solid of slabs
    "surface",  # no exact solid
    "ambiguous",  # approximate, with another solid that fits
    "several",  # approximate, with two other solids that fit, one of them in first angle
    "noisy",  # ok, among noise: split characters, half JSON, binary
    "slow",  # runs until it is cancelled
    "long",  # tells its solid, then runs until it is cancelled
    "dies-late",  # tells its solid, then is killed
    "deaf",  # runs until it is killed
    "refuse",  # exit 4 with a report
    "plate",  # the same, and asks for the thickness, until it is told
    "dies",  # killed in the middle
    "broken",  # not installed
    "liar",  # exit 0 without a file
    "half",  # exit 0 with a damaged surface
    "differs",  # features that make another solid; a check that finds differences
    "cannot-tell",  # a check that can tell nothing
    "takes-long",  # a check that takes two seconds
    "no-features",  # no features are found
    "features-wait",  # they are looked for until it is stopped
    "no-views",  # a sheet is read, and has no views
    "running",  # a batch: another one runs in its folder
    "batch-waits",  # a batch: waits after its second sheet until it is stopped
    "batch-dies",  # a batch: killed after its first sheet
)


DATA = Path(__file__).parent / "data"


def send(event: str, **fields: object) -> None:
    """Write one event."""
    line = json.dumps({"event": event, **fields}, ensure_ascii=False) + "\n"
    sys.stdout.buffer.write(line.encode("utf-8", "backslashreplace"))
    sys.stdout.buffer.flush()


def watch_stdin(deaf: bool) -> None:
    """End the process with 130 when ``cancel`` comes, or stdin ends."""

    def watch() -> None:
        for line in sys.stdin:
            if line.strip() == "cancel" and not deaf:
                send("error", code="cancelled", message="stopped by cancel")
                os._exit(130)
        os._exit(130)

    threading.Thread(target=watch, daemon=True).start()


def data_of(name: str) -> dict[str, Any]:
    """A file of ``data``, that the engine might write."""
    return json.loads((DATA / name).read_text(encoding="utf-8"))


def report(sheet: str, status: str, reasons: list[dict[str, Any]]) -> dict[str, Any]:
    """A report as the contract has it."""
    values = data_of("report.json") | {"status": status, "reasons": reasons}
    values["engine"]["sheet"] = sheet
    if status == "failed":
        values |= dict.fromkeys(("solid", "surface", "gaussians"))
    return values


def write_models(output: Path, behaviour: str) -> None:
    """Write the models that the behaviour is about."""
    if behaviour == "surface":
        shutil.copy(fake_part.STEP_FILE, output / "surface.step")
    else:
        shutil.copy(fake_part.STEP_FILE, output / "solid.step")
    if behaviour == "ambiguous":
        (output / "alternatives").mkdir(exist_ok=True)
        shutil.copy(fake_part.STEP_FILE, output / "alternatives" / "1.step")
    if behaviour == "several":
        (output / "alternatives").mkdir(exist_ok=True)
        for number, path in enumerate(fake_part.ALTERNATIVES, start=1):
            shutil.copy(path, output / "alternatives" / f"{number}.step")
    stl = fake_part.stl_text()
    (output / "surface.stl").write_text("not a mesh" if behaviour == "half" else stl)
    (output / "gaussians.ply").write_bytes(fake_part.gaussians_bytes())


TELL_SOLID = ("ok", "contradicts", "sketched", "ambiguous", "several", "noisy", "long", "dies-late")
"""Behaviours that write the solid before anything else."""


def tell_solid(output: Path, behaviour: str) -> None:
    """Write the solid, and say so."""
    output.mkdir(parents=True, exist_ok=True)
    path = output / "solid.step"
    shutil.copy(fake_part.STEP_FILE, path)
    verified = behaviour not in ("contradicts", "sketched", "ambiguous", "several")
    send("solid", path=str(path), status="verified" if verified else "approximate")


def run_stages(behaviour: str, sheet: str, output: Path) -> None:
    """Tell of three stages, and misbehave in the second or third one."""
    for index, name in enumerate(("read", "solid", "gaussians"), start=1):
        if index == 3 and behaviour in TELL_SOLID:
            tell_solid(output, behaviour)
        send("stage", name=name, index=index, of=3)
        if behaviour == "noisy":
            sys.stdout.buffer.write('{"event": "progress"\n文件 caf'.encode())
            sys.stdout.buffer.flush()
            time.sleep(0.02)
            sys.stdout.buffer.write("é ok\n".encode()[:1] + b"\xa9\n\xff\xfe\x00\n[1]\n{}\n\n")
            sys.stdout.buffer.flush()
        for step in range(1, 5):
            send("progress", stage=name, fraction=step / 4, eta_s=1.0, loss=0.5 / step)
        if index == 2:
            sys.stderr.write("solving cells\n")
            sys.stderr.flush()
            if behaviour == "dies":
                os.kill(os.getpid(), signal.SIGKILL)
            while behaviour in ("slow", "deaf"):
                time.sleep(0.05)
            send("preview", path=sheet)
        if index == 3:
            if behaviour == "dies-late":
                os.kill(os.getpid(), signal.SIGKILL)
            while behaviour == "long":
                time.sleep(0.05)


def reconstruct(arguments: list[str]) -> int:
    """What ``gaussiancad reconstruct`` does."""
    behaviour = os.environ.get("GAUSSIANCAD_FAKE", "ok")
    sheet = Path(arguments[-1])
    output = Path(arguments[arguments.index("--output") + 1])
    if behaviour == "broken":
        sys.stderr.write(f"{sys.argv[0]}: No module named gaussiancad_core\n")
        return 1
    if behaviour == "deaf":
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
    watch_stdin(behaviour == "deaf")
    (name,) = folder_names([sheet])
    send("hello", protocol=1, versions={"gaussiancad": "0.0"}, name=name)
    if not sheet.is_file():
        return refuse("sheet-missing", f"there is no file {sheet}: check its name", 3)
    if sheet.read_bytes()[:4] not in (b"\x89PNG", b"\xff\xd8\xff\xe0"):
        return refuse("not-an-image", f"{sheet.name} is no image: choose a drawing", 3)
    run_stages(behaviour, str(sheet), output)
    output.mkdir(parents=True, exist_ok=True)
    if behaviour == "refuse":
        reason = {"code": "one-view", "message": "only one view was found: draw at least two"}
        (output / "report.json").write_text(json.dumps(report(str(sheet), "failed", [reason])))
        return refuse(reason["code"], reason["message"], 4)
    if behaviour == "plate" and not any(argument.startswith("y=") for argument in arguments):
        return refuse("one-view", "one view, and no thickness", 4, {"axis": "y"})
    if behaviour != "liar":
        write_models(output, behaviour)
        reasons = data_of("reasons.json").get(behaviour, [])
        status = "approximate" if reasons else "verified"
        values = report(str(sheet), status, reasons)
        values["settings"] = settings_of(arguments)
        if behaviour == "sketched":
            values["solid"]["source"] = "sketch"
        if behaviour == "several":
            values["solid"] |= {"agreement": 0.9984, "alternatives": 2}
            values["alternatives"] = [
                {"file": "alternatives/1.step", "agreement": 0.9971, "projection": "third"},
                {"file": "alternatives/2.step", "agreement": 0.9902, "projection": "first"},
            ]
        (output / "report.json").write_text(json.dumps(values), encoding="utf-8")
    send("warning", code="scale-assumed", message="the longest edge was made 100 mm")
    send("result", path=str(output / "report.json"))
    return 0


def read(arguments: list[str]) -> int:
    """What ``gaussiancad read`` does."""
    behaviour = os.environ.get("GAUSSIANCAD_FAKE", "ok")
    output = Path(arguments[arguments.index("--output") + 1])
    watch_stdin(deaf=False)
    send("hello", protocol=1, versions={"gaussiancad": "0.0"})
    for index, name in enumerate(("read", "views", "lines", "masks"), start=1):
        send("stage", name=name, index=index, of=4)
        while behaviour == "slow" and index == 2:
            time.sleep(0.05)
    output.mkdir(parents=True, exist_ok=True)
    values = data_of("reading.json")
    if behaviour == "no-views":
        values["views"] = []
    path = output / "reading.json"
    path.write_text(json.dumps(values), encoding="utf-8")
    send("reading", path=str(path))
    send("result", path=str(path), refused=0)
    return 0


def batch(arguments: list[str]) -> int:
    """What ``gaussiancad batch`` does."""
    behaviour = os.environ.get("GAUSSIANCAD_FAKE", "ok")
    if behaviour == "broken":
        sys.stderr.write(f"{sys.argv[0]}: No module named gaussiancad_core\n")
        return 1
    send("hello", protocol=1, versions={"gaussiancad": "0.0"})
    return FakeBatch(arguments, send).run(behaviour)


def refuse(code: str, message: str, exit_code: int, args: dict[str, object] | None = None) -> int:
    """Tell of an error."""
    send("error", code=code, message=message, **({"args": args} if args else {}))
    sys.stderr.write(f"gaussiancad: {message} [{code}]\n")
    return exit_code


def compare(arguments: list[str]) -> int:
    """What ``gaussiancad compare`` does."""
    for path in arguments[:2]:
        if not Path(path).is_file():
            sys.stderr.write(f"gaussiancad: there is no file {path} [model-missing]\n")
            return 3
    while os.environ.get("GAUSSIANCAD_FAKE") == "slow":
        time.sleep(0.05)
    output = Path(arguments[arguments.index("--output") + 1])
    output.mkdir(parents=True, exist_ok=True)
    (output / "comparison.html").write_text("<!doctype html><h1>fake</h1>")
    (output / "deviation.ply").write_bytes(fake_part.deviation_bytes())
    (output / "deviation.png").write_bytes(fake_part.picture_bytes())
    shutil.copy(DATA / "comparison.json", output)
    sys.stdout.write("chamfer 0.0312\n")
    return 0


def features(arguments: list[str]) -> int:
    """What ``gaussiancad features`` does."""
    behaviour = os.environ.get("GAUSSIANCAD_FAKE", "ok")
    if not Path(arguments[0]).is_file():
        return refuse("model-missing", f"there is no file {arguments[0]}", 3)
    if behaviour == "no-features":
        return refuse("model-unreadable", "the model has no solid", 3)
    while behaviour in ("slow", "features-wait"):
        time.sleep(0.05)
    output = Path(arguments[arguments.index("--output") + 1])
    output.mkdir(parents=True, exist_ok=True)
    values = data_of("features/bracket.json")
    if behaviour == "differs":
        values["solids"][0]["features"][0]["length"] = -39.0
    (output / "features.json").write_text(json.dumps(values), encoding="utf-8")
    return 0


def check(arguments: list[str]) -> int:
    """What ``gaussiancad check`` does."""
    behaviour = os.environ.get("GAUSSIANCAD_FAKE", "ok")
    sheet, model = (Path(path) for path in arguments[-2:])
    output = Path(arguments[arguments.index("--output") + 1])
    watch_stdin(deaf=False)
    send("hello", protocol=1, versions={"gaussiancad": "0.0"})
    if not model.is_file():
        return refuse("model-missing", f"there is no file {model}", 3)
    for index, name in enumerate(("read", "views", "lines", "masks", "judge", "write"), start=1):
        send("stage", name=name, index=index, of=6)
        while behaviour == "slow" and name == "judge":
            time.sleep(0.05)
    if behaviour == "takes-long":
        time.sleep(2.0)
    if behaviour == "refuse":
        return refuse("empty-drawing", f"{sheet.name} has no lines", 4)
    values = data_of("check.json")
    if behaviour != "differs":
        values |= {"reasons": [], "differences": [], "tally": [], "edits": [], "verdict": "agrees"}
    if behaviour == "cannot-tell":
        reason = {"code": "extents-differ", "message": "the extents fit the views in no position"}
        values |= {"verdict": behaviour, "reasons": [reason], "pose": None}
    output.mkdir(parents=True, exist_ok=True)
    (output / "check.json").write_text(json.dumps(values), encoding="utf-8")
    (output / "check.png").write_bytes(fake_part.picture_bytes())
    send("result", path=str(output / "check.json"), verdict=values["verdict"])
    return {"agrees": 0, "differs": 4, "cannot-tell": 5}[values["verdict"]]


def main() -> int:
    """Run the command that follows the interpreter's own arguments."""
    command, *arguments = sys.argv[sys.argv.index("gaussiancad_core") + 1 :]
    if command == "doctor":
        sys.stdout.write("gaussiancad 0.0 (fake)\ntorch: missing: pip install torch\n")
        return 0
    commands = {
        "reconstruct": reconstruct,
        "compare": compare,
        "batch": batch,
        "read": read,
        "features": features,
        "check": check,
    }
    return commands[command](arguments)


if __name__ == "__main__":
    sys.exit(main())
