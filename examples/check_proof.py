"""Checks proofs of the module's answers with exact fractions; docs/proofs.md describes their form.

    python3 examples/check_proof.py FILE...     each a document {"scene": ..., "proof": ...}, one a line
    python3 examples/check_proof.py --scene SCENE PROOF...

It prints "valid", or where a proof fails, for each, and ends with 1 if any fails. It shares no code with the module: it is written
from the document alone.
"""

import json
import sys
from fractions import Fraction as F
from math import isqrt

AXES = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]


class Flaw(Exception):
    """Where a proof fails."""


def need(holds, reason):
    if not holds:
        raise Flaw(reason)


def vec(numbers):
    return tuple(F(v) for v in numbers)


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def mul(a, f):
    return tuple(x * f for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def level(a):
    return (a[0], F(0), a[2])


def root_up(v):
    """The square root, or slightly more."""
    scale = 1 << 400
    over = v.numerator * scale * scale
    root = isqrt(over // v.denominator)
    exact = F(root, scale)
    return exact if exact * exact == v else F(root + 1, scale)


class Piece:
    """A triangle, or a box widened by a disc about its own Y or by a ball."""

    def __init__(self, numbers):
        n = vec(numbers)
        need(len(n) in (9, 17), "a piece has 9 or 17 numbers")
        self.numbers = n
        self.triangle = len(n) == 9
        self.c = n[:3]
        self.r = [n[0:3], n[3:6], n[6:9]] if self.triangle else [(n[3 + k], n[6 + k], n[9 + k]) for k in range(3)]
        self.h = (F(0),) * 3 if self.triangle else n[12:15]
        self.disc, self.ball = (F(0), F(0)) if self.triangle else n[15:17]

    def most(self, n):
        if self.triangle:
            return max(dot(n, v) for v in self.r)
        flat = dot(n, self.c) + sum(h * abs(dot(n, r)) for h, r in zip(self.h, self.r))
        return flat + self.round(n, dot(n, self.r[1]))

    def least(self, n):
        return -self.most(mul(n, -1))

    def round(self, n, along):
        if self.disc > 0:
            a = dot(self.r[1], self.r[1])
            return self.disc * root_up(max(F(0), dot(n, n) * a - along * along) / a)
        return self.ball * root_up(dot(n, n)) if self.ball > 0 else F(0)

    def corners(self):
        if self.triangle:
            return self.r
        points = [self.c]
        for h, r in zip(self.h, self.r):
            if h:
                points = [q for p in points for q in (sub(p, mul(r, h)), add(p, mul(r, h)))]
        return points

    def flat(self):
        """The same as an upright prism about height 0."""
        s = list(self.numbers)
        if self.triangle:
            s[1] = s[4] = s[7] = F(0)
            return Piece(s)
        upright = s[4] == s[10] == s[6] == s[8] == 0 and abs(s[7]) == 1
        sphere = self.ball > 0 and not any(self.h)
        need(upright or sphere, "the outline of a tipped piece is not exact")
        if not upright:
            s[3:12] = vec([1, 0, 0, 0, 1, 0, 0, 0, 1])
        s[1], s[13], s[15], s[16] = F(0), F(1), s[15] + s[16], F(0)
        return Piece(s)

    def meets(self, p, q, wider=F(0)):
        """Whether the segment from p to q has a point in this piece, its disc or ball widened."""
        if self.triangle:
            n = cross(sub(self.r[1], self.r[0]), sub(self.r[2], self.r[0]))
            if not any(n):
                return any(self.meets_edge(p, q, k) for k in range(3))
            bounds = [(n, dot(n, self.r[0])), (mul(n, -1), -dot(n, self.r[0]))]
            for k in range(3):
                out = cross(sub(self.r[(k + 1) % 3], self.r[k]), n)
                bounds.append((out, dot(out, self.r[k])))
            return clip(p, q, bounds) is not None
        r, c, h = self.r, self.c, self.h
        if self.disc > 0:
            return self.tube(p, q, self.disc + wider)
        radius = self.ball if h[0] + h[2] > 0 else self.ball + wider
        if radius > 0:
            ends = (sub(c, mul(r[1], h[1])), add(c, mul(r[1], h[1])))
            return any(near(p, q, (F(0), F(1)), e, None, radius) for e in ends) or (
                h[1] > 0 and self.tube(p, q, radius)
            )
        bounds = []
        for k in range(3):
            n = cross(r[(k + 1) % 3], r[(k + 2) % 3])
            bounds += slab(n, dot(n, c), h[k] * dot(n, r[k]))
        return clip(p, q, bounds) is not None

    def tube(self, p, q, radius):
        a = self.r[1]
        part = clip(p, q, slab(a, dot(a, self.c), self.h[1] * dot(a, a)))
        return part is not None and near(p, q, part, self.c, a, radius)

    def meets_edge(self, p, q, k):
        a, b = self.r[k], self.r[(k + 1) % 3]
        along = sub(b, a)
        part = clip(p, q, [(along, dot(along, b)), (mul(along, -1), -dot(along, a))])
        return part is not None and near(p, q, part, a, along if any(along) else None, F(0))

    def near_face(self, x, radius, face):
        """Whether a ball straight above a face reaches it."""
        if self.triangle:
            n = cross(sub(self.r[1], self.r[0]), sub(self.r[2], self.r[0]))
            inside = all(
                dot(cross(sub(self.r[(k + 1) % 3], self.r[k]), n), sub(x, self.r[k])) <= 0 for k in range(3)
            )
            return any(n) and inside and dot(n, sub(x, self.r[0])) ** 2 <= radius**2 * dot(n, n)
        offset = sub(x, self.c)
        if self.disc > 0 or self.ball > 0:
            a = self.r[1]
            height = abs(dot(a, offset)) - self.h[1] * dot(a, a)
            aside = cross(offset, a)
            return (
                self.disc > 0
                and height >= 0
                and height**2 <= radius**2 * dot(a, a)
                and dot(aside, aside) <= self.disc**2 * dot(a, a)
            )
        normals = [cross(self.r[(k + 1) % 3], self.r[(k + 2) % 3]) for k in range(3)]
        n = normals[face]
        high = dot(n, offset)
        height = abs(high) - self.h[face] * dot(n, self.r[face])
        if height < 0 or height**2 > radius**2 * dot(n, n):
            return False
        foot = sub(offset, mul(n, (height if high >= 0 else -height) / dot(n, n)))
        return all(
            abs(dot(normals[k], foot)) <= self.h[k] * dot(normals[k], self.r[k]) for k in range(3) if k != face
        )


def slab(n, middle, half):
    return [(n, middle + half), (mul(n, -1), half - middle)]


def clip(p, q, bounds):
    """The part of the segment within some half spaces n.x <= b, as parameters; None if there is none."""
    low, high = F(0), F(1)
    way = sub(q, p)
    for n, bound in bounds:
        room, rate = bound - dot(n, p), dot(n, way)
        if rate == 0:
            if room < 0:
                return None
        elif rate > 0:
            high = min(high, room / rate)
        else:
            low = max(low, room / rate)
    return (low, high) if low <= high else None


def near(p, q, part, point, axis, radius):
    """Whether a part of a segment is within a radius of a line, or of a point where the axis is None."""
    u, v = sub(p, point), sub(q, p)
    square = radius**2
    if axis is not None:
        u, v, square = cross(u, axis), cross(v, axis), square * dot(axis, axis)
    a, b, c = dot(v, v), dot(u, v), dot(u, u) - square
    best = [part[0], part[1]]
    if a > 0 and part[0] < -b / a < part[1]:
        best.append(-b / a)
    return any(a * s * s + 2 * b * s + c <= 0 for s in best)


def crossings(start, ray, triangles):
    count = 0
    need(any(ray), "a ray must have a direction")
    for t in triangles:
        n = cross(sub(t.r[1], t.r[0]), sub(t.r[2], t.r[0]))
        sides = [dot(ray, cross(sub(t.r[k], start), sub(t.r[(k + 1) % 3], start))) for k in range(3)]
        if not any(n) or (min(sides) < 0 < max(sides)):
            continue
        need(min(sides) > 0 or max(sides) < 0, "a ray passes an edge of a solid mesh")
        ahead = dot(n, sub(t.r[0], start)) * dot(n, ray)
        need(ahead != 0, "a ray begins on a solid mesh")
        count += ahead > 0
    return count


class Body:
    def __init__(self, value):
        self.pieces = [Piece(p) for p in value["pieces"]]
        self.solids = value["solids"]
        self.center = vec(value["center"])


class Path:
    """Pieces that go along a way, turn about an axis, or (one point) the apex of a cone."""

    def __init__(self, pieces, way=(0, 0, 0), end=F(0), axis=(0, 0, 0), pivot=(0, 0, 0), cosine=F(0)):
        self.pieces, self.way, self.end, self.axis = pieces, vec(way), end, vec(axis)
        self.pivot, self.cosine, self.turns = pivot, cosine, any(axis)

    def top(self, piece, n, low, high):
        if self.cosine > 0:
            return dot(n, piece.c) + self.sector(n)
        rate = dot(n, self.way)
        return piece.most(n) + max(rate * low, rate * high)

    def sector(self, n):
        u, c = self.way, self.cosine
        nu, nn, uu = dot(n, u), dot(n, n), dot(u, u)
        if nu >= 0 and nu * nu >= c * c * nn * uu:
            return self.end * root_up(nn)
        along = nu * c + root_up((nn * uu - nu * nu) * (1 - c * c))
        return self.end * along * root_up(uu) / uu if along > 0 else F(0)

    def turns_below(self, piece, n, low, high, bound, weak, along):
        steady = piece.disc > 0 and not any(cross(piece.r[1], self.axis))
        if piece.disc > 0 and not steady and along:
            down = mul(n, -1) if along > 0 else n
            if not self.stays(piece.r[1], down, -abs(along), low, high, True):
                return False
        round_ = piece.round(n, dot(n, piece.r[1]) if steady else along)
        room = bound - dot(n, self.pivot) - round_
        return all(self.stays(sub(v, self.pivot), n, room, low, high, weak) for v in piece.corners())

    def stays(self, x, n, bound, low, high, weak):
        w = cross(self.axis, x)
        c = dot(n, x) - bound
        a = dot(self.axis, self.axis) * c + 2 * dot(n, cross(self.axis, w))
        b = dot(n, w)
        at = [low, high] + ([-b / a] if a < 0 and low < -b / a < high else [])
        values = [a * s * s + 2 * b * s + c for s in at]
        return max(values) <= 0 if weak else max(values) < 0


class Checker:
    def __init__(self, scene):
        self.flat = scene["dimension"] == "PLANAR"
        self.size = scene["size"] and vec(scene["size"])
        self.objects = [Body(o) for o in scene["objects"]]
        self.pieces, self.owner, self.solids = [], [], []
        for k, o in enumerate(self.objects):
            start = len(self.pieces)
            self.solids.append([(start + a, start + b) for a, b in o.solids])
            self.pieces += o.pieces
            self.owner += [k] * len(o.pieces)
        self.axes = [vec(n) for n in AXES if not (self.flat and n[1])]

    def check(self, proof):
        claim, self.w = proof["claim"], proof["witness"]
        self.margin, self.touched = F(0), set(claim.get("touched", []))
        for name in ("self", "other"):
            need(-2 <= claim.get(name, -1) < len(self.objects), "there is no object " + str(claim.get(name)))
        body = Body(claim["body"]) if "body" in claim else None
        getattr(self, claim["kind"])(claim, body)

    def apart(self, c, body):
        self.free(c["self"], c["other"], Path(body.pieces), body)

    def touching(self, c, body):
        self.touch(body, c["other"], vec((0, 0, 0)))

    def distance(self, c, body):
        if c["low"] > 0:
            self.margin = F(c["low"])
            self.free(c["self"], c["other"], Path(body.pieces), body, border=False)
        if c["high"] is not None:
            k = self.contact()
            a = self.anchor(body.pieces[self.index(k["mine"], body.pieces)], k["anchors"][0])
            b = self.anchor(self.theirs(c["self"], c["other"]), k["anchors"][1])
            gap = level(sub(b, a)) if self.flat else sub(b, a)
            need(c["high"] >= 0 and dot(gap, gap) <= F(c["high"]) ** 2, "the two points are farther apart than high")

    def translation(self, c, body):
        way = vec(c["displacement"])
        need(c["free"] >= 0, "free must be at least 0")
        path = Path(body.pieces, level(way) if self.flat else way, F(c["free"]))
        self.free(c["self"], -1, path, body)

    def blocked(self, c, body):
        self.translation(c, body)
        need(c["free"] <= c["at"] <= 1 and c["other"] != c["self"], "what blocks must come after what is free")
        self.touch(body, c["other"], mul(vec(c["displacement"]), F(c["at"])))

    def turn(self, c, body):
        axis = vec(c["axis"])
        need(any(axis) and not (self.flat and any(level(axis))), "the axis must not be zero, and vertical in the plane")
        need(c["tangent"] >= 0, "the tangent must be at least 0")
        self.free(c["self"], -1, Path(body.pieces, axis=axis, pivot=body.center, end=F(c["tangent"])), body)

    def ray(self, c, body):
        start, way = vec(c["start"]), vec(c["direction"])
        if self.flat:
            start, way = level(start), level(way)
        need(any(way), "the direction must not be zero")
        if c["low"] > 0:
            reach = F(self.w["reach"])
            need(reach >= 0 and dot(way, way) * reach**2 >= F(c["low"]) ** 2, "the reach is shorter than low")
            self.free(c["self"], -1, Path([point(c["start"])], way, reach), None, border=False)
        if c["high"] is not None:
            piece, k = self.theirs(c["self"], c["other"]), self.contact()
            if k["form"] == "INSIDE":
                return self.inside(vec(c["start"]), k)
            to = F(k["point"][0])
            need(to >= 0 and dot(way, way) * to**2 <= F(c["high"]) ** 2, "the hit is beyond high")
            need(self.flatten(piece).meets(start, add(start, mul(way, to))), "the ray does not hit the piece")

    def cone(self, c, body):
        way, cosine = vec(c["direction"]), F(c["cosine"])
        way = level(way) if self.flat else way
        need(any(way) and 0 < cosine <= 1, "the axis must not be zero, and the cosine above 0 and at most 1")
        if c["low"] > 0:
            path = Path([point(c["start"])], way, F(c["low"]), cosine=cosine)
            self.free(c["self"], -1, path, None, border=False)
        if c["high"] is not None:
            piece, k = self.theirs(c["self"], c["other"]), self.contact()
            if k["form"] == "INSIDE":
                return self.inside(vec(c["start"]), k)
            to = sub(self.anchor(piece, k["anchors"][0]), vec(c["start"]))
            to = level(to) if self.flat else to
            need(dot(to, to) <= F(c["high"]) ** 2, "the point is beyond high")
            along = dot(to, way)
            need(along >= 0 and along**2 >= cosine**2 * dot(to, to) * dot(way, way), "the point is beside the cone")

    def free(self, own, other, path, body, border=True):
        need(other == -1 or (0 <= other < len(self.objects) and other != own), "there is no object " + str(other))
        fixed = self.axes + [self.normal(n) for n in self.w["common"]]
        slabs = {}
        for s in self.w["slabs"]:
            slabs.setdefault((s[0], s[1]), []).append(s[2:])
        tops = {}

        def top(i, k):
            if (i, k) not in tops:
                tops[i, k] = path.top(path.pieces[i], fixed[k], F(0), path.end)
            return tops[i, k]

        def less(high, low, n, weak):
            gap = low - high
            if self.margin > 0:
                return gap > 0 and gap * gap >= self.margin**2 * dot(n, n)
            return gap > 0 or (weak and gap == 0)

        def below(i, n, low, high, bound, weak, along):
            if path.turns:
                return path.turns_below(path.pieces[i], n, low, high, bound, weak, along)
            return less(path.top(path.pieces[i], n, low, high), bound, n, weak)

        def is_free(i, j):
            weak = j in self.touched
            for k, n in enumerate(fixed):
                bound = self.pieces[j].least(n)
                if below(i, n, F(0), path.end, bound, weak, F(0)) if path.turns else less(top(i, k), bound, n, weak):
                    return True
            at, any_ = F(0), False
            for low, high, x, y, z, along in slabs.get((i, j), []):
                n = self.normal((x, y, z))
                if low > at or high < at:
                    return False
                if not below(i, n, at, F(high), self.pieces[j].least(n), weak, F(along)):
                    return False
                at, any_ = F(high), True
            return any_ and at >= path.end

        def clear(mine, theirs):
            return not path.turns and any(
                max(path.top(a, n, F(0), path.end) for a in mine) < min(b.least(n) for b in theirs) for n in fixed
            )

        def outside(mine, theirs, is_theirs, piece, solid):
            for m, t, which, ray in self.w["outsides"]:
                if (m, t, which) == (mine, theirs, is_theirs):
                    return crossings(piece.c, vec(ray), solid) % 2 == 0
            return False

        for j, theirs in enumerate(self.pieces):
            if self.owner[j] == own if other == -1 else self.owner[j] != other:
                continue
            for i in range(len(path.pieces)):
                need(is_free(i, j), "piece %d of the body is not proved free of piece %d" % (i, j))
            for a, b in () if self.flat or body is None else body.solids:
                solid = path.pieces[a:b]
                inside = "piece %d may be inside the body's solid mesh" % j
                need(clear(solid, [theirs]) or outside(a, j, False, theirs, solid), inside)
        for k, solids in enumerate(self.solids):
            for a, b in () if self.flat or (k == own if other == -1 else k != other) else solids:
                for i, mine in enumerate(path.pieces):
                    solid = self.pieces[a:b]
                    inside = "piece %d of the body may be inside the solid mesh %d" % (i, a)
                    need(clear([mine], solid) or outside(i, a, True, mine, solid), inside)
        if other == -1 and border and self.size:
            for n in self.axes:
                half = abs(dot(n, self.size)) / 2
                for i in range(len(path.pieces)):
                    need(below(i, n, F(0), path.end, half, True, F(0)), "the body may leave the world")

    def touch(self, body, other, shift):
        if other == -2:
            return need(self.leaves(body, shift), "the body does not leave the world")
        k, given = self.contact(), self.theirs(-1, other)
        i = self.index(k["mine"], body.pieces)
        if k["form"] == "INSIDE":
            return self.inside(add(body.pieces[i].c, shift), k)
        if k["form"] == "CONTAINS":
            solid = [body.pieces[a:b] for a, b in body.solids if a <= i < b]
            need(solid and not self.flat, "the piece is not of a solid mesh")
            return need(crossings(sub(given.c, shift), vec(k["point"]), solid[0]) % 2 == 1, "it is not inside")
        a, b = self.flatten(body.pieces[i]), self.flatten(given)
        by = level(shift) if self.flat else shift
        at = vec(k["point"])
        at = level(at) if self.flat else at
        form, corners = k["form"], k["corners"]

        def segment(piece, move, ends=None):
            v = piece.corners()
            return [add(p, move) for p in ends or (v[self.index(corners[0], v)], v[self.index(corners[1], v)])]

        def wider(piece, to):
            parallel = to.disc > 0 and piece.disc > 0 and not any(cross(piece.r[1], to.r[1]))
            return piece.disc if parallel else piece.ball

        back = mul(by, -1)
        if form == "POINT":
            met = a.meets(sub(at, by), sub(at, by)) and b.meets(at, at)
        elif form == "MINE":
            met = b.meets(*segment(a, by), wider(a, b))
        elif form == "THEIRS":
            met = a.meets(*segment(b, back), wider(b, a))
        elif form == "MY_BALL":
            met = b.near_face(add(a.corners()[self.index(corners[0], a.corners())], by), a.ball, corners[1])
        elif form == "THEIR_BALL":
            met = a.near_face(add(b.corners()[self.index(corners[0], b.corners())], back), b.ball, corners[1])
        elif form == "MY_CHORD":
            met = b.meets(*segment(a, by, [self.anchor(a, x) for x in k["anchors"][:2]]))
        elif form == "THEIR_CHORD":
            met = a.meets(*segment(b, back, [self.anchor(b, x) for x in k["anchors"][:2]]))
        else:
            met = False
        need(met, "the pieces have no point in common by this witness")

    def inside(self, start, k):
        j = k["theirs"]
        solid = [self.pieces[a:b] for s in self.solids for a, b in s if a <= j < b]
        need(solid and not self.flat, "the piece is not of a solid mesh")
        need(crossings(start, vec(k["point"]), solid[0]) % 2 == 1, "the point is not inside the solid mesh")

    def leaves(self, body, shift):
        for n in self.axes if self.size else []:
            half = abs(dot(n, self.size)) / 2
            for piece in body.pieces:
                wide = piece.disc if piece.disc > 0 and dot(n, piece.r[1]) == 0 else piece.ball
                if any(dot(n, add(v, shift)) + wide > half for v in piece.corners()):
                    return True
        return False

    @staticmethod
    def anchor(piece, given):
        at, offset = vec(given[0]), vec(given[1])
        if piece.triangle:
            need(at[0] >= 0 and at[1] >= 0 and at[0] + at[1] <= 1 and not any(offset), "a point is not in its triangle")
            sides = mul(sub(piece.r[1], piece.r[0]), at[0]), mul(sub(piece.r[2], piece.r[0]), at[1])
            return add(add(piece.r[0], sides[0]), sides[1])
        place = add(piece.c, offset)
        for k in range(3):
            need(abs(at[k]) <= 1, "a point is not in its piece")
            place = add(place, mul(piece.r[k], piece.h[k] * at[k]))
        within = piece.meets(place, place) if piece.disc > 0 else dot(offset, offset) <= piece.ball**2
        need(within, "a point is not in its piece")
        return place

    def flatten(self, piece):
        return piece.flat() if self.flat else piece

    def contact(self):
        need(self.w["contact"] is not None, "there is no contact")
        return self.w["contact"]

    def theirs(self, own, other):
        j = self.index(self.contact()["theirs"], self.pieces)
        k = self.owner[j]
        need((other == -1 or k == other) and k != own, "the contact is not on object %d" % other)
        return self.pieces[j]

    @staticmethod
    def index(k, of):
        need(0 <= k < len(of), "there is no number %d" % k)
        return k

    def normal(self, n):
        n = vec(n)
        need(any(n) and not (self.flat and n[1]), "a normal must not be zero, and level in the plane")
        return n


def point(at):
    return Piece(list(at) + [1, 0, 0, 0, 1, 0, 0, 0, 1] + [0] * 5)


def verdict(scene, proof):
    try:
        Checker(scene).check(proof)
        return "valid"
    except Flaw as flaw:
        return "invalid: " + str(flaw)


def main(arguments):
    scene = None
    if arguments[:1] == ["--scene"]:
        with open(arguments[1], encoding="utf-8") as file:
            scene = json.load(file)
        arguments = arguments[2:]
    failed = False
    for name in arguments:
        with open(name, encoding="utf-8") as file:
            for line in file:
                document = json.loads(line)
                found = verdict(scene or document["scene"], document if scene else document["proof"])
                failed |= found != "valid"
                print(found)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
