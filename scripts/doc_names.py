"""What the tree defines, by its syntax alone: modules, what is in them, where a name leads."""

import ast
import builtins
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache, cached_property
from importlib.util import find_spec
from pathlib import Path

from doc_texts import CHECKOUT, Module, listed

ROOTS = (CHECKOUT / "core", CHECKOUT / "scripts", CHECKOUT)
"""Folders from which modules are imported, the first that has one first."""

PACKAGES = (
    "gaussiancad",
    "gaussiancad_core",
    "gaussiancad_protocol",
    "freecad.gaussiancad",
    "benchmarks",
    "learning",
    "sample_parts",
)
"""Of the tree: a dotted name that begins with one of them leads somewhere in it."""

_MOST_STEPS = 20
"""Imports, one of the other, after which a name is given up."""

_ASSIGNING = ast.Assign | ast.AnnAssign | ast.AugAssign | ast.For | ast.With
_DEFINED = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef
_FILE = re.compile(r"[\w-]+(?:\.[\w-]+)*\.[a-z]\w*")
_WORD = re.compile(r"[A-Za-z_]\w*(?:-\w+)*")


def names_of(target: ast.AST) -> Iterator[str]:
    """What an assignment gives a name to."""
    for node in ast.walk(target):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id


class Scope:
    """What a module, or a class, defines.

    Attributes:
        nodes: of each name, what defines it.
        imported: of each name, the dotted name that it was imported as.
    """

    def __init__(self, body: list[ast.stmt], package: str) -> None:
        self.nodes: dict[str, ast.AST] = {}
        self.imported: dict[str, str] = {}
        self._gather(body, package)

    def _gather(self, body: list[ast.stmt], package: str) -> None:
        for node in body:
            if isinstance(node, _DEFINED):
                self.nodes[node.name] = node
            elif isinstance(node, ast.Import):
                for alias in node.names:
                    name = alias.asname or alias.name.partition(".")[0]
                    self.imported[name] = alias.name if alias.asname else name
            elif isinstance(node, ast.ImportFrom):
                parts = package.split(".")
                above = parts[: len(parts) - node.level + 1] if node.level else []
                source = ".".join([*above, *([node.module] if node.module else [])])
                for alias in node.names:
                    self.imported[alias.asname or alias.name] = f"{source}.{alias.name}"
            else:
                for inner in ("body", "orelse", "finalbody"):
                    self._gather(getattr(node, inner, []), package)
                for handler in getattr(node, "handlers", []):
                    self._gather(handler.body, package)
                if isinstance(node, _ASSIGNING):
                    self.nodes.update(dict.fromkeys(names_of(node), node))


class Tree:
    """All modules of the checkout.

    Attributes:
        modules: by their dotted names.
        paths: dotted name of each file's module.
    """

    def __init__(self) -> None:
        self.modules: dict[str, Module] = {}
        self.paths: dict[Path, str] = {}
        for path in listed("*.py"):
            self.add(_dotted(path), Module(path, path.read_text(encoding="utf-8")))
        self._scopes: dict[str, Scope] = {}

    def add(self, name: str, module: Module) -> None:
        """Take a module in, under a dotted name."""
        self.modules[name] = module
        self.paths[module.path] = name

    @cached_property
    def folders(self) -> frozenset[str]:
        """Dotted names of packages, those without a file of their own, too."""
        return frozenset(
            ".".join(parts[:count])
            for parts in (name.split(".") for name in self.modules)
            for count in range(1, len(parts) + 1)
        )

    @cached_property
    def classes(self) -> dict[str, list[tuple[str, ast.ClassDef]]]:
        """By name, the classes of that name with their modules."""
        found: defaultdict[str, list[tuple[str, ast.ClassDef]]] = defaultdict(list)
        for name, module in self.modules.items():
            for node in module.classes:
                found[node.name].append((name, node))
        return found

    @cached_property
    def last_names(self) -> frozenset[str]:
        """Last parts of all that is defined: modules, what is in them and in their classes."""
        found = {name.rpartition(".")[2] for name in self.folders}
        for name, module in self.modules.items():
            found |= set(self.scope(name).nodes)
            for node in module.classes:
                found |= members_of(node)
        return frozenset(found)

    def words(self, reader: Path) -> frozenset[str]:
        """Words of programs, also those with hyphens, docstrings and comments left out.

        Args:
            reader: file in which they are read: what tests alone call so is for tests alone.
        """
        return self._all_words if is_test(reader) else self._words

    @cached_property
    def _all_words(self) -> frozenset[str]:
        """Of all programs, tests, too."""
        tests = (module for path, module in self._by_path() if is_test(path))
        return self._words.union(*(_words(module.program()) for module in tests))

    def _by_path(self) -> Iterator[tuple[Path, Module]]:
        return ((module.path, module) for module in self.modules.values())

    @cached_property
    def _words(self) -> frozenset[str]:
        """Of all programs but tests, and of the names of all files."""
        found: set[str] = set()
        for path, module in self._by_path():
            if not is_test(path):
                found.update(_words(module.program()))
        for path in listed("*.json", "*.toml", "*.ini", "*.sh", "*.ui", "*.xml", "*.txt", "*.js"):
            found.update(_words(path.read_text(encoding="utf-8")))
        for path in listed():
            found.update(_words(path.relative_to(CHECKOUT).as_posix()))
        return frozenset(found)

    def scope(self, name: str) -> Scope:
        """What a module defines."""
        if name not in self._scopes:
            module = self.modules[name]
            inside = module.path.name == "__init__.py"
            self._scopes[name] = Scope(
                module.tree.body, name if inside else name.rpartition(".")[0]
            )
        return self._scopes[name]

    def leads_somewhere(self, dotted: str, steps: int = _MOST_STEPS) -> bool:
        """Whether a name from the tree's root, or of another library, is there."""
        parts = dotted.split(".")
        if dotted in self.folders or CHECKOUT.joinpath(*parts).is_dir():
            return True
        for count in range(len(parts) - 1, 0, -1):
            head = ".".join(parts[:count])
            if head in self.modules:
                return self._member(head, parts[count:], steps)
        return parts[0] not in self.folders and foreign(parts[0])

    def _member(self, module: str, rest: list[str], steps: int) -> bool:
        """Whether a module has a name, and that one the next."""
        scope = self.scope(module)
        first = rest[0]
        if first in scope.nodes:
            return len(rest) == 1 or self._within(module, scope.nodes[first], rest[1:])
        if first in scope.imported:
            tail = rest[1:]
            return steps > 0 and self.leads_somewhere(
                ".".join([scope.imported[first], *tail]), steps - 1
            )
        return first in ("__doc__", "__file__", "__name__") or "__getattr__" in scope.nodes

    def _within(self, module: str, node: ast.AST, rest: list[str]) -> bool:
        """Whether a class of a module has a name; of values it is not known."""
        if not isinstance(node, ast.ClassDef):
            return not isinstance(node, _DEFINED)
        return self.has_member(module, node, rest[0])

    def has_member(self, module: str, node: ast.ClassDef, name: str) -> bool:
        """Whether a class, or one that it is made from, has a name; of foreign ones it may."""
        if name in members_of(node):
            return True
        return any(self._inherited(module, base, name) for base in node.bases)

    def _inherited(self, module: str, base: ast.expr, name: str) -> bool:
        if isinstance(base, ast.Subscript):
            base = base.value
        dotted = ast.unparse(base)
        last = dotted.rpartition(".")[2]
        known = self.classes.get(last, [])
        if known:
            return any(self.has_member(inner, found, name) for inner, found in known)
        plain = getattr(builtins, dotted, None)
        if isinstance(plain, type):
            return hasattr(plain, name)
        return last not in ("Enum", "IntEnum", "StrEnum", "Protocol", "NamedTuple", "Generic")

    def knows(self, path: Path, name: str) -> bool:
        """Whether a class of the tree is what a file means by a name: a module has to have it."""
        if path not in self.paths:
            return name in self.classes
        scope = self.scope(self.paths[path])
        source = scope.imported.get(name, "").partition(".")[0]
        return name in self.classes and (name in scope.nodes or source in self.folders)

    def found_in(self, module: str, dotted: str, around: ast.ClassDef | None = None) -> bool:
        """Whether a name as a text in a module has it leads somewhere.

        Args:
            module: dotted name of the module of the text.
            dotted: the name; with a dot before it what is meant may be anywhere.
            around: the class in whose text it stands.
        """
        if dotted.startswith("."):
            return self._anywhere(dotted[1:])
        first, _, rest = dotted.partition(".")
        if around is not None and self.has_member(module, around, first):
            return True
        if self._member(module, dotted.split("."), _MOST_STEPS):
            return True
        if hasattr(builtins, first):
            return not rest or hasattr(getattr(builtins, first), rest.partition(".")[0])
        return "." in dotted and self.leads_somewhere(dotted)

    def _anywhere(self, dotted: str) -> bool:
        """Whether something of the tree ends with a name."""
        first, _, rest = dotted.partition(".")
        if not rest:
            return first in self.last_names
        return any(
            self.has_member(module, node, rest) for module, node in self.classes.get(first, [])
        ) or any(
            name.endswith(f".{first}") and self._member(name, rest.split("."), _MOST_STEPS)
            for name in self.modules
        )


@cache
def members_of(node: ast.ClassDef) -> frozenset[str]:
    """What a class defines: fields, methods, classes, and attributes that its methods set."""
    found = set(Scope(node.body, "").nodes)
    for inner in ast.walk(node):
        if (
            isinstance(inner, ast.Attribute)
            and isinstance(inner.ctx, ast.Store)
            and isinstance(inner.value, ast.Name)
            and inner.value.id in ("self", "cls")
        ):
            found.add(inner.attr)
    return frozenset(found)


def foreign(name: str) -> bool:
    """Whether a library of another has this name; it is not imported for the answer."""
    try:
        return find_spec(name) is not None
    except (ImportError, ValueError):
        return False


def is_test(path: Path) -> bool:
    """Whether a file is of the tests: what it says to a program is no word to a person."""
    return path.is_relative_to(CHECKOUT / "tests")


def _words(text: str) -> set[str]:
    """Words, and the parts of those with hyphens."""
    whole = set(_WORD.findall(text))
    whole |= set(_FILE.findall(text))
    return whole | {part for word in whole if "-" in word for part in word.split("-")}


def _dotted(path: Path) -> str:
    """The name as which a file is imported."""
    root = next(root for root in ROOTS if path.is_relative_to(root))
    parts = path.relative_to(root).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
