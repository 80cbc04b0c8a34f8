"""A sheet as plain data in mm of paper, whatever kind of file it came from."""
