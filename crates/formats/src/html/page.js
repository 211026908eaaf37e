// The page: what is shown when, and what keys and pointers do. Texts of the flight are shown as
// text only. `page` is what its parts share: flight, views, graph, player, and what they may ask.

const $ = (id) => document.getElementById(id);
const shape = document.documentElement.dataset;
const system = {
  dark: matchMedia("(prefers-color-scheme: dark)"),
  still: matchMedia("(prefers-reduced-motion: reduce)"),
};
const ratio = () => clamp(window.devicePixelRatio || 1, 1, 3);

function name(element, text) {
  element.setAttribute("aria-label", text);
  if (element.tagName !== "SECTION" && element.tagName !== "CANVAS") element.title = text;
}
function set(id, text) {
  if ($(id).textContent !== text) $(id).textContent = text;
}

/// The time: where the flight stands, and whether it goes on.
function makePlayer(flight, changed) {
  const last = flight.count - 1;
  const player = { at: 0, playing: false, looping: false, rate: 1, last };
  let then = 0;

  player.play = (on) => {
    player.playing = on && last > 0;
    then = performance.now();
    if (player.playing && player.at >= last) player.at = 0;
    if (!player.playing) player.at = Math.round(player.at);
    changed();
  };
  player.seek = (at) => {
    player.at = clamp(Math.round(at), 0, last);
    changed();
  };
  player.step = (frames) => player.seek(Math.round(player.at) + frames);
  /// To the support point before (−1) or after (1).
  player.jump = (way) => {
    const frames = flight.points.map((point) => Math.round(point.frame));
    const ahead = frames.filter((frame) => (frame - Math.round(player.at)) * way > 0);
    const nearest = ahead.reduce((best, frame) => ((frame - best) * way < 0 ? frame : best), way > 0 ? last : 0);
    player.seek(nearest);
  };
  player.advance = (now) => {
    if (!player.playing) return;
    player.at += clamp((now - then) / 1000, 0, 0.25) * flight.fps * player.rate;
    then = now;
    if (player.at < last) return;
    if (player.looping) player.at %= last;
    else {
      player.at = last;
      player.play(false);
    }
  };
  /// The frame that is drawn: with less motion one picture a second while it plays.
  player.shown = () => {
    if (!player.playing) return Math.round(player.at);
    if (!system.still.matches || $("smooth").checked) return player.at;
    return Math.min(Math.floor(Math.floor(player.at / flight.fps + 1e-9) * flight.fps), last);
  };
  return player;
}

/// Numbers of a flight in the language of the page.
function makeWriter(flight) {
  return {
    /// The number of a frame that people see: not whole where others are written than there are.
    frame: (at) => (flight.first + flight.step * at).toLocaleString(language, { maximumFractionDigits: 2 }),
    second: (at) => number(at / flight.fps, 2),
    speed: (at) => `${short(flight.speeds[at])} ${flight.unit || words().units}/s`,
    turning: (at) => `${short(flight.turns[at])} °/s`,
    lens: (zoom) => `${number(zoom, 1)} mm · ${number(2 * Math.atan(12 / zoom) * 180 / Math.PI, 1)}°`,
  };
}

/// Where a pane lies on the stage.
function rectOf(pane) {
  const [outer, inner] = [$("stage"), pane].map((element) => element.getBoundingClientRect());
  return { left: inner.left - outer.left, top: inner.top - outer.top, width: inner.width, height: inner.height };
}

function drawPage({ flight, views, graph, player, writer }) {
  if (views.painter.lost()) return;
  const at = player.shown();
  const pen = $("labels").getContext("2d");
  pen.setTransform(ratio(), 0, 0, ratio(), 0, 0);
  pen.clearRect(0, 0, $("labels").width, $("labels").height);
  const [space, camera] = [$("space"), $("camera")].map(rectOf);
  if (space.width > 1 && space.height > 1) views.drawSpace(space, ratio(), at);
  if (camera.width > 1 && camera.height > 1) views.drawPicture(camera, ratio(), at);
  const hovered = Math.round(graph.hovered ?? 0);
  graph.draw(views.colours, views.font, at, `${writer.second(hovered)} s · ${writer.speed(hovered)}`);

  const frame = Math.round(at);
  set("frame", writer.frame(frame));
  set("second", writer.second(frame));
  set("speed", writer.speed(frame));
  set("turning", writer.turning(frame));
  set("lens", writer.lens(flight.pose(at).zoom));
  const scrub = $("scrub");
  if (scrub.valueAsNumber !== frame) scrub.value = frame;
  scrub.style.setProperty("--done", `calc(${INSET}px + (100% - ${2 * INSET}px) * ${player.last ? at / player.last : 0})`);
  scrub.setAttribute("aria-valuetext", `${words().frame} ${writer.frame(frame)}, ${writer.second(frame)} s`);
  $("play-shape").setAttribute("d", player.playing ? "M5 4h3.5v12H5zM11.5 4H15v12h-3.5z" : "M6 3.5v13l11-6.5z");
  name($("play"), words()[player.playing ? "pause" : "play"]);
}

/// All words in a language, and the flight's own texts.
function speak({ flight, player, writer, ask }, chosen) {
  language = chosen;
  const said = words();
  document.documentElement.lang = language;
  for (const element of document.querySelectorAll("[data-text]")) element.textContent = said[element.dataset.text];
  for (const element of document.querySelectorAll("[data-hint]")) name(element, said[element.dataset.hint]);
  const title = flight.title.trim() || said.untitled;
  document.title = title;
  for (const id of ["title", "notes-title"]) $(id).textContent = title;
  $("title").title = title;
  $("comment").textContent = flight.comment;
  $("language").textContent = said.other;
  const fps = number(flight.fps, Number.isInteger(flight.fps) ? 0 : 2);
  $("facts").textContent = `${said.frames(flight.count)} · ${writer.second(flight.count)} s · ${fps} ${said.perSecond}`;
  $("frames").textContent = `/ ${writer.frame(player.last)}`;
  $("seconds").textContent = `/ ${writer.second(flight.count)} s`;
  for (const option of $("rate").options) option.textContent = `${group(Number(option.value))} ×`;
  $("keys").replaceChildren(...said.keys.flatMap((row) => ["dt", "dd"].map((kind, at) => {
    const element = document.createElement(kind);
    element.textContent = row[at];
    return element;
  })));
  ask();
}

/// What keys and buttons do, by the key.
function commandsOf(page) {
  const { flight, player, views, ask } = page;
  const second = Math.max(1, Math.round(flight.fps));
  const step = (way) => (far) => player.step(far ? way * second : way);
  const jump = (way) => () => player.jump(way);
  const pace = (way) => () => {
    const rate = $("rate");
    rate.selectedIndex = clamp(rate.selectedIndex + way, 0, rate.length - 1);
    player.rate = Number(rate.value);
  };
  const only = (pane) => () => {
    const { dataset } = $("stage");
    dataset.only = dataset.only === pane ? "" : pane;
    for (const button of document.querySelectorAll(".enlarge")) button.setAttribute("aria-pressed", button.dataset.pane === dataset.only);
    ask();
  };
  const play = () => player.play(!player.playing);
  return {
    " ": play, k: play,
    ArrowLeft: step(-1), ArrowDown: step(-1), ArrowRight: step(1), ArrowUp: step(1),
    PageUp: jump(-1), ",": jump(-1), PageDown: jump(1), ".": jump(1),
    Home: () => player.seek(0), End: () => player.seek(player.last),
    l: () => {
      player.looping = !player.looping;
      $("loop").setAttribute("aria-pressed", player.looping);
    },
    "-": pace(-1), "=": pace(0), "+": pace(1),
    1: only(""), 2: only("space"), 3: only("camera"),
    t: () => page.paint(shape.theme === "dark" ? "light" : "dark"),
    g: () => speak(page, language === "de" ? "en" : "de"),
    n: () => flight.comment.trim() && $("notes-window").showModal(),
    "?": () => $("help-window").showModal(),
    space: spaceCommands(views, ask),
  };
}

/// What keys do where the space view has the keyboard.
function spaceCommands(views, ask) {
  const turned = (turn, tilt, aside) => (far) => {
    views.turn(far ? { aside } : { turn, tilt });
    ask();
  };
  const zoomed = (zoom) => () => {
    views.turn({ zoom });
    ask();
  };
  return {
    ArrowLeft: turned(-5, 0, [-0.1, 0]), ArrowRight: turned(5, 0, [0.1, 0]), ArrowUp: turned(0, 5, [0, 0.1]), ArrowDown: turned(0, -5, [0, -0.1]),
    "+": zoomed(1.15), "-": zoomed(1 / 1.15),
    0: () => {
      views.reset();
      ask();
    },
  };
}

function listenToKeys(commands) {
  document.addEventListener("keydown", (event) => {
    const { target, key } = event;
    if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector("dialog[open]")) return;
    const pressed = target.closest("button, input[type=checkbox]") && (key === " " || key === "Enter");
    if (pressed || target.closest("select")) return;
    const known = key.length === 1 ? key.toLowerCase() : key;
    const act = (target === $("space") && commands.space[known]) || (Object.hasOwn(commands, known) && commands[known]);
    if (typeof act !== "function") return;
    event.preventDefault();
    act(event.shiftKey);
  });
}

function listenToButtons({ flight, player, ask }, commands) {
  for (const [id, key] of [["play", " "], ["loop", "l"], ["language", "g"], ["theme", "t"], ["help", "?"], ["notes", "n"]]) {
    $(id).onclick = () => commands[key](false);
  }
  for (const button of document.querySelectorAll(".enlarge")) {
    button.onclick = commands[button.dataset.pane === "space" ? 2 : 3];
  }
  for (const rate of [0.25, 0.5, 1, 2, 4]) $("rate").add(new Option("", rate, rate === 1, rate === 1));
  $("rate").onchange = commands["="];
  $("smooth").onchange = ask;
  $("notes").hidden = !flight.comment.trim();
  const scrub = $("scrub");
  scrub.max = player.last;
  scrub.oninput = () => player.seek(scrub.valueAsNumber);
  for (const element of [scrub, $("play"), $("loop"), $("rate")]) element.disabled = !player.last;
}

function listenToGraph({ graph, player, ask }) {
  const box = $("graph");
  const follow = (event) => {
    graph.hovered = graph.at(event.clientX - box.getBoundingClientRect().left);
    if (event.buttons & 1) player.seek(graph.hovered);
    ask();
  };
  box.onpointerdown = (event) => {
    box.setPointerCapture(event.pointerId);
    follow(event);
  };
  box.onpointermove = follow;
  box.onpointerleave = () => {
    graph.hovered = null;
    ask();
  };
}

/// Dragging turns, with Shift moves; two fingers and the wheel zoom.
function listenToSpace({ views, ask }, commands) {
  const held = new Map();
  const space = $("space");
  space.onpointerdown = (event) => {
    if (event.target.closest("button")) return;
    space.setPointerCapture(event.pointerId);
    held.set(event.pointerId, event);
  };
  space.onpointerup = space.onpointercancel = (event) => held.delete(event.pointerId);
  space.onpointermove = (event) => {
    const before = held.get(event.pointerId);
    if (!before) return;
    const other = [...held.values()].find((finger) => finger.pointerId !== event.pointerId);
    const away = (from) => Math.hypot(from.clientX - other.clientX, from.clientY - other.clientY) || 1;
    const [x, y] = [event.clientX - before.clientX, event.clientY - before.clientY];
    if (other) views.turn({ zoom: away(event) / away(before) });
    else if (event.shiftKey) views.turn({ aside: [x, -y].map((value) => value * 3.3 / space.clientHeight / views.look.zoom) });
    else views.turn({ turn: -x * 0.4, tilt: y * 0.4 });
    held.set(event.pointerId, event);
    ask();
  };
  space.ondblclick = commands.space[0];
  space.addEventListener("wheel", (event) => {
    event.preventDefault();
    views.turn({ zoom: Math.exp(-event.deltaY * (event.deltaMode ? 0.04 : 0.0015)) });
    ask();
  }, { passive: false });
}

/// Size, theme and motion of the system, and a graphics card that goes away and comes back.
function listenToSystem(page) {
  const { views, graph, ask } = page;
  const still = () => {
    $("smooth-row").hidden = !system.still.matches;
    ask();
  };
  system.dark.onchange = () => page.paint(system.dark.matches ? "dark" : "light");
  system.still.onchange = still;
  still();
  new ResizeObserver(() => {
    const box = $("stage").getBoundingClientRect();
    for (const canvas of [$("scene"), $("labels")]) {
      canvas.width = Math.max(1, Math.round(box.width * ratio()));
      canvas.height = Math.max(1, Math.round(box.height * ratio()));
    }
    graph.resize(ratio());
    drawPage(page);
  }).observe($("stage"));
  $("scene").addEventListener("webglcontextlost", (event) => event.preventDefault());
  $("scene").addEventListener("webglcontextrestored", () => {
    views.renew();
    ask();
  });
}

/// For tests and for those who look deeper. Poses are counted from 1.
function interfaceOf(page) {
  const { flight, player, views } = page;
  const picture = () => views.picture(rectOf($("camera")), ratio());
  return {
    count: flight.count,
    seek(pose) {
      player.play(false);
      player.seek(pose - 1);
      drawPage(page);
    },
    pose() {
      const at = Math.round(player.at);
      const { place, quaternion, view, up, zoom } = flight.pose(at);
      const position = place.map((value, axis) => value + flight.centre[axis]);
      return { pose: at + 1, frame: flight.first + flight.step * at, seconds: at / flight.fps, position, quaternion, view, up, zoom };
    },
    /// Where the camera's picture lies in the window, in CSS pixels.
    picture() {
      const stage = $("stage").getBoundingClientRect();
      const { left, top, width, height } = picture();
      return { left: left + stage.left, top: top + stage.top, width, height };
    },
    /// A place of the world in that picture: from its upper left; null behind the camera.
    project(x, y, z) {
      const { width, height } = picture();
      const place = seen(flight.camera(Math.round(player.at), width / height).matrix, less([x, y, z], flight.centre), width, height);
      return place && { x: place.x, y: place.y };
    },
    play: () => player.play(true),
    pause: () => player.play(false),
    get playing() {
      return player.playing;
    },
  };
}

function refuse(why) {
  document.documentElement.lang = language;
  document.body.dataset.refused = why;
  $("refusal").hidden = false;
  $("refusal").textContent = words()[why];
}

function start() {
  shape.theme = system.dark.matches ? "dark" : "light";
  let flight;
  try {
    flight = readFlight(JSON.parse($("flight").textContent));
  } catch {
    return refuse("unreadable");
  }
  const views = makeViews(flight, $("scene"), $("labels"));
  if (!views) return refuse("noWebGl");

  const page = { flight, views, graph: makeGraph(flight, $("graph")), writer: makeWriter(flight) };
  let asked = false;
  page.ask = () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame((now) => {
      asked = false;
      page.player.advance(now);
      drawPage(page);
      if (page.player.playing) page.ask();
    });
  };
  page.paint = (theme) => {
    shape.theme = theme;
    views.recolour();
    page.ask();
  };
  page.player = makePlayer(flight, page.ask);
  views.recolour();
  const commands = commandsOf(page);
  listenToKeys(commands);
  listenToButtons(page, commands);
  listenToGraph(page);
  listenToSpace(page, commands);
  speak(page, language);
  listenToSystem(page);
  window.vides = interfaceOf(page);
}

document.addEventListener("DOMContentLoaded", start);
