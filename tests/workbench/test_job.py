"""From settings to the engine's arguments."""

import unittest

from freecad.gaussiancad.engine.job import CompareJob, Projection, ReconstructJob, Scale, ScaleKind
from freecad.gaussiancad.engine.protocol import Preset, Recipe, ResultKind

JOB = ReconstructJob(
    "a b.png",
    "out",
    Projection.FIRST,
    Preset.FINE,
    ResultKind.SOLID,
    Recipe.PAPER,
    Scale(ScaleKind.LENGTH_Y, 12.5),
    "#102030",
    page=2,
    seed=7,
    scale_down=4,
)


class Arguments(unittest.TestCase):
    def test_all_settings_become_options(self) -> None:
        self.assertEqual(
            " ".join(JOB.arguments()),
            "reconstruct --output out --projection first --preset fine --result solid "
            "--recipe paper --colour #102030 --page 2 --seed 7 "
            "--scale-down 4 --length y=12.5 --events -- a b.png",
        )

    def test_what_the_engine_is_installed_for_needs_no_word(self) -> None:
        named = {
            outcome: ReconstructJob("a", "b", outcome=outcome).options().count("--result")
            for outcome in ResultKind
        }
        self.assertEqual(named, {ResultKind.BOTH: 0, ResultKind.SOLID: 1, ResultKind.SURFACE: 1})

    def test_scales(self) -> None:
        self.assertEqual(Scale().arguments(), [])
        self.assertEqual(Scale(ScaleKind.MM_PER_PIXEL, 0.1).arguments(), ["--mm-per-pixel", "0.1"])
        self.assertEqual(Scale(ScaleKind.LENGTH_X, 1 / 3).arguments()[1], "x=0.3333333333")

    def test_a_thickness_is_a_length_beside_the_scale(self) -> None:
        thick = Scale(ScaleKind.LENGTH_Y, 5.0)
        for scale, stated in (
            (Scale(), "--length y=5"),
            (Scale(ScaleKind.LENGTH_Y, 8.0), "--length y=5"),
            (Scale(ScaleKind.LENGTH_X, 80.0), "--length x=80 --length y=5"),
            (Scale(ScaleKind.MM_PER_PIXEL, 0.1), "--mm-per-pixel 0.1 --length y=5"),
        ):
            job = ReconstructJob("a", "b", scale=scale, thickness=thick)
            self.assertTrue(" ".join(job.options()).endswith(f"--scale-down 1 {stated}"))
            again = ReconstructJob.kept("a", "b", job.settings())
            self.assertEqual(again.options(), job.options())
        self.assertNotIn("thickness", ReconstructJob("a", "b").settings())

    def test_a_job_comes_back_from_the_texts_of_a_document(self) -> None:
        self.assertEqual(ReconstructJob.kept("a b.png", "out", JOB.settings()), JOB)
        damaged = ReconstructJob.kept("a.png", "", {"page": "two", "preset": "cake"})
        self.assertEqual(damaged, ReconstructJob("a.png", ""))

    def test_settings_are_texts_for_every_option(self) -> None:
        settings = ReconstructJob("a", "b", scale=Scale(ScaleKind.LENGTH_Z, 3.0)).settings()
        self.assertEqual(settings["scale"], "z = 3")
        self.assertEqual(settings["projection"], "auto")
        self.assertTrue(all(isinstance(value, str) for value in settings.values()))

    def test_a_comparison_asks_for_no_events(self) -> None:
        job = CompareJob("r.step", "t.stl", "out", points=500, seed=1)
        self.assertEqual(
            job.arguments(),
            [
                *("compare", "r.step", "t.stl", "--output", "out", "--protocol", "all"),
                *("--points", "500", "--seed", "1"),
            ],
        )


class Told(unittest.TestCase):
    def test_the_job_that_a_report_tells_of(self) -> None:
        settings = {
            "projection": "first",
            "views": {},
            "lengths": {"y": 12.5},
            "mm_per_pixel": None,
            "colour": "#102030",
            "median_kernel": 3,
            "page": 2,
            "result": "solid",
            "recipe": "paper",
            "preset": "fine",
            "seed": 7,
            "scale_down": 4,
        }
        self.assertEqual(ReconstructJob.from_report("a b.png", "out", settings), JOB)
        pixels = {**settings, "lengths": {}, "mm_per_pixel": 0.25}
        scale = ReconstructJob.from_report("a.png", "out", pixels).scale
        self.assertEqual(scale, Scale(ScaleKind.MM_PER_PIXEL, 0.25))
        self.assertEqual(ReconstructJob.from_report("a", "b", {}), ReconstructJob("a", "b"))
        with self.assertRaises(ValueError):
            ReconstructJob.from_report("a", "b", {"preset": "huge"})
