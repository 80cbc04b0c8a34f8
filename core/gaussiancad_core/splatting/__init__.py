"""Gaussian splatting: from the hull to trained Gaussians (Kerbl et al. 2023).

The rooms in order: :mod:`.gaussians` (what is trained, and its start on the hull), :mod:`.ply`,
:mod:`.projection` (3D to 2D), :mod:`.rasteriser` (the interface; its back ends are :mod:`.tiles`,
:mod:`.gsplat_draw` and :mod:`.reference`, and :mod:`.devices` chooses), :mod:`.losses`,
:mod:`.targets`, :mod:`.settings`, :mod:`.trainee` (Gaussians with the optimiser's memory),
:mod:`.density` (births and deaths), :mod:`.checkpoints`, :mod:`.training` and :mod:`.residuals`.
"""
