"""Which engine is used."""

from pathlib import Path

from support import FolderCase

from freecad.gaussiancad.engine.locate import MARKER, EngineSource, SearchPlaces, find_engine
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.paths import ADDON_ROOT


class Order(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.managed = self.folder / "managed"
        self.checkout = self.folder / ".venv"
        self.preferred = self.program(self.folder / "own python")

    def program(self, path: Path) -> Path:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("#!/bin/sh\n")
        path.chmod(0o755)
        return path

    def places(self, variable: str = "", preference: str = "") -> SearchPlaces:
        return SearchPlaces(variable, preference, self.managed, self.checkout)

    def test_each_place_hides_those_after_it(self) -> None:
        neighbour = self.program(self.checkout / "bin" / "python")
        self.assertEqual(find_engine(self.places()).python, str(neighbour))
        managed = self.program(self.managed / "bin" / "python3")
        self.assertEqual(find_engine(self.places()).python, str(neighbour))
        (self.managed / MARKER).write_text("{}")
        engine = find_engine(self.places())
        self.assertEqual((engine.python, engine.source), (str(managed), EngineSource.MANAGED))
        engine = find_engine(self.places(preference=str(self.preferred)))
        self.assertEqual(
            (engine.python, engine.source), (str(self.preferred), EngineSource.PREFERENCE)
        )
        other = self.program(self.folder / "other")
        engine = find_engine(self.places(variable=str(other), preference=str(self.preferred)))
        self.assertEqual((engine.python, engine.source), (str(other), EngineSource.VARIABLE))

    def test_a_named_engine_that_is_not_there_is_an_error_though_others_are(self) -> None:
        self.program(self.checkout / "bin" / "python")
        not_executable = self.folder / "text"
        not_executable.write_text("x")
        for wrong in (self.folder / "nothing", not_executable, self.folder):
            for places in (self.places(variable=str(wrong)), self.places(preference=str(wrong))):
                with self.assertRaises(WorkbenchError) as caught:
                    find_engine(places)
                self.assertIs(caught.exception.code, ErrorCode.ENGINE_NOT_FOUND)
                self.assertIn(str(wrong), caught.exception.message)

    def test_no_engine_at_all_says_what_to_do(self) -> None:
        with self.assertRaises(WorkbenchError) as caught:
            find_engine(self.places())
        self.assertIs(caught.exception.code, ErrorCode.ENGINE_NOT_FOUND)
        self.assertIn("Preferences", caught.exception.message)

    def test_this_machines_places(self) -> None:
        places = SearchPlaces.of_this_machine(" /a ", {"GAUSSIANCAD_PYTHON": "/b"})
        self.assertEqual((places.variable, places.preference), ("/b", "/a"))
        self.assertEqual(places.checkout, ADDON_ROOT / ".venv")
        self.assertEqual(places.managed.name, "engine")
