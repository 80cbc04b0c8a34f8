"""PLY files of Gaussians: their layout, and that nothing is lost in them."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from gaussiancad_core.errors import UsageError
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.splatting.ply import SH_CONSTANT, write_gaussians


def gaussians(table: np.ndarray) -> Gaussians:
    """17 numbers a row, spread over the fields; the normals are made unit vectors."""
    normals = table[:, 14:17] + np.float32(0.01)
    return Gaussians(
        means=table[:, 0:3],
        quaternions=table[:, 3:7] + np.array([1.5, 0, 0, 0], np.float32),
        log_scales=table[:, 7:10],
        logit_opacities=table[:, 10],
        colours=np.abs(table[:, 11:14]),
        normals=normals / np.linalg.norm(normals, axis=1, keepdims=True),
    )


def some(count: int = 5) -> Gaussians:
    return gaussians(np.random.default_rng(0).random((count, 17)).astype(np.float32))


def rows_of(path: Path) -> np.ndarray:
    """(n, 17) what a file holds."""
    return np.frombuffer(path.read_bytes().split(b"end_header\n", 1)[1], "<f4").reshape(-1, 17)


@given(
    arrays(
        np.float32,
        st.tuples(st.integers(0, 6), st.just(17)),
        elements=st.floats(0.0, 1.0, width=32),
    )
)
def test_nothing_is_rounded(tmp_path_factory: pytest.TempPathFactory, table: np.ndarray) -> None:
    path = tmp_path_factory.mktemp("ply") / "größe 1.ply"
    written = gaussians(table)
    write_gaussians(written, path)
    rows = rows_of(path)
    assert np.array_equal(rows[:, :3], written.means)
    assert np.array_equal(rows[:, 3:6], written.normals)
    assert rows[:, 6:9] * SH_CONSTANT + 0.5 == pytest.approx(written.colours, abs=1e-6)
    assert np.array_equal(rows[:, 9], written.logit_opacities)
    assert np.array_equal(rows[:, 10:13], written.log_scales)
    assert np.array_equal(rows[:, 13:], written.quaternions)


def test_a_missing_folder_is_told(tmp_path: Path) -> None:
    with pytest.raises(UsageError):
        write_gaussians(some(), tmp_path / "none" / "g.ply")
