// The page: what is shown when, and what keys and pointers do. Texts of the flight are shown as
// text only.

function start() {
  const $ = (id) => document.getElementById(id);
  const [stage, scene, labels, scrub] = ["stage", "scene", "labels", "scrub"].map($);
  const refuse = (why) => {
    document.body.dataset.refused = why;
    $("refusal").hidden = false;
    $("refusal").textContent = words()[why];
  };
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const shape = document.documentElement.dataset;
  shape.theme = dark.matches ? "dark" : "light";

  let flight;
  try {
    flight = readFlight(JSON.parse($("flight").textContent));
    if (!flight.count) throw new Error();
  } catch {
    return refuse("unreadable");
  }
  let views = makeViews(flight, scene, labels);
  if (!views) return refuse("noWebGl");
  const graph = makeGraph(flight, $("graph"));
  const last = flight.count - 1;
  const state = { at: 0, playing: false, loop: false, rate: 1, then: 0, asked: false };
  scrub.max = last;
  for (const element of [scrub, $("play"), $("loop"), $("rate")]) element.disabled = !last;
  for (const rate of [0.25, 0.5, 1, 2, 4]) $("rate").add(new Option("", rate, rate === 1, rate === 1));

  const ratio = () => clamp(window.devicePixelRatio || 1, 1, 3);
  const wanted = () => still.matches && !$("smooth").checked;

  /// The frame that is drawn: with less motion one picture a second while it plays.
  function shown() {
    if (!state.playing) return Math.round(state.at);
    return wanted() ? Math.min(Math.floor(Math.floor(state.at / flight.fps + 1e-9) * flight.fps), last) : state.at;
  }

  function speedText(at) {
    const unit = flight.unit || words().units;
    return `${short(flight.speeds[at])} ${unit}/s`;
  }
  const turningText = (at) => `${short(flight.turns[at])} °/s`;
  /// The number of a frame that people see: not whole where others are written than there are.
  const frameText = (at) => (flight.first + flight.step * at).toLocaleString(language, { maximumFractionDigits: 2 });
  const secondText = (at) => number(at / flight.fps, 2);

  const set = (id, text) => {
    if ($(id).textContent !== text) $(id).textContent = text;
  };
  function write(at) {
    const frame = Math.round(at);
    set("frame", frameText(frame));
    set("second", secondText(frame));
    set("speed", speedText(frame));
    set("turning", turningText(frame));
    const { zoom } = flight.pose(at);
    set("lens", `${number(zoom, 1)} mm · ${number(2 * Math.atan(12 / zoom) * 180 / Math.PI, 1)}°`);
    if (scrub.valueAsNumber !== frame) scrub.value = frame;
    scrub.style.setProperty("--done", `calc(${INSET}px + (100% - ${2 * INSET}px) * ${last ? at / last : 0})`);
    scrub.setAttribute("aria-valuetext", `${words().frame} ${frameText(frame)}, ${secondText(frame)} s`);
  }

  function rectOf(pane) {
    const [outer, inner] = [stage, pane].map((element) => element.getBoundingClientRect());
    return { left: inner.left - outer.left, top: inner.top - outer.top, width: inner.width, height: inner.height };
  }
  function draw() {
    const at = shown();
    const pen = labels.getContext("2d");
    pen.setTransform(ratio(), 0, 0, ratio(), 0, 0);
    pen.clearRect(0, 0, labels.width, labels.height);
    const [space, camera] = [$("space"), $("camera")].map(rectOf);
    if (space.width > 1 && space.height > 1) views.drawSpace(space, ratio(), at);
    if (camera.width > 1 && camera.height > 1) views.drawPicture(camera, ratio(), at);
    const hovered = graph.hovered === null ? null : Math.round(graph.hovered);
    const label = hovered === null ? "" : `${secondText(hovered)} s · ${speedText(hovered)}`;
    graph.draw(views.colours, views.font, at, label);
    write(at);
  }
  function ask() {
    if (state.asked) return;
    state.asked = true;
    requestAnimationFrame(tick);
  }
  function tick(now) {
    state.asked = false;
    if (state.playing) {
      state.at += clamp((now - state.then) / 1000, 0, 0.25) * flight.fps * state.rate;
      state.then = now;
      if (state.at >= last && state.loop && last) state.at %= last;
      else if (state.at >= last) {
        state.at = last;
        play(false);
      }
    }
    if (!views.painter.lost()) draw();
    if (state.playing) ask();
  }

  function play(on) {
    state.playing = on && last > 0;
    state.then = performance.now();
    if (state.playing && state.at >= last) state.at = 0;
    if (!state.playing) state.at = Math.round(state.at);
    $("play-shape").setAttribute("d", state.playing ? "M5 4h3.5v12H5zM11.5 4H15v12h-3.5z" : "M6 3.5v13l11-6.5z");
    name($("play"), words()[state.playing ? "pause" : "play"]);
    ask();
  }
  function seek(at) {
    state.at = clamp(Math.round(at), 0, last);
    ask();
  }
  function jump(way) {
    const frames = flight.points.map((point) => Math.round(point.frame));
    const ahead = frames.filter((frame) => (frame - Math.round(state.at)) * way > 0);
    seek(ahead.length ? (way > 0 ? Math.min(...ahead) : Math.max(...ahead)) : way > 0 ? last : 0);
  }
  function loop() {
    state.loop = !state.loop;
    $("loop").setAttribute("aria-pressed", state.loop);
  }
  function pace(way) {
    const rate = $("rate");
    rate.selectedIndex = clamp(rate.selectedIndex + way, 0, rate.length - 1);
    state.rate = Number(rate.value);
  }
  function only(pane) {
    stage.dataset.only = pane && stage.dataset.only !== pane ? pane : "";
    for (const button of document.querySelectorAll(".enlarge")) button.setAttribute("aria-pressed", button.dataset.pane === stage.dataset.only);
    ask();
  }
  function paint(theme) {
    shape.theme = theme;
    views.recolour();
    ask();
  }
  function name(element, text) {
    element.setAttribute("aria-label", text);
    if (element.tagName !== "SECTION" && element.tagName !== "CANVAS") element.title = text;
  }
  function speak(chosen) {
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
    $("facts").textContent = `${said.frames(flight.count)} · ${secondText(last)} s · ${number(flight.fps, Number.isInteger(flight.fps) ? 0 : 2)} ${said.perSecond}`;
    $("frames").textContent = `/ ${frameText(last)}`;
    $("seconds").textContent = `/ ${secondText(last)} s`;
    for (const option of $("rate").options) option.textContent = `${group(Number(option.value))} ×`;
    $("keys").replaceChildren(...said.keys.flatMap(([keys, meaning]) => ["dt", "dd"].map((kind, at) => {
      const element = document.createElement(kind);
      element.textContent = [keys, meaning][at];
      return element;
    })));
    play(state.playing);
  }

  function measure() {
    const box = stage.getBoundingClientRect();
    for (const canvas of [scene, labels]) {
      canvas.width = Math.max(1, Math.round(box.width * ratio()));
      canvas.height = Math.max(1, Math.round(box.height * ratio()));
    }
    graph.resize(ratio());
    if (!views.painter.lost()) draw();
  }

  const keys = {
    " ": () => play(!state.playing), k: () => play(!state.playing),
    ArrowLeft: (far) => seek(Math.round(state.at) - (far ? flight.fps : 1)), ArrowRight: (far) => seek(Math.round(state.at) + (far ? flight.fps : 1)),
    PageUp: () => jump(-1), PageDown: () => jump(1), ",": () => jump(-1), ".": () => jump(1), Home: () => seek(0), End: () => seek(last),
    l: loop, "-": () => pace(-1), "+": () => pace(1), 1: () => only(""), 2: () => only("space"), 3: () => only("camera"),
    t: () => paint(shape.theme === "dark" ? "light" : "dark"), g: () => speak(language === "de" ? "en" : "de"),
    n: () => flight.comment && $("notes-window").showModal(), "?": () => $("help-window").showModal(),
  };
  keys.ArrowDown = keys.ArrowLeft;
  keys.ArrowUp = keys.ArrowRight;
  const turned = (turn, tilt, aside) => (far) => views.turn(far ? { aside } : { turn, tilt });
  const spaceKeys = {
    ArrowLeft: turned(-5, 0, [-0.1, 0]), ArrowRight: turned(5, 0, [0.1, 0]), ArrowUp: turned(0, 5, [0, 0.1]), ArrowDown: turned(0, -5, [0, -0.1]),
    "+": () => views.turn({ zoom: 1.15 }), "-": () => views.turn({ zoom: 1 / 1.15 }), 0: () => views.reset(),
  };
  document.addEventListener("keydown", (event) => {
    const { target, key } = event;
    if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector("dialog[open]")) return;
    const pressed = target.closest("button, input[type=checkbox]") && (key === " " || key === "Enter");
    if (pressed || target.closest("select")) return;
    const known = key.length === 1 ? key.toLowerCase() : key;
    const act = (target === $("space") && spaceKeys[known]) || (Object.hasOwn(keys, known) && keys[known]);
    if (!act) return;
    event.preventDefault();
    act(event.shiftKey);
    ask();
  });

  $("play").onclick = keys[" "];
  $("loop").onclick = loop;
  $("language").onclick = keys.g;
  $("theme").onclick = keys.t;
  $("help").onclick = keys["?"];
  $("notes").onclick = keys.n;
  $("notes").hidden = !flight.comment.trim();
  $("rate").onchange = () => pace(0);
  $("smooth").onchange = ask;
  scrub.oninput = () => seek(scrub.valueAsNumber);
  for (const button of document.querySelectorAll(".enlarge")) button.onclick = () => only(button.dataset.pane);

  const box = $("graph");
  const follow = (event) => {
    graph.hovered = graph.at(event.clientX - box.getBoundingClientRect().left);
    if (event.buttons & 1) seek(graph.hovered);
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
    const others = [...held.values()].filter((other) => other.pointerId !== event.pointerId);
    const [x, y] = [event.clientX - before.clientX, event.clientY - before.clientY];
    const away = (from) => Math.hypot(from.clientX - others[0].clientX, from.clientY - others[0].clientY) || 1;
    if (others.length) views.turn({ zoom: away(event) / away(before) });
    else if (event.shiftKey) views.turn({ aside: [x, -y].map((value) => value * 3.3 / space.clientHeight / views.look.zoom) });
    else views.turn({ turn: -x * 0.4, tilt: y * 0.4 });
    held.set(event.pointerId, event);
    ask();
  };
  space.ondblclick = keys.reset = () => {
    views.reset();
    ask();
  };
  space.addEventListener("wheel", (event) => {
    event.preventDefault();
    views.turn({ zoom: Math.exp(-event.deltaY * (event.deltaMode ? 0.04 : 0.0015)) });
    ask();
  }, { passive: false });

  dark.onchange = () => paint(dark.matches ? "dark" : "light");
  still.onchange = () => {
    $("smooth-row").hidden = !still.matches;
    ask();
  };
  $("smooth-row").hidden = !still.matches;
  scene.addEventListener("webglcontextlost", (event) => event.preventDefault());
  scene.addEventListener("webglcontextrestored", () => {
    const { look } = views;
    views = makeViews(flight, scene, labels);
    Object.assign(views.look, look);
    paint(shape.theme);
  });

  views.recolour();
  speak(language);
  new ResizeObserver(measure).observe(stage);
  measure();

  /// For tests and for those who look deeper. Poses are counted from 1.
  window.vides = {
    count: flight.count,
    seek(pose) {
      play(false);
      seek(pose - 1);
      draw();
    },
    pose() {
      const at = Math.round(state.at);
      const { place, quaternion, view, up, zoom } = flight.pose(at);
      return { pose: at + 1, frame: flight.first + flight.step * at, seconds: at / flight.fps, position: place.map((value, k) => value + flight.centre[k]), quaternion, view, up, zoom };
    },
    /// Where the camera's picture lies in the window, in CSS pixels.
    picture() {
      const { left, top } = stage.getBoundingClientRect();
      const rect = views.picture(rectOf($("camera")), ratio());
      return { ...rect, left: rect.left + left, top: rect.top + top };
    },
    /// A place of the world in that picture: from its upper left; null behind the camera.
    project(x, y, z) {
      const { width, height } = views.picture(rectOf($("camera")), ratio());
      const place = seen(flight.camera(Math.round(state.at), width / height).matrix, less([x, y, z], flight.centre), width, height);
      return place && { x: place.x, y: place.y };
    },
    play: () => play(true),
    pause: () => play(false),
    get playing() {
      return state.playing;
    },
  };
}

document.addEventListener("DOMContentLoaded", start);
