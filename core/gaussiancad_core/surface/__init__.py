"""From trained Gaussians to a surface: points, Poisson mesh, fewer triangles, files."""
