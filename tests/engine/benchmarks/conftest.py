import sys
from pathlib import Path

# The modules of a benchmark find each other beside the script that is run; children of tests find
# their work here.
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "benchmarks"))
sys.path.insert(0, str(Path(__file__).resolve().parent))
