"""Views of a sheet: groups of edges, what kind of drawing each is, and where each looks from."""
