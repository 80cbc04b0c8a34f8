"""What a person at a terminal sees of a run: one line that tells how far it is, and the end."""

import sys
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from gaussiancad_core.cli.streams import drop
from gaussiancad_core.messages import on_one_line

if TYPE_CHECKING:
    from gaussiancad_core.report.run_report import Report

_STAGES = {
    "read": "opening the file",
    "views": "finding the views",
    "lines": "reading the lines",
    "masks": "bringing the views together",
    "solid": "finding the solid",
    "hull": "carving the hull",
    "gaussians": "training the Gaussians",
    "surface": "making the surface",
    "check": "checking against the sheet",
    "write": "writing the files",
}

_ERASE = "\r\x1b[K"
"""Of ECMA-48: to the start of the line, and erase it."""

_MOST_REASONS = 2
"""Reasons that the summary tells: the others are told by ``explain``."""


@dataclass
class Terminal:
    """A listener that shows progress in one line of a terminal, or each stage in a line of its own.

    Attributes:
        stream: of the terminal.
        verbose: whether stages that ended stay, with their seconds, and warnings are shown.
    """

    stream: TextIO
    verbose: bool = False
    _step: str = ""
    _began: float = field(default=0.0)

    def send(self, event: str, **fields: Any) -> None:  # noqa: ANN401
        """Take one event."""
        if event == "stage":
            self._begin(fields)
        elif event == "progress" and self._step:
            self._go_on(fields)
        elif event == "warning" and self.verbose:
            self._print(f"{on_one_line(fields['message'])} [{fields['code']}]\n")
        elif event in ("result", "error") and self.stream.isatty():
            self._print("")

    def _begin(self, fields: dict[str, Any]) -> None:
        name = _STAGES.get(fields["name"], fields["name"])
        self._step, self._began = f"[{fields['index']}/{fields['of']}] {name}", time.monotonic()
        if self.stream.isatty():
            self._print(self._step)

    def _go_on(self, fields: dict[str, Any]) -> None:
        fraction = fields["fraction"]
        if fraction >= 1.0:
            if self.verbose:
                self._print(f"{self._step}: {time.monotonic() - self._began:.1f} s\n")
            self._step = ""
        elif self.stream.isatty():
            left = fields.get("eta_s")
            about = f", about {left:.0f} s left" if left is not None and left >= 1.0 else ""
            self._print(f"{self._step}: {100.0 * fraction:.0f} %{about}")

    def _print(self, text: str) -> None:
        erase = _ERASE if self.stream.isatty() else ""
        # What cannot be shown stops nothing.
        try:
            self.stream.write(f"{erase}{text}")
            self.stream.flush()
        except OSError:
            drop(self.stream)


def terminal(*, verbose: bool) -> Terminal | None:
    """What shows a run on this process's terminal; nothing where nobody looks."""
    if not verbose and not sys.stderr.isatty():
        return None
    return Terminal(sys.stderr, verbose)


def summary(report: "Report", path: Path, sheet: Path) -> list[str]:
    """A run in five lines or fewer: what is known, what was made, why no more, and what is next.

    Args:
        report: of the run.
        path: of its file.
        sheet: that was read.
    """
    lines = [report.verdict, f"{report.status.value}: {on_one_line(str(path))}"]
    if report.solid is not None:
        sides = " x ".join(f"{side:.4g}" for side in report.solid.bounding_box_mm)
        size = f"{sides} mm" if report.size_known else f"{sides}, in units of unknown length"
        lines.append(f"solid.step: {report.solid.faces} faces, {size}")
    reasons = [on_one_line(reason.message) for reason in report.reasons]
    lines += reasons[:_MOST_REASONS]
    more = len(reasons) - _MOST_REASONS
    if reasons:
        others = f"{more} more, and why: " if more > 0 else "why: "
        folder, name = (on_one_line(str(this_path)) for this_path in (path.parent, sheet))
        lines.append(
            f"{others}gaussiancad explain {folder}; to correct: gaussiancad correct {name}"
        )
    return lines
