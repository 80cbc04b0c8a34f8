"""The ink of a view to strokes, solid and dashed."""
