"""The figures of ``exact_solid`` in rows, and time against faces as a picture."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from html import escape

import numpy as np

from benchmarks.methods.exact_peers import Peer
from benchmarks.run.workers import Row
from benchmarks.tasks.exact_work import causes, close, falsely_verified, solved

# Okabe and Ito (2008): colour-blind people can tell them apart.
_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")

_WIDTH, _HEIGHT, _MARGIN = 820.0, 440.0, 60.0
_LEGEND = 100.0
_SECONDS = (0.1, 300.0)


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
        lines += _expressible(of_kind)
        lines += _peers(of_kind)
        lines += _counted("not exact", (causes(row) for row in of_kind))
        doubted = (row.get("reasons", []) for row in of_kind if solved(row))
        lines += _counted("exact, but doubted", doubted)
    return "\n".join(lines)


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


def _expressible(rows: Sequence[Row]) -> list[str]:
    """How many parts have surfaces that cells cannot express, which, and how the others do."""
    known = [row for row in rows if "unsupported" in row]
    able = [row for row in known if not row["unsupported"]]
    if len(able) == len(known):
        return []
    kinds = Counter(kind for row in known for kind in row["unsupported"])
    counted = ", ".join(f"{kind} {n}" for kind, n in kinds.most_common())
    return [
        f"  surfaces that cells do not express: {len(known) - len(able)} of {len(known)} parts "
        f"({counted}); of the {len(able)} others {sum(map(solved, able))} are exact, "
        f"{sum(row.get('status') == 'verified' for row in able)} verified"
    ]


def _peers(rows: Sequence[Row]) -> list[str]:
    lines = []
    for peer in Peer:
        values = [row[peer.value] for row in rows if row.get(peer.value) is not None]
        if values:
            exact = np.mean([value >= 0.999 for value in values])
            lines.append(
                f"  {peer.value}: IoU median {np.median(values):.4f}, "
                f"at least .999 in {exact:.3f} of {len(values)}"
            )
    return lines


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


def time_picture(rows: Sequence[Row], most_faces: int = 150) -> str:
    """An SVG of seconds (logarithmic) against faces: full circles are exact, rings are not."""
    shown = [row for row in rows if "seconds" in row]
    colours = dict(zip(dict.fromkeys(row["group"] for row in shown), _COLOURS * 9, strict=False))
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH:.0f}" height="{_HEIGHT:.0f}" '
        'font-family="DejaVu Sans, Arial, sans-serif" font-size="13">',
        '<rect width="100%" height="100%" fill="white"/>',
    ]
    for faces in range(0, most_faces + 1, 25):
        x = _x(faces, most_faces)
        parts.append(_line((x, _y(_SECONDS[0])), (x, _y(_SECONDS[1]))))
        parts.append(_text((x, _HEIGHT - _MARGIN + 20.0), str(faces), "middle"))
    for seconds in (0.1, 1.0, 10.0, 100.0):
        y = _y(seconds)
        parts.append(_line((_MARGIN, y), (_x(most_faces, most_faces), y)))
        parts.append(_text((_MARGIN - 8.0, y + 4.0), f"{seconds:g} s", "end"))
    for row in shown:
        x, y = _x(min(row["true_faces"], most_faces), most_faces), _y(row["seconds"])
        colour = colours[row["group"]]
        fill = colour if solved(row) else "none"
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{fill}" stroke="{colour}"/>')
    for index, (group, colour) in enumerate(colours.items()):
        at = (_WIDTH - _LEGEND - 30.0, _MARGIN / 2.0 + 18.0 * index + 6.0)
        parts.append(f'<circle cx="{at[0]:.1f}" cy="{at[1] - 4.5:.1f}" r="4" fill="{colour}"/>')
        parts.append(_text((at[0] + 10.0, at[1]), escape(group), "start"))
    parts.append(_text((_WIDTH / 2.0, _HEIGHT - 16.0), "faces of the part", "middle"))
    return "\n".join([*parts, "</svg>\n"])


def _x(faces: float, most: int) -> float:
    return _MARGIN + (_WIDTH - _LEGEND - 2.0 * _MARGIN) * faces / most


def _y(seconds: float) -> float:
    low, high = np.log(_SECONDS)
    share = (np.log(np.clip(seconds, *_SECONDS)) - low) / (high - low)
    return float(_HEIGHT - _MARGIN - (_HEIGHT - 1.5 * _MARGIN) * share)


def _line(start: tuple[float, float], end: tuple[float, float]) -> str:
    return (
        f'<line x1="{start[0]:.1f}" y1="{start[1]:.1f}" x2="{end[0]:.1f}" y2="{end[1]:.1f}" '
        'stroke="#d0d0d0"/>'
    )


def _text(at: tuple[float, float], text: str, anchor: str) -> str:
    return f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" text-anchor="{anchor}">{text}</text>'
