"""What stands on a sheet beside the part's own lines: found, named, and taken off."""
