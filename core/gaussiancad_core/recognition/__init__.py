"""A file to its views with strokes, and what is told of them."""
