package robosim.geometry.proof;

import robosim.geometry.proof.Proof.Flaw;

/** Whether a witness shows that two pieces have a point in common. Exact. */
final class Meeting {
    private Meeting() {}

    /**
     * Whether piece a, moved, and piece b touch, by a given witness.
     *
     * @param isFlat whether both are prisms about height 0, so that no point has another height
     */
    static boolean holds(Piece a, Piece b, Witness.Contact c, Vec by, boolean isFlat) {
        Vec back = by.negate();
        Vec given = Vec.of(c.point());
        Vec point = isFlat ? given.level() : given;
        return switch (c.form()) {
            case POINT -> a.meets(point.plus(back), point.plus(back), Num.ZERO) && b.meets(point, point, Num.ZERO);
            case MINE -> b.meets(corner(a, c, 0).plus(by), corner(a, c, 1).plus(by), wider(a, b));
            case THEIRS -> a.meets(corner(b, c, 0).plus(back), corner(b, c, 1).plus(back), wider(b, a));
            case MY_BALL ->
                b.isNearFace(corner(a, c, 0).plus(by), a.ball, c.corners().get(1));
            case THEIR_BALL ->
                a.isNearFace(corner(b, c, 0).plus(back), b.ball, c.corners().get(1));
            case MY_CHORD -> b.meets(end(a, c, 0).plus(by), end(a, c, 1).plus(by), Num.ZERO);
            case THEIR_CHORD -> a.meets(end(b, c, 0).plus(back), end(b, c, 1).plus(back), Num.ZERO);
            case INSIDE, CONTAINS, NEAR -> false;
        };
    }

    private static Vec corner(Piece piece, Witness.Contact contact, int which) {
        return piece.corners().get(contact.corners().get(which));
    }

    private static Vec end(Piece piece, Witness.Contact contact, int which) {
        return anchor(piece, contact.anchors().get(which));
    }

    /** What a piece is wide about its axis, where that counts if the axis meets another piece, widened by it. */
    private static Num wider(Piece piece, Piece other) {
        boolean isParallel = other.disc.sign() > 0
                && piece.disc.sign() > 0
                && piece.r[1].cross(other.r[1]).isZero();
        return isParallel ? piece.disc : piece.ball;
    }

    /** A point of a piece; fails if it is not in it. */
    static Vec anchor(Piece piece, Witness.Anchor anchor) {
        Vec at = Vec.of(anchor.at());
        Vec offset = Vec.of(anchor.offset());
        if (piece.isTriangle) {
            boolean isIn = at.x().sign() >= 0
                    && at.y().sign() >= 0
                    && at.x().plus(at.y()).compareTo(Num.ONE) <= 0;
            Flaw.unless(isIn && offset.isZero(), "a point is not in its triangle");
            Vec first = piece.r[1].minus(piece.r[0]).times(at.x());
            return piece.r[0].plus(first).plus(piece.r[2].minus(piece.r[0]).times(at.y()));
        }
        Vec point = piece.c.plus(offset);
        Num[] shares = {at.x(), at.y(), at.z()};
        boolean isIn = true;
        for (int k = 0; k < 3; k++) {
            isIn &= shares[k].abs().compareTo(Num.ONE) <= 0;
            point = point.plus(piece.r[k].times(piece.h[k].times(shares[k])));
        }
        isIn &= piece.disc.sign() > 0
                ? piece.meets(point, point, Num.ZERO)
                : offset.dot(offset).compareTo(piece.ball.square()) <= 0;
        Flaw.unless(isIn, "a point is not in its piece");
        return point;
    }
}
