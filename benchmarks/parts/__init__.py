"""Parts that benchmarks build, each from its family and a seed."""
