"""How features, their sketches and their numbers are judged."""
