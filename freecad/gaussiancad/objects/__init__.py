"""What a document stores: reconstructions and comparisons, readable without the addon."""
