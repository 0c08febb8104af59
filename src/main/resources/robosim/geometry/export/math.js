// Vectors, quaternions and 4 x 4 matrices (columns one after another, as WebGL wants them).
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => times(a, 1 / (Math.hypot(a[0], a[1], a[2]) || 1));
const mix = (a, b, t) => a.map((v, k) => v + (b[k] - v) * t);
const clamp = (v, low, high) => Math.min(high, Math.max(low, v));

/** A vector turned by the quaternion at an index of an array. */
function turned(q, at, v) {
  const x = q[at], y = q[at + 1], z = q[at + 2], w = q[at + 3];
  const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
  return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]];
}

/** A pose (centre and quaternion) that is given in the frame of another one. */
function within(outer, inner) {
  const c = turned(outer, 3, inner), [ax, ay, az, aw] = outer.slice(3), [bx, by, bz, bw] = inner.slice(3);
  return [outer[0] + c[0], outer[1] + c[1], outer[2] + c[2],
    aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz];
}

function product(a, b) {
  const out = new Float32Array(16);
  for (let c = 0; c < 4; c++)
    for (let r = 0; r < 4; r++)
      for (let k = 0; k < 4; k++) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
  return out;
}

function perspective(fov, aspect, near, far) {
  const f = 1 / Math.tan(fov / 2), m = new Float32Array(16);
  m[0] = f / aspect; m[5] = f; m[10] = (far + near) / (near - far); m[11] = -1; m[14] = 2 * far * near / (near - far);
  return m;
}

function parallel(width, height, near, far) {
  const m = new Float32Array(16);
  m[0] = 2 / width; m[5] = 2 / height; m[10] = 2 / (near - far); m[14] = (far + near) / (near - far); m[15] = 1;
  return m;
}

function lookAt(eye, target, up) {
  const z = unit(sub(eye, target)), x = unit(cross(up, z)), y = cross(z, x);
  return Float32Array.from([x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1]);
}

/** Where a point is on the screen: x and y from -1 to 1; null behind the camera. */
function project(m, p) {
  const w = m[3] * p[0] + m[7] * p[1] + m[11] * p[2] + m[15];
  if (w <= 1e-6) return null;
  return [(m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12]) / w, (m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13]) / w];
}

/** Oklch (Ottosson 2020) as linear red, green and blue; hue in degrees. */
function oklch(lightness, chroma, hue) {
  const a = chroma * Math.cos(hue * Math.PI / 180), b = chroma * Math.sin(hue * Math.PI / 180);
  const [l, m, s] = [[0.3963377774, 0.2158037573], [-0.1055613458, -0.0638541728], [-0.0894841775, -1.291485548]]
    .map(([p, q]) => (lightness + p * a + q * b) ** 3);
  return [4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s].map(v => clamp(v, 0, 1));
}

/** The colour of a distance as a share of the largest. */
const distanceColor = share => oklch(0.55 + 0.25 * share, 0.2 - 0.09 * share, 20 + 190 * share);

const toLinear = v => { v /= 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; };
