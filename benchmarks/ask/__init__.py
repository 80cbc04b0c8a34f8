"""A module for each benchmark; its first line is the question that it answers."""
