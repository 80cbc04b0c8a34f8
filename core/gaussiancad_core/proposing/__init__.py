"""Parts proposed for a sheet: features put together, each by what it explains."""
