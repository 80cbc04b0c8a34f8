"""What the tools do: each takes its arguments and gives an answer, or an error with a code."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import msgspec

import gaussiancad
from gaussiancad import Reading, Result
from gaussiancad.agent.agent_pictures import PREVIEW_PX, Picture, enlarged, scaled
from gaussiancad.agent.allowed_paths import WorkFolder
from gaussiancad.agent.kept_readings import Kept, KeptReading, KeptResult
from gaussiancad.agent.reading_summary import reading_summary, rounded, stroke_entry
from gaussiancad.agent.result_summary import (
    check_summary,
    comparison_summary,
    features_summary,
    result_summary,
)
from gaussiancad.agent.stroke_selection import check_ids, selected_box, selected_strokes
from gaussiancad.agent.tool_arguments import (
    CheckArguments,
    CompareArguments,
    CorrectArguments,
    ExplainArguments,
    FeaturesArguments,
    FilesArguments,
    LookArguments,
    ReadArguments,
    ReconstructArguments,
    SheetArguments,
)
from gaussiancad.engine_call import Progress
from gaussiancad_core.errors import UsageError
from gaussiancad_protocol.codes import Code

_SHEETS = frozenset(
    {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp", ".pdf", ".svg", ".dxf"}
)
_MODELS = frozenset({".step", ".stp", ".brep", ".stl", ".ply", ".obj"})

_MOST_FILES = 200
"""That one answer lists."""

_MOST_LINES = 150
"""Sentences of an explanation."""


@dataclass(frozen=True)
class Answer:
    """What a tool gives.

    Attributes:
        values: JSON values, or text.
        pictures: to look at.
    """

    values: Mapping[str, Any] | str
    pictures: tuple[Picture, ...] = ()


def _readings() -> Kept[KeptReading]:
    return Kept("reading", "read the sheet again")


def _results() -> Kept[KeptResult]:
    return Kept("part", "reconstruct it again")


@dataclass(frozen=True)
class AgentTools:
    """The tools of one server.

    Attributes:
        work: the folder that it works in.
        readings, results: what has an id.
    """

    work: WorkFolder
    readings: Kept[KeptReading] = field(default_factory=_readings)
    results: Kept[KeptResult] = field(default_factory=_results)

    def files(self, asked: FilesArguments, _progress: Progress) -> Answer:
        """List the drawings and the models of the folder."""
        found = list(self.work.files(_SHEETS, _MODELS))
        shown = found[asked.offset : asked.offset + _MOST_FILES]
        values: dict[str, Any] = {
            "folder": str(self.work.root),
            "drawings": [
                self.work.name_of(path) for path in shown if path.suffix.lower() in _SHEETS
            ],
            "models": [self.work.name_of(path) for path in shown if path.suffix.lower() in _MODELS],
        }
        return Answer(values | _next(asked.offset, len(shown), len(found)))

    def read(self, asked: ReadArguments, progress: Progress) -> Answer:
        """Read a sheet."""
        sheet = self.work.inside(asked.sheet)
        with self.work.output(sheet, "reading", asked.output) as output:
            reading = gaussiancad.read(sheet, output=output, progress=progress, **asked.options())
        return self._read(reading, output, picture=asked.picture)

    def look(self, asked: LookArguments, _progress: Progress) -> Answer:
        """List strokes of a view or in a box, and show them enlarged."""
        reading = self.readings.find(asked.reading_id).load()
        found = selected_strokes(reading, asked)
        shown = found[asked.offset : asked.offset + asked.limit]
        box = selected_box(reading, asked)
        values = {
            "reading_id": asked.reading_id,
            "box": rounded(box),
            "count": len(found),
            "strokes": [stroke_entry(stroke) for stroke in shown],
            **_next(asked.offset, len(shown), len(found)),
        }
        if not asked.picture:
            return Answer(values)
        # Those that are listed are named in the picture.
        listed = {stroke["id"] for stroke in shown}
        rest = [stroke for stroke in found if stroke["id"] not in listed]
        return Answer(values, (enlarged(reading, box, [*shown, *rest]),))

    def correct(self, asked: CorrectArguments, progress: Progress) -> Answer:
        """Correct a reading; the earlier one stays."""
        reading = self.readings.find(asked.reading_id).load()
        check_ids(reading, asked.operations)
        operations = [msgspec.to_builtins(operation) for operation in asked.operations]
        with self.work.output(reading.sheet, "reading", asked.output) as output:
            corrected = gaussiancad.correct(reading, operations, output=output, progress=progress)
        return self._read(corrected, output, picture=asked.picture, earlier=asked.reading_id)

    def reconstruct(self, asked: ReconstructArguments, progress: Progress) -> Answer:
        """Make a part of a sheet, or of a reading."""
        if (asked.sheet is None) == (asked.reading_id is None):
            raise UsageError(Code.WRONG_USAGE, "reconstruct: give a sheet or a reading_id")
        options: dict[str, Any] = {
            "result": asked.result,
            "preset": asked.preset,
            "seed": asked.seed,
            "progress": progress,
        }
        if asked.reading_id is not None:
            if asked.options() != SheetArguments().options():
                raise UsageError(
                    Code.WRONG_USAGE,
                    "reconstruct: what is known of the sheet is in the reading: leave it out, or "
                    "say it with correct",
                )
            reading = self.readings.find(asked.reading_id).load()
            with self.work.output(reading.sheet, "part", asked.output) as output:
                gaussiancad.solve(reading, **options).save(output)
        else:
            sheet = self.work.inside(str(asked.sheet))
            with self.work.output(sheet, "part", asked.output) as output:
                gaussiancad.reconstruct(sheet, **options, **asked.options()).save(output)
        return self._reconstructed(Result(output), pictures=asked.pictures)

    def explain(self, asked: ExplainArguments, _progress: Progress) -> Answer:
        """Say why a reading or a part is what it is."""
        store: Kept[Any] = self.results if asked.id in self.results else self.readings
        lines = gaussiancad.explain(store.find(asked.id).load(), at=asked.at, view=asked.view)
        more = len(lines) - _MOST_LINES
        rest = [f"... and {more} lines more"] if more > 0 else []
        return Answer("\n".join([*lines[:_MOST_LINES], *rest]))

    def compare(self, asked: CompareArguments, progress: Progress) -> Answer:
        """Measure a part against a reference."""
        comparison = gaussiancad.compare(
            self._model(asked.result),
            self._model(asked.reference),
            points=asked.points,
            progress=progress,
        )
        return Answer(comparison_summary(comparison))

    def check(self, asked: CheckArguments, progress: Progress) -> Answer:
        """Tell whether a model agrees with its drawing."""
        sheet = self.work.inside(asked.sheet)
        solid = self._model(asked.solid)
        with self.work.output(sheet, "check", asked.output) as output:
            found = gaussiancad.check(
                sheet, solid, output=output, progress=progress, **asked.options()
            )
        values = {**check_summary(found), "files": self._files(output)}
        pictures = (scaled(output / "check.png", "where both differ"),) if asked.picture else ()
        return Answer(values, pictures)

    def features(self, asked: FeaturesArguments, progress: Progress) -> Answer:
        """Find the features of a solid."""
        solid = self._model(asked.solid)
        named = Path(asked.solid)
        with self.work.output(named, "features", asked.output) as output:
            found = gaussiancad.features(solid, output, progress=progress)
        return Answer({**features_summary(found), "files": self._files(output)})

    def _read(
        self, reading: Reading, output: Path, *, picture: bool, earlier: str | None = None
    ) -> Answer:
        name = self.work.id_of(output)
        self.readings.keep(name, KeptReading(output, reading.sheet))
        values = {
            "reading_id": name,
            **({"earlier_reading_id": earlier} if earlier else {}),
            "sheet": self.work.name_of(reading.sheet),
            "files": self._files(output),
            **reading_summary(reading),
        }
        pictures = (scaled(output / "reading.png", "the reading"),) if picture else ()
        return Answer(values, pictures)

    def _reconstructed(self, part: Result, *, pictures: bool) -> Answer:
        name = self.work.id_of(part.folder)
        self.results.keep(name, KeptResult(part.folder))
        values = {
            "result_id": name,
            **result_summary(part),
            "files": self._files(part.folder),
        }
        shown = (
            ("overlay.png", "the part's lines over the sheet", None),
            ("preview.png", "the part", PREVIEW_PX),
        )
        return Answer(
            values,
            tuple(
                scaled(part.folder / file, shows, *((longest,) if longest else ()))
                for file, shows, longest in shown
                if pictures and (part.folder / file).is_file()
            ),
        )

    def _files(self, folder: Path) -> list[str]:
        return [
            self.work.name_of(path)
            for path in sorted(folder.iterdir())
            if not path.name.startswith(".")
        ]

    def _model(self, name: str) -> Result | Path:
        if name in self.results:
            return self.results.find(name).load()
        return self.work.inside(name)


def _next(offset: int, shown: int, count: int) -> dict[str, int]:
    """Where a list goes on, if it does."""
    return {"next_offset": offset + shown} if offset + shown < count and shown else {}
