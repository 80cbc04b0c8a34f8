"""Views on shared axes in millimetres."""
