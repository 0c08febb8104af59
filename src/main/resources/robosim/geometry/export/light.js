// WebGL 2: the shaders, and what draws with them.

const HEAD = '#version 300 es\nprecision highp float;\nprecision highp sampler2DShadow;\n';

/** Instances of surfaces, seen by the camera or by the sun. */
const INSTANCE = HEAD + `
layout(location=0) in vec4 point; layout(location=1) in vec3 normal;
layout(location=2) in vec3 centre; layout(location=3) in vec4 spin; layout(location=4) in vec4 size; layout(location=5) in vec4 color;
layout(location=6) in vec4 second; layout(location=7) in vec4 light; layout(location=8) in vec4 inner; layout(location=9) in vec4 extent;
uniform mat4 camera; uniform mat4 sunCamera; uniform float push;
out vec3 place; out vec3 facing; flat out vec4 paint; out vec4 inSun; out vec3 own; out vec3 ownFacing; flat out vec4 other; flat out vec4 glow; flat out vec4 half_; flat out float mirror;
vec3 turn(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
void main() {
  ownFacing = normal / max(size.xyz, vec3(1e-6));
  facing = turn(spin, ownFacing);
  own = point.xyz * size.xyz + vec3(0.0, point.w * size.w, 0.0);
  place = centre + turn(spin, own);
  own += inner.xyz; other = second; glow = light; half_ = extent; mirror = inner.w;
  paint = color;
  vec3 out_ = dot(facing, facing) > 0.0 ? normalize(facing) : vec3(0.0);
  inSun = sunCamera * vec4(place + push * out_, 1.0);
  gl_Position = camera * vec4(place, 1.0);
}`;

const LIGHT = `
uniform vec3 eye; uniform vec3 sun; uniform sampler2DShadow shadows; uniform vec3 paper; uniform float floorAt; uniform float reach; uniform float night;
float lit(vec4 at) {
  vec3 p = at.xyz * 0.5 + 0.5;
  if (p.x < 0.0 || p.y < 0.0 || p.x > 1.0 || p.y > 1.0 || p.z > 1.0) return 1.0;
#ifdef PLAIN
  return texture(shadows, p);
#else
  float sum = 0.0;
  float texel = 1.0 / float(textureSize(shadows, 0).x);
  for (int i = -1; i < 3; i++) for (int j = -1; j < 3; j++) sum += texture(shadows, vec3(p.xy + (vec2(i, j) - 0.5) * texel, p.z));
  return sum / 16.0;
#endif
}
#ifdef PLAIN
vec3 encoded(vec3 c) { return sqrt(max(c, 0.0)); }
#else
vec3 encoded(vec3 c) { c = max(c, 0.0); return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
#endif
vec3 shaded(vec3 albedo, vec3 n, vec3 at, float light, float gloss) {
  float up = n.y * 0.5 + 0.5;
  vec3 sky = mix(vec3(0.34, 0.31, 0.28), vec3(0.42, 0.46, 0.52), up);
  float near = mix(0.72, 1.0, smoothstep(0.0, reach * 0.02, at.y - floorAt + (n.y > 0.9 ? reach : 0.0)));
  float facing = max(dot(n, sun), 0.0);
#ifdef PLAIN
  float shine = 0.0;
#else
  vec3 half_ = normalize(sun + normalize(eye - at));
  float shine = gloss * pow(max(dot(n, half_), 0.0), 48.0) * step(0.001, facing);
#endif
  return (albedo * (sky * near + vec3(0.68, 0.64, 0.57) * facing * light) + vec3(shine * light)) * mix(1.0, 0.62, night);
}`;

/** Patterns: where a point lies in the plane of one, and the mean of its colours over a pixel. */
const PATTERN = `
in vec3 own; in vec3 ownFacing; flat in vec4 other; flat in vec4 glow; flat in vec4 half_;
uniform float shape;
vec2 wave(vec2 x) { return 1.0 - 2.0 * abs(fract(x / 2.0) - 0.5); }
vec3 pattern(vec3 first, vec3 n) {
  vec3 a = abs(n), h = half_.xyz;
  vec2 p, w;
  if (shape > 0.5 && (shape > 1.5 || a.y <= max(a.x, a.z))) {
    float angle = atan(-own.z, own.x), ball = own.y - clamp(own.y, -h.y, h.y);
    p.x = (angle < 0.0 ? angle + 6.2831853 : angle) * h.x;
    p.y = shape > 1.5 ? (atan(ball, length(own.xz)) + 1.5707963) * h.x + own.y - ball + h.y : own.y + h.y;
    // Where the angle begins anew, it is compared with one that does not.
    w = vec2(min(fwidth(p.x), fwidth(atan(own.z, -own.x) * h.x)), fwidth(p.y));
  } else {
    if (a.y >= a.x && a.y >= a.z) p = vec2(own.x + h.x, h.z - sign(n.y) * own.z);
    else p = vec2(a.x >= a.z ? h.z - sign(n.x) * own.z : h.x + sign(n.z) * own.x, own.y + h.y);
    w = fwidth(p);
  }
  float size = abs(other.a);
  if (other.a < 0.0) {
    vec2 d = vec2(-sin(glow.a), cos(glow.a));
    p = vec2(dot(p, d), 0.5 * size);
    w = vec2(dot(w, abs(d)), 0.0);
  }
  p /= size;
  w = max(w / size, 1e-3);
  vec2 mean = (wave(p + 0.5 * w) - wave(p - 0.5 * w)) / w;
  return mix(other.rgb, first, 0.5 + 0.5 * clamp(mean.x * mean.y, -1.0, 1.0));
}`;

const SOLID = HEAD + `
in vec3 place; in vec3 facing; flat in vec4 paint; in vec4 inSun; flat in float mirror; out vec4 pixel;
uniform float alpha; uniform vec3 ground;` + LIGHT + PATTERN + `
void main() {
  bool flat_ = dot(facing, facing) == 0.0;
  vec3 n = facing, m = ownFacing;
  if (flat_) { n = cross(dFdx(place), dFdy(place)); m = cross(dFdx(own), dFdy(own)); }
  n = normalize(n);
  if (dot(n, eye - place) < 0.0) { n = -n; m = flat_ ? -m : m; }
  vec3 c = other.a == 0.0 ? paint.rgb : pattern(paint.rgb, m);
  c = shaded(c, n, place, lit(inSun), half_.w);
  if (mirror > 0.0) {
    vec3 away = reflect(normalize(place - eye), n);
    vec3 sky = mix(vec3(0.6, 0.7, 0.82), vec3(0.2, 0.35, 0.62), max(away.y, 0.0)) * mix(1.0, 0.3, night);
    c = mix(c, mix(ground * 0.6, sky, smoothstep(-0.05, 0.05, away.y)), mirror);
  }
  c += glow.rgb;
  if (paint.a > 0.0) c = mix(c, vec3(0.72, 0.02, 0.05) * (0.55 + 0.45 * max(dot(n, sun), 0.0)), paint.a);
  pixel = vec4(encoded(c), alpha);
}`;

const NOTHING = HEAD + 'void main() {}';

const FLOOR_POINTS = HEAD + `
layout(location=0) in vec2 corner; uniform mat4 camera; uniform mat4 sunCamera; uniform vec3 middle; uniform float wide; out vec3 place; out vec4 inSun;
void main() {
  place = vec3(middle.x + corner.x * wide, middle.y, middle.z + corner.y * wide);
  inSun = sunCamera * vec4(place, 1.0);
  gl_Position = camera * vec4(place, 1.0);
}`;

const FLOOR = HEAD + `
in vec3 place; in vec4 inSun; out vec4 pixel;
uniform vec4 border; uniform vec3 zero; uniform float cell; uniform vec3 ground; uniform vec3 line; uniform vec3 middle; uniform float wide;` + LIGHT + `
float lines(float size) {
  vec2 p = (place.xz - zero.xz) / size, w = max(fwidth(p), vec2(1e-6));
  vec2 d = abs(fract(p - 0.5) - 0.5) / w;
  return (1.0 - min(min(d.x, d.y), 1.0)) * clamp(0.35 / max(w.x, w.y), 0.0, 1.0);
}
void main() {
  vec2 past = max(border.xy - place.xz, place.xz - border.zw);
  float inside = 1.0 - smoothstep(0.0, fwidth(place.x) + fwidth(place.z), max(past.x, past.y));
  vec3 c = mix(mix(ground, paper, 0.6), ground, inside);
  c = mix(c, line, max(lines(cell) * 0.5, lines(cell * 5.0)) * mix(0.45, 1.0, inside));
  c = shaded(c, vec3(0.0, 1.0, 0.0), place, lit(inSun), 0.0);
  float far = length(place.xz - middle.xz) / wide;
  pixel = vec4(mix(encoded(c), encoded(paper), smoothstep(0.45, 0.98, far)), 1.0);
}`;

/** Lines of a width in pixels. */
const STROKE_POINTS = HEAD + `
layout(location=0) in vec2 corner; layout(location=1) in vec3 from; layout(location=2) in vec3 to; layout(location=3) in vec4 color; layout(location=4) in float thick;
uniform mat4 camera; uniform vec2 screen; uniform vec3 eye; out vec4 paint;
void main() {
  // A little nearer to the eye, so that the floor does not hide what lies on it.
  vec4 a = camera * vec4(mix(from, eye, 0.002), 1.0), b = camera * vec4(mix(to, eye, 0.002), 1.0);
  float near = 1e-4;
  if (a.w < near && b.w >= near) a = mix(a, b, (near - a.w) / (b.w - a.w));
  else if (b.w < near && a.w >= near) b = mix(b, a, (near - b.w) / (a.w - b.w));
  vec2 along = (b.xy / b.w - a.xy / a.w) * screen;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  vec4 p = mix(a, b, corner.x);
  p.xy += (vec2(-along.y, along.x) * corner.y + along * (corner.x - 0.5)) * (thick + 1.0) / screen * p.w;
  paint = color;
  gl_Position = p;
}`;

const PLAIN = HEAD + `
in vec4 paint; out vec4 pixel;
void main() { pixel = vec4(pow(paint.rgb, vec3(1.0 / 2.2)), paint.a); }`;

/** Triangles that one sees through: the beams of sonars. */
const HAZE_POINTS = HEAD + `
layout(location=0) in vec3 point; layout(location=1) in vec4 color; uniform mat4 camera; out vec4 paint;
void main() { paint = color; gl_Position = camera * vec4(point, 1.0); }`;

/** Whether pictures are drawn by the processor, which is a hundred times slower: then shadows have hard edges, and round things fewer sides. */
function isDrawnInSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2'), known = gl && gl.getExtension('WEBGL_debug_renderer_info');
  const name = known ? gl.getParameter(known.UNMASKED_RENDERER_WEBGL) : '';
  if (gl && gl.getExtension('WEBGL_lose_context')) gl.getExtension('WEBGL_lose_context').loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

function program(gl, vertex, fragment, isPlain) {
  const p = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, isPlain ? text.replace(HEAD, HEAD + '#define PLAIN\n') : text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(p, shader);
  }
  gl.linkProgram(p);
  if (!gl.getProgramParameter(p, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(p));
  const at = {};
  for (let k = 0; k < gl.getProgramParameter(p, gl.ACTIVE_UNIFORMS); k++) {
    const name = gl.getActiveUniform(p, k).name;
    at[name] = gl.getUniformLocation(p, name);
  }
  return { p, at };
}

/** Sets the uniforms of a program by name: numbers, vectors, matrices. */
function use(gl, { p, at }, values) {
  gl.useProgram(p);
  for (const name in values) {
    const v = values[name], place = at[name];
    if (place === undefined) continue;
    if (name === 'shadows') gl.uniform1i(place, v);
    else if (v.length === 16) gl.uniformMatrix4fv(place, false, v);
    else if (v.length) gl['uniform' + v.length + 'fv'](place, v);
    else gl.uniform1f(place, v);
  }
}

/** A buffer of attributes: each with its place, its length, and whether it belongs to an instance. */
function attributes(gl, buffer, stride, list, each) {
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  let offset = 0;
  for (const [place, length] of list) {
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, length, gl.FLOAT, false, 4 * stride, 4 * offset);
    gl.vertexAttribDivisor(place, each ? 1 : 0);
    offset += length;
  }
}

const PER_INSTANCE = 31;
/** Patterns lie on surfaces as on boxes, or around them. */
const ROUND = { cylinder: 1, ball: 2 };

/** Many instances of one surface, drawn at once. */
class Batch {
  constructor(gl, key, surface, count) {
    this.gl = gl;
    this.shape = ROUND[key] || 0;
    this.closed = key === 'box' || key in ROUND;
    this.count = count;
    this.values = new Float32Array(PER_INSTANCE * count);
    this.size = surface.count;
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    attributes(gl, surface.points, 7, [[0, 4], [1, 3]], false);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, surface.index);
    this.buffer = gl.createBuffer();
    attributes(gl, this.buffer, PER_INSTANCE, [[2, 3], [3, 4], [4, 4], [5, 4], [6, 4], [7, 4], [8, 4], [9, 4]], true);
    gl.bufferData(gl.ARRAY_BUFFER, this.values.byteLength, gl.DYNAMIC_DRAW);
    gl.bindVertexArray(null);
    this.changed = true;
  }
  /** Puts an instance somewhere; what it looks like stays. */
  set(k, pose, size) {
    this.values.set(pose, PER_INSTANCE * k);
    this.values.set(size, PER_INSTANCE * k + 7);
    this.changed = true;
  }
  dress(k, look, half, inner) {
    const v = this.values, at = PER_INSTANCE * k;
    v.set(look.color, at + 11);
    v.set([...look.second, look.size, ...look.glow, look.angle, ...inner, look.mirror, ...half, look.gloss], at + 15);
    this.changed = true;
  }
  tint(k, strength) { this.values[PER_INSTANCE * k + 14] = strength; this.changed = true; }
  draw(program) {
    const gl = this.gl;
    gl.uniform1f(program.at.shape || null, this.shape);
    gl.bindVertexArray(this.array);
    if (this.changed) {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, this.values);
      this.changed = false;
    }
    if (this.closed) gl.enable(gl.CULL_FACE); else gl.disable(gl.CULL_FACE);
    gl.drawElementsInstanced(gl.TRIANGLES, this.size, gl.UNSIGNED_INT, 0, this.count);
  }
}

function uploaded(gl, surface) {
  const points = gl.createBuffer(), index = gl.createBuffer();
  gl.bindVertexArray(null);
  gl.bindBuffer(gl.ARRAY_BUFFER, points);
  gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(surface.data), gl.STATIC_DRAW);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, index);
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint32Array.from(surface.index), gl.STATIC_DRAW);
  return { points, index, count: surface.index.length };
}

/** Strokes or triangles that are gathered anew for each picture. */
class Gathered {
  constructor(gl, stride, list, corners) {
    this.gl = gl; this.stride = stride; this.values = []; this.corners = corners;
    this.array = gl.createVertexArray();
    this.buffer = gl.createBuffer();
    gl.bindVertexArray(this.array);
    if (corners) attributes(gl, corners, 2, [[0, 2]], false);
    attributes(gl, this.buffer, stride, list, !!corners);
    gl.bindVertexArray(null);
  }
  draw() {
    const gl = this.gl, n = this.values.length / this.stride;
    if (!n) return;
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(this.values), gl.STREAM_DRAW);
    if (this.corners) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, n);
    else gl.drawArrays(gl.TRIANGLES, 0, n);
  }
}
