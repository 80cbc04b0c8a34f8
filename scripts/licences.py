"""Lists the licences of all packages that the locks pin, and whether each is allowed.

    python scripts/licences.py             # the list; exit status 1 if a package is not allowed
    python scripts/licences.py --record    # asks the package index first; ``make lock`` does this

What the metadata of each locked version says is kept in ``core/locks/licences.json``, for all
platforms, so that the list needs no network and no installation.  ``--record`` asks pip for the
metadata of the packages that have no entry yet, and writes ``docs/licences.md``.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

from licence_policy import UNKNOWN, Licence, is_allowed, stated_licence
from locked import LOCKS, ROOT, Lock, Package, canonical, read_lock

RECORD = LOCKS / "licences.json"
PAGE = ROOT / "docs" / "licences.md"

Key = tuple[str, str]
"""Name and version, without what tells builds apart."""

Record = Mapping[Key, Licence]

HEADING = """# Licences of the packages

Written by `make lock`; `make licences` prints the list. What `make install` and *Install Engine…*
put into the engine's environment is `engine-cpu.txt` of `core/locks`, with PyTorch for CUDA
`engine-cuda.txt`, or without PyTorch `engine-solid.txt`; `make install` adds `tests.txt`.
GaussianCAD's own licence is LGPL-2.1-or-later. One file that lies in it is not its own: the network
that reads texts, under Apache-2.0
([its card](../core/gaussiancad_core/writing/text_network/README.md)).

A licence is what the package's metadata say, in SPDX's words where they can be translated; `read`
are those that a person found in the package, since the metadata do not tell. Which are allowed, and
why, is in `scripts/licence_policy.py`; NVIDIA's are allowed in `engine-cuda.txt` alone.

Metadata speak of the package. Libraries that a wheel carries inside have licences of their own,
which are not in the list. Some are under a copyleft, as far as the file names in the wheels for
Linux show: Open CASCADE (LGPL-2.1 with an exception), FreeImage (GPL or its own, to choose) and
LibRaw (LGPL-2.1 or CDDL-1.0, to choose) in cadquery-ocp-novtk, FFmpeg (LGPL-2.1) in
opencv-python-headless, GEOS (LGPL-2.1) in shapely, GCC's runtime (GPL-3.0 with an exception for
all that uses it) in several. They are shared libraries, files of their own that one can replace.

Not in the list, for no lock has them: gsplat, the extra `cuda`, which its user installs; FreeCAD
and the other packages of `scripts/system-packages.txt`, which Debian installs, with their texts in
`/usr/share/doc/NAME/copyright`.
"""


@dataclass(frozen=True)
class Row:
    """A package in the list.

    Attributes:
        name, version: as locked.
        licence: what is recorded, or ``unknown``.
        locks: those that have it.
        allowed: whether each of them may.
    """

    name: str
    version: str
    licence: Licence
    locks: tuple[Lock, ...]
    allowed: bool


def read_record(text: str) -> dict[Key, Licence]:
    """The licences by name and version, of the text of ``licences.json``."""
    return {
        (name, version): Licence(**licence)
        for name, versions in json.loads(text).items()
        for version, licence in versions.items()
    }


def record_text(record: Record) -> str:
    """The text of ``licences.json``; names and versions in order."""
    nested: dict[str, dict[str, dict[str, str]]] = {}
    for (name, version), licence in sorted(record.items()):
        nested.setdefault(name, {})[version] = asdict(licence)
    return json.dumps(nested, indent=1, ensure_ascii=False) + "\n"


def rows(locks: Mapping[Lock, Iterable[Package]], record: Record) -> tuple[Row, ...]:
    """The list, by name and version; a package without an entry is ``unknown`` and not allowed."""
    holders: dict[Key, list[Lock]] = {}
    for lock, packages in locks.items():
        for package in packages:
            holders.setdefault((package.name, package.release), []).append(lock)
    found = []
    for key, item in sorted(holders.items()):
        licence = record.get(key, Licence(UNKNOWN, "metadata"))
        allowed = all(is_allowed(licence.text, lock) for lock in item)
        found.append(Row(*key, licence, tuple(item), allowed))
    return tuple(found)


def page(listed: Iterable[Row]) -> str:
    """The text of ``docs/licences.md``."""
    lines = ["| package | version | licence | from | in | allowed |"]
    lines.append("| --- | --- | --- | --- | --- | --- |")
    for row in listed:
        where = ", ".join(lock.value.removesuffix(".txt") for lock in row.locks)
        verdict = "yes" if row.allowed else "NO"
        cells = (row.name, row.version, row.licence.text, row.licence.source, where, verdict)
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join([HEADING, *lines, ""])


def table(listed: Iterable[Row]) -> str:
    """The list for a terminal, of one row at least."""
    cells = [
        (
            "allowed" if row.allowed else "NOT ALLOWED",
            row.name,
            row.version,
            row.licence.text + (" (read)" if row.licence.source == "read" else ""),
            " ".join(lock.value.removesuffix(".txt") for lock in row.locks),
        )
        for row in listed
    ]
    widths = [max(len(line[column]) for line in cells) for column in range(4)]
    return "\n".join(
        "  ".join([*(c.ljust(w) for c, w in zip(line, widths, strict=False)), line[4]])
        for line in cells
    )


def asked(packages: Iterable[Package]) -> dict[Key, Licence]:
    """What the package index says of packages, through pip; nothing is installed.

    Raises:
        subprocess.CalledProcessError: pip finds one of them not, or gets no answer.
    """
    places: dict[tuple[str, ...], set[str]] = {}
    for package in packages:
        python = "3.12" if "python_full_version >= '3.12'" in package.marker else "3.11"
        # What only Windows has, pip finds only where it is told of Windows.
        windows = ("--platform", "win_amd64") if "== 'win32'" in package.marker else ()
        place = ("--python-version", python, *windows)
        places.setdefault(place, set()).add(f"{package.name}=={package.release}")
    found = {}
    for place, wanted in places.items():
        with tempfile.TemporaryDirectory() as folder:
            report, names = Path(folder, "report.json"), Path(folder, "names.txt")
            names.write_text("\n".join(sorted(wanted)), encoding="utf-8")
            command = [sys.executable, "-m", "pip", "install", "--dry-run", "--ignore-installed"]
            command += ["--no-deps", "--only-binary", ":all:", *place]
            command += ["--quiet", "--target", folder, "--report", str(report)]
            subprocess.run([*command, "--requirement", str(names)], check=True)
            for item in json.loads(report.read_text(encoding="utf-8"))["install"]:
                entry = item["metadata"]
                name = canonical(entry["name"])
                fields = entry.get("license_expression"), entry.get("license")
                version = entry["version"].partition("+")[0]
                licence = stated_licence(name, *fields, entry.get("classifier", ()))
                found[name, version] = licence
    return found


def main(arguments: list[str]) -> int:
    """The command; returns the exit status."""
    parser = argparse.ArgumentParser(description="licences of the locked packages")
    parser.add_argument("--record", action="store_true", help="ask the package index first")
    record_first = parser.parse_args(arguments).record
    locks = {lock: read_lock(lock) for lock in Lock}
    record = read_record(RECORD.read_text(encoding="utf-8")) if RECORD.exists() else {}
    if record_first:
        packages = [package for lock in locks.values() for package in lock]
        keys = {(package.name, package.release) for package in packages}
        new = [p for p in packages if (p.name, p.release) not in record]
        record = {key: item for key, item in {**record, **asked(new)}.items() if key in keys}
        RECORD.write_text(record_text(record), encoding="utf-8")
    listed = rows(locks, record)
    if record_first:
        PAGE.write_text(page(listed), encoding="utf-8")
    refused = [row for row in listed if not row.allowed]
    if shown := refused if record_first else listed:
        print(table(shown))
    print(f"{len(listed)} packages, {len(refused)} of a licence that is not allowed")
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
