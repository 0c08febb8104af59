package robosim.geometry.proof;

import java.util.List;
import java.util.Set;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.proof.Proof.Flaw;

/**
 * Decides whether proofs about a scene hold, in exact arithmetic and without any code of the engine. It takes every piece of the scene
 * in turn, and accepts a claim only if its witness proves it for each of them.
 *
 * <pre>{@code
 * SphereObject ball = new SphereObject(new Point(3, 0, 0), 1);
 * BoxObject crate = new BoxObject(new Point(0, 0, 0), 2, 2, 2);
 * Attempt attempt = Prover.of(crate).apart(ball);
 * ProofChecker checker = new ProofChecker(Scene.of(crate));
 * checker.check(attempt.proof()).isValid(); // true
 * }</pre>
 */
public final class ProofChecker {
    private final Scene scene;
    private final ScenePieces pieces;
    private final boolean isFlat;

    /**
     * What a check found.
     *
     * @param isValid whether the witness proves the claim
     * @param reason  where it does not; empty if it does
     */
    public record Result(boolean isValid, String reason) {}

    /** A checker of proofs about a scene. */
    public ProofChecker(Scene scene) {
        if (scene == null) {
            throw new IllegalArgumentException("scene must be given (got: null)");
        }
        this.scene = scene;
        pieces = new ScenePieces(scene);
        isFlat = scene.dimension() == Dimension.PLANAR;
    }

    /** Checks a proof. */
    public Result check(Proof proof) {
        if (proof == null) {
            throw new IllegalArgumentException("proof must be given (got: null)");
        }
        try {
            check(proof.claim(), proof.witness());
            return new Result(true, "");
        } catch (Flaw | IndexOutOfBoundsException flaw) {
            return new Result(false, String.valueOf(flaw.getMessage()));
        }
    }

    private void check(Claim claim, Witness w) {
        if (claim instanceof Claim.Apart c) {
            free(
                    c.body(),
                    c.self(),
                    c.other(),
                    Path.along(body(c.body(), c.self()), Vec.ZERO, Num.ZERO),
                    c.touched(),
                    w);
        } else if (claim instanceof Claim.Touching c) {
            touch(c.body(), Claim.ALL, c.other(), Vec.ZERO, w);
        } else if (claim instanceof Claim.Distance c) {
            distance(c, w);
        } else if (claim instanceof Claim.Translation c) {
            translation(c, w);
        } else if (claim instanceof Claim.Blocked c) {
            translation(new Claim.Translation(c.body(), c.self(), c.displacement(), c.free(), c.touched()), w);
            require(c.at() >= c.free() && c.at() <= 1, "what blocks must be from what is free on and at most 1");
            Vec shift = Vec.of(c.displacement()).times(Num.of(c.at()));
            require(c.other() != c.self(), "a body does not block itself");
            touch(c.body(), c.self(), c.other(), shift, w);
        } else if (claim instanceof Claim.Turn c) {
            Vec axis = Vec.of(c.axis());
            require(
                    !axis.isZero() && (!isFlat || axis.level().isZero()),
                    "the axis must not be zero, and vertical in the plane");
            List<Piece> body = body(c.body(), c.self());
            Vec pivot = Vec.of(c.body().center());
            Path turn = new Path(body, Vec.ZERO, axis, pivot, Num.ZERO, finite("tangent", c.tangent()));
            free(c.body(), c.self(), Claim.ALL, turn, c.touched(), w);
        } else if (claim instanceof Claim.Ray c) {
            ray(c, w);
        } else if (claim instanceof Claim.Cone c) {
            cone(c, w);
        }
    }

    private List<Piece> body(GeometryObject body, int self) {
        require(
                self == Claim.ALL || scene.objects().get(self).at(body.pose()).equals(body),
                "the body is not object " + self + " of the scene");
        return Piece.of(body);
    }

    /** Checks that a body is free of an object, or of all objects and within the world. */
    private void free(GeometryObject body, int self, int other, Path path, List<Integer> touched, Witness w) {
        require(
                other == Claim.ALL || (other >= 0 && other < pieces.objects() && other != self),
                "there is no object " + other);
        Separation separation =
                new Separation(pieces, path, ScenePieces.solids(body, 0), Num.ZERO, Set.copyOf(touched), w);
        separation.check(self, other);
        Point size = scene.size();
        if (other == Claim.ALL && size != null) {
            separation.checkBorder(size);
        }
    }

    private void translation(Claim.Translation c, Witness w) {
        Vec way = Vec.of(c.displacement());
        Path path = Path.along(body(c.body(), c.self()), isFlat ? way.level() : way, finite("free", c.free()));
        free(c.body(), c.self(), Claim.ALL, path, c.touched(), w);
    }

    private void distance(Claim.Distance c, Witness w) {
        List<Piece> body = body(c.body(), c.self());
        Num low = finite("low", c.low());
        require(
                c.other() == Claim.ALL || (c.other() >= 0 && c.other() < pieces.objects() && c.other() != c.self()),
                "there is no object " + c.other());
        if (c.low() > 0) {
            Path path = Path.along(body, Vec.ZERO, Num.ZERO);
            new Separation(pieces, path, ScenePieces.solids(c.body(), 0), low, Set.of(), w).check(c.self(), c.other());
        }
        if (c.high() < Double.POSITIVE_INFINITY) {
            Witness.Contact near = contact(w);
            Vec a = Meeting.anchor(body.get(near.mine()), near.anchors().get(0));
            Vec b = Meeting.anchor(
                    theirs(w, c.self(), c.other()), near.anchors().get(1));
            Vec gap = isFlat ? b.minus(a).level() : b.minus(a);
            require(isWithin(gap, finite("high", c.high())), "the two points are farther apart than high");
        }
    }

    private void ray(Claim.Ray c, Witness w) {
        Vec start = isFlat ? Vec.of(c.start()).level() : Vec.of(c.start());
        Vec way = isFlat ? Vec.of(c.direction()).level() : Vec.of(c.direction());
        require(!way.isZero(), "the direction must not be zero");
        if (c.low() > 0) {
            Num reach = finite("reach", w.reach());
            Num low = finite("low", c.low());
            require(way.dot(way).times(reach.square()).compareTo(low.square()) >= 0, "the reach is shorter than low");
            path(Path.along(List.of(Piece.point(c.start())), way, reach), c.self(), w);
        }
        if (c.high() < Double.POSITIVE_INFINITY) {
            Piece hit = flat(theirs(w, c.self(), c.other()));
            Witness.Contact contact = contact(w);
            if (contact.form() == Witness.Form.INSIDE) {
                inside(Vec.of(c.start()), contact);
                return;
            }
            Num to = Num.of(contact.point().x());
            require(to.sign() >= 0 && isWithin(way.times(to), finite("high", c.high())), "the hit is beyond high");
            require(
                    hit.meets(start, start.plus(way.times(to)), Num.ZERO),
                    "the ray does not hit piece " + contact.theirs());
        }
    }

    private void cone(Claim.Cone c, Witness w) {
        Num cosine = finite("cosine", c.cosine());
        require(cosine.sign() > 0 && cosine.compareTo(Num.ONE) <= 0, "the cosine must be above 0 and at most 1");
        Vec way = isFlat ? Vec.of(c.direction()).level() : Vec.of(c.direction());
        require(!way.isZero(), "the axis must not be zero");
        if (c.low() > 0) {
            Path path =
                    new Path(List.of(Piece.point(c.start())), way, Vec.ZERO, Vec.ZERO, cosine, finite("low", c.low()));
            path(path, c.self(), w);
        }
        if (c.high() < Double.POSITIVE_INFINITY) {
            Piece piece = theirs(w, c.self(), c.other());
            if (contact(w).form() == Witness.Form.INSIDE) {
                inside(Vec.of(c.start()), contact(w));
                return;
            }
            Vec to = Meeting.anchor(piece, contact(w).anchors().get(0)).minus(Vec.of(c.start()));
            to = isFlat ? to.level() : to;
            Num along = to.dot(way);
            require(isWithin(to, finite("high", c.high())), "the point is beyond high");
            require(
                    along.sign() >= 0
                            && along.square()
                                            .compareTo(cosine.square()
                                                    .times(to.dot(to))
                                                    .times(way.dot(way)))
                                    >= 0,
                    "the point is beside the cone");
        }
    }

    private void path(Path path, int self, Witness w) {
        new Separation(pieces, path, List.of(), Num.ZERO, Set.of(), w).check(self, Claim.ALL);
    }

    /** Checks that a piece of the body, moved, and one of an object have a point in common, or that the body is beyond the border. */
    private void touch(GeometryObject moved, int self, int other, Vec shift, Witness w) {
        List<Piece> body = body(moved, self);
        if (other == Claim.BORDER) {
            require(leaves(body, shift), "the body does not leave the world");
            return;
        }
        Witness.Contact c = contact(w);
        Piece given = theirs(w, Claim.ALL, other);
        if (c.form() == Witness.Form.INSIDE) {
            inside(body.get(c.mine()).c.plus(shift), c);
            return;
        }
        if (c.form() == Witness.Form.CONTAINS) {
            List<Piece> solid = ScenePieces.solidOf(c.mine(), ScenePieces.solids(moved, 0), body);
            inside(given.c.minus(shift), c, solid);
            return;
        }
        Piece a = flat(body.get(c.mine()));
        Piece b = flat(given);
        boolean isMet = Meeting.holds(a, b, c, isFlat ? shift.level() : shift, isFlat);
        require(isMet, "pieces " + c.mine() + " and " + c.theirs() + " have no point in common by this witness");
    }

    private void inside(Vec start, Witness.Contact c) {
        inside(start, c, pieces.solidOf(c.theirs()));
    }

    private void inside(Vec start, Witness.Contact c, List<Piece> solid) {
        require(!isFlat, "in the plane a mesh has no inside");
        int crossings = ScenePieces.crossings(start, Vec.of(c.point()), solid);
        require(crossings % 2 == 1, "the point is not inside the solid mesh");
    }

    private boolean leaves(List<Piece> body, Vec shift) {
        Point size = scene.size();
        for (int k = 0; size != null && k < 6; k++) {
            int to = k % 2 == 0 ? 1 : -1;
            Vec n = Vec.of(k / 2 == 0 ? to : 0, k / 2 == 1 ? to : 0, k / 2 == 2 ? to : 0);
            for (Piece piece : isFlat && k / 2 == 1 ? List.<Piece>of() : body) {
                // A disc that is not tipped that way counts with its radius, another one with its middle.
                Num round = piece.disc.sign() > 0 && n.dot(piece.r[1]).sign() == 0 ? piece.disc : piece.ball;
                for (Vec corner : piece.corners()) {
                    if (n.dot(corner.plus(shift)).plus(round).compareTo(ScenePieces.half(size, n)) > 0) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private static boolean isWithin(Vec v, Num length) {
        return v.dot(v).compareTo(length.square()) <= 0;
    }

    private Piece flat(Piece piece) {
        Piece flat = isFlat ? piece.flat() : piece;
        if (flat == null) {
            throw new Flaw("the outline of a tipped piece is not exact");
        }
        return flat;
    }

    private static Witness.Contact contact(Witness witness) {
        Witness.Contact contact = witness.contact();
        if (contact == null) {
            throw new Flaw("there is no contact");
        }
        return contact;
    }

    /** The piece of the scene that the contact names, of an object or of any but the body. */
    private Piece theirs(Witness w, int self, int other) {
        int piece = contact(w).theirs();
        int object = pieces.objectOf(piece);
        require((other == Claim.ALL || object == other) && object != self, "the contact is not on object " + other);
        return pieces.piece(piece);
    }

    private static Num finite(String name, double v) {
        require(v >= 0 && v < Double.POSITIVE_INFINITY, name + " must be finite and at least 0");
        return Num.of(v);
    }

    private static void require(boolean holds, String otherwise) {
        Flaw.unless(holds, otherwise);
    }
}
