"""PLY files of Gaussians: layout, round trip, foreign and damaged files."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from gaussiancad_core.errors import UnreadableError, UsageError
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.splatting.ply import SH_CONSTANT, read_gaussians, write_gaussians

FIELDS = [
    *("x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2", "opacity"),
    *("scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"),
]


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


@given(
    arrays(
        np.float32,
        st.tuples(st.integers(0, 6), st.just(17)),
        elements=st.floats(0.0, 1.0, width=32),
    )
)
def test_what_is_written_is_read(
    tmp_path_factory: pytest.TempPathFactory, table: np.ndarray
) -> None:
    path = tmp_path_factory.mktemp("ply") / "größe 1.ply"
    written = gaussians(table)
    write_gaussians(written, path)
    read = read_gaussians(path)
    for name in ("means", "quaternions", "log_scales", "logit_opacities", "normals"):
        assert np.array_equal(getattr(read, name), getattr(written, name)), name
    assert read.colours == pytest.approx(written.colours, abs=1e-6)


def test_layout_is_what_viewers_expect(tmp_path: Path) -> None:
    path = tmp_path / "g.ply"
    written = some(3)
    write_gaussians(written, path)
    header, body = path.read_bytes().split(b"end_header\n", 1)
    lines = header.decode().splitlines()
    assert lines[:3] == ["ply", "format binary_little_endian 1.0", "element vertex 3"]
    assert lines[3:] == [f"property float {name}" for name in FIELDS]
    rows = np.frombuffer(body, "<f4").reshape(3, 17)
    assert np.array_equal(rows[:, :3], written.means)
    assert rows[:, 6:9] == pytest.approx((written.colours - 0.5) / SH_CONSTANT, abs=1e-6)
    assert np.array_equal(rows[:, 9], written.logit_opacities)
    assert np.array_equal(rows[:, 13:], written.quaternions)


def test_more_properties_and_no_normals_are_read_too(tmp_path: Path) -> None:
    path = tmp_path / "other.ply"
    names = [name for name in FIELDS if not name.startswith("n")]
    kinds = [(name, "<f4") for name in names] + [("f_rest_0", "<f8"), ("flag", "u1")]
    table = np.zeros(2, dtype=kinds)
    table["x"] = [-1.0, 1.0]
    table["rot_0"] = 1.0
    table["scale_0"] = -3.0
    lines = ["ply", "format binary_little_endian 1.0", "comment made elsewhere", "element vertex 2"]
    lines += [f"property float {name}" for name in names]
    lines += ["property double f_rest_0", "property uchar flag", "end_header", ""]
    path.write_bytes("\n".join(lines).encode() + table.tobytes())
    read = read_gaussians(path)
    assert read.colours.tolist() == [[0.5, 0.5, 0.5]] * 2
    assert read.normals.tolist() == [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]


@pytest.mark.parametrize(
    ("cut", "replace"),
    [
        (slice(0, -1), None),
        (slice(0, 40), None),
        (slice(0, 0), None),
        (slice(None), (b"binary_little_endian", b"ascii")),
        (slice(None), (b"property float opacity", b"property float opaqueness")),
        (slice(None), (b"property float x\n", b"property list uchar int x\n")),
        (slice(None), (b"element vertex 5", b"element vertex -5")),
        (slice(None), (b"element vertex 5", b"element face 5")),
    ],
)
def test_damaged_and_foreign_files_are_refused(
    tmp_path: Path, cut: slice, replace: tuple[bytes, bytes] | None
) -> None:
    path = tmp_path / "bad.ply"
    write_gaussians(some(), path)
    content = path.read_bytes()[cut]
    path.write_bytes(content.replace(*replace) if replace else content)
    with pytest.raises(UnreadableError) as caught:
        read_gaussians(path)
    assert caught.value.code == "gaussians-unreadable"


def test_missing_files_and_folders_are_told(tmp_path: Path) -> None:
    with pytest.raises(UnreadableError):
        read_gaussians(tmp_path / "none.ply")
    with pytest.raises(UsageError):
        write_gaussians(some(), tmp_path / "none" / "g.ply")
