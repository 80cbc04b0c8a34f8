"""The cell complex that carriers divide space into, and the rays that cross it."""
