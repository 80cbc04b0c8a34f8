"""One task of a benchmark: draw, solve, measure; in a process that can be ended."""
