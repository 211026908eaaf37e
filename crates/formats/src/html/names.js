// The names of the support points beside them, where they hide least, and the axes.

// Where a name may stand: in widths of it and lines.
const BESIDE = [[1, -0.8], [1, 0], [1, 0.8], [-1, -0.8], [-1, 0], [-1, 0.8], [0, -1.4], [0, 1.4]];
const MOST = 500; // more names cannot be read
const HEADING = { x: 0, y: 0, width: 160, height: 40 };
const meet = (a, b) => a.x <= b.x + b.width && b.x <= a.x + a.width && a.y <= b.y + b.height && b.y <= a.y + a.height;

/// Some places of the way as they are seen.
function spotsOf(way, matrix, width, height) {
  const spots = [];
  const stride = 3 * Math.max(1, Math.ceil(way.length / 3 / 400));
  for (let at = 0; at < way.length; at += stride) {
    const spot = seen(matrix, way.slice(at, at + 3), width, height);
    if (spot) spots.push({ ...spot, width: 0, height: 0 });
  }
  return spots;
}

function drawAxes(pen, height, axes, colours) {
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
}

function drawNames(pen, { left, top, width, height }, { matrix, axes }, flight, { way, keys }, { colours, font }) {
  pen.save();
  pen.beginPath();
  pen.rect(left, top, width, height);
  pen.clip();
  pen.translate(left, top);
  pen.font = `12px ${font}`;
  pen.textBaseline = "middle";
  pen.lineJoin = "round";
  pen.lineWidth = 3;
  pen.strokeStyle = colours.field;
  pen.fillStyle = colours.weak;
  const taken = [HEADING];
  const spots = spotsOf(way, matrix, width, height);
  const within = (box) => box.x >= 0 && box.x + box.width <= width && box.y >= 0 && box.y + box.height <= height;
  const crowd = (box) => (within(box) ? 0 : 50) + 100 * taken.filter((other) => meet(box, other)).length + spots.filter((spot) => meet(box, spot)).length;
  keys.slice(0, MOST).forEach((key, at) => {
    const place = seen(matrix, key, width, height);
    if (!place) return;
    const point = flight.points[at];
    const text = `${point.number}  ${point.name ?? ""}`.trim().slice(0, 60);
    const wide = pen.measureText(text).width;
    const boxes = BESIDE.map(([x, y]) => ({ x: place.x + x * (9 + wide / 2) - wide / 2, y: place.y + y * 14 - 8, width: wide, height: 16 }));
    const crowds = boxes.map(crowd);
    const fewest = Math.min(...crowds);
    if (fewest >= 100) return;
    const box = boxes[crowds.indexOf(fewest)];
    taken.push(box);
    pen.strokeText(text, box.x, box.y + 8);
    pen.fillText(text, box.x, box.y + 8);
  });
  drawAxes(pen, height, axes, colours);
  pen.restore();
}
