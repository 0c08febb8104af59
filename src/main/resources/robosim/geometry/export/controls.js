// Playing, the cameras, and what people press.

const SPEEDS = [0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
const el = id => document.getElementById(id);

/** Where one looks from: around a point, from above, from a robot, behind a robot. */
class Camera {
  constructor(view) { this.view = view; this.kind = 'orbit'; this.fit(); }

  fit() {
    this.yaw = 0.6; this.pitch = 0.72; this.target = [0.035 * this.view.reach, -this.view.data.space[1] / 2, 0.05 * this.view.reach];
    this.far = this.view.reach * 1.5; this.topFar = this.view.reach * 1.36; this.look = [0, 0]; this.topTarget = [0, 0, 0.05 * this.view.reach];
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
      return { eye: add(t, [0, this.topFar, 0]), target: t, up: [0, 0, -1] };
    }
    const c = [Math.cos(this.pitch) * Math.sin(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch) * Math.cos(this.yaw)];
    if (this.kind === 'follow' && pose) {
      const back = turned(pose, 3, [-1, 0, 0]), t = add(pose, [0, size * 0.3, 0]), flat = unit([back[0], 0, back[2]]);
      return { eye: add(t, times(add(flat, [0, 0.55, 0]), size * 7 * this.far / (this.view.reach * 1.5))), target: t, up: [0, 1, 0] };
    }
    return { eye: add(this.target, times(c, this.far)), target: this.target, up: [0, 1, 0] };
  }

  matrix({ eye, target, up }) {
    const aspect = this.view.canvas.width / this.view.canvas.height, reach = this.view.reach;
    const fov = this.kind === 'eye' ? 1.25 : this.kind === 'top' ? 0.75 : 0.8;
    const wide = aspect < 1 ? 2 * Math.atan(Math.tan(fov / 2) / aspect) : fov;
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

class Player {
  constructor(data, view) {
    Object.assign(this, { data, view, at: 0, playing: false, speed: 4, dirty: true, names: false, last: 0 });
    this.camera = new Camera(view);
    this.robot = data.chapters[0].movers.length ? 0 : -1;
    this.settled = null;
  }
  get step() { return Math.floor(this.at); }
  seek(step) { this.playing = false; this.at = clamp(Math.floor(step), 0, this.data.frames - 1); this.dirty = true; }
  toggle() {
    this.playing = !this.playing && this.data.frames > 1;
    if (this.playing && this.at >= this.data.frames - 1) this.at = 0;
    this.dirty = true;
  }
  faster(by) { this.speed = clamp(this.speed + by, 0, SPEEDS.length - 1); this.dirty = true; }
  movers() { return this.view.chapter.movers; }
  pose() { return this.robot >= 0 && this.robot < this.view.poses.length ? this.view.poses[this.robot] : null; }

  tick(now) {
    const past = Math.min(0.1, (now - this.last) / 1000);
    this.last = now;
    if (this.playing) {
      this.at += past * SPEEDS[this.speed];
      if (this.at >= this.data.frames - 1) { this.at = this.data.frames - 1; this.playing = false; }
      this.dirty = true;
    }
    if (this.dirty) { this.dirty = false; this.draw(past); }
  }

  /** Draws the present moment; the camera glides to where it is wanted. */
  draw(past) {
    const { view, canvas = view.canvas } = this, ratio = Math.min(window.devicePixelRatio || 1, 2);
    const w = Math.max(1, Math.round(canvas.clientWidth * ratio)), h = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
    view.hidden = -1;
    view.setChapter(Math.max(0, chapterAt(this.data, this.at)));
    if (this.robot >= this.movers().length) this.robot = this.movers().length - 1;
    if (this.camera.kind === 'eye') view.hidden = this.robot;
    view.selected = this.camera.kind === 'eye' ? -1 : this.robot;
    view.moment(this.at);
    const pose = this.pose(), wanted = this.camera.place(pose, pose ? view.sizeOf(this.robot) : 1);
    let place = wanted;
    if (this.settled && past !== undefined && this.camera.kind !== 'eye') {
      const share = 1 - Math.exp(-past * 14);
      place = { eye: mix(this.settled.eye, wanted.eye, share), target: mix(this.settled.target, wanted.target, share), up: mix(this.settled.up, wanted.up, share) };
      if (Math.hypot(...sub(place.eye, wanted.eye)) + Math.hypot(...sub(place.up, wanted.up)) > 1e-4 * view.reach) this.dirty = true; else place = wanted;
    }
    this.settled = place;
    view.draw(place.eye, this.matrix = this.camera.matrix(place));
    this.labels();
    this.show();
  }

  labels() {
    const box = el('names'), list = this.names ? this.view.poses : [];
    while (box.children.length < list.length) box.append(document.createElement('span'));
    while (box.children.length > list.length) box.lastChild.remove();
    list.forEach((pose, k) => {
      const high = this.data.objects[this.movers()[k]].bounds.high[1];
      const p = project(this.matrix, [pose[0], pose[1] + high * 1.2, pose[2]]), span = box.children[k];
      span.hidden = !p || k === this.view.hidden;
      if (!p) return;
      span.textContent = this.data.objects[this.movers()[k]].name;
      span.style.transform = `translate(${(p[0] + 1) / 2 * this.view.canvas.clientWidth}px, ${(1 - p[1]) / 2 * this.view.canvas.clientHeight}px) translate(-50%, -100%)`;
    });
  }

  show() {
    const step = this.step;
    el('play').setAttribute('aria-pressed', this.playing);
    el('play').innerHTML = this.playing ? ICONS.pause : ICONS.play;
    el('speed').value = this.speed;
    el('count').textContent = (step + 1 + this.data.first).toLocaleString('en') + ' / ' + (this.data.frames + this.data.first).toLocaleString('en');
    el('time').value = step;
    el('time').style.setProperty('--done', 100 * step / Math.max(1, this.data.frames - 1) + '%');
    el('story').textContent = this.data.frames > 1 || this.data.remarks.length ? story(this.data, step) : '';
    document.querySelectorAll('[data-camera]').forEach(b => b.setAttribute('aria-pressed', b.dataset.camera === this.camera.kind));
    for (const name of ['sonars', 'trails']) el(name).setAttribute('aria-pressed', this.view.shown[name]);
    el('labels').setAttribute('aria-pressed', this.names);
    this.tell();
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
  }

  pickAt(x, y) {
    const { canvas } = this.view, place = this.settled, m = this.matrix;
    const z = unit(sub(place.eye, place.target)), right = unit(cross(place.up, z)), up = cross(z, right);
    const fx = (2 * x / canvas.clientWidth - 1), fy = 1 - 2 * y / canvas.clientHeight;
    const p = perspectiveOf(m, place);
    const found = this.view.pick(place.eye, unit(add(add(times(right, fx / p[0]), times(up, fy / p[1])), times(z, -1))));
    this.picked = found < 0 ? undefined : found;
    if (found >= 0 && found < this.movers().length) { this.robot = found; this.picked = undefined; }
    this.dirty = true;
  }

  choose(kind) {
    if ((kind === 'eye' || kind === 'follow') && this.robot < 0) return;
    this.camera.kind = kind;
    this.camera.look = [0, 0];
    if (kind === 'eye') this.settled = null;
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
    Home: () => player.seek(0), End: () => player.seek(player.data.frames - 1), ArrowUp: () => player.faster(1), ArrowDown: () => player.faster(-1),
    1: () => player.choose('orbit'), 2: () => player.choose('top'), 3: () => player.choose('eye'), 4: () => player.choose('follow'),
    r: e => player.nextRobot(1), R: () => player.nextRobot(-1), x: () => player.nextRefused(1), X: () => player.nextRefused(-1),
    s: () => { player.view.shown.sonars = !player.view.shown.sonars; }, t: () => { player.view.shown.trails = !player.view.shown.trails; },
    n: () => { player.names = !player.names; }, d: () => dark(!player.view.shown.dark), f: () => player.camera.fit(),
    '+': () => player.camera.zoom(0.8), '-': () => player.camera.zoom(1.25), '?': () => { el('help').hidden = !el('help').hidden; }, h: () => { el('help').hidden = !el('help').hidden; },
    Escape: () => { el('help').hidden = true; player.picked = undefined; },
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
    ['labels', 'n'], ['theme', 'd'], ['ask', '?'], ['close', 'Escape'], ['fit', 'f']]) click(id, key);
  document.querySelectorAll('[data-camera]').forEach(b => b.addEventListener('click', () => player.choose(b.dataset.camera)));
  el('time').addEventListener('input', () => player.seek(+el('time').value));
  el('speed').addEventListener('change', () => { player.speed = +el('speed').value; });
  const fingers = new Map();
  let moved = 0;
  canvas.addEventListener('pointerdown', e => { canvas.setPointerCapture(e.pointerId); fingers.set(e.pointerId, [e.clientX, e.clientY]); moved = 0; });
  canvas.addEventListener('pointermove', e => {
    const was = fingers.get(e.pointerId);
    if (!was) return;
    const now = [e.clientX, e.clientY], dx = now[0] - was[0], dy = now[1] - was[1];
    moved += Math.abs(dx) + Math.abs(dy);
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== e.pointerId)[1], d = p => Math.hypot(p[0] - other[0], p[1] - other[1]);
      player.camera.zoom(d(was) / Math.max(1, d(now)));
      player.camera.drag(dx / 2, dy / 2, true, player.pose());
    } else {
      player.camera.drag(dx, dy, e.shiftKey || e.buttons > 1, player.pose());
    }
    fingers.set(e.pointerId, now);
    player.dirty = true;
  });
  const gone = e => { if (fingers.delete(e.pointerId) && moved < 4 && e.type === 'pointerup') player.pickAt(e.offsetX, e.offsetY); };
  canvas.addEventListener('pointerup', gone);
  canvas.addEventListener('pointercancel', gone);
  canvas.addEventListener('contextmenu', e => e.preventDefault());
  canvas.addEventListener('wheel', e => { e.preventDefault(); player.camera.zoom(Math.exp(clamp(e.deltaY, -120, 120) * 0.0015)); player.dirty = true; }, { passive: false });
  addEventListener('resize', () => { player.dirty = true; });
  dark(matchMedia('(prefers-color-scheme: dark)').matches);
  return dark;
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
  data.chapters.forEach(chapter => chapter.bumps.forEach(b => c.fillRect(Math.round(b.frame / Math.max(1, data.frames - 1) * 998), 0, 2, 1)));
  return 'url(' + canvas.toDataURL() + ')';
}

async function begin() {
  try {
    const data = decode(await unpack(el('data').textContent));
    el('title').textContent = data.title;
    el('subtitle').textContent = data.subtitle;
    if (!data.chapters.length) throw new Error('The recording has no world.');
    const player = new Player(data, new View(el('canvas'), data));
    for (const id of ['back', 'next', 'begin', 'end']) el(id).innerHTML = ICONS[id];
    SPEEDS.forEach((s, k) => el('speed').add(new Option(s + ' / s', k)));
    el('time').max = data.frames - 1;
    el('time').style.setProperty('--marks', marks(data));
    el('bar').classList.toggle('still', data.frames < 2);
    document.querySelectorAll('[data-camera=eye],[data-camera=follow]').forEach(b => { b.disabled = player.robot < 0; });
    const dark = listen(player);
    fromAddress(player, dark);
    addEventListener('hashchange', () => { fromAddress(player, dark); player.settled = null; player.dirty = true; });
    const tick = now => { player.tick(now); requestAnimationFrame(tick); };
    requestAnimationFrame(tick);
    window.robosim = player;
    player.draw();
    document.documentElement.dataset.state = 'ready';
  } catch (failure) {
    el('problem').textContent = 'This page cannot be shown: ' + failure.message;
    el('problem').hidden = false;
    document.documentElement.dataset.state = 'failed';
  }
}

if (typeof document !== 'undefined') begin();
