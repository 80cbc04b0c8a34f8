"""What lines of sight of a view cross of all features that may be tried, as one table.

Prisms of one area share their rows: only the places along its axis differ.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.proposing.feature_kernels import MOST, Offers, Table, Tables
from gaussiancad_core.proposing.part_features import Feature, Prism, Sights, loop_table


def tables_of(pool: Sequence[Feature], sights: Sights) -> tuple[Tables, Offers]:
    """The tables of features, each area's once, and what each feature has of them.

    Args:
        pool: the features.
        sights: lines of sight of a view.
    """
    known: dict[int, int] = {}
    tables: list[Table] = []
    rows = []
    for feature in pool:
        key, ends = id(feature), (-1.0, 1.0, 0, 0)
        if isinstance(feature, Prism):
            key, ends = id(feature.loop), (feature.low, feature.high, *feature.ends)
        if key not in known:
            known[key] = len(tables)
            tables.append(_table(feature, sights))
        rows.append((known[key], *ends))
    number, low, high, first, last = (np.array(column) for column in zip(*rows, strict=True))
    offers = Offers(number, low, high, first.astype(np.int64), last.astype(np.int64))
    return _joined(tables), offers


def _table(feature: Feature, sights: Sights) -> Table:
    """What a feature has in common with others: all but the places of a prism."""
    if isinstance(feature, Prism):
        return loop_table(feature.loop, sights)
    return feature.table(sights)


def _joined(tables: Sequence[Table]) -> Tables:
    counts = [table.counts for table in tables]
    begins = np.concatenate([[0], np.cumsum([len(table.rows) for table in tables])])
    offsets = np.concatenate([[0], np.cumsum([len(each) for each in counts])])
    # What is seen along its axis is one row, that of its places.
    where = [
        table.where if table.is_along else table.where + offset
        for table, offset in zip(tables, offsets[:-1], strict=True)
    ]
    depth, surface = (
        [_wide(each) for each in column]
        for column in zip(*((table.depth, table.surface) for table in tables), strict=True)
    )
    return Tables(
        begins.astype(np.int64),
        np.concatenate([table.rows for table in tables]),
        np.concatenate(where),
        np.concatenate([table.at for table in tables]),
        np.concatenate(counts),
        np.concatenate(depth),
        np.concatenate(surface),
        np.array([table.is_along for table in tables]),
    )


def _wide(values: np.ndarray) -> np.ndarray:
    """(k, m) values with as many columns as a line of sight has crossings at most."""
    return np.pad(values, ((0, 0), (0, MOST - values.shape[1])))
