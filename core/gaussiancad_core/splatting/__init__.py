"""Gaussian splatting: from the hull to trained Gaussians (Kerbl et al. 2023).

The modules in order: :mod:`.gaussians` (what is trained, and its start on the hull), :mod:`.ply`,
:mod:`.projection` (3D to 2D), :mod:`.rasterizer` (the interface; its back ends are :mod:`.tiles`,
:mod:`.gsplat_draw` and :mod:`.reference`, and :mod:`.torch_devices` chooses), :mod:`.losses`,
:mod:`.targets`, :mod:`.settings`, :mod:`.gaussian_model` (Gaussians with the optimiser's memory),
:mod:`.density` (births and deaths), :mod:`.checkpoints`, :mod:`.gaussian_training` and
:mod:`.residuals`.
"""
