"""What to do about errors, and the exit code that the command ends with."""

from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.explained import row

FILES = (
    row(
        "`compare`, `draw`: a model breaks the library that reads, measures or draws it: "
        "export it again",
        Code.DAMAGED_MODEL,
        exit_code=3,
    ),
    row("check the name", Code.FILE_MISSING, exit_code=3),
    row("a folder or a device was named: name a file", Code.NOT_A_FILE, exit_code=3),
    row("check the file's permissions", Code.FILE_UNREADABLE, Code.FILE_NOT_READABLE, exit_code=3),
    row("export the drawing again", Code.EMPTY_FILE, exit_code=3),
    row(
        "the file is no PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF, whatever its name says: "
        "export it as one of them",
        Code.NOT_AN_IMAGE,
        exit_code=3,
    ),
    row(
        "the file ends too early or is broken: export or scan it again",
        Code.DAMAGED_IMAGE,
        exit_code=3,
    ),
    row(
        "the file cannot be parsed or drawn: export it again, or as PNG",
        Code.DAMAGED_PDF,
        Code.DAMAGED_SVG,
        Code.DAMAGED_DXF,
        exit_code=3,
    ),
    row(
        "the file is no `reading.json`, or no `corrections.json`, of this version; the "
        "message names the place",
        Code.READING_NOT_READ,
        Code.CORRECTIONS_NOT_READ,
        exit_code=3,
    ),
    row(
        "the file is no `report.csv` or `report.json` of a batch", Code.BATCH_NOT_READ, exit_code=3
    ),
    row(
        "`gaussiancad explain` needs the output folder of a run, of this version: run the "
        "sheet again",
        Code.NO_REPORT,
        Code.DAMAGED_REPORT,
        Code.OLD_REPORT,
        exit_code=3,
    ),
    row("the PDF asks for a password: save it without one", Code.ENCRYPTED_PDF, exit_code=3),
    row(
        "the SVG declares XML entities, which are never expanded: save it as plain SVG",
        Code.SVG_ENTITIES,
        exit_code=3,
    ),
    row(
        "all that the SVG shows lies in other files, which are never opened: embed it",
        Code.EXTERNAL_CONTENT,
        exit_code=3,
    ),
    row("the page has no lines: choose another page or file", Code.EMPTY_DRAWING, exit_code=3),
    row(
        "more than 1000 pages: save the sheet in a file by itself", Code.TOO_MANY_PAGES, exit_code=3
    ),
    row(
        "more than 150 million pixels, vector sheets at 200 dpi: lower the resolution, or "
        "take smaller paper",
        Code.IMAGE_TOO_LARGE,
        exit_code=3,
    ),
    row("under 64 px: export at 1920 x 1080 px or more", Code.IMAGE_TOO_SMALL, exit_code=3),
    row(
        "a FreeCAD document is no drawing: export its TechDraw page as PDF or SVG, or "
        "reconstruct the page in FreeCAD",
        Code.FREECAD_DOCUMENT,
        exit_code=3,
    ),
    row(
        "DWG, PostScript, GIF, HEIC and others are not read: the message says what to save instead",
        Code.FORMAT_NOT_SUPPORTED,
        exit_code=3,
    ),
    row("the file has fewer pages", Code.PAGE_MISSING, exit_code=3),
    row("take STEP, BREP, STL, PLY or OBJ", Code.MODEL_FORMAT_UNKNOWN, exit_code=3),
    row(
        "the model holds no surface or solid that can be compared or drawn",
        Code.NOT_A_MODEL,
        Code.NOT_A_SOLID,
        Code.EMPTY_MODEL,
        Code.POINT_CLOUD,
        Code.FILE_DAMAGED,
        Code.FILE_TOO_LARGE,
        exit_code=3,
    ),
    row(
        "a model to compare is smaller than 1e-6 mm, or has coordinates beyond 1e8 mm",
        Code.SIZE_OUT_OF_RANGE,
        exit_code=3,
    ),
)

VIEWS = (
    row("there are no lines", Code.BLANK_SHEET, exit_code=4),
    row(
        "too much of the sheet is dark: use an export or a scan, not a photograph",
        Code.NOT_A_LINE_DRAWING,
        exit_code=4,
    ),
    row(
        "two orthogonal views are needed at least, or one with diameters across its axis, or "
        "with a thickness and a scale; `axis` among the values is the one that the view does "
        "not show",
        Code.NO_VIEWS,
        Code.ONE_VIEW,
        exit_code=4,
    ),
    row(
        "the sheet shows the part in an isometric or other pictorial view alone: add or "
        "export views at right angles",
        Code.PICTORIAL_ALONE,
        exit_code=4,
    ),
    row(
        "no view has aligned neighbours: name them with `--view ROLE=X0,Y0,X1,Y1`",
        Code.VIEWS_NOT_ALIGNED,
        exit_code=4,
    ),
    row(
        "a view of the reading has strokes and no visible one is left: draw its edges, or "
        "give it another role",
        Code.EMPTY_VIEW,
        exit_code=4,
    ),
    row("the views show nothing of one axis", Code.VIEWS_PARALLEL, exit_code=4),
    row(
        "views differ by more than a tenth along an axis: check their scale, or name them",
        Code.VIEWS_CONTRADICT,
        exit_code=4,
    ),
    row(
        "by its scale the part is under a thousandth of a millimetre or over a kilometre "
        "long: pass its size with `--length AXIS=MM`",
        Code.SIZE_OUT_OF_RANGE,
        exit_code=4,
    ),
    row(
        "draw the visible edges of the named view without gaps, or export the sheet with more"
        " pixels where they are one line",
        Code.OPEN_OUTLINE,
        exit_code=4,
    ),
    row(
        "the views have no part in common: check which is which, and the projection",
        Code.EMPTY_HULL,
        Code.NO_SURFACE,
        exit_code=4,
    ),
    row(
        "a view has more than 3000 lines, in a picture more than 1500, or the lines of a "
        "picture cross each other everywhere, or are in more than 15,000 pieces: draw less in"
        " one sheet",
        Code.PART_TOO_COMPLEX,
        exit_code=4,
    ),
    row(
        "`--result solid` was asked for, and there is none, nor a sketch: see the reasons "
        "above, or ask for `--result both`",
        Code.NO_EXACT_SOLID,
        Code.NO_SOLID_FITS,
        Code.NO_VALID_SOLID,
        Code.PART_TOO_COMPLEX,
        exit_code=4,
    ),
)

LIMITS = (
    row(
        "the file was made for another sheet, page, or version of it: read that sheet with "
        "`gaussiancad read`",
        Code.READING_OF_ANOTHER_SHEET,
        Code.CORRECTIONS_OF_ANOTHER_SHEET,
        exit_code=2,
    ),
    row(
        "`serve` or `mcp` was asked something that it does not know",
        Code.UNKNOWN_REQUEST,
        exit_code=2,
    ),
    row("a reading gives two views one role", Code.ROLE_REPEATED, exit_code=2),
    row(
        "`gaussiancad explain --view`: the sheet has no view of that role",
        Code.UNKNOWN_VIEW,
        exit_code=2,
    ),
    row(
        "`--page all` together with `--reading` or `--corrections`: name the page that these "
        "speak of",
        Code.ONE_PAGE_ONLY,
        exit_code=2,
    ),
    row("an option or its value is not known: see `--help`", Code.WRONG_USAGE, exit_code=2),
    row("choose another output folder", Code.OUTPUT_NOT_WRITABLE, exit_code=2),
    row(
        "`batch`: name files, folders with drawings, or a CSV table with a column `sheet`; "
        "the message names the line",
        Code.NO_SHEETS,
        Code.TABLE_UNREADABLE,
        exit_code=2,
    ),
    row(
        "a link lies where a batch writes: remove it; nothing is written outside of its folder",
        Code.OUTPUT_IS_LINK,
        exit_code=2,
    ),
    row(
        "another batch writes to the folder: wait for it, or choose another `--output`",
        Code.BATCH_RUNNING,
        exit_code=2,
    ),
    row("correct `--view`", Code.EMPTY_VIEW_BOX, Code.VIEW_REPEATED, exit_code=2),
    row("`--length` names an axis twice: once is enough", Code.LENGTH_REPEATED, exit_code=2),
    row(
        "correct `--views` of `draw`",
        Code.VIEWS_COUNT,
        Code.VIEWS_REPEAT,
        Code.VIEWS_NOT_ORTHOGONAL,
        exit_code=2,
    ),
    row(
        "correct `--style` or the sheet's name",
        Code.STYLE_UNKNOWN,
        Code.STYLE_KEY_UNKNOWN,
        Code.STYLE_VALUE_BAD,
        Code.SHEET_TOO_SMALL,
        Code.SHEET_SUFFIX_UNKNOWN,
        exit_code=2,
    ),
    row(
        "the models to compare differ in length by more than 1e7: give `--factor`, or the "
        "right files",
        Code.SIZES_TOO_DIFFERENT,
        exit_code=2,
    ),
    row(
        "correct the option that the message names",
        Code.POINTS_OUT_OF_RANGE,
        Code.SEED_NEGATIVE,
        Code.FACTOR_NOT_POSITIVE,
        Code.TOLERANCE_NOT_POSITIVE,
        exit_code=2,
    ),
    row(
        "the protocol `deepcad` neither registers nor keeps the scale: leave out `--register`"
        " and `--scale`",
        Code.PROTOCOL_HAS_NO_REGISTRATION,
        exit_code=2,
    ),
    row(
        "no Dask scheduler answers at the address: start one, or check the address",
        Code.SCHEDULER_UNREACHABLE,
        exit_code=2,
    ),
    row("start workers, with this engine installed", Code.SCHEDULER_WITHOUT_WORKERS, exit_code=2),
    row(
        "a worker has another engine or other packages for it: install the same lock everywhere",
        Code.SCHEDULER_DIFFERS,
        exit_code=2,
    ),
    row(
        "a worker does not see the output folder: use one that all machines have under one name",
        Code.FOLDER_NOT_SHARED,
        exit_code=2,
    ),
    row(
        "the machines that worked on a sheet were lost, several times: look at their logs, or"
        " the sheet is to blame",
        Code.WORKER_LOST,
        exit_code=6,
    ),
    row(
        "use `--preset draft` or a smaller sheet; export a vector sheet as PNG",
        Code.OUT_OF_MEMORY,
        exit_code=5,
    ),
    row(
        "a vector sheet has more than 100,000 lines and other elements: save only the views, "
        "or export it as PNG; or a reading more than 20,000 strokes, or a person made more "
        "than 2,000 corrections, or a table of a batch has more than 50,000 lines",
        Code.TOO_MANY_ELEMENTS,
        exit_code=5,
    ),
    row(
        "a sheet of a batch, or a comparison, took longer than `--seconds`, or the search for"
        " the solid more than 15 minutes of the processor in each of its ways; "
        "the code is `out-of-memory` where it takes more than `--memory`",
        Code.TAKES_TOO_LONG,
        exit_code=5,
    ),
    row(
        "an SVG has more than 64 MB, or a DXF more than 256 MB: save only the views, or "
        "export it as PNG",
        Code.DRAWING_FILE_TOO_LARGE,
        exit_code=5,
    ),
    row(
        "a vector sheet is not read after 60 s: save only the views, or export it as PNG",
        Code.READING_TAKES_TOO_LONG,
        exit_code=5,
    ),
    row(
        "the output folder holds files of the same names that no run made: choose another, or"
        " `--overwrite`",
        Code.FOREIGN_FILES,
        exit_code=2,
    ),
    row(
        "the system refuses the file or folder, as for a name that is too long: choose another",
        Code.PATH_NOT_USABLE,
        exit_code=2,
    ),
    row(
        "`gaussiancad mcp`: the server works inside one folder: name files in it, or start it with "
        "another `--folder`",
        Code.OUTSIDE_FOLDER,
        exit_code=2,
    ),
    row(
        "`gaussiancad mcp`: what was named is not kept, or no longer: read the sheet again, or "
        "list its strokes",
        Code.UNKNOWN_ID,
        exit_code=2,
    ),
    row("free some space", Code.DISK_FULL, exit_code=5),
    row(
        "the system lets the engine open no more files: raise that limit (`ulimit -n`), or "
        "close other programs",
        Code.TOO_MANY_OPEN_FILES,
        exit_code=5,
    ),
    row(
        "the GPU cannot be used: the message says why; or use `--device auto` or `cpu`",
        Code.CUDA_UNAVAILABLE,
        exit_code=6,
    ),
    row(
        "a library ended the engine, a fault of ours: report it with the sheet; what was "
        "finished before is kept",
        Code.ENGINE_DIED,
        exit_code=6,
    ),
    row(
        "the system ended the engine, as where memory does not suffice: use `--preset draft` "
        "or a smaller sheet",
        Code.KILLED,
        exit_code=5,
    ),
    row(
        "a fault of the engine: report it with the file that the message names; it has no "
        "content of the drawing",
        Code.UNFORESEEN,
        exit_code=6,
    ),
    row(
        "what was asked for needs an extra of the package that is not installed, or not all "
        "of it: the message has the command that installs it",
        Code.EXTRA_MISSING,
        exit_code=6,
    ),
    row(
        "the engine runs in Python 3.11 or later: start it with a newer one",
        Code.PYTHON_TOO_OLD,
        exit_code=6,
    ),
    row("run `gaussiancad doctor`", Code.ENGINE_INCOMPLETE, exit_code=6),
    row(
        "a step of the geometry failed: report the sheet",
        Code.DECIMATION_FAILED,
        Code.FACETED_SOLID_FAILED,
        Code.STEP_NOT_WRITTEN,
        exit_code=6,
    ),
    row("the run was stopped; a solid that was final stays", Code.CANCELLED, exit_code=130),
    row(
        "`import gaussiancad`: this Python lacks the engine's libraries: install them, or name an "
        "interpreter that has them in `GAUSSIANCAD_PYTHON`",
        Code.ENGINE_MISSING,
        exit_code=6,
    ),
    row(
        "`import gaussiancad`: the engine ended without a word, or cannot be started: `gaussiancad "
        "doctor` says why",
        Code.ENGINE_BROKEN,
        exit_code=6,
    ),
    row(
        "`import gaussiancad`: a result without a solid or mesh was to be compared or drawn",
        Code.NO_MODEL_FILE,
        exit_code=3,
    ),
)
