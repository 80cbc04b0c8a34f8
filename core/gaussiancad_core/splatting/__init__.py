"""Gaussian splatting: from the hull to trained Gaussians (Kerbl et al. 2023).

The rooms in order: :mod:`.gaussians` (what is trained, and its start on the hull), :mod:`.ply`,
:mod:`.projection` (3D to 2D), :mod:`.rasteriser` (the interface, with the fast back end in
:mod:`.tiles` and :mod:`.kernels` and the plain one in :mod:`.reference`), :mod:`.losses`,
:mod:`.targets`, :mod:`.settings` and :mod:`.training`.
"""
