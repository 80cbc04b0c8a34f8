"""What reasons, assumptions and warnings mean."""

from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.explained import row

REASONS = (
    row(
        "the model is a surface around the space that the outlines leave; or the exact solid "
        "that fits best explains too few of the lines and was not kept",
        Code.NO_EXACT_SOLID,
    ),
    row(
        "no solid has all lines as they were read, or none could be proved: the part is the "
        "stack of slabs that explains them best; `solid.source` is `sketch`",
        Code.SKETCHED,
    ),
    row("the part is several bodies", Code.SEVERAL_BODIES),
    row("no solid has the lines of all views: they contradict each other", Code.NO_SOLID_FITS),
    row(
        "the named lines, as they were read, contradict each other, or show a surface that is"
        " not supported; they are marked in `overlay.png`, with a border those without which "
        "all others agree, and boxed in `report.json` under `conflict`",
        Code.LINES_CONTRADICT,
    ),
    row(
        "what fits the lines best does not enclose a solid: lines are missing or wrong",
        Code.NO_VALID_SOLID,
    ),
    row(
        "the lines divide the views into too many pieces for an exact solid: draw less in one"
        " sheet",
        Code.PART_TOO_COMPLEX,
    ),
    row("the solid is not one valid closed body", Code.SOLID_UNSOUND),
    row(
        "different solids have these lines, or fit in first and in third angle; the others "
        "are in `alternatives/`",
        Code.AMBIGUOUS,
    ),
    row(
        "the search for solids with these lines ended at its limit of work, or, as its "
        "message says then, by the clock: there may be others",
        Code.SEARCH_UNFINISHED,
    ),
    row(
        "the model does not show all lines of the named views, or shows others; `overlay.png`"
        " shows where",
        Code.LINES_UNEXPLAINED,
    ),
    row(
        "a line of the sheet lies farther off the solid's than it may miss where it "
        "belongs, the ink runs off a line of the solid (a curve was misread), or lines "
        "that miss each other were taken to meet: a small step may be missing",
        Code.LINES_APART,
    ),
    row(
        "a library broke down, or came to no end, in one of the ways in which the solid is "
        "looked for; the run began again without it: the solid, if there is one, is a sketch."
        " A fault of ours: report it with the sheet",
        Code.SOLID_WAY_LEFT_OUT,
    ),
    row(
        "the sheet was photographed at a slant: it was straightened by its level and upright "
        "lines, and its width by its circles or its paper; all places are given in px of the "
        "straightened picture, which `gaussiancad read` writes as `sheet.png`, and no bound "
        "is stated for the measures. Where neither circles nor paper give the width, it may "
        "be some per cent off: scan the sheet, or pass a length",
        Code.PHOTOGRAPHED_AT_A_SLANT,
    ),
    row(
        "a section, a detail, an auxiliary, half, broken or partial view, another part, or a "
        "group of lines as large as a view, was not used; `unused` in `report.json` has their"
        " boxes. What it shows may be missing",
        Code.UNUSED_VIEW,
    ),
    row(
        "lines run from edge to edge of a view in another pen than the part's and were not "
        "used: tangent or thin edges, or annotation; what they show may be missing",
        Code.OTHER_PEN_LINES,
    ),
    row(
        "no scale gives two lengths that were given between points of the sheet; the last one "
        "was taken",
        Code.TOLD_LENGTHS_DISAGREE,
    ),
    row(
        "corrections by hand point at strokes or views that are no longer there; they were "
        "left out: look at them again",
        Code.CORRECTIONS_UNMATCHED,
    ),
    row(
        "the solid rests on something that no line says; `assumptions` in `report.json` says "
        "what, and what else might be. No hidden line in any view is such a thing: nothing "
        "proves then that the part is solid inside",
        Code.ASSUMED,
    ),
    row(
        "the solid has long faces narrower than two pixels, which no view can show: they may "
        "be left between lines that belong together",
        Code.FACES_THIN,
    ),
    row(
        "the named lines of a picture may be edges of the part or annotation: they are orange"
        " on the canvas, and listed with what else they may be; say what they are",
        Code.LABELS_DOUBTFUL,
    ),
    row(
        "hidden lines no longer than a dash look like visible ones, where all lines are of "
        "one width: some are taken for the other kind, as the other views have it",
        Code.LINETYPES_RETOLD,
    ),
    row(
        "the projection symbol says one angle, the lines the other; pass `--projection`",
        Code.SYMBOL_CONTRADICTS_LINES,
    ),
    row(
        "the dimensions agree on another scale than the one that was given: it was taken, and "
        "their numbers were not used",
        Code.SCALE_CONTRADICTS_DIMENSIONS,
    ),
    row(
        "entities of a DXF that cannot be read, of kinds that may show the part, were left "
        "out: the message names kinds and counts",
        Code.ENTITIES_LEFT_OUT,
    ),
    row(
        "a drawing in free space, without paper, has lines around everything that were taken "
        "for a frame, as they hold a single view; a plate with a pocket looks the same",
        Code.FRAME_LEFT_OUT,
    ),
    row(
        "a note names another unit than the one in which the dimensions say the lengths that "
        "the file draws, in the unit that it states: the latter was taken",
        Code.UNIT_CONTRADICTS_NOTE,
    ),
    row(
        "numbers that the file has as text do not fit the scale of the others: wrong, or not "
        "drawn to scale",
        Code.DIMENSIONS_DISAGREE,
    ),
    row("only two directions of view", Code.TWO_VIEWS),
    row(
        "a section, or a view with one, stands for a view: what was cut away before it no "
        "line shows",
        Code.SECTION_USED,
    ),
    row(
        "a note speaks of more or fewer holes than the view has of that kind: all of them "
        "were taken to be meant",
        Code.NOTE_COUNT,
    ),
    row(
        "the sheet has one view; what a second would have shown follows from diameters or a "
        "thickness, noted or given, and was assumed",
        Code.SECOND_VIEW_ASSUMED,
    ),
    row(
        "a view is drawn without a piece of the part: its length is not as drawn; pass "
        "`--length` along another axis",
        Code.BROKEN_VIEW,
    ),
    row(
        "a view is drawn up to its centre line: what lies beyond it was taken as its mirror image",
        Code.HALF_VIEW,
    ),
)

ASSUMPTIONS = (
    row(
        "no hidden line is drawn: nothing lies inside that no view, section or note shows",
        Code.NOTHING_HIDDEN,
    ),
    row(
        "a hole goes through, as nothing tells its depth: holes of one diameter in a view "
        "together, `places` has their boxes",
        Code.HOLE_THROUGH,
    ),
    row(
        "a section without a cutting line cuts through the middle of the part",
        Code.SECTION_THROUGH_MIDDLE,
    ),
    row(
        "what a second view would have shown follows from diameters or a thickness",
        Code.SECOND_VIEW,
    ),
)

WARNINGS = (
    row(
        "the lines fit first and third angle: the message says which was taken; pass "
        "`--projection`",
        Code.PROJECTION_ASSUMED,
    ),
    row(
        "the named numbers, read from pixels, do not fit the scale of the others: misread, or"
        " not drawn to scale",
        Code.DIMENSIONS_DISAGREE,
    ),
    row(
        "the picture has more than 24 million pixels, or the drawing is on larger paper than "
        "A2, and was read at a lower resolution, for memory; the measures of a picture are "
        "known less well",
        Code.RESOLUTION_LOWERED,
    ),
    row(
        "the trained network that tells edges from annotation is missing or damaged: the "
        "picture was read by the widths of its lines and the sizes of its letters, which say"
        " much less; install the engine again",
        Code.LABELS_MISSING,
    ),
    row(
        "the extra `surface` is not installed, and no result was asked for: only the exact "
        'solid was made; `pip install "gaussiancad-core[surface]"`, or `--result solid`',
        Code.SURFACE_LEFT_OUT,
    ),
    row(
        "a vector sheet has no scale note that could be read: 1:1 was taken, or the size in "
        "the unit that a DXF states; pass `--length` if it is not",
        Code.FULL_SCALE_ASSUMED,
    ),
    row(
        "the dimensions of a DXF say another size than what it draws in the unit that it "
        "states, as where a view is drawn larger: the dimensions were taken",
        Code.SIZE_CONTRADICTS_UNIT,
    ),
    row(
        "the longest edge was made 100 mm; pass `--length` or `--mm-per-pixel`", Code.SCALE_ASSUMED
    ),
    row(
        "so many corrections by hand were taken; the result is checked by the sheet as corrected",
        Code.CORRECTED,
    ),
    row(
        "views differ in the part's extent along an axis, or in what lies between "
        "(`residuals_px`); the mean was taken",
        Code.VIEWS_DISAGREE,
    ),
    row(
        "the SVG refers to other files, which are never opened: what they hold is missing",
        Code.EXTERNAL_LEFT_OUT,
    ),
    row(
        "the SVG does not say how large its paper is, or the DXF not its unit: pass `--unit`,"
        " `--length` or `--mm-per-pixel`",
        Code.PAPER_SIZE_UNKNOWN,
    ),
    row(
        "entities of a DXF that cannot be read were left out, such as tables; none of them "
        "shows the part",
        Code.ENTITIES_LEFT_OUT,
    ),
    row(
        "a drawing in free space, without paper, has a frame around everything: around "
        "several views, with a table, or with the margins of a sheet; it is listed in "
        "`unused`",
        Code.FRAME_LEFT_OUT,
    ),
    row(
        "page 1 of a DXF shows no views that belong together, and one paper layout brings "
        "them together: that one was taken; pass `--page` if another is meant",
        Code.OTHER_PAGE_TAKEN,
    ),
    row(
        "the picture has another resolution across than down, as faxes have: it was "
        "resampled, and all places are given in px of that",
        Code.PIXELS_MADE_SQUARE,
    ),
    row(
        "a photograph or scan shows more than the paper, such as a table: that was left out",
        Code.SURROUNDINGS_LEFT_OUT,
    ),
    row(
        "groups of lines belong to no view, or lie far from all others; large ones are a reason, "
        "`unused-view`",
        Code.LINES_LEFT_OUT,
    ),
    row("an isometric or other pictorial view was left out", Code.PICTORIAL_LEFT_OUT),
    row(
        "there is a solid, but the Gaussians do not enclose a body, or the views no hull: there "
        "is no"
        " mesh in addition to it",
        Code.NO_SURFACE,
        Code.EMPTY_HULL,
    ),
    row(
        "the lines around the named views leave gaps; as the exact solid has all lines of the"
        " sheet, or its outline runs along the sheet's ink, the surface was made with its outline"
        " there",
        Code.OUTLINE_OF_SOLID,
    ),
    row(
        "the paper's recipe at full size takes an hour or more on a processor: `--preset "
        "draft`, `--scale-down N`, or a GPU",
        Code.TRAINING_TAKES_LONG,
    ),
    row(
        "`--resume` found a checkpoint of another sheet, other options or another version: "
        "the training began anew",
        Code.CHECKPOINT_IGNORED,
    ),
    row(
        "a thread symbol was taken off: the model has the plain cylinder that the wide lines show",
        Code.THREAD_LEFT_OUT,
    ),
)

CHECK = (
    row(
        "the solid's extents are not those of the views, in any position; or one of them is off "
        "by more than it can be misread",
        Code.EXTENTS_DIFFER,
    ),
    row("the solid is larger or smaller than the sheet's numbers say", Code.SIZE_DIFFERS),
    row("a view has a whole circle that the solid does not show", Code.CIRCLE_MISSING),
    row(
        "the solid has a visible edge where the sheet has neither a line nor ink",
        Code.EDGE_NOT_DRAWN,
    ),
    row("what a section hatches is not what the solid has cut there", Code.SECTION_DIFFERS),
    row(
        "holes are not as their note says: another depth, another width, or fewer than it counts",
        Code.NOTE_NOT_KEPT,
    ),
    row(
        "views are shaded pictures in place of lines, which are read too poorly to say that the "
        "model differs",
        Code.SHADED_VIEWS,
    ),
    row(
        "a single change of the solid, which the message tells, explains the sheet better",
        Code.EXPLAINED_BETTER,
    ),
)

COMPARISON = (
    row(
        "a mirror image of the result fits clearly better; it is measured as it is",
        Code.RESULT_MIRRORED,
    ),
    row(
        "the result's measures are the reference's times a ratio of units: the message tells "
        "the `--factor` that corrects it",
        Code.UNIT_MISMATCH,
    ),
    row(
        "a model is not closed: no volume, no signs, and its volume IoU is estimated or missing",
        Code.MODEL_OPEN,
    ),
    row(
        "OpenCASCADE's check refuses a solid: its volume and Booleans may be wrong",
        Code.SOLID_INVALID,
    ),
    row(
        "a STEP or BREP file holds surfaces that do not close up to a solid; they are "
        "measured as an open model",
        Code.SURFACES_ONLY,
    ),
    row(
        "it holds no solid, but its surfaces close up when they are sewn: they are measured "
        "as a solid",
        Code.SURFACES_SEWN,
    ),
    row("it holds faces outside of its solids, which are not measured", Code.SURFACES_LEFT_OUT),
    row(
        "its solids touch or overlap: they are measured as one body, without the faces "
        "between them",
        Code.SOLIDS_UNITED,
    ),
    row("a model is closed but flat", Code.NO_VOLUME),
    row("the numbers of bodies, through holes or cavities differ", Code.TOPOLOGY_DIFFERS),
)
