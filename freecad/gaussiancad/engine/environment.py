"""The child's environment: the user's own, without what FreeCAD's bundle put into it.

AppImages, snaps and bundles point Python, Qt and the dynamic linker at their own libraries.  An
engine that inherits those loads the wrong ones.
"""

import os
from collections.abc import Mapping

_DROPPED = frozenset(
    {
        "PYTHONHOME",
        "PYTHONPATH",
        "PYTHONSTARTUP",
        "PYTHONEXECUTABLE",
        "VIRTUAL_ENV",
        "PIP_USER",
        "LD_LIBRARY_PATH",
        "LD_PRELOAD",
        "QT_PLUGIN_PATH",
        "QT_QPA_PLATFORM_PLUGIN_PATH",
    }
)
_DROPPED_PREFIX = "DYLD_"
_SAVED_SUFFIX = "_ORIG"


def clean_environment(system: Mapping[str, str]) -> dict[str, str]:
    """The variables that the engine gets.

    What a bundle saved under a variable's name with ``_ORIG`` behind it, the user's own value, is
    restored.  Entries of ``PATH`` below ``APPDIR`` (a mounted AppImage) are left out.

    Args:
        system: the variables of this process.
    """
    clean = {name: value for name, value in system.items() if not _is_bundled(name)}
    for name in system:
        saved = system.get(name + _SAVED_SUFFIX)
        if _is_bundled(name) and saved:
            clean[name] = saved
    bundle = system.get("APPDIR")
    if bundle and "PATH" in clean:
        entries = clean["PATH"].split(os.pathsep)
        clean["PATH"] = os.pathsep.join(e for e in entries if not _is_below(e, bundle))
    return clean


def _is_bundled(name: str) -> bool:
    return name in _DROPPED or name.startswith(_DROPPED_PREFIX)


def _is_below(path: str, folder: str) -> bool:
    folder = folder.rstrip("/")
    return path == folder or path.startswith(folder + "/")
