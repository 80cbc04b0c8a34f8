"""Which back end draws on this machine."""

from importlib import metadata

from gaussiancad_core.errors import EngineError
from gaussiancad_core.splatting.rasterizer import Backend
from gaussiancad_core.storage.extras import Extra
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import Device


def backend_for(device: Device) -> Backend:
    """The back end of a device; ``auto`` takes the GPU where it can be used.

    Raises:
        EngineError: ``cuda-unavailable``, the GPU was asked for and cannot be used.
    """
    if device is Device.CPU:
        return Backend.TILES
    problem = cuda_problem()
    if problem is None:
        return Backend.GSPLAT
    if device is Device.CUDA:
        raise EngineError(
            Code.CUDA_UNAVAILABLE, "{reason}, or use --device auto or cpu", reason=problem
        )
    return Backend.TILES


def cuda_problem() -> str | None:
    """Why no GPU can be used and what to do, or nothing if one can.

    Where gsplat was installed without compiled kernels it compiles them here, once, in minutes.
    """
    import torch

    if not torch.cuda.is_available():
        return "PyTorch sees no CUDA device: install its CUDA build and NVIDIA's driver"
    try:
        metadata.version("gsplat")
    except metadata.PackageNotFoundError:
        return f"gsplat is not installed: {Extra.CUDA.command}"
    try:
        from gsplat.cuda import _backend
    except Exception as error:  # Compilers fail in any way.
        return f"gsplat cannot compile its kernels ({str(error).splitlines()[0]}): see its manual"
    if _backend._C is None:
        return "gsplat has no kernels and found no nvcc: install NVIDIA's CUDA toolkit"
    return None
