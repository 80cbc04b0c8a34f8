<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Colour of the deviation at each point</source>
        <translation>Farbe der Abweichung an jedem Punkt</translation>
    </message>
    <message>
        <source>Sum of the mean distances to the nearest point, both ways</source>
        <translation>Summe der mittleren Abstände zum nächsten Punkt, in beiden Richtungen</translation>
    </message>
    <message>
        <source>Largest distance to the nearest point</source>
        <translation>Größter Abstand zum nächsten Punkt</translation>
    </message>
    <message>
        <source>Mean distance of points matched one to one</source>
        <translation>Mittlerer Abstand paarweise zugeordneter Punkte</translation>
    </message>
    <message>
        <source>Mean distance to the surface</source>
        <translation>Mittlerer Abstand zur Oberfläche</translation>
    </message>
    <message>
        <source>Common volume over united volume</source>
        <translation>Gemeinsames Volumen durch vereinigtes Volumen</translation>
    </message>
    <message>
        <source>Version of these properties</source>
        <translation>Version dieser Eigenschaften</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Was gemessen wurde</translation>
    </message>
    <message>
        <source>What it was measured against</source>
        <translation>Woran gemessen wurde</translation>
    </message>
    <message>
        <source>Deviation at the ends of the colour scale</source>
        <translation>Abweichung an den Enden der Farbskala</translation>
    </message>
    <message>
        <source>What two samples of the reference give</source>
        <translation>Was zwei Stichproben der Referenz ergeben</translation>
    </message>
    <message>
        <source>The engine&apos;s report as it wrote it</source>
        <translation>Der Bericht der Engine im Wortlaut</translation>
    </message>
    <message>
        <source>What is hidden when a window first shows the group</source>
        <translation>Was verborgen ist, wenn ein Fenster die Gruppe zum ersten Mal zeigt</translation>
    </message>
    <message>
        <source>Whether the part was checked on the drawing</source>
        <translation>Ob das Bauteil an der Zeichnung geprüft wurde</translation>
    </message>
    <message>
        <source>Whether the faces are exact, not triangles</source>
        <translation>Ob die Flächen exakt sind und keine Dreiecke</translation>
    </message>
    <message>
        <source>Where the drawing was when it was read</source>
        <translation>Wo die Zeichnung lag, als sie gelesen wurde</translation>
    </message>
    <message>
        <source>The drawing, stored in this document</source>
        <translation>Die Zeichnung, in diesem Dokument gespeichert</translation>
    </message>
    <message>
        <source>What the engine was asked to do</source>
        <translation>Womit die Engine beauftragt wurde</translation>
    </message>
    <message>
        <source>The drawing with the part&apos;s own lines over it</source>
        <translation>Die Zeichnung mit den Linien des Bauteils darüber</translation>
    </message>
    <message>
        <source>Verified, approximate or failed</source>
        <translation>Geprüft (verified), angenähert (approximate) oder gescheitert (failed)</translation>
    </message>
    <message>
        <source>Why the part is not verified</source>
        <translation>Warum das Bauteil nicht als geprüft gilt</translation>
    </message>
    <message>
        <source>What the engine warns of</source>
        <translation>Wovor die Engine warnt</translation>
    </message>
    <message>
        <source>First or third angle, and how that is known</source>
        <translation>Projektionsmethode 1 oder 3, und woher das bekannt ist</translation>
    </message>
    <message>
        <source>Scale of the drawing</source>
        <translation>Maßstab der Zeichnung</translation>
    </message>
    <message>
        <source>How the scale is known</source>
        <translation>Woher der Maßstab bekannt ist</translation>
    </message>
    <message>
        <source>Where each view is on the drawing, in pixels</source>
        <translation>Wo jede Ansicht auf der Zeichnung liegt, in Pixeln</translation>
    </message>
    <message>
        <source>Share of the drawing&apos;s lines found, and of the part&apos;s lines right</source>
        <translation>Anteil der gefundenen Linien der Zeichnung und der richtigen Linien des Bauteils</translation>
    </message>
    <message>
        <source>Duration of the run</source>
        <translation>Dauer des Laufs</translation>
    </message>
    <message>
        <source>Duration of each stage</source>
        <translation>Dauer jeder Stufe</translation>
    </message>
    <message>
        <source>Versions, device, seed and hash of the drawing</source>
        <translation>Versionen, Gerät, Startwert und Prüfsumme der Zeichnung</translation>
    </message>
    <message>
        <source>Which of the solutions was kept by hand</source>
        <translation>Welche der Lösungen von Hand behalten wurde</translation>
    </message>
    <message>
        <source>Share of the lines that agree with the drawing&apos;s, 0 to 1</source>
        <translation>Anteil der Linien, die mit denen der Zeichnung übereinstimmen, 0 bis 1</translation>
    </message>
    <message>
        <source>The projection under which the drawing was read</source>
        <translation>Die Projektion, unter der die Zeichnung gelesen wurde</translation>
    </message>
    <message>
        <source>Deviation at each point in mm</source>
        <translation>Abweichung an jedem Punkt in mm</translation>
    </message>
    <message>
        <source>The comparison as a page for a browser</source>
        <translation>Der Vergleich als Seite für einen Browser</translation>
    </message>
    <message>
        <source>The file it was measured against</source>
        <translation>Die Datei, an der gemessen wurde</translation>
    </message>
    <message>
        <source>The file that was measured</source>
        <translation>Die Datei, die gemessen wurde</translation>
    </message>
    <message>
        <source>The object that it was measured against</source>
        <translation>Das Objekt, an dem gemessen wurde</translation>
    </message>
    <message>
        <source>The object that was measured</source>
        <translation>Das Objekt, das gemessen wurde</translation>
    </message>
    <message>
        <source>The reference when it was compared</source>
        <translation>Die Referenz, als verglichen wurde</translation>
    </message>
    <message>
        <source>The result when it was compared</source>
        <translation>Das Ergebnis, als verglichen wurde</translation>
    </message>
    <message>
        <source>Whether an object changed since it was compared</source>
        <translation>Ob sich ein Objekt seit dem Vergleich geändert hat</translation>
    </message>
    <message>
        <source>Whether to compare again when an object changes</source>
        <translation>Ob neu verglichen wird, wenn sich ein Objekt ändert</translation>
    </message>
    <message>
        <source>The result, coloured by its deviation</source>
        <translation>Das Ergebnis in den Farben seiner Abweichung</translation>
    </message>
    <message>
        <source>Bound that 95 % of the faces&apos; places keep; 0 if it is not known</source>
        <translation>Grenze, die 95 % der Flächen in ihrer Lage einhalten; 0, wenn sie nicht bekannt ist</translation>
    </message>
</context>
<context>
    <name>GaussianCAD</name>
    <message>
        <source>{name} cannot be written for the comparison: {reason}</source>
        <translation>{name} kann für den Vergleich nicht geschrieben werden: {reason}</translation>
    </message>
    <message>
        <source>Compare with Reference</source>
        <translation>Mit Referenz vergleichen</translation>
    </message>
    <message>
        <source>Comparison of {result} with {reference}</source>
        <translation>Vergleich von {result} mit {reference}</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>The engine&apos;s file {path} cannot be read ({reason}). Run it again.</source>
        <translation>Die Datei {path} der Engine kann nicht gelesen werden ({reason}). Starten Sie den Lauf noch einmal.</translation>
    </message>
    <message>
        <source>The engine made no model of {sheet}: {reason}</source>
        <translation>Die Engine hat aus {sheet} kein Modell gemacht: {reason}</translation>
    </message>
    <message>
        <source>Reconstruct from Drawing</source>
        <translation>Aus Zeichnung rekonstruieren</translation>
    </message>
    <message>
        <source>Reconstruction of {name}</source>
        <translation>Rekonstruktion von {name}</translation>
    </message>
    <message>
        <source>Alternative {number}</source>
        <translation>Alternative {number}</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Gaussians</source>
        <translation>Gauß-Verteilungen</translation>
    </message>
    <message>
        <source>View {role}</source>
        <translation>Ansicht {role}</translation>
    </message>
    <message>
        <source>Part (faceted, approximate)</source>
        <translation>Bauteil (facettiert, angenähert)</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Bauteil</translation>
    </message>
    <message>
        <source>Part (approximate)</source>
        <translation>Bauteil (angenähert)</translation>
    </message>
    <message>
        <source>GaussianCAD</source>
        <translation>GaussianCAD</translation>
    </message>
    <message>
        <source>The engine&apos;s report {path} cannot be read ({reason}). Run it again; if that does not help, choose GaussianCAD &gt; Check Engine.</source>
        <translation>Der Bericht {path} der Engine kann nicht gelesen werden ({reason}). Starten Sie den Lauf noch einmal; hilft das nicht, wählen Sie GaussianCAD &gt; Engine prüfen.</translation>
    </message>
    <message>
        <source>named by the environment variable GAUSSIANCAD_PYTHON</source>
        <translation>genannt in der Umgebungsvariablen GAUSSIANCAD_PYTHON</translation>
    </message>
    <message>
        <source>named in the preferences</source>
        <translation>genannt in den Einstellungen</translation>
    </message>
    <message>
        <source>installed by GaussianCAD</source>
        <translation>von GaussianCAD installiert</translation>
    </message>
    <message>
        <source>found beside the addon</source>
        <translation>neben dem Addon gefunden</translation>
    </message>
    <message>
        <source>The GaussianCAD engine is not installed. Choose GaussianCAD &gt; Install Engine, or name the engine&apos;s Python in Edit &gt; Preferences &gt; GaussianCAD.</source>
        <translation>Die GaussianCAD-Engine ist nicht installiert. Wählen Sie GaussianCAD &gt; Engine installieren, oder nennen Sie das Python der Engine unter Bearbeiten &gt; Einstellungen &gt; GaussianCAD.</translation>
    </message>
    <message>
        <source>GAUSSIANCAD_PYTHON names {path}, which is not a program that can be run. Correct the variable or unset it.</source>
        <translation>GAUSSIANCAD_PYTHON nennt {path}; das ist kein ausführbares Programm. Berichtigen oder löschen Sie die Variable.</translation>
    </message>
    <message>
        <source>The preferences name {path} as the engine&apos;s Python, which is not a program that can be run. Correct it in Edit &gt; Preferences &gt; GaussianCAD.</source>
        <translation>Die Einstellungen nennen {path} als Python der Engine; das ist kein ausführbares Programm. Berichtigen Sie es unter Bearbeiten &gt; Einstellungen &gt; GaussianCAD.</translation>
    </message>
    <message>
        <source>The run was cancelled.</source>
        <translation>Der Lauf wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The GaussianCAD engine could not be started with {python}: {reason}. Choose GaussianCAD &gt; Check Engine to see what to do.</source>
        <translation>Die GaussianCAD-Engine konnte mit {python} nicht gestartet werden: {reason}. GaussianCAD &gt; Engine prüfen zeigt, was zu tun ist.</translation>
    </message>
    <message>
        <source>The GaussianCAD engine at {python} does not work: {reason}. Choose GaussianCAD &gt; Check Engine to see what to do.</source>
        <translation>Die GaussianCAD-Engine unter {python} arbeitet nicht: {reason}. GaussianCAD &gt; Engine prüfen zeigt, was zu tun ist.</translation>
    </message>
    <message>
        <source>The GaussianCAD engine stopped with code {code}.</source>
        <translation>Die GaussianCAD-Engine endete mit dem Code {code}.</translation>
    </message>
    <message>
        <source>The part stays in the document.</source>
        <translation>Das Teil bleibt im Dokument.</translation>
    </message>
    <message>
        <source>The hull on which the Gaussians started is nearer to the drawing&apos;s outlines.</source>
        <translation>Die Hülle, auf der die Gaußfunktionen begannen, kommt den Umrissen der Zeichnung näher.</translation>
    </message>
    <message>
        <source>The GaussianCAD engine was ended from outside, or ran out of memory. Close other programs or choose a simpler preset, then try again.</source>
        <translation>Die GaussianCAD-Engine wurde von außen beendet, oder der Speicher reichte nicht. Schließen Sie andere Programme oder wählen Sie eine einfachere Qualität, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Failed: no part follows from this drawing.</source>
        <translation>Gescheitert: Aus dieser Zeichnung folgt kein Bauteil.</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>sichtbar</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verdeckt</translation>
    </message>
    <message>
        <source>centre line</source>
        <translation>Mittellinie</translation>
    </message>
    <message>
        <source>tangent edge</source>
        <translation>Tangentenkante</translation>
    </message>
    <message>
        <source>dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>ignore</source>
        <translation>ignorieren</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Ignore Area</source>
        <translation>Bereich ignorieren</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>given</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>from the sheet&apos;s resolution</source>
        <translation>aus der Auflösung des Blatts</translation>
    </message>
    <message>
        <source>from a dimension</source>
        <translation>aus einem Maß</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>Scale: {scale} mm per pixel ({source})</source>
        <translation>Maßstab: {scale} mm je Pixel ({source})</translation>
    </message>
    <message>
        <source>Time: {seconds} s</source>
        <translation>Zeit: {seconds} s</translation>
    </message>
    <message>
        <source>visible lines</source>
        <translation>sichtbare Linien</translation>
    </message>
    <message>
        <source>hidden lines</source>
        <translation>verdeckte Linien</translation>
    </message>
    <message>
        <source>{lines} {recall} found, {precision} right</source>
        <translation>{lines} zu {recall} gefunden, zu {precision} richtig</translation>
    </message>
    <message>
        <source>Solid: {faces} faces, {volume} mm³</source>
        <translation>Festkörper: {faces} Flächen, {volume} mm³</translation>
    </message>
    <message>
        <source>Surface of the Gaussians: {triangles} triangles, {volume} mm³</source>
        <translation>Oberfläche der Gaußfunktionen: {triangles} Dreiecke, {volume} mm³</translation>
    </message>
    <message>
        <source>No Python from 3.11 to 3.14 with its venv module was found. Install one (on Debian: apt-get install python3-venv), then try again.</source>
        <translation>Kein Python von 3.11 bis 3.14 mit dem Modul venv gefunden. Installieren Sie eines (unter Debian: apt-get install python3-venv), und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Making the environment</source>
        <translation>Umgebung wird angelegt</translation>
    </message>
    <message>
        <source>The installation was cancelled.</source>
        <translation>Die Installation wurde abgebrochen.</translation>
    </message>
    <message>
        <source>{step} failed: {reason}</source>
        <translation>{step} ist gescheitert: {reason}</translation>
    </message>
    <message>
        <source>Looking for the small build of PyTorch</source>
        <translation>Kleine Fassung von PyTorch wird gesucht</translation>
    </message>
    <message>
        <source>Linking the engine</source>
        <translation>Engine wird verbunden</translation>
    </message>
    <message>
        <source>Checking the engine</source>
        <translation>Engine wird geprüft</translation>
    </message>
    <message>
        <source>Compiling the engine&apos;s kernels</source>
        <translation>Rechenkerne der Engine werden übersetzt</translation>
    </message>
    <message>
        <source>Downloading and installing packages</source>
        <translation>Pakete werden geladen und installiert</translation>
    </message>
    <message>
        <source>Install Engine</source>
        <translation>Engine installieren</translation>
    </message>
    <message>
        <source>Download and Install</source>
        <translation>Laden und installieren</translation>
    </message>
    <message>
        <source>The engine is installed.</source>
        <translation>Die Engine ist installiert.</translation>
    </message>
    <message>
        <source>GaussianCAD can download the packages of its engine from the Python package index that pip is set up for: 0.7 GB, or 3.3 GB with PyTorch for NVIDIA cards. Each package is checked against a hash that comes with this addon. They go into {folder} (up to 7 GB on disk); FreeCAD&apos;s own Python stays as it is. Nothing is sent.</source>
        <translation>GaussianCAD kann die Pakete seiner Engine aus dem Python-Paketverzeichnis laden, das für pip eingerichtet ist: 0,7 GB, oder 3,3 GB mit PyTorch für NVIDIA-Karten. Jedes Paket wird gegen eine Prüfsumme geprüft, die zu diesem Addon gehört. Sie kommen nach {folder} (bis zu 7 GB auf der Platte); FreeCADs eigenes Python bleibt, wie es ist. Gesendet wird nichts.</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Temporary</source>
        <translation>Vorübergehend</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>{0} correction(s), beside the sheet</source>
        <translation>{0} Korrektur(en), neben dem Blatt gespeichert</translation>
    </message>
    <message>
        <source>The engine is at work…</source>
        <translation>Die Engine arbeitet …</translation>
    </message>
    <message>
        <source>Click to see the place</source>
        <translation>Klicken, um die Stelle zu sehen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Length between the two points in mm:</source>
        <translation>Länge zwischen den zwei Punkten in mm:</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Keeps the engine&apos;s files in a folder named after the drawing. If empty, they are removed once the document holds the result.</source>
        <translation>Bewahrt die Dateien der Engine in einem Ordner auf, der nach der Zeichnung benannt ist. Ist das Feld leer, werden sie entfernt, sobald das Dokument das Ergebnis enthält.</translation>
    </message>
    <message>
        <source>Folder for the Engine&apos;s Files</source>
        <translation>Ordner für die Dateien der Engine</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>First angle</source>
        <translation>Projektionsmethode 1</translation>
    </message>
    <message>
        <source>Third angle</source>
        <translation>Projektionsmethode 3</translation>
    </message>
    <message>
        <source>Tells how the views are arranged: third angle has the top view above the front view, first angle below it</source>
        <translation>Sagt, wie die Ansichten angeordnet sind: Bei Methode 3 steht die Draufsicht über der Vorderansicht, bei Methode 1 darunter</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>Trades time for detail of the surface and effort of the search</source>
        <translation>Wägt Zeit gegen Feinheit der Oberfläche und Aufwand der Suche ab</translation>
    </message>
    <message>
        <source>Solid and surface</source>
        <translation>Festkörper und Oberfläche</translation>
    </message>
    <message>
        <source>Solid only</source>
        <translation>Nur Festkörper</translation>
    </message>
    <message>
        <source>Surface only</source>
        <translation>Nur Oberfläche</translation>
    </message>
    <message>
        <source>Chooses the exact solid, the mesh from trained Gaussians, or both of them</source>
        <translation>Wählt den exakten Festkörper, das Netz aus trainierten Gauß-Verteilungen oder beides</translation>
    </message>
    <message>
        <source>Parallel, as drawings are</source>
        <translation>Parallel, wie Zeichnungen</translation>
    </message>
    <message>
        <source>Perspective, as in the paper</source>
        <translation>Perspektivisch, wie im Aufsatz</translation>
    </message>
    <message>
        <source>Chooses the cameras that train the Gaussians</source>
        <translation>Wählt die Kameras, mit denen die Gauß-Verteilungen trainiert werden</translation>
    </message>
    <message>
        <source>Unknown or on the sheet</source>
        <translation>Unbekannt oder auf dem Blatt</translation>
    </message>
    <message>
        <source>Length along X</source>
        <translation>Länge entlang X</translation>
    </message>
    <message>
        <source>Length along Y</source>
        <translation>Länge entlang Y</translation>
    </message>
    <message>
        <source>Length along Z</source>
        <translation>Länge entlang Z</translation>
    </message>
    <message>
        <source>Millimetres per pixel</source>
        <translation>Millimeter je Pixel</translation>
    </message>
    <message>
        <source>Tells how large the part is. X runs along the front view&apos;s width, Z up its height, Y into depth</source>
        <translation>Sagt, wie groß das Bauteil ist. X läuft entlang der Breite der Vorderansicht, Z ihre Höhe hinauf, Y in die Tiefe</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Drop a drawing here</source>
        <translation>Zeichnung hierher ziehen</translation>
    </message>
    <message>
        <source>No preview of {name} here; the engine shows it when it is done</source>
        <translation>Hier keine Vorschau von {name}; die Engine zeigt sie, wenn sie fertig ist</translation>
    </message>
    <message>
        <source>The page {name} shows no views of a part. Recompute it, or choose another one.</source>
        <translation>Die Seite {name} zeigt keine Ansichten eines Teils. Berechnen Sie sie neu, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>The picture of {name} is missing. Choose the drawing&apos;s file instead.</source>
        <translation>Das Bild von {name} fehlt. Wählen Sie statt dessen die Datei der Zeichnung.</translation>
    </message>
    <message>
        <source>From the Document</source>
        <translation>Aus dem Dokument</translation>
    </message>
    <message>
        <source>Takes a TechDraw page or an image of the active document</source>
        <translation>Nimmt eine TechDraw-Seite oder ein Bild des aktiven Dokuments</translation>
    </message>
    <message>
        <source>The document has no TechDraw pages and no images</source>
        <translation>Das Dokument hat keine TechDraw-Seiten und keine Bilder</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Vergleich läuft</translation>
    </message>
    <message>
        <source>Choose two different objects to compare.</source>
        <translation>Wählen Sie zwei verschiedene Objekte für den Vergleich.</translation>
    </message>
    <message>
        <source>An object was removed while it was being compared.</source>
        <translation>Ein Objekt wurde während des Vergleichs entfernt.</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>The document was closed. Open it and compare again.</source>
        <translation>Das Dokument wurde geschlossen. Öffnen Sie es, und vergleichen Sie noch einmal.</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Cancelling</source>
        <translation>Wird abgebrochen</translation>
    </message>
    <message>
        <source>Stage {index} of {count}: {name}</source>
        <translation>Stufe {index} von {count}: {name}</translation>
    </message>
    <message>
        <source>Elapsed {time}</source>
        <translation>Vergangen {time}</translation>
    </message>
    <message>
        <source>this stage needs about {time} more</source>
        <translation>diese Stufe braucht noch etwa {time}</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Overall</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Starting the engine</source>
        <translation>Engine wird gestartet</translation>
    </message>
    <message>
        <source>Choose a drawing first.</source>
        <translation>Wählen Sie zuerst eine Zeichnung.</translation>
    </message>
    <message>
        <source>There is no file {path}. Choose another drawing.</source>
        <translation>Die Datei {path} gibt es nicht. Wählen Sie eine andere Zeichnung.</translation>
    </message>
    <message>
        <source>Choose a Drawing</source>
        <translation>Zeichnung wählen</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Zeichnungen</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>Check Engine</source>
        <translation>Engine prüfen</translation>
    </message>
    <message>
        <source>Install Engine…</source>
        <translation>Engine installieren…</translation>
    </message>
    <message>
        <source>Engine: {engine}</source>
        <translation>Engine: {engine}</translation>
    </message>
    <message>
        <source>Asking the engine…</source>
        <translation>Engine wird gefragt…</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>GaussianCAD looked in these places, in this order:</source>
        <translation>GaussianCAD hat der Reihe nach hier gesucht:</translation>
    </message>
    <message>
        <source>Preferences: {path}</source>
        <translation>Einstellungen: {path}</translation>
    </message>
    <message>
        <source>To install the engine, press Install Engine, or run in a terminal: make -C &apos;{folder}&apos; install</source>
        <translation>Um die Engine zu installieren, drücken Sie Engine installieren, oder geben Sie in einem Terminal ein: make -C &apos;{folder}&apos; install</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Grundwert</translation>
    </message>
    <message>
        <source>Values are in units: the longest edge of the reference is 5. The floor is what two samples of the reference itself give.</source>
        <translation>Werte in Einheiten: Die längste Kante der Referenz misst 5. Der Grundwert ist, was zwei Stichproben der Referenz selbst ergeben.</translation>
    </message>
    <message>
        <source>{distance}: {length} mm</source>
        <translation>{distance}: {length} mm</translation>
    </message>
    <message>
        <source>Chamfer</source>
        <translation>Chamfer</translation>
    </message>
    <message>
        <source>Sum of the mean distances to the nearest point, both ways</source>
        <translation>Summe der mittleren Abstände zum nächsten Punkt, in beiden Richtungen</translation>
    </message>
    <message>
        <source>Hausdorff</source>
        <translation>Hausdorff</translation>
    </message>
    <message>
        <source>Largest distance to the nearest point, either way</source>
        <translation>Größter Abstand zum nächsten Punkt, in einer der Richtungen</translation>
    </message>
    <message>
        <source>Earth mover</source>
        <translation>Earth Mover</translation>
    </message>
    <message>
        <source>Mean distance of points matched one to one</source>
        <translation>Mittlerer Abstand paarweise zugeordneter Punkte</translation>
    </message>
    <message>
        <source>To surface</source>
        <translation>Zur Fläche</translation>
    </message>
    <message>
        <source>Mean distance of the points to the other surface</source>
        <translation>Mittlerer Abstand der Punkte zur anderen Oberfläche</translation>
    </message>
    <message>
        <source>Volume IoU</source>
        <translation>Volumen-IoU</translation>
    </message>
    <message>
        <source>Common volume over united volume; 1 is perfect</source>
        <translation>Gemeinsames Volumen durch vereinigtes Volumen; 1 ist vollkommen</translation>
    </message>
    <message>
        <source>Opens a dialog to choose from</source>
        <translation>Öffnet einen Auswahldialog</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Adding the result to the document</source>
        <translation>Ergebnis kommt ins Dokument</translation>
    </message>
    <message>
        <source>The result cannot be added to the document: {reason}</source>
        <translation>Das Ergebnis kann dem Dokument nicht hinzugefügt werden: {reason}</translation>
    </message>
    <message>
        <source>The solutions are not in the document any more.</source>
        <translation>Die Lösungen sind nicht mehr im Dokument.</translation>
    </message>
    <message>
        <source>Keep Solution</source>
        <translation>Lösung behalten</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Vorige</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächste</translation>
    </message>
    <message>
        <source>{number} of {count}</source>
        <translation>{number} von {count}</translation>
    </message>
    <message>
        <source>Keep This One</source>
        <translation>Diese behalten</translation>
    </message>
    <message>
        <source>Choose among Solutions</source>
        <translation>Unter Lösungen wählen</translation>
    </message>
    <message>
        <source>Choose among {count} Solutions…</source>
        <translation>Unter {count} Lösungen wählen…</translation>
    </message>
    <message>
        <source>Size: {x} × {y} × {z} mm</source>
        <translation>Größe: {x} × {y} × {z} mm</translation>
    </message>
    <message>
        <source>Read in first angle</source>
        <translation>In Projektionsmethode 1 gelesen</translation>
    </message>
    <message>
        <source>Read in third angle</source>
        <translation>In Projektionsmethode 3 gelesen</translation>
    </message>
    <message>
        <source>The simplest of them, and the result so far</source>
        <translation>Die einfachste, und das bisherige Ergebnis</translation>
    </message>
    <message>
        <source>{count} different solids have the lines of this drawing. Keep the one that is meant; the others are removed.</source>
        <translation>{count} verschiedene Körper haben die Linien dieser Zeichnung. Behalten Sie den gemeinten; die anderen werden entfernt.</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Why there is doubt</source>
        <translation>Warum es Zweifel gibt</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Share of the lines, the drawing&apos;s and the solid&apos;s, that agree</source>
        <translation>Anteil der Linien, der Zeichnung und des Körpers, die übereinstimmen</translation>
    </message>
    <message>
        <source>Orange: {volume} mm³ more than solution 1, {place}</source>
        <translation>Orange: {volume} mm³ mehr als Lösung 1, {place}</translation>
    </message>
    <message>
        <source>Magenta: {volume} mm³ less than solution 1, {place}</source>
        <translation>Magenta: {volume} mm³ weniger als Lösung 1, {place}</translation>
    </message>
    <message>
        <source>within X {x}, Y {y}, Z {z} mm</source>
        <translation>innerhalb X {x}, Y {y}, Z {z} mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Part (outlines only, approximate)</source>
        <translation>Bauteil (nur Umrisse, angenähert)</translation>
    </message>
    <message>
        <source>Agrees, %</source>
        <translation>Stimmt, %</translation>
    </message>
    <message>
        <source>Area, %</source>
        <translation>Fläche, %</translation>
    </message>
    <message>
        <source>By how much the result&apos;s area differs</source>
        <translation>Um wie viel die Fläche des Ergebnisses abweicht</translation>
    </message>
    <message>
        <source>By how much the result&apos;s volume differs</source>
        <translation>Um wie viel das Volumen des Ergebnisses abweicht</translation>
    </message>
    <message>
        <source>Colours to ±</source>
        <translation>Farben bis ±</translation>
    </message>
    <message>
        <source>Compare Again</source>
        <translation>Neu vergleichen</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>Inside, mm</source>
        <translation>Innen, mm</translation>
    </message>
    <message>
        <source>Mean deviation; negative lies inside the other model</source>
        <translation>Mittlere Abweichung; negativ liegt im anderen Modell</translation>
    </message>
    <message>
        <source>Mean, mm</source>
        <translation>Mittel, mm</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>Model to Compare</source>
        <translation>Modell zum Vergleichen</translation>
    </message>
    <message>
        <source>Models ({patterns})</source>
        <translation>Modelle ({patterns})</translation>
    </message>
    <message>
        <source>Outside, mm</source>
        <translation>Außen, mm</translation>
    </message>
    <message>
        <source>Page for a browser (*.html)</source>
        <translation>Seite für einen Browser (*.html)</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>RMS, mm</source>
        <translation>RMS, mm</translation>
    </message>
    <message>
        <source>Range of the Colours</source>
        <translation>Bereich der Farben</translation>
    </message>
    <message>
        <source>Root mean square of the deviation</source>
        <translation>Quadratisches Mittel der Abweichung</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Save Comparison</source>
        <translation>Vergleich speichern</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Share of the surface within the tolerance</source>
        <translation>Anteil der Oberfläche innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>The comparison is out of date: {reason}</source>
        <translation>Der Vergleich ist veraltet: {reason}</translation>
    </message>
    <message>
        <source>The farthest that it lies inside the other model</source>
        <translation>Wie weit es höchstens im anderen Modell liegt</translation>
    </message>
    <message>
        <source>The farthest that it lies outside the other model</source>
        <translation>Wie weit es höchstens außerhalb des anderen Modells liegt</translation>
    </message>
    <message>
        <source>There is no file {path}. Choose another one.</source>
        <translation>Es gibt keine Datei {path}. Bitte eine andere wählen.</translation>
    </message>
    <message>
        <source>There is nothing to compare. Open a document with a result and a reference: a part, a body or a mesh each, or choose a file.</source>
        <translation>Es gibt nichts zu vergleichen. Öffnen Sie ein Dokument mit einem Ergebnis und einer Referenz: je ein Bauteil, ein Körper oder ein Netz, oder wählen Sie eine Datei.</translation>
    </message>
    <message>
        <source>Volume, %</source>
        <translation>Volumen, %</translation>
    </message>
    <message>
        <source>Worst points</source>
        <translation>Schlimmste Punkte</translation>
    </message>
    <message>
        <source>material is missing</source>
        <translation>Material fehlt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>the result has too little</source>
        <translation>das Ergebnis hat zu wenig</translation>
    </message>
    <message>
        <source>the result has too much</source>
        <translation>das Ergebnis hat zu viel</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Share of the surface by its deviation</source>
        <translation>Anteil der Oberfläche nach ihrer Abweichung</translation>
    </message>
    <message>
        <source>Result has</source>
        <translation>Ergebnis hat</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Größe, mm</translation>
    </message>
    <message>
        <source>Volume, mm³</source>
        <translation>Volumen, mm³</translation>
    </message>
    <message>
        <source>Area, mm²</source>
        <translation>Fläche, mm²</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>too little</source>
        <translation>zu wenig</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>too much</source>
        <translation>zu viel</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>Bildgröße</translation>
    </message>
    <message>
        <source>Divides the edges of the images that train the Gaussians. 1 / 1 is the size in the paper</source>
        <translation>Teilt die Kanten der Bilder, an denen die Gauß-Verteilungen trainiert werden. 1 / 1 ist die Größe aus dem Aufsatz</translation>
    </message>
    <message>
        <source>{width} x {height} px, about {minutes} min on a processor</source>
        <translation>{width} x {height} px, auf einem Prozessor etwa {minutes} min</translation>
    </message>
    <message>
        <source>Shape verified.</source>
        <translation>Form bestätigt.</translation>
    </message>
    <message>
        <source>Shape not certain: check the part against the drawing.</source>
        <translation>Die Form ist nicht sicher: Prüfen Sie das Teil an der Zeichnung.</translation>
    </message>
    <message>
        <source>from the sheet&apos;s numbers</source>
        <translation>aus den Zahlen des Blatts</translation>
    </message>
    <message>
        <source>from the drawing</source>
        <translation>aus der Zeichnung</translation>
    </message>
    <message>
        <source>from the sheet&apos;s numbers and the drawing</source>
        <translation>aus den Zahlen des Blatts und der Zeichnung</translation>
    </message>
    <message>
        <source>Measures to ±{bound} mm ({source}).</source>
        <translation>Maße auf ±{bound} mm genau ({source}).</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Select all like this</source>
        <translation>Alle gleichartigen auswählen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Assumed: {0}</source>
        <translation>Angenommen: {0}</translation>
    </message>
    <message>
        <source>The part lacks a line of {0} mm here</source>
        <translation>Dem Teil fehlt hier eine Linie von {0} mm</translation>
    </message>
    <message>
        <source>The part has a line of {0} mm here that the sheet has not</source>
        <translation>Das Teil hat hier eine Linie von {0} mm, die das Blatt nicht hat</translation>
    </message>
    <message>
        <source>These lines contradict each other</source>
        <translation>Diese Linien widersprechen einander</translation>
    </message>
    <message>
        <source>Verified: the part has the sheet&apos;s lines, no others</source>
        <translation>Verifiziert: das Teil hat die Linien des Blatts und keine anderen</translation>
    </message>
    <message>
        <source>Approximate: check the part against the sheet</source>
        <translation>Näherung: das Teil mit dem Blatt vergleichen</translation>
    </message>
    <message>
        <source>No part follows from the sheet as it is</source>
        <translation>Aus dem Blatt, wie es ist, folgt kein Teil</translation>
    </message>
</context>
<context>
    <name>GaussianCADPreferences</name>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Engine</translation>
    </message>
    <message>
        <source>Python of the engine</source>
        <translation>Python der Engine</translation>
    </message>
    <message>
        <source>Names the Python in whose environment the engine is installed. If empty, GaussianCAD looks for its own environment.</source>
        <translation>Nennt das Python, in dessen Umgebung die Engine installiert ist. Ist das Feld leer, sucht GaussianCAD nach seiner eigenen Umgebung.</translation>
    </message>
    <message>
        <source>If this is empty, GaussianCAD uses the environment that it installed itself, then the folder .venv beside the addon. GaussianCAD &gt; Check Engine shows which one was found.</source>
        <translation>Ist dieses Feld leer, verwendet GaussianCAD die Umgebung, die es selbst installiert hat, danach den Ordner .venv neben dem Addon. GaussianCAD &gt; Engine prüfen zeigt, welche gefunden wurde.</translation>
    </message>
    <message>
        <source>New Reconstructions</source>
        <translation>Neue Rekonstruktionen</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>First angle</source>
        <translation>Projektionsmethode 1</translation>
    </message>
    <message>
        <source>Third angle</source>
        <translation>Projektionsmethode 3</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>Folder for the engine&apos;s files</source>
        <translation>Ordner für die Dateien der Engine</translation>
    </message>
    <message>
        <source>Keeps the engine&apos;s files in a folder for each run. If empty, they are removed once the document holds the result.</source>
        <translation>Bewahrt die Dateien der Engine in einem Ordner je Lauf auf. Ist das Feld leer, werden sie entfernt, sobald das Dokument das Ergebnis enthält.</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_CheckEngine</name>
    <message>
        <source>Check Engine…</source>
        <translation>Engine prüfen…</translation>
    </message>
    <message>
        <source>Shows where the engine is, what it lacks and what to do about it</source>
        <translation>Zeigt, wo die Engine ist, was ihr fehlt und was zu tun ist</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Compare</name>
    <message>
        <source>Compare with Reference…</source>
        <translation>Mit Referenz vergleichen…</translation>
    </message>
    <message>
        <source>Measures how far a part or mesh is from another one and colours the difference</source>
        <translation>Misst, wie weit ein Bauteil oder Netz von einem anderen entfernt ist, und färbt den Unterschied</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Correct</name>
    <message>
        <source>Correct Sheet…</source>
        <translation>Blatt korrigieren …</translation>
    </message>
    <message>
        <source>Shows what was understood of a drawing, lets it be corrected, and makes the part</source>
        <translation>Zeigt, was von einer Zeichnung verstanden wurde, lässt es korrigieren und erzeugt das Teil</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_InstallEngine</name>
    <message>
        <source>Install Engine…</source>
        <translation>Engine installieren…</translation>
    </message>
    <message>
        <source>Downloads and installs the engine into an environment of its own</source>
        <translation>Lädt und installiert die Engine in eine eigene Umgebung</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Reconstruct</name>
    <message>
        <source>Reconstruct from Drawing…</source>
        <translation>Aus Zeichnung rekonstruieren…</translation>
    </message>
    <message>
        <source>Creates a 3D part from a drawing with two or more views</source>
        <translation>Erzeugt ein 3D-Bauteil aus einer Zeichnung mit zwei oder mehr Ansichten</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Solutions</name>
    <message>
        <source>Choose among Solutions…</source>
        <translation>Unter Lösungen wählen…</translation>
    </message>
    <message>
        <source>Flips through the solids that all have the drawing&apos;s lines and keeps one</source>
        <translation>Blättert durch die Körper, die alle die Linien der Zeichnung haben, und behält einen</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Turns drawings with three views into 3D parts</source>
        <translation>Macht aus Zeichnungen mit drei Ansichten 3D-Bauteile</translation>
    </message>
    <message>
        <source>GaussianCAD</source>
        <translation>GaussianCAD</translation>
    </message>
</context>
</TS>
