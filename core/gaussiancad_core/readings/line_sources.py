"""Where the lines of a sheet come from: read, or taken from a file, with a person's corrections."""

from collections.abc import Callable

from gaussiancad_core.errors import UsageError
from gaussiancad_core.messages import Message
from gaussiancad_core.readings.corrected_scales import GivenLength, contradicting_lengths
from gaussiancad_core.readings.correcting import Corrected, Ink, corrected
from gaussiancad_core.readings.reading_files import open_corrections, open_reading
from gaussiancad_core.readings.reading_schema import SheetReading
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_protocol.codes import Code


def given_reading(
    job: Job,
    sheet_sha256: str,
    read: Callable[[], SheetReading],
    notes: RunNotes,
    ink: Ink | None = None,
) -> SheetReading | None:
    """The reading that a run is to take; None where nobody said anything of one.

    Args:
        job: with the files of a reading and of corrections.
        sheet_sha256: of the sheet.
        read: reads the sheet where there are corrections and no reading.
        notes: told how many corrections were taken, and which found no place.
        ink: of the sheet, for corrections that ask for it.

    Raises:
        UnreadableError: ``reading-not-read``, ``corrections-not-read``.
        UsageError: ``corrections-of-another-sheet``.
    """
    if job.given is None and job.corrections is None:
        return None
    reading = open_reading(job.given) if job.given else read()
    if job.corrections is None:
        _note_corrections(Corrected(reading), notes)
        return reading
    path = job.corrections
    corrections = open_corrections(path)
    if corrections.sheet_sha256 != sheet_sha256:
        raise UsageError(
            Code.CORRECTIONS_OF_ANOTHER_SHEET,
            "{path} corrects another sheet, or another version of it: remove it, or correct the "
            "sheet again",
            path=path,
        )
    found = corrected(reading, corrections.ops, ink)
    _note_corrections(found, notes)
    _tell_lengths(contradicting_lengths(reading.scale, corrections.ops), notes)
    return found.reading


def _tell_lengths(pair: tuple[GivenLength, GivenLength] | None, notes: RunNotes) -> None:
    if pair is None:
        return
    earlier, last = pair
    notes.doubt(
        Code.TOLD_LENGTHS_DISAGREE,
        Message(
            "the lengths of {earlier_mm} mm and {last_mm} mm that were given contradict each "
            "other; "
            "the last one was taken: give one of them again",
            earlier_mm=earlier.length_mm,
            last_mm=last.length_mm,
        ),
    )


def _note_corrections(found: Corrected, notes: RunNotes) -> None:
    taken = found.reading.corrected
    if taken:
        notes.warn(
            Code.CORRECTED,
            Message(
                "{count} correction(s) by hand were taken: the result is checked by them",
                count=taken,
            ),
        )
    if found.unmatched:
        names = ", ".join(map(str, found.unmatched[:10]))
        notes.doubt(
            Code.CORRECTIONS_UNMATCHED,
            Message(
                "{count} correction(s) found nothing to correct any more (number {numbers}): look "
                "at them again",
                count=len(found.unmatched),
                numbers=names,
            ),
        )
