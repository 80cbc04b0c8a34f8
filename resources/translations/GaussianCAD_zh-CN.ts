<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Colour of the deviation at each point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation at each point in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The object that was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The object that it was measured against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The comparison as a page for a browser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The result, coloured by its deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it was measured against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file that was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file it was measured against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The result when it was compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reference when it was compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The engine&apos;s report as it wrote it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version of these properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether an object changed since it was compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether to compare again when an object changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation at the ends of the colour scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What two samples of the reference give</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sum of the mean distances to the nearest point, both ways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance to the nearest point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean distance of points matched one to one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean distance to the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Common volume over united volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was corrected by hand, as JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the engine read on the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The corrections that the part follows from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is hidden when a window first shows the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the part was checked on the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the faces are exact, not triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the lines that agree with the drawing&apos;s, 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The projection under which the drawing was read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing with the part&apos;s own lines over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the drawing was when it was read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing, stored in this document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the engine was asked to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verified, approximate or failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why the part is not verified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bound that 95 % of the faces&apos; places keep; 0 if it is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the engine warns of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First or third angle, and how that is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale of the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the scale is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where each view is on the drawing, in pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the drawing&apos;s lines found, and of the part&apos;s lines right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration of each stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Versions, device, seed and hash of the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which of the solutions was kept by hand</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GaussianCAD</name>
    <message>
        <source>Hole Goes Through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of Hole…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all like this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Erase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centre line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tangent edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ignore Area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick from Ink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting Plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>detail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auxiliary view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pictorial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines of the Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other Lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers and Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting Planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems and Disagreements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to see the place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The engine broke off: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part lacks a line of {0} mm here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part has a line of {0} mm here that the sheet has not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These lines contradict each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assumed: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes, Through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No, so Deep…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures to ±{0} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verified: the part has the sheet&apos;s lines, no others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approximate: check the part against the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No part follows from the sheet as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sheet is read…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The corrections beside the sheet are of another version of it: they were left out, and will be kept as a file of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} correction(s) by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box a View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tell a Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the Plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other Projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the part…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length between the two points in mm:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What “{0}” gives, in mm:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of the hole in mm:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no line of a view at this place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Third angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solve as I Go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the part (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No Python from 3.11 to 3.14 with its venv module was found. Install one (on Debian: apt-get install python3-venv), then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The installation was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{step} failed: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for the small build of PyTorch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linking the engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking the engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compiling the engine&apos;s kernels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Downloading and installing packages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>named by the environment variable GAUSSIANCAD_PYTHON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>named in the preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>installed by GaussianCAD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found beside the addon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The GaussianCAD engine is not installed. Choose GaussianCAD &gt; Install Engine, or name the engine&apos;s Python in Edit &gt; Preferences &gt; GaussianCAD.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GAUSSIANCAD_PYTHON names {path}, which is not a program that can be run. Correct the variable or unset it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preferences name {path} as the engine&apos;s Python, which is not a program that can be run. Correct it in Edit &gt; Preferences &gt; GaussianCAD.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The engine&apos;s report {path} cannot be read ({reason}). Run it again; if that does not help, choose GaussianCAD &gt; Check Engine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A mirror image of the result fits better. Check the projection and the views.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The result is {ratio} times as large as the reference: their units differ. Scale the result by {factor} to have it in millimetres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not closed: {model} (open edges: {count}). Its volume is not certain, and distances from it have no sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD&apos;s geometry check refuses this solid: {model}. Its volume may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only surfaces that do not close up to a solid: {model}. Its volume is not certain, and distances from it have no sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces without a solid: {model}. Sewn together they are closed, and are measured as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces beside the solids are not measured: {model} (faces: {count}). Remove them, or make solids of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solids that touch or overlap are measured as one body, without the faces between them: {model} (solids: {count}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closed, but without a volume: {model}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result: bodies {result_bodies}, through holes {result_holes}, cavities {result_cavities}. Reference: bodies {reference_bodies}, through holes {reference_holes}, cavities {reference_cavities}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The models cannot be compared: one is damaged. Export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no model. Choose a STEP, BREP, STL, PLY or OBJ file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model&apos;s file is damaged, or of another format. Export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds no solid and no surfaces. Export a solid or its faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model has no surface. Export it with its faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is points without faces. Make a surface of them first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model&apos;s file is cut off or damaged. Export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model&apos;s file is too large. Export it with fewer triangles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is too small, or too far from the origin, to be measured. Export it in millimetres, near the origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The models differ too much in size to be compared. Check that these are the right ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The earth mover&apos;s distance could not be computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No exact solid was found. The model is a surface that fills what the outlines leave: measure nothing from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The exact solid that fits best has only {percent} % of the drawing&apos;s lines and was not kept. Check in Correct Sheet whether the lines were read right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No exact solid was found. This one fills what the outlines and the through holes leave: pockets and blind holes are missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lines of the views contradict each other, so that no solid has them all. Check in Correct Sheet whether a line was read wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines contradict each other as they were read. They are marked on the sheet: correct or erase the wrong one in Correct Sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What fits the lines best does not close up to a solid: lines are missing or wrong. Check them in Correct Sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has too many lines for an exact solid. Draw fewer of them on one sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solid is not one valid closed body.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} different solids have the lines of this drawing. Choose the one that is meant with Choose among Solutions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The views fit different solids in first and in third angle. Choose the angle under Projection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The search for solids with these lines was not completed: there may be others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The search for solids took much longer than usual and was ended. Close other programs and run the drawing again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The views may fit a solid in the other projection as well. Choose first or third angle under Projection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has more lines than can be understood together. Draw fewer of them on one sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part does not have all lines of the drawing, or it has others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part lacks lines of the drawing; the longest one, of {length_mm} mm, is in the view “{view}”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part has lines that the drawing does not show; the longest one, of {length_mm} mm, is in the view “{view}”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface does not have all lines of these views, or it has others: {views}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines that nearly meet were taken to meet: small steps may be missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the view “{view}” the drawn line lies {distance_mm} mm beside the part&apos;s: a curve may have been misread there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A line of the drawing lies {distance_mm} mm beside the part&apos;s: a small step may be missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The views and the part differ by up to {distance_mm} mm in size: a small step may be missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not used: {kind}. What it shows of the part may be missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Groups of lines belong to no view and are large enough to be one ({count}). Box them as views in Correct Sheet if they show the part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines that cross a view in another line width were not used ({count}). If they are edges of the part, make them visible lines in Correct Sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrections that no longer find what they corrected: {count}. Look at them again in Correct Sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No view has a hidden line. It was assumed that nothing lies inside the part that no view shows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These views have no hidden line: {views}. It was assumed that none was left out; otherwise another solid fits as well, see Choose among Solutions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solid has long faces too narrow for any view to show: lines that belong together may have been read apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden lines as short as a dash look like visible ones. Some were taken for the other kind, as the other views have it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The projection symbol says {symbol}, but the lines fit {other} better. Taken was {taken}; choose under Projection if it is the other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing&apos;s dimensions agree on {sheet} mm per pixel, but the scale that was set gives {told}. The dimensions were not used: check what is set under Scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has only two directions of view: what a third would show is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Used as a view: {kind}. What was cut away in front of the cut is shown by no line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The note “{note}” speaks of {count} holes, and the view “{view}” has {found} of that kind: the note was taken for all of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has one view; what a second would show was assumed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has one view with diameters across its axis: a turned part was assumed. If it is none, another view is needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has one view and a thickness: it was assumed that the part is of that thickness everywhere and that what is drawn inside goes through.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A view is broken, so that its length is not as drawn. Set a length along another axis under Scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A view is drawn up to its centre line: what lies beyond was taken as its mirror image.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hole of {diameter_mm} mm in the view “{view}” was taken to go through, as nothing tells its depth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section {label} was taken to cut through the middle of the part, as it has no cutting line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A section without a title was taken to cut through the middle of the part, as it has no cutting line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are bores, pockets or cavities that only hidden lines would show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It ends inside: give its depth in a note, or draw its hidden lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cuts elsewhere: draw its cutting line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is another part with the same view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lines fit both {taken} and {other}. Taken was {taken}; choose under Projection if it is the other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimensions do not fit the scale of the others ({numbers}): they were misread, or the drawing is not to scale there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sheet is so large that it was read at a lower resolution: measures are known less well. Cut out the views to have them read as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dimensions on the sheet were not read, as the engine has no text recognition. Set a length under Scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sheet has no readable scale: 1:1 was assumed. Set a length under Scale if it is another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scale is not known: the longest edge was made 100 mm. Set a length under Scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrections by hand that were taken: {count}. The result is checked by the sheet as corrected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The views differ by {spread_mm} mm in the part&apos;s extent along {axis}: the mean was taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SVG refers to other files, which are never opened: what they hold is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not say how large its paper is. Set a length under Scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Groups of lines belong to no view and were left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A pictorial view was left out: it illustrates what the other views show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outlines of these views have gaps: {views}. The surface was made with the exact solid&apos;s outline there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On a processor this takes an hour or more. Choose the quality Draft or smaller images, or use a graphics card.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The interrupted run in the folder belongs to another drawing, other settings or another version: the training began anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thread symbols were left out: the model has plain cylinders there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such file: {path}. Choose it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is no file. Choose a drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} cannot be opened. Check that you may read it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be read. Check that you may read it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is empty. Export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF, whatever its name says. Export the drawing as one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is damaged. Export or scan the drawing again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no PDF, or is damaged. Export the drawing again, or as PNG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no SVG, or is damaged. Export the drawing again, or as PNG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no DXF, or is damaged. Export the drawing again, or as PNG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was read of the sheet is damaged, or of another version. Open the drawing in Correct Sheet again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The corrections in {path} are damaged, or of another version. Remove that file, or mend it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PDF is protected by a password. Save it without one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SVG declares XML entities, which are never expanded. Save it as plain SVG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that the SVG shows lies in other files, which are never opened. Embed it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page has no lines. Choose another page or file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has {count} pages, at most {most} are read. Save the sheet in a file by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no page {page}: the last page of the file is page {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is too large: at most {most} million pixels are read. Export or scan it at a lower resolution, or on smaller paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture has only {width} × {height} pixels. Export the drawing with 1920 × 1080 or more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{format} files are not read. Save the drawing as PDF, SVG, DXF or PNG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds no Gaussians that can be read. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct Sheet needs PySide6 in the engine&apos;s environment. Open it from FreeCAD instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run left no report. Run it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run&apos;s report is damaged. Run it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run&apos;s report is of another version. Run it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sheet is blank: there are no lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This does not look like a line drawing. Use an export or a scan of the drawing, not a photograph.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No view of a part was found. Box the views in Correct Sheet and say which is which.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only one view was found. A part follows from two views, or from one with diameters across its axis or with a thickness. Box the views in Correct Sheet if there are more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The views do not line up with each other. Box them in Correct Sheet and say which is which.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view “{view}” has no visible line. Draw its edges in Correct Sheet, or say that the box is another view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The views show nothing of the {axis} axis. Two views at right angles are needed: box them in Correct Sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The views differ by {percent} % in the part&apos;s extent along {axis} ({views}). Check that they show one part at one scale, or box them in Correct Sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline of the view “{view}” is not closed. Draw what is missing of its visible edges in Correct Sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edges of the view “{view}” run together to one line. Export the drawing with more pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outlines of the views have no body in common, so that there is no surface. Check which view is which, and the projection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Gaussians bound no body, so that there is no surface of them. Choose a finer quality, or check that the views belong together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no lines in the box of the view “{view}”. Draw it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two boxes are named “{view}”. Give one of them another name in Correct Sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has changed since it was read. Open it in Correct Sheet again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The corrections in {path} belong to another drawing, or to an earlier version of it. Remove that file, or correct the drawing again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory. Choose the quality Draft or a smaller file, or export a vector drawing as PNG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing has more lines and other elements than can be read ({most}). Save only the views, or export it as PNG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has more than {most} MB. Save only the views, or export the drawing as PNG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing was not read after {seconds} s. Save only the views, or export it as PNG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It took longer than is allowed, and was ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no space left on the disk. Free some, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {path} cannot be written to. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics card cannot be used. GaussianCAD &gt; Check Engine shows what is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The engine is incomplete. Choose GaussianCAD &gt; Check Engine to see what to do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface cannot be simplified to a closed one. Choose a finer quality.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface does not become a valid solid: only its mesh can be used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solid cannot be saved as STEP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape verified.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape not certain: check the part against the drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed: no part follows from this drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the sheet&apos;s numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the sheet&apos;s numbers and the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures to ±{bound} mm ({source}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the sheet&apos;s resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from a dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>assumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale: {scale} mm per pixel ({source})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time: {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>visible lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hidden lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{lines} {recall} found, {precision} right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid: {faces} faces, {volume} mm³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface of the Gaussians: {triangles} triangles, {volume} mm³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hull on which the Gaussians started is nearer to the drawing&apos;s outlines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The GaussianCAD engine could not be started with {python}: {reason}. Choose GaussianCAD &gt; Check Engine to see what to do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The GaussianCAD engine at {python} does not work: {reason}. Choose GaussianCAD &gt; Check Engine to see what to do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The GaussianCAD engine stopped with code {code}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The GaussianCAD engine was ended from outside, or ran out of memory. Close other programs or choose a simpler preset, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finding the views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading the lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bringing the views together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finding the solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>carving the outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>training the Gaussians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>making the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checking against the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing the files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>broken-out section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pictorial view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>enlarged detail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>views of another part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>broken view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thread symbol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>group of lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>third angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} cannot be written for the comparison: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparison of {result} with {reference}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The engine&apos;s file {path} cannot be read ({reason}). Run it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open Drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing was not read yet. Wait until it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct Drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture of {name} is missing. Choose the drawing&apos;s file instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The engine made no model of {sheet}: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reconstruct from Drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part (not there yet)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reconstruction of {name}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View {role}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alternative {number}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part (faceted, approximate)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part (outlines only, approximate)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part (approximate)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The comparison is out of date: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solutions are not in the document any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep Solution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file {path}. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page {name} shows no views of a part. Recompute it, or choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check Engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Install Engine…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine: {engine}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking the engine…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GaussianCAD looked in these places, in this order:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preferences: {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To install the engine, press Install Engine, or run in a terminal: make -C &apos;{folder}&apos; install</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose two different objects to compare.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An object was removed while it was being compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document was closed. Open it and compare again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to compare. Open a document with a result and a reference: a part, a body or a mesh each, or choose a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface by its deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume, mm³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area, mm²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of the Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page for a browser (*.html)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours to ±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh and Gaussians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a Drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values are in units: the longest edge of the reference is 5. The floor is what two samples of the reference itself give.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{distance}: {length} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean deviation; negative lies inside the other model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square of the deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inside, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The farthest that it lies inside the other model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outside, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The farthest that it lies outside the other model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Agrees, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface within the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much the result&apos;s volume differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much the result&apos;s area differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chamfer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sum of the mean distances to the nearest point, both ways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hausdorff</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance to the nearest point, either way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earth mover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean distance of points matched one to one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean distance of the points to the other surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume IoU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Common volume over united volume; 1 is perfect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the Document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes a TechDraw page or an image of the active document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document has no TechDraw pages and no images</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adding the result to the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The result cannot be added to the document: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh and Gaussians of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drawing is no longer in the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Install Engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Download and Install</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The engine is installed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GaussianCAD can download the packages of its engine from the Python package index that pip is set up for: 0.7 GB, or 3.3 GB with PyTorch for NVIDIA cards. Each package is checked against a hash that comes with this addon. They go into {folder} (up to 7 GB on disk); FreeCAD&apos;s own Python stays as it is. Nothing is sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GaussianCAD Jobs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Job</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting the engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage {index} of {count}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model to Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models ({patterns})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part stays in the document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose among {count} Solutions…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a drawing first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file {path}. Choose another drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage {index} of {count}: {name}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elapsed {time}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this stage needs about {time} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temporary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the engine&apos;s files in a folder named after the drawing. If empty, they are removed once the document holds the result.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the Engine&apos;s Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tells how the views are arranged: third angle has the top view above the front view, first angle below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trades time for detail of the surface and effort of the search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid and surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chooses the exact solid, the mesh from trained Gaussians, or both of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel, as drawings are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective, as in the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chooses the cameras that train the Gaussians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown or on the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length along X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length along Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length along Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres per pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tells how large the part is. X runs along the front view&apos;s width, Z up its height, Y into depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop a drawing here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No preview of {name} here; the engine shows it when it is done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the lines, the drawing&apos;s and the solid&apos;s, that agree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep This One</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number} of {count}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose among Solutions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size: {x} × {y} × {z} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read in first angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read in third angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simplest of them, and the result so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} different solids have the lines of this drawing. Keep the one that is meant; the others are removed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why there is doubt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orange: {volume} mm³ more than solution 1, {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magenta: {volume} mm³ less than solution 1, {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within X {x}, Y {y}, Z {z} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Divides the edges of the images that train the Gaussians. 1 / 1 is the size in the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{width} x {height} px, about {minutes} min on a processor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens a dialog to choose from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too little</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too much</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the result has too little</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>material is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the result has too much</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GaussianCAD</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GaussianCADPreferences</name>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Python of the engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names the Python in whose environment the engine is installed. If empty, GaussianCAD looks for its own environment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If this is empty, GaussianCAD uses the environment that it installed itself, then the folder .venv beside the addon. GaussianCAD &gt; Check Engine shows which one was found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New Reconstructions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Third angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the engine&apos;s files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the engine&apos;s files in a folder for each run. If empty, they are removed once the document holds the result.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GaussianCAD_CheckEngine</name>
    <message>
        <source>Check Engine…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows where the engine is, what it lacks and what to do about it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Compare</name>
    <message>
        <source>Compare with Reference…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures how far a part or mesh is from another one and colours the difference</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Correct</name>
    <message>
        <source>Correct Sheet…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what was understood of a drawing, lets it be corrected, and makes the part</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GaussianCAD_InstallEngine</name>
    <message>
        <source>Install Engine…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Downloads and installs the engine into an environment of its own</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Reconstruct</name>
    <message>
        <source>Reconstruct from Drawing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Creates a 3D part from a drawing with two or more views</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Solutions</name>
    <message>
        <source>Choose among Solutions…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flips through the solids that all have the drawing&apos;s lines and keeps one</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Turns drawings with three views into 3D parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GaussianCAD</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
