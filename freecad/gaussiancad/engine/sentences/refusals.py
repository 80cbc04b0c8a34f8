"""Why no part was made: files that cannot be read, sheets without a part, limits, the engine."""

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP

FILES = {
    "file-missing": QT_TRANSLATE_NOOP(
        "GaussianCAD", "There is no such file: {path}. Choose it again."
    ),
    "not-a-file": QT_TRANSLATE_NOOP("GaussianCAD", "{path} is no file. Choose a drawing."),
    "file-unreadable": QT_TRANSLATE_NOOP(
        "GaussianCAD", "{path} cannot be opened. Check that you may read it."
    ),
    "file-not-readable": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The file cannot be read. Check that you may read it."
    ),
    "empty-file": QT_TRANSLATE_NOOP("GaussianCAD", "The file is empty. Export it again."),
    "not-an-image": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The file is no PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF, whatever its name says. "
        "Export the drawing as one of them.",
    ),
    "damaged-image": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The picture is damaged. Export or scan the drawing again."
    ),
    "damaged-pdf": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The file is no PDF, or is damaged. Export the drawing again, or as PNG."
    ),
    "damaged-svg": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The file is no SVG, or is damaged. Export the drawing again, or as PNG."
    ),
    "damaged-dxf": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The file is no DXF, or is damaged. Export the drawing again, or as PNG."
    ),
    "reading-not-read": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "What was read of the sheet is damaged, or of another version. Open the drawing {canvas} "
        "again.",
    ),
    "corrections-not-read": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The corrections in {path} are damaged, or of another version. Remove that file, or mend "
        "it.",
    ),
    "encrypted-pdf": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The PDF is protected by a password. Save it without one."
    ),
    "svg-entities": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The SVG declares XML entities, which are never expanded. Save it as plain SVG.",
    ),
    "external-content": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "All that the SVG shows lies in other files, which are never opened. Embed it.",
    ),
    "empty-drawing": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The page has no lines. Choose another page or file."
    ),
    "too-many-pages": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The file has {count} pages, at most {most} are read. Save the sheet in a file by itself.",
    ),
    "page-missing": QT_TRANSLATE_NOOP(
        "GaussianCAD", "There is no page {page}: the last page of the file is page {count}."
    ),
    "image-too-large": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The picture is too large: at most {most} million pixels are read. Export or scan it at a "
        "lower resolution, or on smaller paper.",
    ),
    "image-too-small": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The picture has only {width} × {height} pixels. Export the drawing with 1920 × 1080 or "
        "more.",
    ),
    "freecad-document": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "This is a FreeCAD document. Open it, then choose its TechDraw page as the drawing.",
    ),
    "format-not-supported": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "{format} files are not read. Save the drawing as PDF, SVG, DXF or PNG.",
    ),
    "batch-not-read": QT_TRANSLATE_NOOP(
        "GaussianCAD", "This is no report of a batch. Choose the one in the folder that it wrote."
    ),
    "no-report": QT_TRANSLATE_NOOP("GaussianCAD", "The run left no report. Run it again."),
    "damaged-report": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The run's report is damaged. Run it again."
    ),
    "old-report": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The run's report is of another version. Run it again."
    ),
}

VIEWS = {
    "blank-sheet": QT_TRANSLATE_NOOP("GaussianCAD", "The sheet is blank: there are no lines."),
    "not-a-line-drawing": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "This does not look like a line drawing. Use an export or a scan of the drawing, not a "
        "photograph.",
    ),
    "no-views": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "No view of a part was found. Box the views {canvas} and say which is which.",
    ),
    "one-view": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Only one view was found. A part follows from two views, or from one with diameters "
        "across its axis or with a thickness. Box the views {canvas} if there are more.",
    ),
    "one-view:scale": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has one view and a thickness, and nothing tells its scale. Tell a length "
        "that the view shows, under Scale or {canvas}.",
    ),
    "pictorial-alone": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The sheet shows the part in a pictorial view alone. Views at right angles are needed, "
        "such as front, top and side.",
    ),
    "views-not-aligned": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The views do not line up with each other. Box them {canvas} and say which is which.",
    ),
    "empty-view": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The view “{view}” has no visible line. Draw its edges {canvas}, or say that the "
        "box is another view.",
    ),
    "views-parallel": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The views show nothing of the {axis} axis. Two views at right angles are needed: box "
        "them {canvas}.",
    ),
    "views-contradict": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The views differ by {percent} % in the part's extent along {axis} ({views}). Check that "
        "they show one part at one scale, or box them {canvas}.",
    ),
    "size-out-of-range": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "By its scale the part is {longest} mm long. Tell its true size with Tell a Length.",
    ),
    "open-outline": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The outline of the view “{view}” is not closed. Draw what is missing of its visible "
        "edges {canvas}.",
    ),
    "open-outline:thin": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The edges of the view “{view}” run together to one line. Export the drawing with more "
        "pixels.",
    ),
    "empty-hull": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The outlines of the views have no body in common, so that there is no surface. Check "
        "which view is which, and the projection.",
    ),
    "no-surface": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The Gaussians bound no body, so that there is no surface of them. Choose a finer "
        "quality, or check that the views belong together.",
    ),
    "empty-view-box": QT_TRANSLATE_NOOP(
        "GaussianCAD", "There are no lines in the box of the view “{view}”. Draw it again."
    ),
    "role-repeated": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Two boxes are named “{view}”. Give one of them another name {canvas}.",
    ),
    "reading-of-another-sheet": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has changed since it was read. Open it {canvas} again.",
    ),
    "corrections-of-another-sheet": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The corrections in {path} belong to another drawing, or to an earlier version of it. "
        "Remove that file, or correct the drawing again.",
    ),
}

LIMITS = {
    "out-of-memory": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "There is not enough memory. Choose the quality Draft or a smaller file, or export a "
        "vector drawing as PNG.",
    ),
    "too-many-elements": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has more lines and other elements than can be read ({most}). Save only the "
        "views, or export it as PNG.",
    ),
    "too-many-elements:reading": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The reading has more strokes than are taken ({most}). Read the views alone.",
    ),
    "too-many-elements:corrections": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "There are more corrections than are taken ({most}). Remove those that no longer matter.",
    ),
    "too-many-elements:table": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The table has more lines than are taken ({most}). Make several tables of it.",
    ),
    "drawing-file-too-large": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The file has more than {most} MB. Save only the views, or export the drawing as PNG.",
    ),
    "reading-takes-too-long": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing was not read after {seconds} s. Save only the views, or export it as PNG.",
    ),
    "takes-too-long": QT_TRANSLATE_NOOP(
        "GaussianCAD", "It took longer than is allowed, and was ended."
    ),
    "disk-full": QT_TRANSLATE_NOOP(
        "GaussianCAD", "There is no space left on the disk. Free some, then try again."
    ),
    "too-many-open-files": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The system lets the engine open no more files. Close other programs, then try again.",
    ),
    "output-not-writable": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The folder {path} cannot be written to. Choose another one."
    ),
    "cuda-unavailable": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The graphics card cannot be used. GaussianCAD > Check Engine shows what is missing.",
    ),
    "engine-incomplete": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The engine is incomplete. Choose GaussianCAD > Check Engine to see what to do.",
    ),
    "extra-missing": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The engine was installed without what this needs ({packages}). Choose GaussianCAD > "
        "Install Engine, and there an engine with PyTorch.",
    ),
    "engine-died": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A library ended the engine. This is a fault of ours: please report it with the sheet.",
    ),
    "killed": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The system ended the engine, as it does where the memory does not suffice. Choose a "
        "coarser quality, or a smaller sheet.",
    ),
    "foreign-files": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "{folder} holds files that GaussianCAD did not make: {names}. Choose another folder.",
    ),
    "unforeseen": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The engine met something that nobody foresaw ({kind}). This is a fault of ours: please "
        "report it with the sheet.",
    ),
    "unforeseen:file": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The engine met something that nobody foresaw ({kind}). This is a fault of ours: please "
        "report it with the file {path}.",
    ),
    "decimation-failed": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The surface cannot be simplified to a closed one. Choose a finer quality."
    ),
    "faceted-solid-failed": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The surface does not become a valid solid: only its mesh can be used."
    ),
    "step-not-written": QT_TRANSLATE_NOOP("GaussianCAD", "The solid cannot be saved as STEP."),
}
