"""GaussianCAD's engine: a three-view drawing in, a measured solid model out.

The package knows nothing of FreeCAD or Qt.  Data flows one way through frozen dataclasses:
sheet -> views -> hull -> Gaussians -> surface -> files (see :mod:`gaussiancad_core.run.pipeline`).
"""

__version__ = "0.1.0"
