"""What is asked of ``gaussiancad read``, as data, and as the engine's arguments."""

from dataclasses import dataclass

READING_FILE = "reading.json"
"""What the engine leaves in the job's folder."""


@dataclass(frozen=True)
class ReadJob:
    """A sheet to be read into ``reading.json``, whatever follows from it.

    Attributes:
        sheet: path of the drawing; corrections beside it are taken.
        output: folder for the engine's files.
        page: of a PDF, TIFF or DXF file, from 1.
        corrections: a file that is taken instead of the one beside the sheet, or empty.
    """

    sheet: str
    output: str
    page: int = 1
    corrections: str = ""

    def arguments(self) -> list[str]:
        """``read --output DIR ... -- SHEET``, whose name may begin with a dash."""
        return [
            "read",
            *("--output", self.output),
            *("--page", str(self.page)),
            *(("--corrections", self.corrections) if self.corrections else ()),
            "--events",
            "--",
            self.sheet,
        ]
