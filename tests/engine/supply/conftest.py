import sys
from pathlib import Path

# The scripts find each other beside the one that is run.
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "scripts"))
