"""The child's environment."""

import os
import unittest

from freecad.gaussiancad.engine.environment import clean_environment


class CleanEnvironment(unittest.TestCase):
    def test_what_a_bundle_sets_is_dropped_and_the_rest_stays(self) -> None:
        system = {
            "HOME": "/home/a",
            "PYTHONHOME": "/bundle",
            "PYTHONPATH": "/bundle/lib",
            "LD_LIBRARY_PATH": "/bundle/lib",
            "DYLD_FALLBACK_LIBRARY_PATH": "/bundle",
            "QT_PLUGIN_PATH": "/bundle/qt",
            "CUDA_VISIBLE_DEVICES": "1",
        }
        self.assertEqual(
            clean_environment(system), {"HOME": "/home/a", "CUDA_VISIBLE_DEVICES": "1"}
        )

    def test_the_users_own_value_is_restored(self) -> None:
        system = {"LD_LIBRARY_PATH": "/bundle/lib", "LD_LIBRARY_PATH_ORIG": "/usr/lib/cuda"}
        self.assertEqual(clean_environment(system)["LD_LIBRARY_PATH"], "/usr/lib/cuda")

    def test_an_appimages_own_programs_leave_the_path(self) -> None:
        entries = ["/tmp/.mount_x/usr/bin", "/tmp/.mount_x", "/tmp/.mount_xy/bin", "/usr/bin"]
        system = {"APPDIR": "/tmp/.mount_x/", "PATH": os.pathsep.join(entries)}
        expected = os.pathsep.join(["/tmp/.mount_xy/bin", "/usr/bin"])
        self.assertEqual(clean_environment(system)["PATH"], expected)
