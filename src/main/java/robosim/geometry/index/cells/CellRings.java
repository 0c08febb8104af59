package robosim.geometry.index.cells;

/**
 * Shows the occupied cells around a rectangle, nearest first: ring by ring, each of the cells that are equally many cells away
 * as a king moves. A sector may limit it. Coordinates are the cells' own ({@link PlacedCells}). A search belongs to one thread.
 */
public final class CellRings {
    /** No index is taken to be farther out, so that sums of two do not overflow. */
    private static final int FAR = 1 << 29;

    private ClearanceMap map;
    private double slack;

    // The cells that the rectangle touches, some of which may be outside the grid.
    private int lowI;
    private int highI;
    private int lowJ;
    private int highJ;

    private int ring;
    private int lastRing;

    /** Which stretch of the ring is next: one of its four sides; of ring 0, which is full, one of its rows. */
    private int side;

    // The stretch: cells of a row, or of a column, that have not been looked at yet.
    private boolean isRow;
    private int fixed;
    private int place;
    private int end;

    // The sector: where it begins, and outward normals of its two sides.
    private boolean hasSector;
    private double apexU;
    private double apexV;
    private double leftU;
    private double leftV;
    private double rightU;
    private double rightV;

    @SuppressWarnings("NullAway.Init") // a search starts with its map
    public CellRings() {}

    /** Begins a search around a rectangle; the slack is more than any error of a coordinate. */
    public void start(ClearanceMap map, double lowU, double lowV, double highU, double highV, double slack) {
        this.map = map;
        this.slack = slack;
        hasSector = false;
        lowI = index(lowU - slack);
        highI = index(highU + slack);
        lowJ = index(lowV - slack);
        highJ = index(highV + slack);
        int columns = map.columns();
        int rows = map.rows();
        int outside = Math.max(Math.max(lowI - columns + 1, -highI), Math.max(lowJ - rows + 1, -highJ));
        lastRing = Math.max(0, Math.max(Math.max(lowI, columns - 1 - highI), Math.max(lowJ, rows - 1 - highJ)));
        ring = Math.max(0, Math.max(outside, firstRing()));
        side = 0;
        place = 0;
        end = -1;
    }

    /**
     * Limits the search to a sector.
     *
     * @param apexU where it begins
     * @param leftU a normal of one side, outward, of any length; both of its numbers are 0 where it has no such side
     */
    public void sector(double apexU, double apexV, double leftU, double leftV, double rightU, double rightV) {
        hasSector = true;
        this.apexU = apexU;
        this.apexV = apexV;
        this.leftU = leftU;
        this.leftV = leftV;
        this.rightU = rightU;
        this.rightV = rightV;
    }

    private static int index(double at) {
        return (int) Math.floor(Math.max(-FAR, Math.min(FAR, at)));
    }

    /** The first ring that may have an occupied cell, as far as the clearance of the middle tells. */
    private int firstRing() {
        int i = (lowI + highI) >> 1;
        int j = (lowJ + highJ) >> 1;
        if (i < 0 || i >= map.columns() || j < 0 || j >= map.rows()) {
            return 0;
        }
        return map.clearance(map.cell(i, j)) - Math.max(highI - i, highJ - j);
    }

    /**
     * The number of the next occupied cell; -1 if there is none within the limit.
     *
     * @param limit how far away to look, in cells; may only shrink
     */
    public int next(double limit) {
        while (true) {
            while (place <= end) {
                int cell = isRow ? map.cell(place, fixed) : map.cell(fixed, place);
                int clearance = map.clearance(cell);
                if (clearance == 0) {
                    place++;
                    return cell;
                }
                place += clearance;
            }
            if (!nextStretch(limit)) {
                return -1;
            }
        }
    }

    private boolean nextStretch(double limit) {
        int sides = ring == 0 ? Math.min(highJ, map.rows() - 1) - Math.max(lowJ, 0) + 1 : 4;
        if (side >= sides) {
            side = 0;
            ring++;
        }
        if (ring > lastRing || ring - 1 - slack > limit) {
            place = 0;
            end = -1;
            side = 0;
            return false;
        }
        if (ring == 0) {
            stretch(true, Math.max(lowJ, 0) + side, lowI, highI);
        } else {
            switch (side) {
                case 0 -> stretch(true, lowJ - ring, lowI - ring, highI + ring);
                case 1 -> stretch(true, highJ + ring, lowI - ring, highI + ring);
                case 2 -> stretch(false, lowI - ring, lowJ - ring + 1, highJ + ring - 1);
                default -> stretch(false, highI + ring, lowJ - ring + 1, highJ + ring - 1);
            }
        }
        side++;
        return true;
    }

    private void stretch(boolean isOfRow, int at, int from, int to) {
        isRow = isOfRow;
        fixed = at;
        int across = isOfRow ? map.rows() : map.columns();
        place = Math.max(from, 0);
        end = Math.min(to, (isOfRow ? map.columns() : map.rows()) - 1);
        if (at < 0 || at >= across) {
            end = place - 1;
        } else if (hasSector) {
            if (isOfRow) {
                clip(leftU, leftV, apexU, at - apexV);
                clip(rightU, rightV, apexU, at - apexV);
            } else {
                clip(leftV, leftU, apexV, at - apexU);
                clip(rightV, rightU, apexV, at - apexU);
            }
        }
    }

    /**
     * Leaves out cells of the stretch that are wholly on the outer side of a line through the apex.
     *
     * @param along  the part of the outward normal along the stretch
     * @param across the part across it
     * @param apex   the apex's coordinate along the stretch
     * @param near   the coordinate across it of the stretch's lower edge, as seen from the apex
     */
    private void clip(double along, double across, double apex, double near) {
        double least = across * (across > 0 ? near - slack : near + 1 + slack);
        double room = slack * Math.abs(along) - least;
        if (along > 0) {
            end = Math.min(end, index(apex + room / along + slack));
        } else if (along < 0) {
            place = Math.max(place, index(apex + room / along - slack));
        } else if (room < 0) {
            end = place - 1;
        }
    }
}
