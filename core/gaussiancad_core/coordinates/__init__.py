"""One consistent set of values: the carriers of lines, and coordinates that all views share."""
