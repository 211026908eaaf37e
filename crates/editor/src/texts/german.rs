//! What the engine says, in German: one line for each variant of its errors.

use vides_document::error::{
    Bound, EngineError, Index, Invalid, List, OutOfRange, Place, Quantity, TooMany,
};
use vides_engine::deform::counts;
use vides_engine::limits;
use vides_engine::scene::{Channel, Interpolation};
use vides_engine::tools::check::FindingKind;

use super::Language;

/// A text of the library in German.
pub(crate) struct German<'a, T>(pub(crate) &'a T);

/// A text for each variant of an enum; the compiler sees that none is forgotten.
macro_rules! german {
    ($($of:ident {$($variant:ident $(($($at:ident),+))? $({ $($name:ident),+ })? =>
        $text:literal $(, $value:expr)*;)+})+) => {$(
        impl std::fmt::Display for German<'_, $of> {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self.0 {$(
                    $of::$variant $(($($at),+))? $({ $($name),+ })? => write!(f, $text $(, $value)*),
                )+}
            }
        }
    )+};
}
pub(super) use german;

pub(super) fn number(number: f64) -> String {
    Language::German.written(Bound(number).to_string())
}

german! {
    EngineError {
        Argument(cause) => "{}", German(cause);
        Range(cause) => "{}", German(cause);
        Limit(cause) => "{}", German(cause);
        Memory => "der Speicher reicht nicht";
        At(place, cause) => "{}: {}", German(place), German::<EngineError>(cause);
    }
    Place {
        Point(at) => "Punkt {}", Index(*at);
        Orientation(at) => "Blick {}", Index(*at);
        ObjectPoint(at) => "Objektpunkt {}", Index(*at);
        Node(name) => "Knoten „{name}“";
        Channel(name) => "Kanal „{name}“";
        Key(at) => "Schlüssel {}", Index(*at);
        Marker => "Marke";
        Parent => "parent";
        Aim => "aim";
        Name => "der Name";
        Title => "der Titel";
        Unit => "die Einheit";
        Position => "die Position";
        Scale => "die Skalierung";
        Pivot => "der Drehpunkt";
        Step => "die Schrittweite";
        Tangents => "die Tangenten";
        Pose(at) => "Pose {}", Index(*at);
    }
    Quantity {
        AimWeight => "das Gewicht des Zielens";
        Bias => "bias";
        Continuity => "continuity";
        Coordinate => "eine Koordinate";
        CurveSpeed => "jeder Wert einer Zeitkurve";
        DistanceAhead => "der Abstand voraus";
        Frame => "ein Bild";
        Intensity => "die Helligkeit";
        Parameter => "ein Wert einer Verformung";
        Rate => "eine Geschwindigkeit oder Steigung";
        Roll => "der Winkel";
        Tension => "tension";
        Times => "wie oft";
        Value => "ein Wert";
        Zoom => "der Zoom";
    }
    Invalid {
        NotFinite(what) => "{} muss eine endliche Zahl sein", German(what);
        ControlCharacter => "Steuerzeichen sind nicht erlaubt";
        TargetOnCamera => "das Ziel darf nicht auf der Kameraposition liegen";
        BaseSpeed => "eine Grundgeschwindigkeit muss endlich und größer als null sein";
        DistanceNotFinite => "die Schlüssel eines vorgegebenen Wegs müssen endliche Zahlen sein";
        ControlNotUnit => "die Kontrollquaternionen einer Drehung müssen die Länge 1 haben";
        NoNewKey =>
            "in der Blickart barry-goldman würde ein neuer Schlüssel die Ansichten ringsum ändern";
        CentreNotFinite => "der Mittelpunkt des Raums muss endlich sein";
        NoSize => "ein einzelner Ort hat keine Größe, die ein Raum haben könnte";
        ViewNotFinite => "jede Zahl einer Ansicht muss endlich sein";
        NormalZero => "die Normale der Bildebene darf nicht null sein";
        ViewUpZero => "der Aufwärtsvektor einer Ansicht darf nicht null sein";
        ViewUpParallel => "der Aufwärtsvektor darf nicht parallel zur Normale der Bildebene sein";
        LookNotFinite => "Position, Blickrichtung und Aufwärtsvektor müssen endlich sein";
        LookZero => "Blickrichtung und Aufwärtsvektor dürfen nicht null sein";
        UpParallel => "der Aufwärtsvektor darf nicht parallel zur Blickrichtung sein";
        RotationAxis => "die Achse einer Drehung muss endlich und darf nicht null sein";
        RotationNotFinite => "Punkt und Winkel einer Drehung müssen endlich sein";
        RotationZero => "eine Drehung muss endlich und darf nicht null sein";
        QuaternionZero => "eine Quaternion muss endlich und darf nicht null sein";
        NoControlPoint => "eine Bézierkurve braucht mindestens einen Kontrollpunkt";
        ControlPointNotFinite(at) => "der Kontrollpunkt mit Index {at} muss endlich sein";
        CurveTooShort => "eine Kurve braucht mindestens zwei Punkte";
        SplineTooShort => "ein Spline braucht mindestens zwei Punkte";
        KnotCount { points, knots } =>
            "{points} Punkte brauchen ebenso viele Knoten, nicht {knots}";
        PointNotFinite(at) => "der Punkt mit Index {at} muss endlich sein";
        KnotNotFinite(at) => "der Knoten mit Index {at} muss endlich sein";
        KnotOrder(at) => "der Knoten mit Index {at} muss größer sein als der davor";
        EndSlope => "eine Endsteigung muss endlich sein";
        EndTangent => "eine Endtangente muss endlich sein";
        PeriodicEnds => "ein periodischer Spline muss enden, wo er beginnt";
        TimeOrder => "die Zeiten müssen endlich sein und jede später als die davor";
        TimesUnequal =>
            "die Zeiten liegen zu weit oder zu ungleich auseinander, um damit zu rechnen";
        DrawnBound => "die Fehlerschranke einer gezeichneten Kurve muss positiv und endlich sein";
        DrawnNotFinite => "eine gezeichnete Kurve muss endlich sein";
        NoName => "ein Name darf nicht leer sein";
        NodeTwice(name) => "einen Knoten „{name}“ gibt es schon";
        NoNodeNamed(name) => "einen Knoten „{name}“ gibt es nicht";
        KindStays { node, kind } => "„{node}“ ist von der Art „{kind}“ und bleibt es";
        NoObject(name) => "„{name}“ ist kein Objekt";
        NotACamera(name) => "„{name}“ ist keine Kamera";
        Pivot => "Lichter und Kameras haben ihren Drehpunkt bei 0, 0, 0";
        CannotAim => "nur Lichter und Kameras zielen auf etwas";
        AimsAtItself => "er kann nicht auf sich selbst zielen";
        InItself => "er kann nicht in sich selbst liegen";
        ParentMovesWithIt { node, parent } =>
            "Knoten „{node}“ kann nicht in „{parent}“ liegen, das in ihm liegt oder sich mit ihm bewegt";
        AimMovesWithIt { node, parent } =>
            "Knoten „{node}“ kann nicht auf etwas in „{parent}“ zielen, das sich mit ihm bewegt";
        MovesInParent(name) =>
            "„{name}“ bewegt sich in den Koordinaten seines übergeordneten Knotens, und die des anderen sind nicht dieselben";
        NeedsShear(name) =>
            "„{name}“ müsste geschert werden, um in diesem Knoten zu bleiben, wo es ist";
        WayOfPath(name) =>
            "„{name}“ folgt einer Bahn, die ihren Weg nur behält, wo beide übergeordneten Knoten ruhen: bitte erst durch Schlüssel bewegen";
        PathFliesOtherwise(name) =>
            "„{name}“ flöge dort auf einer Bahn nicht dasselbe: bitte erst durch Schlüssel bewegen";
        ScaleZero(name) => "„{name}“ kann nicht bleiben, wo es ist: eine Skalierung ist 0";
        PlaceTooFar => "sein Ort ist zu weit weg oder zu groß, um berechnet zu werden";
        NoMarker(name) => "eine Marke „{name}“ gibt es nicht";
        PinsTurnBack => "seine Marke muss nach der des vorigen angehefteten Punktes kommen";
        PathWithOffset =>
            "ein Pfad hält, wiederholt sich oder läuft hin und her; mit Versatz wiederholt er sich nicht";
        RangeEnds => "das letzte Bild darf nicht vor dem ersten liegen";
        NoChannel(name) => "einen Kanal „{name}“ gibt es nicht; bekannt sind: {}",
            List(Channel::names(None));
        NoChannelOfKind { kind, channel } =>
            "ein Knoten der Art „{kind}“ hat keinen Kanal „{channel}“; er kann haben: {}",
            List(Channel::names(Some(kind)));
        NoShapes => "ein Objekt ohne Formen hat keinen Kanal „weights“";
        NoParameter { deformation, parameter, parameters } =>
            "die Verformung „{deformation}“ hat kein „{parameter}“; sie hat: {}",
            List(parameters.iter().map(|known| known.0));
        NoChannelOfNode { node, channel } => "„{node}“ hat keinen Kanal „{channel}“";
        ChannelWithoutName => "ein eigener Kanal braucht einen Namen: value:NAME";
        KeysMoveIt { node, channel } =>
            "„{node}“ hat eine Spur für {channel}; es bewegt sich durch Schlüssel oder auf einem Pfad";
        PathMovesIt { node, channel } => "„{node}“ folgt einem Pfad, der {channel} bewegt";
        GivenTwice => "das steht weiter oben schon";
        NoKey => "eine Spur braucht einen Schlüssel";
        NoTrack { node, channel } => "„{node}“ hat keine Schlüssel für „{channel}“";
        NotThatChannel { channel, given } =>
            "Schlüssel für „{given}“ passen nicht zum Kanal „{channel}“";
        KeysOutOfOrder => "Schlüssel sind in der Reihenfolge ihrer Bilder zu nennen, jeder einmal";
        HasTrack { channel } => "erst müssen die Schlüssel für „{channel}“ weg";
        NoPathOf(node) => "„{node}“ folgt keiner Bahn";
        MarkerTwice(name) => "eine Marke „{name}“ gibt es schon";
        Pinned(marker) => "an der Marke „{marker}“ hängen Punkte";
        KeyOrder => "sein Bild muss hinter dem des Schlüssels davor liegen";
        SwitchWithOffset => "was nur 0 oder 1 ist, kann sich nicht mit Versatz wiederholen";
        NoInterpolation(name) => "eine Interpolation „{name}“ gibt es nicht; bekannt sind: {}",
            List(Interpolation::names(None));
        NotInterpolated { channel, by } =>
            "er kann nicht mit „{by}“ interpoliert werden, nur mit: {}",
            List(Interpolation::names(Some(channel)));
        InterpolationWithoutName => "eine eigene Interpolation braucht einen Namen";
        NotRegistered { channel, name } =>
            "Kanal „{channel}“: eine Interpolation „host:{name}“ ist nicht angemeldet";
        InterpolationFailed { channel, name } =>
            "Kanal „{channel}“: die Interpolation „host:{name}“ ist gescheitert";
        InterpolationGave { channel, name } =>
            "Kanal „{channel}“: die Interpolation „host:{name}“ gab eine unbrauchbare Zahl";
        MeshOfShapes { given, wanted } =>
            "dieses Netz hat {given} Punkte, die Formen des Objekts haben {wanted}";
        Weight => "ein Gewicht muss eine endliche Zahl bis 1e9 sein";
        NoDeformation(name) =>
            "eine Verformung „{name}“ gibt es nicht; bekannt sind taper, twist, bend, free-form";
        BendAxes => "eine Biegung braucht zwei verschiedene Achsen";
        BoxEnds => "der Quader darf nicht enden, bevor er beginnt";
        NumberNotFinite(name) => "{name} muss eine endliche Zahl sein";
        NoMove { name, known } => "die Fahrt „{name}“ gibt es nicht; bekannt sind: {known}";
        PaceLimit(limit) => "die Grenze „{limit}“ muss größer als 0 sein";
        NoPaceLimit =>
            "ein Tempo braucht eine Grenze: speed, acceleration, jerk, turning, \
             turning-acceleration, zoom oder crossing";
        PaceRests { point, orientation, share, limit } =>
            "ab Punkt {}, Blick {}, bei {} des Wegs müsste das Tempo an einem Knick von Kurve oder \
             Blick ruhen ({limit}): dort einen Punkt setzen oder glätten",
            Index(*point), Index(*orientation), number(*share);
        PaceKeys { point, orientation, limit } =>
            "ab Punkt {}, Blick {} hält kein Tempo aus wenigen Stellen die Grenze „{limit}“: einen \
             Punkt dazwischen setzen",
            Index(*point), Index(*orientation);
        PaceSeconds { seconds, least } =>
            "{} s sind zu kurz: die Grenzen erlauben es in {} s", number(*seconds), number(*least);
        PaceTime => "die Sekunden eines Tempos müssen 0 oder eine positive Zahl sein";
        NoSurface =>
            "ein Rundflug braucht ein Objekt mit Oberfläche: Dreiecke, die nicht alle ohne Fläche sind";
        TourNothing => "aus diesem Abstand zeigt keine Ansicht eines Rundflugs etwas";
        TourStart => "der Beginn eines Rundflugs muss ein Ort sein, der nicht im Objekt oder dicht daneben liegt";
        NoRoomInside => "im Objekt ist kein freier Ort, von dem ein Rundflug es zeigen könnte";
        TourWay => "kein Weg eines Rundflugs bleibt vom Objekt entfernt: einen anderen Abstand wählen";
        AvoidClearance(most) =>
            "der Abstand muss größer als 0 sein, der Radius mindestens 0, beide zusammen höchstens {}",
            number(*most);
        NoWayRound { frame, x, y, z, need } =>
            "bei Bild {}, bei ({}, {}, {}), führt kein Weg um das Objekt, der {} von ihm entfernt bleibt",
            number(*frame), number(*x), number(*y), number(*z), number(*need);
        PictureMargin => "der Rand eines Bildes muss mindestens 0 und kleiner als 0,5 sein";
        PictureBehind { frame } =>
            "bei Bild {} ist nicht das ganze Objekt vor der Kamera, kein Zoom zeigt es ganz",
            number(*frame);
        PictureZoom { frame, zoom } =>
            "bei Bild {} wäre das Objekt mit einem Zoom von {} mm ganz zu sehen, weniger als 1 mm",
            number(*frame), number(*zoom);
        PictureHere { zoom } =>
            "von hier wäre das Objekt erst mit einem Zoom von {} mm ganz zu sehen, weniger als 1 mm",
            number(*zoom);
        PictureLarge { frame } =>
            "bei Bild {} ist das Objekt zu groß für das Bild, wohin auch die Kamera blickt",
            number(*frame);
        PicturePlace => "das Objekt ist ein einzelner Ort, aus jeder Entfernung gleich groß";
        PictureKeys { frame } =>
            "um Bild {} halten keine Blicke das Objekt im Bild: dort einen Punkt setzen oder \
             dem Abschnitt mehr Bilder geben",
            number(*frame);
        NothingSelected => "kein Punkt ist ausgewählt";
        UprightDiffers => "in beiden Pfaden muss dieselbe Achse aufrecht stehen";
        NoNormal => "oben nach „frenet“ braucht eine Kurve der Art cubic, deren Punkte keine \
                     eigenen Tangenten haben, sonst spränge ihre Normale; „minimal“ geht auf \
                     jeder Kurve";
        FixedUp(name) => "das Oben „{name}“ eines Blicks kann nicht mitgehen, wo ein anderer \
                          Achse aufrecht stehen soll; wählen Sie vorher „axis“ dafür";
        NoUp(name) =>
            "es gibt kein oben „{name}“; bekannt: axis, point, path, minimal, frenet, y, z";
        MatrixNotFinite => "jede Zahl einer Matrix muss endlich sein";
        MatrixScale => "der Maßstab einer Matrix muss zwischen 1e-78 und 1e78 liegen, gespiegelt oder nicht";
        MatrixFlat => "die Matrix darf nicht platt drücken: kein Maßstab darf weniger als 1e-12 eines anderen sein";
        Matrix => "die Matrix muss verschieben, drehen, skalieren oder spiegeln, ohne Scherung";
        NoDirection => "um verbunden zu werden, brauchen Pfad und Baustein dort Richtung und Länge";
        PathWeights => "jeder Pfad braucht ein Gewicht";
        ClosedAndOpen => "geschlossene Pfade lassen sich nicht mit offenen mischen";
        NoWay => "die Kamera bewegt sich nicht";
        SteadyBound(within) => "im Abstand von {} vom Flug wurde kein ruhiger Pfad aus ganzen Bildern gefunden", within;
        Cancelled => "es wurde abgebrochen";
        TooFewPoses => "eine Anpassung braucht mindestens zwei Posen";
        PoseTimes => "jede Pose braucht eine Zeit, und Zeiten dürfen nicht rückwärts laufen";
        Outliers { off, all } =>
            "{} von {} Posen weichen von dem ab, was die um sie herum sagen: zu viele, um sie \
             auszulassen; eine größere Toleranz, oder eine Anpassung, die allen folgt", off, all;
        NoCheck(name) => "die Prüfung „{name}“ gibt es nicht; bekannt sind: {}",
            List(FindingKind::all().map(FindingKind::name));
        LimitNan(name) => "die Grenze von {name} muss eine Zahl sein, oder unendlich, wo nichts gesucht \
                           werden soll";
        NoGeometry => "das Objekt hat keine Geometrie";
    }
    OutOfRange {
        Between(what, low, high) =>
            "{} muss zwischen {} und {} liegen", German(what), number(*low), number(*high);
        Exceeds(what, most) => "{} darf höchstens {} sein", German(what), number(*most);
        TooFewSupportPoints => "eine Bahn braucht mindestens zwei Stützpunkte";
        NoPoint { point, last } =>
            "den Punkt {} gibt es nicht: die Bahn hat die Punkte 1 bis {}", Index(*point), Index(*last);
        NoPreset(preset) =>
            "den Standardwert {} gibt es nicht: sie sind von 0 bis 9 nummeriert", preset;
        Orientations => "ein Punkt hat 1 bis 10 Blicke";
        Hold => "das Halten muss zwischen 0 und 1000000 Bildern liegen";
        NoFrame { frame, first, last } =>
            "das Bild {} gibt es nicht: sie gehen von {} bis {}",
            number(*frame), number(*first), number(*last);
        NoPose => "eine Liste hat mindestens eine Pose";
        SectionFrames => "ein Bewegungsabschnitt hat höchstens {} Bilder", limits::MAX_SECTION_FRAMES;
        DistanceKeys => "ein vorgegebener Weg hat 2 bis {} Schlüssel", limits::MAX_DISTANCE_KEYS;
        DistanceOrder =>
            "die Schlüssel eines vorgegebenen Wegs müssen von 0, 0 nach 1, 1 führen, und beide Zahlen müssen steigen";
        EaseShares =>
            "die Zeitanteile für Anfahren und Bremsen dürfen nicht negativ sein und zusammen höchstens 1";
        Part => "ein Teil muss zwischen 0 und 1 beginnen und enden, und zwar nach seinem Anfang";
        PointOrder { first, last } =>
            "der erste Punkt eines Bereichs, {}, darf nicht hinter dem letzten, {}, liegen",
            Index(*first), Index(*last);
        TooFewFrames { frames, least } =>
            "{frames} Bilder sind zu wenige: es müssen mindestens {least} sein";
        TooManyFrames { frames, most } =>
            "{frames} Bilder sind zu viele: es können höchstens {most} sein";
        AtKey(frame) => "bei Bild {} ist die Kamera schon an einem Schlüssel", number(*frame);
        FewerFrames(point) => "auf dem Weg von Punkt {} sind weniger Bilder als neue Punkte", Index(*point);
        Turning { frame, point } =>
            "bei Bild {} dreht sich die Kamera an Punkt {}, dort gibt es keinen Weg zu teilen",
            number(*frame), Index(*point);
        NearPoint => "die Stelle liegt zu nah an einem Punkt des Pfads";
        HalfSize => "die halbe Größe des Raums muss zwischen 1e-30 und 1e30 liegen";
        Centre =>
            "der Mittelpunkt des Raums darf höchstens 1e9 halbe Größen vom Ursprung der Welt entfernt sein";
        FarFromCentre =>
            "eine Koordinate darf höchstens 1e9 halbe Größen vom Mittelpunkt des Raums entfernt sein";
        DistanceAhead =>
            "der Abstand voraus muss zwischen 0 und 1e9 halben Größen des Raums liegen";
        Fps => "die Bilder pro Sekunde müssen größer als 0 und höchstens 100000 sein";
        ViewZoom => "der Zoom einer Ansicht muss positiv und endlich sein";
        PictureHeight => "die Höhe eines Bildes muss positiv und endlich sein";
        FieldOfView => "ein Blickwinkel muss zwischen 0 und 180 Grad liegen, beide ausgenommen";
        ViewAspect => "das Seitenverhältnis einer Ansicht muss positiv und endlich sein";
        FrontPlane => "die vordere Ebene muss in positivem Abstand vor der Kamera liegen";
        BackPlane => "die hintere Ebene muss weiter von der Kamera entfernt sein als die vordere";
        ViewWindow => "das Fenster einer Ansicht darf nicht leer sein";
        ViewPlanes => "die hintere Ebene einer Ansicht muss hinter der vorderen liegen";
        ReferenceBehindFront => "der Projektionsreferenzpunkt muss vor der vorderen Ebene liegen";
        ReferenceInViewPlane => "der Projektionsreferenzpunkt darf nicht in der Bildebene liegen";
        ViewNumbers => "die Zahlen einer Ansicht dürfen nicht so groß oder so nah beieinander sein";
        CameraTooFar => "die Position der Kamera ist zu groß";
        KnotDistance(at) =>
            "die Knoten mit den Indizes {at} und {} dürfen nicht so nah beieinander oder so weit auseinander liegen", at + 1;
        QuaternionKeys =>
            "eine Quaternionenkurve braucht mindestens zwei Schlüssel, jeder mit einer Zeit";
        Time => "die gefragte Zeit muss zwischen dem ersten und dem letzten Schlüssel liegen";
        KeyShapes => "jeder Schlüssel braucht tension, continuity und bias";
        NoNode { node, count } => "unter {count} Knoten, gezählt von 0, ist kein Knoten {node}";
        NoLink { node, number, count, link } =>
            "Knoten „{node}“: unter {count} Knoten, gezählt von 0, ist kein Knoten {number} für {link}";
        NoPathPoint { node, point, count } =>
            "der Pfad von „{node}“ hat unter {count} Punkten, gezählt von 0, keinen Punkt {point}";
        States { nodes, given } => "{nodes} Knoten brauchen ebenso viele Zustände, nicht {given}";
        Colour => "die Zahlen einer Farbe müssen zwischen 0 und 1e9 liegen";
        Cone =>
            "der innere Winkel eines Kegels muss zwischen 0 und dem äußeren liegen, dieser unter 90";
        CameraPlanes =>
            "die vordere Ebene einer Kamera muss hinter 0 und vor der hinteren liegen, diese bis 1e9";
        ChannelWidth =>
            "ein eigener Kanal hat 1 bis {} Zahlen: value:NAME:3", limits::MAX_CHANNEL_WIDTH;
        TrackWidth { channel, wanted, given } =>
            "der Kanal „{channel}“ hat hier {wanted} Zahlen je Schlüssel, nicht {given}";
        KeyNumbers { keys, numbers } =>
            "{keys} Schlüssel können sich {numbers} Zahlen nicht teilen";
        KeyWidth { wanted, given } => "ein Schlüssel hat hier {wanted} Zahlen, nicht {given}";
        KeyShapeNumbers { interpolation, wanted, keys, given } =>
            "die Interpolation „{interpolation}“ braucht {wanted} Zahlen für die Form von {keys} Schlüsseln, nicht {given}";
        KeyDistance =>
            "die Bilder zweier Schlüssel liegen für einen glatten Übergang zu nah beieinander";
        ChannelValue => "ein Wert liegt außerhalb des Bereichs seines Kanals";
        Tangent =>
            "eine Tangente muss endlich sein und darf {} nicht überschreiten", limits::MAX_TANGENT;
        NoMeshPoint { corner, point, count } =>
            "{corner}unter {count} Punkten, gezählt von 0, ist kein Punkt {point}";
        MeshColours { points, given } =>
            "{points} Punkte brauchen ebenso viele Farben, nicht {given}";
        PointRoom { points, given } => "{points} Punkte brauchen ebenso viel Platz, nicht {given}";
        ShapePoints { shape, given, wanted } =>
            "die Form „{shape}“ hat {given} Punkte, das Netz {wanted}";
        ShapeWeights { shapes, given } =>
            "{shapes} Formen brauchen ebenso viele Gewichte, nicht {given}";
        NoShape { at, count } => "unter {count} Formen, gezählt von 0, ist keine {at}";
        NoKeyThere { key, count } =>
            "unter {count} Schlüsseln, gezählt von {}, ist keiner {}", Index(0), Index(*key);
        NoDeformation { at, count } => "unter {count} Verformungen, gezählt von 0, ist keine {at}";
        DeformationNumbers { deformation, given } =>
            "die Verformung „{deformation}“ nimmt nicht {given} Zahlen, sondern {}",
            List(counts(deformation));
        DeformationAxis => "eine Achse einer Verformung ist 0, 1 oder 2";
        NumberBetween(name, low, high) =>
            "{name} muss zwischen {} und {} liegen", number(*low), number(*high);
        NumbersGiven { given, most } =>
            "{given} Zahlen sind angegeben, höchstens {most} gehören hierher";
        ZoomAtEnd(zoom) => "der Zoom wäre am Ende {}; er muss zwischen 1 und 2000 liegen", number(*zoom);
        NoTurn => "die Kamera muss sich um mehr als 0 Grad drehen";
        NoWay => "die Kamera bliebe, wo sie ist: die Fahrt muss anderswo enden, als sie beginnt";
        NoNextPoint => "es gibt keinen nächsten Punkt, an dem der Baustein enden könnte";
        WeightSum(sum) => "die Gewichte müssen zusammen 1 ergeben, nicht {}", number(*sum);
        Tolerance => "die Toleranz muss endlich und größer als 0 sein";
        SteadyPeriod(most) => "die Grenzperiode muss größer als 0 sein, und höchstens {} s (2.000 Bilder)", most;
        SteadyWithin => "die Schranke der Beruhigung muss endlich sein und darf nicht kleiner als 0 sein";
        TooFewFittedPoints =>
            "mit so wenigen Punkten folgt keine Bahn den Posen, auch bei der tausendfachen Toleranz nicht";
        ToleranceAngle => "die Toleranz der Winkel muss größer als 0 sein, und höchstens 180 Grad";
        Coverage => "der Anteil der Oberfläche eines Rundflugs muss größer als 0 und höchstens 1 sein";
        TourDistance =>
            "der Abstand eines Rundflugs muss 0 sein oder zwischen dem {}- und dem {}-Fachen der halben \
             Diagonale des Objekts liegen",
            number(limits::TOUR_DISTANCES[0]), number(limits::TOUR_DISTANCES[1]);
    }
    TooMany {
        NameBytes => "höchstens {} Byte sind erlaubt", limits::MAX_NAME_BYTES;
        CommentBytes => "der Kommentar hat höchstens {} Byte", limits::MAX_COMMENT_BYTES;
        FittedPoints =>
            "innerhalb dieser Toleranz brauchen die Posen mehr als {} Punkte: mit einer größeren \
             folgt der Pfad nicht ihrem Rauschen; oder weniger Posen auf einmal",
            limits::MAX_POINTS;
        UpPathPoints =>
            "eine Bahn für oben hat höchstens {} Punkte", limits::MAX_UP_PATH_POINTS;
        UpPaths => "eine Bahn hat höchstens {} verschiedene Bahnen für oben", limits::MAX_UP_PATHS;
        SupportPoints => "eine Bahn hat höchstens {} Stützpunkte", limits::MAX_POINTS;
        Orientations => "ein Punkt hat höchstens 10 Blicke";
        AllOrientations =>
            "die Punkte einer Bahn haben zusammen höchstens {} Blicke", limits::MAX_ALL_ORIENTATIONS;
        Frames =>
            "die Bahn ergäbe mehr als 100000000 Bilder; die Grundgeschwindigkeiten sind zu hoch";
        SceneFrames(most) => "die Szene hat mehr als {} Bilder", most;
        SampledFrames(frames) =>
            "höchstens {} Bilder lassen sich anpassen, hier sind es {}",
            limits::MAX_SAMPLED_FRAMES, frames;
        PoseSpan(frames) =>
            "die Zeiten der Posen umfassen {:.0} Bilder, höchstens {} sind erlaubt: ihre Einheit \
             prüfen, Zeiten sind Sekunden",
            frames, limits::MAX_FRAMES;
        Poses => "so viele Posen kann eine Liste nicht zählen";
        ControlPoints =>
            "eine Bézierkurve hat höchstens {} Kontrollpunkte", limits::MAX_BEZIER_POINTS;
        CurvePoints => "eine Kurve hat höchstens {} Punkte", limits::MAX_POINTS;
        SplinePoints => "ein Spline hat höchstens {} Punkte", limits::MAX_POINTS;
        QuaternionKeys => "eine Quaternionenkurve hat höchstens 1000000 Schlüssel";
        ObjectPoints => "ein Objekt hat höchstens {} Punkte", limits::MAX_OBJECT_POINTS;
        WireframePoints => "ein Drahtmodell hat höchstens {} Punkte", limits::MAX_OBJECT_POINTS;
        MeshPoints => "ein Objekt hat höchstens {} Punkte", limits::MAX_MESH_POINTS;
        MeshCorners =>
            "ein Objekt hat höchstens {} Ecken von Dreiecken und ebenso viele Enden von Linien", limits::MAX_MESH_CORNERS;
        Shapes => "ein Objekt hat höchstens {} Formen", limits::MAX_SHAPES;
        Deformations => "ein Objekt hat höchstens {} Verformungen", limits::MAX_DEFORMATIONS;
        Nodes => "eine Szene hat höchstens {} Knoten", limits::MAX_NODES;
        Levels => "eine Szene hat höchstens {} Ebenen", limits::MAX_LEVELS;
        Markers => "eine Szene hat höchstens {} Marken", limits::MAX_MARKERS;
        Pins => "in einer Szene sind höchstens {} Punkte angeheftet", limits::MAX_PINS;
        Tracks => "ein Knoten hat höchstens {} Spuren", limits::MAX_TRACKS;
        Keys => "eine Spur hat höchstens {} Schlüssel", limits::MAX_KEYS;
        SceneNumbers =>
            "die Schlüssel einer Szene haben höchstens {} Zahlen", limits::MAX_SCENE_NUMBERS;
        Interpolations =>
            "höchstens {} Interpolationen können angemeldet werden", limits::MAX_INTERPOLATIONS;
    }
}
