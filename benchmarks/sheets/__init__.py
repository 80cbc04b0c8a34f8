"""Drawings of parts: how they are made, varied, found and kept."""
