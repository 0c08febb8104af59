package robosim.geometry.reference;

import java.util.List;

/** Points against slabs, and what is left of the segments between them, or of the ray from the first. */
final class Clip {
    private final int size;

    /** How far inside of each border each point lies; of a direction, how fast it goes inside. */
    private final Quantity[][] inside;

    private final int[][] signs;

    /** The slab that each border is of. */
    private final int[] slabOf;

    // Where segments enter and leave: a share over something above 0, and the slab.
    private final Quantity[] lower = new Quantity[12];
    private final Quantity[] upper = new Quantity[12];
    private final int[] lowerOf = new int[6];
    private final int[] upperOf = new int[6];

    Clip(List<Quantity[]> points, List<Hull.Slab> slabs) {
        this(points, slabs, false);
    }

    private Clip(List<Quantity[]> points, List<Hull.Slab> slabs, boolean lastIsDirection) {
        int borders = 0;
        for (Hull.Slab slab : slabs) {
            borders += slab.high() == null ? 1 : 2;
        }
        size = points.size();
        inside = new Quantity[borders][size];
        signs = new int[borders][size];
        slabOf = new int[borders];
        int border = 0;
        int index = 0;
        for (Hull.Slab slab : slabs) {
            for (int p = 0; p < size; p++) {
                Quantity value = Vectors.dot(slab.normal(), points.get(p));
                boolean direction = lastIsDirection && p == size - 1;
                set(border, p, direction ? value : value.minus(slab.low()));
                if (slab.high() != null) {
                    set(border + 1, p, direction ? value.negate() : slab.high().minus(value));
                }
            }
            for (int last = border + (slab.high() == null ? 1 : 2); border < last; border++) {
                slabOf[border] = index;
            }
            index++;
        }
    }

    private void set(int border, int point, Quantity value) {
        inside[border][point] = value;
        signs[border][point] = value.signum();
    }

    /** Whether all points lie outside of one and the same border. */
    boolean isBeyond() {
        for (int[] border : signs) {
            boolean beyond = true;
            for (int sign : border) {
                beyond &= sign < 0;
            }
            if (beyond) {
                return true;
            }
        }
        return false;
    }

    boolean anyMeets(List<int[]> edges) {
        for (int[] edge : edges) {
            if (segmentMeets(edge[0], edge[1])) {
                return true;
            }
        }
        return false;
    }

    boolean segmentMeets(int p, int q) {
        for (int[] border : signs) {
            if (border[p] < 0 && border[q] < 0) {
                return false;
            }
        }
        int lowers = 0;
        int uppers = 0;
        for (int k = 0; k < signs.length; k++) {
            if (signs[k][p] < 0) {
                enter(lowers++, k, inside[k][p].negate(), inside[k][q].minus(inside[k][p]));
            } else if (signs[k][q] < 0) {
                leave(uppers++, k, inside[k][p], inside[k][p].minus(inside[k][q]));
            }
        }
        return isOpen(lowers, uppers);
    }

    /** Whether the ray from a point along a direction comes into all the slabs at once. */
    static boolean rayMeets(Quantity[] start, Quantity[] direction, List<Hull.Slab> slabs) {
        Clip clip = new Clip(List.of(start, direction), slabs, true);
        int lowers = 0;
        int uppers = 0;
        for (int k = 0; k < clip.signs.length; k++) {
            int sign = clip.signs[k][0];
            int slope = clip.signs[k][1];
            if (sign < 0) {
                if (slope <= 0) {
                    return false;
                }
                clip.enter(lowers++, k, clip.inside[k][0].negate(), clip.inside[k][1]);
            } else if (slope < 0) {
                clip.leave(uppers++, k, clip.inside[k][0], clip.inside[k][1].negate());
            }
        }
        return clip.isOpen(lowers, uppers);
    }

    private void enter(int at, int border, Quantity over, Quantity under) {
        lower[2 * at] = over;
        lower[2 * at + 1] = under;
        lowerOf[at] = slabOf[border];
    }

    private void leave(int at, int border, Quantity over, Quantity under) {
        upper[2 * at] = over;
        upper[2 * at + 1] = under;
        upperOf[at] = slabOf[border];
    }

    /** Whether no slab is entered after another is left; the same one never is. */
    private boolean isOpen(int lowers, int uppers) {
        for (int i = 0; i < lowers; i++) {
            for (int j = 0; j < uppers; j++) {
                if (lowerOf[i] != upperOf[j]
                        && !Vectors.atMost(
                                lower[2 * i].times(upper[2 * j + 1]), upper[2 * j].times(lower[2 * i + 1]))) {
                    return false;
                }
            }
        }
        return true;
    }
}
