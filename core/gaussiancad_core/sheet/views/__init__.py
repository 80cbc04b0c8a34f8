"""Where the views of a sheet are, and in which roles."""
