"""What a run is asked to do and what it says of its result."""
