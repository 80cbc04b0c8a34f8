"""The tables of codes in docs/messages.md, from what the protocol explains.

``python3 scripts/messages_page.py`` writes them anew; ``--check`` only tells whether they are up to
date.
"""

import argparse
import re
import sys
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(CHECKOUT / "core"))

from gaussiancad_protocol import explained_errors, explained_results  # noqa: E402
from gaussiancad_protocol.explained import Explained  # noqa: E402

PAGE = CHECKOUT / "docs" / "messages.md"

SECTIONS: dict[str, tuple[Explained, ...]] = {
    "Reasons": explained_results.REASONS,
    "Assumptions": explained_results.ASSUMPTIONS,
    "Warnings": explained_results.WARNINGS,
    "Reasons of a check": explained_results.CHECK,
    "Warnings of a comparison": explained_results.COMPARISON,
    "Errors: reading files": explained_errors.FILES,
    "Errors: no model follows from the sheet": explained_errors.VIEWS,
    "Errors: usage, limits, the engine": explained_errors.LIMITS,
}
"""Heading of the page -> what its table has."""


def table(rows: tuple[Explained, ...]) -> str:
    """A table of codes; of errors with what to do and the exit code."""
    errors = rows[0].exit_code is not None
    head = "| code | what to do | exit |" if errors else "| code | meaning |"
    lines = [head, "| --- | --- | --- |" if errors else "| --- | --- |"]
    for entry in rows:
        codes = ", ".join(f"`{code}`" for code in entry.codes)
        end = f" {entry.exit_code} |" if errors else ""
        lines.append(f"| {codes} | {entry.meaning} |{end}")
    return "\n".join(lines)


def page() -> str:
    """The page with its tables as they should be."""
    text = PAGE.read_text(encoding="utf-8")
    for heading, rows in SECTIONS.items():
        found = re.search(
            rf"^## {re.escape(heading)}\n.*?(^\| code \|.*?)(?=\n\n|\Z)", text, re.M | re.S
        )
        if found is None:
            raise SystemExit(f"{PAGE} has no table under '{heading}'")
        text = text[: found.start(1)] + table(rows) + text[found.end(1) :].rstrip("\n") + "\n"
    return text


def main() -> int:
    """Write the page, or tell whether it is up to date."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 if old")
    options = parser.parse_args()
    wanted = page()
    if options.check:
        return int(wanted != PAGE.read_text(encoding="utf-8"))
    PAGE.write_text(wanted, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
