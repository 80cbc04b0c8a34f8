"""What is known of a code beside its sentence: a row of docs/messages.md."""

from dataclasses import dataclass

from gaussiancad_protocol.codes import Code


@dataclass(frozen=True)
class Explained:
    """Codes that mean the same, or call for the same.

    Attributes:
        codes: one or more.
        meaning: of a reason or warning; of an error what to do.  In Markdown.
        exit_code: of the command, for an error.
    """

    codes: tuple[Code, ...]
    meaning: str
    exit_code: int | None = None


def row(meaning: str, *codes: Code, exit_code: int | None = None) -> Explained:
    """A row, with its text first."""
    return Explained(codes, meaning, exit_code)
