"""Why a part's shape is not certain, what was assumed, and what was left out."""

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP

REASONS = {
    "solid-way-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A library broke down in one of the ways in which the solid is looked for. That way was "
        "left out: check the part. It is a fault of ours: please report it with the drawing.",
    ),
    "photographed-at-a-slant": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The sheet was photographed at a slant of about {degrees} degrees and was straightened by "
        "its lines. Check the part's measures.",
    ),
    "photographed-at-a-slant:width": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The sheet was photographed at a slant of about {degrees} degrees and was straightened by "
        "its lines. How wide it is for its height may be some per cent off: check the part's "
        "measures.",
    ),
    "no-exact-solid": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "No exact solid was found. The model is a surface that fills what the outlines leave: "
        "measure nothing from it.",
    ),
    "no-exact-solid:refused": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The exact solid that fits best has only {percent} % of the drawing's lines and was not "
        "kept. Check {canvas} whether the lines were read right.",
    ),
    "sketched": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "No solid has all lines as they were read. This part is a stack of slabs along {axis} "
        "that explains {percent} % of them. Check {canvas} which lines are wrong.",
    ),
    "sketched:all": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "This part, a stack of slabs along {axis}, has all lines of the drawing, but nothing "
        "proves that no other part has them. Compare it with the sheet.",
    ),
    "sketched:features": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "No solid has all lines as they were read. This part, put together of {count} features, "
        "explains {percent} % of them. Check {canvas} which lines are wrong.",
    ),
    "sketched:features-all": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "This part, put together of {count} features, has all lines of the drawing, but nothing "
        "proves that no other part has them. Compare it with the sheet.",
    ),
    "several-bodies": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The part is {count} bodies: the sheet shows several, or a line is missing that joins "
        "them.",
    ),
    "no-solid-fits": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The lines of the views contradict each other, so that no solid has them all. Check "
        "{canvas} whether a line was read wrong.",
    ),
    "lines-contradict": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Lines contradict each other as they were read, and are marked on the sheet: one was read "
        "wrong, or another is missing. Correct it {canvas}.",
    ),
    "lines-contradict:missing": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The lines contradict each other as they were read. They would agree if the view "
        "“{view}” had one more {linetype}: draw it {canvas}.",
    ),
    "lines-contradict:surplus": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The lines contradict each other as they were read. They would agree without one "
        "{linetype} of the view “{view}”: erase it {canvas} if it is wrong.",
    ),
    "lines-contradict:kind": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The lines contradict each other as they were read. They would agree if another line of "
        "the view “{view}” were a {linetype}: change it {canvas} if it was read wrong.",
    ),
    "no-valid-solid": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "What fits the lines best does not close up to a solid: lines are missing or wrong. Check "
        "them {canvas}.",
    ),
    "part-too-complex": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has too many lines for an exact solid. Draw fewer of them on one sheet.",
    ),
    "part-too-complex:picture": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The lines of the drawing are too many, or cross each other too often, to be told "
        "apart. Draw fewer of them on one sheet, or cut the views out of the picture.",
    ),
    "part-too-complex:pieces": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has more separate strokes than can be followed ({most}). Draw fewer of "
        "them on one sheet, or cut the views out of it.",
    ),
    "solid-unsound": QT_TRANSLATE_NOOP("GaussianCAD", "The solid is not one valid closed body."),
    "ambiguous": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "{count} different solids have the lines of this drawing. Choose the one that is meant "
        "with Choose among Solutions.",
    ),
    "ambiguous:projection": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The views fit different solids in first and in third angle. Choose the angle under "
        "Projection.",
    ),
    "search-unfinished": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The search for solids with these lines was not completed: there may be others.",
    ),
    "search-unfinished:clock": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The search for solids took much longer than usual and was ended. Close other programs "
        "and run the drawing again.",
    ),
    "search-unfinished:projection": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The views may fit a solid in the other projection as well. Choose first or third angle "
        "under Projection.",
    ),
    "search-unfinished:lines": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has more lines than can be understood together. Draw fewer of them on one "
        "sheet.",
    ),
    "lines-unexplained": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The part does not have all lines of the drawing, or it has others."
    ),
    "lines-unexplained:missing": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The part lacks lines of the drawing; the longest one, of {length_mm} mm, is in the view "
        "“{view}”.",
    ),
    "lines-unexplained:beyond": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The part has lines that the drawing does not show; the longest one, of {length_mm} mm, "
        "is in the view “{view}”.",
    ),
    "lines-unexplained:surface": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The surface does not have all lines of these views, or it has others: {views}.",
    ),
    "lines-apart": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Lines that nearly meet were taken to meet: small steps may be missing.",
    ),
    "lines-apart:ink": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "In the view “{view}” the drawn line lies {distance_mm} mm beside the part's: a curve may "
        "have been misread there.",
    ),
    "lines-apart:line": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A line of the drawing lies {distance_mm} mm beside the part's: a small step may be "
        "missing.",
    ),
    "lines-apart:direction": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A short line of the drawing runs in a direction that no line of the part near it has: a "
        "small rounding or chamfer may be missing.",
    ),
    "lines-apart:extent": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The views and the part differ by up to {distance_mm} mm in size: a small step may be "
        "missing.",
    ),
    "unused-view": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Not used: {kind}. What it shows of the part may be missing.",
    ),
    "unused-view:lines": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Groups of lines belong to no view and are large enough to be one ({count}). Box them as "
        "views {canvas} if they show the part.",
    ),
    "other-pen-lines": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Lines that cross a view in another line width were not used ({count}). If they are edges "
        "of the part, make them visible lines {canvas}.",
    ),
    "told-lengths-disagree": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The lengths of {earlier_mm} mm and {last_mm} mm that you told contradict each other. The "
        "last one was taken. Tell one of them again, or take it back.",
    ),
    "corrections-unmatched": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Corrections that no longer find what they corrected: {count}. Look at them again "
        "{canvas}.",
    ),
    "assumed": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "No view has a hidden line. It was assumed that nothing lies inside the part that no view "
        "shows.",
    ),
    "assumed:views": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "These views have no hidden line: {views}. It was assumed that none was left out; "
        "otherwise another solid fits as well, see Choose among Solutions.",
    ),
    "faces-thin": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The solid has long faces too narrow for any view to show: lines that belong together may "
        "have been read apart.",
    ),
    "linetypes-retold": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Hidden lines as short as a dash look like visible ones. Some were taken for the other "
        "kind, as the other views have it.",
    ),
    "symbol-contradicts-lines": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The projection symbol says {symbol}, but the lines fit {other} better. Taken was "
        "{taken}; choose under Projection if it is the other.",
    ),
    "entities-left-out:part": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The file has entities that cannot be read and were left out: {kinds}. What they show may "
        "be missing.",
    ),
    "frame-left-out:guessed": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The lines around everything were taken for a frame. If they are the part's outline, and "
        "what lies within is a pocket, the part is larger than what was made.",
    ),
    "unit-contradicts-note": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A note names {noted} as the unit, but the numbers fit what the file draws in {taken}, "
        "which was taken. Check the part's size.",
    ),
    "scale-contradicts-dimensions": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing's dimensions agree on {sheet} mm per pixel, but the scale that was set gives "
        "{told}. The dimensions were not used: check what is set under Scale.",
    ),
    "two-views": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has only two directions of view: what a third would show is not known.",
    ),
    "section-used": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Used as a view: {kind}. What was cut away in front of the cut is shown by no line.",
    ),
    "note-count": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The note “{note}” speaks of {count} holes, and the view “{view}” has {found} of that "
        "kind: the note was taken for all of them.",
    ),
    "second-view-assumed": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has one view; what a second would show was assumed.",
    ),
    "second-view-assumed:turned": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has one view with diameters across its axis: a turned part was assumed. If "
        "it is none, another view is needed.",
    ),
    "second-view-assumed:plate": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing has one view and a thickness: it was assumed that the part is of that "
        "thickness everywhere and that what is drawn inside goes through.",
    ),
    "broken-view": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A view is broken, so that its length is not as drawn. Set a length along another axis "
        "under Scale.",
    ),
    "half-view": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A view is drawn up to its centre line: what lies beyond was taken as its mirror image.",
    ),
}

ASSUMPTIONS = {
    "nothing-hidden": REASONS["assumed"],
    "nothing-hidden:views": REASONS["assumed:views"],
    "hole-through:several": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "{count} holes of {diameter_mm} mm in the view “{view}” were taken to go through, as "
        "nothing tells their depth.",
    ),
    "hole-through": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The hole of {diameter_mm} mm in the view “{view}” was taken to go through, as nothing "
        "tells its depth.",
    ),
    "section-through-middle": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Section {label} was taken to cut through the middle of the part, as it has no cutting "
        "line.",
    ),
    "section-through-middle:untitled": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A section without a title was taken to cut through the middle of the part, as it has no "
        "cutting line.",
    ),
    "second-view": REASONS["second-view-assumed"],
    "second-view:turned": REASONS["second-view-assumed:turned"],
    "second-view:plate": REASONS["second-view-assumed:plate"],
}

ALTERNATIVES = {
    "nothing-hidden": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "There are bores, pockets or cavities that only hidden lines would show.",
    ),
    "hole-through": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "It ends inside: give its depth in a note, or draw its hidden lines.",
    ),
    "section-through-middle": QT_TRANSLATE_NOOP(
        "GaussianCAD", "It cuts elsewhere: draw its cutting line."
    ),
    "second-view": QT_TRANSLATE_NOOP("GaussianCAD", "It is another part with the same view."),
}
"""What else may be, by the code of an assumption."""

WARNINGS = {
    "surroundings-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD", "What surrounds the paper in the picture was left out."
    ),
    "projection-assumed": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The lines fit both {taken} and {other}. Taken was {taken}; choose under Projection if it "
        "is the other.",
    ),
    "dimensions-disagree": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Dimensions do not fit the scale of the others ({numbers}): they were misread, or the "
        "drawing is not to scale there.",
    ),
    "resolution-lowered": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The sheet is so large that it was read at a lower resolution: measures are known less "
        "well. Cut out the views to have them read as they are.",
    ),
    "labels-missing": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The trained network that tells edges from dimensions is missing or damaged: the picture "
        "was read by rules. Repair the engine under Check Engine.",
    ),
    "labels-doubtful": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Lines that may be edges of the part or annotation: {count}. Look at them {canvas}.",
    ),
    "surface-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The engine was installed for exact solids only: no surface was made. GaussianCAD > "
        "Install Engine has one that makes both.",
    ),
    "full-scale-assumed": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The sheet has no readable scale: 1:1 was assumed. Set a length under Scale if it is "
        "another.",
    ),
    "size-contradicts-unit": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The dimensions say that the part is {share} times as large as the file draws it. They "
        "were taken: check the part's size.",
    ),
    "full-scale-assumed:file": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The file says the unit of its lengths, and no scale: the part was taken to be drawn in "
        "its own size. Set a length under Scale if it is not.",
    ),
    "pixels-made-square": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The picture has {across} pixels an inch across and {down} down: it was resampled to {dpi} "
        "both ways.",
    ),
    "other-page-taken": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Page 1 shows no views that belong together. Page {page} of {pages}, which brings them "
        "together, was taken.",
    ),
    "scale-assumed": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The scale is not known: the longest edge was made 100 mm. Set a length under Scale.",
    ),
    "corrected": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Corrections by hand that were taken: {count}. The result is checked by the sheet as "
        "corrected.",
    ),
    "views-disagree": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The views differ by {spread_mm} mm in the part's extent along {axis}: the mean was taken.",
    ),
    "external-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The SVG refers to other files, which are never opened: what they hold is missing.",
    ),
    "paper-size-unknown": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The file says neither its unit nor how large its paper is. Set a length under Scale.",
    ),
    "entities-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The file has entities that cannot be read and were left out: {kinds}.",
    ),
    "frame-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The lines around everything were taken for a frame, not for the part's outline.",
    ),
    "lines-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Groups of lines belong to no view and were left out: {count}.",
    ),
    "pictorial-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A pictorial view was left out: it illustrates what the other views show.",
    ),
    "outline-of-solid": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The outlines of these views have gaps: {views}. The surface was made with the exact "
        "solid's outline there.",
    ),
    "training-takes-long": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "On a processor this takes an hour or more. Choose the quality Draft or smaller images, "
        "or use a graphics card.",
    ),
    "checkpoint-ignored": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The interrupted run in the folder belongs to another drawing, other settings or another "
        "version: the training began anew.",
    ),
    "thread-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Thread symbols were left out: the model has plain cylinders there.",
    ),
}
