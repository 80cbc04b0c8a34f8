"""CP-SAT for rules: deterministic time that is counted as work, and a clock that only guards."""

from math import isfinite
from typing import Any

from ortools.sat.python import cp_model

from gaussiancad_core.labelling.counted_work import NEVER, Deadline

FOUND = (cp_model.OPTIMAL, cp_model.FEASIBLE)
"""What a solver says that has a solution."""

_LOADED = 2e-6
"""Units of work of a constraint each time that a model is solved: reading it is not counted by the
solver itself."""


class CountingSolver(cp_model.CpSolver):
    """A solver whose deterministic time counts towards a deadline.

    Args:
        deadline: that it counts towards.
    """

    def __init__(self, deadline: Deadline) -> None:
        super().__init__()
        self._deadline = deadline

    def solve(self, model: cp_model.CpModel, *callbacks: Any) -> cp_model.CpSolverStatus:  # noqa: ANN401
        """Solve, and count what that took."""
        status = super().solve(model, *callbacks)
        loaded = _LOADED * len(model.proto.constraints)
        self._deadline.add(float(self.response_proto.deterministic_time) + loaded)
        return status


def solver_for(effort: float, workers: int = 1, deadline: Deadline = NEVER) -> cp_model.CpSolver:
    """A solver that stops after a deterministic time and gives the same answer each time.

    It makes no linear relaxation: rules are clauses, of which that tells nothing.  Nor does it look
    for symmetries, or try literals one by one, which took a fifth of the time, or simplify clauses
    more than once, which takes seconds of a hundred thousand and removes hardly any.
    """
    solver = CountingSolver(deadline)
    solver.parameters.linearization_level = 0
    solver.parameters.cp_model_probing_level = 0
    solver.parameters.symmetry_level = 0
    solver.parameters.max_presolve_iterations = 1
    solver.parameters.max_deterministic_time = min(effort, deadline.left)
    solver.parameters.num_workers = workers
    solver.parameters.interleave_search = workers > 1
    solver.parameters.random_seed = 0
    solver.parameters.max_memory_in_mb = 2000
    if isfinite(deadline.seconds_left):
        solver.parameters.max_time_in_seconds = deadline.seconds_left
    return solver


def relaxing_solver(effort: float, deadline: Deadline = NEVER) -> cp_model.CpSolver:
    """A solver for what costs least, by unsatisfiable cores: most rules can hold together."""
    solver = solver_for(effort, deadline=deadline)
    solver.parameters.optimize_with_core = True
    return solver
