"""What is written on sheets: numbers, notes, words."""

import random

_REMARKS = ("±0.1", " ±0.05", " H7", " h6", " +0.1", "°", " TYP", " REF", " mm", '"')
"""After numbers."""

_NOTES = (
    "2x ⌀{size} THRU", "⌀{size} ↧ {depth}", "4x M{whole}", "M{whole}x0.7 ↧{depth}",
    "M{whole} - 6H THRU ALL", "⌀{size} THRU ALL", "⌴ ⌀{size} ↧{depth}", "⌵ ⌀{size} x 90°",
    "R{depth}", "{depth} x 45°", "C{depth}", "4xR{depth}", "2x R{depth}", "BREAK SHARP EDGES",
    "SEE NOTE {whole}", "ALL FILLETS R{depth}", "POLISH", "{size}-{depth}", "⌀{size} H7",
    "4 HOLES EQ. SP.", "PCD {size}", "SLOT {depth} WIDE", "TYP", "{whole} PLACES", "KNURL",
    "A/F {size}",
)  # fmt: skip
"""What leaders tell."""

_WORDS = (
    "ALL DIMENSIONS IN MM UNLESS OTHERWISE STATED REMOVE BURRS SHARP EDGES MATERIAL STEEL "
    "ALUMINIUM 6061-T6 ANODISED BLACK SURFACE FINISH TOLERANCE ISO 2768-mK GENERAL DRAWN CHECKED "
    "APPROVED DATE SCALE SHEET OF TITLE PART NUMBER REV A3 A4 DO NOT SCALE DRAWING THIRD ANGLE "
    "PROJECTION FIRST WEIGHT KG QTY ITEM DESCRIPTION NAME SIGNATURE DEBUR AND COMPANY CONFIDENTIAL "
    "BRACKET SHAFT PLATE FLANGE HOUSING COVER Ra 3.2 1.6 HRC 58-62 DIN EN 10025 S235JR fillets R1 "
    "chamfer C0.5 thread M6 depth holes"
)
"""Of title blocks, tables and notes."""

_CAPTIONS = (
    "{0}-{0}", "SECTION {0}-{0}", "{0}-{0} (1:1)", "VIEW {0}", "{0}", "FRONT", "TOP VIEW",
    "Front View", "Right View", "Top View", "VIEW FROM {0}", "SIDE", "{0} - {0}", "FIG. {0}",
    "PLAN", "ELEVATION",
)  # fmt: skip
"""Of views."""

_HAN = "技术要求材料比例图号名称数量备注设计审核批准日期标记签名共张第未注倒角圆角热处理公差表面"
"""Characters of Chinese title blocks and notes."""


def number(chance: random.Random) -> str:
    """A measure as on a dimension."""
    value = chance.choice(
        [
            chance.randint(1, 20),
            chance.randint(5, 200),
            round(chance.uniform(1.0, 150.0), 1),
            round(chance.uniform(1.0, 99.0), 2),
            round(chance.uniform(0.1, 9.0), 3),
        ]
    )
    text = str(value)
    if chance.random() < 0.05:
        text = text.replace(".", ",")
    if chance.random() < 0.12:
        text += chance.choice(_REMARKS)
    return f"({text})" if chance.random() < 0.05 else text


def note(chance: random.Random) -> str:
    """What a leader tells."""
    return chance.choice(_NOTES).format(
        size=chance.choice([chance.randint(2, 60), round(chance.uniform(2.0, 60.0), 1)]),
        depth=chance.choice([chance.randint(1, 20), round(chance.uniform(0.3, 9.0), 1)]),
        whole=chance.randint(2, 16),
    )


def words(chance: random.Random, count: int) -> str:
    """So many of the words of title blocks and notes."""
    known = _WORDS.split()
    return " ".join(chance.choice(known) for _ in range(count))


def han(chance: random.Random, count: int) -> str:
    """So many Chinese characters."""
    return "".join(chance.choice(_HAN) for _ in range(count))


def caption(chance: random.Random) -> str:
    """What stands under a view."""
    return chance.choice(_CAPTIONS).format(chance.choice("ABCD"))
