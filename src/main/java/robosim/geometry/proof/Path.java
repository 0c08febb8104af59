package robosim.geometry.proof;

import java.util.List;

/**
 * What is to be free: pieces that move with a parameter from 0 to an end. They go along a way times the parameter; or they turn about
 * an axis through a pivot, the parameter being the tangent of half the angle over the axis' length; or the one piece is the apex of a
 * cone about the way, with a cosine above 0, and the end is its length.
 */
record Path(List<Piece> body, Vec way, Vec axis, Vec pivot, Num cosine, Num end) {
    static Path along(List<Piece> body, Vec way, Num end) {
        return new Path(body, way, Vec.ZERO, Vec.ZERO, Num.ZERO, end);
    }

    boolean isTurn() {
        return !axis.isZero();
    }

    /** Of what does not turn, the largest product of a normal with a piece from one parameter to another, or slightly more. */
    Num top(Piece piece, Vec n, Num from, Num to) {
        if (cosine.sign() > 0) {
            return sector(piece.c, n);
        }
        Num rate = n.dot(way);
        return piece.most(n).plus(rate.times(rate.sign() > 0 ? to : from));
    }

    private Num sector(Vec apex, Vec n) {
        Num nn = n.dot(n);
        Num uu = way.dot(way);
        Num nu = n.dot(way);
        Num cc = cosine.square();
        if (nu.sign() >= 0 && nu.square().compareTo(cc.times(nn).times(uu)) >= 0) {
            return n.dot(apex).plus(end.times(nn.rootUp()));
        }
        Num aside = nn.times(uu).minus(nu.square()).times(Num.ONE.minus(cc)).rootUp();
        Num sum = nu.times(cosine).plus(aside);
        return sum.sign() <= 0
                ? n.dot(apex)
                : n.dot(apex).plus(end.times(sum).times(uu.rootUp()).overUp(uu));
    }

    /**
     * Whether the product of a normal with a piece that turns stays below a bound, or at it.
     *
     * @param along a number that the product with the axis of a disc is never nearer to 0 than; 0 if nothing is known
     */
    boolean turnsBelow(Piece piece, Vec n, Num from, Num to, Num bound, boolean isWeak, Num along) {
        boolean isDisc = piece.disc.sign() > 0;
        boolean isSteady = isDisc && piece.r[1].cross(axis).isZero();
        if (isDisc && !isSteady && along.sign() != 0) {
            // Above a positive number means below its opposite along the opposite normal.
            Vec down = along.sign() > 0 ? n.negate() : n;
            if (!staysBelow(piece.r[1], down, along.sign() > 0 ? along.negate() : along, from, to, true)) {
                return false;
            }
        }
        Num round = piece.round(n, isSteady ? n.dot(piece.r[1]) : along);
        Num room = bound.minus(n.dot(pivot)).minus(round);
        for (Vec corner : piece.corners()) {
            if (!staysBelow(corner.minus(pivot), n, room, from, to, isWeak)) {
                return false;
            }
        }
        return true;
    }

    /** Whether n.x stays below a bound while x turns: a quadratic in the parameter. */
    private boolean staysBelow(Vec x, Vec n, Num bound, Num from, Num to, boolean isWeak) {
        Vec w = axis.cross(x);
        Num f = n.dot(x).minus(bound);
        Num a = axis.dot(axis).times(f).plus(n.dot(axis.cross(w)).twice());
        Num b = n.dot(w);
        int most = Math.max(sign(a, b, f, from), sign(a, b, f, to));
        if (a.sign() < 0
                && a.times(from).plus(b).sign() > 0
                && a.times(to).plus(b).sign() < 0) {
            most = Math.max(most, b.square().minus(a.times(f)).sign());
        }
        return isWeak ? most <= 0 : most < 0;
    }

    private static int sign(Num a, Num b, Num f, Num s) {
        return a.times(s.square()).plus(b.times(s).twice()).plus(f).sign();
    }
}
