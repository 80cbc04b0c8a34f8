"""The strokes of a file as a graph: what touches what, in which pen, and what each stands for."""
