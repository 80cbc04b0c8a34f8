"""A process that limits itself, and then is ``gaussiancad``.

``python -m gaussiancad_core.processes.limited_child FILE_BYTES ARGUMENTS...``.  It dies with its
parent, and leaves no core files.
"""

import contextlib
import math
import signal
import sys

_PR_SET_PDEATHSIG = 1
"""Of prctl(2): the signal that a process gets when its parent ends."""


def limit_itself(most_bytes: int) -> None:
    """Die with the parent; write no file larger than so many bytes, and no core file.

    Where the system has no such limits nothing happens.
    """
    if sys.platform == "linux":
        import ctypes

        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    try:
        import resource
    except ImportError:
        return
    # A file that grows too large ends a write, not the process.
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    for kind, most in ((resource.RLIMIT_CORE, 0), (resource.RLIMIT_FSIZE, most_bytes)):
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(kind, (most, most))


def processor_limit() -> float:
    """Seconds of the processor after which the system ends this process; infinite for none, and
    where the system has no such limit."""
    try:
        import resource
    except ImportError:
        return math.inf
    usual, _ = resource.getrlimit(resource.RLIMIT_CPU)
    return math.inf if usual == resource.RLIM_INFINITY else float(usual)


def limit_processor(seconds: float) -> None:
    """Let the system end this process by SIGXCPU once it has taken so many seconds of the processor
    since it began; infinite for no limit.

    Where the system has no such limit, or does not grant so many, nothing happens.
    """
    try:
        import resource
    except ImportError:
        return
    _, most = resource.getrlimit(resource.RLIMIT_CPU)
    wanted = resource.RLIM_INFINITY if math.isinf(seconds) else math.ceil(seconds)
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(resource.RLIMIT_CPU, (wanted, most))


if __name__ == "__main__":
    limit_itself(int(sys.argv[1]))
    from gaussiancad_core.processes.command_entry import run_command

    sys.exit(run_command(sys.argv[2:]))
