package robosim.geometry.narrow.planar;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The exact projection of a box or a triangle, for cases that a filter leaves in doubt; slow. An octagon takes its
 * corners as {@link PlanarShape} rounds them: it is an enclosure and never decides alone.
 *
 * <p>All decisions use separating axes. The difference of two convex sets is bounded by the side normals of both; the
 * world's axes are added for degenerate shapes.
 */
public final class ExactPlanar {
    private final Dyadic[] x;
    private final Dyadic[] z;
    private final Dyadic[] sideX;
    private final Dyadic[] sideZ;

    private ExactPlanar(int corners, int sides) {
        x = new Dyadic[corners];
        z = new Dyadic[corners];
        sideX = new Dyadic[sides + 2];
        sideZ = new Dyadic[sides + 2];
        sideX[sides] = Dyadic.ONE;
        sideZ[sides] = Dyadic.ZERO;
        sideX[sides + 1] = Dyadic.ZERO;
        sideZ[sides + 1] = Dyadic.ONE;
    }

    public static ExactPlanar of(LeafKind kind, double[] row, int at) {
        return switch (kind.polytope()) {
            case BOX -> box(row, at);
            case TRIANGLE -> triangle(row, at);
        };
    }

    private static ExactPlanar triangle(double[] row, int at) {
        ExactPlanar shape = new ExactPlanar(3, 3);
        for (int k = 0; k < 3; k++) {
            shape.x[k] = Dyadic.of(row[at + 3 * k]);
            shape.z[k] = Dyadic.of(row[at + 3 * k + 2]);
        }
        for (int k = 0; k < 3; k++) {
            shape.sideX[k] = shape.x[(k + 1) % 3].subtract(shape.x[k]);
            shape.sideZ[k] = shape.z[(k + 1) % 3].subtract(shape.z[k]);
        }
        return shape;
    }

    // All eight sums of the half axes, on the hull or not: inner points do no harm.
    private static ExactPlanar box(double[] row, int at) {
        ExactPlanar shape = new ExactPlanar(8, 3);
        Dyadic cx = Dyadic.of(row[at]);
        Dyadic cz = Dyadic.of(row[at + 2]);
        for (int k = 0; k < 8; k++) {
            shape.x[k] = cx;
            shape.z[k] = cz;
        }
        for (int axis = 0; axis < 3; axis++) {
            Dyadic gx = Dyadic.product(row[at + Leaf.SIZE + axis], row[at + Leaf.ROTATION + axis]);
            Dyadic gz = Dyadic.product(row[at + Leaf.SIZE + axis], row[at + Leaf.ROTATION + 6 + axis]);
            shape.sideX[axis] = gx;
            shape.sideZ[axis] = gz;
            for (int k = 0; k < 8; k++) {
                boolean plus = (k >> axis & 1) != 0;
                shape.x[k] = plus ? shape.x[k].add(gx) : shape.x[k].subtract(gx);
                shape.z[k] = plus ? shape.z[k].add(gz) : shape.z[k].subtract(gz);
            }
        }
        return shape;
    }

    public boolean touches(ExactPlanar other) {
        return !isApartAlong(other, sideX, sideZ) && !isApartAlong(other, other.sideX, other.sideZ);
    }

    private boolean isApartAlong(ExactPlanar other, Dyadic[] ex, Dyadic[] ez) {
        for (int k = 0; k < ex.length; k++) {
            if (least(ex[k], ez[k]).compareTo(other.most(ex[k], ez[k])) > 0
                    || other.least(ex[k], ez[k]).compareTo(most(ex[k], ez[k])) > 0) {
                return true;
            }
        }
        return false;
    }

    boolean touchesDisc(double px, double pz, double radius) {
        Dyadic cx = Dyadic.of(px);
        Dyadic cz = Dyadic.of(pz);
        if (contains(cx, cz)) {
            return true;
        }
        // Every side is among the segments that join two corners, and no such segment leaves the polygon.
        Dyadic square = Dyadic.of(radius).square();
        for (int k = 0; k < x.length; k++) {
            for (int m = k + 1; m < x.length; m++) {
                if (isNear(k, m, cx, cz, square)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isNear(int k, int m, Dyadic cx, Dyadic cz, Dyadic square) {
        Dyadic ex = x[m].subtract(x[k]);
        Dyadic ez = z[m].subtract(z[k]);
        Dyadic wx = cx.subtract(x[k]);
        Dyadic wz = cz.subtract(z[k]);
        Dyadic along = dot(ex, ez, wx, wz);
        Dyadic length = dot(ex, ez, ex, ez);
        if (along.signum() <= 0) {
            return dot(wx, wz, wx, wz).compareTo(square) <= 0;
        }
        if (along.compareTo(length) >= 0) {
            return dot(wx.subtract(ex), wz.subtract(ez), wx.subtract(ex), wz.subtract(ez))
                            .compareTo(square)
                    <= 0;
        }
        return cross(ex, ez, wx, wz).square().compareTo(square.multiply(length)) <= 0;
    }

    public boolean contains(double px, double pz) {
        return contains(Dyadic.of(px), Dyadic.of(pz));
    }

    private boolean contains(Dyadic px, Dyadic pz) {
        for (int k = 0; k < sideX.length; k++) {
            Dyadic here = cross(sideX[k], sideZ[k], px, pz);
            if (here.compareTo(least(sideX[k], sideZ[k])) < 0 || here.compareTo(most(sideX[k], sideZ[k])) > 0) {
                return false;
            }
        }
        return true;
    }

    /** Whether the ray from (ox, oz) along (ux, uz) hits it. */
    public boolean isHitBy(double ox, double oz, double ux, double uz) {
        Dyadic px = Dyadic.of(ox);
        Dyadic pz = Dyadic.of(oz);
        Dyadic dx = Dyadic.of(ux);
        Dyadic dz = Dyadic.of(uz);
        Dyadic line = cross(dx, dz, px, pz);
        if (least(dx, dz).compareTo(line) > 0 || most(dx, dz).compareTo(line) < 0) {
            return false;
        }
        // Entirely behind the start: the same test along the ray's direction turned by a quarter.
        if (most(dz, dx.negate()).compareTo(cross(dz, dx.negate(), px, pz)) < 0) {
            return false;
        }
        for (int k = 0; k < sideX.length; k++) {
            Dyadic here = cross(sideX[k], sideZ[k], px, pz);
            int way = cross(sideX[k], sideZ[k], dx, dz).signum();
            if ((way <= 0 && here.compareTo(least(sideX[k], sideZ[k])) < 0)
                    || (way >= 0 && here.compareTo(most(sideX[k], sideZ[k])) > 0)) {
                return false;
            }
        }
        return true;
    }

    private Dyadic least(Dyadic ex, Dyadic ez) {
        Dyadic least = cross(ex, ez, x[0], z[0]);
        for (int k = 1; k < x.length; k++) {
            least = least.min(cross(ex, ez, x[k], z[k]));
        }
        return least;
    }

    private Dyadic most(Dyadic ex, Dyadic ez) {
        Dyadic most = cross(ex, ez, x[0], z[0]);
        for (int k = 1; k < x.length; k++) {
            most = most.max(cross(ex, ez, x[k], z[k]));
        }
        return most;
    }

    private static Dyadic cross(Dyadic ax, Dyadic az, Dyadic bx, Dyadic bz) {
        return ax.multiply(bz).subtract(az.multiply(bx));
    }

    private static Dyadic dot(Dyadic ax, Dyadic az, Dyadic bx, Dyadic bz) {
        return ax.multiply(bx).add(az.multiply(bz));
    }
}
