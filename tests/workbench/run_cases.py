"""A document, and runs of the fake engine whose results go into it."""

import tempfile
from pathlib import Path

import FreeCAD
from support import FolderCase, run_fake

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.objects.loading import LoadedRun, load_run


class RunCase(FolderCase):
    """A test with a document; all documents are closed at its end."""

    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Test")
        self.addCleanup(self.close_all)

    def close_all(self) -> None:
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    def loaded(self, job: ReconstructJob) -> LoadedRun:
        """The result of a job."""
        run_fake(job.arguments())
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        return load_run(job, Path(scratch.name))
