package robosim.geometry.engine.broadphase;

import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.hierarchy.ConeCursor;
import robosim.geometry.index.hierarchy.Hierarchy;
import robosim.geometry.index.hierarchy.RayCursor;
import robosim.geometry.narrow.Cast;

/**
 * Visits the objects that a line or a cone may meet, mostly the nearer ones first, and none that begins farther than the
 * subclass still looks. A class and no interface, so that the compiler knows the one subclass: rays are short.
 */
public abstract class BeamSearch {
    /** More than what a square may lose by underflow. */
    private static final double UNDERFLOW = 0x1p-1000;

    /** How many objects are remembered that a ray has been tried on. */
    private static final int RECENT = 8;

    /** A box that nothing meets. */
    private static final double[] NOTHING = {
        Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY
    };

    protected final ObjectTable objects;
    protected final Cast cast;

    /** The beam of the cast. */
    private final BeamAxis beam;

    /** The sides of the cone seen from above: outward normals; both zero where it has none. */
    private double leftX;

    private double leftZ;
    private double rightX;
    private double rightZ;

    /** By the last bits of an id: the query's number above the id. */
    private final long[] recent = new long[RECENT];

    private long query;

    /** A box, of which all objects that meet it have been looked at. */
    private double[] done = NOTHING;

    /** A search for what the beam of a cast meets. */
    protected BeamSearch(ObjectTable objects, Cast cast) {
        this.objects = objects;
        this.cast = cast;
        beam = cast.beam;
    }

    /** Looks at an object, perhaps not for the first time; answers how far to look from now on. */
    protected abstract double hit(LeafTable table, int id, double reach);

    /**
     * Looks at an object of a world without heights by its outline alone.
     *
     * @param outlines those of all objects of its table; see {@link robosim.geometry.index.tiles.OrientedRectangle}
     * @param local the object's place in them
     * @return how far to look from now on; NaN where the outline does not tell
     */
    protected abstract double hitOutline(int id, double[] outlines, int local, double reach);

    /** Whether an object is the nearest so far, which has nothing new to tell. */
    protected abstract boolean isNearest(int id);

    /**
     * The cone's shadow on the XZ plane is a sector where its axis rises less than it leaves room for: the sine of the
     * half angle seen from above is that of the cone over the cosine of the axis's rise.
     */
    private void setSides() {
        double ux = beam.ux();
        double uz = beam.uz();
        double level = Math.sqrt(ux * ux + uz * uz);
        double shadow = beam.sin * (1 + 0x1p-40) + 0x1p-40;
        if (shadow >= level) {
            leftX = 0;
            leftZ = 0;
            rightX = 0;
            rightZ = 0;
            return;
        }
        double sine = shadow / level;
        double cosine = Math.sqrt((1 - sine) * (1 + sine));
        double ax = ux / level;
        double az = uz / level;
        leftX = -sine * ax - cosine * az;
        leftZ = -sine * az + cosine * ax;
        rightX = -sine * ax + cosine * az;
        rightZ = -sine * az - cosine * ax;
    }

    /**
     * Searches a world.
     *
     * @param limit how far to look before anything has been found
     * @param ignored an object that is left out; -1 for none
     */
    protected void search(AccuracyView view, double limit, int ignored) {
        double reach = limit;
        for (LeafTable table = view.first(); ; table = view.own) {
            for (int k = 0; k < table.gridCount(); k++) { // first, as a map's walls mostly hide the rest
                if (table.grid(k) != ignored && !table.overlaps(table.grid(k), done)) {
                    reach = hit(table, table.grid(k), reach);
                }
            }
            SpaceIndex space = table.space;
            if (table.hasEmptyTrees()) {
                // nothing to look for
            } else if (space == null) {
                reach = beam.isCone ? searchSector(table, reach, ignored) : searchLine(table, reach, ignored);
            } else {
                reach = beam.isCone
                        ? searchCone(table, space, reach, ignored)
                        : searchRay(table, space, reach, ignored);
            }
            if (table.moversBesideTree() > 0) {
                reach = searchBesideTree(table, reach, ignored);
            }
            if (table == view.own) {
                return;
            }
        }
    }

    /** Adds the cone at hand to those that share what is around their place, or begins with it. */
    public void share(ConeCandidates around, int cone, boolean isFirst) {
        if (isFirst) {
            around.start(beam.ox, beam.oy, beam.oz);
        }
        setSides();
        if (leftX == 0 && leftZ == 0) {
            around.add(cone);
        } else {
            // The sides are across the borders: half their sum is the axis, times the sine, and back.
            double x = -(leftX + rightX) / 2;
            double z = -(leftZ + rightZ) / 2;
            double sine = Math.sqrt(x * x + z * z);
            around.add(cone, x / sine, z / sine, Math.min(1, sine + 0x1p-40));
        }
    }

    /**
     * Searches a world along one of the cones that share what is around their place; past that, alone.
     *
     * @param cone its number among them
     */
    protected void searchAround(AccuracyView view, double limit, int ignored, ConeCandidates around, int cone) {
        LeafTable own = view.own;
        setSides();
        double slack = slack(own) + 0x1p-44 * Math.abs(beam.oy);
        double reach = limit;
        double within = loose(reach, slack);
        for (int k = 0; around.has(k, within); k++) {
            int id = around.id(k);
            if (around.mayTouch(k, cone) && id != ignored) {
                LeafTable table = view.table(id);
                if (coneHits(table, id, within)) {
                    reach = hit(table, id, reach);
                    within = loose(reach, slack);
                }
            }
        }
        double complete = around.complete();
        if (within >= complete && complete < Double.POSITIVE_INFINITY) {
            around.close();
            done = around.box();
            try {
                search(view, reach, ignored);
            } finally {
                done = NOTHING;
            }
        }
    }

    private double searchBesideTree(LeafTable table, double limit, int ignored) {
        int count = table.moversBesideTree();
        if (beam.isCone) {
            setSides();
        }
        double slack = slack(table);
        double reach = limit;
        for (int k = next(table, 0, loose(reach, slack)); k < count; k = next(table, k + 1, loose(reach, slack))) {
            int id = objects.mover(k);
            if (id != ignored && !table.overlaps(id, done)) {
                reach = hit(table, id, reach);
            }
        }
        return reach;
    }

    /** The next of the moveable objects beside the tree that the beam may meet within a reach. */
    private int next(LeafTable table, int from, double reach) {
        if (!beam.isCone) {
            return nextOnLine(table, from, reach);
        }
        int k = from;
        while (k < table.moversBesideTree() && !coneHits(table, objects.mover(k), reach)) {
            k++;
        }
        return k;
    }

    /** Searches the quadtree along a line. */
    private double searchLine(LeafTable table, double limit, int ignored) {
        int mark = table.mark;
        double slack = slack(table);
        double inverse = beam.inverseLength();
        double[] outlines = table.leaves().outlines();
        QuadCursor cursor = table.cursor;
        double reach = limit;
        double last = loose(reach, slack) * inverse;
        query += 1L << Integer.SIZE;
        cursor.startRay(beam.ox, beam.oz, beam.dx, beam.dz);
        for (int local = cursor.nextOnRay(last, outlines); local >= 0; local = cursor.nextOnRay(last, outlines)) {
            // What is the nearest so far comes again where it lies across regions.
            int id = local | mark;
            if (id != ignored && !isNearest(id)) {
                double found = hitOutline(id, outlines, local, reach);
                reach = !Double.isNaN(found) ? found : isNew(id) ? hit(table, id, reach) : reach;
                last = loose(reach, slack) * inverse;
            }
        }
        return reach;
    }

    /** Whether an object, which may come again and again along a ray as it lies across regions, has not just come. */
    private boolean isNew(int id) {
        long mark = query | id;
        int place = id & (RECENT - 1);
        if (recent[place] == mark) {
            return false;
        }
        recent[place] = mark;
        return true;
    }

    /** Searches the quadtree in the sector that is the cone as seen from above. */
    private double searchSector(LeafTable table, double limit, int ignored) {
        double reach = limit;
        double slack = slack(table);
        QuadCursor cursor = table.cursor;
        cursor.startSector(beam);
        for (int local = cursor.next(loose(reach, slack)); local >= 0; local = cursor.next(loose(reach, slack))) {
            int id = local | table.mark;
            if (id != ignored && !table.overlaps(id, done)) {
                reach = hit(table, id, reach);
            }
        }
        return reach;
    }

    /** Searches the hierarchies of a world with heights along a line. */
    private double searchRay(LeafTable table, SpaceIndex space, double limit, int ignored) {
        int only = space.only();
        if (only >= 0 && table.count(only | table.mark) == 1) { // nothing to look for
            int id = only | table.mark;
            return id == ignored ? limit : hit(table, id, limit);
        }
        RayCursor cursor = space.rays;
        cursor.aim(beam, space.most());
        double reach = limit;
        for (Hierarchy tree = space.still; ; tree = space.moving) {
            if (tree.size() > 0) {
                cursor.start(tree);
                for (int local = cursor.next(reach); local >= 0; local = cursor.next(reach)) {
                    int id = local | table.mark;
                    if (id != ignored) {
                        reach = hit(table, id, reach);
                    }
                }
            }
            if (tree == space.moving) {
                return reach;
            }
        }
    }

    private double searchCone(LeafTable table, SpaceIndex space, double limit, int ignored) {
        double reach = limit;
        double slack = slack(table) + 0x1p-44 * (space.most() + Math.abs(beam.oy));
        ConeCursor cursor = space.cones;
        cursor.aim(beam, space.most());
        cursor.start(space.still, space.moving);
        for (int local = cursor.next(loose(reach, slack)); local >= 0; local = cursor.next(loose(reach, slack))) {
            int id = local | table.mark;
            if (id != ignored && !table.overlaps(id, done)) {
                reach = hit(table, id, reach);
            }
        }
        return reach;
    }

    /**
     * The reach of the index and of bounds. A certified distance may be below the true one, and so below where the bounds
     * begin: by 2^-40 of itself in a cone, and for a cylinder by 2^-44 of its place and size, both of which the
     * world limits. What is answered at all is to be found again with its own distance as the limit.
     */
    static double loose(double reach, double slack) {
        return reach + (0x1p-38 * reach + slack);
    }

    private double slack(LeafTable table) {
        return 0x1p-44 * (table.extent + Math.abs(beam.ox) + Math.abs(beam.oz));
    }

    /** A loop without calls, so that everything stays in registers. Never wrong where it passes over an object. */
    private int nextOnLine(LeafTable table, int from, double reach) {
        double ux = beam.ux();
        double uz = beam.uz();
        double ox = beam.ox;
        double oz = beam.oz;
        double place = Math.abs(ox) + Math.abs(oz);
        double wideX = Math.abs(ux);
        double wideZ = Math.abs(uz);
        double[] b = table.bounds();
        int count = table.moversBesideTree();
        for (int mover = from; mover < count; mover++) {
            int k = table.boundsAt(objects.mover(mover));
            double hx = b[k + 3] / 2 - b[k] / 2;
            double hz = b[k + 5] / 2 - b[k + 2] / 2;
            double mx = b[k] / 2 + b[k + 3] / 2 - ox;
            double mz = b[k + 2] / 2 + b[k + 5] / 2 - oz;
            double slack = 0x1p-40 * (Math.abs(mx) + Math.abs(mz) + place + hx + hz);
            double ahead = mx * ux + mz * uz;
            double half = hx * wideX + hz * wideZ + slack;
            if (Math.abs(mx * uz - mz * ux) <= hx * wideZ + hz * wideX + slack
                    && ahead >= -half
                    && (reach == Double.POSITIVE_INFINITY || ahead - half <= reach)) {
                return mover;
            }
        }
        return count;
    }

    private boolean coneHits(LeafTable table, int id, double reach) {
        double[] b = table.bounds();
        int k = table.boundsAt(id);
        double dx = Math.max(0, Math.max(b[k] - beam.ox, beam.ox - b[k + 3]));
        double dz = Math.max(0, Math.max(b[k + 2] - beam.oz, beam.oz - b[k + 5]));
        if ((dx * dx + dz * dz) * (1 - 0x1p-50) > reach * reach + UNDERFLOW) {
            return false;
        }
        return !isBeyond(b, k, leftX, leftZ) && !isBeyond(b, k, rightX, rightZ);
    }

    /** Whether a box is wholly on the outer side of one of the cone's sides. */
    private boolean isBeyond(double[] b, int k, double nx, double nz) {
        double x = nx > 0 ? b[k] - beam.ox : b[k + 3] - beam.ox;
        double z = nz > 0 ? b[k + 2] - beam.oz : b[k + 5] - beam.oz;
        // What a certified shape is taken larger by goes with its size, not with how near its box is.
        double size = Math.abs(b[k]) + Math.abs(b[k + 2]) + Math.abs(b[k + 3]) + Math.abs(b[k + 5]);
        double slack = 0x1p-40 * (size + Math.abs(beam.ox) + Math.abs(beam.oz));
        return nx * x + nz * z > slack;
    }
}
