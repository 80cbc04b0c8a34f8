"""Files as runs write and find them: whole under their names, the user's own left alone."""
