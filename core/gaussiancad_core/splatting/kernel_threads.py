"""Who runs the compiled kernels, and that one caller at a time does.

numba's own work queue runs them: it comes with every numba, and unlike OpenMP its threads sleep
between kernels instead of spinning, which costs torch its processor.  It serves one caller at a
time, so that the kernels are behind a lock.
"""

import os
import threading

import numba

if "NUMBA_THREADING_LAYER" not in os.environ:
    setattr(numba.config, "THREADING_LAYER", "workqueue")  # noqa: B010 - it is made at run time

KERNELS = threading.Lock()
"""Held while a kernel runs."""
