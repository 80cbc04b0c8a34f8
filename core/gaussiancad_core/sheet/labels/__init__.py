"""What the ink of a picture stands for, as a trained network sees it, decided along its lines."""
