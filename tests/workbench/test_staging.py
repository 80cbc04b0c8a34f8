"""Folders in which files become whole."""

import os

from support import FolderCase

from freecad.gaussiancad.staging import put_in_place, staging, sweep


class Staging(FolderCase):
    def test_what_a_killed_process_left_is_swept_and_what_lives_is_not(self) -> None:
        child = os.fork()
        if child == 0:
            held = staging(self.folder)
            held.__enter__()
            os._exit(0)
        os.waitpid(child, 0)
        (left,) = self.folder.iterdir()
        outside = self.folder / "outside"
        outside.mkdir()
        link = self.folder / ".gaussiancad-link"
        link.symlink_to(outside)
        item = self.folder / ".gaussiancad-own"
        item.mkdir()
        with staging(self.folder) as alive:
            sweep(self.folder)
            self.assertFalse(left.exists())
            self.assertEqual(set(self.folder.iterdir()), {outside, link, item, alive})
        self.assertFalse(alive.exists())

    def test_a_link_is_replaced_and_not_followed(self) -> None:
        mine = self.folder / "mine"
        mine.write_text("mine")
        target = self.folder / "target"
        target.symlink_to(mine)
        with staging(self.folder) as scratch:
            (scratch / "new").write_text("new")
            put_in_place(scratch / "new", target)
        self.assertEqual((mine.read_text(), target.read_text()), ("mine", "new"))
        self.assertFalse(target.is_symlink())
