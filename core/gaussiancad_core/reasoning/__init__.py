"""From the lines of the views to which space is material: supports, cells, labels."""
