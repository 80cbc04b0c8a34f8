"""Versions of what a run is made with."""

OPEN3D_DISTRIBUTIONS = ("open3d-cpu", "open3d")
"""Those that bring Open3D: without CUDA kernels, for Linux on x86-64, and with them, for others."""

ENGINE_PACKAGES = (
    "torch",
    "numpy",
    "opencv-python-headless",
    "numba",
    *OPEN3D_DISTRIBUTIONS,
    "trimesh",
    "cadquery-ocp-novtk",
    "ortools",
    "gsplat",
)


def installed_versions(names: tuple[str, ...]) -> dict[str, str]:
    """Versions of the packages that are installed; the others are left out."""
    # It loads what reads mail.
    from importlib import metadata

    found = {}
    for name in names:
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            continue
    return found
