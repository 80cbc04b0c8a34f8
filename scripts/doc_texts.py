"""What people read in the tree: pages, docstrings, comments, and messages with commands in them.

Each is cut into passages.  A passage knows where it stands and what kind of text it is; spans
between backticks, lines of commands and references of docstrings are taken from it here.
"""

import ast
import re
import subprocess
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, auto
from functools import cached_property
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[1]

NEWEST_ALONE = "CHANGELOG.md"
"""Page of which the newest section alone is about what there is."""

_FENCE = re.compile(r"^(```|~~~)")
_SPAN = re.compile(r"(?<!`)(`{1,2})(?!`)([^`]+?)\1(?!`)", re.DOTALL)
_ROLE = re.compile(r":(func|class|mod|data|meth|attr|exc|const|obj):`~?([^`]+)`")


class Kind(Enum):
    """What a passage is."""

    PAGE = auto()
    """Of a page, outside of its blocks of code."""

    COMMANDS = auto()
    """A block of code of a page, which has commands or a program."""

    DOCSTRING = auto()
    COMMENT = auto()
    MESSAGE = auto()
    """A text of a program that is no docstring."""

    SCRIPT = auto()
    """A file of a shell, of settings or of rules: its comments and its commands."""


@dataclass(frozen=True)
class Passage:
    """A piece of text.

    Attributes:
        path: of the file.
        line: of the file on which it begins, from 1.
        text: as it stands there.
        kind: what it is.
    """

    path: Path
    line: int
    text: str
    kind: Kind

    def line_at(self, place: int) -> int:
        """The line of the file on which a character of the text stands."""
        return self.line + self.text.count("\n", 0, place)

    def spans(self) -> Iterator[tuple[int, str]]:
        """Line and content of what stands between backticks, references left out."""
        for match in _SPAN.finditer(_ROLE.sub(_blank, self.text)):
            if "\n\n" not in match[2]:
                yield self.line_at(match.start()), " ".join(match[2].split())

    def references(self) -> Iterator[tuple[int, str, str]]:
        """Line, role and name of the references of a docstring."""
        for match in _ROLE.finditer(self.text):
            yield self.line_at(match.start()), match[1], "".join(match[2].split())


def _blank(match: re.Match[str]) -> str:
    return "\n" * match[0].count("\n")


def listed(*patterns: str) -> list[Path]:
    """The files of the checkout that match, without what git ignores."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", *patterns]
    done = subprocess.run(command, cwd=CHECKOUT, check=True, capture_output=True, text=True)
    paths = (CHECKOUT / name for name in done.stdout.split("\0") if name)
    return sorted({path for path in paths if path.is_file() and not path.is_symlink()})


@dataclass(frozen=True)
class Literal:
    """A text in a file of Python.

    Attributes:
        line: on which it begins, from 1.
        end: on which it ends.
        text: what it says.
    """

    line: int
    end: int
    text: str


class Module:
    """A file of Python.

    Attributes:
        path: of it.
        source: its text.
        tree: its syntax.
    """

    def __init__(self, path: Path, source: str) -> None:
        self.path = path
        self.source = source
        self.tree = ast.parse(self.source)

    @cached_property
    def nodes(self) -> list[ast.AST]:
        """Every piece of the syntax."""
        return list(ast.walk(self.tree))

    @cached_property
    def classes(self) -> list[ast.ClassDef]:
        """All classes, those within others, too."""
        return [node for node in self.nodes if isinstance(node, ast.ClassDef)]

    @cached_property
    def texts(self) -> list[Literal]:
        """All texts of the program that are no docstrings."""
        docstrings = {literal for _, literal in self.documented}
        literals = (literal for node in self.nodes if (literal := _literal(node)))
        return [literal for literal in literals if literal not in docstrings]

    @cached_property
    def documented(self) -> list[tuple[ast.AST, Literal]]:
        """What is documented, each with the docstring's place; of a name with a text after it,
        that of the statement."""
        found: list[tuple[ast.AST, Literal]] = []
        for node in self.nodes:
            body = getattr(node, "body", None)
            if not isinstance(body, list):
                continue
            for before, statement in zip([None, *body], body, strict=False):
                literal = _literal(statement.value) if isinstance(statement, ast.Expr) else None
                if literal:
                    found.append((node if before is None else before, literal))
        return found

    def passages(self) -> Iterator[Passage]:
        """Docstrings, comments, and other texts with backticks."""
        for _, docstring in self.documented:
            yield Passage(self.path, docstring.line, docstring.text, Kind.DOCSTRING)
        for literal in self.texts:
            if "`" in literal.text:
                yield Passage(self.path, literal.line, literal.text, Kind.MESSAGE)
        lines = self.source.split("\n")
        begun, texts, goes_on = 0, list[str](), False
        for number in [*self.comments, len(lines) + 1]:
            column = self.comments.get(number)
            whole = column is not None and not lines[number - 1][:column].strip()
            if texts and not (whole and goes_on and number == begun + len(texts)):
                yield Passage(self.path, begun, "\n".join(texts), Kind.COMMENT)
                texts = []
            goes_on = whole
            if column is not None:
                begun = begun if texts else number
                texts.append(lines[number - 1][column + 1 :])

    @cached_property
    def comments(self) -> dict[int, int]:
        """By line, from 1, where its comment begins."""
        strings = sorted(
            (node.lineno, node.col_offset, node.end_lineno or 0, node.end_col_offset or 0)
            for node in self.nodes
            if isinstance(node, ast.JoinedStr)
            or (isinstance(node, ast.Constant) and isinstance(node.value, str | bytes))
        )
        starts = [(line, column) for line, column, _, _ in strings]
        # The end of what begins before: a text within another's braces ends earlier.
        ends: list[tuple[int, int]] = []
        for _, _, line, column in strings:
            ends.append(max((line, column), ends[-1] if ends else (0, 0)))
        found = {}
        for number, text in enumerate(self.source.split("\n"), 1):
            column = text.find("#")
            while column >= 0:
                at = number, len(text[:column].encode())
                before = bisect_right(starts, at)
                if not before or ends[before - 1] <= at:
                    found[number] = column
                    break
                column = text.find("#", column + 1)
        return found

    def program(self) -> str:
        """The source without docstrings and comments."""
        lines = self.source.split("\n")
        for number, column in self.comments.items():
            lines[number - 1] = lines[number - 1][:column]
        for _, docstring in self.documented:
            for number in range(docstring.line, docstring.end + 1):
                lines[number - 1] = ""
        return "\n".join(lines)


def _literal(node: ast.AST) -> Literal | None:
    """What a piece of syntax says, if it is a text."""
    if not isinstance(node, ast.Constant) or not isinstance(node.value, str):
        return None
    return Literal(node.lineno, node.end_lineno or node.lineno, node.value)


def page_passages(path: Path, text: str) -> Iterator[Passage]:
    """The text of a page and its blocks of code."""
    lines = text.split("\n")
    if path.name == NEWEST_ALONE:
        heads = [number for number, line in enumerate(lines) if line.startswith("## ")]
        lines = lines[: heads[1]] if len(heads) > 1 else lines
    begun, texts, kind, fenced = 1, list[str](), Kind.PAGE, False
    for number, line in enumerate(lines, 1):
        fence = bool(_FENCE.match(line))
        indented = line.startswith("    ") and (kind is Kind.COMMANDS or not "".join(texts[-1:]))
        coded = fenced or fence or (indented and not _in_list(texts))
        this_kind = Kind.COMMANDS if coded else Kind.PAGE
        if this_kind is not kind and (line.strip() or fenced):
            yield Passage(path, begun, "\n".join(texts), kind)
            begun, texts, kind = number, [], this_kind
        texts.append("" if fence else line)
        fenced = fenced != fence
    yield Passage(path, begun, "\n".join(texts), kind)


def _in_list(texts: list[str]) -> bool:
    """Whether what goes on is an item of a list, not a block of code."""
    written = [text for text in texts if text.strip()]
    return bool(written) and bool(re.match(r"\s*([-*]|\d+\.)\s|\s{2,3}\S", written[-1]))
