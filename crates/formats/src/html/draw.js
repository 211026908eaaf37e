// Drawing by WebGL 2: lines as rectangles that face the eye, dots, and faces lit from the eye.
// It knows matrices, buffers and colours; what is drawn where, is decided in page.js.

const LINES = [`#version 300 es
  layout(location = 0) in vec3 from;
  layout(location = 1) in vec3 to;
  layout(location = 2) in vec3 fromColour;
  layout(location = 3) in vec3 toColour;
  uniform mat4 matrix;
  uniform vec2 size;
  uniform float width, lift;
  uniform vec4 colour, ahead;
  uniform int flown;
  uniform bool own;
  out vec4 tint;
  out float across;
  void main() {
    bool end = gl_VertexID > 1;
    vec4 a = matrix * vec4(from, 1.0), b = matrix * vec4(to, 1.0);
    float na = a.z + a.w, nb = b.z + b.w;
    if (na < 0.0 && nb < 0.0) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); return; }
    if (na < 0.0) a = mix(a, b, na / (na - nb));
    else if (nb < 0.0) b = mix(b, a, nb / (nb - na));
    vec2 along = (b.xy / b.w - a.xy / a.w) * size;
    float far = length(along);
    along = far > 1e-6 ? along / far : vec2(1.0, 0.0);
    across = (gl_VertexID % 2 == 0 ? -0.5 : 0.5) * (width + 2.0);
    vec4 place = end ? b : a;
    place.xy += (vec2(-along.y, along.x) * across + along * (end ? 0.5 : -0.5) * width) * 2.0 / size * place.w;
    place.z += lift;
    gl_Position = place;
    tint = own ? vec4(end ? toColour : fromColour, 1.0) : gl_InstanceID < flown ? colour : ahead;
  }`, `#version 300 es
  precision highp float;
  uniform float width;
  in vec4 tint;
  in float across;
  out vec4 pixel;
  void main() {
    float cover = clamp(width * 0.5 + 0.5 - abs(across), 0.0, 1.0);
    if (cover * tint.a < 0.02) discard;
    pixel = vec4(tint.rgb, tint.a * cover);
  }`];

const FACES = [`#version 300 es
  layout(location = 0) in vec3 point;
  layout(location = 2) in vec3 pointColour;
  uniform mat4 matrix, eye;
  uniform vec4 colour;
  uniform bool own;
  out vec3 place;
  out vec3 tint;
  void main() {
    gl_Position = matrix * vec4(point, 1.0);
    place = (eye * vec4(point, 1.0)).xyz;
    tint = own ? pointColour : colour.rgb;
  }`, `#version 300 es
  precision highp float;
  in vec3 place;
  in vec3 tint;
  out vec4 pixel;
  void main() {
    vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
    float light = abs(dot(normal, vec3(0.24, 0.48, 0.84)));
    pixel = vec4(tint * (0.4 + 0.6 * light), 1.0);
  }`];

const DOTS = [`#version 300 es
  layout(location = 0) in vec3 point;
  layout(location = 2) in vec3 pointColour;
  uniform mat4 matrix;
  uniform float width, lift;
  uniform vec4 colour;
  uniform bool own;
  out vec4 tint;
  void main() {
    gl_Position = matrix * vec4(point, 1.0);
    gl_Position.z += lift;
    gl_PointSize = width + 1.0;
    tint = own ? vec4(pointColour, 1.0) : colour;
  }`, `#version 300 es
  precision highp float;
  uniform float width;
  in vec4 tint;
  out vec4 pixel;
  void main() {
    float away = length(gl_PointCoord - 0.5) * (width + 1.0);
    float cover = clamp(width * 0.5 + 0.5 - away, 0.0, 1.0);
    if (cover < 0.02) discard;
    pixel = vec4(tint.rgb, tint.a * cover);
  }`];

function program(gl, [vertex, fragment]) {
  const made = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  const places = {};
  const count = gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS) || 0;
  for (let at = 0; at < count; at++) {
    const { name } = gl.getActiveUniform(made, at);
    places[name] = gl.getUniformLocation(made, name);
  }
  return { made, places };
}

/// What makes buffers of numbers.
function makeBuffers(gl) {
  function buffer(numbers, target = gl.ARRAY_BUFFER, use = gl.STATIC_DRAW) {
    const made = gl.createBuffer();
    gl.bindBuffer(target, made);
    gl.bufferData(target, numbers, use);
    return made;
  }
  function attribute(at, size, stride, offset, each, kind = gl.FLOAT) {
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, kind, kind !== gl.FLOAT, stride, offset);
    gl.vertexAttribDivisor(at, each);
  }
  function vertices(describe) {
    const made = gl.createVertexArray();
    gl.bindVertexArray(made);
    describe();
    gl.bindVertexArray(null);
    return made;
  }
  const buffers = {};
  /// Lines with two ends each, six numbers a line; `joined`: each end is the next line's start.
  buffers.lines = (numbers, joined = false, colours = null) => {
    let data = null;
    const stride = joined ? 12 : 24;
    const array = vertices(() => {
      data = buffer(numbers);
      attribute(0, 3, stride, 0, 1);
      attribute(1, 3, stride, 12, 1);
      if (!colours) return;
      buffer(colours);
      attribute(2, 3, 6, 0, 1, gl.UNSIGNED_BYTE);
      attribute(3, 3, 6, 3, 1, gl.UNSIGNED_BYTE);
    });
    const count = joined ? Math.max(numbers.length / 3 - 1, 0) : numbers.length / 6;
    return { array, data, count, own: Boolean(colours) };
  };
  buffers.dots = (numbers, colours = null) => {
    const array = vertices(() => {
      buffer(numbers);
      attribute(0, 3, 12, 0, 0);
      if (!colours) return;
      buffer(colours);
      attribute(2, 3, 3, 0, 0, gl.UNSIGNED_BYTE);
    });
    return { array, count: numbers.length / 3, own: Boolean(colours) };
  };
  buffers.faces = (points, triangles, colours = null) => {
    const array = vertices(() => {
      buffer(points);
      attribute(0, 3, 12, 0, 0);
      buffer(triangles, gl.ELEMENT_ARRAY_BUFFER);
      if (!colours) return;
      buffer(colours);
      attribute(2, 3, 3, 0, 0, gl.UNSIGNED_BYTE);
    });
    return { array, count: triangles.length, own: Boolean(colours) };
  };
  buffers.change = (made, numbers) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, made.data);
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
    made.count = numbers.length / 6;
  };
  return buffers;
}

function makePainter(canvas) {
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: true, preserveDrawingBuffer: false });
  if (!gl) return null;
  const [lines, faces, dots] = [LINES, FACES, DOTS].map((sources) => program(gl, sources));
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  gl.enable(gl.SCISSOR_TEST);

  let pane = { width: 1, height: 1, ratio: 1 };
  const painter = { lost: () => gl.isContextLost(), ...makeBuffers(gl) };

  /// What is drawn from here on lies in this rectangle (CSS pixels from the canvas's upper left).
  painter.begin = ({ left, top, width, height }, ratio, ground) => {
    const [x, y, right, bottom] = [left, top, left + width, top + height].map((value) => Math.round(value * ratio));
    pane = { width: right - x, height: bottom - y, ratio };
    gl.viewport(x, canvas.height - bottom, pane.width, pane.height);
    gl.scissor(x, canvas.height - bottom, pane.width, pane.height);
    gl.clearColor(ground[0], ground[1], ground[2], 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    return pane;
  };
  function use({ made, places }, thing, matrix, style) {
    gl.useProgram(made);
    gl.uniformMatrix4fv(places.matrix, false, matrix);
    gl.uniform4fv(places.colour, style.colour);
    if (places.own) gl.uniform1i(places.own, thing.own ? 1 : 0);
    if (places.width) gl.uniform1f(places.width, style.width * pane.ratio);
    if (places.lift) gl.uniform1f(places.lift, style.lift || 0);
    gl.bindVertexArray(thing.array);
  }
  painter.drawLines = (thing, matrix, style) => {
    if (!thing.count) return;
    use(lines, thing, matrix, style);
    gl.uniform2f(lines.places.size, pane.width, pane.height);
    gl.uniform4fv(lines.places.ahead, style.ahead || style.colour);
    gl.uniform1i(lines.places.flown, style.flown ?? thing.count);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, thing.count);
  };
  painter.drawDots = (thing, matrix, style) => {
    if (!thing.count) return;
    use(dots, thing, matrix, style);
    gl.drawArrays(gl.POINTS, 0, thing.count);
  };
  /// `eye`: from the object's axes to those of the eye.
  painter.drawFaces = (thing, matrix, eye, style) => {
    if (!thing.count) return;
    use(faces, thing, matrix, style);
    gl.uniformMatrix4fv(faces.places.eye, false, eye);
    gl.drawElements(gl.TRIANGLES, thing.count, gl.UNSIGNED_INT, 0);
  };
  return painter;
}
