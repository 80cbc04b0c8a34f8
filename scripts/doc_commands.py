"""Whether the commands of texts are there: targets of make, modules of Python, the engine's own.

A command of another program is nobody's business here.
"""

import argparse
import ast
import re
import sys
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path

from doc_names import Tree
from doc_texts import CHECKOUT, listed

_OPTION = re.compile(r"(?<![\w-])--[a-z][\w-]*")
_PLACEHOLDER = re.compile(r"[A-Z]|[<{$…]|\.\.\.")

_END = re.compile(r"\s#\s|[|;&>]|\s\\?$")
"""Where a command ends on its line."""

_MAKE = re.compile(r"(?:^|[&;(] ?|sudo )make ([a-z][\w-]*)")
_MODULE = re.compile(r"(?:^|[\s/`(])python[\d.]* -m ([\w.]+)((?:\s+[^\s`]+)*)")
_FILE = re.compile(
    r"(?:^|[\s/`])(?:python[\d.]*|freecadcmd|sh) ([\w./-]+\.(?:py|sh))((?:\s+[^\s`]+)*)"
)
_ENGINE = re.compile(r"(?:^|[&;] ?|/)gaussiancad(?: (?!-)(\S+))?((?: .*)?)$")


class Commands:
    """Looks at commands, in a tree."""

    def __init__(self, tree: Tree) -> None:
        self._tree = tree

    @cached_property
    def targets(self) -> frozenset[str]:
        """Of make."""
        text = (CHECKOUT / "Makefile").read_text(encoding="utf-8")
        return frozenset(re.findall(r"^([a-z][\w-]*):", text, re.MULTILINE))

    @cached_property
    def engine(self) -> dict[str, frozenset[str]]:
        """The options of each subcommand of the engine, from its own parser; those of all under
        the empty name."""
        # That of this checkout, whatever is installed.
        sys.path.insert(0, str(CHECKOUT / "core"))
        from gaussiancad_core.cli.parser import build_parser

        parser = build_parser()
        found = {"": frozenset(parser._option_string_actions)}
        for action in parser._actions:
            if isinstance(action, argparse._SubParsersAction):
                for name, inner in action.choices.items():
                    found[name] = frozenset(inner._option_string_actions)
        return found

    @cached_property
    def options(self) -> frozenset[str]:
        """Every option that some program of the tree takes or gives to another."""
        found = {option for options in self.engine.values() for option in options}
        for name in self._tree.modules:
            found |= self._options_of(name)
        for path in listed("*.sh", "Makefile", "*.ini", "*.toml", ".ci/*"):
            found |= set(_OPTION.findall(path.read_text(encoding="utf-8")))
        return frozenset(found)

    @cached_property
    def _questions(self) -> frozenset[str]:
        """Names of the benchmarks."""
        paths = (CHECKOUT / "benchmarks" / "ask").glob("*.py")
        return frozenset(path.stem for path in paths if path.stem != "__init__")

    def wrong(self, text: str) -> Iterator[str]:
        """What is wrong with a command; nothing where there is none of the tree."""
        for match in _MAKE.finditer(text):
            if match[1] not in self.targets:
                yield f"make has no target `{match[1]}`"
        yield from self.wrong_modules(text)
        if engine := _ENGINE.search(text):
            yield from self._wrong_of_engine(engine[1] or "", engine[2])
        elif text.startswith("--"):
            for option in _OPTION.findall(text):
                if option not in self.options:
                    yield f"no command has the option `{option}`"

    def wrong_modules(self, text: str) -> Iterator[str]:
        """What is wrong with a module, or a file, that Python is told to run."""
        for match in _MODULE.finditer(text):
            yield from self._wrong_of_module(match[1].rstrip("."), match[2])
        for match in _FILE.finditer(text):
            path = CHECKOUT / match[1]
            if _PLACEHOLDER.search(match[1]):
                continue
            if not path.exists() and (CHECKOUT / match[1].partition("/")[0]).is_dir():
                yield f"there is no file `{match[1]}`"
            elif path in self._tree.paths:
                known = self._options_of(self._tree.paths[path], follow=2)
                yield from self._unknown(match[2], known, match[1])

    def _wrong_of_engine(self, name: str, rest: str) -> Iterator[str]:
        if _PLACEHOLDER.match(name):
            return
        if name not in self.engine:
            yield f"gaussiancad has no command `{name}`"
            return
        yield from self._unknown(rest, self.engine[name], f"gaussiancad {name}".rstrip())

    def _wrong_of_module(self, name: str, rest: str) -> Iterator[str]:
        if name.partition(".")[0] not in self._tree.folders:
            return
        if name not in self._tree.folders:
            yield f"there is no module `{name}`"
            return
        known = self._options_of(name) | self._options_of(f"{name}.__main__")
        if name == "benchmarks":
            known |= self._options_of("benchmarks.run.command")
            asked = rest.split(maxsplit=1)[0].strip(".,:)") if rest.split() else ""
            if re.fullmatch(r"[a-z][a-z_]*", asked):
                if asked not in self._questions:
                    yield f"there is no benchmark `{asked}`"
                    return
                known |= self._options_of(f"benchmarks.ask.{asked}", follow=2)
        elif name == "learning":
            known |= self._options_of("learning.learning_command")
        elif name == "gaussiancad_core":
            words = rest.split()
            yield from self._wrong_of_engine(words[0] if words else "", " ".join(words[1:]))
            return
        yield from self._unknown(rest, known, f"python -m {name}")

    def _unknown(self, rest: str, known: frozenset[str] | set[str], who: str) -> Iterator[str]:
        end = _END.search(rest)
        for option in _OPTION.findall(rest[: end.start()] if end else rest):
            if option not in known and option != "--help":
                yield f"`{who}` has no option `{option}`"

    def _options_of(self, module: str, follow: int = 0) -> frozenset[str]:
        """The options that a module spells out.

        Args:
            module: dotted name; of none there are none.
            follow: imports, one of the other, of which the options count, too.
        """
        if module not in self._tree.modules:
            return frozenset()
        facts = self._tree.modules[module]
        found = {text.text for text in facts.texts if _OPTION.fullmatch(text.text)}
        if follow:
            for node in facts.nodes:
                if isinstance(node, ast.ImportFrom) and node.module:
                    found |= self._options_of(node.module, follow - 1)
                    for alias in node.names:
                        found |= self._options_of(f"{node.module}.{alias.name}", follow - 1)
        return frozenset(found)


def lines_of(block: str) -> Iterator[tuple[int, str]]:
    """The commands of a block of code, from which line on; those that go on are put together."""
    begun, whole = 0, ""
    for number, line in enumerate(block.split("\n")):
        begun = begun if whole else number
        whole += line.strip().removeprefix("$ ")
        if whole.endswith("\\"):
            whole = whole[:-1]
            continue
        if whole:
            yield begun, whole
        whole = ""


def script(path: Path) -> bool:
    """Whether a file is of a shell."""
    return path.suffix == ".sh" or path.name in ("Makefile", "run")
