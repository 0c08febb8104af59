// Follows what happens after the page was loaded, and sends the server the commands that it permits.

/** The frames that are kept; older ones are dropped, so that a page may stay open for days. */
const KEPT = 20000;
const PACES = [0, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** Makes decoded data able to grow. */
function growing(data) {
  data.begin = 0;
  data.known = new Map();
  for (const c of data.chapters) {
    c.tracks.forEach(t => { t.frames = Array.from(t.frames); t.poses = Array.from(t.poses); });
    c.scans.forEach(s => { for (const k of ['frames', 'kinds', 'starts', 'distances']) s[k] = Array.from(s[k]); });
  }
  return data;
}

/** The number of an arrangement of sensors, which may be new. */
function arrangement(data, sensors) {
  const key = JSON.stringify(sensors);
  if (!data.known.has(key)) {
    data.known.set(key, data.sensors.length);
    data.sensors.push(sensors.map(([bearing, width, range, x, y, z]) =>
      ({ bearing, width, range: range === null ? Infinity : range / data.unit, at: [x / data.unit, y / data.unit, z / data.unit] })));
  }
  return data.known.get(key);
}

/** Adds all that is known about a frame, in place of what was known about it. */
function grow(data, event) {
  const chapter = data.chapters[data.chapters.length - 1], frame = event.frame - data.first;
  if (frame < chapter.begin) return;
  data.frames = Math.max(data.frames, frame + 1);
  for (const [mover, x, y, z, ...spin] of event.placed) {
    const t = chapter.tracks[mover], last = t.frames.length - 1, pose = [...[x, y, z].map((v, k) => (v - data.origin[k]) / data.unit), ...spin];
    if (t.frames[last] === frame) pose.forEach((v, k) => { t.poses[7 * last + k] = v; });
    else { t.frames.push(frame); t.poses.push(...pose); }
  }
  for (const [mover, sensors, distances] of event.heard) {
    const s = chapter.scans[mover], last = s.frames.length - 1;
    if (s.frames[last] === frame) { s.distances.length = s.starts[last]; s.frames.pop(); s.kinds.pop(); s.starts.pop(); }
    s.frames.push(frame);
    s.kinds.push(arrangement(data, sensors));
    s.starts.push(s.distances.length);
    for (const d of distances) s.distances.push(d === null ? Infinity : d / data.unit);
  }
  chapter.bumps = chapter.bumps.filter(b => b.frame !== frame);
  for (const [mover, heading, obstacle] of event.refused) chapter.bumps.push({ frame, mover, heading, obstacle });
  data.remarks = data.remarks.filter(r => r.frame !== frame);
  for (const text of event.words) if (text) data.remarks.push({ frame, text });
  trim(data, chapter);
}

/** Drops what is older than what is kept, a quarter of it at a time. */
function trim(data, chapter) {
  const cut = data.frames - KEPT;
  if (cut < data.begin + KEPT / 4) return;
  data.begin = cut;
  chapter.tracks.forEach(t => {
    const k = Math.max(0, lastUpTo(t.frames, cut));
    t.frames.splice(0, k);
    t.poses.splice(0, 7 * k);
  });
  chapter.scans.forEach(s => {
    const k = Math.max(0, lastUpTo(s.frames, cut)), from = s.starts[k] || 0;
    s.frames.splice(0, k);
    s.kinds.splice(0, k);
    s.starts = s.starts.slice(k).map(at => at - from);
    s.distances.splice(0, from);
  });
  chapter.bumps = chapter.bumps.filter(b => b.frame >= cut);
  data.remarks = data.remarks.filter(r => r.frame >= cut);
}

class Live {
  constructor(settings) {
    Object.assign(this, { commands: settings.commands, player: null, number: -1, waiting: [], loading: false, grip: null, wanted: null, asking: false, marked: 0 });
  }

  begin() {
    const source = new EventSource('events');
    source.addEventListener('anew', () => this.load());
    source.addEventListener('frame', e => this.receive(+e.lastEventId, JSON.parse(e.data)));
    source.addEventListener('state', e => this.state(JSON.parse(e.data)));
    source.onerror = () => this.tell('no connection; trying again');
    source.onopen = () => this.tell(this.player ? '' : 'waiting for a session');
    el('title').textContent = document.title;
    this.panel();
  }

  /** Asks for the present world with its past, once more if there is another one by then. */
  async load() {
    if (this.loading) { this.again = true; return; }
    this.loading = true;
    try {
      const answer = await fetch('data');
      if (answer.ok) {
        const data = growing(decode(await inflated(new Uint8Array(await answer.arrayBuffer()))));
        this.number = +answer.headers.get('X-Number');
        this.tell('');
        if (this.player) this.change(data); else this.start(data);
      }
    } catch (failure) { fail(failure); }
    this.loading = false;
    const waiting = this.waiting;
    this.waiting = [];
    waiting.forEach(([number, event]) => this.receive(number, event));
    if (this.again) { this.again = false; this.load(); }
  }

  start(data) {
    this.player = show(data);
    this.player.live = this;
    this.player.playing = true;
    el('bar').classList.remove('still');
    el('speed').hidden = true;
  }

  /** Another world: the cameras stay where they are if it is as large as the one before. */
  change(data) {
    const p = this.player, before = p.data, name = p.robot < 0 ? '' : before.objects[p.movers()[p.robot]].name;
    const isLike = data.unit === before.unit && [0, 1, 2].every(k => data.space[k] === before.space[k] && data.origin[k] === before.origin[k]);
    p.data = data;
    p.view.load(data);
    if (!isLike) p.cameras.forEach(c => c.fit());
    p.view.rulers = [];
    p.picked = undefined;
    p.robot = data.chapters[0].movers.findIndex(id => data.objects[id].name === name);
    if (p.robot < 0 && data.chapters[0].movers.length) p.robot = 0;
    document.querySelectorAll('[data-camera=eye],[data-camera=follow]').forEach(b => { b.disabled = p.robot < 0; });
    p.at = clamp(p.at, 0, data.frames - 1);
    p.dirty = true;
  }

  /** A frame from the server. */
  receive(number, event) {
    if (this.loading || !this.player) { this.waiting.push([number, event]); return; }
    if (number <= this.number) return;
    this.number = number;
    const p = this.player;
    grow(p.data, event);
    for (const [, , distances] of event.heard)
      for (const d of distances) if (d !== null) p.view.farthest = Math.max(p.view.farthest, d / p.data.unit);
    p.at = Math.max(p.at, p.first);
    if (event.refused.length && performance.now() - this.marked > 1000) {
      this.marked = performance.now();
      el('time').style.setProperty('--marks', marks(p.data));
    }
    p.dirty = true;
  }

  tell(words) {
    el('said').textContent = words;
    el('said').hidden = !words;
  }

  state({ problem, control }) {
    if (problem) this.tell(problem); else if (this.player && el('said').textContent !== this.answer) this.tell('');
    if (!control) return;
    el('pause').setAttribute('aria-pressed', !!control.paused);
    el('pause').dataset.do = control.paused ? 'run' : 'pause';
    if (control.pace !== undefined && document.activeElement !== el('pace')) el('pace').value = control.pace;
  }

  /** The buttons of what is permitted. */
  panel() {
    const may = name => this.commands.includes(name);
    el('panel').hidden = !this.commands.length;
    document.querySelectorAll('[data-do]').forEach(b => {
      b.hidden = !may(b.dataset.do);
      b.addEventListener('click', () => this.ask({ do: b.dataset.do }));
    });
    el('pace').hidden = !may('pace');
    PACES.forEach(p => el('pace').add(new Option(p ? p + ' / s' : 'any pace', p)));
    el('pace').addEventListener('change', () => this.ask({ do: 'pace', value: +el('pace').value }));
    document.querySelectorAll('.driven').forEach(row => { row.hidden = !may('drag'); });
    addEventListener('keydown', e => {
      const degrees = { q: 15, e: -15 }[e.key], p = this.player;
      if (degrees && may('turn') && p && p.robot >= 0 && !e.ctrlKey && !e.metaKey && !e.altKey)
        this.ask({ do: 'turn', name: p.data.objects[p.movers()[p.robot]].name, degrees });
    });
  }

  async ask(command) {
    try {
      const answer = await fetch('control', { method: 'POST', body: JSON.stringify(command) });
      const text = await answer.text(), said = answer.ok ? JSON.parse(text) : { said: text, state: null };
      this.answer = said.said;
      this.tell(said.said);
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.tell(''), 6000);
      if (said.state) this.state({ problem: '', control: said.state });
    } catch (failure) { this.tell('not asked: ' + failure.message); }
  }

  /** Takes the robot at a place of the canvas, if it may be dragged. */
  take(x, y) {
    const p = this.player, k = this.commands.includes('drag') ? p.objectAt(x, y) : -1;
    if (k < 0 || k >= p.movers().length) return;
    const pose = p.view.poses[k], at = p.levelAt(x, y, pose[1]);
    if (!at) return;
    p.robot = k;
    p.picked = undefined;
    this.grip = { name: p.data.objects[p.movers()[k]].name, height: pose[1], off: sub(pose.slice(0, 3), at) };
  }

  /** Where the robot is to go; while an answer is awaited only the last place is remembered. */
  drag(x, y, lift) {
    const p = this.player, at = p.levelAt(x, y, this.grip.height);
    if (!at) return;
    p.playing = true;
    const to = toWorld(p.data, add(at, this.grip.off));
    this.wanted = { do: 'drag', name: this.grip.name, x: to[0], z: to[2], lift };
    this.pull();
  }

  async pull() {
    if (this.asking) return;
    this.asking = true;
    while (this.wanted) {
      const command = this.wanted;
      this.wanted = null;
      await this.ask(command);
    }
    this.asking = false;
  }

  release() { this.grip = null; }
}
