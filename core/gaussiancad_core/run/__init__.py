"""The stages of a run in order, and the engine that stays."""
