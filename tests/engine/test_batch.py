from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.axes import Axis, Projection, Role
from gaussiancad_core.batch import job_arguments, unique_names
from gaussiancad_core.cli.parser import build_parser
from gaussiancad_core.cli.reconstruct import job_of
from gaussiancad_core.job import Job
from gaussiancad_core.modes import Preset, Recipe, ResultKind
from gaussiancad_core.sheet.options import Finder, ReadingOptions


@given(st.lists(st.text("abAB", min_size=1, max_size=2), max_size=12))
def test_every_sheet_has_a_folder_of_its_own(stems: list[str]) -> None:
    names = unique_names([Path(f"{i}/{stem}.png") for i, stem in enumerate(stems)])
    assert len({name.casefold() for name in names}) == len(stems)
    assert all(name.startswith(stem) for name, stem in zip(names, stems, strict=True))


def test_options_give_the_same_job_again() -> None:
    reading = ReadingOptions(
        projection=Projection.FIRST,
        views=((Role.FRONT, (1.5, 2.0, 30.0, 40.0)), (Role.LEFT, (50.0, 2.0, 80.0, 40.0))),
        length=(Axis.Y, 42.5),
        colour=(1, 200, 30),
        median_kernel=5,
        finder=Finder.HOUGH,
    )
    job = Job(
        Path("sheet.png"),
        Path("out"),
        reading,
        page=2,
        result=ResultKind.SURFACE,
        recipe=Recipe.PAPER,
        preset=Preset.DRAFT,
        seed=7,
        resume=True,
        scale_down=3,
        transforms=True,
    )
    command = ["reconstruct", "sheet.png", "--output", "out", *job_arguments(job)]
    options = build_parser().parse_args(command)
    assert job_of(options, options.sheet, options.output) == job
