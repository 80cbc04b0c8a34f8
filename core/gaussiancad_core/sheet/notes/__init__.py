"""What the words of a sheet say: notes at holes and edges, titles of sections, cutting planes."""
