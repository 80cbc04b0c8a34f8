<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Numbers of the body that are not on the drawing</source>
        <translation>Maße des Körpers, die nicht auf der Zeichnung stehen</translation>
    </message>
    <message>
        <source>Numbers of the body that the drawing tells</source>
        <translation>Maße des Körpers, die auf der Zeichnung stehen</translation>
    </message>
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
    <message>
        <source>What was corrected by hand, as JSON</source>
        <translation>Was von Hand korrigiert wurde, als JSON</translation>
    </message>
    <message>
        <source>What the engine read on the drawing</source>
        <translation>Was die Engine auf der Zeichnung gelesen hat</translation>
    </message>
    <message>
        <source>The corrections that the part follows from</source>
        <translation>Die Korrekturen, aus denen das Teil folgt</translation>
    </message>
    <message>
        <source>Numbers that break the body if they are changed alone by 3 %</source>
        <translation>Maße, mit denen der Körper zerfällt, wenn sie allein um 3 % geändert werden</translation>
    </message>
    <message>
        <source>How many numbers were not tried for that</source>
        <translation>Wie viele Maße darauf nicht geprüft wurden</translation>
    </message>
    <message>
        <source>The drawing&apos;s numbers when the body was made</source>
        <translation>Die Maße der Zeichnung, als der Körper erzeugt wurde</translation>
    </message>
    <message>
        <source>The part that this body was made of</source>
        <translation>Das Bauteil, aus dem dieser Körper erzeugt wurde</translation>
    </message>
</context>
<context>
    <name>GaussianCAD</name>
    <message>
        <source>no features were found on it</source>
        <translation>es wurden keine Formelemente daran gefunden</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Grundkörper</translation>
    </message>
    <message>
        <source>Body of {name}</source>
        <translation>Körper von {name}</translation>
    </message>
    <message>
        <source>Features: {features}. Numbers from the sheet: {sheet}, measured: {measured}.</source>
        <translation>Formelemente: {features}. Maße vom Blatt: {sheet}, gemessen: {measured}.</translation>
    </message>
    <message>
        <source>From the sheet:</source>
        <translation>Vom Blatt:</translation>
    </message>
    <message>
        <source>Looking for features</source>
        <translation>Formelemente werden gesucht</translation>
    </message>
    <message>
        <source>Make Body</source>
        <translation>Körper erzeugen</translation>
    </message>
    <message>
        <source>No body was made of {name}: {reason}. The solid stays as it is.</source>
        <translation>Aus {name} wurde kein Körper: {reason}. Der Festkörper bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Not on the sheet:</source>
        <translation>Nicht auf dem Blatt:</translation>
    </message>
    <message>
        <source>Select a reconstruction, or another part with one solid, first.</source>
        <translation>Wählen Sie zuerst eine Rekonstruktion oder ein anderes Teil mit einem Festkörper.</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Festkörper</translation>
    </message>
    <message>
        <source>The part is not in its document any more.</source>
        <translation>Das Teil ist nicht mehr in seinem Dokument.</translation>
    </message>
    <message>
        <source>The solid of {name} cannot be written: {reason}</source>
        <translation>Der Festkörper von {name} kann nicht geschrieben werden: {reason}</translation>
    </message>
    <message>
        <source>They stand over a base solid, of which no features are known.</source>
        <translation>Sie stehen auf einem Grundkörper, von dem keine Formelemente bekannt sind.</translation>
    </message>
    <message>
        <source>To Body</source>
        <translation>In Körper umwandeln</translation>
    </message>
    <message>
        <source>the features are of {found} solids instead of {expected}</source>
        <translation>die Formelemente gehören zu {found} Festkörpern statt zu {expected}</translation>
    </message>
    <message>
        <source>the features do not make one valid solid</source>
        <translation>die Formelemente ergeben keinen einzelnen gültigen Festkörper</translation>
    </message>
    <message>
        <source>there are {found} faces instead of {expected}</source>
        <translation>es sind {found} Flächen statt {expected}</translation>
    </message>
    <message>
        <source>{feature} cannot be made ({reason})</source>
        <translation>{feature} lässt sich nicht erzeugen ({reason})</translation>
    </message>
    <message>
        <source>{percent} % of the volume differ</source>
        <translation>{percent} % des Volumens weichen ab</translation>
    </message>
    <message>
        <source>in doubt</source>
        <translation>fraglich</translation>
    </message>
    <message>
        <source>other lines</source>
        <translation>andere Linien</translation>
    </message>
    <message>
        <source>in Correct Sheet</source>
        <translation>mit „Blatt korrigieren“</translation>
    </message>
    <message>
        <source>here</source>
        <translation>hier</translation>
    </message>
    <message>
        <source>A library broke down in one of the ways in which the solid is looked for. That way was left out: check the part. It is a fault of ours: please report it with the drawing.</source>
        <translation>Eine Bibliothek ist bei einer der Arten zusammengebrochen, auf die der Festkörper gesucht wird. Diese Art wurde ausgelassen: Prüfen Sie das Teil. Das ist ein Fehler von uns: Bitte melden Sie ihn mit der Zeichnung.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Breaks off making the part</source>
        <translation>Bricht das Erzeugen des Teils ab</translation>
    </message>
    <message>
        <source>Into</source>
        <translation>In</translation>
    </message>
    <message>
        <source>A new document</source>
        <translation>Ein neues Dokument</translation>
    </message>
    <message>
        <source>The document into which the part goes</source>
        <translation>Das Dokument, in das das Teil kommt</translation>
    </message>
    <message>
        <source>The sheet was photographed at a slant of about {degrees} degrees and was straightened by its lines. Check the part&apos;s measures.</source>
        <translation>Das Blatt wurde um etwa {degrees} Grad schräg fotografiert und an seinen Linien entzerrt. Prüfen Sie die Maße des Teils.</translation>
    </message>
    <message>
        <source>The sheet was photographed at a slant of about {degrees} degrees and was straightened by its lines. How wide it is for its height may be some per cent off: check the part&apos;s measures.</source>
        <translation>Das Blatt wurde um etwa {degrees} Grad schräg fotografiert und an seinen Linien entzerrt. Das Verhältnis von Breite zu Höhe kann um einige Prozent falsch sein: Prüfen Sie die Maße des Teils.</translation>
    </message>
    <message>
        <source>What surrounds the paper in the picture was left out.</source>
        <translation>Was das Papier auf dem Bild umgibt, wurde weggelassen.</translation>
    </message>
    <message>
        <source>How exact its measures are is not known: the views fit no one scale</source>
        <translation>Wie genau die Maße sind, ist nicht bekannt: Die Ansichten passen zu keinem gemeinsamen Maßstab</translation>
    </message>
    <message>
        <source>The file has entities that cannot be read and were left out: {kinds}. What they show may be missing.</source>
        <translation>Die Datei hat Elemente, die nicht gelesen werden können und ausgelassen wurden: {kinds}. Was sie zeigen, kann fehlen.</translation>
    </message>
    <message>
        <source>The lines around everything were taken for a frame. If they are the part&apos;s outline, and what lies within is a pocket, the part is larger than what was made.</source>
        <translation>Die Linien um alles herum wurden für einen Rahmen gehalten. Sind sie der Umriss des Teils, und ist das Innere eine Tasche, dann ist das Teil größer als das, was gemacht wurde.</translation>
    </message>
    <message>
        <source>A note names {noted} as the unit, but the numbers fit what the file draws in {taken}, which was taken. Check the part&apos;s size.</source>
        <translation>Eine Notiz nennt {noted} als Einheit, aber die Zahlen passen zu dem, was die Datei in {taken} zeichnet; das wurde genommen. Prüfen Sie die Größe des Teils.</translation>
    </message>
    <message>
        <source>The dimensions say that the part is {share} times as large as the file draws it. They were taken: check the part&apos;s size.</source>
        <translation>Nach den Maßen ist das Teil {share}-mal so groß, wie die Datei es zeichnet. Die Maße wurden genommen: Prüfen Sie die Größe des Teils.</translation>
    </message>
    <message>
        <source>The file says the unit of its lengths, and no scale: the part was taken to be drawn in its own size. Set a length under Scale if it is not.</source>
        <translation>Die Datei nennt die Einheit ihrer Längen und keinen Maßstab: Es wurde angenommen, dass das Teil in wahrer Größe gezeichnet ist. Geben Sie sonst unter „Maßstab“ eine Länge an.</translation>
    </message>
    <message>
        <source>The file says neither its unit nor how large its paper is. Set a length under Scale.</source>
        <translation>Die Datei sagt weder ihre Einheit noch, wie groß ihr Papier ist. Geben Sie unter „Maßstab“ eine Länge an.</translation>
    </message>
    <message>
        <source>The file has entities that cannot be read and were left out: {kinds}.</source>
        <translation>Die Datei hat Elemente, die nicht gelesen werden können und ausgelassen wurden: {kinds}.</translation>
    </message>
    <message>
        <source>The lines around everything were taken for a frame, not for the part&apos;s outline.</source>
        <translation>Die Linien um alles herum wurden für einen Rahmen gehalten, nicht für den Umriss des Teils.</translation>
    </message>
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
        <source>Part (not there yet)</source>
        <translation>Bauteil (noch nicht vorhanden)</translation>
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
        <source>cutting line</source>
        <translation>Schnittlinie</translation>
    </message>
    <message>
        <source>hatching</source>
        <translation>Schraffur</translation>
    </message>
    <message>
        <source>extension line</source>
        <translation>Maßhilfslinie</translation>
    </message>
    <message>
        <source>leader</source>
        <translation>Hinweislinie</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>Symbol</translation>
    </message>
    <message>
        <source>line of a pictorial view</source>
        <translation>Linie einer bildlichen Ansicht</translation>
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
        <source>Pick from Ink</source>
        <translation>Aus dem Strich aufnehmen</translation>
    </message>
    <message>
        <source>Cutting Plane</source>
        <translation>Schnittebene</translation>
    </message>
    <message>
        <source>section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>Einzelheit</translation>
    </message>
    <message>
        <source>auxiliary view</source>
        <translation>Hilfsansicht</translation>
    </message>
    <message>
        <source>pictorial</source>
        <translation>Bildhafte Ansicht</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Lines of the Part</source>
        <translation>Linien des Teils</translation>
    </message>
    <message>
        <source>Other Lines</source>
        <translation>Andere Linien</translation>
    </message>
    <message>
        <source>Numbers and Notes</source>
        <translation>Zahlen und Hinweise</translation>
    </message>
    <message>
        <source>Cutting Planes</source>
        <translation>Schnittebenen</translation>
    </message>
    <message>
        <source>Problems and Disagreements</source>
        <translation>Probleme und Abweichungen</translation>
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
        <source>Looking for damaged files</source>
        <translation>Beschädigte Dateien werden gesucht</translation>
    </message>
    <message>
        <source>The repair was cancelled. Repair again to finish it.</source>
        <translation>Die Reparatur wurde abgebrochen. Reparieren Sie noch einmal, um sie zu beenden.</translation>
    </message>
    <message>
        <source>Looking for the small build of PyTorch</source>
        <translation>Kleine Fassung von PyTorch wird gesucht</translation>
    </message>
    <message>
        <source>The build of PyTorch for processors was found neither in the package index that pip is set up for nor in {index}. Look whether the network is there, or choose the build for NVIDIA cards, which works without such a card, too.</source>
        <translation>PyTorch für Prozessoren wurde weder im Paketverzeichnis gefunden, das für pip eingestellt ist, noch in {index}. Prüfen Sie das Netz, oder wählen Sie die Fassung für NVIDIA-Karten, die auch ohne solche Karte läuft.</translation>
    </message>
    <message>
        <source>Reinstalling damaged packages</source>
        <translation>Beschädigte Pakete werden neu installiert</translation>
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
        <source>Repair</source>
        <translation>Reparieren</translation>
    </message>
    <message>
        <source>Remove…</source>
        <translation>Entfernen…</translation>
    </message>
    <message>
        <source>Downloads and installs what is missing or damaged, only that</source>
        <translation>Lädt und installiert nur, was fehlt oder beschädigt ist</translation>
    </message>
    <message>
        <source>Remove the engine in {folder}? {size} on disk become free. Drawings, documents and this addon stay as they are, and the engine can be installed again.</source>
        <translation>Die Engine in {folder} entfernen? {size} auf der Platte werden frei. Zeichnungen, Dokumente und diese Erweiterung bleiben, wie sie sind, und die Engine kann wieder installiert werden.</translation>
    </message>
    <message>
        <source>Remove Engine</source>
        <translation>Engine entfernen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The engine is complete.</source>
        <translation>Die Engine ist vollständig.</translation>
    </message>
    <message>
        <source>Version {version} with PyTorch for {build}, {size} on disk in {folder}.</source>
        <translation>Version {version} mit PyTorch für {build}, {size} auf der Platte in {folder}.</translation>
    </message>
    <message>
        <source>Version {version} for {build}, {size} on disk in {folder}.</source>
        <translation>Version {version}, {build}, {size} auf der Platte in {folder}.</translation>
    </message>
    <message>
        <source>The engine in {folder} is not complete. Repair downloads what is missing or damaged.</source>
        <translation>Die Engine in {folder} ist nicht vollständig. „Reparieren“ lädt, was fehlt oder beschädigt ist.</translation>
    </message>
    <message>
        <source>Missing, or of another version: {names}</source>
        <translation>Es fehlen oder sind von anderer Version: {names}</translation>
    </message>
    <message>
        <source>An engine is in use already: {engine}.</source>
        <translation>Es wird schon eine Engine verwendet: {engine}.</translation>
    </message>
    <message>
        <source>GaussianCAD can download the packages of its engine from the Python package index that pip is set up for, and PyTorch for the processor from {index} where that index lacks it. Each package is checked against a hash that comes with this addon. They go into {folder}; FreeCAD&apos;s own Python stays as it is. Nothing is sent.</source>
        <translation>GaussianCAD kann die Pakete seiner Engine aus dem Paketverzeichnis laden, das für pip eingestellt ist, und PyTorch für den Prozessor aus {index}, wo es dort fehlt. Jedes Paket wird mit einer Prüfsumme verglichen, die mit dieser Erweiterung kommt. Sie kommen nach {folder}; FreeCADs eigenes Python bleibt, wie es ist. Gesendet wird nichts.</translation>
    </message>
    <message>
        <source>{count} MB</source>
        <translation>{count} MB</translation>
    </message>
    <message>
        <source>{count} GB</source>
        <translation>{count} GB</translation>
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
        <source>Click to see the place</source>
        <translation>Klicken, um die Stelle zu sehen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>The sheet is being read…</source>
        <translation>Das Blatt wird gelesen …</translation>
    </message>
    <message>
        <source>The corrections beside the sheet are of another version of it: they were left out, and will be kept as a file of their own.</source>
        <translation>Die Korrekturen neben dem Blatt gehören zu einer anderen Fassung davon: Sie wurden weggelassen und bleiben als eigene Datei erhalten.</translation>
    </message>
    <message>
        <source>Nothing meets this end</source>
        <translation>Nichts trifft auf dieses Ende</translation>
    </message>
    <message>
        <source>Corrections by hand: {0}</source>
        <translation>Korrekturen von Hand: {0}</translation>
    </message>
    <message>
        <source>Box a View</source>
        <translation>Ansicht umrahmen</translation>
    </message>
    <message>
        <source>Draw a Line</source>
        <translation>Linie zeichnen</translation>
    </message>
    <message>
        <source>Tell a Length</source>
        <translation>Länge angeben</translation>
    </message>
    <message>
        <source>Set the Plane</source>
        <translation>Ebene festlegen</translation>
    </message>
    <message>
        <source>Other Projection</source>
        <translation>Andere Projektion</translation>
    </message>
    <message>
        <source>Close Gaps</source>
        <translation>Lücken schließen</translation>
    </message>
    <message>
        <source>It Belongs There</source>
        <translation>Sie gehört dorthin</translation>
    </message>
    <message>
        <source>Tangent Edge</source>
        <translation>Tangentenkante</translation>
    </message>
    <message>
        <source>Erase It</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Es wird gelesen …</translation>
    </message>
    <message>
        <source>Making the part…</source>
        <translation>Das Teil wird erzeugt …</translation>
    </message>
    <message>
        <source>Length between the two points in mm:</source>
        <translation>Länge zwischen den zwei Punkten in mm:</translation>
    </message>
    <message>
        <source>What “{0}” gives, in mm:</source>
        <translation>Was „{0}“ angibt, in mm:</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Depth of the hole in mm:</source>
        <translation>Tiefe der Bohrung in mm:</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Bohrung</translation>
    </message>
    <message>
        <source>There is no line of a view at this place</source>
        <translation>An dieser Stelle liegt keine Linie einer Ansicht</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Solve as I Go</source>
        <translation>Laufend lösen</translation>
    </message>
    <message>
        <source>Makes the part (Enter)</source>
        <translation>Erzeugt das Teil (Eingabetaste)</translation>
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
        <source>Show</source>
        <translation>Anzeigen</translation>
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
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Change of the model</source>
        <translation>Änderung am Modell</translation>
    </message>
    <message>
        <source>Single changes with which the model explains more of the drawing, and how many millimetres of its lines</source>
        <translation>Einzelne Änderungen, mit denen das Modell mehr von der Zeichnung erklärt, und wie viele Millimeter ihrer Linien</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>The model was changed since: check again.</source>
        <translation>Das Modell wurde seitdem geändert: Prüfen Sie noch einmal.</translation>
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
        <source>No run has ended on this drawing yet.</source>
        <translation>Zu dieser Zeichnung ist noch kein Lauf beendet.</translation>
    </message>
    <message>
        <source>The drawing is gone, and the document holds no copy</source>
        <translation>Die Zeichnung ist nicht mehr da, und das Dokument hat keine Kopie</translation>
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
        <source>Another shape: {share} % of the volume is shared where both are as large.</source>
        <translation>Eine andere Form: {share} % des Volumens sind gemeinsam, wenn beide gleich groß sind.</translation>
    </message>
    <message>
        <source>The same part: {share} % of the volume is shared.</source>
        <translation>Dasselbe Teil: {share} % des Volumens sind gemeinsam.</translation>
    </message>
    <message>
        <source>The same shape, {ratio} times too large.</source>
        <translation>Dieselbe Form, {ratio}-mal zu groß.</translation>
    </message>
    <message>
        <source>The same shape, {ratio} times too small.</source>
        <translation>Dieselbe Form, {ratio}-mal zu klein.</translation>
    </message>
    <message>
        <source>Set Length along X to {length} mm and run it again.</source>
        <translation>Setzen Sie „Länge entlang X“ auf {length} mm und starten Sie erneut.</translation>
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
        <source>GaussianCAD Jobs</source>
        <translation>GaussianCAD-Aufträge</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Stage {index} of {count}</source>
        <translation>Stufe {index} von {count}</translation>
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
        <source>Check Against Drawing</source>
        <translation>An Zeichnung prüfen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Starting the engine</source>
        <translation>Engine wird gestartet</translation>
    </message>
    <message>
        <source>There is nothing to check. Open a document with a part, a body or a mesh, or choose a file.</source>
        <translation>Es gibt nichts zu prüfen. Öffnen Sie ein Dokument mit einem Bauteil, einem Körper oder einem Netz, oder wählen Sie eine Datei.</translation>
    </message>
    <message>
        <source>Check Again</source>
        <translation>Noch einmal prüfen</translation>
    </message>
    <message>
        <source>Correct Sheet…</source>
        <translation>Blatt korrigieren…</translation>
    </message>
    <message>
        <source>The document was closed. Open it and check again.</source>
        <translation>Das Dokument wurde geschlossen. Öffnen Sie es und prüfen Sie noch einmal.</translation>
    </message>
    <message>
        <source>Model and drawing</source>
        <translation>Modell und Zeichnung</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>The drawing of {name} is gone, and the document holds no copy of it. Choose the drawing in Reconstruct from Drawing.</source>
        <translation>Die Zeichnung von {name} ist nicht mehr da, und das Dokument hat keine Kopie davon. Wählen Sie die Zeichnung in „Aus Zeichnung rekonstruieren“.</translation>
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
        <source>Run Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>{name} – Correct Sheet</source>
        <translation>{name} – Blatt korrigieren</translation>
    </message>
    <message>
        <source>Mesh and Gaussians</source>
        <translation>Netz und Gaußfunktionen</translation>
    </message>
    <message>
        <source>Choose among Solutions…</source>
        <translation>Unter Lösungen wählen…</translation>
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
        <source>The engine is complete and works.</source>
        <translation>Die Engine ist vollständig und arbeitet.</translation>
    </message>
    <message>
        <source>The engine does not work: see below what to do.</source>
        <translation>Die Engine arbeitet nicht: unten steht, was zu tun ist.</translation>
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
        <source>Chamfer distance</source>
        <translation>Chamfer-Abstand</translation>
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
        <source>Part (slabs, approximate)</source>
        <translation>Bauteil (Platten, angenähert)</translation>
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
        <source>Hole Goes Through</source>
        <translation>Bohrung geht durch</translation>
    </message>
    <message>
        <source>Depth of Hole…</source>
        <translation>Tiefe der Bohrung…</translation>
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
        <source>Otherwise: {0}</source>
        <translation>Sonst: {0}</translation>
    </message>
    <message>
        <source>Yes, Through</source>
        <translation>Ja, durchgehend</translation>
    </message>
    <message>
        <source>Its ink looks like that.</source>
        <translation>So sieht ihre Tinte aus.</translation>
    </message>
    <message>
        <source>Its width, color or rhythm tells it.</source>
        <translation>Ihre Breite, Farbe oder Strichfolge sagt es.</translation>
    </message>
    <message>
        <source>The rest of its line tells it, against its look.</source>
        <translation>Der Rest ihrer Linie sagt es, gegen ihr Aussehen.</translation>
    </message>
    <message>
        <source>The figure that it is a part of tells it.</source>
        <translation>Die Figur, zu der sie gehört, sagt es.</translation>
    </message>
    <message>
        <source>As an edge it would end at no other edge.</source>
        <translation>Als Kante endete sie an keiner anderen Kante.</translation>
    </message>
    <message>
        <source>Without it other edges would end at nothing.</source>
        <translation>Ohne sie endeten andere Kanten im Leeren.</translation>
    </message>
    <message>
        <source>Its dashes, or its pen, tell it.</source>
        <translation>Ihre Striche oder ihr Stift sagen es.</translation>
    </message>
    <message>
        <source>In doubt: {kind}, {share} sure.</source>
        <translation>Fraglich: {kind}, zu {share} sicher.</translation>
    </message>
    <message>
        <source>More lines in doubt: {0}</source>
        <translation>Weitere fragliche Linien: {0}</translation>
    </message>
    <message>
        <source>Yes: {0}</source>
        <translation>Ja: {0}</translation>
    </message>
    <message>
        <source>No: {0}</source>
        <translation>Nein: {0}</translation>
    </message>
    <message>
        <source>No, so Deep…</source>
        <translation>Nein, so tief…</translation>
    </message>
    <message>
        <source>All {0} Go Through</source>
        <translation>Alle {0} gehen durch</translation>
    </message>
    <message>
        <source>The size is not known: tell a length</source>
        <translation>Die Größe ist nicht bekannt: geben Sie eine Länge an</translation>
    </message>
    <message>
        <source>Measures to ±{0} mm</source>
        <translation>Maße auf ±{0} mm</translation>
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
    <message>
        <source>The engine broke off: {reason}</source>
        <translation>Die Engine ist abgebrochen: {reason}</translation>
    </message>
    <message>
        <source>A mirror image of the result fits better. Check the projection and the views.</source>
        <translation>Ein Spiegelbild des Ergebnisses passt besser. Prüfen Sie die Projektion und die Ansichten.</translation>
    </message>
    <message>
        <source>The result is {ratio} times as large as the reference: their units differ. Scale the result by {factor} to have it in millimetres.</source>
        <translation>Das Ergebnis ist {ratio}-mal so groß wie die Referenz: Die Einheiten sind verschieden. Skalieren Sie das Ergebnis mit {factor}, damit es in Millimetern ist.</translation>
    </message>
    <message>
        <source>Not closed: {model} (open edges: {count}). Its volume is not certain, and distances from it have no sign.</source>
        <translation>Nicht geschlossen: {model} (offene Kanten: {count}). Das Volumen ist nicht sicher, und Abstände davon haben kein Vorzeichen.</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s geometry check refuses this solid: {model}. Its volume may be wrong.</source>
        <translation>Die Geometrieprüfung von FreeCAD lehnt diesen Festkörper ab: {model}. Sein Volumen kann falsch sein.</translation>
    </message>
    <message>
        <source>Only surfaces that do not close up to a solid: {model}. Its volume is not certain, and distances from it have no sign.</source>
        <translation>Nur Flächen, die sich nicht zu einem Festkörper schließen: {model}. Das Volumen ist nicht sicher, und Abstände davon haben kein Vorzeichen.</translation>
    </message>
    <message>
        <source>Surfaces without a solid: {model}. Sewn together they are closed, and are measured as a solid.</source>
        <translation>Flächen ohne Festkörper: {model}. Zusammengenäht sind sie geschlossen und werden als Festkörper gemessen.</translation>
    </message>
    <message>
        <source>Faces beside the solids are not measured: {model} (faces: {count}). Remove them, or make solids of them.</source>
        <translation>Flächen neben den Festkörpern werden nicht gemessen: {model} (Flächen: {count}). Entfernen Sie sie, oder machen Sie Festkörper daraus.</translation>
    </message>
    <message>
        <source>Solids that touch or overlap are measured as one body, without the faces between them: {model} (solids: {count}).</source>
        <translation>Festkörper, die sich berühren oder überschneiden, werden als ein Körper gemessen, ohne die Flächen dazwischen: {model} (Festkörper: {count}).</translation>
    </message>
    <message>
        <source>Closed, but without a volume: {model}.</source>
        <translation>Geschlossen, aber ohne Volumen: {model}.</translation>
    </message>
    <message>
        <source>Result: bodies {result_bodies}, through holes {result_holes}, cavities {result_cavities}. Reference: bodies {reference_bodies}, through holes {reference_holes}, cavities {reference_cavities}.</source>
        <translation>Ergebnis: Körper {result_bodies}, durchgehende Löcher {result_holes}, Hohlräume {result_cavities}. Referenz: Körper {reference_bodies}, durchgehende Löcher {reference_holes}, Hohlräume {reference_cavities}.</translation>
    </message>
    <message>
        <source>The models cannot be compared: one is damaged. Export it again.</source>
        <translation>Die Modelle lassen sich nicht vergleichen: Eines ist beschädigt. Exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>The model cannot be drawn: it is damaged. Export it again.</source>
        <translation>Das Modell kann nicht gezeichnet werden: Es ist beschädigt. Exportieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The file is no model. Choose a STEP, BREP, STL, PLY or OBJ file.</source>
        <translation>Die Datei ist kein Modell. Wählen Sie eine STEP-, BREP-, STL-, PLY- oder OBJ-Datei.</translation>
    </message>
    <message>
        <source>The model&apos;s file is damaged, or of another format. Export it again.</source>
        <translation>Die Datei des Modells ist beschädigt oder hat ein anderes Format. Exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>The file holds no solid and no surfaces. Export a solid or its faces.</source>
        <translation>Die Datei enthält weder Festkörper noch Flächen. Exportieren Sie einen Festkörper oder seine Flächen.</translation>
    </message>
    <message>
        <source>The model has no surface. Export it with its faces.</source>
        <translation>Das Modell hat keine Oberfläche. Exportieren Sie es mit seinen Flächen.</translation>
    </message>
    <message>
        <source>The model is points without faces. Make a surface of them first.</source>
        <translation>Das Modell besteht aus Punkten ohne Flächen. Machen Sie zuerst eine Oberfläche daraus.</translation>
    </message>
    <message>
        <source>The model&apos;s file is cut off or damaged. Export it again.</source>
        <translation>Die Datei des Modells ist abgeschnitten oder beschädigt. Exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>The model&apos;s file is too large. Export it with fewer triangles.</source>
        <translation>Die Datei des Modells ist zu groß. Exportieren Sie es mit weniger Dreiecken.</translation>
    </message>
    <message>
        <source>The model is too small, or too far from the origin, to be measured. Export it in millimetres, near the origin.</source>
        <translation>Das Modell ist zu klein oder liegt zu weit vom Ursprung, um gemessen zu werden. Exportieren Sie es in Millimetern nahe am Ursprung.</translation>
    </message>
    <message>
        <source>The models differ too much in size to be compared. Check that these are the right ones.</source>
        <translation>Die Modelle sind zu verschieden groß für einen Vergleich. Prüfen Sie, ob es die richtigen sind.</translation>
    </message>
    <message>
        <source>No exact solid was found. The model is a surface that fills what the outlines leave: measure nothing from it.</source>
        <translation>Es wurde kein exakter Festkörper gefunden. Das Modell ist eine Oberfläche, die füllt, was die Umrisse lassen: Nehmen Sie keine Maße davon ab.</translation>
    </message>
    <message>
        <source>The exact solid that fits best has only {percent} % of the drawing&apos;s lines and was not kept. Check {canvas} whether the lines were read right.</source>
        <translation>Der exakte Festkörper, der am besten passt, hat nur {percent} % der Linien der Zeichnung und wurde nicht behalten. Prüfen Sie {canvas}, ob die Linien richtig gelesen wurden.</translation>
    </message>
    <message>
        <source>No solid has all lines as they were read. This part is a stack of slabs along {axis} that explains {percent} % of them. Check {canvas} which lines are wrong.</source>
        <translation>Kein Festkörper hat alle Linien, wie sie gelesen wurden. Dieses Bauteil ist ein Stapel von Platten längs {axis}, der {percent} % von ihnen erklärt. Prüfen Sie {canvas}, welche Linien falsch sind.</translation>
    </message>
    <message>
        <source>This part, a stack of slabs along {axis}, has all lines of the drawing, but nothing proves that no other part has them. Compare it with the sheet.</source>
        <translation>Dieses Bauteil, ein Stapel von Platten längs {axis}, hat alle Linien der Zeichnung, aber nichts beweist, dass kein anderes sie hat. Vergleichen Sie es mit dem Blatt.</translation>
    </message>
    <message>
        <source>The part is {count} bodies: the sheet shows several, or a line is missing that joins them.</source>
        <translation>Das Bauteil besteht aus {count} Körpern: Das Blatt zeigt mehrere, oder eine Linie fehlt, die sie verbindet.</translation>
    </message>
    <message>
        <source>The lines of the views contradict each other, so that no solid has them all. Check {canvas} whether a line was read wrong.</source>
        <translation>Die Linien der Ansichten widersprechen sich, sodass kein Festkörper sie alle hat. Prüfen Sie {canvas}, ob eine Linie falsch gelesen wurde.</translation>
    </message>
    <message>
        <source>Lines contradict each other as they were read, and are marked on the sheet: one was read wrong, or another is missing. Correct it {canvas}.</source>
        <translation>Linien widersprechen einander, wie sie gelesen wurden, und sind auf dem Blatt markiert: eine wurde falsch gelesen, oder eine andere fehlt. Berichtigen Sie es {canvas}.</translation>
    </message>
    <message>
        <source>The lines contradict each other as they were read. They would agree if the view “{view}” had one more {linetype}: draw it {canvas}.</source>
        <translation>Die Linien widersprechen sich, so wie sie gelesen wurden. Sie würden übereinstimmen, wenn die Ansicht „{view}“ eine weitere {linetype} hätte: Zeichnen Sie sie {canvas}.</translation>
    </message>
    <message>
        <source>The lines contradict each other as they were read. They would agree without one {linetype} of the view “{view}”: erase it {canvas} if it is wrong.</source>
        <translation>Die Linien widersprechen sich, so wie sie gelesen wurden. Sie würden ohne eine {linetype} der Ansicht „{view}“ übereinstimmen: Löschen Sie diese {canvas}, wenn sie falsch ist.</translation>
    </message>
    <message>
        <source>The lines contradict each other as they were read. They would agree if another line of the view “{view}” were a {linetype}: change it {canvas} if it was read wrong.</source>
        <translation>Die Linien widersprechen sich, so wie sie gelesen wurden. Sie würden übereinstimmen, wenn eine andere Linie der Ansicht „{view}“ eine {linetype} wäre: Ändern Sie sie {canvas}, wenn sie falsch gelesen wurde.</translation>
    </message>
    <message>
        <source>What fits the lines best does not close up to a solid: lines are missing or wrong. Check them {canvas}.</source>
        <translation>Was am besten zu den Linien passt, schließt sich nicht zu einem Festkörper: Linien fehlen oder sind falsch. Prüfen Sie sie {canvas}.</translation>
    </message>
    <message>
        <source>The drawing has too many lines for an exact solid. Draw fewer of them on one sheet.</source>
        <translation>Die Zeichnung hat zu viele Linien für einen exakten Festkörper. Zeichnen Sie weniger davon auf ein Blatt.</translation>
    </message>
    <message>
        <source>The lines of the drawing are too many, or cross each other too often, to be told apart. Draw fewer of them on one sheet, or cut the views out of the picture.</source>
        <translation>Die Linien der Zeichnung sind zu viele oder kreuzen sich zu oft, um sie auseinanderzuhalten. Zeichnen Sie weniger davon auf ein Blatt, oder schneiden Sie die Ansichten aus dem Bild aus.</translation>
    </message>
    <message>
        <source>The drawing has more separate strokes than can be followed ({most}). Draw fewer of them on one sheet, or cut the views out of it.</source>
        <translation>Die Zeichnung hat mehr einzelne Striche, als verfolgt werden können ({most}). Zeichnen Sie weniger davon auf ein Blatt, oder schneiden Sie die Ansichten aus.</translation>
    </message>
    <message>
        <source>The solid is not one valid closed body.</source>
        <translation>Der Festkörper ist nicht ein einziger gültiger, geschlossener Körper.</translation>
    </message>
    <message>
        <source>{count} different solids have the lines of this drawing. Choose the one that is meant with Choose among Solutions.</source>
        <translation>{count} verschiedene Festkörper haben die Linien dieser Zeichnung. Wählen Sie den gemeinten mit „Unter Lösungen wählen“.</translation>
    </message>
    <message>
        <source>The views fit different solids in first and in third angle. Choose the angle under Projection.</source>
        <translation>Die Ansichten passen nach Projektionsmethode 1 und 3 zu verschiedenen Festkörpern. Wählen Sie die Methode unter „Projektion“.</translation>
    </message>
    <message>
        <source>The search for solids with these lines was not completed: there may be others.</source>
        <translation>Die Suche nach Festkörpern mit diesen Linien wurde nicht abgeschlossen: Es kann andere geben.</translation>
    </message>
    <message>
        <source>The search for solids took much longer than usual and was ended. Close other programs and run the drawing again.</source>
        <translation>Die Suche nach Festkörpern dauerte viel länger als üblich und wurde beendet. Schließen Sie andere Programme und starten Sie die Zeichnung erneut.</translation>
    </message>
    <message>
        <source>The views may fit a solid in the other projection as well. Choose first or third angle under Projection.</source>
        <translation>Die Ansichten passen vielleicht auch in der anderen Projektion zu einem Festkörper. Wählen Sie Projektionsmethode 1 oder 3 unter „Projektion“.</translation>
    </message>
    <message>
        <source>The drawing has more lines than can be understood together. Draw fewer of them on one sheet.</source>
        <translation>Die Zeichnung hat mehr Linien, als sich zusammen verstehen lassen. Zeichnen Sie weniger davon auf ein Blatt.</translation>
    </message>
    <message>
        <source>The part does not have all lines of the drawing, or it has others.</source>
        <translation>Das Teil hat nicht alle Linien der Zeichnung, oder es hat andere.</translation>
    </message>
    <message>
        <source>The part lacks lines of the drawing; the longest one, of {length_mm} mm, is in the view “{view}”.</source>
        <translation>Dem Teil fehlen Linien der Zeichnung; die längste, {length_mm} mm lang, liegt in der Ansicht „{view}“.</translation>
    </message>
    <message>
        <source>The part has lines that the drawing does not show; the longest one, of {length_mm} mm, is in the view “{view}”.</source>
        <translation>Das Teil hat Linien, die die Zeichnung nicht zeigt; die längste, {length_mm} mm lang, liegt in der Ansicht „{view}“.</translation>
    </message>
    <message>
        <source>The surface does not have all lines of these views, or it has others: {views}.</source>
        <translation>Die Oberfläche hat nicht alle Linien dieser Ansichten, oder sie hat andere: {views}.</translation>
    </message>
    <message>
        <source>Lines that nearly meet were taken to meet: small steps may be missing.</source>
        <translation>Linien, die sich fast treffen, wurden als verbunden genommen: Kleine Absätze können fehlen.</translation>
    </message>
    <message>
        <source>In the view “{view}” the drawn line lies {distance_mm} mm beside the part&apos;s: a curve may have been misread there.</source>
        <translation>In der Ansicht „{view}“ liegt die gezeichnete Linie {distance_mm} mm neben der des Teils: Dort kann eine Kurve falsch gelesen sein.</translation>
    </message>
    <message>
        <source>A line of the drawing lies {distance_mm} mm beside the part&apos;s: a small step may be missing.</source>
        <translation>Eine Linie der Zeichnung liegt {distance_mm} mm neben der des Teils: Ein kleiner Absatz kann fehlen.</translation>
    </message>
    <message>
        <source>The views and the part differ by up to {distance_mm} mm in size: a small step may be missing.</source>
        <translation>Die Ansichten und das Teil sind um bis zu {distance_mm} mm verschieden groß: Ein kleiner Absatz kann fehlen.</translation>
    </message>
    <message>
        <source>Not used: {kind}. What it shows of the part may be missing.</source>
        <translation>Nicht verwendet: {kind}. Was dort vom Teil zu sehen ist, kann fehlen.</translation>
    </message>
    <message>
        <source>Groups of lines belong to no view and are large enough to be one ({count}). Box them as views {canvas} if they show the part.</source>
        <translation>Gruppen von Linien gehören zu keiner Ansicht und sind groß genug, eine zu sein ({count}). Umrahmen Sie sie {canvas} als Ansichten, wenn sie das Teil zeigen.</translation>
    </message>
    <message>
        <source>Lines that cross a view in another line width were not used ({count}). If they are edges of the part, make them visible lines {canvas}.</source>
        <translation>Linien, die in anderer Strichbreite durch eine Ansicht laufen, wurden nicht verwendet ({count}). Wenn es Kanten des Teils sind, machen Sie sie {canvas} zu sichtbaren Linien.</translation>
    </message>
    <message>
        <source>The lengths of {earlier_mm} mm and {last_mm} mm that you told contradict each other. The last one was taken. Tell one of them again, or take it back.</source>
        <translation>Die Längen von {earlier_mm} mm und {last_mm} mm, die Sie angegeben haben, widersprechen einander. Die letzte wurde genommen. Geben Sie eine davon noch einmal an, oder nehmen Sie sie zurück.</translation>
    </message>
    <message>
        <source>Corrections that no longer find what they corrected: {count}. Look at them again {canvas}.</source>
        <translation>Korrekturen, die nicht mehr finden, was sie korrigierten: {count}. Sehen Sie sie {canvas} noch einmal an.</translation>
    </message>
    <message>
        <source>No view has a hidden line. It was assumed that nothing lies inside the part that no view shows.</source>
        <translation>Keine Ansicht hat eine verdeckte Linie. Es wurde angenommen, dass im Inneren des Teils nichts liegt, was keine Ansicht zeigt.</translation>
    </message>
    <message>
        <source>These views have no hidden line: {views}. It was assumed that none was left out; otherwise another solid fits as well, see Choose among Solutions.</source>
        <translation>Diese Ansichten haben keine verdeckte Linie: {views}. Es wurde angenommen, dass keine weggelassen wurde; sonst passt auch ein anderer Festkörper, siehe „Unter Lösungen wählen“.</translation>
    </message>
    <message>
        <source>The solid has long faces too narrow for any view to show: lines that belong together may have been read apart.</source>
        <translation>Der Festkörper hat lange Flächen, die zu schmal für jede Ansicht sind: Linien, die zusammengehören, wurden vielleicht getrennt gelesen.</translation>
    </message>
    <message>
        <source>Hidden lines as short as a dash look like visible ones. Some were taken for the other kind, as the other views have it.</source>
        <translation>Verdeckte Linien, die nicht länger als ein Strich sind, sehen wie sichtbare aus. Einige wurden nach den anderen Ansichten für die andere Art genommen.</translation>
    </message>
    <message>
        <source>The projection symbol says {symbol}, but the lines fit {other} better. Taken was {taken}; choose under Projection if it is the other.</source>
        <translation>Das Projektionssymbol sagt {symbol}, aber die Linien passen besser zu {other}. Angenommen wurde {taken}; wählen Sie unter „Projektion“, wenn es die andere ist.</translation>
    </message>
    <message>
        <source>The drawing&apos;s dimensions agree on {sheet} mm per pixel, but the scale that was set gives {told}. The dimensions were not used: check what is set under Scale.</source>
        <translation>Die Maße der Zeichnung ergeben übereinstimmend {sheet} mm je Pixel, der eingestellte Maßstab aber {told}. Die Maße wurden nicht verwendet: Prüfen Sie, was unter „Maßstab“ eingestellt ist.</translation>
    </message>
    <message>
        <source>The drawing has only two directions of view: what a third would show is not known.</source>
        <translation>Die Zeichnung hat nur zwei Blickrichtungen: Was eine dritte zeigen würde, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Used as a view: {kind}. What was cut away in front of the cut is shown by no line.</source>
        <translation>Als Ansicht verwendet: {kind}. Was vor dem Schnitt weggeschnitten ist, zeigt keine Linie.</translation>
    </message>
    <message>
        <source>The note “{note}” speaks of {count} holes, and the view “{view}” has {found} of that kind: the note was taken for all of them.</source>
        <translation>Der Hinweis „{note}“ spricht von {count} Bohrungen, und die Ansicht „{view}“ hat {found} dieser Art: Der Hinweis wurde auf alle bezogen.</translation>
    </message>
    <message>
        <source>The drawing has one view; what a second would show was assumed.</source>
        <translation>Die Zeichnung hat eine Ansicht; was eine zweite zeigen würde, wurde angenommen.</translation>
    </message>
    <message>
        <source>The drawing has one view with diameters across its axis: a turned part was assumed. If it is none, another view is needed.</source>
        <translation>Die Zeichnung hat eine Ansicht mit Durchmessern quer zur Achse: Ein Drehteil wurde angenommen. Wenn es keines ist, wird eine weitere Ansicht gebraucht.</translation>
    </message>
    <message>
        <source>The drawing has one view and a thickness: it was assumed that the part is of that thickness everywhere and that what is drawn inside goes through.</source>
        <translation>Die Zeichnung hat eine Ansicht und eine Dicke: Es wurde angenommen, dass das Teil überall so dick ist und dass durchgeht, was innen gezeichnet ist.</translation>
    </message>
    <message>
        <source>A view is broken, so that its length is not as drawn. Set a length along another axis under Scale.</source>
        <translation>Eine Ansicht ist unterbrochen gezeichnet, sodass ihre Länge nicht die gezeichnete ist. Stellen Sie unter „Maßstab“ eine Länge entlang einer anderen Achse ein.</translation>
    </message>
    <message>
        <source>A view is drawn up to its centre line: what lies beyond was taken as its mirror image.</source>
        <translation>Eine Ansicht ist bis zu ihrer Mittellinie gezeichnet: Was jenseits liegt, wurde als ihr Spiegelbild genommen.</translation>
    </message>
    <message>
        <source>{count} holes of {diameter_mm} mm in the view “{view}” were taken to go through, as nothing tells their depth.</source>
        <translation>{count} Bohrungen von {diameter_mm} mm in der Ansicht „{view}“ wurden als durchgehend angenommen, da nichts ihre Tiefe sagt.</translation>
    </message>
    <message>
        <source>The hole of {diameter_mm} mm in the view “{view}” was taken to go through, as nothing tells its depth.</source>
        <translation>Die Bohrung von {diameter_mm} mm in der Ansicht „{view}“ wurde als durchgehend genommen, da nichts ihre Tiefe angibt.</translation>
    </message>
    <message>
        <source>Section {label} was taken to cut through the middle of the part, as it has no cutting line.</source>
        <translation>Schnitt {label} wurde durch die Mitte des Teils gelegt, da er keine Schnittlinie hat.</translation>
    </message>
    <message>
        <source>A section without a title was taken to cut through the middle of the part, as it has no cutting line.</source>
        <translation>Ein Schnitt ohne Bezeichnung wurde durch die Mitte des Teils gelegt, da er keine Schnittlinie hat.</translation>
    </message>
    <message>
        <source>There are bores, pockets or cavities that only hidden lines would show.</source>
        <translation>Es gibt Bohrungen, Taschen oder Hohlräume, die nur verdeckte Linien zeigen würden.</translation>
    </message>
    <message>
        <source>It ends inside: give its depth in a note, or draw its hidden lines.</source>
        <translation>Sie endet im Inneren: Geben Sie ihre Tiefe in einem Hinweis an, oder zeichnen Sie ihre verdeckten Linien.</translation>
    </message>
    <message>
        <source>It cuts elsewhere: draw its cutting line.</source>
        <translation>Er schneidet woanders: Zeichnen Sie seine Schnittlinie.</translation>
    </message>
    <message>
        <source>It is another part with the same view.</source>
        <translation>Es ist ein anderes Teil mit derselben Ansicht.</translation>
    </message>
    <message>
        <source>The lines fit both {taken} and {other}. Taken was {taken}; choose under Projection if it is the other.</source>
        <translation>Die Linien passen zu {taken} und zu {other}. Angenommen wurde {taken}; wählen Sie unter „Projektion“, wenn es die andere ist.</translation>
    </message>
    <message>
        <source>Dimensions do not fit the scale of the others ({numbers}): they were misread, or the drawing is not to scale there.</source>
        <translation>Maße passen nicht zum Maßstab der anderen ({numbers}): Sie wurden falsch gelesen, oder die Zeichnung ist dort nicht maßstäblich.</translation>
    </message>
    <message>
        <source>The sheet is so large that it was read at a lower resolution: measures are known less well. Cut out the views to have them read as they are.</source>
        <translation>Das Blatt ist so groß, dass es mit geringerer Auflösung gelesen wurde: Die Maße sind weniger genau bekannt. Schneiden Sie die Ansichten aus, damit sie gelesen werden, wie sie sind.</translation>
    </message>
    <message>
        <source>The trained network that tells edges from dimensions is missing or damaged: the picture was read by rules. Repair the engine under Check Engine.</source>
        <translation>Das trainierte Netz, das Kanten von Maßen unterscheidet, fehlt oder ist beschädigt: das Bild wurde nach Regeln gelesen. Reparieren Sie die Engine unter „Engine prüfen“.</translation>
    </message>
    <message>
        <source>Lines that may be edges of the part or annotation: {count}. Look at them {canvas}.</source>
        <translation>Linien, die Kanten des Teils oder Beschriftung sein können: {count}. Sehen Sie sie {canvas} an.</translation>
    </message>
    <message>
        <source>The engine was installed for exact solids only: no surface was made. GaussianCAD &gt; Install Engine has one that makes both.</source>
        <translation>Die Engine wurde nur für exakte Festkörper installiert: Eine Oberfläche wurde nicht gemacht. Unter GaussianCAD &gt; Engine installieren gibt es eine, die beides macht.</translation>
    </message>
    <message>
        <source>The sheet has no readable scale: 1:1 was assumed. Set a length under Scale if it is another.</source>
        <translation>Das Blatt hat keine lesbare Maßstabsangabe: 1:1 wurde angenommen. Stellen Sie unter „Maßstab“ eine Länge ein, wenn es anders ist.</translation>
    </message>
    <message>
        <source>The picture has {across} pixels an inch across and {down} down: it was resampled to {dpi} both ways.</source>
        <translation>Das Bild hat waagerecht {across} und senkrecht {down} Pixel je Zoll: Es wurde in beiden Richtungen auf {dpi} umgerechnet.</translation>
    </message>
    <message>
        <source>Page 1 shows no views that belong together. Page {page} of {pages}, which brings them together, was taken.</source>
        <translation>Seite 1 zeigt keine Ansichten, die zusammengehören. Genommen wurde Seite {page} von {pages}, die sie zusammenbringt.</translation>
    </message>
    <message>
        <source>The scale is not known: the longest edge was made 100 mm. Set a length under Scale.</source>
        <translation>Der Maßstab ist nicht bekannt: Die längste Kante wurde 100 mm lang gemacht. Stellen Sie unter „Maßstab“ eine Länge ein.</translation>
    </message>
    <message>
        <source>Corrections by hand that were taken: {count}. The result is checked by the sheet as corrected.</source>
        <translation>Übernommene Korrekturen von Hand: {count}. Das Ergebnis wird am korrigierten Blatt geprüft.</translation>
    </message>
    <message>
        <source>The views differ by {spread_mm} mm in the part&apos;s extent along {axis}: the mean was taken.</source>
        <translation>Die Ansichten unterscheiden sich um {spread_mm} mm in der Ausdehnung des Teils entlang {axis}: Der Mittelwert wurde genommen.</translation>
    </message>
    <message>
        <source>The SVG refers to other files, which are never opened: what they hold is missing.</source>
        <translation>Die SVG-Datei verweist auf andere Dateien, die nie geöffnet werden: Was sie enthalten, fehlt.</translation>
    </message>
    <message>
        <source>Groups of lines belong to no view and were left out: {count}.</source>
        <translation>Gruppen von Linien, die zu keiner Ansicht gehören und weggelassen wurden: {count}.</translation>
    </message>
    <message>
        <source>A pictorial view was left out: it illustrates what the other views show.</source>
        <translation>Eine bildhafte Ansicht wurde weggelassen: Sie veranschaulicht, was die anderen Ansichten zeigen.</translation>
    </message>
    <message>
        <source>The outlines of these views have gaps: {views}. The surface was made with the exact solid&apos;s outline there.</source>
        <translation>Die Umrisse dieser Ansichten haben Lücken: {views}. Die Oberfläche wurde dort mit dem Umriss des exakten Festkörpers erzeugt.</translation>
    </message>
    <message>
        <source>On a processor this takes an hour or more. Choose the quality Draft or smaller images, or use a graphics card.</source>
        <translation>Auf einem Prozessor dauert das eine Stunde oder länger. Wählen Sie die Qualität „Entwurf“ oder kleinere Bilder, oder verwenden Sie eine Grafikkarte.</translation>
    </message>
    <message>
        <source>The interrupted run in the folder belongs to another drawing, other settings or another version: the training began anew.</source>
        <translation>Der unterbrochene Lauf in dem Ordner gehört zu einer anderen Zeichnung, anderen Einstellungen oder einer anderen Version: Das Training begann von vorn.</translation>
    </message>
    <message>
        <source>Thread symbols were left out: the model has plain cylinders there.</source>
        <translation>Gewindesymbole wurden weggelassen: Das Modell hat dort glatte Zylinder.</translation>
    </message>
    <message>
        <source>There is no such file: {path}. Choose it again.</source>
        <translation>Diese Datei gibt es nicht: {path}. Wählen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>{path} is no file. Choose a drawing.</source>
        <translation>{path} ist keine Datei. Wählen Sie eine Zeichnung.</translation>
    </message>
    <message>
        <source>{path} cannot be opened. Check that you may read it.</source>
        <translation>{path} lässt sich nicht öffnen. Prüfen Sie, ob Sie die Datei lesen dürfen.</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that you may read it.</source>
        <translation>Die Datei lässt sich nicht lesen. Prüfen Sie, ob Sie sie lesen dürfen.</translation>
    </message>
    <message>
        <source>The file is empty. Export it again.</source>
        <translation>Die Datei ist leer. Exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The file is no PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF, whatever its name says. Export the drawing as one of them.</source>
        <translation>Die Datei ist kein PNG, JPEG, TIFF, BMP, WebP, PDF, SVG oder DXF, was auch immer ihr Name sagt. Exportieren Sie die Zeichnung in eines dieser Formate.</translation>
    </message>
    <message>
        <source>The picture is damaged. Export or scan the drawing again.</source>
        <translation>Das Bild ist beschädigt. Exportieren oder scannen Sie die Zeichnung neu.</translation>
    </message>
    <message>
        <source>The file is no PDF, or is damaged. Export the drawing again, or as PNG.</source>
        <translation>Die Datei ist kein PDF oder ist beschädigt. Exportieren Sie die Zeichnung neu oder als PNG.</translation>
    </message>
    <message>
        <source>The file is no SVG, or is damaged. Export the drawing again, or as PNG.</source>
        <translation>Die Datei ist kein SVG oder ist beschädigt. Exportieren Sie die Zeichnung neu oder als PNG.</translation>
    </message>
    <message>
        <source>The file is no DXF, or is damaged. Export the drawing again, or as PNG.</source>
        <translation>Die Datei ist kein DXF oder ist beschädigt. Exportieren Sie die Zeichnung neu oder als PNG.</translation>
    </message>
    <message>
        <source>What was read of the sheet is damaged, or of another version. Open the drawing {canvas} again.</source>
        <translation>Was vom Blatt gelesen wurde, ist beschädigt oder von einer anderen Version. Öffnen Sie die Zeichnung noch einmal {canvas}.</translation>
    </message>
    <message>
        <source>The corrections in {path} are damaged, or of another version. Remove that file, or mend it.</source>
        <translation>Die Korrekturen in {path} sind beschädigt oder von einer anderen Version. Entfernen Sie diese Datei, oder bringen Sie sie in Ordnung.</translation>
    </message>
    <message>
        <source>The PDF is protected by a password. Save it without one.</source>
        <translation>Das PDF ist durch ein Kennwort geschützt. Speichern Sie es ohne Kennwort.</translation>
    </message>
    <message>
        <source>The SVG declares XML entities, which are never expanded. Save it as plain SVG.</source>
        <translation>Die SVG-Datei deklariert XML-Entitäten, die nie aufgelöst werden. Speichern Sie sie als einfaches SVG.</translation>
    </message>
    <message>
        <source>All that the SVG shows lies in other files, which are never opened. Embed it.</source>
        <translation>Alles, was die SVG-Datei zeigt, liegt in anderen Dateien, die nie geöffnet werden. Betten Sie es ein.</translation>
    </message>
    <message>
        <source>The page has no lines. Choose another page or file.</source>
        <translation>Die Seite hat keine Linien. Wählen Sie eine andere Seite oder Datei.</translation>
    </message>
    <message>
        <source>The file has {count} pages, at most {most} are read. Save the sheet in a file by itself.</source>
        <translation>Die Datei hat {count} Seiten, höchstens {most} werden gelesen. Speichern Sie das Blatt in einer eigenen Datei.</translation>
    </message>
    <message>
        <source>There is no page {page}: the last page of the file is page {count}.</source>
        <translation>Es gibt keine Seite {page}: Die letzte Seite der Datei ist Seite {count}.</translation>
    </message>
    <message>
        <source>The picture is too large: at most {most} million pixels are read. Export or scan it at a lower resolution, or on smaller paper.</source>
        <translation>Das Bild ist zu groß: Höchstens {most} Millionen Pixel werden gelesen. Exportieren oder scannen Sie es mit geringerer Auflösung oder auf kleinerem Papier.</translation>
    </message>
    <message>
        <source>The picture has only {width} × {height} pixels. Export the drawing with 1920 × 1080 or more.</source>
        <translation>Das Bild hat nur {width} × {height} Pixel. Exportieren Sie die Zeichnung mit 1920 × 1080 oder mehr.</translation>
    </message>
    <message>
        <source>This is a FreeCAD document. Open it, then choose its TechDraw page as the drawing.</source>
        <translation>Das ist ein FreeCAD-Dokument. Öffnen Sie es und wählen Sie dann seine TechDraw-Seite als Zeichnung.</translation>
    </message>
    <message>
        <source>{format} files are not read. Save the drawing as PDF, SVG, DXF or PNG.</source>
        <translation>{format}-Dateien werden nicht gelesen. Speichern Sie die Zeichnung als PDF, SVG, DXF oder PNG.</translation>
    </message>
    <message>
        <source>This is no report of a batch. Choose the one in the folder that it wrote.</source>
        <translation>Das ist kein Bericht eines Stapels. Wählen Sie den in dem Ordner, den er geschrieben hat.</translation>
    </message>
    <message>
        <source>The run left no report. Run it again.</source>
        <translation>Der Lauf hat keinen Bericht hinterlassen. Starten Sie ihn erneut.</translation>
    </message>
    <message>
        <source>The run&apos;s report is damaged. Run it again.</source>
        <translation>Der Bericht des Laufs ist beschädigt. Starten Sie ihn erneut.</translation>
    </message>
    <message>
        <source>The run&apos;s report is of another version. Run it again.</source>
        <translation>Der Bericht des Laufs ist von einer anderen Version. Starten Sie ihn erneut.</translation>
    </message>
    <message>
        <source>The sheet is blank: there are no lines.</source>
        <translation>Das Blatt ist leer: Es gibt keine Linien.</translation>
    </message>
    <message>
        <source>This does not look like a line drawing. Use an export or a scan of the drawing, not a photograph.</source>
        <translation>Das sieht nicht wie eine Strichzeichnung aus. Verwenden Sie einen Export oder Scan der Zeichnung, kein Foto.</translation>
    </message>
    <message>
        <source>No view of a part was found. Box the views {canvas} and say which is which.</source>
        <translation>Es wurde keine Ansicht eines Teils gefunden. Umrahmen Sie die Ansichten {canvas} und sagen Sie, welche welche ist.</translation>
    </message>
    <message>
        <source>Only one view was found. A part follows from two views, or from one with diameters across its axis or with a thickness. Box the views {canvas} if there are more.</source>
        <translation>Es wurde nur eine Ansicht gefunden. Ein Teil folgt aus zwei Ansichten, oder aus einer mit Durchmessern quer zur Achse oder mit einer Dicke. Umrahmen Sie die Ansichten {canvas}, wenn es mehr gibt.</translation>
    </message>
    <message>
        <source>The sheet shows the part in a pictorial view alone. Views at right angles are needed, such as front, top and side.</source>
        <translation>Das Blatt zeigt das Teil nur in einer perspektivischen Ansicht. Nötig sind rechtwinklige Ansichten wie Vorder-, Drauf- und Seitenansicht.</translation>
    </message>
    <message>
        <source>The views do not line up with each other. Box them {canvas} and say which is which.</source>
        <translation>Die Ansichten liegen nicht in Flucht zueinander. Umrahmen Sie sie {canvas} und sagen Sie, welche welche ist.</translation>
    </message>
    <message>
        <source>The view “{view}” has no visible line. Draw its edges {canvas}, or say that the box is another view.</source>
        <translation>Die Ansicht „{view}“ hat keine sichtbare Linie. Zeichnen Sie ihre Kanten {canvas}, oder sagen Sie, dass der Rahmen eine andere Ansicht ist.</translation>
    </message>
    <message>
        <source>The views show nothing of the {axis} axis. Two views at right angles are needed: box them {canvas}.</source>
        <translation>Die Ansichten zeigen nichts von der {axis}-Achse. Zwei rechtwinklig zueinander liegende Ansichten werden gebraucht: Umrahmen Sie sie {canvas}.</translation>
    </message>
    <message>
        <source>The views differ by {percent} % in the part&apos;s extent along {axis} ({views}). Check that they show one part at one scale, or box them {canvas}.</source>
        <translation>Die Ansichten unterscheiden sich um {percent} % in der Ausdehnung des Teils entlang {axis} ({views}). Prüfen Sie, ob sie ein Teil in einem Maßstab zeigen, oder umrahmen Sie sie {canvas}.</translation>
    </message>
    <message>
        <source>The outline of the view “{view}” is not closed. Draw what is missing of its visible edges {canvas}.</source>
        <translation>Der Umriss der Ansicht „{view}“ ist nicht geschlossen. Zeichnen Sie {canvas}, was von ihren sichtbaren Kanten fehlt.</translation>
    </message>
    <message>
        <source>The edges of the view “{view}” run together to one line. Export the drawing with more pixels.</source>
        <translation>Die Kanten der Ansicht „{view}“ laufen zu einer Linie zusammen. Exportieren Sie die Zeichnung mit mehr Pixeln.</translation>
    </message>
    <message>
        <source>The outlines of the views have no body in common, so that there is no surface. Check which view is which, and the projection.</source>
        <translation>Die Umrisse der Ansichten haben keinen gemeinsamen Körper, sodass es keine Oberfläche gibt. Prüfen Sie, welche Ansicht welche ist, und die Projektion.</translation>
    </message>
    <message>
        <source>The Gaussians bound no body, so that there is no surface of them. Choose a finer quality, or check that the views belong together.</source>
        <translation>Die Gaußfunktionen begrenzen keinen Körper, sodass es keine Oberfläche daraus gibt. Wählen Sie eine feinere Qualität, oder prüfen Sie, ob die Ansichten zusammengehören.</translation>
    </message>
    <message>
        <source>There are no lines in the box of the view “{view}”. Draw it again.</source>
        <translation>Im Rahmen der Ansicht „{view}“ liegen keine Linien. Ziehen Sie ihn neu auf.</translation>
    </message>
    <message>
        <source>Two boxes are named “{view}”. Give one of them another name {canvas}.</source>
        <translation>Zwei Rahmen heißen „{view}“. Geben Sie einem davon {canvas} einen anderen Namen.</translation>
    </message>
    <message>
        <source>The drawing has changed since it was read. Open it {canvas} again.</source>
        <translation>Die Zeichnung hat sich geändert, seit sie gelesen wurde. Öffnen Sie sie noch einmal {canvas}.</translation>
    </message>
    <message>
        <source>The corrections in {path} belong to another drawing, or to an earlier version of it. Remove that file, or correct the drawing again.</source>
        <translation>Die Korrekturen in {path} gehören zu einer anderen Zeichnung oder zu einer früheren Fassung davon. Entfernen Sie diese Datei, oder korrigieren Sie die Zeichnung neu.</translation>
    </message>
    <message>
        <source>There is not enough memory. Choose the quality Draft or a smaller file, or export a vector drawing as PNG.</source>
        <translation>Der Speicher reicht nicht. Wählen Sie die Qualität „Entwurf“ oder eine kleinere Datei, oder exportieren Sie eine Vektorzeichnung als PNG.</translation>
    </message>
    <message>
        <source>The drawing has more lines and other elements than can be read ({most}). Save only the views, or export it as PNG.</source>
        <translation>Die Zeichnung hat mehr Linien und andere Elemente, als gelesen werden können ({most}). Speichern Sie nur die Ansichten, oder exportieren Sie sie als PNG.</translation>
    </message>
    <message>
        <source>The table has more lines than are taken ({most}). Make several tables of it.</source>
        <translation>Die Tabelle hat mehr Zeilen, als angenommen werden ({most}). Teilen Sie sie in mehrere Tabellen auf.</translation>
    </message>
    <message>
        <source>There are more corrections than are taken ({most}). Remove those that no longer matter.</source>
        <translation>Es sind mehr Korrekturen, als angenommen werden ({most}). Entfernen Sie die, auf die es nicht mehr ankommt.</translation>
    </message>
    <message>
        <source>The reading has more strokes than are taken ({most}). Read the views alone.</source>
        <translation>Die Lesung hat mehr Striche, als angenommen werden ({most}). Lesen Sie nur die Ansichten.</translation>
    </message>
    <message>
        <source>The file has more than {most} MB. Save only the views, or export the drawing as PNG.</source>
        <translation>Die Datei hat mehr als {most} MB. Speichern Sie nur die Ansichten, oder exportieren Sie die Zeichnung als PNG.</translation>
    </message>
    <message>
        <source>The drawing was not read after {seconds} s. Save only the views, or export it as PNG.</source>
        <translation>Die Zeichnung war nach {seconds} s nicht gelesen. Speichern Sie nur die Ansichten, oder exportieren Sie sie als PNG.</translation>
    </message>
    <message>
        <source>It took longer than is allowed, and was ended.</source>
        <translation>Es dauerte länger als erlaubt und wurde beendet.</translation>
    </message>
    <message>
        <source>There is no space left on the disk. Free some, then try again.</source>
        <translation>Auf dem Datenträger ist kein Platz mehr. Machen Sie Platz und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The system lets the engine open no more files. Close other programs, then try again.</source>
        <translation>Das System lässt die Engine keine weiteren Dateien öffnen. Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The folder {path} cannot be written to. Choose another one.</source>
        <translation>In den Ordner {path} lässt sich nicht schreiben. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>The graphics card cannot be used. GaussianCAD &gt; Check Engine shows what is missing.</source>
        <translation>Die Grafikkarte lässt sich nicht verwenden. GaussianCAD &gt; Engine prüfen zeigt, was fehlt.</translation>
    </message>
    <message>
        <source>The engine is incomplete. Choose GaussianCAD &gt; Check Engine to see what to do.</source>
        <translation>Die Engine ist unvollständig. Wählen Sie GaussianCAD &gt; Engine prüfen, um zu sehen, was zu tun ist.</translation>
    </message>
    <message>
        <source>The engine was installed without what this needs ({packages}). Choose GaussianCAD &gt; Install Engine, and there an engine with PyTorch.</source>
        <translation>Der Engine fehlt, was dafür nötig ist ({packages}). Wählen Sie GaussianCAD &gt; Engine installieren, und dort eine mit PyTorch.</translation>
    </message>
    <message>
        <source>The engine met something that nobody foresaw ({kind}). This is a fault of ours: please report it with the sheet.</source>
        <translation>Die Engine ist auf etwas gestoßen, das niemand vorhergesehen hat ({kind}). Das ist unser Fehler: Bitte melden Sie ihn zusammen mit dem Blatt.</translation>
    </message>
    <message>
        <source>The engine met something that nobody foresaw ({kind}). This is a fault of ours: please report it with the file {path}.</source>
        <translation>Die Engine ist auf etwas gestoßen, das niemand vorhergesehen hat ({kind}). Das ist unser Fehler: Bitte melden Sie ihn zusammen mit der Datei {path}.</translation>
    </message>
    <message>
        <source>A library ended the engine. This is a fault of ours: please report it with the sheet.</source>
        <translation>Eine Bibliothek hat die Engine beendet. Das ist unser Fehler: Bitte melden Sie ihn zusammen mit dem Blatt.</translation>
    </message>
    <message>
        <source>The system ended the engine, as it does where the memory does not suffice. Choose a coarser quality, or a smaller sheet.</source>
        <translation>Das System hat die Engine beendet, wie es bei zu wenig Arbeitsspeicher geschieht. Wählen Sie eine gröbere Qualität oder ein kleineres Blatt.</translation>
    </message>
    <message>
        <source>{folder} holds files that GaussianCAD did not make: {names}. Choose another folder.</source>
        <translation>{folder} enthält Dateien, die nicht von GaussianCAD sind: {names}. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>By its scale the part is {longest} mm long. Tell its true size with Tell a Length.</source>
        <translation>Nach seinem Maßstab ist das Teil {longest} mm lang. Geben Sie mit „Länge angeben“ die wahre Größe an.</translation>
    </message>
    <message>
        <source>The surface cannot be simplified to a closed one. Choose a finer quality.</source>
        <translation>Die Oberfläche lässt sich nicht zu einer geschlossenen vereinfachen. Wählen Sie eine feinere Qualität.</translation>
    </message>
    <message>
        <source>The surface does not become a valid solid: only its mesh can be used.</source>
        <translation>Aus der Oberfläche wird kein gültiger Festkörper: Nur ihr Netz ist zu gebrauchen.</translation>
    </message>
    <message>
        <source>The solid cannot be saved as STEP.</source>
        <translation>Der Festkörper lässt sich nicht als STEP speichern.</translation>
    </message>
    <message>
        <source>reading the sheet</source>
        <translation>Blatt lesen</translation>
    </message>
    <message>
        <source>finding the views</source>
        <translation>Ansichten finden</translation>
    </message>
    <message>
        <source>reading the lines</source>
        <translation>Linien lesen</translation>
    </message>
    <message>
        <source>bringing the views together</source>
        <translation>Ansichten zusammenführen</translation>
    </message>
    <message>
        <source>finding the solid</source>
        <translation>Festkörper finden</translation>
    </message>
    <message>
        <source>carving the outlines</source>
        <translation>Umrisse schnitzen</translation>
    </message>
    <message>
        <source>training the Gaussians</source>
        <translation>Gaußfunktionen trainieren</translation>
    </message>
    <message>
        <source>making the surface</source>
        <translation>Oberfläche erzeugen</translation>
    </message>
    <message>
        <source>holding the model against the views</source>
        <translation>Modell mit den Ansichten vergleichen</translation>
    </message>
    <message>
        <source>checking against the sheet</source>
        <translation>Am Blatt prüfen</translation>
    </message>
    <message>
        <source>writing the files</source>
        <translation>Dateien schreiben</translation>
    </message>
    <message>
        <source>half section</source>
        <translation>Halbschnitt</translation>
    </message>
    <message>
        <source>broken-out section</source>
        <translation>Ausbruch</translation>
    </message>
    <message>
        <source>pictorial view</source>
        <translation>bildhafte Ansicht</translation>
    </message>
    <message>
        <source>enlarged detail</source>
        <translation>vergrößerte Einzelheit</translation>
    </message>
    <message>
        <source>views of another part</source>
        <translation>Ansichten eines anderen Teils</translation>
    </message>
    <message>
        <source>broken view</source>
        <translation>unterbrochene Ansicht</translation>
    </message>
    <message>
        <source>half view</source>
        <translation>halbe Ansicht</translation>
    </message>
    <message>
        <source>thread symbol</source>
        <translation>Gewindesymbol</translation>
    </message>
    <message>
        <source>group of lines</source>
        <translation>Gruppe von Linien</translation>
    </message>
    <message>
        <source>visible line</source>
        <translation>sichtbare Linie</translation>
    </message>
    <message>
        <source>hidden line</source>
        <translation>verdeckte Linie</translation>
    </message>
    <message>
        <source>first angle</source>
        <translation>Projektionsmethode 1</translation>
    </message>
    <message>
        <source>third angle</source>
        <translation>Projektionsmethode 3</translation>
    </message>
    <message>
        <source>the result</source>
        <translation>das Ergebnis</translation>
    </message>
    <message>
        <source>the reference</source>
        <translation>die Referenz</translation>
    </message>
    <message>
        <source>Open Drawing</source>
        <translation>Zeichnung öffnen</translation>
    </message>
    <message>
        <source>The drawing was not read yet. Wait until it is.</source>
        <translation>Die Zeichnung ist noch nicht gelesen. Warten Sie, bis sie es ist.</translation>
    </message>
    <message>
        <source>Show Solutions</source>
        <translation>Lösungen zeigen</translation>
    </message>
    <message>
        <source>Correct Drawing</source>
        <translation>Zeichnung korrigieren</translation>
    </message>
    <message>
        <source>Mesh and Gaussians of {0}</source>
        <translation>Netz und Gaußfunktionen von {0}</translation>
    </message>
    <message>
        <source>The drawing is no longer in the document</source>
        <translation>Die Zeichnung ist nicht mehr im Dokument</translation>
    </message>
    <message>
        <source>Page {0}</source>
        <translation>Seite {0}</translation>
    </message>
    <message>
        <source>The lines as they are drawn</source>
        <translation>Die Linien, wie sie gezeichnet sind</translation>
    </message>
    <message>
        <source>Slabs that explain the lines best</source>
        <translation>Platten, die die Linien am besten erklären</translation>
    </message>
    <message>
        <source>Short lines as visible or hidden, whichever fits</source>
        <translation>Kurze Linien als sichtbar oder verdeckt, je nachdem was passt</translation>
    </message>
    <message>
        <source>The open outline closed by a straight line</source>
        <translation>Der offene Umriss mit einer geraden Linie geschlossen</translation>
    </message>
    <message>
        <source>With bodies of revolution that only one view shows</source>
        <translation>Mit Rotationskörpern, die nur eine Ansicht zeigt</translation>
    </message>
    <message>
        <source>Rough arcs taken for curves in which surfaces meet</source>
        <translation>Ungenaue Bögen als Kurven genommen, in denen sich Flächen treffen</translation>
    </message>
    <message>
        <source>Lines led onto the curves in which two surfaces meet</source>
        <translation>Linien auf die Kurven geführt, in denen sich zwei Flächen treffen</translation>
    </message>
    <message>
        <source>With hidden lines that may have been left out</source>
        <translation>Mit verdeckten Linien, die weggelassen sein können</translation>
    </message>
    <message>
        <source>With measures that are most likely round</source>
        <translation>Mit Maßen, die wahrscheinlich rund sind</translation>
    </message>
    <message>
        <source>a solid with all lines</source>
        <translation>ein Festkörper mit allen Linien</translation>
    </message>
    <message>
        <source>a solid whose lines differ from the drawing&apos;s</source>
        <translation>ein Festkörper, dessen Linien von denen der Zeichnung abweichen</translation>
    </message>
    <message>
        <source>a solid that is not one valid closed body</source>
        <translation>ein Festkörper, der nicht ein einziger gültiger, geschlossener Körper ist</translation>
    </message>
    <message>
        <source>faces that do not close</source>
        <translation>Flächen, die sich nicht schließen</translation>
    </message>
    <message>
        <source>nothing that bounds a body</source>
        <translation>nichts, was einen Körper begrenzt</translation>
    </message>
    <message>
        <source>no solid, as the lines contradict each other</source>
        <translation>kein Festkörper, da sich die Linien widersprechen</translation>
    </message>
    <message>
        <source>no answer within the work that is allowed</source>
        <translation>keine Antwort mit dem erlaubten Aufwand</translation>
    </message>
    <message>
        <source>not tried, as there are too many lines</source>
        <translation>nicht versucht, da es zu viele Linien sind</translation>
    </message>
    <message>
        <source>Why there is no part:</source>
        <translation>Warum es kein Teil gibt:</translation>
    </message>
    <message>
        <source>Why the shape is not certain:</source>
        <translation>Warum die Form nicht sicher ist:</translation>
    </message>
    <message>
        <source>What was assumed:</source>
        <translation>Was angenommen wurde:</translation>
    </message>
    <message>
        <source>What was not used:</source>
        <translation>Was nicht verwendet wurde:</translation>
    </message>
    <message>
        <source>What was tried for the solid:</source>
        <translation>Was für den Festkörper versucht wurde:</translation>
    </message>
    <message>
        <source>Where the part&apos;s lines and the drawing&apos;s differ:</source>
        <translation>Wo sich die Linien von Teil und Zeichnung unterscheiden:</translation>
    </message>
    <message>
        <source>Lines that contradict each other:</source>
        <translation>Linien, die sich widersprechen:</translation>
    </message>
    <message>
        <source>{model}: {outcome}.</source>
        <translation>{model}: {outcome}.</translation>
    </message>
    <message>
        <source>Faces: {faces}, agreement of the lines: {share}.</source>
        <translation>Flächen: {faces}, Übereinstimmung der Linien: {share}.</translation>
    </message>
    <message>
        <source>Length of the lines that were given up: {length} mm.</source>
        <translation>Länge der aufgegebenen Linien: {length} mm.</translation>
    </message>
    <message>
        <source>This one was taken.</source>
        <translation>Dieser wurde genommen.</translation>
    </message>
    <message>
        <source>{view}: the part lacks a line of {length} mm</source>
        <translation>{view}: Dem Teil fehlt eine Linie von {length} mm</translation>
    </message>
    <message>
        <source>{view}: the part has a line of {length} mm too many</source>
        <translation>{view}: Das Teil hat eine Linie von {length} mm zu viel</translation>
    </message>
    <message>
        <source>{view}: a visible line</source>
        <translation>{view}: eine sichtbare Linie</translation>
    </message>
    <message>
        <source>{view}: a hidden line</source>
        <translation>{view}: eine verdeckte Linie</translation>
    </message>
    <message>
        <source>{view}: a place where nothing is drawn</source>
        <translation>{view}: eine Stelle, an der nichts gezeichnet ist</translation>
    </message>
    <message>
        <source>without it all others agree</source>
        <translation>ohne sie stimmen alle anderen überein</translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation>und {count} weitere</translation>
    </message>
    <message>
        <source>Next Sheet</source>
        <translation>Nächstes Blatt</translation>
    </message>
    <message>
        <source>{0} of these {1} sheets are not verified</source>
        <translation>{0} von {1} Blättern sind nicht bestätigt</translation>
    </message>
    <message>
        <source>{folder} is not an environment that GaussianCAD made, and stays as it is.</source>
        <translation>{folder} ist keine Umgebung, die GaussianCAD angelegt hat, und bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>The engine cannot be removed: {reason}. Nothing has changed. Close what uses it, then try again.</source>
        <translation>Die Engine kann nicht entfernt werden: {reason}. Nichts wurde geändert. Schließen Sie, was sie benutzt, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>an NVIDIA card was found</source>
        <translation>eine NVIDIA-Karte wurde gefunden</translation>
    </message>
    <message>
        <source>no NVIDIA card was found</source>
        <translation>keine NVIDIA-Karte wurde gefunden</translation>
    </message>
    <message>
        <source>0.7 GB to download, 3 GB on disk</source>
        <translation>0,7 GB zu laden, 3 GB auf der Platte</translation>
    </message>
    <message>
        <source>3.3 GB to download, 7 GB on disk</source>
        <translation>3,3 GB zu laden, 7 GB auf der Platte</translation>
    </message>
    <message>
        <source>0.4 GB to download, 1.5 GB on disk</source>
        <translation>0,4 GB zu laden, 1,5 GB auf der Platte</translation>
    </message>
    <message>
        <source>PyTorch for {build}: {sizes}</source>
        <translation>PyTorch für {build}: {sizes}</translation>
    </message>
    <message>
        <source>Exact solids only, without surfaces: {sizes}</source>
        <translation>Nur exakte Festkörper, ohne Oberflächen: {sizes}</translation>
    </message>
    <message>
        <source>Reads drawings, makes solids and bodies. Gaussians, their mesh, and Compare with Reference need one of the others.</source>
        <translation>Liest Zeichnungen, macht Festkörper und Körper. Gauß-Verteilungen, ihr Netz und „Mit Referenz vergleichen“ brauchen eine der anderen.</translation>
    </message>
    <message>
        <source>exact solids only</source>
        <translation>nur exakte Festkörper</translation>
    </message>
    <message>
        <source>the processor (CPU)</source>
        <translation>den Prozessor (CPU)</translation>
    </message>
    <message>
        <source>NVIDIA cards (CUDA)</source>
        <translation>NVIDIA-Karten (CUDA)</translation>
    </message>
    <message>
        <source>Choose the Report of a Batch</source>
        <translation>Bericht eines Stapels wählen</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Berichte</translation>
    </message>
    <message>
        <source>Every sheet of this batch is verified.</source>
        <translation>Alle Blätter dieses Stapels sind bestätigt.</translation>
    </message>
    <message>
        <source>Failed Sheets</source>
        <translation>Misslungene Blätter</translation>
    </message>
    <message>
        <source>There is no file {0} any more.</source>
        <translation>Die Datei {0} gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>More settings</source>
        <translation>Weitere Einstellungen</translation>
    </message>
    <message>
        <source>Select a view first: click its frame, or a line in it</source>
        <translation>Wählen Sie zuerst eine Ansicht: klicken Sie auf ihren Rahmen oder auf eine Linie darin</translation>
    </message>
    <message>
        <source>There is no view at this place</source>
        <translation>An dieser Stelle ist keine Ansicht</translation>
    </message>
    <message>
        <source>Lines to Sketches</source>
        <translation>Linien zu Skizzen</translation>
    </message>
    <message>
        <source>Lines {name}</source>
        <translation>Linien {name}</translation>
    </message>
    <message>
        <source>Make Sketches</source>
        <translation>Skizzen machen</translation>
    </message>
    <message>
        <source>Sketches: {sketches}, of {lines} lines.</source>
        <translation>Skizzen: {sketches}, aus {lines} Linien.</translation>
    </message>
    <message>
        <source>What is in doubt is below.</source>
        <translation>Was unsicher ist, steht unten.</translation>
    </message>
    <message>
        <source>The size is not known: the longest extent of the part was made 100 mm. Tell a length in Correct Sheet (key M).</source>
        <translation>Die Größe ist nicht bekannt: Die längste Ausdehnung des Bauteils wurde 100 mm. Geben Sie unter „Blatt korrigieren“ eine Länge an (Taste M).</translation>
    </message>
    <message>
        <source>It is not known where a section looks: it stands beside the front view.</source>
        <translation>Es ist nicht bekannt, wohin ein Schnitt blickt: Er steht neben der Vorderansicht.</translation>
    </message>
    <message>
        <source>What was read of the drawing, {path}, cannot be used ({reason}). Read the drawing again; if that does not help, choose GaussianCAD &gt; Check Engine.</source>
        <translation>Was auf der Zeichnung gelesen wurde, {path}, ist nicht brauchbar ({reason}). Lesen Sie die Zeichnung noch einmal; hilft das nicht, wählen Sie GaussianCAD &gt; Engine prüfen.</translation>
    </message>
    <message>
        <source>Only one view was found. How thick is the part?</source>
        <translation>Es wurde nur eine Ansicht gefunden. Wie dick ist das Teil?</translation>
    </message>
    <message>
        <source>How thick is the part, in mm?</source>
        <translation>Wie dick ist das Teil, in mm?</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>How Thick Is the Part?</source>
        <translation>Wie dick ist das Teil?</translation>
    </message>
    <message>
        <source>The drawing has one view and a thickness, and nothing tells its scale. Tell a length that the view shows, under Scale or {canvas}.</source>
        <translation>Die Zeichnung hat eine Ansicht und eine Dicke, und nichts sagt ihren Maßstab. Geben Sie eine Länge an, die die Ansicht zeigt, unter „Maßstab“ oder {canvas}.</translation>
    </message>
    <message>
        <source>These numbers cannot be set back: {names}</source>
        <translation>Diese Maße lassen sich nicht zurücksetzen: {names}</translation>
    </message>
    <message>
        <source>No body has a number that is another than on the sheet.</source>
        <translation>Kein Körper hat ein anderes Maß als die Zeichnung.</translation>
    </message>
    <message>
        <source>No body was made: the part is no exact solid.</source>
        <translation>Es wurde kein Körper erzeugt: Das Bauteil ist kein exakter Festkörper.</translation>
    </message>
    <message>
        <source>Back to the Sheet&apos;s Numbers</source>
        <translation>Zurück zu den Maßen der Zeichnung</translation>
    </message>
    <message>
        <source>Makes a body with sketches, pads and holes of an exact solid, once that is shown; the solid stays beside it, hidden</source>
        <translation>Erzeugt aus einem exakten Festkörper, sobald er gezeigt ist, einen Körper mit Skizzen, Aufpolsterungen und Bohrungen; der Festkörper bleibt daneben, ausgeblendet</translation>
    </message>
    <message>
        <source>{name}: {sheet} mm on the sheet, {now} mm in the body</source>
        <translation>{name}: {sheet} mm auf der Zeichnung, {now} mm im Körper</translation>
    </message>
    <message>
        <source>Make an editable body</source>
        <translation>Bearbeitbaren Körper erzeugen</translation>
    </message>
    <message>
        <source>The part is the same: its body stays as it is.</source>
        <translation>Das Bauteil ist dasselbe: Sein Körper bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>The body breaks when one of these numbers is changed: {numbers}.</source>
        <translation>Der Körper zerfällt, wenn eines dieser Maße geändert wird: {numbers}.</translation>
    </message>
    <message>
        <source>No body was made: {reason}.</source>
        <translation>Es wurde kein Körper erzeugt: {reason}.</translation>
    </message>
    <message>
        <source>Changing each number on a copy</source>
        <translation>Ändere jedes Maß an einer Kopie</translation>
    </message>
    <message>
        <source>Numbers that were not tried: {count}.</source>
        <translation>Nicht geprüfte Maße: {count}.</translation>
    </message>
    <message>
        <source>No body was made: it was cancelled.</source>
        <translation>Es wurde kein Körper erzeugt: Das wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Break the body when they are changed:</source>
        <translation>Der Körper zerfällt, wenn sie geändert werden:</translation>
    </message>
    <message>
        <source>In the body numbers are others than on the sheet</source>
        <translation>Im Körper sind Maße anders als auf der Zeichnung</translation>
    </message>
    <message>
        <source>Each number can be changed.</source>
        <translation>Jedes Maß lässt sich ändern.</translation>
    </message>
    <message>
        <source>No body was made: several solids fit the sheet. Choose one, then use To Body.</source>
        <translation>Es wurde kein Körper erzeugt: Mehrere Festkörper passen zur Zeichnung. Wählen Sie einen und dann In Körper umwandeln.</translation>
    </message>
    <message>
        <source>The model agrees with the drawing.</source>
        <translation>Das Modell stimmt mit der Zeichnung überein.</translation>
    </message>
    <message>
        <source>The model differs from the drawing.</source>
        <translation>Das Modell weicht von der Zeichnung ab.</translation>
    </message>
    <message>
        <source>It cannot be told whether the model agrees with the drawing.</source>
        <translation>Ob das Modell mit der Zeichnung übereinstimmt, lässt sich nicht sagen.</translation>
    </message>
    <message>
        <source>Missing, hidden</source>
        <translation>Fehlt, verdeckt</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlt</translation>
    </message>
    <message>
        <source>The drawing has a line here that the model does not show.</source>
        <translation>Die Zeichnung hat hier eine Linie, die das Modell nicht zeigt.</translation>
    </message>
    <message>
        <source>Extra, hidden</source>
        <translation>Zu viel, verdeckt</translation>
    </message>
    <message>
        <source>Extra</source>
        <translation>Zu viel</translation>
    </message>
    <message>
        <source>The model has an edge here that the drawing does not show.</source>
        <translation>Das Modell hat hier eine Kante, die die Zeichnung nicht zeigt.</translation>
    </message>
    <message>
        <source>Linetype</source>
        <translation>Linienart</translation>
    </message>
    <message>
        <source>The line is visible in one of both and hidden in the other.</source>
        <translation>Die Linie ist im einen sichtbar und im anderen verdeckt.</translation>
    </message>
    <message>
        <source>Hatching</source>
        <translation>Schraffur</translation>
    </message>
    <message>
        <source>The hatched area is not where the model is cut.</source>
        <translation>Die schraffierte Fläche ist nicht dort, wo das Modell geschnitten ist.</translation>
    </message>
    <message>
        <source>Different</source>
        <translation>Anders</translation>
    </message>
    <message>
        <source>Fill the hole of {diameter} mm at {start}</source>
        <translation>Füllen Sie die Bohrung von {diameter} mm bei {start}</translation>
    </message>
    <message>
        <source>Drill a hole of {diameter} mm at {end}</source>
        <translation>Bohren Sie eine Bohrung von {diameter} mm bei {end}</translation>
    </message>
    <message>
        <source>Move the hole of {diameter} mm from {start} to {end}</source>
        <translation>Verschieben Sie die Bohrung von {diameter} mm von {start} nach {end}</translation>
    </message>
    <message>
        <source>Move the flat face at {start} to {end}</source>
        <translation>Verschieben Sie die ebene Fläche bei {start} nach {end}</translation>
    </message>
    <message>
        <source>Take the mirror image of the model</source>
        <translation>Nehmen Sie das Spiegelbild des Modells</translation>
    </message>
    <message>
        <source>Note “{text}”: the drawing says {stated}, the model has {found}.</source>
        <translation>Notiz „{text}“: Die Zeichnung sagt {stated}, das Modell hat {found}.</translation>
    </message>
    <message>
        <source>The drawing does not say how large the part is: the size was not checked.</source>
        <translation>Die Zeichnung sagt nicht, wie groß das Bauteil ist: Die Größe wurde nicht geprüft.</translation>
    </message>
    <message>
        <source>The model fits the views in no position: it is another part, or the views were read wrong. Check {canvas} how they were read.</source>
        <translation>Das Modell passt in keiner Lage zu den Ansichten: Es ist ein anderes Bauteil, oder die Ansichten wurden falsch gelesen. Prüfen Sie {canvas}, wie sie gelesen wurden.</translation>
    </message>
    <message>
        <source>The views are {stated_mm} mm long along {axis} (x runs along the front view&apos;s width, z up its height), the model is {measured_mm} mm long.</source>
        <translation>Die Ansichten sind längs {axis} {stated_mm} mm lang (x läuft längs der Breite der Vorderansicht, z ihre Höhe hinauf), das Modell ist {measured_mm} mm lang.</translation>
    </message>
    <message>
        <source>The model has {factor} times the size that the drawing&apos;s numbers say.</source>
        <translation>Das Modell ist {factor}-mal so groß, wie die Zahlen der Zeichnung sagen.</translation>
    </message>
    <message>
        <source>The view “{view}” has a circle of {diameter_mm} mm that the model does not show.</source>
        <translation>Die Ansicht „{view}“ hat einen Kreis von {diameter_mm} mm, den das Modell nicht zeigt.</translation>
    </message>
    <message>
        <source>The model shows an edge of {length_mm} mm in the view “{view}” that is not drawn there. Such edges are {total_mm} mm long in all.</source>
        <translation>Das Modell zeigt in der Ansicht „{view}“ eine Kante von {length_mm} mm, die dort nicht gezeichnet ist. Solche Kanten sind insgesamt {total_mm} mm lang.</translation>
    </message>
    <message>
        <source>The section in the view “{view}” is hatched where the model is not cut, or the other way round.</source>
        <translation>Der Schnitt in der Ansicht „{view}“ ist dort schraffiert, wo das Modell nicht geschnitten ist, oder umgekehrt.</translation>
    </message>
    <message>
        <source>The drawing shows shaded pictures in place of lines. They are not read surely enough to say that the model differs.</source>
        <translation>Die Zeichnung zeigt schattierte Bilder statt Linien. Sie werden nicht sicher genug gelesen, um zu sagen, dass das Modell abweicht.</translation>
    </message>
    <message>
        <source>With a single change the model explains the drawing better: it is the first one among the changes.</source>
        <translation>Mit einer einzelnen Änderung erklärt das Modell die Zeichnung besser: Sie steht als erste unter den Änderungen.</translation>
    </message>
    <message>
        <source>{percent} % of the lines that were read disagree with the model, and nothing tells whether the model or the reading is wrong. Check {canvas} how the lines were read.</source>
        <translation>{percent} % der gelesenen Linien passen nicht zum Modell, und nichts sagt, ob das Modell oder das Gelesene falsch ist. Prüfen Sie {canvas}, wie die Linien gelesen wurden.</translation>
    </message>
    <message>
        <source>The model is not closed, or damaged: what it is full of is not certain.</source>
        <translation>Das Modell ist nicht geschlossen oder beschädigt: Wo es voll ist, ist nicht sicher.</translation>
    </message>
    <message>
        <source>The drawing states {stated} mm, the model has {found} mm.</source>
        <translation>Die Zeichnung gibt {stated} mm an, das Modell hat {found} mm.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>A short line of the drawing runs in a direction that no line of the part near it has: a small rounding or chamfer may be missing.</source>
        <translation>Eine kurze Linie der Zeichnung verläuft in einer Richtung, die keine Linie des Teils in ihrer Nähe hat: eine kleine Rundung oder Fase kann fehlen.</translation>
    </message>
    <message>
        <source>Features put together by what they explain</source>
        <translation>Merkmale, zusammengesetzt nach dem, was sie erklären</translation>
    </message>
    <message>
        <source>No solid has all lines as they were read. This part, put together of {count} features, explains {percent} % of them. Check {canvas} which lines are wrong.</source>
        <translation>Kein Festkörper hat alle Linien, wie sie gelesen wurden. Dieses Bauteil, aus {count} Merkmalen zusammengesetzt, erklärt {percent} % davon. Prüfen Sie {canvas}, welche Linien falsch sind.</translation>
    </message>
    <message>
        <source>This part, put together of {count} features, has all lines of the drawing, but nothing proves that no other part has them. Compare it with the sheet.</source>
        <translation>Dieses Bauteil, aus {count} Merkmalen zusammengesetzt, hat alle Linien der Zeichnung, aber nichts beweist, dass kein anderes Bauteil sie hat. Vergleichen Sie es mit dem Blatt.</translation>
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
        <source>Result</source>
        <translation>Ergebnis</translation>
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
        <source>Folder for the engine&apos;s files</source>
        <translation>Ordner für die Dateien der Engine</translation>
    </message>
    <message>
        <source>Keeps the engine&apos;s files in a folder for each run. If empty, they are removed once the document holds the result.</source>
        <translation>Bewahrt die Dateien der Engine in einem Ordner je Lauf auf. Ist das Feld leer, werden sie entfernt, sobald das Dokument das Ergebnis enthält.</translation>
    </message>
    <message>
        <source>Add the drawing&apos;s views as pictures around the part</source>
        <translation>Die Ansichten der Zeichnung als Bilder um das Bauteil stellen</translation>
    </message>
    <message>
        <source>The task panel begins with these settings, and then with those that were used last. A change here counts from the next time that the panel opens. Parts are made in millimetres; sizes are shown in the units that are set under General &gt; Units.</source>
        <translation>Die Aufgabenleiste beginnt mit diesen Einstellungen, danach mit den zuletzt verwendeten. Eine Änderung hier gilt, wenn die Leiste das nächste Mal geöffnet wird. Bauteile entstehen in Millimetern; Größen werden in den Einheiten gezeigt, die unter Allgemein &gt; Einheiten eingestellt sind.</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Check</name>
    <message>
        <source>Check Against Drawing…</source>
        <translation>An Zeichnung prüfen…</translation>
    </message>
    <message>
        <source>Tells whether a part, body or mesh agrees with its drawing, and shows where it does not</source>
        <translation>Sagt, ob ein Bauteil, ein Körper oder ein Netz mit seiner Zeichnung übereinstimmt, und zeigt, wo nicht</translation>
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
        <translation>Blatt korrigieren…</translation>
    </message>
    <message>
        <source>Shows what was understood of a drawing, lets it be corrected, and makes the part</source>
        <translation>Zeigt, was von einer Zeichnung verstanden wurde, lässt es korrigieren und erzeugt das Teil</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_FailedSheets</name>
    <message>
        <source>Open Failed Sheets…</source>
        <translation>Misslungene Blätter öffnen…</translation>
    </message>
    <message>
        <source>Steps through the sheets of a batch that failed or are approximate</source>
        <translation>Geht die Blätter eines Stapels durch, die misslungen oder angenähert sind</translation>
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
    <name>GaussianCAD_LinesToSketches</name>
    <message>
        <source>Lines to Sketches…</source>
        <translation>Linien zu Skizzen…</translation>
    </message>
    <message>
        <source>Makes a sketch on its plane of the lines of each view, to model from by hand</source>
        <translation>Macht aus den Linien jeder Ansicht eine Skizze auf ihrer Ebene, um von Hand zu modellieren</translation>
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
    <name>GaussianCAD_Report</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Shows how far the part can be trusted, why, and what was read of the drawing</source>
        <translation>Zeigt, wie weit dem Bauteil zu trauen ist, warum, und was von der Zeichnung gelesen wurde</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_RunAgain</name>
    <message>
        <source>Run Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Reconstructs the drawing of what is selected again and updates the result</source>
        <translation>Rekonstruiert die Zeichnung des Gewählten noch einmal und aktualisiert das Ergebnis</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_SheetNumbers</name>
    <message>
        <source>Sets all numbers of the body that the drawing tells back to the drawing&apos;s</source>
        <translation>Setzt alle Maße des Körpers, die auf der Zeichnung stehen, auf die der Zeichnung zurück</translation>
    </message>
    <message>
        <source>Back to the Sheet&apos;s Numbers</source>
        <translation>Zurück zu den Maßen der Zeichnung</translation>
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
    <name>GaussianCAD_ToBody</name>
    <message>
        <source>To Body…</source>
        <translation>In Körper umwandeln…</translation>
    </message>
    <message>
        <source>Makes an editable body, with sketches, pads and holes, of the selected solid</source>
        <translation>Erzeugt aus dem ausgewählten Festkörper einen bearbeitbaren Körper mit Skizzen, Aufpolsterungen und Bohrungen</translation>
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
