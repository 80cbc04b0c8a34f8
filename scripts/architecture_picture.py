"""The picture of the packages in docs/architecture.md, from the contract that lint-imports checks.

``python3 scripts/architecture_picture.py`` writes it anew; ``--check`` only tells whether it is up
to date.  A package is described by the first line of its docstring.
"""

import argparse
import ast
import configparser
import sys
from collections.abc import Iterator
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[1]
PAGE = CHECKOUT / "docs" / "architecture.md"
ENGINE = CHECKOUT / "core" / "gaussiancad_core"
BEGIN, END = "<!-- packages: made by scripts/architecture_picture.py -->", "<!-- /packages -->"


def layers() -> list[str]:
    """The engine's packages, those that import most first."""
    contract = configparser.ConfigParser()
    contract.read(CHECKOUT / ".importlinter", encoding="utf-8")
    return contract["importlinter:contract:order"]["layers"].split()


def first_line(path: Path) -> str:
    """The first sentence of a package's or module's docstring."""
    source = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    text = ast.get_docstring(ast.parse(source.read_text(encoding="utf-8"))) or ""
    return " ".join(text.partition("\n\n")[0].split())


def rows() -> Iterator[str]:
    """One line a package, those that need no other first; packages within packages under them."""
    for name in reversed(layers()):
        path = ENGINE / name
        yield f"| `{name}` | {first_line(path)} |"
        if path.is_dir():
            for inner in sorted(found.parent for found in path.glob("*/__init__.py")):
                yield f"| `{name}.{inner.name}` | {first_line(inner)} |"


def picture() -> str:
    """The table, with the marks around it."""
    head = "| package | what it answers |\n| --- | --- |"
    return "\n".join((BEGIN, head, *rows(), END))


def page() -> str:
    """The page with the table as it should be."""
    text = PAGE.read_text(encoding="utf-8")
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    return before + picture() + after


def main() -> int:
    """Write the page, or tell whether it is up to date."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 if old")
    options = parser.parse_args()
    wanted = page()
    if options.check:
        return int(wanted != PAGE.read_text(encoding="utf-8"))
    PAGE.write_text(wanted, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
