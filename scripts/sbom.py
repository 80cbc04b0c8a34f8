"""Writes what the locks pin as bills of materials, CycloneDX 1.6 in JSON: one for each lock.

    python scripts/sbom.py FOLDER

The same locks give the same bytes: the serial number is made of the lock, and there is no time in
it.  Each wheel's SHA-256 stands under the package's reference of the type ``distribution``, whose
address is the package's own URL (purl), for where wheels come from is up to whoever installs.
Libraries that a wheel carries inside are not in a lock, and so not in its bill.
"""

import json
import re
import sys
import tomllib
import uuid
from collections.abc import Mapping, Sequence
from pathlib import Path

from licence_policy import UNKNOWN
from licences import RECORD, Record, read_record
from locked import ROOT, Lock, Package, canonical, parse_lock

PROJECT = ROOT / "core" / "pyproject.toml"

_NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, "https://example.org/gaussiancad")

_SPDX_ID = re.compile(r"(?!LicenseRef-)[\w.+-]+-[\w.+-]+|MIT|ISC|Zlib|0BSD")


def purl(package: Package) -> str:
    """The package's URL (purl-spec, type pypi); one entry of a lock has one."""
    return f"pkg:pypi/{package.name}@{package.version.replace('+', '%2B')}"


def bill(lock: Lock, text: str, project: Mapping[str, object], record: Record) -> dict[str, object]:
    """A bill of materials.

    Args:
        lock: which lock; what is in that of the tests does not ship, its scope is ``excluded``.
        text: of the lock.
        project: the table ``project`` of ``pyproject.toml``.
        record: licences by name and version.

    Raises:
        ValueError: the lock is damaged.
    """
    packages = parse_lock(text)
    item = f"pkg:pypi/{project['name']}@{project['version']}"
    seed = f"{lock.value}\n{project['version']}\n{text}"
    return {
        "$schema": "http://cyclonedx.org/schema/bom-1.6.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "serialNumber": f"urn:uuid:{uuid.uuid5(_NAMESPACE, seed)}",
        "version": 1,
        "metadata": {
            "component": {
                "type": "application",
                "bom-ref": item,
                "name": project["name"],
                "version": project["version"],
                "licenses": [{"license": {"id": project["license"]}}],
                "purl": item,
            },
            "properties": [{"name": "gaussiancad:lock", "value": lock.value}],
        },
        "components": [_component(package, lock, record) for package in packages],
        "dependencies": _dependencies(item, lock, packages, project),
        "compositions": [{"aggregate": "incomplete_third_party_only", "assemblies": [item]}],
    }


def _component(package: Package, lock: Lock, record: Record) -> dict[str, object]:
    licence = record.get((package.name, package.release))
    found: dict[str, object] = {
        "type": "library",
        "bom-ref": purl(package),
        "name": package.name,
        "version": package.version,
        "scope": "excluded" if lock is Lock.TESTS else "required",
    }
    if licence is not None and licence.text != UNKNOWN:
        found["licenses"] = [_licence(licence.text)]
    found["purl"] = purl(package)
    hashes = [{"alg": "SHA-256", "content": content} for content in package.hashes]
    reference = {"type": "distribution", "url": purl(package), "hashes": hashes}
    found["externalReferences"] = [reference]
    if package.marker:
        found["properties"] = [{"name": "gaussiancad:marker", "value": package.marker}]
    return found


def _licence(text: str) -> dict[str, object]:
    if re.search(r" (?:AND|OR|WITH) ", text) or text.startswith("LicenseRef-"):
        return {"expression": text}
    if _SPDX_ID.fullmatch(text):
        return {"license": {"id": text}}
    return {"license": {"name": text}}


def _dependencies(
    text: str, lock: Lock, packages: Sequence[Package], project: Mapping[str, object]
) -> list[dict[str, object]]:
    """What the engine itself asks for; what its packages ask for is not in a lock."""
    extras = project["optional-dependencies"]
    lines = [] if lock is Lock.TESTS else list(project["dependencies"])
    for name in lock.extras:
        lines += extras[name]
    asked = {canonical(re.match(r"[\w.-]+", line)[0]) for line in lines}
    direct = [purl(package) for package in packages if package.name in asked]
    return [{"ref": text, "dependsOn": direct}]


def main(arguments: list[str]) -> int:
    """The command; returns the exit status."""
    if len(arguments) != 1:
        print("usage: sbom.py FOLDER", file=sys.stderr)
        return 2
    folder = Path(arguments[0])
    folder.mkdir(parents=True, exist_ok=True)
    project = tomllib.loads(PROJECT.read_text(encoding="utf-8"))["project"]
    record = read_record(RECORD.read_text(encoding="utf-8"))
    for lock in Lock:
        made = bill(lock, lock.path.read_text(encoding="utf-8"), project, record)
        path = folder / f"{lock.path.stem}.cdx.json"
        path.write_text(json.dumps(made, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
        print(f"{path}: {len(made['components'])} packages")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
