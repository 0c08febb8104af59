// Decodes the recording, and says where everything is after any frame. Runs without a browser too.
'use strict';

/** Reads numbers and texts from one part of the data. */
class Reader {
  constructor(bytes) { this.b = bytes; this.at = 0; this.v = new DataView(bytes.buffer, bytes.byteOffset, bytes.length); }
  octet() { return this.b[this.at++]; }
  count() {
    let value = 0, scale = 1, byte;
    do { byte = this.b[this.at++]; value += (byte & 127) * scale; scale *= 128; } while (byte > 127);
    return value;
  }
  signed() { const n = this.count(); return n % 2 ? -(n + 1) / 2 : n / 2; }
  real() { this.at += 4; return this.v.getFloat32(this.at - 4, true); }
  exact() { this.at += 8; return this.v.getFloat64(this.at - 8, true); }
  reals(n) { return Array.from({ length: n }, () => this.real()); }
  text() { const n = this.count(); this.at += n; return new TextDecoder().decode(this.b.subarray(this.at - n, this.at)); }
}

const PLACE = 1 << 13, RANGE = 1 << 11, TURN = 1 << 16, SPIN = 1 << 15;
const round = x => Math.floor(x + 0.5);

/** Sine of an angle in 65,536ths of a turn; the operations and their order are those of the writer, as tracks depend on every bit. */
function stepSin(turn) {
  let step = ((turn % TURN) + TURN) % TURN, sign = 1;
  if (step >= TURN / 2) { step -= TURN / 2; sign = -1; }
  if (step > TURN / 4) step = TURN / 2 - step;
  const a = step * 9.587379924285257e-5, s = a * a;
  const t = -1.0 / 39916800 + s * (1.0 / 6227020800.0 + s * (-1.0 / 1307674368000.0));
  return sign * (a * (1 + s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 + s * t))))));
}
const stepCos = turn => stepSin(turn + TURN / 4);

/** The places of one object: for each key a frame, and seven numbers: the centre and a quaternion. */
function readTrack(begin, from) {
  const head = from.tracks.count(), upright = head % 2 === 1, n = (head - head % 2) / 2;
  const frames = new Int32Array(n), poses = new Float64Array(7 * n);
  for (let k = 0, frame = begin; k < n; k++) frames[k] = frame += from.times.count();
  if (upright) {
    let x = 0, y = 0, z = 0, turn = 0, ahead = 0, aside = 0;
    for (let k = 0; k < n; k++) {
      const op = from.tracks.octet(), move = op & 31;
      if (move >= 10) { ahead = from.moves.signed(); aside = from.moves.signed(); }
      if (move === 19) { x = from.moves.signed(); z = from.moves.signed(); }
      else if (move) {
        const cos = stepCos(turn), sin = stepSin(turn), off = (move - 1) % 9;
        x += round(cos * ahead + sin * aside) + Math.floor(off / 3) - 1;
        z += round(cos * aside + -sin * ahead) + off % 3 - 1;
      }
      if (op & 32) turn = (turn + from.turns.signed() + TURN) % TURN;
      if (op & 64) y += from.free.signed();
      poses.set([x / PLACE, y / PLACE, z / PLACE, 0, Math.sin(Math.PI * turn / TURN), 0, Math.cos(Math.PI * turn / TURN)], 7 * k);
    }
  } else {
    const now = [0, 0, 0, 0, 0, 0, 0];
    for (let k = 0; k < n; k++) {
      for (let j = 0; j < 7; j++) now[j] += from.free.signed();
      const length = Math.hypot(now[3], now[4], now[5], now[6]) || 1;
      for (let j = 0; j < 7; j++) poses[7 * k + j] = now[j] / (j < 3 ? PLACE : length);
    }
  }
  return { frames, poses };
}

/** What one object measured: by frame, the arrangement of its sensors and where its distances begin. */
function readScans(begin, sensors, from) {
  const n = from.scans.count(), frames = new Int32Array(n), kinds = new Int32Array(n), starts = new Int32Array(n), all = [];
  const last = {};
  for (let k = 0, frame = begin; k < n; k++) {
    frames[k] = frame += from.scans.count();
    const kind = kinds[k] = from.scans.count();
    starts[k] = all.length;
    const known = last[kind] || (last[kind] = new Float64Array(sensors[kind].length));
    for (let s = 0; s < known.length; s++) {
      const code = from.distances.count();
      if (code) known[s] += code % 2 ? (code - 1) / 2 : -code / 2;
      all.push(code ? known[s] / RANGE : Infinity);
    }
  }
  return { frames, kinds, starts, distances: Float64Array.from(all) };
}

const NAMES = ['about', 'looks', 'objects', 'meshes', 'chapters', 'tracks', 'times', 'moves', 'turns', 'free', 'sensors', 'scans', 'distances'];

/** What a surface looks like: colours are linear; a pattern has a second one, its size (negative of stripes) and an angle. */
function readLook(o) {
  const color = () => [o.octet(), o.octet(), o.octet()].map(toLinear);
  const look = { color: color(), glow: color(), gloss: o.octet() / 255, mirror: o.octet() / 255, second: [0, 0, 0], size: 0, angle: 0 }, kind = o.octet();
  if (kind) { look.second = color(); look.size = o.real(); }
  if (kind === 2) { look.size = -look.size; look.angle = o.real(); }
  return look;
}

function readObject(from, out) {
  const o = from.objects;
  const object = { name: o.text(), kind: o.text(), color: [o.octet(), o.octet(), o.octet()], pose: o.reals(7), parts: [] };
  for (let left = o.count(); left > 0; left--) {
    const code = o.octet(), part = { shape: code & 7, sizes: o.reals([3, 2, 1, 2, 0, 2][code & 7]), place: [0, 0, 0, 0, 0, 0, 1] };
    if (part.shape === 4) part.mesh = o.count();
    if (part.shape === 5) {
      part.columns = o.count(); part.rows = o.count();
      const n = o.count(), cells = part.cells = new Int32Array(4 * n);
      for (let k = 0, row = 0; k < n; k++) cells.set([row += o.count(), o.count(), o.count(), o.count()], 4 * k);
    }
    part.look = o.count();
    if (code & 8) part.place = o.reals(7);
    object.parts.push(part);
  }
  return object;
}

function readChapter(from, data) {
  const c = from.chapters;
  const chapter = { begin: c.count(), size: c.reals(3), spatial: c.octet() === 1, statics: [], movers: [], bumps: [] };
  let id = 0;
  for (let left = c.count(); left > 0; left--) chapter.statics.push(id += c.signed());
  for (let left = c.count(); left > 0; left--) chapter.movers.push(id += c.signed());
  chapter.tracks = chapter.movers.map(() => readTrack(chapter.begin, from));
  chapter.scans = chapter.movers.map(() => readScans(chapter.begin, data.sensors, from));
  for (let left = c.count(), frame = chapter.begin; left > 0; left--)
    chapter.bumps.push({ frame: frame += c.count(), mover: c.count(), heading: c.count() / TURN * 2 * Math.PI, obstacle: c.count() });
  return chapter;
}

/** The whole recording; lengths are in the page's unit, from its origin. */
function decode(bytes) {
  const head = new Reader(bytes), sizes = Array.from({ length: head.count() }, () => head.count()), from = {};
  sizes.forEach((size, k) => { from[NAMES[k]] = new Reader(bytes.subarray(head.at, head.at + size)); head.at += size; });
  const a = from.about, data = { title: a.text(), subtitle: a.text(), unitName: a.text(), unit: 1 };
  for (let k = a.signed(); k !== 0; k -= Math.sign(k)) data.unit *= k > 0 ? 2 : 0.5;
  data.origin = [a.exact(), a.exact(), a.exact()];
  data.space = a.reals(3);
  data.first = a.count();
  data.frames = a.count();
  const texts = Array.from({ length: a.count() }, () => a.text());
  data.remarks = [];
  for (let left = a.count(), frame = 0; left > 0; left--) data.remarks.push({ frame: frame += a.count(), text: texts[a.count()] });
  data.goals = Array.from({ length: a.count() }, () => a.count());
  data.meshes = [];
  for (const m = from.meshes; m.at < m.b.length;) {
    const n = m.count(), axes = [0, 1, 2].map(() => Float32Array.from({ length: n }, () => m.real()));
    const points = new Float32Array(3 * n);
    for (let k = 0; k < 3 * n; k++) points[k] = axes[k % 3][Math.floor(k / 3)];
    const corners = new Uint32Array(3 * m.count());
    for (let k = 0, v = 0; k < corners.length; k++) corners[k] = v += m.signed();
    data.meshes.push({ points, corners });
  }
  data.looks = [];
  while (from.looks.at < from.looks.b.length) data.looks.push(readLook(from.looks));
  data.objects = [];
  while (from.objects.at < from.objects.b.length) data.objects.push(readObject(from, data));
  data.sensors = Array.from({ length: from.sensors.count() }, () => Array.from({ length: from.sensors.count() }, () => {
    const s = from.sensors;
    return { bearing: s.count() / TURN * 2 * Math.PI, width: s.count() / TURN * 2 * Math.PI, range: s.octet() ? s.real() : Infinity, at: s.reals(3) };
  }));
  data.chapters = Array.from({ length: from.chapters.count() }, () => readChapter(from, data));
  return data;
}

/** The index of the last number that is at most `value`; -1 if there is none. */
function lastUpTo(sorted, value) {
  let low = 0, high = sorted.length;
  while (low < high) { const mid = (low + high) >> 1; if (sorted[mid] <= value) low = mid + 1; else high = mid; }
  return low - 1;
}

/** The index of the world of a frame; -1 before the first. */
const chapterAt = (data, frame) => lastUpTo(data.chapters.map(c => c.begin), frame);

/** The pose of a mover after a frame; between two frames it is between their poses. */
function poseAt(track, frame, out) {
  const whole = Math.floor(frame), k = Math.max(0, lastUpTo(track.frames, whole)), p = track.poses;
  for (let j = 0; j < 7; j++) out[j] = p[7 * k + j];
  const share = frame - whole;
  if (share > 0 && k + 1 < track.frames.length && track.frames[k + 1] === whole + 1) {
    const b = 7 * k + 7;
    const dot = out[3] * p[b + 3] + out[4] * p[b + 4] + out[5] * p[b + 5] + out[6] * p[b + 6];
    for (let j = 0; j < 7; j++) out[j] += ((j > 2 && dot < 0 ? -p[b + j] : p[b + j]) - out[j]) * share;
    const length = Math.hypot(out[3], out[4], out[5], out[6]) || 1;
    for (let j = 3; j < 7; j++) out[j] /= length;
  }
  return out;
}

/** A point of the page in world units. */
const toWorld = (data, p) => p.map((v, k) => v * data.unit + data.origin[k]);

/** What happened in a frame, in words. */
function story(data, frame) {
  const chapter = data.chapters[chapterAt(data, frame)], words = [];
  if (!chapter) return '';
  const name = k => data.objects[chapter.movers[k]].name || 'object ' + (k + 1);
  const obstacle = code => code === 0 ? 'something' : code === 1 ? 'the border of the world' : describe(data, chapter, code - 2);
  let moved = 0, scanned = 0;
  chapter.tracks.forEach(t => { const k = lastUpTo(t.frames, frame); if (k > 0 && t.frames[k] === frame) moved++; });
  chapter.scans.forEach(s => { const k = lastUpTo(s.frames, frame); if (k >= 0 && s.frames[k] === frame) scanned += data.sensors[s.kinds[k]].length; });
  const refused = chapter.bumps.filter(b => b.frame === frame);
  if (moved) words.push(moved + (moved > 1 ? ' moves' : ' move'));
  if (refused.length) {
    words.push(refused.length + ' refused: ' + refused.slice(0, 3).map(b => name(b.mover) + ' by ' + obstacle(b.obstacle)).join(', ')
      + (refused.length > 3 ? ', …' : ''));
  }
  if (scanned) words.push(scanned + (scanned > 1 ? ' distances' : ' distance'));
  data.remarks.forEach(r => { if (r.frame === frame) words.push(r.text); });
  return words.join('; ');
}


function describe(data, chapter, k) {
  const all = chapter.movers.concat(chapter.statics), object = data.objects[all[k]];
  return object.name || 'a ' + object.kind;
}

/** The bytes of the recording from the page's text. */
const unpack = text => inflated(Uint8Array.from(atob(text.trim()), c => c.charCodeAt(0)));

async function inflated(packed) {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
