"""Processes with limits of memory, time and file size, that die with who started them."""
