"""The workbench's commands, in the order of its toolbar and its menu."""

TOOLBAR = (
    "GaussianCAD_Correct",
    "GaussianCAD_Reconstruct",
    "GaussianCAD_Solutions",
    "GaussianCAD_Compare",
    "GaussianCAD_CheckEngine",
)

MENU = (*TOOLBAR[:-1], "GaussianCAD_FailedSheets", TOOLBAR[-1], "GaussianCAD_InstallEngine")
