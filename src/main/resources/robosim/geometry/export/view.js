// One world at one moment, drawn.

const TRAIL = 400, FRESH = 8;
/** The sides of round things by the number of pieces in a world; where the processor draws, of moveable ones that cast shadows. */
const SIDES = 40, FEW_SIDES = 20, FEWEST_SIDES = 12, MANY_PIECES = 2000, SOME_PIECES = 500;
const LOOKS = {
  light: { paper: [0.955, 0.95, 0.935], ground: [0.86, 0.86, 0.85], line: [0.5, 0.51, 0.52], night: 0 },
  dark: { paper: [0.0065, 0.008, 0.0115], ground: [0.05, 0.058, 0.072], line: [0.012, 0.014, 0.018], night: 1 },
};

/** The arrow on a robot. */
const ARROW = { color: [0.94, 0.94, 0.92], glow: [0, 0, 0], second: [0, 0, 0], size: 0, angle: 0, gloss: 0, mirror: 0 };

class View {
  constructor(canvas, data) {
    const gl = this.gl = canvas.getContext('webgl2', { alpha: false, antialias: !(this.plain = isDrawnInSoftware()), powerPreference: 'high-performance' });
    if (!gl) throw new Error('This browser or its graphics driver has no WebGL 2.');
    this.canvas = canvas;
    this.solid = program(gl, INSTANCE, SOLID, this.plain);
    this.shadow = program(gl, INSTANCE, NOTHING);
    this.floor = program(gl, FLOOR_POINTS, FLOOR, this.plain);
    this.stroke = program(gl, STROKE_POINTS, PLAIN);
    this.haze = program(gl, HAZE_POINTS, PLAIN);
    const square = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, square);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), gl.STATIC_DRAW);
    this.square = gl.createVertexArray();
    gl.bindVertexArray(this.square);
    attributes(gl, square, 2, [[0, 2]], false);
    gl.bindVertexArray(null);
    const ends = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, ends);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([0, -0.5, 1, -0.5, 0, 0.5, 1, 0.5]), gl.STATIC_DRAW);
    this.strokes = new Gathered(gl, 11, [[1, 3], [2, 3], [3, 4], [4, 1]], ends);
    this.beams = new Gathered(gl, 7, [[0, 3], [1, 4]], null);
    this.makeShadows();
    this.shown = { sonars: true, trails: true, refused: true, dark: false };
    this.rulers = [];
    this.chapter = null;
    this.surfaces = {};
    this.load(data);
  }

  /** Shows other data, in place of what is shown. */
  load(data) {
    this.freeBatches();
    for (const s of Object.values(this.surfaces)) { this.gl.deleteBuffer(s.points); this.gl.deleteBuffer(s.index); }
    this.surfaces = {};
    this.data = data;
    data.objects.forEach(o => { o.pieces = pieces(o); o.bounds = boundsOf(data, o); o.paint = o.color.map(toLinear); });
    const count = data.objects.reduce((sum, o) => sum + o.pieces.length, 0);
    this.sides = !this.plain ? (count > MANY_PIECES ? FEW_SIDES : SIDES) : count > SOME_PIECES ? FEWEST_SIDES : FEW_SIDES;
    this.reach = Math.max(data.space[0], data.space[2], 1e-6);
    this.floorAt = -data.space[1] / 2;
    this.chapter = null;
    this.hidden = -1;
    this.selected = -1;
    this.setChapter(0);
  }

  freeBatches() {
    for (const old of this.chapter ? [this.statics, this.movers, this.goals] : []) {
      old.list.forEach(b => { this.gl.deleteBuffer(b.buffer); this.gl.deleteVertexArray(b.array); });
    }
  }

  makeShadows() {
    const gl = this.gl, size = Math.min(this.plain ? 1024 : 4096, gl.getParameter(gl.MAX_TEXTURE_SIZE));
    this.shadowSize = size;
    this.shadowMap = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.shadowMap);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, size, size);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    this.shadowTarget = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadowTarget);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.shadowMap, 0);
    gl.drawBuffers([gl.NONE]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  surface(key) {
    if (!this.surfaces[key]) {
      const made = key === 'box' ? boxSurface() : key === 'cylinder' ? cylinderSurface(this.sides) : key === 'ball' ? ballSurface(this.sides)
        : key === 'arrow' ? arrowSurface() : meshSurface(this.data.meshes[+key.slice(4)]);
      this.surfaces[key] = uploaded(this.gl, made);
    }
    return this.surfaces[key];
  }

  /** Batches for objects, and for each object the places of its pieces in them. */
  batches(ids, withArrows) {
    const counts = {}, made = {}, where = ids.map(id => {
      const all = this.data.objects[id].pieces.slice();
      if (withArrows) all.push(this.arrow(this.data.objects[id]));
      return all.map(piece => {
        counts[piece.key] = counts[piece.key] || 0;
        return { piece, key: piece.key, index: counts[piece.key]++ };
      });
    });
    for (const key in counts) made[key] = new Batch(this.gl, key, this.surface(key), counts[key]);
    where.forEach(w => w.forEach(({ piece, key, index }) => made[key].dress(index, this.data.looks[piece.look] || ARROW, piece.half, piece.inner)));
    return { list: Object.values(made), pieces: Object.values(counts).reduce((sum, n) => sum + n, 0), objects: where.map(w => w.map(e => ({ piece: e.piece, batch: made[e.key], index: e.index }))) };
  }

  /** The arrow on top of an object. */
  arrow(object) {
    const { low, high } = object.bounds, width = Math.min(high[0] - low[0], high[2] - low[2]) * 0.42;
    return { key: 'arrow', size: [width, 1, width, 0], half: [0, 0, 0], inner: [0, 0, 0],
      place: [(low[0] + high[0]) / 2, high[1] + 0.0015 * this.reach, (low[2] + high[2]) / 2, 0, 0, 0, 1] };
  }

  setChapter(k) {
    const chapter = this.data.chapters[k];
    if (!chapter || chapter === this.chapter) return;
    this.freeBatches();
    this.chapter = chapter;
    this.statics = this.batches(chapter.statics, false);
    this.movers = this.batches(chapter.movers, true);
    this.goals = this.batches(this.data.goals, false);
    this.statics.objects.forEach((o, k) => this.put(o, this.data.objects[chapter.statics[k]].pose));
    this.goals.objects.forEach((o, k) => this.put(o, this.data.objects[this.data.goals[k]].pose));
    this.poses = chapter.movers.map(() => [0, 0, 0, 0, 0, 0, 1]);
    this.red = [];
    this.farthest = 0;
    chapter.scans.forEach(s => s.distances.forEach(d => { if (d < Infinity) this.farthest = Math.max(this.farthest, d); }));
    const w = chapter.size[0] / 2, l = chapter.size[2] / 2, o = this.zero();
    this.border = [o[0] - w, o[2] - l, o[0] + w, o[2] + l];
    this.cell = 10 ** Math.round(Math.log10(this.reach * this.data.unit / 30)) / this.data.unit;
  }

  /** The world's origin on the page. */
  zero() { return this.data.origin.map(v => -v / this.data.unit); }

  put(object, pose) { for (const { piece, batch, index } of object) batch.set(index, within(pose, piece.place), piece.size); }

  /** Moves everything to where it is at a moment; `frame` may lie between two. */
  moment(frame) {
    this.setChapter(Math.max(0, chapterAt(this.data, frame)));
    this.frame = frame;
    const chapter = this.chapter;
    chapter.tracks.forEach((track, k) => {
      poseAt(track, frame, this.poses[k]);
      this.put(this.movers.objects[k], this.poses[k]);
      if (k === this.hidden) for (const { batch, index } of this.movers.objects[k]) batch.set(index, this.poses[k], [0, 0, 0, 0]);
    });
    this.markRefused(Math.floor(frame));
  }

  /** The object of a number: moveable ones first. */
  instances(k) { return k < this.chapter.movers.length ? this.movers.objects[k] : this.statics.objects[k - this.chapter.movers.length]; }

  markRefused(frame) {
    this.red.forEach(k => this.instances(k).forEach(({ batch, index }) => batch.tint(index, 0)));
    this.red = [];
    for (const b of this.shown.refused ? this.recent(frame) : []) {
      if (b.obstacle < 2) continue;
      const k = b.obstacle - 2;
      this.instances(k).forEach(({ batch, index }) => batch.tint(index, 0.7 * (1 - (frame - b.frame) / FRESH)));
      this.red.push(k);
    }
  }

  /** Moves that were refused in a frame or shortly before. */
  recent(frame) { return this.chapter.bumps.filter(b => b.frame <= frame && b.frame > frame - FRESH); }

  line(a, b, color, alpha, thick) { this.strokes.values.push(a[0], a[1], a[2], b[0], b[1], b[2], color[0], color[1], color[2], alpha, thick); }

  gather() {
    const { chapter, frame } = this, whole = Math.floor(frame);
    this.strokes.values = [];
    this.beams.values = [];
    const up = this.floorAt + 0.0015 * this.reach, edge = this.shown.dark ? [0.16, 0.18, 0.22] : [0.26, 0.28, 0.3];
    const [x, z, toX, toZ] = this.border, corner = [[x, up, z], [toX, up, z], [toX, up, toZ], [x, up, toZ]];
    const bordered = this.recent(whole).some(b => b.obstacle === 1);
    corner.forEach((c, k) => this.line(c, corner[(k + 1) % 4], bordered ? [0.6, 0.01, 0.04] : edge, 1, bordered ? 4 : 2));
    if (this.shown.trails) chapter.tracks.forEach((t, k) => this.trail(t, k, up));
    if (this.shown.sonars) chapter.scans.forEach((s, k) => this.scan(s, k, whole));
    if (this.shown.refused) for (const b of chapter.bumps) if (b.frame <= whole && b.frame > whole - TRAIL && b.mover !== this.hidden) this.cross(b, whole, up);
    for (const [a, b] of this.rulers) this.line(a, b, this.shown.dark ? [0.9, 0.7, 0.1] : [0.35, 0.2, 0], 1, 3);
    if (this.selected >= 0) this.ring(this.selected, this.shown.dark ? [0.9, 0.9, 0.9] : [0.02, 0.02, 0.02], up);
  }

  trail(track, k, up) {
    const last = lastUpTo(track.frames, Math.floor(this.frame)), first = Math.max(0, lastUpTo(track.frames, this.frame - TRAIL));
    const color = this.data.objects[this.chapter.movers[k]].paint, flat = Math.abs(track.poses[1] - track.poses[7 * last + 1]) < 1e-9;
    let from = null;
    for (let j = first; j <= last + 1; j++) {
      const p = j > last ? this.poses[k] : [track.poses[7 * j], track.poses[7 * j + 1], track.poses[7 * j + 2]], to = [p[0], flat ? up : p[1], p[2]];
      if (from && (from[0] !== to[0] || from[2] !== to[2] || from[1] !== to[1]))
        this.line(from, to, color, 0.15 + 0.6 * clamp((track.frames[Math.min(j, last)] - this.frame + TRAIL) / TRAIL, 0, 1), 2);
      from = to;
    }
  }

  /** The beams of one object's last measurement, from where it measured. */
  scan(scans, k, whole) {
    const at = lastUpTo(scans.frames, whole);
    if (at < 0) return;
    const pose = poseAt(this.chapter.tracks[k], scans.frames[at], [0, 0, 0, 0, 0, 0, 0]);
    this.data.sensors[scans.kinds[at]].forEach((sensor, s) => {
      const distance = scans.distances[scans.starts[at] + s], echo = distance < Infinity;
      const length = echo ? distance : Math.min(sensor.range, this.farthest || this.reach / 4);
      const color = echo ? distanceColor(clamp(distance / (this.farthest || 1), 0, 1)) : [0.4, 0.42, 0.45];
      this.beam(pose, sensor, length, color, echo);
    });
  }

  beam(pose, sensor, length, color, echo) {
    const from = add(pose.slice(0, 3), turned(pose, 3, sensor.at)), half = sensor.width / 2, alpha = echo ? 0.2 : 0.07;
    // a aside, b upwards from the direction of the sensor, on a ball around it
    const rim = (a, b) => {
      const v = [Math.cos(b) * Math.cos(sensor.bearing + a), Math.sin(b), -Math.cos(b) * Math.sin(sensor.bearing + a)];
      return add(from, times(turned(pose, 3, v), length));
    };
    if (half < 1e-4) {
      this.line(from, rim(0, 0), color, echo ? 0.8 : 0.25, echo ? 1.5 : 1);
      return;
    }
    const steps = this.chapter.spatial ? 14 : Math.max(2, Math.ceil(half / 0.06));
    const points = [];
    for (let j = 0; j <= steps; j++) {
      const a = this.chapter.spatial ? 2 * Math.PI * j / steps : half * (2 * j / steps - 1);
      points.push(this.chapter.spatial ? rim(half * Math.cos(a), half * Math.sin(a)) : rim(a, 0));
    }
    for (let j = 0; j < steps; j++) {
      for (const p of [from, points[j], points[j + 1]]) this.beams.values.push(...p, ...color, alpha);
      if (echo) this.line(points[j], points[j + 1], color, 0.9, 2);
    }
  }

  /** Where a move was refused, and in which direction it was to go. */
  cross(bump, whole, up) {
    const pose = poseAt(this.chapter.tracks[bump.mover], bump.frame, [0, 0, 0, 0, 0, 0, 0]), size = this.sizeOf(bump.mover);
    const age = whole - bump.frame, fresh = age < FRESH, c = [0.72, 0.02, 0.05], alpha = fresh ? 1 : 0.5, y = up;
    const s = size * 0.3, x = pose[0], z = pose[2], thick = fresh ? 3 : 1.5;
    this.line([x - s, y, z - s], [x + s, y, z + s], c, alpha, thick);
    this.line([x - s, y, z + s], [x + s, y, z - s], c, alpha, thick);
    const d = [Math.cos(bump.heading), 0, -Math.sin(bump.heading)];
    this.line([x, y, z], [x + d[0] * size * 1.5, y, z + d[2] * size * 1.5], c, alpha, thick);
    if (fresh) this.ring(bump.mover, c, pose[1]);
  }

  sizeOf(k) {
    const { low, high } = this.data.objects[this.chapter.movers[k]].bounds;
    return Math.hypot(high[0] - low[0], high[2] - low[2]) / 2;
  }

  ring(k, color, y) {
    const p = this.poses[k], r = this.sizeOf(k) * 1.25;
    for (let j = 0; j < 32; j++) {
      const [a, b] = [j, j + 1].map(v => [p[0] + r * Math.cos(v * Math.PI / 16), y, p[2] + r * Math.sin(v * Math.PI / 16)]);
      this.line(a, b, color, 1, 2.5);
    }
  }

  /** The sun's camera, around the whole scene. */
  sunCamera() {
    const s = this.data.space, radius = Math.hypot(s[0], s[1], s[2]) / 2 * 1.02 || 1, sun = this.sun = unit([-0.55, 1, 0.6]);
    return product(parallel(2 * radius, 2 * radius, 0, 4 * radius), lookAt(times(sun, 2 * radius), [0, 0, 0], [0, 0, -1]));
  }

  /** The sun's view of what casts shadows. Where the processor draws, many moveable pieces cast none, so that it is drawn once. */
  castShadows(sunCamera) {
    const { gl } = this, still = this.plain && this.movers.pieces > SOME_PIECES;
    if (still && this.shadowed === this.chapter) return;
    this.shadowed = still ? this.chapter : null;
    const casting = still ? this.statics.list : this.statics.list.concat(this.movers.list);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadowTarget);
    gl.disable(gl.SCISSOR_TEST);
    gl.viewport(0, 0, this.shadowSize, this.shadowSize);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1.5, 3);
    use(gl, this.shadow, { camera: sunCamera, sunCamera, push: 0 });
    casting.forEach(b => b.draw(this.shadow));
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.disable(gl.CULL_FACE);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** Draws the moment from a camera, its eye and its matrix, into a part of the canvas: left, bottom, width and height in pixels. */
  draw(eye, camera, part) {
    const { gl, canvas } = this, look = LOOKS[this.shown.dark ? 'dark' : 'light'];
    this.camera = camera;
    this.gather();
    const sunCamera = this.sunCamera(), solids = this.statics.list.concat(this.movers.list);
    this.castShadows(sunCamera);
    const [left, bottom, wide, high] = part || [0, 0, canvas.width, canvas.height];
    gl.viewport(left, bottom, wide, high);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(left, bottom, wide, high);
    const encode = v => v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055;
    gl.clearColor(...look.paper.map(encode), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.shadowMap);
    const common = { camera, sunCamera, eye, sun: this.sun, shadows: 0, paper: look.paper, night: look.night, floorAt: this.floorAt, reach: this.reach };
    const middle = [0, this.floorAt - 0.0005 * this.reach, 0];
    use(gl, this.solid, { ...common, alpha: 1, ground: look.ground, push: 1e-3 * this.reach });
    solids.forEach(b => b.draw(this.solid));
    gl.disable(gl.CULL_FACE);
    use(gl, this.floor, { ...common, middle, wide: 2.2 * this.reach, border: this.border, zero: this.zero(), cell: this.cell, ground: look.ground, line: look.line });
    gl.bindVertexArray(this.square);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    use(gl, this.haze, { camera });
    this.beams.draw();
    use(gl, this.solid, { ...common, alpha: 0.4, ground: look.ground, push: 0 });
    this.goals.list.forEach(b => b.draw(this.solid));
    gl.disable(gl.CULL_FACE);
    use(gl, this.stroke, { camera, eye, screen: [wide / 2, high / 2] });
    this.strokes.draw();
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  /** The object that a ray meets first: its number, moveable ones first; -1 for none. */
  pick(from, towards) {
    let best = Infinity, found = -1;
    this.chapter.movers.concat(this.chapter.statics).forEach((id, k) => {
      if (k === this.hidden) return;
      const object = this.data.objects[id], pose = k < this.poses.length ? this.poses[k] : object.pose;
      for (const piece of object.pieces) {
        const at = hitPiece(this.data, piece, pose, from, towards);
        if (at < best) { best = at; found = k; }
      }
    });
    return found;
  }
}
