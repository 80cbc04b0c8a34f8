"""Which errors say that memory does not suffice."""

import cv2
import numpy as np
import pytest
import torch

from gaussiancad_core.errors import is_out_of_memory


def _raised(make: object) -> BaseException:
    with pytest.raises(Exception) as told:
        make()
    return told.value


def test_libraries_that_get_no_memory_are_known_by_what_they_raise() -> None:
    assert is_out_of_memory(_raised(lambda: np.empty(1 << 50)))
    assert is_out_of_memory(_raised(lambda: torch.empty(1 << 50)))
    error = cv2.error("Insufficient memory")
    error.code = -4
    assert is_out_of_memory(error)


def test_other_errors_are_others() -> None:
    assert not is_out_of_memory(_raised(lambda: cv2.resize(np.zeros((2, 2)), (0, 0))))
    assert not is_out_of_memory(RuntimeError("no kernel image"))
    assert not is_out_of_memory(ValueError("cannot allocate memory"))
