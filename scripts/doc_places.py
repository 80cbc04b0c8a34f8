"""Whether the paths and links of texts lead somewhere."""

import re
from collections.abc import Iterator
from functools import cache, cached_property
from pathlib import Path

from doc_texts import CHECKOUT, Kind, Passage, listed

_LINK = re.compile(r"\]\(([^)\s]+)\)")
_HEADING = re.compile(r"^#+\s+(.*)$", re.MULTILINE)

ROOTS = (
    "core",
    "freecad",
    "benchmarks",
    "learning",
    "sample_parts",
    "scripts",
    "tests",
    "docs",
    "resources",
    ".ci",
)
"""Folders of the checkout: a path that begins with one is meant from there."""

_ENGINE = ("gaussiancad_core", "gaussiancad_protocol")
"""Packages from which paths are told without ``core/`` before them."""

_HEADS = "|".join(map(re.escape, (*ROOTS, *_ENGINE)))
_WRITTEN = re.compile(rf"(?<![\w/.~-])(?:{_HEADS})/[\w./*-]*[\w/*]")
"""A path of the checkout, wherever it is written."""

_PATH = re.compile(r"(?:\.{0,2}/)?[\w.*-]+(?:/[\w.*-]+)*/?")
_PLAIN = re.compile(r"(?<![\w/.*{}<>-])[a-z_]\w*\.(?:py|sh|md)\b(?!\.\w)")
"""A file's name wherever it is written."""

_FILE = re.compile(r"[\w*-]+\.(?:py|sh|md|toml|ini)")

_PLACEHOLDER = re.compile(r"\b[A-Z]+\b(?=\.|/|$)")
"""What stands for a name."""

_BASES = ("", "core", "freecad/gaussiancad", "core/gaussiancad_core", "learning", "benchmarks")
"""Folders from which paths are told where it is clear what is spoken of."""

_MADE = ("build/", "demo/", ".venv/", "dist/")
"""What is made, and not in the tree."""


class Places:
    """Looks at paths and links."""

    @cached_property
    def _files(self) -> frozenset[str]:
        """Names of all files."""
        return frozenset(path.name for path in listed())

    @cached_property
    def _folders(self) -> frozenset[str]:
        """All folders, from the checkout."""
        return frozenset(
            parent.as_posix()
            for path in listed()
            for parent in path.relative_to(CHECKOUT).parents
            if parent.name
        )

    def wrong_links(self, passage: Passage) -> Iterator[tuple[int, str]]:
        """Line and address of links of a page that lead nowhere."""
        for match in _LINK.finditer(passage.text):
            path, _, anchor = match[1].partition("#")
            if re.match(r"[a-z]+:", path):
                continue
            target = (passage.path.parent / path).resolve() if path else passage.path
            if not target.exists():
                yield passage.line_at(match.start()), f"there is no `{path}`"
            elif anchor and anchor not in anchors(target):
                yield passage.line_at(match.start()), f"`{target.name}` has no heading `#{anchor}`"

    def wrong_paths(self, passage: Passage) -> Iterator[tuple[int, str]]:
        """Line and path of what is written as a path of the checkout and is not there."""
        written = _LINK.sub(lambda match: " " * len(match[0]), passage.text)
        for match in _WRITTEN.finditer(written):
            if re.match(r"-?[{<$]", passage.text[match.end() :]):
                continue
            if not self._is_there(match[0].rstrip("."), passage.path):
                yield passage.line_at(match.start()), f"there is no `{match[0]}`"
        if passage.kind in (Kind.DOCSTRING, Kind.COMMENT, Kind.PAGE):
            for match in _PLAIN.finditer(written):
                if match[0] not in self._files:
                    yield passage.line_at(match.start()), f"there is no file `{match[0]}`"
        if passage.kind in (Kind.COMMANDS, Kind.SCRIPT, Kind.MESSAGE):
            return
        for line, span in passage.spans():
            if self._meant(span, passage.path) and not self._is_there(span, passage.path):
                yield line, f"there is no `{span}`"

    def _meant(self, span: str, path: Path) -> bool:
        """Whether what stands between backticks is a path of the tree, not looked at yet."""
        if _FILE.fullmatch(span):
            return True
        if not _PATH.fullmatch(span) or "/" not in span or span.startswith((*_MADE, "/", "../")):
            return False
        first = span.partition("/")[0]
        if first in ROOTS or not re.search(r"[a-z]", first):
            return False
        here = path.parent.relative_to(CHECKOUT).as_posix()
        return any(f"{base}/{first}".strip("/") in self._folders for base in (*_BASES, here))

    def _is_there(self, name: str, path: Path) -> bool:
        """Whether a path is there, from one of the places from which it may be told."""
        name = _PLACEHOLDER.sub("*", name)
        if "/" not in name:
            return bool(self._matching(name))
        places = (*(CHECKOUT / base for base in _BASES), path.parent)
        if "*" in name:
            return any(any(place.glob(name)) for place in places)
        return any((place / name).exists() for place in places) or name.startswith(_MADE)

    def _matching(self, name: str) -> list[str]:
        if "*" not in name:
            return [name] if name in self._files else []
        pattern = re.compile(re.escape(name).replace(r"\*", ".*"))
        return [known for known in self._files if pattern.fullmatch(known)]


@cache
def anchors(page: Path) -> frozenset[str]:
    """What links can name of a page: its headings as addresses."""
    headings = _HEADING.findall(page.read_text(encoding="utf-8"))
    plain = (re.sub(r"[^\w\- ]", "", heading.lower().replace("`", "")) for heading in headings)
    return frozenset(heading.replace(" ", "-") for heading in plain)
