// The two views: what stands in the space, seen from outside and through the camera, and the names
// beside it. It keeps how the space is turned.

const PIECE = 1 / 250; // of the half size: shorter pieces of the way cannot be told apart
const START = { turn: 28, tilt: 20, zoom: 1, aside: [0, 0] };
// Where a name may stand beside its point: in widths of it and lines.
const BESIDE = [[1, -0.8], [1, 0], [1, 0.8], [-1, -0.8], [-1, 0], [-1, 0.8], [0, -1.4], [0, 1.4]];
const meet = (a, b) => a.x <= b.x + b.width && b.x <= a.x + a.width && a.y <= b.y + b.height && b.y <= a.y + a.height;
const FOCAL = 4.2; // of the eye outside: a long lens, so that what is parallel looks so

function makeViews(flight, canvas, labels) {
  const painter = makePainter(canvas);
  if (!painter) return null;
  const pen = labels.getContext("2d");
  const { half } = flight;
  const look = { ...START };
  const upright = (x, height, z) => (flight.zUp ? [x, -z, height] : [x, height, z]);

  const edges = [];
  const grid = [];
  for (let at = 0; at < 12; at++) {
    const [axis, a, b] = [at >> 2, at & 1 ? half : -half, at & 2 ? half : -half];
    const end = (value) => { const place = [0, 0, 0]; place[axis] = value; place[(axis + 1) % 3] = a; place[(axis + 2) % 3] = b; return place; };
    edges.push(...end(-half), ...end(half));
  }
  for (let at = 1; at < 10; at++) {
    const value = half * (at / 5 - 1);
    grid.push(...upright(value, -half, -half), ...upright(value, -half, half), ...upright(-half, -half, value), ...upright(half, -half, value));
  }

  const way = [];
  const flown = []; // the frame at which each piece of the way ends
  const { poses } = flight;
  for (let at = 0, from = 0; at < flight.count; at++) {
    const place = poses.subarray(at * POSE, at * POSE + 3);
    const before = poses.subarray(from * POSE, from * POSE + 3);
    const far = Math.hypot(place[0] - before[0], place[1] - before[1], place[2] - before[2]);
    if (at && at < flight.count - 1 && far < PIECE * half) continue;
    way.push(...place);
    if (at) flown.push(at);
    from = at;
  }
  const ticks = [];
  const every = [1, 2, 5, 10, 30, 60, 300, 600].find((seconds) => flight.count / flight.fps / seconds <= 120) || 3600;
  for (let second = every; second * flight.fps < flight.count - 1; second += every) ticks.push(...flight.pose(second * flight.fps).place);
  const keys = flight.points.map((point) => less(point.position, flight.centre));

  function build(object) {
    const count = object.points.length / 3;
    const joined = new Uint8Array(count);
    for (const at of object.lines) joined[at] = 1;
    for (const at of object.triangles) joined[at] = 1;
    const { points, colours } = object;
    const ends = new Float32Array(object.lines.length * 3);
    const endColours = colours && new Uint8Array(object.lines.length * 3);
    object.lines.forEach((from, at) => {
      ends.set(points.subarray(3 * from, 3 * from + 3), 3 * at);
      if (colours) endColours.set(colours.subarray(3 * from, 3 * from + 3), 3 * at);
    });
    const [alone, aloneColours] = [[], []];
    for (let at = 0; at < count; at++) {
      if (joined[at] || !object.dots) continue;
      for (let k = 3 * at; k < 3 * at + 3; k++) {
        alone.push(points[k]);
        if (colours) aloneColours.push(colours[k]);
      }
    }
    return {
      object,
      lines: painter.lines(ends, false, endColours),
      dots: painter.dots(new Float32Array(alone), colours && new Uint8Array(aloneColours)),
      faces: painter.faces(points, object.triangles, colours),
    };
  }
  const things = flight.objects.map(build);
  const drawn = {
    edges: painter.lines(new Float32Array(edges)), grid: painter.lines(new Float32Array(grid)),
    way: painter.lines(new Float32Array(way), true), ticks: painter.dots(new Float32Array(ticks)),
    keys: painter.dots(new Float32Array(keys.flat())), here: painter.dots(new Float32Array(3)),
    glyph: painter.lines(new Float32Array(6)), arrow: painter.lines(new Float32Array(6)), plumb: painter.lines(new Float32Array(6)),
  };

  let colours = {};
  const hex = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16) / 255);
  const views = { look, painter };

  /// Reads the colours of the page anew.
  views.recolour = () => {
    const style = getComputedStyle(document.documentElement);
    for (const name of ["panel", "field", "picture", "text", "weak", "accent", "flown", "ahead", "grid", "shade", "cube", "object", "face", "turning", "line", "x", "y", "z"]) {
      const text = style.getPropertyValue(`--${name}`).trim();
      colours[name] = text;
      colours[`${name}Gl`] = hex(text);
    }
    views.font = style.getPropertyValue("--font");
    views.colours = colours;
  };
  const solid = (name, alpha = 1) => [...colours[`${name}Gl`], alpha];

  /// Turns, tilts, zooms and moves the space; angles in degrees, `aside` in parts of its half size.
  views.turn = ({ turn = 0, tilt = 0, zoom = 1, aside = [0, 0] }) => {
    look.turn = (look.turn + turn) % 360;
    look.tilt = clamp(look.tilt + tilt, -89, 89);
    look.zoom = clamp(look.zoom * zoom, 0.2, 50);
    look.aside = look.aside.map((value, axis) => clamp(value + aside[axis], -4, 4));
  };
  views.reset = () => Object.assign(look, START);

  function axesOf({ turn, tilt }) {
    const [a, b] = [turn, tilt].map((angle) => angle * Math.PI / 180);
    const [s, c, v, h] = [Math.sin(a), Math.cos(a), Math.sin(b), Math.cos(b)];
    return { right: upright(c, 0, -s), up: upright(-s * v, h, -c * v), back: upright(s * h, v, c * h) };
  }
  // The cube and the way, where that leaves it.
  const extent = way.reduce((far, value) => Math.max(far, Math.abs(value)), half);
  /// How far the eye is for all of it to be seen, however it is turned about its upright axis.
  function fitting(aspect) {
    let distance = 0;
    for (const turn of [START.turn, 45]) {
      const { right, up, back } = axesOf({ ...START, turn });
      for (let at = 0; at < 8; at++) {
        const corner = [1, 2, 4].map((bit) => (at & bit ? extent : -extent));
        const wide = Math.max(Math.abs(dot(right, corner)) / aspect, Math.abs(dot(up, corner)));
        distance = Math.max(distance, dot(back, corner) + wide * FOCAL / 0.94);
      }
    }
    return distance;
  }
  function outside(width, height) {
    const { right, up, back } = axesOf(look);
    const distance = fitting(width / height) / look.zoom;
    const place = back.map((value, k) => value * distance - half * (right[k] * look.aside[0] + up[k] * look.aside[1]));
    const far = Math.hypot(...place) + flight.reach * 1.01;
    const project = perspective(FOCAL, width / height, Math.max(distance / 400, half / 5000), far);
    const eye = looking(place, right, up, back);
    return { project, eye, matrix: multiply(project, eye), axes: { right, up } };
  }

  /// Objects, as the eye of `camera` sees them.
  function drawObjects({ project, matrix, eye }, frame, width) {
    const lift = 0.002 * project[14];
    for (const { object, lines, dots, faces } of things) {
      const place = flight.placed(object, frame);
      if (!place) continue;
      const all = multiply(matrix, place);
      const own = object.colour ? [...object.colour.map((value) => value / 255), 1] : null;
      painter.drawFaces(faces, all, multiply(eye, place), { colour: own || solid("face") });
      painter.drawLines(lines, all, { colour: own || solid("object"), width, lift });
      painter.drawDots(dots, all, { colour: own || solid("object"), width: width + 1.5, lift });
    }
  }

  function drawCamera(matrix, lift, frame) {
    const { place, left, up, view, zoom } = flight.pose(frame);
    const deep = half * 0.18;
    const high = Math.min(deep * 12 / zoom, half * 0.14);
    const wide = high * flight.aspect;
    const at = (x, y, z) => place.map((value, k) => value - left[k] * x + up[k] * y + view[k] * z);
    const corners = [[-wide, high], [wide, high], [wide, -high], [-wide, -high]].map(([x, y]) => at(x, y, deep));
    const glyph = [];
    corners.forEach((corner, k) => glyph.push(...place, ...corner, ...corner, ...corners[(k + 1) % 4]));
    painter.change(drawn.glyph, new Float32Array(glyph));
    const [a, b, top] = [at(-high * 0.4, high * 1.15, deep), at(high * 0.4, high * 1.15, deep), at(0, high * 1.7, deep)];
    painter.change(drawn.arrow, new Float32Array([...a, ...b, ...b, ...top, ...top, ...a]));
    painter.drawLines(drawn.glyph, matrix, { colour: solid("accent"), width: 1.6, lift });
    painter.drawLines(drawn.arrow, matrix, { colour: solid("accent"), width: 1.6, lift });
    const foot = place.map((value, axis) => (axis === (flight.zUp ? 2 : 1) ? -half : value));
    painter.change(drawn.plumb, new Float32Array([...place, ...foot]));
    painter.drawLines(drawn.plumb, matrix, { colour: solid("accent", 0.35), width: 1, lift });
    painter.drawDots(drawn.here, multiply(matrix, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...place, 1]), { colour: solid("accent"), width: 9, lift: lift * 5 });
  }

  /// The space from outside in this rectangle.
  views.drawSpace = (rect, ratio, frame) => {
    painter.begin(rect, ratio, colours.fieldGl);
    const camera = outside(rect.width, rect.height);
    const { matrix, project } = camera;
    const lift = 0.002 * project[14];
    painter.drawLines(drawn.grid, matrix, { colour: solid("grid"), width: 1 });
    painter.drawLines(drawn.edges, matrix, { colour: solid("cube", 0.6), width: 1 });
    const height = flight.zUp ? 2 : 1;
    const ground = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    ground[5 * height] = 0;
    ground[12 + height] = -half;
    painter.drawLines(drawn.way, multiply(matrix, ground), { colour: solid("shade"), width: 2, lift });
    drawObjects(camera, frame, 1.5);
    const done = flown.findIndex((end) => end > frame);
    painter.drawLines(drawn.way, matrix, { colour: solid("flown"), ahead: solid("ahead"), width: 2.4, lift, flown: done < 0 ? flown.length : done });
    painter.drawDots(drawn.ticks, matrix, { colour: solid("flown"), width: 5, lift: lift * 3 });
    painter.drawDots(drawn.keys, matrix, { colour: solid("text"), width: 8, lift: lift * 4 });
    drawCamera(matrix, lift, frame);
    drawNames(rect, camera);
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
    painter.begin(rect, ratio, colours.fieldGl);
    const picture = views.picture(rect, ratio);
    const pane = painter.begin(picture, ratio, colours.pictureGl);
    const camera = flight.camera(frame, pane.width / pane.height);
    painter.drawLines(drawn.grid, camera.matrix, { colour: solid("grid"), width: 1 });
    painter.drawLines(drawn.edges, camera.matrix, { colour: solid("cube", 0.6), width: 1 });
    drawObjects(camera, frame, 1.8);
    const { left, top, width, height } = picture;
    pen.strokeStyle = colours.line;
    pen.lineWidth = 1;
    pen.strokeRect(left + 0.5, top + 0.5, width - 1, height - 1);
  };

  function drawNames({ left, top, width, height }, { matrix, axes }) {
    pen.save();
    pen.beginPath();
    pen.rect(left, top, width, height);
    pen.clip();
    pen.translate(left, top);
    pen.font = `12px ${views.font}`;
    pen.textBaseline = "middle";
    pen.lineJoin = "round";
    pen.lineWidth = 3;
    pen.strokeStyle = colours.field;
    const taken = [{ x: 0, y: 0, width: 160, height: 40 }];
    const spots = [];
    const stride = 3 * Math.max(1, Math.ceil(way.length / 3 / 400));
    for (let at = 0; at < way.length; at += stride) {
      const spot = seen(matrix, way.slice(at, at + 3), width, height);
      if (spot) spots.push({ ...spot, width: 0, height: 0 });
    }
    keys.slice(0, 500).forEach((key, at) => {
      const place = seen(matrix, key, width, height);
      if (!place) return;
      const point = flight.points[at];
      const text = `${point.number}  ${point.name ?? ""}`.trim().slice(0, 60);
      const wide = pen.measureText(text).width;
      const boxes = BESIDE.map(([x, y]) => ({ x: place.x + x * (9 + wide / 2) - wide / 2, y: place.y + y * 14 - 8, width: wide, height: 16 }));
      const within = (box) => box.x >= 0 && box.x + box.width <= width && box.y >= 0 && box.y + box.height <= height;
      const crowd = (box) => (within(box) ? 0 : 50) + 100 * taken.filter((other) => meet(box, other)).length + spots.filter((spot) => meet(box, spot)).length;
      const crowds = boxes.map(crowd);
      const fewest = Math.min(...crowds);
      if (fewest >= 100) return;
      const box = boxes[crowds.indexOf(fewest)];
      taken.push(box);
      pen.fillStyle = colours.weak;
      pen.strokeText(text, box.x, box.y + 8);
      pen.fillText(text, box.x, box.y + 8);
    });
    pen.textAlign = "center";
    pen.lineWidth = 1.5;
    const middle = [38, height - 38];
    [["x", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]]].forEach(([name, axis]) => {
      const [x, y] = [dot(axis, axes.right), -dot(axis, axes.up)];
      pen.strokeStyle = colours[name];
      pen.fillStyle = colours[name];
      pen.beginPath();
      pen.moveTo(...middle);
      pen.lineTo(middle[0] + 18 * x, middle[1] + 18 * y);
      pen.stroke();
      pen.fillText(name, middle[0] + 27 * x, middle[1] + 27 * y);
    });
    pen.restore();
  }
  return views;
}
