"""What the end of a run means."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from freecad.gaussiancad.engine.protocol import Event
from freecad.gaussiancad.engine.wording import worded
from freecad.gaussiancad.language import translate

ENGINE_EXIT = 6
CANCELLED_EXIT = 130

_TOLD = re.compile(r"^gaussiancad: (?P<message>.*) \[(?P<code>[a-z0-9-]+)\]$")
"""How the engine tells an error on stderr."""


class RunState(Enum):
    """How a run ended."""

    DONE = "done"
    FAILED = "failed"
    CANCELLED = "cancelled"
    KILLED = "killed"
    BROKEN = "broken"


@dataclass(frozen=True)
class Ending:
    """What is known when the process has ended.

    Attributes:
        python: the interpreter that was started.
        exit_code: of the process; -1 if a signal ended it.
        cancelled: whether it was asked to stop.
        spoke: False if it should have told events and told none.
        error: its last ``error`` event, or None.
        log: the last lines of its stderr.
    """

    python: str
    exit_code: int
    cancelled: bool
    spoke: bool
    error: Event | None
    log: Sequence[str]


@dataclass(frozen=True)
class Verdict:
    """How a run ended.

    Attributes:
        state: done, refused by the engine, cancelled, killed from outside, or the engine is broken.
        code: the engine's kebab-case code, or empty.
        message: a sentence, empty if done; the engine's own is English.
        args: the values in the engine's.
    """

    state: RunState
    code: str = ""
    message: str = ""
    args: Mapping[str, Any] = field(default_factory=dict)

    @property
    def words(self) -> str:
        """The sentence for who uses the window, in their language."""
        return worded(self.code, self.message, self.args)


def judge(ending: Ending) -> Verdict:
    """Tell how a run ended."""
    if ending.exit_code == 0:
        return Verdict(RunState.DONE)
    if ending.cancelled or ending.exit_code == CANCELLED_EXIT:
        return Verdict(
            RunState.CANCELLED, "cancelled", translate("GaussianCAD", "The run was cancelled.")
        )
    # A shell around the interpreter turns signals into codes above 128.
    if not 0 <= ending.exit_code <= 128:
        return Verdict(RunState.KILLED, "engine-killed", _killed_text())
    return _refusal(ending)


def not_started(python: str, reason: str) -> Verdict:
    """The verdict on an interpreter that could not be started."""
    text = translate(
        "GaussianCAD",
        "The GaussianCAD engine could not be started with {python}: {reason}. Choose GaussianCAD > "
        "Check Engine to see what to do.",
    )
    return Verdict(RunState.BROKEN, "engine-broken", text.format(python=python, reason=reason))


def _refusal(ending: Ending) -> Verdict:
    """The engine ended by itself with an error; its own words go first."""
    state = RunState.BROKEN if ending.exit_code == ENGINE_EXIT else RunState.FAILED
    if ending.error is not None:
        error = ending.error
        return Verdict(state, error.text("code"), error.text("message"), error.values("args"))
    stated = next((match for line in reversed(ending.log) if (match := _TOLD.match(line))), None)
    if stated is not None:
        return Verdict(state, stated["code"], stated["message"])
    last_words = next((line for line in reversed(ending.log) if line.strip()), "")
    if not ending.spoke:
        text = translate(
            "GaussianCAD",
            "The GaussianCAD engine at {python} does not work: {reason}. Choose GaussianCAD > "
            "Check Engine to see what to do.",
        )
        message = text.format(python=ending.python, reason=last_words or ending.exit_code)
        return Verdict(RunState.BROKEN, "engine-broken", message)
    text = translate("GaussianCAD", "The GaussianCAD engine stopped with code {code}.")
    return Verdict(state, "", last_words or text.format(code=ending.exit_code))


def _killed_text() -> str:
    return translate(
        "GaussianCAD",
        "The GaussianCAD engine was ended from outside, or ran out of memory. Close other "
        "programs or choose a simpler preset, then try again.",
    )
