// What stands in the space, as buffers of a painter.

const PIECE = 1 / 250; // of the half size: shorter pieces of the way cannot be told apart

/// A place by its height, whichever axis stands upright.
const upright = (flight, x, height, z) => (flight.zUp ? [x, -z, height] : [x, height, z]);
const heightAxis = (flight) => (flight.zUp ? 2 : 1);
const moved = ([x, y, z]) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

/// The edges of the space and a grid on its ground.
function cubeOf(flight) {
  const { half } = flight;
  const [edges, grid] = [[], []];
  const place = (x, height, z) => upright(flight, x, height, z);
  for (const a of [-half, half]) {
    for (const b of [-half, half]) {
      edges.push(...place(-half, a, b), ...place(half, a, b), ...place(a, -half, b), ...place(a, half, b), ...place(a, b, -half), ...place(a, b, half));
    }
  }
  for (let at = 1; at < 10; at++) {
    const value = half * (at / 5 - 1);
    grid.push(...place(value, -half, -half), ...place(value, -half, half), ...place(-half, -half, value), ...place(half, -half, value));
  }
  return { edges, grid };
}

/// The way of the camera in pieces that can be told apart, the frame at which each ends, and dots
/// at equal times, a second or more apart.
function wayOf(flight) {
  const [way, ends, ticks] = [[], [], []];
  const { poses, count, fps } = flight;
  for (let at = 0, from = 0; at < count; at++) {
    const [p, q] = [at * POSE, from * POSE];
    const far = Math.hypot(poses[p] - poses[q], poses[p + 1] - poses[q + 1], poses[p + 2] - poses[q + 2]);
    if (at && at < count - 1 && far < PIECE * flight.half) continue;
    way.push(poses[p], poses[p + 1], poses[p + 2]);
    if (at) ends.push(at);
    from = at;
  }
  const every = [1, 2, 5, 10, 30, 60, 300, 600].find((seconds) => count / fps / seconds <= 120) || 3600;
  for (let second = every; second * fps < count - 1 && ticks.length < 3000; second += every) {
    ticks.push(...flight.pose(second * fps).place);
  }
  return { way, ends, ticks };
}

/// An object's lines, faces, and points that belong to neither.
function buffersOf(painter, object) {
  const { points, lines, triangles, colours } = object;
  const joined = new Uint8Array(points.length / 3);
  for (const at of lines) joined[at] = 1;
  for (const at of triangles) joined[at] = 1;
  const picked = (corners, from, Kind) => {
    const chosen = new Kind(corners.length * 3);
    corners.forEach((corner, at) => chosen.set(from.subarray(3 * corner, 3 * corner + 3), 3 * at));
    return chosen;
  };
  const alone = object.dots ? Array.from(joined.keys()).filter((at) => !joined[at]) : [];
  const coloured = (corners) => colours && picked(corners, colours, Uint8Array);
  return {
    object,
    lines: painter.lines(picked(lines, points, Float32Array), false, coloured(lines)),
    dots: painter.dots(picked(alone, points, Float32Array), coloured(alone)),
    faces: painter.faces(points, triangles, colours),
  };
}

function makeThings(flight, painter) {
  const { edges, grid } = cubeOf(flight);
  const { way, ends, ticks } = wayOf(flight);
  const keys = flight.points.map((point) => less(point.position, flight.centre));
  const lines = (numbers, joined) => painter.lines(new Float32Array(numbers), joined);
  const dots = (numbers) => painter.dots(new Float32Array(numbers));
  return {
    edges: lines(edges), grid: lines(grid), way: lines(way, true), ticks: dots(ticks), keys: dots(keys.flat()),
    here: dots([0, 0, 0]), glyph: lines([]), plumb: lines([]),
    objects: flight.objects.map((object) => buffersOf(painter, object)),
    places: { way, ends, keys },
  };
}
