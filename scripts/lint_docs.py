"""What the documentation names is there: paths, links, commands, options, names, arguments.

``.venv/bin/python scripts/lint_docs.py`` prints each place that names what is not there, and exits
with 1 if there is one.  It reads the pages, the docstrings and comments of all Python files, the
messages with commands in them, and the scripts; nothing heavy is imported.
"""

import ast
import gc
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from doc_commands import Commands, lines_of, script
from doc_names import PACKAGES, Tree, is_test, members_of
from doc_places import Places
from doc_sections import Sections
from doc_texts import CHECKOUT, Kind, Passage, listed, page_passages

_DOTTED = re.compile(
    rf"(?<![\w./@-])(?:{'|'.join(map(re.escape, PACKAGES))})(?:\.\w+)+(?![\w/-])(?!\.\w)"
)
"""A name of the tree, wherever it is written."""

_INNER = re.compile(r"([a-z_]\w*)(?:\.\w+)+")
_MEMBER = re.compile(r"([A-Z]\w+)\.(\w+)")
_SUFFIXES = re.compile(
    r"\.(json|png|svg|pdf|dxf|step|stl|ply|py|sh|md|txt|csv|html|sqlite|toml|ini|onnx|pt|zip|FCStd)$"
)
"""Ends of what is a file and no name."""

_WORD = re.compile(r"[A-Za-z_]+|[a-z]+(?:-[a-z]+)+")
"""What a program may call something, without numbers: those are of examples."""

_WRITTEN = re.compile(r"[\w-]+(?:\.[\w-]+)*\.(?:json|csv|html|sqlite|ply|stl|onnx)")
"""A file that some program writes or reads; pictures, sheets and solids have any name."""

FOREIGN = frozenset(
    (
        "DaskCluster",
        "ReadWriteMany",
        "Standard_Failure",
        "StsNoMem",
        "f_rest",
        "lambda_dssim",
        "lambda_silhouette",
        "removeSplitter",
    )
)
"""What other programs call so, and no program of the tree."""

_CALL = re.compile(r"([\w.]+)\([^()]*\)")


@dataclass(frozen=True)
class Finding:
    """A place that names what is not there.

    Attributes:
        path: of the file.
        line: of it, from 1.
        kind: of what is named.
        text: what is wrong.
    """

    path: Path
    line: int
    kind: str
    text: str

    def __str__(self) -> str:
        """As compilers tell places."""
        return f"{self.path.relative_to(CHECKOUT)}:{self.line}: {self.kind}: {self.text}"


class Reader:
    """Reads the texts of the checkout.

    Attributes:
        tree: what is defined in it.
    """

    def __init__(self) -> None:
        self.tree = Tree()
        self._commands = Commands(self.tree)
        self._places = Places()
        self._sections = Sections(self.tree)

    @cached_property
    def _inner_packages(self) -> frozenset[str]:
        """Packages that pages name without the engine's name before them."""
        return frozenset(
            name.split(".")[1] for name in self.tree.folders if name.startswith("gaussiancad_core.")
        )

    @cached_property
    def _reported(self) -> frozenset[str]:
        """Keys of reports, which have parts called as packages are: ``solid``, ``surface``."""
        return frozenset(
            member
            for name, module in self.tree.modules.items()
            if name.startswith("gaussiancad_core.report.")
            for node in module.classes
            for member in members_of(node)
        )

    def findings(self) -> Iterator[Finding]:
        """All that is wrong, file by file."""
        for path in listed("*.md"):
            for passage in page_passages(path, path.read_text(encoding="utf-8")):
                yield from self.in_text(passage)
        for path in listed("*.sh", "*.toml", "*.ini", "Makefile", ".importlinter", ".ci/*"):
            whole = path.read_text(encoding="utf-8")
            yield from self.in_text(Passage(path, 1, whole, Kind.SCRIPT))
        for name in self.tree.modules:
            yield from self.in_module(name)

    def in_module(self, name: str) -> Iterator[Finding]:
        """What is wrong in a module of Python, by its dotted name."""
        module = self.tree.modules[name]
        for passage in module.passages():
            if passage.kind is not Kind.MESSAGE or not is_test(module.path):
                yield from self.in_text(passage)
        yield from self._references(name)
        for line, section, text in self._sections.wrong(name):
            yield Finding(module.path, line, section, text)

    def in_text(self, passage: Passage) -> Iterator[Finding]:
        """What is wrong in a piece of text."""
        path = passage.path
        for line, text in self._places.wrong_paths(passage):
            yield Finding(path, line, "path", text)
        if passage.kind in (Kind.PAGE, Kind.COMMANDS):
            for line, text in self._places.wrong_links(passage):
                yield Finding(path, line, "link", text)
        for line, text in self._wrong_commands(passage):
            yield Finding(path, line, "command", text)
        for line, text in self._wrong_names(passage):
            yield Finding(path, line, "name", text)

    def _wrong_commands(self, passage: Passage) -> Iterator[tuple[int, str]]:
        commands = self._commands
        if passage.kind is Kind.COMMANDS or script(passage.path):
            for number, command in lines_of(passage.text):
                for text in commands.wrong(command):
                    yield passage.line + number, text
            return
        for line, span in passage.spans():
            for text in commands.wrong(span):
                yield line, text
        if passage.kind in (Kind.DOCSTRING, Kind.COMMENT):
            for number, plain in enumerate(passage.text.split("\n")):
                if "`" not in plain:
                    for text in commands.wrong_modules(plain):
                        yield passage.line + number, text

    def _wrong_names(self, passage: Passage) -> Iterator[tuple[int, str]]:
        tree = self.tree
        for match in _DOTTED.finditer(passage.text):
            dotted = match[0]
            if not _SUFFIXES.search(dotted) and not tree.leads_somewhere(dotted):
                yield passage.line_at(match.start()), f"there is no `{dotted}`"
        if passage.kind not in (Kind.PAGE, Kind.DOCSTRING, Kind.COMMENT):
            return
        for line, span in passage.spans():
            if text := self._wrong_name(span, passage.path):
                yield line, text

    def _wrong_name(self, span: str, path: Path) -> str:
        """What is wrong with a name between backticks; nothing where it is none, or is there."""
        tree, words = self.tree, self.tree.words(path)
        called = _CALL.fullmatch(span)
        name = called[1] if called else span
        if _WRITTEN.fullmatch(name):
            tails = [name.split(".", count)[-1] for count in range(name.count("."))]
            return "" if words.intersection(tails) else f"nothing has to do with a file `{name}`"
        if _SUFFIXES.search(name) or name.startswith(PACKAGES) or name in FOREIGN:
            return ""
        inner = _INNER.fullmatch(name)
        if inner and inner[1] in self._inner_packages:
            known = name.rpartition(".")[2] in self._reported
            known = known or tree.leads_somewhere(f"gaussiancad_core.{name}")
            return "" if known else f"there is no `{name}` in the engine"
        if (member := _MEMBER.fullmatch(name)) and tree.knows(path, member[1]):
            known = tree.found_in("", f".{name}")
            return "" if known else f"`{member[1]}` has no `{member[2]}`"
        if "." not in name and (called or _WORD.fullmatch(name)) and name not in words:
            return f"nothing is called `{name}`"
        return ""

    def _references(self, name: str) -> Iterator[Finding]:
        """What docstrings refer to by roles."""
        module = self.tree.modules[name]
        within = {id(inner): node for node in module.classes for inner in ast.walk(node)}
        for node, docstring in module.documented:
            passage = Passage(module.path, docstring.line, docstring.text, Kind.DOCSTRING)
            around = within.get(id(node))
            for line, role, dotted in passage.references():
                if not self.tree.found_in(name, dotted, around):
                    yield Finding(module.path, line, "reference", f":{role}:`{dotted}`")


def main() -> int:
    """Print what is found, and how much of each kind."""
    # Millions of small objects that all stay: looking for what could go takes longer than all else.
    gc.disable()
    found = sorted(set(Reader().findings()), key=lambda item: (item.path, item.line, item.text))
    for finding in found:
        print(finding)
    counts = Counter(finding.kind for finding in found)
    said = ", ".join(f"{kind} {count}" for kind, count in sorted(counts.items()))
    print(f"what is not there: {said}" if found else "all that is named is there")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())
