"""Names that say nothing: no variable, parameter, attribute or function is called so.

``python3 scripts/lint_names.py`` prints each place and exits with 1 if there is one.  A variable is
named by what it holds (``stroke``, ``view``, ``dimension``, ``neighbour``), not by its part in the
sentence.
"""

import ast
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[1]

SAY_NOTHING = {"own", "told", "beside"}


def named(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Line and name of whatever a module gives a name to."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.lineno, node.id
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node.lineno, node.attr
        elif isinstance(node, ast.arg):
            yield node.lineno, node.arg
        elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            yield node.lineno, node.name
        elif isinstance(node, ast.alias) and node.asname:
            yield node.lineno, node.asname


def found(path: Path) -> list[str]:
    """A line for each bad name in a file."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    where = path.relative_to(CHECKOUT)
    return [
        f"{where}:{line}: '{name}' says nothing: name what it holds"
        for line, name in named(tree)
        if name in SAY_NOTHING
    ]


def main() -> int:
    """Print what is found in all files that git knows."""
    listed = subprocess.run(
        ["git", "ls-files", "*.py"], cwd=CHECKOUT, check=True, capture_output=True, text=True
    ).stdout.split()
    lines = [line for name in listed for line in found(CHECKOUT / name)]
    print("\n".join(lines) if lines else "all names say something")
    return int(bool(lines))


if __name__ == "__main__":
    sys.exit(main())
