// Runs a page of a server without a browser: node browse.js ADDRESS. Each line of the input is a program that may use the page's
// names, and `page`, the player; what it returns, or what its promise brings, is printed as a line of JSON.
const address = process.argv[2];

/** A canvas that draws nothing: every function of WebGL is there and returns a number. */
function blank() {
  const known = { getExtension: () => null, getShaderParameter: () => true, getProgramParameter: (p, name) => name === 'ACTIVE_UNIFORMS' ? 0 : true };
  return new Proxy({}, { get: (_, name) => name in known ? known[name] : /^[A-Z_0-9]+$/.test(name) ? String(name) : () => 1 });
}

const elements = new Map();
function element(id) {
  if (!elements.has(id)) {
    const listeners = {};
    const made = {
      id, textContent: '', children: [], innerHTML: '', dataset: {}, hidden: false, value: '', clientWidth: 800, clientHeight: 600, width: 800, height: 600,
      classList: { toggle() {}, remove() {}, add() {} }, style: { setProperty() {} },
      setAttribute(name, value) { made[name] = String(value); }, addEventListener(name, action) { (listeners[name] = listeners[name] || []).push(action); },
      append(child) { made.children.push(child); child.remove = () => { made.children.splice(made.children.indexOf(child), 1); }; },
      get lastChild() { return made.children[made.children.length - 1]; }, add() {}, click() {}, setPointerCapture() {}, getContext: kind => kind === 'webgl2' ? gl : { fillRect() {} }, toDataURL: () => '', toBlob() {},
      fire(name, event) { (listeners[name] || []).forEach(action => action({ preventDefault() {}, target: made, buttons: 1, pointerId: 1, shiftKey: false, ...event })); },
    };
    elements.set(id, made);
  }
  return elements.get(id);
}
const gl = blank();
const page = {};
const windowListeners = {};
const frames = [];

class EventSource {
  constructor(path) { this.listeners = {}; this.last = null; this.path = path; this.connect(); }
  addEventListener(name, action) { this.listeners[name] = action; }
  async connect() {
    try {
      const answer = await fetch(address + this.path, { headers: this.last === null ? {} : { 'Last-Event-ID': this.last } });
      if (this.onopen) this.onopen();
      let text = '';
      for await (const chunk of answer.body) {
        text += Buffer.from(chunk).toString('utf8');
        for (let end = text.indexOf('\n\n'); end >= 0; end = text.indexOf('\n\n')) {
          const fields = Object.fromEntries(text.slice(0, end).split('\n').map(line => [line.slice(0, line.indexOf(': ')), line.slice(line.indexOf(': ') + 2)]));
          text = text.slice(end + 2);
          if (fields.id) this.last = fields.id;
          if (fields.event && this.listeners[fields.event]) this.listeners[fields.event]({ data: fields.data, lastEventId: this.last });
        }
      }
    } catch (failure) { /* connects again, as a browser does */ }
    if (this.onerror) this.onerror();
    setTimeout(() => this.connect(), 200);
  }
}

async function main() {
  const answer = await fetch(address), html = await answer.text();
  const source = html.match(/<script>\n([^]*?)<\/script>/)[1];
  for (const [, id, text] of html.matchAll(/<script id="(\w+)"[^>]*>([^<]*)</g)) element(id).textContent = text;
  const document = {
    title: html.match(/<title>(.*)<\/title>/)[1], activeElement: null, documentElement: element('html'),
    getElementById: element, createElement: () => element('new ' + elements.size), querySelectorAll: () => [],
  };
  const listen = (name, action) => { (windowListeners[name] = windowListeners[name] || []).push(action); };
  const window = { devicePixelRatio: 1 };
  const names = { document, window, EventSource, addEventListener: listen, location: { hash: '' }, matchMedia: () => ({ matches: false }), Option: class {},
    requestAnimationFrame: action => { frames.push(action); }, fetch: (path, more) => fetch(new URL(path, address), more) };
  const run = new Function(...Object.keys(names), source + '\nreturn program => eval(program);')(...Object.values(names));
  Object.assign(page, { run, window, element, key: (name, more) => (windowListeners.keydown || []).forEach(action =>
    action({ key: name, target: element('body'), preventDefault() {}, ...more })), tick: () => frames.splice(0).forEach(action => action(performance.now())) });
  setInterval(page.tick, 15);
  globalThis.page = page;
  globalThis.until = async condition => {
    for (const end = performance.now() + 30000; !condition();) {
      if (performance.now() > end) throw new Error('never: ' + condition + ' ' + element('problem').textContent);
      await new Promise(done => setTimeout(done, 5));
    }
    return true;
  };
  for await (const line of require('readline').createInterface({ input: process.stdin })) {
    try {
      const said = await run(line);
      console.log(said === undefined ? 'null' : JSON.stringify(said));
    } catch (failure) { console.log(JSON.stringify('WRONG ' + failure.stack)); }
  }
  process.exit(0);
}
main();
