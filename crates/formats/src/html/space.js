// The two views: the space from outside and through the camera. It keeps how the space is turned.

const START = { turn: 28, tilt: 20, zoom: 1, aside: [0, 0] };
const FOCAL = 4.2; // of the eye outside: a long lens, so that what is parallel looks so
const COLOURS = ["panel", "field", "picture", "text", "weak", "accent", "flown", "ahead", "grid", "shade", "cube", "object", "face", "turning", "line", "x", "y", "z"];

function axesOf(flight, { turn, tilt }) {
  const [a, b] = [turn, tilt].map((angle) => angle * Math.PI / 180);
  const [s, c, v, h] = [Math.sin(a), Math.cos(a), Math.sin(b), Math.cos(b)];
  const axis = (...numbers) => upright(flight, ...numbers);
  return { right: axis(c, 0, -s), up: axis(-s * v, h, -c * v), back: axis(s * h, v, c * h) };
}

/// How far the eye is for a cube to be seen, however it is turned about its upright axis.
function fitting(flight, half, aspect) {
  let distance = 0;
  for (const turn of [START.turn, 45]) {
    const { right, up, back } = axesOf(flight, { ...START, turn });
    for (let at = 0; at < 8; at++) {
      const corner = [1, 2, 4].map((bit) => (at & bit ? half : -half));
      const wide = Math.max(Math.abs(dot(right, corner)) / aspect, Math.abs(dot(up, corner)));
      distance = Math.max(distance, dot(back, corner) + wide * FOCAL / 0.94);
    }
  }
  return distance;
}

/// The eye outside; `extent`: half of what is to be seen.
function outside(flight, look, extent, aspect) {
  const { right, up, back } = axesOf(flight, look);
  const distance = fitting(flight, extent, aspect) / look.zoom;
  const place = back.map((value, k) => value * distance - flight.half * (right[k] * look.aside[0] + up[k] * look.aside[1]));
  const far = Math.hypot(...place) + Math.max(flight.reach, extent * 2) * 1.01;
  const project = perspective(FOCAL, aspect, Math.max(distance / 400, flight.half / 5000), far);
  const eye = looking(place, right, up, back);
  return { project, eye, matrix: multiply(project, eye), axes: { right, up } };
}

/// The camera as a pyramid with an arrow up, and a line down to the ground.
function glyphOf(flight, frame) {
  const { place, left, up, view, zoom } = flight.pose(frame);
  const deep = flight.half * 0.18;
  const high = Math.min(deep * 12 / zoom, flight.half * 0.14);
  const wide = high * flight.aspect;
  const at = (x, y) => place.map((value, k) => value - left[k] * x + up[k] * y + view[k] * deep);
  const corners = [at(-wide, high), at(wide, high), at(wide, -high), at(-wide, -high)];
  const lines = corners.flatMap((corner, k) => [place, corner, corner, corners[(k + 1) % 4]]);
  const [a, b, top] = [at(-high * 0.4, high * 1.15), at(high * 0.4, high * 1.15), at(0, high * 1.7)];
  const foot = [...place];
  foot[heightAxis(flight)] = -flight.half;
  return { place, lines: [...lines, a, b, b, top, top, a].flat(), plumb: [...place, ...foot] };
}

function makeViews(flight, canvas, labels) {
  const views = { look: { ...START }, colours: {}, painter: null };
  const pen = labels.getContext("2d");
  const { look, colours } = views;
  let [painter, things, extent] = [null, null, flight.half];

  /// Makes everything anew on the graphics card; whether there is one.
  views.renew = () => {
    painter = views.painter = makePainter(canvas);
    if (!painter) return false;
    things = makeThings(flight, painter);
    // The way may leave the cube.
    extent = things.places.way.reduce((far, value) => Math.max(far, Math.abs(value)), flight.half);
    return true;
  };
  if (!views.renew()) return null;

  /// Reads the colours of the page anew.
  views.recolour = () => {
    const style = getComputedStyle(document.documentElement);
    for (const name of COLOURS) colours[name] = style.getPropertyValue(`--${name}`).trim();
    views.font = style.getPropertyValue("--font");
  };
  const solid = (name, alpha = 1) => [...[1, 3, 5].map((at) => parseInt(colours[name].slice(at, at + 2), 16) / 255), alpha];

  /// Turns, tilts, zooms and moves the space; angles in degrees, `aside` in parts of its half size.
  views.turn = ({ turn = 0, tilt = 0, zoom = 1, aside = [0, 0] }) => {
    look.turn = (look.turn + turn) % 360;
    look.tilt = clamp(look.tilt + tilt, -89, 89);
    look.zoom = clamp(look.zoom * zoom, 0.2, 50);
    look.aside = look.aside.map((value, axis) => clamp(value + aside[axis], -4, 4));
  };
  views.reset = () => Object.assign(look, START);

  function drawCube({ matrix }) {
    painter.drawLines(things.grid, matrix, { colour: solid("grid"), width: 1 });
    painter.drawLines(things.edges, matrix, { colour: solid("cube", 0.6), width: 1 });
  }
  function drawObjects({ project, matrix, eye }, frame, width) {
    const lift = 0.002 * project[14];
    for (const { object, lines, dots, faces } of things.objects) {
      const place = placed(object, frame);
      if (!place) continue;
      const all = multiply(matrix, place);
      const own = object.colour ? [...object.colour.map((value) => value / 255), 1] : null;
      painter.drawFaces(faces, all, multiply(eye, place), { colour: own || solid("face") });
      painter.drawLines(lines, all, { colour: own || solid("object"), width, lift });
      painter.drawDots(dots, all, { colour: own || solid("object"), width: width + 1.5, lift });
    }
  }
  function drawWay({ matrix }, lift, frame) {
    const done = things.places.ends.findIndex((end) => end > frame);
    const flown = done < 0 ? things.places.ends.length : done;
    painter.drawLines(things.way, matrix, { colour: solid("flown"), ahead: solid("ahead"), width: 2.4, lift, flown });
    painter.drawDots(things.ticks, matrix, { colour: solid("flown"), width: 5, lift: lift * 3 });
    painter.drawDots(things.keys, matrix, { colour: solid("text"), width: 8, lift: lift * 4 });
  }
  /// The way's shadow.
  function drawGround({ matrix }, lift) {
    const ground = moved([0, 0, 0]);
    ground[5 * heightAxis(flight)] = 0;
    ground[12 + heightAxis(flight)] = -flight.half;
    painter.drawLines(things.way, multiply(matrix, ground), { colour: solid("shade"), width: 2, lift });
  }
  function drawCamera({ matrix }, lift, frame) {
    const { place, lines, plumb } = glyphOf(flight, frame);
    painter.change(things.glyph, new Float32Array(lines));
    painter.change(things.plumb, new Float32Array(plumb));
    painter.drawLines(things.glyph, matrix, { colour: solid("accent"), width: 1.6, lift });
    painter.drawLines(things.plumb, matrix, { colour: solid("accent", 0.35), width: 1, lift });
    painter.drawDots(things.here, multiply(matrix, moved(place)), { colour: solid("accent"), width: 9, lift: lift * 5 });
  }

  /// The space from outside in this rectangle.
  views.drawSpace = (rect, ratio, frame) => {
    painter.begin(rect, ratio, solid("field"));
    const camera = outside(flight, look, extent, rect.width / rect.height);
    const lift = 0.002 * camera.project[14];
    drawCube(camera);
    drawGround(camera, lift);
    drawObjects(camera, frame, 1.5);
    drawWay(camera, lift, frame);
    drawCamera(camera, lift, frame);
    drawNames(pen, rect, camera, flight, things.places, views);
  };

  /// The largest picture of the flight's shape within a rectangle, of whole pixels of the screen.
  views.picture = (rect, ratio) => {
    const whole = (value) => Math.round(value * ratio) / ratio;
    const width = Math.max(whole(Math.min(rect.width, rect.height * flight.aspect)), 1);
    const height = Math.max(whole(width / flight.aspect), 1);
    const [left, top] = [rect.left + (rect.width - width) / 2, rect.top + (rect.height - height) / 2];
    return { left: whole(left), top: whole(top), width, height };
  };
  /// What the camera sees.
  views.drawPicture = (rect, ratio, frame) => {
    painter.begin(rect, ratio, solid("field"));
    const picture = views.picture(rect, ratio);
    const pane = painter.begin(picture, ratio, solid("picture"));
    const camera = flight.camera(frame, pane.width / pane.height);
    drawCube(camera);
    drawObjects(camera, frame, 1.8);
    pen.strokeStyle = colours.line;
    pen.lineWidth = 1;
    pen.strokeRect(picture.left + 0.5, picture.top + 0.5, picture.width - 1, picture.height - 1);
  };
  return views;
}
