"""How like the truth something is: solids, faces, strokes, views."""
