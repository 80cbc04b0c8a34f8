"""``gaussiancad doctor``: what is installed, what is missing, what to do."""

import argparse
import importlib
import os
import platform
import sys
from importlib import metadata

from gaussiancad_core import __version__
from gaussiancad_core.errors import ExitCode
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.storage.versions import OPEN3D_DISTRIBUTIONS, installed_versions

_NEEDED = {
    "numpy": "numpy",
    "scipy": "scipy",
    "cv2": "opencv-python-headless",
    "PIL": "pillow",
    "skimage": "scikit-image",
    "pypdfium2": "pypdfium2",
    "ezdxf": "ezdxf",
    "svgelements": "svgelements",
    "resvg_py": "resvg-py",
    "defusedxml": "defusedxml",
    "psutil": "psutil",
    "torch": "torch",
    "numba": "numba",
    "trimesh": "trimesh",
    "manifold3d": "manifold3d",
    "ot": "POT",
    "OCP": "cadquery-ocp-novtk",
    "onnxruntime": "onnxruntime",
}
"""Module -> distribution, of all but Open3D, which has two."""

_SYSTEM_LIBRARIES = {
    "libusb-1.0.so.0": "libusb-1.0-0",
    "libGL.so.1": "libgl1",
    "libgomp.so.1": "libgomp1",
    "libX11.so.6": "libx11-6",
    "libEGL.so.1": "libegl1",
}
"""Shared library -> Debian package that has it."""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommands ``doctor`` and ``warm-up``."""
    parser = commands.add_parser("doctor", help="check the engine's installation")
    parser.set_defaults(run=run)
    warm = commands.add_parser("warm-up", help="compile the kernels ahead of the first run")
    warm.set_defaults(run=run_warm_up)


def run(_options: argparse.Namespace, _listener: Listener) -> ExitCode:
    """Import every library the engine needs and say what to do about those that fail."""
    print(f"gaussiancad {__version__}")
    print(f"Python {platform.python_version()} at {sys.executable}")
    print(f"{os.cpu_count()} cores, {platform.platform()}")
    open3d = next(iter(installed_versions(OPEN3D_DISTRIBUTIONS)), "open3d")
    needed = {**_NEEDED, "gaussiancad_core.kernel.bare_open3d": open3d}
    broken = 0
    for module, distribution in needed.items():
        problem = _problem(module, distribution)
        broken += problem is not None
        state = f"BROKEN: {problem}" if problem else metadata.version(distribution)
        print(f"  {distribution:24} {state}", flush=True)
    print(f"  {'labels network':24} {_labels_state()}", flush=True)
    print(f"  {'ocr (optional)':24} {_ocr_state()}", flush=True)
    print(f"  {'gpu (optional)':24} {_gpu_state()}", flush=True)
    if broken:
        print(f"{broken} of {len(needed)} libraries cannot be used; run `make install` again")
        return ExitCode.ENGINE
    print("the engine is complete")
    return ExitCode.DONE


def _labels_state() -> str:
    """Whether pictures are labelled by the trained network."""
    from gaussiancad_core.sheet.labels.labels_network import labels_problem

    problem = labels_problem()
    return "whole" if problem is None else f"not used, pictures are read by rules: {problem}"


def _ocr_state() -> str:
    """Whether dimensions can be read from the pixels of a sheet."""
    try:
        version = metadata.version("rapidocr")
    except metadata.PackageNotFoundError:
        return "not installed: pip install rapidocr"
    return _problem("onnxruntime", "onnxruntime") or version


def _gpu_state() -> str:
    """Whether Gaussians are trained on the GPU; no library is compiled for the answer."""
    try:
        import torch
    except Exception:  # A broken library raises anything while it is imported.
        return "not used: PyTorch is broken"
    if not torch.cuda.is_available():
        return "not used: PyTorch sees no CUDA device"
    try:
        return f"{torch.cuda.get_device_name()} with gsplat {metadata.version('gsplat')}"
    except metadata.PackageNotFoundError:
        return "not used: pip install gsplat (it needs NVIDIA's CUDA toolkit)"


def _problem(module: str, distribution: str) -> str | None:
    try:
        metadata.version(distribution)
        importlib.import_module(module)
    except metadata.PackageNotFoundError:
        return f"not installed: pip install {distribution}"
    except Exception as error:  # A broken library raises anything while it is imported.
        return _advice(str(error))
    return None


def _advice(message: str) -> str:
    for library, package in _SYSTEM_LIBRARIES.items():
        if library in message:
            return f"{library} is missing: apt-get install {package}"
    return message


def run_warm_up(_options: argparse.Namespace, _listener: Listener) -> ExitCode:
    """Compile the kernels into their cache."""
    from gaussiancad_core.cells import sight_lines
    from gaussiancad_core.lines import mesh_crossings, mesh_rays
    from gaussiancad_core.pictures import preview
    from gaussiancad_core.sheet.tracing import shape_growth
    from gaussiancad_core.splatting import tiles

    sight_lines.warm_up()
    shape_growth.warm_up()
    tiles.warm_up()
    mesh_crossings.warm_up()
    mesh_rays.warm_up()
    preview.warm_up()
    return ExitCode.DONE
