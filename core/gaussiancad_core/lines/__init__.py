"""A solid or a mesh to its visible and hidden lines, and how two sets of lines agree."""
