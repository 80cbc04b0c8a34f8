"""CP-SAT for rules: deterministic time, and a clock that only ends what would take far too long."""

import time
from dataclasses import dataclass
from math import inf, isfinite

from ortools.sat.python import cp_model

FOUND = (cp_model.OPTIMAL, cp_model.FEASIBLE)
"""What a solver says that has a solution."""


@dataclass(frozen=True)
class Deadline:
    """A time by which solvers end.

    The same input ends at the same labels as long as it is not reached: deterministic time ends
    solvers earlier, but on a machine that is busy with other things.

    Attributes:
        at: s of ``time.perf_counter``.
    """

    at: float = inf

    @property
    def left(self) -> float:
        """s until then; 0 when it is over."""
        return max(0.0, self.at - time.perf_counter())


NEVER = Deadline()


def solver_for(effort: float, workers: int = 1, deadline: Deadline = NEVER) -> cp_model.CpSolver:
    """A solver that stops after a deterministic time and gives the same answer each time.

    It makes no linear relaxation: rules are clauses, of which that tells nothing.  Nor does it look
    for symmetries, or try literals one by one, which took a fifth of the time, or simplify clauses
    more than once, which takes seconds of a hundred thousand and removes hardly any.
    """
    solver = cp_model.CpSolver()
    solver.parameters.linearization_level = 0
    solver.parameters.cp_model_probing_level = 0
    solver.parameters.symmetry_level = 0
    solver.parameters.max_presolve_iterations = 1
    solver.parameters.max_deterministic_time = effort
    solver.parameters.num_workers = workers
    solver.parameters.interleave_search = workers > 1
    solver.parameters.random_seed = 0
    solver.parameters.max_memory_in_mb = 2000
    if isfinite(deadline.at):
        solver.parameters.max_time_in_seconds = deadline.left
    return solver


def relaxing_solver(effort: float, deadline: Deadline = NEVER) -> cp_model.CpSolver:
    """A solver for what costs least, by unsatisfiable cores: most rules can hold together."""
    solver = solver_for(effort, deadline=deadline)
    solver.parameters.optimize_with_core = True
    return solver
