"""The workbench's commands, in the order of its toolbar and its menu."""

TOOLBAR = (
    "GaussianCAD_Correct",
    "GaussianCAD_LinesToSketches",
    "GaussianCAD_ToBody",
    "GaussianCAD_Reconstruct",
    "GaussianCAD_Solutions",
    "GaussianCAD_Compare",
    "GaussianCAD_Check",
    "GaussianCAD_CheckEngine",
)

MENU = (
    *TOOLBAR[:-1],
    "GaussianCAD_SheetNumbers",
    "GaussianCAD_FailedSheets",
    TOOLBAR[-1],
    "GaussianCAD_InstallEngine",
)

OF_A_RECONSTRUCTION = (
    "GaussianCAD_Correct",
    "GaussianCAD_LinesToSketches",
    "GaussianCAD_Solutions",
    "GaussianCAD_RunAgain",
    "GaussianCAD_Report",
)
"""What the context menu offers for a reconstruction and its part."""
