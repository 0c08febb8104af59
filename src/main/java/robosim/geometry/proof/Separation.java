package robosim.geometry.proof;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.proof.Proof.Flaw;

/** Whether a plane is proved to keep each piece of a path from each piece of a scene, at every moment of it. */
final class Separation {
    private final ScenePieces scene;
    private final Path path;
    private final List<int[]> solids;

    /** The distance at which every pair is to be apart; 0 where being apart is enough. */
    private final Num margin;

    private final Set<Integer> touched;
    private final Witness witness;
    private final boolean isFlat;
    private final List<Vec> fixed = new ArrayList<>();
    private final Map<Long, List<Witness.Slab>> slabs = new HashMap<>();
    private final Map<Integer, Num> tops = new HashMap<>();

    /**
     * A path in a scene.
     *
     * @param solids where solid meshes begin and end among the pieces that move
     */
    Separation(ScenePieces scene, Path path, List<int[]> solids, Num margin, Set<Integer> touched, Witness witness) {
        this.scene = scene;
        this.path = path;
        this.solids = solids;
        this.margin = margin;
        this.touched = touched;
        this.witness = witness;
        isFlat = scene.dimension == Dimension.PLANAR;
        for (int k = 0; k < 6; k++) {
            int to = k % 2 == 0 ? 1 : -1;
            if (!isFlat || k / 2 != 1) {
                fixed.add(Vec.of(k / 2 == 0 ? to : 0, k / 2 == 1 ? to : 0, k / 2 == 2 ? to : 0));
            }
        }
        for (Point direction : witness.common()) {
            fixed.add(normal(direction));
        }
        for (Witness.Slab slab : witness.slabs()) {
            slabs.computeIfAbsent(key(slab.mine(), slab.theirs()), k -> new ArrayList<>())
                    .add(slab);
        }
    }

    private static long key(int mine, int theirs) {
        return ((long) mine << 32) | (theirs & 0xffffffffL);
    }

    private Vec normal(Point direction) {
        Vec n = Vec.of(direction);
        Flaw.unless(!n.isZero(), "a normal must not be zero");
        Flaw.unless(!isFlat || n.y().sign() == 0, "a normal in the plane must be level");
        return n;
    }

    /** Checks all pieces of an object, or of every object but one. */
    void check(int self, int other) {
        for (int object = 0; object < scene.objects(); object++) {
            if (other == Claim.ALL ? object != self : object == other) {
                checkObject(object);
            }
        }
    }

    private void checkObject(int object) {
        for (int j = scene.begin(object); j < scene.begin(object + 1); j++) {
            for (int i = 0; i < path.body().size(); i++) {
                if (!isFree(i, j, touched.contains(j))) {
                    throw new Flaw("piece " + i + " of the body is not proved free of piece " + j);
                }
            }
            for (int[] solid : isFlat ? List.<int[]>of() : solids) {
                List<Piece> triangles = path.body().subList(solid[0], solid[1]);
                if (!isClear(List.of(scene.piece(j)), triangles) && !isOutside(solid[0], j, false, triangles)) {
                    throw new Flaw("piece " + j + " may be inside the body's solid mesh " + solid[0]);
                }
            }
        }
        for (int[] solid : isFlat ? List.<int[]>of() : scene.solids(object)) {
            List<Piece> triangles = scene.pieces().subList(solid[0], solid[1]);
            for (int i = 0; i < path.body().size(); i++) {
                if (!isClear(triangles, List.of(path.body().get(i))) && !isOutside(i, solid[0], true, triangles)) {
                    throw new Flaw("piece " + i + " of the body may be inside the solid mesh " + solid[0]);
                }
            }
        }
    }

    /** Whether the body stays within the world; touching the border is inside. */
    void checkBorder(Point size) {
        for (Vec n : fixed.subList(0, isFlat ? 4 : 6)) {
            Num half = ScenePieces.half(size, n);
            for (Piece piece : path.body()) {
                Flaw.unless(
                        isBelow(piece, n, Num.ZERO, path.end(), half, true, Num.ZERO), "the body may leave the world");
            }
        }
    }

    /** Whether what moves stays within the world. */
    static boolean isWithin(ScenePieces empty, Path path, Point size) {
        Witness none = new Witness(List.of(), List.of(), null, List.of(), 0);
        try {
            new Separation(empty, path, List.of(), Num.ZERO, Set.of(), none).checkBorder(size);
            return true;
        } catch (Flaw leaves) {
            return false;
        }
    }

    private boolean isFree(int i, int j, boolean isWeak) {
        Piece mine = path.body().get(i);
        Piece theirs = scene.piece(j);
        int first = likely(mine, theirs);
        for (int at = -1; at < fixed.size(); at++) {
            int k = at == -1 ? first : at;
            Vec n = fixed.get(k);
            Num bound = at == -1 ? theirs.leastAlongAxis(n) : theirs.least(n);
            boolean isBelow = path.isTurn()
                    ? path.turnsBelow(mine, n, Num.ZERO, path.end(), bound, isWeak, Num.ZERO)
                    : isLess(tops.computeIfAbsent(i * fixed.size() + k, key -> top(mine, n)), bound, n, isWeak);
            if (isBelow) {
                return true;
            }
        }
        Num from = Num.ZERO;
        boolean isAny = false;
        for (Witness.Slab slab : slabs.getOrDefault(key(i, j), List.of())) {
            Vec n = normal(slab.normal());
            Num to = Num.of(slab.to());
            if (Num.of(slab.from()).compareTo(from) > 0
                    || to.compareTo(from) < 0
                    || !isBelow(mine, n, from, to, theirs.least(n), isWeak, Num.of(slab.along()))) {
                return false;
            }
            from = to;
            isAny = true;
        }
        return isAny && from.compareTo(path.end()) >= 0;
    }

    /** The axis along which two pieces are the farthest from each other, to be tried first: few pairs need another. */
    private int likely(Piece mine, Piece theirs) {
        int axes = isFlat ? 2 : 3;
        int likely = 0;
        double most = 0;
        for (int axis = 0; axis < axes; axis++) {
            int of = isFlat ? 2 * axis : axis;
            double ahead = theirs.stored[of] - mine.stored[of];
            if (Math.abs(ahead) > most) {
                most = Math.abs(ahead);
                likely = 2 * axis + (ahead > 0 ? 0 : 1);
            }
        }
        return likely;
    }

    private Num top(Piece piece, Vec n) {
        return path.top(piece, n, Num.ZERO, path.end());
    }

    private boolean isBelow(Piece piece, Vec n, Num from, Num to, Num bound, boolean isWeak, Num along) {
        return path.isTurn()
                ? path.turnsBelow(piece, n, from, to, bound, isWeak, along)
                : isLess(path.top(piece, n, from, to), bound, n, isWeak);
    }

    private boolean isLess(Num top, Num bound, Vec n, boolean isWeak) {
        Num gap = bound.minus(top);
        return margin.sign() > 0
                ? gap.sign() > 0 && gap.square().compareTo(margin.square().times(n.dot(n))) >= 0
                : gap.sign() > 0 || (isWeak && gap.sign() == 0);
    }

    /** Whether one of the directions for all pairs keeps all of some pieces from all of those that move. */
    private boolean isClear(List<Piece> theirs, List<Piece> mine) {
        for (Vec n : path.isTurn() ? List.<Vec>of() : fixed) {
            boolean isClear = true;
            for (Piece a : mine) {
                Num top = top(a, n);
                for (int k = 0; isClear && k < theirs.size(); k++) {
                    isClear = top.compareTo(theirs.get(k).least(n)) < 0;
                }
            }
            if (isClear) {
                return true;
            }
        }
        return false;
    }

    /** Pieces that never touch a solid mesh stay on one side of it: a point at the start decides. */
    private boolean isOutside(int mine, int theirs, boolean isTheirsSolid, List<Piece> solid) {
        Piece piece = isTheirsSolid ? path.body().get(mine) : scene.piece(theirs);
        for (Witness.Outside w : witness.outsides()) {
            if (w.mine() == mine && w.theirs() == theirs && w.isTheirsSolid() == isTheirsSolid) {
                return ScenePieces.crossings(piece.c, Vec.of(w.direction()), solid) % 2 == 0;
            }
        }
        return false;
    }
}
