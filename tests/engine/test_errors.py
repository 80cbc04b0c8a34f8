"""Which errors say that memory does not suffice."""

import errno

import cv2
import numpy as np
import pytest
import torch
from onnxruntime.capi.onnxruntime_pybind11_state import RuntimeException

from gaussiancad_core.errors import UnreadableError, is_out_of_memory, out_of_files


def _raised(make: object) -> BaseException:
    with pytest.raises(Exception) as stated:
        make()
    return stated.value


def test_libraries_that_get_no_memory_are_known_by_what_they_raise() -> None:
    assert is_out_of_memory(_raised(lambda: np.empty(1 << 50)))
    assert is_out_of_memory(_raised(lambda: torch.empty(1 << 50)))
    error = cv2.error("Insufficient memory")
    error.code = -4
    assert is_out_of_memory(error)
    assert is_out_of_memory(OSError(errno.ENOMEM, "Cannot allocate memory"))
    assert is_out_of_memory(ImportError("libx.so.9: failed to map segment from shared object"))
    assert is_out_of_memory(RuntimeException("Status Message: std::bad_alloc"))


def test_other_errors_are_others() -> None:
    assert not is_out_of_memory(_raised(lambda: cv2.resize(np.zeros((2, 2)), (0, 0))))
    assert not is_out_of_memory(RuntimeError("no kernel image"))
    assert not is_out_of_memory(ValueError("cannot allocate memory"))
    assert not is_out_of_memory(UnreadableError("file-missing", "bad_alloc.png does not exist"))
    assert not is_out_of_memory(ImportError("no module named torch"))


def test_an_error_that_comes_of_too_many_open_files_is_told_as_that() -> None:
    refused = OSError(errno.EMFILE, "Too many open files")
    made = UnreadableError("file-unreadable", "a.png cannot be opened")
    made.__cause__ = refused
    loader = ImportError("libx.so.9: cannot open shared object file: Too many open files")
    for error in (refused, made, loader, OSError(errno.ENFILE, "Too many open files in system")):
        found = out_of_files(error)
        assert found is not None
        assert (found.code, int(found.exit_code)) == ("too-many-open-files", 5)
    again = UnreadableError("file-missing", "no")
    again.__cause__ = again
    for error in (OSError(errno.ENOSPC, "No space left"), again):
        assert out_of_files(error) is None
