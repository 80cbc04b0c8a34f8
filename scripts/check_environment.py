"""Whether each package of this environment finds what it requires, as ``pip check`` does.

But for what ``exclude-dependencies`` in ``core/pyproject.toml`` leaves out on purpose, which
``pip check`` would call missing.  Prints one line for each requirement that is not met; exit
status 1 if there is one.
"""

import sys
import tomllib
from importlib import metadata
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

PROJECT = Path(__file__).resolve().parents[1] / "core" / "pyproject.toml"


def excluded() -> frozenset[str]:
    """The canonical names of the packages that the locks leave out."""
    project = tomllib.loads(PROJECT.read_text(encoding="utf-8"))
    return frozenset(canonicalize_name(n) for n in project["tool"]["uv"]["exclude-dependencies"])


def problems(
    installed: dict[str, str], required: dict[str, list[str]], left_out: frozenset[str]
) -> list[str]:
    """What is missing or of another version.

    Args:
        installed: canonical name to version.
        required: canonical name to its requirements (PEP 508).
        left_out: canonical names that may be missing.
    """
    found = []
    for name, lines in required.items():
        for requirement in map(Requirement, lines):
            other = canonicalize_name(requirement.name)
            if requirement.marker and not requirement.marker.evaluate({"extra": ""}):
                continue
            version = installed.get(other)
            if version is None and other not in left_out:
                found.append(f"{name} requires {requirement}, which is not installed")
            elif version is not None and not requirement.specifier.contains(version, True):
                found.append(f"{name} requires {requirement}, but {version} is installed")
    return sorted(found)


def main() -> int:
    """Check the environment that this interpreter belongs to; returns the exit status."""
    packages = {canonicalize_name(p.metadata["Name"]): p for p in metadata.distributions()}
    installed = {name: package.version for name, package in packages.items()}
    required = {name: package.requires or [] for name, package in packages.items()}
    lines = problems(installed, required, excluded())
    print("\n".join(lines) or "every requirement is met")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
