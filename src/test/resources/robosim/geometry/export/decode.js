// Runs the program of a page without a browser: node decode.js PAGE. Prints what it decodes as JSON.
const fs = require('fs');
const page = fs.readFileSync(process.argv[2], 'utf8');
const source = page.match(/<script>\n([^]*?)<\/script>/)[1];
const text = page.match(/<script id="data"[^>]*>([^<]*)</)[1];
const { decode, unpack, poseAt, toWorld, story, pieces, turned } = new Function(source
  + '\nreturn { decode, unpack, poseAt, toWorld, story, pieces, turned };')();
unpack(text).then(bytes => {
  const data = decode(bytes), lines = [];
  data.chapters.forEach((chapter, c) => {
    const end = c + 1 < data.chapters.length ? data.chapters[c + 1].begin : data.frames;
    chapter.tracks.forEach((track, mover) => {
      for (let frame = chapter.begin; frame < end; frame += Math.max(1, Math.floor((end - chapter.begin) / 50))) {
        const pose = poseAt(track, frame, [0, 0, 0, 0, 0, 0, 0]);
        lines.push(['pose', c, mover, frame, ...toWorld(data, pose.slice(0, 3)), ...turned(pose, 3, [1, 0, 0]), ...turned(pose, 3, [0, 1, 0])].join(' '));
      }
    });
    chapter.scans.forEach((scans, mover) => scans.frames.forEach((frame, k) => {
      const n = data.sensors[scans.kinds[k]].length;
      lines.push(['scan', c, mover, frame, ...Array.from(scans.distances.subarray(scans.starts[k], scans.starts[k] + n), d => d * data.unit)].join(' '));
    }));
  });
  data.objects.forEach(o => lines.push(['object', pieces(o).length, o.name].join(' ')));
  for (let frame = 0; frame < Math.min(data.frames, 200); frame++) lines.push('story ' + frame + ' ' + story(data, frame));
  process.stdout.write(lines.join('\n') + '\n');
});
