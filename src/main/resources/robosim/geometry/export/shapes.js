// The surfaces of the shapes, and the instances of them that a world consists of.

/** Six numbers a vertex: the point in units of the sizes; by how many half segments it is lifted; the normal follows from the shape. */
class Surface {
  constructor() { this.data = []; this.index = []; }
  /** A vertex with its normal, and how far along Y a capsule's segment takes it: -1, 0 or 1. */
  vertex(p, n, lift) { this.data.push(p[0], p[1], p[2], lift, n[0], n[1], n[2]); return this.data.length / 7 - 1; }
  quad(a, b, c, d) { this.index.push(a, b, c, a, c, d); }
}

function boxSurface() {
  const s = new Surface();
  for (let axis = 0; axis < 3; axis++)
    for (const side of [-1, 1]) {
      const n = [0, 0, 0], u = [0, 0, 0], v = [0, 0, 0];
      n[axis] = side; u[(axis + 1) % 3] = side; v[(axis + 2) % 3] = 1;
      const corner = (i, j) => s.vertex([0, 1, 2].map(k => (n[k] + i * u[k] + j * v[k]) / 2), n, 0);
      s.quad(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
    }
  return s;
}

function cylinderSurface(sides) {
  const s = new Surface(), at = k => [Math.cos(2 * Math.PI * k / sides), -Math.sin(2 * Math.PI * k / sides)], all = Array.from({ length: sides }, (_, k) => k);
  const ring = (y, normal) => all.map(k => { const [x, z] = at(k); return s.vertex([x, y, z], normal || [x, 0, z], 0); });
  const low = ring(-0.5), high = ring(0.5), base = ring(-0.5, [0, -1, 0]), top = ring(0.5, [0, 1, 0]);
  for (const k of all) s.quad(low[k], low[(k + 1) % sides], high[(k + 1) % sides], high[k]);
  for (let k = 1; k + 1 < sides; k++) s.index.push(base[0], base[k + 1], base[k], top[0], top[k], top[k + 1]);
  return s;
}

/** A ball that is cut at its equator, so that a capsule's segment can be put between its halves. */
function ballSurface(sides) {
  const s = new Surface(), rings = sides / 2, rows = [];
  for (let r = 0; r <= rings; r++) {
    const polar = Math.PI * r / rings - Math.PI / 2;
    for (const lift of r === rings / 2 ? [-1, 1] : [r < rings / 2 ? -1 : 1]) {
      rows.push(Array.from({ length: sides + 1 }, (_, k) => {
        const a = 2 * Math.PI * k / sides, p = [Math.cos(polar) * Math.cos(a), Math.sin(polar), -Math.cos(polar) * Math.sin(a)];
        return s.vertex(p, p, lift);
      }));
    }
  }
  for (let r = 0; r + 1 < rows.length; r++)
    for (let k = 0; k < sides; k++) s.quad(rows[r][k], rows[r][k + 1], rows[r + 1][k + 1], rows[r + 1][k]);
  return s;
}

/** A flat arrow on top of a robot, towards its forward direction. */
function arrowSurface() {
  const s = new Surface(), p = [[0.75, 0], [-0.35, 0.5], [-0.1, 0], [-0.35, -0.5]].map(q => s.vertex([q[0], 0, q[1]], [0, 1, 0], 0));
  s.index.push(p[0], p[2], p[1], p[0], p[3], p[2]);
  return s;
}

function meshSurface(mesh) {
  const s = new Surface(), p = mesh.points, c = mesh.corners;
  for (let k = 0; k < p.length; k += 3) s.vertex([p[k], p[k + 1], p[k + 2]], [0, 0, 0], 0);
  s.index = c;
  return s;
}


// The pieces of an object, each an instance of a surface: its surface's key, pose in the object, sizes and look;
// half are half the sizes of what its pattern lies on, and inner is its place in that.
function pieces(object) {
  const all = [];
  for (const part of object.parts) {
    const s = part.sizes, add = (key, size, half, place, inner) => all.push({ key, size, half, place: place || part.place, inner: inner || [0, 0, 0], look: part.look });
    if (part.shape === 0) add('box', [s[0], s[1], s[2], 0], [s[0] / 2, s[1] / 2, s[2] / 2]);
    else if (part.shape === 1) add('cylinder', [s[0], s[1], s[0], 0], [s[0], s[1] / 2, s[0]]);
    else if (part.shape < 4) add('ball', [s[0], s[0], s[0], part.shape === 3 ? s[1] / 2 : 0], [s[0], part.shape === 3 ? s[1] / 2 : 0, 0]);
    else if (part.shape === 4) add('mesh' + part.mesh, [1, 1, 1, 0], [0, 0, 0]);
    else {
      for (let k = 0; k < part.cells.length; k += 4) {
        const [row, column, wide, deep] = part.cells.subarray(k, k + 4), cell = s[0];
        const inner = [(column + wide / 2 - part.columns / 2) * cell, 0, (row + deep / 2 - part.rows / 2) * cell];
        add('box', [wide * cell, s[1], deep * cell, 0], [part.columns * cell / 2, s[1] / 2, part.rows * cell / 2], within(part.place, [...inner, 0, 0, 0, 1]), inner);
      }
    }
  }
  return all;
}

/** Half the extents of a piece along its own axes, and the middle of these. */
function extent(data, piece) {
  const s = piece.size;
  if (piece.key === 'box') return { half: [s[0] / 2, s[1] / 2, s[2] / 2], mid: [0, 0, 0] };
  if (piece.key === 'cylinder') return { half: [s[0], s[1] / 2, s[2]], mid: [0, 0, 0] };
  if (piece.key === 'ball') return { half: [s[0], s[1] + s[3], s[2]], mid: [0, 0, 0] };
  const mesh = data.meshes[+piece.key.slice(4)];
  if (!mesh.extent) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    mesh.points.forEach((v, k) => { low[k % 3] = Math.min(low[k % 3], v); high[k % 3] = Math.max(high[k % 3], v); });
    mesh.extent = { half: times(sub(high, low), 0.5), mid: times(add(high, low), 0.5) };
  }
  return mesh.extent;
}

/** The box around an object in its own frame. */
function boundsOf(data, object) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const piece of object.pieces) {
    const e = extent(data, piece), mid = add(piece.place, turned(piece.place, 3, e.mid)), axes = [0, 1, 2].map(k => {
      const v = [0, 0, 0]; v[k] = e.half[k];
      return turned(piece.place, 3, v);
    });
    for (let k = 0; k < 3; k++) {
      const reach = Math.abs(axes[0][k]) + Math.abs(axes[1][k]) + Math.abs(axes[2][k]);
      low[k] = Math.min(low[k], mid[k] - reach);
      high[k] = Math.max(high[k], mid[k] + reach);
    }
  }
  return { low, high };
}

/** The distance along a ray to the box around a piece; infinite where it passes. */
function hitPiece(data, piece, pose, from, towards) {
  const at = within(pose, piece.place), e = extent(data, piece), back = [0, 0, 0, -at[3], -at[4], -at[5], at[6]];
  const o = sub(turned(back, 3, sub(from, at)), e.mid), d = turned(back, 3, towards);
  let near = 0, far = Infinity;
  for (let k = 0; k < 3; k++) {
    const a = (-e.half[k] - o[k]) / d[k], b = (e.half[k] - o[k]) / d[k];
    if (Number.isNaN(a) || Number.isNaN(b)) continue;
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near <= far ? near : Infinity;
}
