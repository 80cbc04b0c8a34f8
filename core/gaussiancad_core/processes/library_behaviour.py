"""How the libraries behave in the command's process."""

import os

_ENVIRONMENT = {
    # Threads that spin while they wait take the cores from the other library's threads.
    "OMP_WAIT_POLICY": "passive",
    # OpenBLAS's spin whatever that says; its problems here are small ones.
    "OPENBLAS_NUM_THREADS": "1",
    # Numba would look for TBB first and warn about versions that it cannot use.
    "NUMBA_THREADING_LAYER_PRIORITY": "omp tbb workqueue",
}


def prepare_environment() -> None:
    """Set what the numerical libraries read when they are loaded; the user's own values stay."""
    for name, value in _ENVIRONMENT.items():
        os.environ.setdefault(name, value)


def silence_opencascade() -> None:
    """Keep OpenCASCADE from printing statistics of every file that it reads or writes."""
    from OCP.Message import Message

    Message.DefaultMessenger_s().ChangePrinters().Clear()
