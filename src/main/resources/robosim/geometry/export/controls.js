// Playing, the cameras, and what people press.

const SPEEDS = [0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
const el = id => document.getElementById(id);

/** Which cameras share the canvas; the first is the one that the buttons are about. */
const LAYOUTS = [['orbit'], ['orbit', 'eye'], ['top', 'orbit', 'eye', 'follow']];

/** Where one looks from: around a point, from above, from a robot, behind a robot. */
class Camera {
  constructor(view) { this.view = view; this.kind = 'orbit'; this.fit(); }

  fit() {
    this.yaw = 0.6; this.pitch = 0.72; this.target = [0.035 * this.view.reach, -this.view.data.space[1] / 2, 0.05 * this.view.reach];
    this.settled = null; this.far = this.view.reach * 1.5; this.topFar = this.view.reach * 1.36; this.look = [0, 0]; this.topTarget = [0, 0, 0.05 * this.view.reach];
  }

  /** The eye, where it looks, and what is up there. */
  place(pose, size) {
    if (this.kind === 'eye' && pose) {
      const a = this.look[0], b = this.look[1], v = [Math.cos(b) * Math.cos(a), Math.sin(b), -Math.cos(b) * Math.sin(a)];
      const eye = [pose[0], pose[1], pose[2]];
      return { eye, target: add(eye, turned(pose, 3, v)), up: turned(pose, 3, [0, 1, 0]) };
    }
    if (this.kind === 'top') {
      const t = pose && this.follow ? [pose[0], 0, pose[2]] : this.topTarget;
      return { eye: add(t, [0, this.height(), 0]), target: t, up: [0, 0, -1] };
    }
    const c = [Math.cos(this.pitch) * Math.sin(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch) * Math.cos(this.yaw)];
    if (this.kind === 'follow' && pose) {
      const back = turned(pose, 3, [-1, 0, 0]), t = add(pose, [0, size * 0.3, 0]), flat = unit([back[0], 0, back[2]]);
      return { eye: add(t, times(add(flat, [0, 0.55, 0]), size * 7 * this.far / (this.view.reach * 1.5))), target: t, up: [0, 1, 0] };
    }
    return { eye: add(this.target, times(c, this.far)), target: this.target, up: [0, 1, 0] };
  }

  /** How far above the plan the eye is: so far that the view is almost parallel. */
  height() { return 10 * (this.view.reach + this.view.data.space[1]); }

  matrix({ eye, target, up }, aspect) {
    const reach = this.view.reach;
    const fov = this.kind === 'eye' ? 1.25 : this.kind === 'top' ? 2 * Math.atan(this.topFar * 0.394 / this.height()) : 0.8;
    const wide = aspect < 1 ? 2 * Math.atan(Math.tan(fov / 2) / aspect) : fov;
    if (this.kind === 'top') return product(perspective(wide, aspect, this.height() / 2, 2 * this.height()), lookAt(eye, target, up));
    const near = this.kind === 'eye' ? reach * 1e-3 : reach * 4e-3;
    return product(perspective(wide, aspect, near, reach * 12 + 4 * this.far), lookAt(eye, target, up));
  }

  drag(dx, dy, pan, pose) {
    if (this.kind === 'eye') { this.look[0] += dx * 0.004; this.look[1] = clamp(this.look[1] + dy * 0.004, -1.5, 1.5); return; }
    if (this.kind === 'top') { const k = this.topFar * 0.0011; this.topTarget = add(this.topTarget, [-dx * k, 0, -dy * k]); return; }
    if (this.kind === 'follow') { this.kind = 'orbit'; if (pose) this.target = pose.slice(0, 3); }
    if (pan) {
      const k = this.far * 0.0012, s = Math.sin(this.yaw), c = Math.cos(this.yaw);
      this.target = add(this.target, [(-dx * c - dy * s) * k, 0, (dx * s - dy * c) * k]);
    } else {
      this.yaw -= dx * 0.006;
      this.pitch = clamp(this.pitch + dy * 0.005, 0.03, 1.55);
    }
  }

  zoom(factor) {
    const far = v => clamp(v * factor, this.view.reach * 0.01, this.view.reach * 6);
    if (this.kind === 'top') this.topFar = far(this.topFar); else this.far = far(this.far);
  }
}

/** Milliseconds between frames above which moving pictures get fewer pixels; the least share of a side's; how long nothing moves before all are drawn. */
const SLOW = 40, ROUGHEST = 0.5, STILL = 300;

class Player {
  constructor(data, view) {
    Object.assign(this, { data, view, at: 0, playing: false, speed: 4, dirty: true, names: false, last: 0, live: null, measuring: false, sharp: 1, pace: 0, drawn: 0, rough: false });
    this.cameras = [new Camera(view)];
    this.camera = this.cameras[0];
    this.layout = 0;
    this.panes = [];
    this.robot = data.chapters[0].movers.length ? 0 : -1;
  }
  get step() { return Math.floor(this.at); }
  get first() { return this.data.begin || 0; }
  set settled(place) { this.cameras.forEach(c => { c.settled = place; }); }
  get matrix() { return this.panes[0].matrix; }
  seek(step) { this.playing = false; this.at = clamp(Math.floor(step), this.first, this.data.frames - 1); this.dirty = true; }
  toggle() {
    this.playing = !this.playing && (this.data.frames > 1 || this.live !== null);
    if (this.playing && !this.live && this.at >= this.data.frames - 1) this.at = 0;
    this.dirty = true;
  }

  /** More cameras, or one again. */
  nextLayout() {
    this.layout = (this.layout + 1) % LAYOUTS.length;
    const kinds = LAYOUTS[this.layout].filter(kind => this.robot >= 0 || (kind !== 'eye' && kind !== 'follow'));
    this.cameras = kinds.map((kind, k) => {
      const camera = k === 0 && kind === this.camera.kind ? this.camera : new Camera(this.view);
      camera.kind = kind;
      return camera;
    });
    this.camera = this.cameras[0];
    this.dirty = true;
  }

  /** The part of the canvas of a camera: left, top, width and height as shares. */
  part(k) {
    const n = this.cameras.length, columns = n > 1 ? 2 : 1, rows = Math.ceil(n / columns);
    return [(k % columns) / columns, Math.floor(k / columns) / rows, 1 / columns, 1 / rows];
  }

  /** The pane at a place of the canvas. */
  paneAt(x, y) {
    const { clientWidth, clientHeight } = this.view.canvas;
    return this.panes.find(({ part: [left, top, wide, high] }) => x < (left + wide) * clientWidth && y < (top + high) * clientHeight) || this.panes[0];
  }
  faster(by) { this.speed = clamp(this.speed + by, 0, SPEEDS.length - 1); this.dirty = true; }
  movers() { return this.view.chapter.movers; }
  pose() { return this.robot >= 0 && this.robot < this.view.poses.length ? this.view.poses[this.robot] : null; }

  tick(now) {
    const past = Math.min(0.1, (now - this.last) / 1000);
    this.last = now;
    if (this.playing && this.live) {
      this.dirty = this.dirty || this.at !== this.data.frames - 1;
      this.at = this.data.frames - 1;
    } else if (this.playing) {
      this.at += past * SPEEDS[this.speed];
      if (this.at >= this.data.frames - 1) { this.at = this.data.frames - 1; this.playing = false; }
      this.dirty = true;
    }
    if (this.dirty) {
      this.pace += 0.2 * ((this.drawn === this.before ? now - this.drawn : 16) - this.pace);
      if (this.pace > SLOW && this.sharp > ROUGHEST) { this.sharp = Math.max(ROUGHEST, 0.8 * this.sharp); this.pace = 16; }
      this.dirty = false;
      this.rough = this.sharp < 1;
      this.draw(past);
      this.drawn = now;
    } else if (this.rough && now - this.drawn > STILL) {
      this.rough = false;
      this.draw();
    }
    this.before = now;
  }

  /** Draws the present moment; the camera glides to where it is wanted. */
  draw(past) {
    const { view, canvas = view.canvas } = this, ratio = Math.min(window.devicePixelRatio || 1, 2) * (this.rough ? this.sharp : 1);
    const w = Math.max(1, Math.round(canvas.clientWidth * ratio)), h = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
    view.hidden = -1;
    view.setChapter(Math.max(0, chapterAt(this.data, this.at)));
    if (this.robot >= this.movers().length) this.robot = this.movers().length - 1;
    this.panes = this.cameras.map((camera, k) => {
      const part = this.part(k), [left, top, wide, high] = part;
      view.hidden = camera.kind === 'eye' ? this.robot : -1;
      view.selected = camera.kind === 'eye' ? -1 : this.robot;
      view.moment(this.at);
      const place = this.glide(camera, past), matrix = camera.matrix(place, wide * w / (high * h));
      view.draw(place.eye, matrix, [Math.round(left * w), Math.round((1 - top - high) * h), Math.round(wide * w), Math.round(high * h)]);
      return { camera, part, place, matrix, hidden: view.hidden };
    });
    view.hidden = this.camera.kind === 'eye' ? this.robot : -1;
    this.labels();
    this.show();
  }

  /** Where a camera is on the way to where it is wanted. */
  glide(camera, past) {
    const pose = this.pose(), wanted = camera.place(pose, pose ? this.view.sizeOf(this.robot) : 1), was = camera.settled;
    let place = wanted;
    if (was && past !== undefined && camera.kind !== 'eye') {
      const share = 1 - Math.exp(-past * 14);
      place = { eye: mix(was.eye, wanted.eye, share), target: mix(was.target, wanted.target, share), up: mix(was.up, wanted.up, share) };
      if (Math.hypot(...sub(place.eye, wanted.eye)) + Math.hypot(...sub(place.up, wanted.up)) > 1e-4 * this.view.reach) this.dirty = true; else place = wanted;
    }
    camera.settled = place;
    return place;
  }

  /** The names of the moveable objects, in each pane. */
  labels() {
    const box = el('names'), count = this.view.poses.length, size = this.names ? count * this.panes.length : 0;
    while (box.children.length < size) box.append(document.createElement('span'));
    while (box.children.length > size) box.lastChild.remove();
    for (let at = 0; at < size; at++) {
      const k = at % count, pane = this.panes[Math.floor(at / count)], [left, top, wide, high] = pane.part, pose = this.view.poses[k];
      const tall = this.data.objects[this.movers()[k]].bounds.high[1], span = box.children[at];
      const p = project(pane.matrix, [pose[0], pose[1] + tall * 1.2, pose[2]]);
      span.hidden = !p || k === pane.hidden || Math.abs(p[0]) > 1 || Math.abs(p[1]) > 1;
      if (span.hidden) continue;
      const x = (left + wide * (p[0] + 1) / 2) * this.view.canvas.clientWidth, y = (top + high * (1 - p[1]) / 2) * this.view.canvas.clientHeight;
      span.textContent = this.data.objects[this.movers()[k]].name;
      span.style.transform = 'translate(' + x + 'px, ' + y + 'px) translate(-50%, -100%)';
    }
  }

  show() {
    const step = this.step;
    el('speed').value = this.speed;
    el('count').textContent = (step + 1 + this.data.first).toLocaleString('en') + ' / ' + (this.data.frames + this.data.first).toLocaleString('en');
    el('time').min = this.first;
    el('time').max = this.data.frames - 1;
    el('time').value = step;
    el('time').style.setProperty('--done', 100 * (step - this.first) / Math.max(1, this.data.frames - 1 - this.first) + '%');
    el('story').textContent = this.data.frames > 1 || this.data.remarks.length ? story(this.data, step) : '';
    const { sonars, trails, refused } = this.view.shown;
    const buttons = [this.playing, this.camera.kind, sonars, trails, refused, this.names, this.measuring, this.cameras.length].join();
    if (buttons !== this.buttons) this.showButtons();
    this.buttons = buttons;
    this.tell();
  }

  /** Which buttons are pressed; only where that has changed, as the browser lays them out again. */
  showButtons() {
    el('play').setAttribute('aria-pressed', this.playing);
    el('play').innerHTML = this.playing ? ICONS.pause : ICONS.play;
    document.querySelectorAll('[data-camera]').forEach(b => b.setAttribute('aria-pressed', b.dataset.camera === this.camera.kind));
    for (const name of ['sonars', 'trails', 'refused']) el(name).setAttribute('aria-pressed', this.view.shown[name]);
    el('labels').setAttribute('aria-pressed', this.names);
    el('measure').setAttribute('aria-pressed', this.measuring);
    el('cameras').setAttribute('aria-pressed', this.cameras.length > 1);
  }

  /** What is known of the selected object. */
  tell() {
    const k = this.picked ?? this.robot, box = el('info'), all = this.movers().concat(this.view.chapter.statics);
    box.hidden = k < 0 || k >= all.length;
    if (box.hidden) return;
    const object = this.data.objects[all[k]], moves = k < this.movers().length, pose = moves ? this.view.poses[k] : object.pose;
    const digits = v => (+v.toPrecision(6)).toString(), unit = this.data.unitName ? ' ' + this.data.unitName : '';
    const { low, high } = object.bounds, forward = turned(pose, 3, [1, 0, 0]), heading = Math.atan2(-forward[2], forward[0]) * 180 / Math.PI;
    box.innerHTML = '';
    const line = (tag, text) => { const e = document.createElement(tag); e.textContent = text; box.append(e); };
    line('b', object.name || 'a ' + object.kind);
    line('span', (object.name ? object.kind + ', ' : '') + sub(high, low).map(v => digits(v * this.data.unit)).join(' × ') + unit);
    line('span', 'at ' + toWorld(this.data, pose.slice(0, 3)).map(v => v.toFixed(3)).join(', '));
    line('span', 'heading ' + heading.toFixed(1) + '°');
    const ruler = this.view.rulers[0];
    if (ruler) line('b', Math.hypot(...sub(ruler[0], ruler[1])) * this.data.unit > 0 ? 'measured ' + digits(Math.hypot(...sub(ruler[0], ruler[1])) * this.data.unit) + unit : 'the other end?');
  }

  /** The ray of sight through a place of the canvas: its eye and its direction. */
  ray(x, y) {
    const { place, matrix, part: [left, top, wide, high] } = this.paneAt(x, y), { clientWidth, clientHeight } = this.view.canvas;
    const z = unit(sub(place.eye, place.target)), right = unit(cross(place.up, z)), up = cross(z, right);
    const fx = 2 * (x / clientWidth - left) / wide - 1, fy = 1 - 2 * (y / clientHeight - top) / high, p = perspectiveOf(matrix, place);
    return [place.eye, unit(add(add(times(right, fx / p[0]), times(up, fy / p[1])), times(z, -1)))];
  }

  /** Where a line of sight meets a height; null above the horizon. */
  levelAt(x, y, height) {
    const [eye, towards] = this.ray(x, y), far = (height - eye[1]) / towards[1];
    return far > 0 && far < Infinity ? add(eye, times(towards, far)) : null;
  }

  /** The number of the object at a place of the canvas; -1 for none. */
  objectAt(x, y) {
    this.view.hidden = this.paneAt(x, y).hidden;
    return this.view.pick(...this.ray(x, y));
  }

  /** A point to measure from or to, on the floor. */
  measureAt(x, y) {
    const p = this.levelAt(x, y, this.view.floorAt + 0.002 * this.view.reach), open = this.view.rulers[0];
    if (p) this.view.rulers = [open && open.isOpen ? [open[0], p] : Object.assign([p, p], { isOpen: true })];
    this.dirty = true;
  }

  pickAt(x, y) {
    const found = this.objectAt(x, y);
    this.picked = found < 0 ? undefined : found;
    if (found >= 0 && found < this.movers().length) { this.robot = found; this.picked = undefined; }
    this.dirty = true;
  }

  choose(kind) {
    if ((kind === 'eye' || kind === 'follow') && this.robot < 0) return;
    if (kind === 'eye' || kind === 'top' || this.camera.kind === 'top') this.camera.settled = null;
    this.camera.kind = kind;
    this.camera.look = [0, 0];
    this.dirty = true;
  }

  nextRobot(by) {
    const n = this.movers().length;
    if (n) { this.robot = (this.robot + by + n) % n; this.picked = undefined; this.dirty = true; }
  }

  /** The first step after this one, or before it, in which a move was refused. */
  nextRefused(by) {
    const steps = this.data.chapters.flatMap(c => c.bumps.map(b => b.frame));
    const found = by > 0 ? steps.find(s => s > this.step) : steps.filter(s => s < this.step).pop();
    if (found !== undefined) this.seek(found);
  }
}

/** The first two diagonal elements of the projection alone. */
function perspectiveOf(m, { eye, target, up }) {
  const z = unit(sub(eye, target)), x = unit(cross(up, z)), y = cross(z, x);
  return [dot([m[0], m[4], m[8]], x), dot([m[1], m[5], m[9]], y)];
}

const icon = path => `<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><path d="${path}" fill="currentColor"/></svg>`;
const ICONS = {
  play: icon('M5 3l12 7-12 7z'), pause: icon('M5 3h4v14H5zM11 3h4v14h-4z'), back: icon('M13 4v12L6 10zM4 4h2v12H4z'), next: icon('M7 4v12l7-6zM14 4h2v12h-2z'),
  begin: icon('M17 4v12l-6-6zM11 4v12L5 10zM3 4h2v12H3z'), end: icon('M3 4v12l6-6zM9 4v12l6-6zM15 4h2v12h-2z'),
};

function listen(player) {
  const { canvas } = player.view, press = {
    ' ': () => player.toggle(), ArrowLeft: e => player.seek(player.step - (e.shiftKey ? 10 : 1)), ArrowRight: e => player.seek(player.step + (e.shiftKey ? 10 : 1)),
    Home: () => player.seek(player.first), End: () => { player.seek(player.data.frames - 1); player.playing = player.live !== null; }, ArrowUp: () => player.faster(1), ArrowDown: () => player.faster(-1),
    1: () => player.choose('orbit'), 2: () => player.choose('top'), 3: () => player.choose('eye'), 4: () => player.choose('follow'),
    r: e => player.nextRobot(1), R: () => player.nextRobot(-1), x: () => player.nextRefused(1), X: () => player.nextRefused(-1),
    s: () => { player.view.shown.sonars = !player.view.shown.sonars; }, t: () => { player.view.shown.trails = !player.view.shown.trails; },
    b: () => { player.view.shown.refused = !player.view.shown.refused; }, c: () => player.nextLayout(),
    g: () => { player.camera.follow = !player.camera.follow; }, p: () => picture(player),
    m: () => { player.measuring = !player.measuring; player.view.rulers = []; },
    n: () => { player.names = !player.names; }, d: () => dark(!player.view.shown.dark), f: () => player.camera.fit(),
    '+': () => player.camera.zoom(0.8), '-': () => player.camera.zoom(1.25), '?': () => { el('help').hidden = !el('help').hidden; }, h: () => { el('help').hidden = !el('help').hidden; },
    Escape: () => { el('help').hidden = true; player.picked = undefined; player.measuring = false; player.view.rulers = []; },
  };
  const dark = on => { player.view.shown.dark = on; document.documentElement.classList.toggle('dark', on); player.dirty = true; };
  addEventListener('keydown', e => {
    if (e.ctrlKey || e.metaKey || e.altKey || !press[e.key] || e.target.tagName === 'SELECT') return;
    e.preventDefault();
    press[e.key](e);
    player.dirty = true;
  });
  const click = (id, key) => el(id).addEventListener('click', e => { press[key](e); player.dirty = true; });
  for (const [id, key] of [['play', ' '], ['back', 'ArrowLeft'], ['next', 'ArrowRight'], ['begin', 'Home'], ['end', 'End'], ['sonars', 's'], ['trails', 't'],
    ['labels', 'n'], ['refused', 'b'], ['cameras', 'c'], ['measure', 'm'], ['picture', 'p'], ['theme', 'd'], ['ask', '?'], ['close', 'Escape'], ['fit', 'f']]) click(id, key);
  document.querySelectorAll('[data-camera]').forEach(b => b.addEventListener('click', () => player.choose(b.dataset.camera)));
  el('time').addEventListener('input', () => player.seek(+el('time').value));
  el('speed').addEventListener('change', () => { player.speed = +el('speed').value; });
  const fingers = new Map();
  let moved = 0;
  canvas.addEventListener('pointerdown', e => {
    canvas.setPointerCapture(e.pointerId);
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    moved = 0;
    player.camera = player.paneAt(e.offsetX, e.offsetY).camera;
    if (player.live && !player.measuring && fingers.size === 1 && e.buttons < 2) player.live.take(e.offsetX, e.offsetY);
    player.dirty = true;
  });
  canvas.addEventListener('pointermove', e => {
    const was = fingers.get(e.pointerId);
    if (!was) return;
    const now = [e.clientX, e.clientY], dx = now[0] - was[0], dy = now[1] - was[1];
    moved += Math.abs(dx) + Math.abs(dy);
    if (player.live && player.live.grip && fingers.size === 1) {
      if (moved > 4) player.live.drag(e.offsetX, e.offsetY, e.shiftKey);
    } else if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== e.pointerId)[1], d = p => Math.hypot(p[0] - other[0], p[1] - other[1]);
      player.camera.zoom(d(was) / Math.max(1, d(now)));
      player.camera.drag(dx / 2, dy / 2, true, player.pose());
    } else {
      player.camera.drag(dx, dy, e.shiftKey || e.buttons > 1, player.pose());
    }
    fingers.set(e.pointerId, now);
    player.dirty = true;
  });
  const gone = e => {
    if (player.live) player.live.release();
    if (!fingers.delete(e.pointerId) || moved >= 4 || e.type !== 'pointerup') return;
    if (player.measuring) player.measureAt(e.offsetX, e.offsetY); else player.pickAt(e.offsetX, e.offsetY);
  };
  canvas.addEventListener('pointerup', gone);
  canvas.addEventListener('pointercancel', gone);
  canvas.addEventListener('contextmenu', e => e.preventDefault());
  canvas.addEventListener('wheel', e => { e.preventDefault(); player.camera.zoom(Math.exp(clamp(e.deltaY, -120, 120) * 0.0015)); player.dirty = true; }, { passive: false });
  addEventListener('resize', () => { player.dirty = true; });
  dark(matchMedia('(prefers-color-scheme: dark)').matches);
  return dark;
}

/** Saves what is seen as a PNG. */
function picture(player) {
  player.draw();
  player.view.canvas.toBlob(blob => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = (player.data.title || 'view') + '-' + (player.step + 1 + player.data.first) + '.png';
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  });
}

/** Settings in the address, or else those of the writer of the page: #step=120&camera=eye&robot=drum 1&dark=1&sonars=0&trails=0&names=1&speed=10&play=1 */
function fromAddress(player, dark) {
  const given = new URLSearchParams(location.hash.slice(1) || '%START%'), number = (name, then) => { if (/^\d+$/.test(given.get(name) || '')) then(+given.get(name)); };
  number('step', v => player.seek(v - 1 - player.data.first));
  const robot = player.movers().findIndex(id => player.data.objects[id].name === given.get('robot'));
  if (robot >= 0) player.robot = robot;
  if (['orbit', 'top', 'eye', 'follow'].includes(given.get('camera'))) player.choose(given.get('camera'));
  number('dark', v => dark(v > 0));
  number('sonars', v => { player.view.shown.sonars = v > 0; });
  number('trails', v => { player.view.shown.trails = v > 0; });
  number('names', v => { player.names = v > 0; });
  number('yaw', v => { player.camera.yaw = v * Math.PI / 180; });
  number('pitch', v => { player.camera.pitch = clamp(v * Math.PI / 180, 0.03, 1.55); });
  number('zoom', v => { player.camera.zoom(100 / Math.max(v, 1)); });
  number('speed', v => { player.speed = Math.max(0, SPEEDS.findIndex(s => s >= v)); });
  number('play', v => { if (v) player.toggle(); });
}

/** A timeline's marks for refused moves, as a picture behind it. */
function marks(data) {
  const canvas = document.createElement('canvas'), c = canvas.getContext('2d');
  canvas.width = 1000; canvas.height = 1;
  c.fillStyle = '#c8102e';
  const from = data.begin || 0, size = Math.max(1, data.frames - 1 - from);
  data.chapters.forEach(chapter => chapter.bumps.forEach(b => c.fillRect(Math.round((b.frame - from) / size * 998), 0, 2, 1)));
  return 'url(' + canvas.toDataURL() + ')';
}

/** Shows decoded data for the first time. */
function show(data) {
  el('title').textContent = data.title;
  el('subtitle').textContent = data.subtitle;
  if (!data.chapters.length) throw new Error('The recording has no world.');
  const player = new Player(data, new View(el('canvas'), data));
  for (const id of ['back', 'next', 'begin', 'end']) el(id).innerHTML = ICONS[id];
  SPEEDS.forEach((s, k) => el('speed').add(new Option(s + ' / s', k)));
  el('time').style.setProperty('--marks', marks(data));
  el('bar').classList.toggle('still', data.frames < 2);
  document.documentElement.classList.toggle('plain', player.view.plain);
  document.querySelectorAll('[data-camera=eye],[data-camera=follow]').forEach(b => { b.disabled = player.robot < 0; });
  const dark = listen(player);
  fromAddress(player, dark);
  addEventListener('hashchange', () => { fromAddress(player, dark); player.settled = null; player.dirty = true; });
  const tick = now => { player.tick(now); requestAnimationFrame(tick); };
  requestAnimationFrame(tick);
  window.robosim = player;
  player.draw();
  document.documentElement.dataset.state = 'ready';
  return player;
}

function fail(failure) {
  el('problem').textContent = 'This page cannot be shown: ' + failure.message;
  el('problem').hidden = false;
  document.documentElement.dataset.state = 'failed';
}

async function begin() {
  try {
    if (el('live').textContent.trim()) new Live(JSON.parse(el('live').textContent)).begin();
    else show(decode(await unpack(el('data').textContent)));
  } catch (failure) { fail(failure); }
}

if (typeof document !== 'undefined') begin();
