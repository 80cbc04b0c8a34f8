"""The visual hull of the masks, and how depths carve it."""
