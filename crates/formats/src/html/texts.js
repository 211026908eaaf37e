// Every word of the page in both languages.

const TEXTS = {
  en: {
    other: "DE", languageHint: "Deutsch (G)", themeHint: "Light or dark (T)", help: "Keys", notes: "Notes", notesHint: "Notes on this flight (N)", close: "Close",
    untitled: "Camera flight", frames: (n) => (n === 1 ? "1 frame" : `${group(n)} frames`), frame: "Frame", time: "Time",
    perSecond: "frames/s", seconds: "s",
    space: "Space", spaceHint: "Space view. Arrow keys turn it, plus and minus zoom, 0 shows all.",
    camera: "Camera", cameraHint: "What the camera sees", enlarge: "Only this view, or both",
    play: "Play (space)", pause: "Pause (space)", loop: "Again and again (L)", rate: "Pace", smooth: "Smooth motion",
    speed: "Speed", turning: "Turning", graph: "Speed over time", scrub: "Frame", units: "units",
    noWebGl: "This page needs WebGL 2, which this browser does not offer here.",
    unreadable: "The data of this flight cannot be read: the file is incomplete.",
    keys: [["Space, K", "Play, pause"], ["← →", "One frame back or on"], ["Shift ← →", "One second back or on"], ["Page ↑ ↓  , .", "Support point before or after"],
      ["Home, End", "Start, end"], ["L", "Again and again"], ["− +", "Slower, faster"], ["1 2 3", "Both views, space, camera"],
      ["In the space view", "Arrows turn, Shift + arrows move, + − zoom, 0 shows all; so do dragging, Shift-dragging and the wheel"],
      ["T", "Light or dark"], ["G", "Deutsch"], ["N", "Notes on this flight"], ["?", "These keys"]],
  },
  de: {
    other: "EN", languageHint: "English (G)", themeHint: "Hell oder dunkel (T)", help: "Tasten", notes: "Notizen", notesHint: "Notizen zu diesem Flug (N)", close: "Schließen",
    untitled: "Kameraflug", frames: (n) => (n === 1 ? "1 Bild" : `${group(n)} Bilder`), frame: "Bild", time: "Zeit",
    perSecond: "Bilder/s", seconds: "s",
    space: "Raum", spaceHint: "Raumansicht. Pfeiltasten drehen, Plus und Minus zoomen, 0 zeigt alles.",
    camera: "Kamera", cameraHint: "Was die Kamera sieht", enlarge: "Nur diese Ansicht, oder beide",
    play: "Abspielen (Leertaste)", pause: "Anhalten (Leertaste)", loop: "Immer wieder (L)", rate: "Tempo", smooth: "Fließende Bewegung",
    speed: "Geschwindigkeit", turning: "Drehung", graph: "Geschwindigkeit über der Zeit", scrub: "Bild", units: "Einheiten",
    noWebGl: "Diese Seite braucht WebGL 2, das dieser Browser hier nicht bietet.",
    unreadable: "Die Daten dieses Flugs sind nicht lesbar: Die Datei ist unvollständig.",
    keys: [["Leertaste, K", "Abspielen, anhalten"], ["← →", "Ein Bild zurück oder weiter"], ["Umschalt ← →", "Eine Sekunde zurück oder weiter"], ["Bild ↑ ↓  , .", "Stützpunkt davor oder danach"],
      ["Pos1, Ende", "Anfang, Ende"], ["L", "Immer wieder"], ["− +", "Langsamer, schneller"], ["1 2 3", "Beide Ansichten, Raum, Kamera"],
      ["In der Raumansicht", "Pfeile drehen, Umschalt + Pfeile verschieben, + − zoomen, 0 zeigt alles; ebenso Ziehen, Umschalt-Ziehen und Mausrad"],
      ["T", "Hell oder dunkel"], ["G", "English"], ["N", "Notizen zu diesem Flug"], ["?", "Diese Tasten"]],
  },
};

let language = /^de\b/i.test(navigator.language) ? "de" : "en";
const words = () => TEXTS[language];
const number = (value, digits) => value.toLocaleString(language, { minimumFractionDigits: digits, maximumFractionDigits: digits });
const group = (value) => value.toLocaleString(language);

/// About three digits.
function short(value) {
  const size = Math.abs(value);
  if (size >= 1e6 || (size > 0 && size < 1e-3)) return value.toExponential(1).replace(".", language === "de" ? "," : ".");
  return number(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : size >= 0.1 || size === 0 ? 3 : size >= 0.01 ? 4 : 5);
}
