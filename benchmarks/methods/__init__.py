"""Models by several methods on many sheets, and their tables."""
