"""Whether the sections of docstrings are true: arguments, attributes, and the errors raised."""

import ast
import builtins
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from inspect import cleandoc

from doc_names import Tree, foreign

ARGS, ATTRIBUTES, RAISES = "Args", "Attributes", "Raises"

_HEAD = re.compile(r"^([A-Z][a-z]+):$")
_ENTRY = re.compile(r"^    (\*{0,2}[\w.]+(?:, \*{0,2}[\w.]+)*)(?: \([^)]*\))?:(?: |$)")
_CODE = re.compile(r"``([a-z]+(?:-[a-z]+)*)``")

_CODES = re.compile(r" (?:``[a-z-]+``(?:, | or |, or )?)*")
"""What an error is told by, before it is said when."""

_MAKERS = ("__init__", "__new__", "__call__")

_Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class Entry:
    """An entry of a section.

    Attributes:
        section: its heading.
        line: of the docstring, from 0.
        names: that it is about; none where it names nothing.
        text: all that it says.
    """

    section: str
    line: int
    names: tuple[str, ...]
    text: str


def entries(docstring: str) -> Iterator[Entry]:
    """The entries of the sections that are looked at."""
    section, block, begun = "", list[str](), 0
    for number, line in enumerate([*cleandoc(docstring).split("\n"), ""]):
        fresh = bool(re.match(r"^    \S", line))
        if block and (fresh or not line.startswith("    ")):
            yield _entry(section, begun, block)
            block = []
        if head := _HEAD.match(line):
            section = head[1]
        elif line and not line.startswith(" "):
            section = ""
        elif section in (ARGS, ATTRIBUTES, RAISES) and line.strip():
            begun = begun if block else number
            block.append(line)


def _entry(section: str, begun: int, block: list[str]) -> Entry:
    match = _ENTRY.match(block[0])
    names = tuple(name.lstrip("*") for name in match[1].split(", ")) if match else ()
    return Entry(section, begun, names, " ".join(line.strip() for line in block))


class Sections:
    """Looks at the docstrings of a tree."""

    def __init__(self, tree: Tree) -> None:
        self._tree = tree

    @cached_property
    def _codes(self) -> frozenset[str]:
        """What programs tell errors by."""
        codes = self._tree.modules["gaussiancad_protocol.codes"].tree
        return frozenset(
            node.value
            for node in ast.walk(codes)
            if isinstance(node, ast.Constant) and isinstance(node.value, str)
        )

    def wrong(self, name: str) -> Iterator[tuple[int, str, str]]:
        """Line, section and what is wrong with it, for each wrong entry of a module."""
        module = self._tree.modules[name]
        for node, docstring in module.documented:
            for entry in entries(docstring.text):
                line = docstring.line + entry.line
                if not entry.names:
                    yield line, entry.section, f"names nothing: {entry.text[:60]}"
                for named in entry.names:
                    if not self._is_there(name, node, entry.section, named):
                        yield line, entry.section, f"`{named}` is not there"
                if entry.section == RAISES:
                    stated = _CODES.match(entry.text.partition(":")[2])
                    codes = set(_CODE.findall(stated[0] if stated else ""))
                    for code in sorted(codes - self._codes):
                        yield line, entry.section, f"no error has the code `{code}`"

    def _is_there(self, module: str, node: ast.AST, section: str, name: str) -> bool:
        if section == RAISES:
            return self._is_error(module, name)
        if section == ARGS:
            return name in self._parameters(node)
        if isinstance(node, ast.ClassDef):
            return self._tree.has_member(module, node, name)
        if isinstance(node, ast.Module):
            return self._tree.found_in(module, name)
        return False

    def _parameters(self, node: ast.AST) -> set[str]:
        """Of a function; of a class, what makes it: its maker's and its fields."""
        if isinstance(node, ast.ClassDef):
            found: set[str] = set()
            for inner in node.body:
                if isinstance(inner, _Function) and inner.name in (
                    "__init__",
                    "__new__",
                    "__call__",
                ):
                    found |= self._parameters(inner)
                if isinstance(inner, ast.AnnAssign) and isinstance(inner.target, ast.Name):
                    found.add(inner.target.id)
            return found
        if not isinstance(node, _Function):
            # A type of a callable, say: what it takes has no names.
            return set()
        given = node.args
        several = [argument for argument in (given.vararg, given.kwarg) if argument]
        listed = [*given.posonlyargs, *given.args, *given.kwonlyargs, *several]
        return {argument.arg for argument in listed}

    def _is_error(self, module: str, name: str) -> bool:
        """Whether a name is that of an exception: a plain one, one of the tree, or another's."""
        plain = getattr(builtins, name, None)
        if isinstance(plain, type):
            return issubclass(plain, BaseException)
        last = name.rpartition(".")[2]
        if any(self._derives(node) for _, node in self._tree.classes.get(last, [])):
            return True
        first = name.partition(".")[0]
        source = self._tree.scope(module).imported.get(first, first)
        return foreign(source.partition(".")[0]) and source not in self._tree.folders

    def _derives(self, node: ast.ClassDef) -> bool:
        """Whether a class is an exception."""
        for base in node.bases:
            name = ast.unparse(base).rpartition(".")[2]
            plain = getattr(builtins, name, None)
            if isinstance(plain, type) and issubclass(plain, BaseException):
                return True
            if any(self._derives(found) for _, found in self._tree.classes.get(name, [])):
                return True
            if name.endswith(("Error", "Exception")):
                return True
        return False
