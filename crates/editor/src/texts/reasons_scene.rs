//! What the library says of scenes; see [`super::reasons`].

/// English, German.
pub(super) const SENTENCES: &[(&str, &str)] = &[
    // Places.
    ("node \"{0}\"", "Knoten „{0}“"),
    ("channel \"{0}\"", "Kanal „{0}“"),
    ("key {0}", "Schlüssel {0}"),
    ("marker", "Marke"),
    ("parent", "parent"),
    ("aim", "aim"),
    ("the position", "die Position"),
    ("the scale", "die Skalierung"),
    ("the pivot", "der Drehpunkt"),
    ("the step", "die Schrittweite"),
    // Files.
    (
        "this is a scene with {0} nodes, not a path alone",
        "das ist eine Szene mit {0} Knoten, kein Pfad allein",
    ),
    (
        "in a scene \"{0}\" belongs to the path of a node",
        "in einer Szene gehört „{0}“ zum Pfad eines Knotens",
    ),
    (
        "a marker has a name and a frame",
        "eine Marke hat einen Namen (name) und ein Bild (frame)",
    ),
    (
        "there is a marker \"{0}\" already",
        "eine Marke „{0}“ gibt es schon",
    ),
    (
        "this node has no name",
        "dieser Knoten hat keinen Namen (name)",
    ),
    (
        "this node has no kind",
        "dieser Knoten hat keine Art (kind)",
    ),
    ("a {0} has none", "das hat ein Knoten der Art „{0}“ nicht"),
    (
        "must be \"group\", \"object\", \"light\" or \"camera\"",
        "muss „group“, „object“, „light“ oder „camera“ sein",
    ),
    (
        "must be \"directional\", \"point\" or \"spot\"",
        "muss „directional“, „point“ oder „spot“ sein",
    ),
    (
        "must be \"hold\", \"repeat\", \"pingpong\" or \"offset\"",
        "muss „hold“, „repeat“, „pingpong“ oder „offset“ sein",
    ),
    (
        "here are rows of numbers before",
        "hier stehen davor Zeilen von Zahlen",
    ),
    (
        "here are single numbers before",
        "hier stehen davor einzelne Zahlen",
    ),
    (
        "{0} keys need as many values, not {1}",
        "{0} Schlüssel brauchen ebenso viele Werte, nicht {1}",
    ),
    (
        "this deformation has no kind",
        "diese Verformung hat keine Art (kind)",
    ),
    (
        "a pin has a point and a marker",
        "zum Anheften gehören ein Punkt (point) und eine Marke (marker)",
    ),
    (
        "a track has a channel, an interpolation, frames and values",
        "eine Spur hat channel, interpolation, frames und values",
    ),
    (
        "this scene has no camera on a path",
        "diese Szene hat keine Kamera auf einem Pfad",
    ),
    // Nodes.
    (
        "a scene has at most {0} nodes",
        "eine Szene hat höchstens {0} Knoten",
    ),
    ("a node needs a name", "ein Knoten braucht einen Namen"),
    (
        "there is a node \"{0}\" already",
        "einen Knoten „{0}“ gibt es schon",
    ),
    (
        "there is no node \"{0}\"",
        "einen Knoten „{0}“ gibt es nicht",
    ),
    (
        "there is no node {0} among {1}, counted from 0",
        "unter {1} Knoten, gezählt von 0, ist kein Knoten {0}",
    ),
    (
        "node \"{0}\": there is no node {1} among {2} for its {3}",
        "Knoten „{0}“: unter {2} Knoten ist kein Knoten {1} für {3}",
    ),
    (
        "node \"{0}\": a scene has at most {1} levels",
        "Knoten „{0}“: eine Szene hat höchstens {1} Ebenen",
    ),
    (
        "node \"{0}\" cannot be in \"{1}\", which is in it or moves with it",
        "Knoten „{0}“ kann nicht in „{1}“ liegen, das in ihm liegt oder sich mit ihm bewegt",
    ),
    (
        "node \"{0}\" cannot aim at what is in \"{1}\", which moves with it",
        "Knoten „{0}“ kann nicht auf etwas in „{1}“ zielen, das sich mit ihm bewegt",
    ),
    (
        "it cannot aim at itself",
        "er kann nicht auf sich selbst zielen",
    ),
    (
        "it cannot be in itself",
        "er kann nicht in sich selbst liegen",
    ),
    (
        "only lights and cameras aim at something",
        "nur Lichter und Kameras zielen auf etwas",
    ),
    (
        "lights and cameras have their pivot at 0, 0, 0",
        "Lichter und Kameras haben ihren Drehpunkt bei 0, 0, 0",
    ),
    (
        "\"{0}\" is a {1} and stays one",
        "„{0}“ ist von der Art „{1}“ und bleibt es",
    ),
    ("\"{0}\" is no object", "„{0}“ ist kein Objekt"),
    (
        "a rotation must be finite and not zero",
        "eine Drehung muss endlich und darf nicht null sein",
    ),
    (
        "a colour's numbers must lie between 0 and 1e9",
        "die Zahlen einer Farbe müssen zwischen 0 und 1e9 liegen",
    ),
    (
        "the intensity must lie between 0 and 1e9",
        "die Helligkeit muss zwischen 0 und 1e9 liegen",
    ),
    (
        "the inner angle of a cone must lie between 0 and the outer one, that one below 90",
        "der innere Winkel eines Kegels muss zwischen 0 und dem äußeren liegen, dieser unter 90",
    ),
    (
        "the weight of an aim must lie between 0 and 1",
        "das Gewicht des Zielens muss zwischen 0 und 1 liegen",
    ),
    (
        "a camera's near plane must lie behind 0 and before the far one, that one within 1e9",
        "die vordere Ebene einer Kamera muss hinter 0 und vor der hinteren liegen, diese bis 1e9",
    ),
    (
        "{0} nodes need as many states, not {1}",
        "{0} Knoten brauchen ebenso viele Zustände, nicht {1}",
    ),
    (
        "its place is too far away or too large to be computed",
        "sein Ort ist zu weit weg oder zu groß, um berechnet zu werden",
    ),
    (
        "\"{0}\" moves in its parent's coordinates, which are not those of the other parent",
        "„{0}“ bewegt sich in den Koordinaten seines übergeordneten Knotens, und die des anderen sind nicht dieselben",
    ),
    (
        "\"{0}\" would need a shear to stay where it is in that parent",
        "„{0}“ müsste geschert werden, um in diesem Knoten zu bleiben, wo es ist",
    ),
    (
        "\"{0}\" cannot stay where it is: a scale is 0",
        "„{0}“ kann nicht bleiben, wo es ist: eine Skalierung ist 0",
    ),
    // Paths, markers.
    (
        "a path holds, repeats or goes back and forth; it has no repeat with offset",
        "ein Pfad hält, wiederholt sich oder läuft hin und her; mit Versatz wiederholt er sich nicht",
    ),
    (
        "a frame must be a finite number",
        "ein Bild muss eine endliche Zahl sein",
    ),
    (
        "a frame must not exceed 1e9",
        "ein Bild darf 1e9 nicht überschreiten",
    ),
    (
        "\"{0}\" has a track of its {1}; it moves by keys or by a path",
        "„{0}“ hat eine Spur für {1}; es bewegt sich durch Schlüssel oder auf einem Pfad",
    ),
    (
        "\"{0}\" follows a path, which moves its {1}",
        "„{0}“ folgt einem Pfad, der {1} bewegt",
    ),
    (
        "the path of \"{0}\" has no point {1} among {2}, counted from 0",
        "der Pfad von „{0}“ hat unter {2} Punkten, gezählt von 0, keinen Punkt {1}",
    ),
    (
        "there is no marker \"{0}\"",
        "eine Marke „{0}“ gibt es nicht",
    ),
    (
        "a scene has at most {0} markers",
        "eine Szene hat höchstens {0} Marken",
    ),
    (
        "a scene has at most {0} pins",
        "in einer Szene sind höchstens {0} Punkte angeheftet",
    ),
    // Tracks.
    (
        "there is no channel \"{0}\"",
        "einen Kanal „{0}“ gibt es nicht",
    ),
    (
        "a {0} has no channel \"{1}\"",
        "ein Knoten der Art „{0}“ hat keinen Kanal „{1}“",
    ),
    (
        "\"{0}\" has no channel \"{1}\"",
        "„{0}“ hat keinen Kanal „{1}“",
    ),
    (
        "a channel of the host's own needs a name: value:NAME",
        "ein eigener Kanal braucht einen Namen: value:NAME",
    ),
    (
        "a channel of the host's own has 1 to {0} numbers: value:NAME:3",
        "ein eigener Kanal hat 1 bis {0} Zahlen: value:NAME:3",
    ),
    (
        "the channel \"{0}\" has {1} numbers a key here, not {2}",
        "der Kanal „{0}“ hat hier {1} Zahlen je Schlüssel, nicht {2}",
    ),
    (
        "a node has at most {0} tracks",
        "ein Knoten hat höchstens {0} Spuren",
    ),
    (
        "the keys of a scene have at most {0} numbers",
        "die Schlüssel einer Szene haben höchstens {0} Zahlen",
    ),
    ("a track needs a key", "eine Spur braucht einen Schlüssel"),
    (
        "a track has at most {0} keys",
        "eine Spur hat höchstens {0} Schlüssel",
    ),
    (
        "{0} keys cannot share {1} numbers",
        "{0} Schlüssel können sich {1} Zahlen nicht teilen",
    ),
    (
        "a key has {0} numbers here, not {1}",
        "ein Schlüssel hat hier {0} Zahlen, nicht {1}",
    ),
    (
        "its frame must lie behind that of the key before",
        "sein Bild muss hinter dem des Schlüssels davor liegen",
    ),
    (
        "the frames of two keys are too close together to be joined smoothly",
        "die Bilder zweier Schlüssel liegen für einen glatten Übergang zu nah beieinander",
    ),
    (
        "a value must be a finite number",
        "ein Wert muss eine endliche Zahl sein",
    ),
    (
        "a value must not exceed 1e9",
        "ein Wert darf 1e9 nicht überschreiten",
    ),
    (
        "a value lies outside the range of its channel",
        "ein Wert liegt außerhalb des Bereichs seines Kanals",
    ),
    (
        "a tangent must be finite and not exceed {0}",
        "eine Tangente muss endlich sein und darf {0} nicht überschreiten",
    ),
    (
        "there is no interpolation \"{0}\"",
        "eine Interpolation „{0}“ gibt es nicht",
    ),
    (
        "this channel cannot be interpolated by \"{0}\"",
        "dieser Kanal kann nicht mit „{0}“ interpoliert werden",
    ),
    (
        "the interpolation \"{0}\" needs {1} numbers for the shape of {2} keys, not {3}",
        "die Interpolation „{0}“ braucht {1} Zahlen für die Form von {2} Schlüsseln, nicht {3}",
    ),
    (
        "what is either 0 or 1 cannot repeat with offset",
        "was nur 0 oder 1 ist, kann sich nicht mit Versatz wiederholen",
    ),
    (
        "an interpolation of the host's own needs a name",
        "eine eigene Interpolation braucht einen Namen",
    ),
    (
        "at most {0} interpolations can be registered",
        "höchstens {0} Interpolationen können angemeldet werden",
    ),
    (
        "channel \"{0}\": no interpolation \"host:{1}\" is registered",
        "Kanal „{0}“: eine Interpolation „host:{1}“ ist nicht angemeldet",
    ),
    (
        "channel \"{0}\": the interpolation \"host:{1}\" failed",
        "Kanal „{0}“: die Interpolation „host:{1}“ ist gescheitert",
    ),
    (
        "channel \"{0}\": the interpolation \"host:{1}\" gave a number that cannot be used",
        "Kanal „{0}“: die Interpolation „host:{1}“ gab eine unbrauchbare Zahl",
    ),
    // Objects.
    (
        "an object has at most {0} corners of triangles and as many ends of lines",
        "ein Objekt hat höchstens {0} Ecken von Dreiecken und ebenso viele Enden von Linien",
    ),
    (
        "{0} points need as many colours, not {1}",
        "{0} Punkte brauchen ebenso viele Farben, nicht {1}",
    ),
    (
        "{0} points need as much room, not {1}",
        "{0} Punkte brauchen ebenso viel Platz, nicht {1}",
    ),
    (
        "there is no point {0} among {1}, counted from 0",
        "unter {1} Punkten, gezählt von 0, ist kein Punkt {0}",
    ),
    (
        "this mesh has {0} points, the object's shapes have {1}",
        "dieses Netz hat {0} Punkte, die Formen des Objekts haben {1}",
    ),
    (
        "the shape \"{0}\" has {1} points, the mesh {2}",
        "die Form „{0}“ hat {1} Punkte, das Netz {2}",
    ),
    (
        "an object has at most {0} shapes",
        "ein Objekt hat höchstens {0} Formen",
    ),
    (
        "{0} shapes need as many weights, not {1}",
        "{0} Formen brauchen ebenso viele Gewichte, nicht {1}",
    ),
    (
        "a weight must be a finite number up to 1e9",
        "ein Gewicht muss eine endliche Zahl bis 1e9 sein",
    ),
    // Deformations.
    (
        "an object has at most {0} deformations",
        "ein Objekt hat höchstens {0} Verformungen",
    ),
    (
        "there is no deformation {0} among {1}, counted from 0",
        "unter {1} Verformungen, gezählt von 0, ist keine {0}",
    ),
    (
        "there is no deformation \"{0}\"; known: taper, twist, bend, free-form",
        "eine Verformung „{0}“ gibt es nicht; bekannt sind taper, twist, bend, free-form",
    ),
    (
        "the deformation \"{0}\" does not take {1} numbers",
        "die Verformung „{0}“ nimmt nicht {1} Zahlen",
    ),
    (
        "an axis of a deformation is 0, 1 or 2",
        "eine Achse einer Verformung ist 0, 1 oder 2",
    ),
    (
        "a bend needs two different axes",
        "eine Biegung braucht zwei verschiedene Achsen",
    ),
    (
        "a parameter of a deformation must be a finite number",
        "ein Wert einer Verformung muss eine endliche Zahl sein",
    ),
    (
        "a parameter of a deformation must not exceed {0}",
        "ein Wert einer Verformung darf {0} nicht überschreiten",
    ),
    (
        "the box must not end before it begins",
        "der Quader darf nicht enden, bevor er beginnt",
    ),
];
