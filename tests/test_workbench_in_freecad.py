"""The suite of ``make test-workbench``, as one test beside the engine's."""

import pytest
from run_freecad_suites import report_of


@pytest.mark.freecad
@pytest.mark.slow
def test_the_suite_passes_in_freecad() -> None:
    passed, report = report_of("workbench")
    assert passed, report
