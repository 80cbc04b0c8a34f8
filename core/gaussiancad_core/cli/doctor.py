"""``gaussiancad doctor``: what is installed, what is missing, what to do."""

import argparse
import importlib
import os
import platform
import sys
from importlib import metadata

from gaussiancad_core import __version__
from gaussiancad_core.errors import EngineError
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.storage.extras import MODULES, Extra, lacking
from gaussiancad_core.storage.versions import installed_versions
from gaussiancad_protocol.exit_codes import ExitCode

_NEEDED = {
    "numpy": "numpy",
    "scipy": "scipy",
    "cv2": "opencv-python-headless",
    "PIL": "pillow",
    "pypdfium2": "pypdfium2",
    "ezdxf": "ezdxf",
    "svgelements": "svgelements",
    "resvg_py": "resvg-py",
    "defusedxml": "defusedxml",
    "psutil": "psutil",
    "filelock": "filelock",
    "shapely": "shapely",
    "msgspec": "msgspec",
    "numba": "numba",
    "OCP": "cadquery-ocp-novtk",
    "ortools.sat.python.cp_model": "ortools",
    "onnxruntime": "onnxruntime",
}
"""Module -> distribution, of all that reading a sheet and making its solid take."""

_IMPORTED = {
    "open3d": "gaussiancad_core.kernel.bare_open3d",
}
"""Module of an extra -> the one by which the engine imports it, where that is another."""

_LOOKED_AT = (Extra.SURFACE, Extra.COMPARE, Extra.WINDOW, Extra.CLUSTER, Extra.MCP)
"""Extras that are told of; a line of its own tells of the GPU."""

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
    broken = 0
    for module, distribution in _NEEDED.items():
        problem = _problem(module, distribution)
        broken += problem is not None
        state = f"BROKEN: {problem}" if problem else metadata.version(distribution)
        print(f"  {distribution:24} {state}", flush=True)
    print(f"  {'labels network':24} {_labels_state()}", flush=True)
    state, works = _texts_state()
    broken += not works
    print(f"  {'text network':24} {state}", flush=True)
    for extra in _LOOKED_AT:
        state, works = _extra_state(extra)
        broken += not works
        print(f"  {f'extra {extra.value}':24} {state}", flush=True)
    print(f"  {'extra cuda':24} {_gpu_state()}", flush=True)
    if broken:
        print(f"{broken} of these cannot be used; install them again")
        return ExitCode.ENGINE
    missing = [extra.value for extra in _LOOKED_AT if lacking(extra)]
    print("the engine is complete" + (f", without {', '.join(missing)}" if missing else ""))
    return ExitCode.DONE


def _extra_state(extra: Extra) -> tuple[str, bool]:
    """What of an extra is there, and whether all of that can be used."""
    missing = lacking(extra)
    there = [module for module in MODULES[extra] if module not in missing]
    for module in there:
        if (problem := _importing(_IMPORTED.get(module, module))) is not None:
            return f"BROKEN: {problem}", False
    if not there:
        return f"not installed: {extra.command}", True
    if missing:
        return f"lacks {', '.join(missing)}: {extra.command}", True
    versions = [_version(MODULES[extra][module]) for module in there]
    return ", ".join(dict.fromkeys(versions)), True


def _version(distributions: tuple[str, ...]) -> str:
    """Name and version of the first of some distributions that is installed."""
    found = installed_versions(distributions).items()
    return next((f"{name} {version}" for name, version in found), distributions[0])


def _labels_state() -> str:
    """Whether pictures are labelled by the trained network."""
    from gaussiancad_core.sheet.labels.labels_network import labels_problem

    problem = labels_problem()
    return "whole" if problem is None else f"not used, pictures are read by rules: {problem}"


def _texts_state() -> tuple[str, bool]:
    """Whether the network that reads texts from pixels is whole, and so can be used."""
    from gaussiancad_core.writing.ocr import network_weights

    try:
        network_weights()
    except EngineError:
        return "BROKEN: its file is missing or damaged", False
    return "whole", True


def _gpu_state() -> str:
    """Whether Gaussians are trained on the GPU; no library is compiled for the answer."""
    if "torch" in lacking(Extra.CUDA):
        return f"not installed: {Extra.CUDA.command}"
    try:
        import torch
    except Exception:  # A broken library raises anything while it is imported.
        return "not used: PyTorch is broken"
    if not torch.cuda.is_available():
        return "not used: PyTorch sees no CUDA device"
    try:
        return f"{torch.cuda.get_device_name()} with gsplat {metadata.version('gsplat')}"
    except metadata.PackageNotFoundError:
        return f"not used: {Extra.CUDA.command} (it needs NVIDIA's CUDA toolkit)"


def _problem(module: str, distribution: str) -> str | None:
    try:
        metadata.version(distribution)
    except metadata.PackageNotFoundError:
        return f"not installed: pip install {distribution}"
    return _importing(module)


def _importing(module: str) -> str | None:
    """What goes wrong while a module is imported."""
    try:
        importlib.import_module(module)
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
    from gaussiancad_core.proposing import kernel_warm_up
    from gaussiancad_core.sheet.tracing import shape_growth

    sight_lines.warm_up()
    shape_growth.warm_up()
    mesh_crossings.warm_up()
    mesh_rays.warm_up()
    preview.warm_up()
    kernel_warm_up.warm_up()
    if not lacking(Extra.SURFACE):
        from gaussiancad_core.splatting import tiles

        tiles.warm_up()
    return ExitCode.DONE
