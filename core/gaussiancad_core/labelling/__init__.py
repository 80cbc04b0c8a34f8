"""Which cells are material: rules of visibility, priors, the constraint solver."""
