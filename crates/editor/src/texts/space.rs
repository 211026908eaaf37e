//! Texts of the movement window.

use super::texts;

texts! {
    Space {
        name: "Movement window", "Bewegungsfenster";
        size: "Size", "Größe";
        size_tip: "Size of the movement space (mouse wheel, + and −)",
            "Größe des Bewegungsraumes (Mausrad, + und −)";
        rotate: "Rotate", "Drehen";
        rotate_tip: "Turns the movement space about its up axis (drag in the empty space)",
            "Dreht den Bewegungsraum um seine senkrechte Achse (im leeren Raum ziehen)";
        tilt: "Tilt", "Kippen";
        tilt_tip: "Tilts the movement space (drag in the empty space)",
            "Kippt den Bewegungsraum (im leeren Raum ziehen)";
        circle_edge_on: "The circle of the arrow up is seen edge-on: rotate or tilt the space first",
            "Der Kreis des Pfeils nach oben ist nur von der Kante zu sehen: erst den Raum drehen oder kippen";
        position_at: "Position  x {0}  y {1}  z {2}", "Position  x {0}  y {1}  z {2}";
        target_at: "Target  x {0}  y {1}  z {2}", "Ziel  x {0}  y {1}  z {2}";
        offset_at: "Direction  x {0}  y {1}  z {2}", "Richtung  x {0}  y {1}  z {2}";
        tangent_at: "Tangent  x {0}  y {1}  z {2}", "Tangente  x {0}  y {1}  z {2}";
        roll_at: "Roll {0}°", "Winkel {0}°";
        aim_here: "Aim the camera here", "Kamera hierauf richten";
        aim_all_here: "Aim all cameras here", "Alle Kameras hierauf richten";
        empty_hint: "Drag: turn · Shift: move the space · Ctrl: select points",
            "Ziehen: drehen · Umschalt: Raum verschieben · Strg: Punkte auswählen";
        nodes_hint: "Drag: turn · Shift: move the space · Ctrl: select · M, R, S: move, turn, scale the nodes · P: pivot",
            "Ziehen: drehen · Umschalt: Raum verschieben · Strg: auswählen · M, R, S: Knoten bewegen, drehen, skalieren · P: Drehpunkt";
        draw_hint: "Drag: draw a line at the depth of the current point · right button: turn · middle: move the space",
            "Ziehen: Linie zeichnen, so tief, wie der aktuelle Punkt liegt · rechts: drehen · Mitte: Raum verschieben";
        several_hint: "{0} points selected: a change changes all · M, R, S: move, turn, scale · Esc: one",
            "{0} Punkte ausgewählt: Was geschieht, gilt für alle · M, R, S: bewegen, drehen, skalieren · Esc: einer";
        all_points: "Select all points", "Alle Punkte auswählen";
        click_mouse: "Shift or Ctrl, click on a point",
            "Umschalt oder Strg, Klick auf einen Punkt";
        click_meaning: "Add it to the selection, or remove it; actions apply to all selected",
            "Auch auswählen oder nicht mehr; dann gilt alles für alle";
        box_mouse: "Ctrl, drag elsewhere",
            "Strg, daneben ziehen";
        box_meaning: "Select the points in the box; with Shift: these too",
            "Die Punkte im Kasten auswählen; mit Umschalt: dazu";
        one_keys: "Esc, click elsewhere", "Esc, Klick daneben";
        one_meaning: "Select the current point alone", "Nur den aktuellen Punkt auswählen";
        tool_keys: "M, R, S", "M, R, S";
        tool_meaning: "Move, turn, scale what is selected; Esc: as it was",
            "Ausgewählte bewegen, drehen, skalieren; Esc: wie vorher";
        turn_hint: "Drag: turn them about their middle · X, Y, Z: about an axis · type a number",
            "Ziehen: um ihre Mitte drehen · X, Y, Z: um eine Achse · Zahl tippen";
        scale_hint: "Drag: scale them about their middle · X, Y, Z: along an axis · type a number",
            "Ziehen: um ihre Mitte skalieren · X, Y, Z: längs einer Achse · Zahl tippen";
        handle_mouse: "Drag the ring or its square", "Am Ring oder seinem Quadrat ziehen";
        handle_meaning: "Turn or scale several selected points, or nodes",
            "Mehrere ausgewählte Punkte oder Knoten drehen oder skalieren";
        list_keys: "F2, double click in the list", "F2, Doppelklick in der Liste";
        list_meaning: "Type the name of a point; dragging there: another order",
            "Name des Punkts tippen; Ziehen dort: andere Reihenfolge";
        axis_keys: "X, Y, Z, a number, Enter with these", "X, Y, Z, eine Zahl, Enter mit diesen";
        axis_meaning: "Along or about an axis, by a number; for a node's own axis press the letter twice",
            "Längs einer Achse oder um sie, und um so viel; eigene Achse eines Knotens: Buchstabe zweimal";
        node_mouse: "Click on something of a scene", "Klick auf etwas aus einer Szene";
        node_meaning: "Select it; again: the one behind; Ctrl, Shift: several. Drag its pivot: move it",
            "Es auswählen; nochmal: was dahinter liegt; Strg, Umschalt: mehrere. Am Drehpunkt ziehen: bewegen";
        pivot_keys_name: "P", "P";
        pivot_meaning: "Move the pivot of the selected node, which stays", "Drehpunkt des gewählten Knotens bewegen, der bleibt";
        way_mouse: "Drag a square on the way of a node", "Ein Quadrat auf dem Weg eines Knotens ziehen";
        way_meaning: "Move that key of its position", "Diesen Schlüssel seines Ortes bewegen";
        tool_hint: "{0} · X, Y, Z: axis · type a number · Ctrl: in steps · Shift: finer · Enter, click: done · Esc: back",
            "{0} · X, Y, Z: Achse · Zahl tippen · Strg: in Schritten · Umschalt: feiner · Enter, Klick: fertig · Esc: zurück";
        moved_by: "Moved by x {0}  y {1}  z {2}", "Bewegt um x {0}  y {1}  z {2}";
        turned_by: "Turned about {0} by {1}°", "Um {0} gedreht um {1}°";
        scaled_by: "Scaled by {0}", "Skaliert mit {0}";
        scaled_along: "Scaled along {0} by {1}", "Längs {0} skaliert mit {1}";
        nudged: "Along {0} by {1}", "Längs {0} um {1}";
        own_axis: "its own {0}", "das eigene {0}";
        needs_nodes: "Select a node of the scene first", "Erst einen Knoten der Szene auswählen";
        path_moves_it: "“{0}” follows a path, which moves and turns it: move the path's points, or give it keys",
            "„{0}“ folgt einer Bahn, die es bewegt und dreht: deren Punkte bewegen, oder ihm Schlüssel geben";
        pivot_of_flat: "It is flat: with a scale of 0 its pivot cannot be moved",
            "Es ist flach: Bei einer Größe von 0 lässt sich der Drehpunkt nicht bewegen";
        pivot_too_long: "“{0}” turns or scales by keys: its position would need a key in each of more than {1} frames",
            "„{0}“ dreht oder skaliert sich durch Schlüssel: Sein Ort brauchte einen Schlüssel in jedem von mehr als {1} Bildern";
        pivot_moved: "Pivot moved by x {0}  y {1}  z {2}", "Drehpunkt bewegt um x {0}  y {1}  z {2}";
        pivot_keys: "{0} · its position gets a key a frame", "{0} · sein Ort bekommt einen Schlüssel je Bild";
        node_hint: "Drag: move · X, Y, Z: along an axis, twice: its own · M, R, S: move, turn, scale · P: pivot",
            "Ziehen: bewegen · X, Y, Z: Achse, zweimal: eigene · M, R, S: bewegen, drehen, skalieren · P: Drehpunkt";
        key_hint: "Drag: move this key of its position", "Ziehen: diesen Schlüssel seines Ortes bewegen";
        needs_several: "Select several points first: Shift + click, Ctrl + drag, Ctrl + A",
            "Erst mehrere Punkte auswählen: Umschalt + Klick, Strg + Ziehen, Strg + A";
        corner_mouse: "Right click on the object", "Rechtsklick auf das Objekt";
        corner_meaning: "Aim one camera or all at this place; F7: all", "Eine Kamera oder alle auf diese Stelle richten; F7: alle";
        drag_hint: "Drag: left keeps {0}, middle {1}, right {2}",
            "Ziehen: links bleibt {0} fest, Mitte {1}, rechts {2}";
        in_plane: "In the plane {0} = const · X, Y, Z: lock one · a number: distance · Ctrl: in steps · Shift: finer",
            "In der Ebene {0} = const · X, Y, Z: festhalten · Zahl: Abstand · Strg: in Schritten · Umschalt: feiner";
        only_along: "{0} (along {1})", "{0} (längs {1})";
        edge_on: "{0} = const is seen edge-on: only along {1} · rotate or tilt the space for all of the plane",
            "{0} = const ist nur von der Kante zu sehen: nur längs {1} · den Raum drehen oder kippen, um die ganze Ebene zu haben";
        on_line: "Along {0} · X, Y, Z: lock one · a number: distance · Ctrl: in steps · Shift: finer",
            "Längs {0} · X, Y, Z: festhalten · Zahl: Abstand · Strg: in Schritten · Umschalt: feiner";
        rolling: "A number: the roll · Ctrl: in steps of 15° · Shift: finer", "Zahl: die Drehung · Strg: in Schritten von 15° · Umschalt: feiner";
        roll_hint: "Drag: roll the camera", "Ziehen: Kamera um die Blickrichtung drehen";
        tangent_hint: "{0} · {1} · Alt: this side alone", "{0} · {1} · Alt: nur diese Seite";
        before: "Tangent before the point", "Tangente vor dem Punkt";
        after: "Tangent behind the point", "Tangente hinter dem Punkt";
        tangent_mouse: "Drag the end of a tangent", "Am Ende einer Tangente ziehen";
        tangent_meaning: "Bend the curve at a point with custom tangents; Alt: on this side only",
            "Kurve an einem Punkt mit eigenen Tangenten biegen; Alt: nur auf dieser Seite";
        make_closed: "Close the path", "Bahn schließen";
        make_open: "Open the path", "Bahn öffnen";
        scene_last_tip: "Where the scene ends: type a later end to make room for keys, or an earlier one",
            "Wo die Szene endet: ein späteres Ende tippen, um Platz für Schlüssel zu haben, oder ein früheres";
        play: "Play", "Abspielen";
        pause: "Pause", "Anhalten";
        play_tip: "Plays the flight (space bar)", "Spielt den Flug ab (Leertaste)";
        timeline: "Frame", "Bild";
        timeline_tip: "Drag or use the arrow keys to go through the frames",
            "Ziehen oder Pfeiltasten: durch die Bilder gehen";
        frame_number: "Number of the frame", "Nummer des Bildes";
        frame_tip: "Go to a frame: drag, or click and type",
            "Zu einem Bild gehen: ziehen, oder klicken und tippen";
        second: "Seconds", "Sekunden";
        second_tip: "Go to a time: drag, or click and type",
            "Zu einem Zeitpunkt gehen: ziehen, oder klicken und tippen";
        of: "of", "von";
        last_frame: "Last frame", "Letztes Bild";
        last_frame_tip: "Type the number of frames of the whole flight: each section keeps its share", "Wie viele Bilder der ganze Flug haben soll: jeder Abschnitt behält seinen Anteil";
        duration: "Duration", "Dauer";
        duration_tip: "Type the duration of the whole flight: each section keeps its share", "Wie lange der ganze Flug dauern soll: jeder Abschnitt behält seinen Anteil";
        times: "Times of the keys", "Zeiten der Schlüssel";
        times_fixed: "fixed", "fest";
        times_fixed_tip: "The times are fixed: when a point is moved, added or removed, all other keys keep their times. Click: times follow the speed",
            "Die Zeiten sind fest: Wird ein Punkt bewegt, eingefügt oder gelöscht, behalten alle anderen Schlüssel ihre Zeit. Klick: Zeiten folgen dem Tempo";
        times_follow: "follows speed", "folgt dem Tempo";
        times_follow_tip: "The times follow the speed: a longer way takes longer, unless its section has frames of its own (F3). Click: times are fixed",
            "Die Zeiten folgen dem Tempo: Ein längerer Weg dauert länger, außer sein Abschnitt hat eigene Bilder (F3). Klick: Zeiten sind fest";
        rate: "Frames per second", "Bilder je Sekunde";
        rate_tip: "Frames per second; keys keep their time in seconds",
            "Bilder in einer Sekunde; was geschieht, behält seine Sekunde";
        rate_unit: " fps", " B./s";
        again: "Loop", "Endlos";
        again_tip: "Start over at the end (L)", "Am Ende von vorn beginnen (L)";
        only_selected: "Only what is selected", "Nur Ausgewähltes";
        only_selected_tip: "Play and loop only the frames in which the selected nodes move",
            "Nur die Bilder abspielen und wiederholen, in denen sich die gewählten Knoten bewegen";
        pace: "Playing speed", "Abspieltempo";
        pace_tip: "Half, whole or double speed", "Halbes, ganzes oder doppeltes Tempo";
        loop_keys: "L", "L";
        loop_meaning: "Loop: start over at the end when playing", "Endlos: beim Abspielen am Ende von vorn beginnen";
        too_many_frames: "Too many frames", "Zu viele Bilder";
        speed_graph: "Pace", "Tempo";
        plot: "Graph", "Verlauf";
        plot_tip: "What is shown along the path, several over one another, with the values at the playhead; limits of the check are dashed red lines, what an open check has found is marked",
            "Was über der Bahn gezeigt wird, auch mehreres übereinander, mit den Werten am Abspielkopf; Grenzen der Prüfung sind rot gestrichelt, was eine offene Prüfung fand, ist markiert";
        plot_distance: "Distance", "Weg";
        plot_clearance: "Clearance", "Abstand";
        plot_speed: "Speed", "Geschwindigkeit";
        plot_acceleration: "Acceleration", "Beschleunigung";
        plot_turning: "Turning", "Drehung";
        plot_roll: "Roll", "Winkel";
        plot_zoom: "Zoom", "Zoom";
        plot_distance_tip: "How far the camera has come since the first frame",
            "Wie weit die Kamera seit dem ersten Bild gekommen ist";
        plot_clearance_tip: "How near the camera comes to the object",
            "Wie nahe die Kamera dem Objekt kommt";
        plot_speed_tip: "How far the camera moves in a second",
            "Wie weit sich die Kamera in einer Sekunde bewegt";
        plot_acceleration_tip: "By how much the camera's motion changes in a second",
            "Um wie viel sich die Bewegung der Kamera in einer Sekunde ändert";
        plot_turning_tip: "By how many degrees the camera turns in a second",
            "Um wie viel Grad sich die Kamera in einer Sekunde dreht";
        plot_roll_tip: "How far the camera is rolled about its view direction, in degrees",
            "Um wie viel Grad die Kamera um ihre Blickrichtung gedreht ist";
        plot_zoom_tip: "The camera's zoom, in millimetres", "Der Zoom der Kamera, in Millimetern";
        speed_graph_tip: "Speed all along the path; 50 is the base speed, a red step a jump",
            "Geschwindigkeit über die ganze Bahn; 50 ist die Grundgeschwindigkeit, eine rote Stufe ein Sprung";
        speed_graph_switch: "Shows the pace and more all along the path (G)",
            "Zeigt das Tempo und anderes über die ganze Bahn (G)";
        speed_graph_keys: "G", "G";
        speed_graph_meaning: "Pace: show or hide the speed all along the path", "Tempo: die Geschwindigkeit über die ganze Bahn zeigen oder verbergen";
        section_border: "End of section {0}", "Ende des Abschnitts {0}";
        section_border_tip: "Drag: move frames from one section to the other; Shift: ten times finer; Ctrl: a copy of the key",
            "Ziehen: Bilder wechseln vom einen Abschnitt zum anderen; Umschalt: zehnmal feiner; Strg: eine Kopie des Schlüssels";
        camera_whole: "Camera only", "Nur Kamera";
        camera_whole_tip: "The camera's picture in place of the space, and back (Shift+C)",
            "Das Kamerabild an Stelle des Raumes, und zurück (Umschalt+C)";
        camera_menu: "Options of the camera's picture", "Optionen des Kamerabilds";
        camera_corner: "Camera in the corner", "Kamera in der Ecke";
        camera_border: "Border of the camera's picture", "Rand des Kamerabilds";
        camera_beside: "Camera beside the space", "Kamera neben dem Raum";
        camera_beside_tip: "Space and camera side by side, and back (B)",
            "Raum und Kamera nebeneinander, und zurück (B)";
        camera_place_keys: "Shift + C, B", "Umschalt + C, B";
        camera_place_meaning: "Camera's picture alone, beside the space, and back",
            "Kamerabild allein, neben dem Raum, und zurück";
        camera_aspect: "Width by height", "Breite zu Höhe";
        camera_aspect_tip: "Width by height of the picture: click for the next",
            "Breite zu Höhe des Bildes: für das nächste klicken";
        safe_frame: "Safe frame", "Sicherer Bereich";
        safe_frame_tip: "Marks what every screen shows (93 %), and where titles belong (90 %)",
            "Zeigt, was jeder Bildschirm zeigt (93 %) und wohin Titel gehören (90 %)";
        free_view: "Free view", "Freier Blick";
        fly_tip: "Drag: look around; right button: circle; middle button or Shift: shift; wheel, W A S D Q E: walk",
            "Ziehen: umsehen; rechts: umkreisen; Mitte oder Umschalt: verschieben; Rad, W A S D Q E: gehen";
        fly_mouse: "Drag in the large camera picture, W A S D Q E", "Im großen Kamerabild ziehen, W A S D Q E";
        fly_meaning: "Look around, walk; then add it as a point", "Umsehen, gehen; dann als Punkt übernehmen";
        fly_back: "Back", "Zurück";
        fly_back_tip: "To the camera of the path (Esc)", "Zur Kamera der Bahn (Esc)";
        camera_view: "Camera view", "Kamerabild";
        camera_view_tip: "Shows what the camera sees (C)", "Zeigt, was die Kamera sieht (C)";
        camera_picture: "What the camera sees", "Was die Kamera sieht";
        close_camera_view: "Close the camera view", "Kamerabild schließen";
        camera_at_frame: "Camera · frame {0}", "Kamera · Bild {0}";
        camera_at_key: "Camera · point {0}.{1}", "Kamera · Punkt {0}.{1}";
        millimetres: "{0} mm", "{0} mm";
        shift_mouse: "Drag elsewhere, middle button or Shift", "Daneben ziehen, Mitte oder Umschalt";
        shift_meaning: "Shift the space", "Raum verschieben";
        whole_mouse: "Double click elsewhere", "Doppelklick daneben";
        whole_meaning: "See all of it as at first", "Alles sehen wie am Anfang";
        move_keys: "Arrow keys, Page Up, Page Down", "Pfeiltasten, Bild auf, Bild ab";
        move_meaning: "Move the current point; Shift: ten times as far",
            "Aktuellen Punkt bewegen; Umschalt: zehnmal so weit";
        target_keys: "Alt with these", "Alt mit diesen";
        target_meaning: "Move the tip of the view's arrow", "Spitze des Blickpfeils bewegen";
        roll_keys: "Comma, full stop", "Komma, Punkt";
        roll_meaning: "Roll the camera by 1°; Shift: by 10°",
            "Kamera um 1° drehen; Umschalt: um 10°";
        turn_keys: "Ctrl + arrow keys", "Strg + Pfeiltasten";
        turn_meaning: "Rotate and tilt the space", "Raum drehen und kippen";
        size_keys: "+, −, Home", "+, −, Pos1";
        size_meaning: "Size of the space; Home: as at first",
            "Größe des Raumes; Pos1: wie am Anfang";
        next_keys: "N, O", "N, O";
        next_meaning: "Point ›, View ›: the next one; Shift: the one before",
            "Punkt ›, Blick ›: der nächste; Umschalt: der vorige";
        play_keys: "Space bar", "Leertaste";
        play_meaning: "Play, pause", "Abspielen, anhalten";
        camera_keys: "C", "C";
        camera_meaning: "Open and close the camera view", "Kamerabild öffnen und schließen";
        menu_keys: "Shift + F10", "Umschalt + F10";
        menu_meaning: "What can be done with the current point",
            "Was sich mit dem aktuellen Punkt tun lässt";
        facing_mouse: "Drag where a plane is seen edge-on", "Ziehen, wo eine Ebene von der Kante zu sehen ist";
        facing_meaning: "It moves along the line of that plane that is seen",
            "Es geht längs der Geraden dieser Ebene, die zu sehen ist";
        snap_mouse: "Ctrl while dragging", "Strg beim Ziehen";
        snap_meaning: "Go by steps of 0.05, a fifth of the grid; the arrow up by 15°",
            "In Schritten von 0,05, einem Fünftel des Gitters; den Pfeil nach oben um 15°";
        fine_mouse: "Shift while dragging", "Umschalt beim Ziehen";
        fine_meaning: "Ten times finer", "Zehnmal feiner";
        escape_keys: "Esc while dragging", "Esc beim Ziehen";
        escape_meaning: "Leave all as it was", "Alles lassen, wie es war";
        host_view: "program", "Programm";
        no_host_view: "{0}: there is no view to take over", "{0}: Es gibt keine Ansicht zu übernehmen";
        host_view_refused: "{0}: the view cannot be added: {1}",
            "{0}: Die Ansicht lässt sich nicht übernehmen: {1}";
        same_view: "Point {0} already has this view", "Punkt {0} hat diesen Blick schon";
        take_over: "Take over the view", "Ansicht übernehmen";
        take_over_tip: "Add a point after this one, with the program's camera (Ctrl+Enter; with Shift: replace this one)",
            "Ein neuer Punkt hinter diesem, mit der Kamera des Programms (Strg+Enter; mit Umschalt: an Stelle von diesem)";
        take_over_here: "Take over the view here", "Ansicht hierher übernehmen";
        take_over_here_tip: "Replace this point and view with the program's camera",
            "Die Kamera des Programms an Stelle von diesem Punkt und diesem Blick";
        begin_with: "Begin with: {0}", "Beginnen mit: {0}";
        begin_view: "From the view", "Aus der Ansicht";
        begin_open: "Open …", "Öffnen …";
        begin_open_tip: "Open a path, a scene or an object from a file", "Eine Bahn, eine Szene oder ein Objekt aus einer Datei öffnen";
        one_outside: "1 point is outside: Around the path", "1 Punkt liegt außerhalb: Um die Bahn";
        some_outside: "{0} points are outside: Around the path", "{0} Punkte liegen außerhalb: Um die Bahn";
        outside_tip: "Make the space hold the whole path; the path stays where it is",
            "Ein Raum, in dem die ganze Bahn liegt; die Bahn bleibt, wo sie ist";
        view_menu: "Numbers of the view", "Zahlen der Ansicht";
        view_menu_tip: "Size, rotation and tilt of the space, from the front, from above, and the sliders",
            "Größe, Drehung und Kippung des Raumes, von vorn, von oben, und die Schieber";
        view_oblique: "Oblique", "Schräg";
        view_oblique_tip: "From in front, a little from the right and from above", "Von vorn, etwas von rechts und von oben";
        wireframe: "Wireframe", "Drahtmodell";
        wireframe_tip: "Show objects by their edges instead of shaded faces",
            "Objekte durch ihre Kanten zeigen statt durch schattierte Flächen";
        sliders: "Sliders", "Schieber";
        sliders_tip: "Sliders for size, rotation and tilt around the space",
            "Schieber für Größe, Drehung und Kippung um den Raum";
        view_reset: "Reset the view", "Ansicht zurücksetzen";
        view_front: "From the front", "Von vorn";
        view_right: "From the right", "Von rechts";
        view_above: "From above", "Von oben";
    }
}
