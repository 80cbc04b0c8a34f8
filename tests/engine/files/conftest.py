"""Files written by the tests themselves, byte by byte, so that their truth is known."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.files.vectors import VectorStroke

KAPPA = 0.5522847498307936
"""Handle length of the usual Bézier quarter circle."""


@dataclass(frozen=True)
class Pdf:
    """A PDF file of one page, before it is written.

    Attributes:
        content: of the page.
        box: MediaBox.
        page: more entries of the page's dictionary.
        objects: bodies of objects, the first of which is number 5.
        kids: how often the page is listed.
    """

    content: bytes
    box: str = "0 0 595.28 841.89"
    page: bytes = b""
    objects: tuple[bytes, ...] = ()
    kids: int = 1

    def to_bytes(self) -> bytes:
        """The file."""
        kids = b" ".join([b"3 0 R"] * self.kids)
        bodies = [
            b"<< /Type /Catalog /Pages 2 0 R >>",
            b"<< /Type /Pages /Kids [%s] /Count %d >>" % (kids, self.kids),
            b"<< /Type /Page /Parent 2 0 R /MediaBox [%s] /Contents 4 0 R %s >>"
            % (self.box.encode(), self.page),
            stream(self.content),
            *self.objects,
        ]
        data = b"%PDF-1.7\n"
        offsets = []
        for number, body in enumerate(bodies, start=1):
            offsets.append(len(data))
            data += b"%d 0 obj\n%s\nendobj\n" % (number, body)
        table = b"".join(b"%010d 00000 n \n" % offset for offset in offsets)
        return (
            data
            + b"xref\n0 %d\n0000000000 65535 f \n%s" % (len(bodies) + 1, table)
            + b"trailer << /Size %d /Root 1 0 R >>\n" % (len(bodies) + 1)
            + b"startxref\n%d\n%%%%EOF" % len(data)
        )


def stream(content: bytes, entries: bytes = b"") -> bytes:
    """The body of a stream object."""
    return b"<< %s /Length %d >>\nstream\n%s\nendstream" % (entries, len(content), content)


def circle(x: float, y: float, radius: float) -> bytes:
    """Path operators for a circle of four Bézier curves, stroked."""
    h = KAPPA * radius
    corners = [
        (x + radius, y + h, x + h, y + radius, x, y + radius),
        (x - h, y + radius, x - radius, y + h, x - radius, y),
        (x - radius, y - h, x - h, y - radius, x, y - radius),
        (x + h, y - radius, x + radius, y - h, x + radius, y),
    ]
    curves = "".join("{:.6f} {:.6f} {:.6f} {:.6f} {:.6f} {:.6f} c\n".format(*c) for c in corners)
    return f"{x + radius:.6f} {y:.6f} m\n{curves} s\n".encode()


@pytest.fixture
def pdf() -> type[Pdf]:
    """The class of PDF files to write."""
    return Pdf


@pytest.fixture
def pdf_circle() -> Callable[[float, float, float], bytes]:
    """Path operators for a circle."""
    return circle


@pytest.fixture
def pdf_stream() -> Callable[..., bytes]:
    """The body of a stream object."""
    return stream


@pytest.fixture
def save(tmp_path: Path) -> Callable[[str, bytes | str], Path]:
    """Writes a file into the test's folder."""

    def write(name: str, data: bytes | str) -> Path:
        path = tmp_path / name
        path.write_bytes(data if isinstance(data, bytes) else data.encode())
        return path

    return write


@pytest.fixture
def ink_offsets() -> Callable[[npt.NDArray[np.uint8], VectorStroke], npt.NDArray[np.float64]]:
    """Where the ink of a stroke lies beside the stroke."""
    return _ink_offsets


def _ink_offsets(grey: npt.NDArray[np.uint8], stroke: VectorStroke) -> npt.NDArray[np.float64]:
    """(n,) px from points of a stroke to the centre of the ink across it, where there is ink."""
    points = stroke.curve.sample(3.0)[2:-2]
    way = np.gradient(points, axis=0)
    way /= np.hypot(*way.T)[:, None]
    across = np.stack([-way[:, 1], way[:, 0]], axis=1)
    steps = np.linspace(-5.0, 5.0, 101)
    places = points[:, None] + steps[None, :, None] * across[:, None]
    dark = 255.0 - _bilinear(grey, places.reshape(-1, 2)).reshape(len(points), len(steps))
    inked = dark.max(axis=1) > 100.0
    return (dark[inked] @ steps) / dark[inked].sum(axis=1)


def _bilinear(
    grey: npt.NDArray[np.uint8], points: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """Grey levels at (n, 2) points, pixel centres at .5."""
    x, y = (points - 0.5).T
    columns = np.clip(np.floor(x).astype(int), 0, grey.shape[1] - 2)
    rows = np.clip(np.floor(y).astype(int), 0, grey.shape[0] - 2)
    u, v = x - columns, y - rows
    values = grey.astype(np.float64)
    upper = values[rows, columns] * (1 - u) + values[rows, columns + 1] * u
    lower = values[rows + 1, columns] * (1 - u) + values[rows + 1, columns + 1] * u
    return upper * (1 - v) + lower * v
