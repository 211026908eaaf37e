//! What the tools say of their numbers; see [`super::reasons`].

/// English, German.
pub(super) const SENTENCES: &[(&str, &str)] = &[
    (
        "{0}: must be a finite number",
        "{0}: das muss eine endliche Zahl sein",
    ),
    (
        "{0}: must lie between {1} and {2}",
        "{0}: das muss zwischen {1} und {2} liegen",
    ),
    (
        "{0} numbers are given where there are at most {1}",
        "{0} Zahlen sind angegeben, höchstens {1} gehören hierher",
    ),
    (
        "there is no move \"{0}\"; known: {1}",
        "die Fahrt „{0}“ gibt es nicht; bekannt sind: {1}",
    ),
    (
        "the zoom would be {0} at the end; it must lie between 1 and 100",
        "der Zoom wäre am Ende {0}; er muss zwischen 1 und 100 liegen",
    ),
    (
        "the camera must turn by more than 0 degrees",
        "die Kamera muss sich um mehr als 0 Grad drehen",
    ),
    ("no point is selected", "kein Punkt ist ausgewählt"),
    (
        "each number of a matrix must be finite",
        "jede Zahl einer Matrix muss endlich sein",
    ),
    (
        "the matrix must move, turn, scale or mirror, without shear",
        "die Matrix muss verschieben, drehen, skalieren oder spiegeln, ohne Scherung",
    ),
    (
        "path and block need a direction and a length there to be joined",
        "um verbunden zu werden, brauchen Pfad und Baustein dort Richtung und Länge",
    ),
    (
        "there is no next point at which the block could end",
        "es gibt keinen nächsten Punkt, an dem der Baustein enden könnte",
    ),
    (
        "the same axis must stand upright in both paths",
        "in beiden Pfaden muss dieselbe Achse aufrecht stehen",
    ),
    ("each path needs a weight", "jeder Pfad braucht ein Gewicht"),
    (
        "the weights must sum to 1, not to {0}",
        "die Gewichte müssen zusammen 1 ergeben, nicht {0}",
    ),
    (
        "closed paths cannot be blended with open ones",
        "geschlossene Pfade lassen sich nicht mit offenen mischen",
    ),
    ("the fit was cancelled", "die Anpassung wurde abgebrochen"),
    (
        "tolerance, angle and frames per second must be greater than 0",
        "Toleranz, Winkel und Bilder je Sekunde müssen größer als 0 sein",
    ),
    (
        "a fit needs at least three poses",
        "eine Anpassung braucht mindestens drei Posen",
    ),
    (
        "the times of the poses must increase, one for each",
        "die Zeiten der Posen müssen wachsen, eine für jede",
    ),
    ("pose {0}", "Pose {0}"),
    ("all poses are the same", "alle Posen sind gleich"),
    (
        "the poses do not differ by more than the tolerance",
        "die Posen unterscheiden sich um nicht mehr als die Toleranz",
    ),
    (
        "view and up must be two directions",
        "Blick und Oben müssen zwei Richtungen sein",
    ),
    (
        "there is no check \"{0}\"",
        "die Prüfung „{0}“ gibt es nicht",
    ),
    (
        "the object has no geometry",
        "das Objekt hat keine Geometrie",
    ),
    ("the camera does not move", "die Kamera bewegt sich nicht"),
];
