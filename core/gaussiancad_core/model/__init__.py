"""Plain data that all stages share: axes, views, section planes, hole depths, meshes, cameras."""
