import sys
from pathlib import Path

# Children of tests find their work in the folder of these tests.
sys.path.insert(0, str(Path(__file__).resolve().parent))
