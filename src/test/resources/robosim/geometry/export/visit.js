// After a page's own program: uses the page as a person would, and writes down what is seen.
const seen = [];
const say = (name, value) => seen.push(name + ' ' + value);

/** The picture that is shown: how many colours it has, and its pixels. */
function look(player) {
  player.settled = null;
  player.draw();
  const gl = player.view.gl, { width, height } = player.view.canvas, pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  if (gl.getError()) wrong.push('WebGL error');
  const colors = new Set();
  for (let k = 0; k < pixels.length; k += 4) colors.add(pixels[k] << 16 | pixels[k + 1] << 8 | pixels[k + 2]);
  return { pixels, colors: colors.size };
}

function differing(a, b) {
  let count = 0;
  for (let k = 0; k < a.length; k += 4) if (Math.abs(a[k] - b[k]) + Math.abs(a[k + 1] - b[k + 1]) + Math.abs(a[k + 2] - b[k + 2]) > 12) count++;
  return count / (a.length / 4);
}

const key = (name, more) => dispatchEvent(new KeyboardEvent('keydown', { key: name, cancelable: true, ...more }));

function visit() {
  const player = window.robosim, place = () => player.view.poses[0].slice(0, 3).map(v => v.toFixed(6)).join(' ');
  player.seek(1);
  const first = look(player);
  say('colors', first.colors);
  say('same', differing(first.pixels, look(player).pixels));
  const before = place();
  key('ArrowRight'); key('ArrowRight');
  const later = look(player);
  say('step', player.step);
  say('moved', before !== place());
  say('changed', differing(first.pixels, later.pixels));
  for (const [name, camera] of [['2', 'top'], ['3', 'eye'], ['4', 'follow'], ['1', 'orbit']]) {
    key(name);
    const there = look(player);
    say(camera, there.colors + ' ' + player.camera.kind + ' ' + differing(later.pixels, there.pixels).toFixed(4));
  }
  key('2');
  for (const name of ['s', 't', 'd']) {
    const with_ = look(player).pixels;
    key(name);
    say('without ' + name, differing(with_, look(player).pixels));
    key(name);
  }
  key('x');
  say('refused', player.step + ' ' + document.getElementById('story').textContent);
  look(player);
  say('told', document.getElementById('story').textContent);
  say('red', player.view.red.length);
  // From above the middle of the picture shows the middle of the world.
  const { clientWidth, clientHeight } = player.view.canvas, robot = project(player.matrix, player.view.poses[1]);
  player.pickAt((robot[0] + 1) / 2 * clientWidth, (1 - robot[1]) / 2 * clientHeight);
  look(player);
  say('picked', document.querySelector('#info b').textContent);
  key('Home'); key(' ');
  say('playing', player.playing);
  player.last = performance.now() - 100;
  player.tick(performance.now());
  say('played', player.at > 0);
  key('?');
  say('help', !document.getElementById('help').hidden);
  document.getElementById('next').click();
  say('paused', !player.playing);
  say('frames', player.data.frames);
}

const waiting = setInterval(() => {
  const state = document.documentElement.dataset.state;
  if (!state) return;
  clearInterval(waiting);
  try {
    if (state === 'ready') visit(); else wrong.push(document.getElementById('problem').textContent);
  } catch (failure) { wrong.push(failure.stack); }
  const result = document.createElement('pre');
  result.id = 'result';
  result.textContent = seen.map(s => s + '\n').join('') + wrong.map(w => 'WRONG ' + w + '\n').join('');
  document.body.append(result);
}, 20);
