"""Many sheets: each is reconstructed in a limited process of its own, with one report over all."""
