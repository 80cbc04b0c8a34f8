"""How much of the ink of pictures is taken for what it is: edges, hidden lines, annotation?

Each picture is read as a sheet is: at working scale, labelled, taken apart; then each pixel of its
ridges is compared with what it is known to be.

A folder has NAME.img.png beside NAME.lab.png, which has for each pixel of ink 1 (visible edge), 2
(hidden edge), 3 to 10 or 200 (annotation), 255 (not known).
"""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt

from benchmarks.run.arguments import tell
from benchmarks.run.outcome import Figure
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.working_scale import resampled, working_factor
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.labelled_ink import separate_by_labels
from gaussiancad_core.sheet.labels.labels_network import ink_labels
from gaussiancad_core.sheet.tracing.ridges import ridge_points

VISIBLE, HIDDEN, ANNOTATION = range(3)
NAMES = ("visible", "hidden", "annotation")
_UNKNOWN = 255

Confusion = npt.NDArray[np.int64]
"""(3, 3) px of ridges, by what they are and by what they were taken for."""


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture with the truth.

    Attributes:
        name: SOURCE+NAME.
        grey: (h, w) uint8.
        truth: (h, w) uint8.
    """

    name: str
    grey: np.ndarray
    truth: np.ndarray

    @property
    def source(self) -> str:
        """Whose it is."""
        return self.name.split("+")[0]


def labelled_figures(folder: Path) -> tuple[Figure, ...]:
    """The figures of all pictures of a folder; those of each source are printed."""
    sums: dict[str, Confusion] = defaultdict(lambda: np.zeros((3, 3), np.int64))
    for picture in pictures_of(folder):
        confusion = labelled(picture)
        for source in (picture.source, "all"):
            sums[source] += confusion
        tell(f"{picture.name} {_in_words(confusion)}")
    for source, confusion in sorted(sums.items()):
        print(f"{source:20} {_in_words(confusion)}")
    return figures_of(sums["all"])


def pictures_of(folder: Path) -> Iterator[Picture]:
    """The pictures of a folder."""
    for path in sorted(folder.glob("*.img.png")):
        name = path.name.removesuffix(".img.png")
        truth = cv2.imread(str(path.with_name(f"{name}.lab.png")), cv2.IMREAD_GRAYSCALE)
        yield Picture(name, cv2.imread(str(path), cv2.IMREAD_GRAYSCALE), truth)


def labelled(picture: Picture) -> Confusion:
    """(3, 3) px of ridges, by what they are and by what they were taken for."""
    grey = _sized(picture.grey, working_factor(picture.grey))
    sheet = clean_sheet(grey)
    labels = ink_labels(grey)
    part = separate_by_labels(sheet, labels).part
    size = (grey.shape[1], grey.shape[0])
    truth = cv2.resize(picture.truth, size, interpolation=cv2.INTER_NEAREST)
    columns, rows = np.rint(ridge_points(sheet.weight, sheet.stroke_width).points).astype(int).T
    true = truth[rows, columns]
    known = (true > 0) & (true != _UNKNOWN) & sheet.ink[rows, columns]
    best = labels.best()[rows, columns]
    taken = np.where(best == InkClass.HIDDEN, HIDDEN, VISIBLE)
    taken = np.where(part.ink[rows, columns], taken, ANNOTATION)
    kind = np.where(true == 1, VISIBLE, np.where(true == 2, HIDDEN, ANNOTATION))
    return np.bincount(3 * kind[known] + taken[known], minlength=9).reshape(3, 3)


def _sized(grey: np.ndarray, factor: float) -> np.ndarray:
    if factor == 1.0:
        return grey
    height, width = grey.shape
    return resampled(grey, (round(width * factor), round(height * factor)))


def _in_words(confusion: Confusion) -> str:
    return "  ".join(map(str, figures_of(confusion)))


def figures_of(confusion: Confusion) -> tuple[Figure, ...]:
    """Precision and recall of lines, edges lost, annotation kept.

    Args:
        confusion: (3, 3) px by what they are and by what they were taken for.
    """
    figures = []
    for kind in (VISIBLE, HIDDEN):
        right = confusion[kind, kind]
        taken, true = confusion[:, kind].sum(), confusion[kind].sum()
        figures.append(Figure(f"{NAMES[kind]} precision", round(right / max(taken, 1), 3)))
        figures.append(Figure(f"{NAMES[kind]} recall", round(right / max(true, 1), 3)))
    # An edge is not lost where its linetype is the wrong one.
    lost = confusion[:ANNOTATION, ANNOTATION].sum() / max(confusion[:ANNOTATION].sum(), 1)
    added = confusion[ANNOTATION, :ANNOTATION].sum() / max(confusion[ANNOTATION].sum(), 1)
    ends = Figure("edges lost", round(lost, 3)), Figure("annotation kept", round(added, 3))
    return (*figures, *ends)
