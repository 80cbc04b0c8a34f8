"""The suite of ``make test-gui``, as one test beside the engine's."""

import pytest
from run_freecad_suites import report_of


@pytest.mark.freecad
@pytest.mark.window
@pytest.mark.slow
def test_the_suite_passes_in_freecad() -> None:
    passed, report = report_of("gui")
    assert passed, report
