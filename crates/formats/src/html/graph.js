// The graph of the speeds over the whole flight, with support points above and seconds below.

const INSET = 8; // half the scrub bar's thumb, so that both run over the same way

/// What stands beside a place of the graph.
function drawLabel(pen, colours, label, place, width, top, bottom) {
  pen.globalAlpha = 0.6;
  pen.fillRect(place - 0.5, top, 1, bottom - top);
  pen.globalAlpha = 1;
  const wide = pen.measureText(label).width + 12;
  const left = place + wide + 8 < width ? place + 6 : place - wide - 6;
  pen.fillStyle = colours.panel;
  pen.fillRect(left, top + 4, wide, 18);
  pen.strokeStyle = colours.line;
  pen.lineWidth = 1;
  pen.strokeRect(left + 0.5, top + 4.5, wide - 1, 17);
  pen.fillStyle = colours.text;
  pen.textAlign = "left";
  pen.fillText(label, left + 6, top + 13.5);
}

function makeGraph(flight, canvas) {
  const pen = canvas.getContext("2d");
  const last = Math.max(flight.count - 1, 1);
  let [width, height] = [0, 0];
  let columns = [];
  const highest = (values) => values.reduce((high, value) => Math.max(high, value), 0);
  const [fastest, widest] = [highest(flight.speeds), highest(flight.turns)];
  const x = (at) => INSET + at / last * (width - 2 * INSET);
  const graph = { hovered: null };

  /// The frame (a fraction) that stands at this distance from the left.
  graph.at = (left) => clamp((left - INSET) / Math.max(width - 2 * INSET, 1), 0, 1) * (flight.count - 1);

  graph.resize = (ratio) => {
    const box = canvas.getBoundingClientRect();
    [width, height] = [box.width, box.height];
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    columns = [];
    const count = Math.max(1, Math.min(Math.round(width - 2 * INSET), flight.count));
    for (let column = 0; column < count; column++) {
      const from = Math.round(column / Math.max(count - 1, 1) * (flight.count - 1));
      const to = Math.max(from + 1, Math.round((column + 1) / Math.max(count - 1, 1) * (flight.count - 1)));
      const most = { speed: from, turning: from }; // the frames that stand for the column
      for (let at = from; at < Math.min(to, flight.count); at++) {
        if (flight.speeds[at] > flight.speeds[most.speed]) most.speed = at;
        if (flight.turns[at] > flight.turns[most.turning]) most.turning = at;
      }
      columns.push(most);
    }
  };

  function curve(what, most, top, bottom) {
    const values = what === "speed" ? flight.speeds : flight.turns;
    pen.beginPath();
    for (const { [what]: at } of columns) pen.lineTo(x(at), bottom - values[at] / (most * 1.08) * (bottom - top));
  }

  function seconds(colours, top, bottom) {
    const whole = flight.count / flight.fps;
    const steps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1800, 3600];
    const step = steps.find((value) => value / whole * width >= 64) || whole;
    pen.textAlign = "center";
    for (let at = 0; at * step * flight.fps <= flight.count - 1 && at < 200; at++) {
      const place = x(at * step * flight.fps);
      pen.fillStyle = colours.line;
      if (at) pen.fillRect(Math.round(place), top, 1, bottom - top);
      pen.fillStyle = colours.weak;
      if (place > 20 && place < width - 20) pen.fillText(`${number(at * step, step < 1 ? 1 : 0)} s`, place, bottom + 9);
    }
  }

  function points(colours, top, bottom) {
    let free = -Infinity;
    pen.textAlign = "center";
    for (const point of flight.points) {
      const place = x(clamp(point.frame, 0, flight.count - 1));
      pen.fillStyle = colours.weak;
      pen.globalAlpha = 0.5;
      pen.fillRect(Math.round(place) - 0.5, top - 4, 1, bottom - top + 4);
      pen.globalAlpha = 1;
      const text = String(point.number);
      const half = pen.measureText(text).width / 2;
      if (place - half < free) continue;
      free = place + half + 6;
      pen.fillText(text, clamp(place, half + 1, width - half - 1), 6);
    }
  }

  /// `label`: what stands beside the hovered frame.
  graph.draw = (colours, font, frame, label) => {
    const [top, bottom] = [17, height - 18];
    pen.clearRect(0, 0, width, height);
    pen.font = `11px ${font}`;
    pen.textBaseline = "middle";
    pen.fillStyle = colours.field;
    pen.fillRect(INSET, top, width - 2 * INSET, bottom - top);
    seconds(colours, top, bottom);
    if (fastest > 0) {
      const shape = () => {
        curve("speed", fastest, top, bottom);
        pen.lineTo(x(flight.count - 1), bottom);
        pen.lineTo(x(0), bottom);
        pen.closePath();
      };
      pen.fillStyle = colours.accent;
      pen.globalAlpha = 0.14;
      shape();
      pen.fill();
      pen.save();
      pen.beginPath();
      pen.rect(0, 0, x(frame), height);
      pen.clip();
      pen.globalAlpha = 0.22;
      shape();
      pen.fill();
      pen.restore();
      pen.globalAlpha = 1;
      curve("speed", fastest, top, bottom);
      pen.strokeStyle = colours.accent;
      pen.lineWidth = 1.75;
      pen.lineJoin = "round";
      pen.stroke();
    }
    if (widest > 0) {
      curve("turning", widest, top, bottom);
      pen.strokeStyle = colours.turning;
      pen.lineWidth = 1.25;
      pen.setLineDash([4, 3]);
      pen.stroke();
      pen.setLineDash([]);
    }
    points(colours, top, bottom);
    pen.fillStyle = colours.text;
    pen.fillRect(x(frame) - 0.75, top - 4, 1.5, bottom - top + 22);
    if (graph.hovered !== null) drawLabel(pen, colours, label, x(graph.hovered), width, top, bottom);
  };
  return graph;
}
