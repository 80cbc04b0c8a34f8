"""Bills of materials: what CycloneDX 1.6 demands, and all that the locks say."""

import json
import re
import subprocess
import sys
import tomllib
import uuid
from pathlib import Path
from typing import Any

import pytest
import sbom
from licence_policy import ALLOWED, NVIDIA, Licence
from licences import RECORD, read_record
from locked import ROOT, Lock, read_lock
from packaging.licenses import canonicalize_license_expression

PROJECT = tomllib.loads((ROOT / "core" / "pyproject.toml").read_text(encoding="utf-8"))["project"]

SECTIONS = {
    *("$schema", "bomFormat", "specVersion", "serialNumber", "version", "metadata"),
    *("components", "dependencies", "compositions"),
}


@pytest.fixture(scope="module", params=Lock)
def lock(request: pytest.FixtureRequest) -> Lock:
    return request.param


@pytest.fixture(scope="module")
def made(lock: Lock) -> dict[str, Any]:
    record = read_record(RECORD.read_text(encoding="utf-8"))
    return sbom.bill(lock, lock.path.read_text(encoding="utf-8"), PROJECT, record)


def test_it_says_what_it_is(made: dict[str, Any]) -> None:
    assert set(made) == SECTIONS
    assert (made["bomFormat"], made["specVersion"], made["version"]) == ("CycloneDX", "1.6", 1)
    assert made["serialNumber"] == uuid.UUID(made["serialNumber"][9:]).urn
    component = made["metadata"]["component"]
    assert (component["type"], component["name"]) == ("application", "gaussiancad-core")
    assert component["version"] == PROJECT["version"]


def test_every_package_is_there_with_every_hash(lock: Lock, made: dict[str, Any]) -> None:
    packages = read_lock(lock)
    assert [(c["name"], c["version"]) for c in made["components"]] == [
        (package.name, package.version) for package in packages
    ]
    for package, component in zip(packages, made["components"], strict=True):
        (reference,) = component["externalReferences"]
        assert reference["type"] == "distribution" and reference["url"] == component["purl"]
        assert {item["alg"] for item in reference["hashes"]} == {"SHA-256"}
        assert tuple(item["content"] for item in reference["hashes"]) == package.hashes
        mapping = {entry["name"]: entry["value"] for entry in component.get("properties", ())}
        assert mapping.get("gaussiancad:marker", "") == package.marker


def test_components_have_what_the_format_demands(lock: Lock, made: dict[str, Any]) -> None:
    references = [component["bom-ref"] for component in made["components"]]
    references.append(made["metadata"]["component"]["bom-ref"])
    assert len(set(references)) == len(references)
    scope = "excluded" if lock is Lock.TESTS else "required"
    for component in made["components"]:
        assert component["type"] == "library" and component["scope"] == scope
        assert re.fullmatch(r"pkg:pypi/[a-z0-9-]+@[\w.!-]+(%2B[\w.]+)?", component["purl"])
        (licence,) = component["licenses"]
        if "expression" in licence:
            assert canonicalize_license_expression(licence["expression"]) == licence["expression"]
        elif "id" in licence["license"]:
            assert licence["license"]["id"] in ALLOWED
            assert " " not in licence["license"]["id"]
        else:
            assert licence["license"] == {"name": "BSD License"}


def test_what_depends_on_what_names_components_only(lock: Lock, made: dict[str, Any]) -> None:
    references = {component["bom-ref"] for component in made["components"]}
    (item,) = made["dependencies"]
    assert item["ref"] == made["metadata"]["component"]["bom-ref"]
    assert set(item["dependsOn"]) <= references
    names = {re.split(r"[/@]", reference)[1] for reference in item["dependsOn"]}
    engine = {"numpy", "rapidocr"}
    expected = {Lock.TESTS: {"pytest", "pycolmap", "mcp"}, Lock.SOLID: engine}
    assert expected.get(lock, engine | {"torch", "open3d-cpu"}) <= names
    assert ("torch" in names) is (lock in (Lock.CPU, Lock.CUDA))


def test_the_same_lock_gives_the_same_bill_and_another_one_another(
    lock: Lock, made: dict[str, Any]
) -> None:
    text = lock.path.read_text(encoding="utf-8")
    record = read_record(RECORD.read_text(encoding="utf-8"))
    assert sbom.bill(lock, text, PROJECT, record) == made
    other = text.replace("--hash=sha256:0", "--hash=sha256:1", 1)
    changed = sbom.bill(lock, other, PROJECT, record)
    assert changed["serialNumber"] != made["serialNumber"]


def test_licences_stand_where_the_format_has_them() -> None:
    text = f"a==1 \\\n    --hash=sha256:{'a' * 64}\n"
    for said, expected in (
        ("MIT", [{"license": {"id": "MIT"}}]),
        ("BSD-3-Clause", [{"license": {"id": "BSD-3-Clause"}}]),
        ("MIT OR Zlib", [{"expression": "MIT OR Zlib"}]),
        (NVIDIA, [{"expression": NVIDIA}]),
        ("BSD License", [{"license": {"name": "BSD License"}}]),
        ("unknown", None),
    ):
        record = {("a", "1"): Licence(said, "metadata")}
        (component,) = sbom.bill(Lock.CPU, text, PROJECT, record)["components"]
        assert component.get("licenses") == expected


def test_the_command_writes_one_for_each_lock(tmp_path: Path) -> None:
    script = [sys.executable, str(ROOT / "scripts" / "sbom.py")]
    done = subprocess.run([*script, str(tmp_path / "new" / "folder")], check=False)
    assert done.returncode == 0
    for lock in Lock:
        content = (tmp_path / "new" / "folder" / f"{lock.path.stem}.cdx.json").read_text("utf-8")
        assert len(json.loads(content)["components"]) == len(read_lock(lock))
    assert subprocess.run(script, check=False, capture_output=True).returncode == 2
