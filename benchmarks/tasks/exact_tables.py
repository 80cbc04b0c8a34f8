"""The figures of ``exact_solid`` in rows."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence

import numpy as np

from benchmarks.run.workers import Row
from benchmarks.tasks.exact_work import causes, close, falsely_verified, solved
from gaussiancad_protocol.modes import Status


def tables(rows: Sequence[Row]) -> str:
    """For each kind of drawing a row for each group, and why parts are not exact."""
    lines = []
    for kind, of_kind in _by(rows, "input"):
        lines += ["", _head(kind)]
        groups = _by(of_kind, "group")
        lines += [_figures(group, some) for group, some in groups]
        if len(groups) > 1:
            lines.append(_figures("all", of_kind))
        lines += _processor(of_kind)
        lines += _counted("not exact", (causes(row) for row in of_kind))
        doubted = (row.get("reasons", []) for row in of_kind if solved(row))
        lines += _counted("exact, but doubted", doubted)
    return "\n".join(lines)


def summary(rows: Sequence[Row]) -> tuple[tuple[str, ...], tuple[tuple[str, ...], ...]]:
    """A table of exact parts, and of those verified, by class and kind of drawing: head, rows."""
    kinds = [kind for kind, _ in _by(rows, "input")]
    groups = [*_by(rows, "group"), ("all", list(rows))]
    lines = []
    for name, some in groups:
        cells = [_exact_verified([row for row in some if row["input"] == kind]) for kind in kinds]
        lines.append((name, *cells))
    return ("exact, verified", *kinds), tuple(lines)


def _exact_verified(rows: Sequence[Row]) -> str:
    verified = sum(row.get("status") == Status.VERIFIED.value for row in rows)
    return f"{sum(map(solved, rows))}, {verified} of {len(rows)}"


def _head(kind: str) -> str:
    names = (
        "parts", "exact", "close", "faces=", "verif.", "false", "far", "approx.", "failed", "alt.",
        "mirror", "med. s", "95% s", "most s",
    )  # fmt: skip
    return f"{kind:14}" + "".join(f"{name:>8}" for name in names)


def _figures(name: str, rows: Sequence[Row]) -> str:
    statuses = Counter(row.get("status", "none") for row in rows)
    counts = (
        sum(falsely_verified(row) for row in rows),
        sum(falsely_verified(row) and not close(row) for row in rows),
        statuses["approximate"],
        statuses["failed"] + statuses["none"],
        sum(bool(row.get("in_alternatives")) for row in rows),
        sum(bool(row.get("mirrored")) for row in rows),
    )
    alike = sum(solved(row) and row["faces"] == row["true_faces"] for row in rows)
    exact = sum(map(solved, rows))
    near = sum(map(close, rows))
    shares = f"{exact / len(rows):8.3f}{near / len(rows):8.3f}{alike / max(exact, 1):8.3f}"
    shares += f"{statuses['verified'] / len(rows):8.3f}"
    seconds = [row["seconds"] for row in rows if "seconds" in row] or [float("nan")]
    times = (np.median(seconds), np.percentile(seconds, 95), max(seconds))
    return (
        f"{name:14}{len(rows):8}{shares}"
        + "".join(f"{value:8}" for value in counts)
        + "".join(f"{value:8.2f}" for value in times)
    )


def _processor(rows: Sequence[Row]) -> list[str]:
    """On a busy machine this tells more of the solver than the clock does."""
    seconds = [row["processor"] for row in rows if "processor" in row]
    if not seconds:
        return []
    median, most = np.median(seconds), np.percentile(seconds, 95)
    return [f"  processor s of those that ended: median {median:.2f}, 95 % {most:.2f}"]


def _counted(title: str, codes: Iterable[Iterable[str]]) -> list[str]:
    counts = Counter(code for some in codes for code in some)
    if not counts:
        return []
    return [f"  {title}: " + ", ".join(f"{code} {n}" for code, n in counts.most_common())]


def _by(rows: Sequence[Row], key: str) -> list[tuple[str, list[Row]]]:
    found: dict[str, list[Row]] = defaultdict(list)
    for row in rows:
        found[row[key]].append(row)
    return list(found.items())
