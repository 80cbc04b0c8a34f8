"""Runs benchmarks: child processes with limits, rows that are kept, results that are recorded."""
