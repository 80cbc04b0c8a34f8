"""From a solid to its lines, and from the lines to a sheet of views."""
