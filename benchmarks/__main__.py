"""Starts ``python -m benchmarks``."""

import sys

if __name__ == "__main__":
    from benchmarks.run.command import main

    sys.exit(main(sys.argv[1:]))
