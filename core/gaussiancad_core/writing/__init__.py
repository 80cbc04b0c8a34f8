"""What a sheet's writing says: its scale, notes at features, names of views, cutting planes."""
