"""Pictures of results: shaded previews, and the sheet with a result's lines over it."""
