"""Which modules of the workbench go into the wheel: those of the window, which need Qt alone.

All else that setuptools needs to know is in ``pyproject.toml``.
"""

from setuptools import setup
from setuptools.command.build_py import build_py

WINDOW = {
    "freecad.gaussiancad": {"__init__", "errors", "language", "qt"},
    "freecad.gaussiancad.engine": {
        "__init__",
        "protocol",
        "report",
        "summary",
        "verdict",
        "wording",
    },
}
"""Package of the workbench -> its modules that the window imports; of the others, all."""


class WindowModules(build_py):
    """Leaves out what only FreeCAD runs."""

    def find_package_modules(self, package: str, package_dir: str) -> list[tuple[str, str, str]]:
        """The modules of a package: package, name, file."""
        found = super().find_package_modules(package, package_dir)
        return [module for module in found if module[1] in WINDOW.get(package, {module[1]})]


setup(cmdclass={"build_py": WindowModules})
