// The flight as numbers: what the data block holds, poses at and between frames, speeds, matrices.
// Places are relative to the middle of the space, so that 32 bits are enough wherever it lies.
// Matrices are lists of 16 numbers, column by column.

const POSE = 8; // place x y z, quaternion w x y z, zoom
const MATRIX = 12; // three axes and the origin of a node

function bytes(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text);
  return Uint8Array.from({ length: raw.length }, (_, at) => raw.charCodeAt(at));
}
const floats = (text) => new Float32Array(bytes(text || "").buffer);
const indices = (text) => new Uint32Array(bytes(text || "").buffer);

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const less = (a, b) => a.map((value, axis) => value - b[axis]);
const mix = (a, b, part) => a + (b - a) * part;
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

function multiply(a, b) {
  const product = new Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[4 * k + row] * b[4 * column + k];
      product[4 * column + row] = sum;
    }
  }
  return product;
}

/// World to eye: x to the right, y up, the view along −z.
function looking(eye, right, up, back) {
  return [
    right[0], up[0], back[0], 0,
    right[1], up[1], back[1], 0,
    right[2], up[2], back[2], 0,
    -dot(right, eye), -dot(up, eye), -dot(back, eye), 1,
  ];
}

/// `focal`: the cotangent of half the vertical field of view.
function perspective(focal, aspect, near, far) {
  const depth = near - far;
  return [focal / aspect, 0, 0, 0, 0, focal, 0, 0, 0, 0, (near + far) / depth, -1, 0, 0, (2 * near * far) / depth, 0];
}

/// Where a place (relative to the middle) is seen: pixels from the upper left; null behind the eye.
function seen(matrix, [x, y, z], width, height) {
  const row = (at) => matrix[at] * x + matrix[at + 4] * y + matrix[at + 8] * z + matrix[at + 12];
  const w = row(3);
  if (w <= 0) return null;
  return { x: (row(0) / w + 1) * width / 2, y: (1 - row(1) / w) * height / 2, w };
}

/// The place of an object; null: it is not seen then.
function placed({ matrices }, at) {
  const last = matrices.length / MATRIX - 1; // 0: it rests
  const low = clamp(Math.floor(at), 0, last) * MATRIX;
  let high = clamp(Math.ceil(at), 0, last) * MATRIX;
  if (Number.isNaN(matrices[low])) return null;
  if (Number.isNaN(matrices[high])) high = low;
  const part = at - Math.floor(at);
  const matrix = [];
  for (let k = 0; k < MATRIX; k++) {
    matrix.push(mix(matrices[low + k], matrices[high + k], part));
    if (k % 3 === 2) matrix.push(k === MATRIX - 1 ? 1 : 0);
  }
  return matrix;
}

/// Space and degrees a second, at each frame: over both neighbours, at the ends over one.
function speedsOf(poses, count, fps) {
  const speeds = new Float32Array(count);
  const turns = new Float32Array(count);
  for (let at = 0; at < count; at++) {
    const [a, b] = [Math.max(at - 1, 0), Math.min(at + 1, count - 1)];
    if (a === b) continue;
    const rate = fps / (b - a);
    const [p, q] = [a * POSE, b * POSE];
    speeds[at] = Math.hypot(poses[q] - poses[p], poses[q + 1] - poses[p + 1], poses[q + 2] - poses[p + 2]) * rate;
    let [same, other] = [0, 0];
    for (let k = 3; k < 7; k++) {
      same += (poses[q + k] - poses[p + k]) ** 2;
      other += (poses[q + k] + poses[p + k]) ** 2;
    }
    const angle = 4 * Math.atan2(Math.sqrt(Math.min(same, other)), Math.sqrt(Math.max(same, other)));
    turns[at] = angle * rate * 180 / Math.PI;
  }
  return { speeds, turns };
}

/// How far the outermost point of all objects is from the middle.
function reachOf(objects, half) {
  let reach = half * Math.sqrt(3);
  for (const object of objects) {
    let farthest = 0;
    for (let at = 0; at + 2 < object.points.length; at += 3) {
      farthest = Math.max(farthest, Math.hypot(object.points[at], object.points[at + 1], object.points[at + 2]));
    }
    for (let at = 0; at < object.matrices.length; at += MATRIX) {
      const matrix = object.matrices.subarray(at, at + MATRIX);
      const size = Math.max(...[0, 3, 6].map((k) => Math.hypot(...matrix.subarray(k, k + 3)))) * Math.sqrt(3);
      const far = Math.hypot(...matrix.subarray(9, 12)) + size * farthest;
      if (far > reach) reach = far; // not for NaN: hidden
    }
  }
  return reach;
}

function readFlight(data) {
  const poses = floats(data.poses);
  const count = Math.floor(poses.length / POSE);
  if (!count) throw new Error("no poses");
  const { centre, half } = data.space;

  /// At frame `at`, counted from 0; between two frames on the straight way from one to the other.
  function pose(at) {
    const low = clamp(Math.floor(at), 0, count - 1);
    const high = Math.min(low + 1, count - 1);
    const part = clamp(at - low, 0, 1);
    const [a, b] = [low * POSE, high * POSE];
    const blend = (from, sign) => mix(poses[a + from], sign * poses[b + from], part);
    let side = 0;
    for (let k = 3; k < 7; k++) side += poses[a + k] * poses[b + k];
    const quaternion = [3, 4, 5, 6].map((k) => blend(k, side < 0 ? -1 : 1));
    const length = Math.hypot(...quaternion) || 1;
    const [w, x, y, z] = quaternion.map((value) => value / length);
    return {
      place: [0, 1, 2].map((k) => blend(k, 1)),
      quaternion: [w, x, y, z],
      left: [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
      up: [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
      view: [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
      zoom: blend(7, 1),
    };
  }

  const objects = data.objects.map((object) => ({
    points: floats(object.points),
    lines: indices(object.lines),
    triangles: indices(object.triangles),
    colours: object.colours ? bytes(object.colours) : null,
    colour: object.colour,
    dots: object.dots,
    matrices: floats(object.matrices),
  }));

  const reach = reachOf(objects, half);

  /// The camera's matrix for a picture of this shape.
  function camera(at, aspect) {
    const { place, left, up, view, zoom } = pose(at);
    const far = Math.hypot(...place) + reach * 1.01;
    const project = perspective(zoom / 12, aspect, half / 2000, far);
    const [right, back] = [left, view].map((axis) => axis.map((value) => -value));
    const eye = looking(place, right, up, back);
    return { project, eye, matrix: multiply(project, eye) };
  }

  return {
    title: String(data.title || ""), comment: String(data.comment || ""), unit: String(data.unit || ""),
    fps: data.fps, first: data.first_frame, step: data.frame_step, zUp: data.up === "z", centre, half, reach,
    aspect: data.size[0] / data.size[1], points: data.points, objects, poses, count, pose, camera, ...speedsOf(poses, count, data.fps),
  };
}
