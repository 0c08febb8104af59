package robosim.geometry.dynamics.planar;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.World;
import robosim.geometry.engine.objects.IgnoredPairs;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/** What there is in a world as a step sees it: bodies, and the pieces of these and of what stands still. */
final class PlanarScene {
    final MovingBodies bodies = new MovingBodies();
    final ConvexPieces pieces = new ConvexPieces();

    /** What passes through each other. */
    final IgnoredPairs passing;

    /** How each piece bounces and rubs. */
    double[] restitution = new double[8];

    double[] still = new double[8];
    double[] sliding = new double[8];

    /** The boxes of what stands still, by piece less {@link #firstStill}. */
    final CellGrid stillGrid = new CellGrid();

    /** The pieces of bodies come first. */
    int firstStill;

    private final World world;
    private final double halfX;
    private final double halfZ;
    private final PieceOutlines outlines = new PieceOutlines(pieces);
    private long changes = -1;
    private @Nullable ContactSurfaces surfaces;

    /** The columns of each body's rotation that a turn about the vertical keeps: its own Y. */
    private double[] upwards = new double[8];

    PlanarScene(World world) {
        this.world = world;
        passing = world.ignoredPairs();
        halfX = world.width / 2;
        halfZ = world.length / 2;
    }

    /** The height of the centre of a body's object. */
    double height(int id) {
        return world.objects.places()[world.objects.place(id) + 1];
    }

    /** The surfaces that the pieces were made with. */
    ContactSurfaces surfaces() {
        return Checks.present("surfaces", surfaces);
    }

    /** Whether objects were added to the world or removed from it since the pieces were made. */
    boolean isOld() {
        return changes != world.objects.changes();
    }

    void forget() {
        changes = -1;
    }

    /** Makes all pieces anew; bodies have been told before, with their ids. */
    void build(ContactSurfaces surfaces) {
        this.surfaces = surfaces;
        changes = world.objects.changes();
        pieces.clear();
        ObjectTable objects = world.objects;
        upwards = new double[3 * Math.max(1, bodies.count)];
        for (int b = 0; b < bodies.count; b++) {
            bodies.betweenParts.run();
            outline(b);
            cover(surfaces, bodies.id[b]);
        }
        firstStill = pieces.count;
        objects.ids().forEach(id -> {
            if (!objects.isMoveable(id)) {
                outlines.addStill(id, objects.value(id));
                cover(surfaces, id);
            }
        });
        addBorder();
        cover(surfaces, -1);
        double cell = 0;
        for (int piece = firstStill; piece < pieces.count - 4; piece++) {
            cell = Math.max(cell, 0.125 * extent(piece));
        }
        double own = 0;
        for (int b = 0; b < bodies.count; b++) {
            own += 2 * bodies.size[b];
        }
        own = bodies.count == 0 ? 0 : own / bodies.count;
        cell = own > 0 ? own : cell > 0 ? cell : 1;
        stillGrid.clear(pieces.count - firstStill, cell);
        for (int piece = firstStill; piece < pieces.count; piece++) {
            double r = pieces.radius[piece];
            stillGrid.put(
                    piece - firstStill,
                    least(pieces.x, piece) - r,
                    least(pieces.z, piece) - r,
                    -leastNegated(pieces.x, piece) + r,
                    -leastNegated(pieces.z, piece) + r);
        }
    }

    private void outline(int b) {
        ObjectTable objects = world.objects;
        GeometryObject present = objects.present(bodies.id[b]);
        Pose pose = present.pose();
        int first = pieces.count;
        if (pose.isUpright()) {
            outlines.add(b, bodies.id[b], present.at(Pose.ORIGIN), bodies.offsetX[b], bodies.offsetZ[b], 1, 0);
        } else {
            double cos = Degrees.cos(present.heading());
            double sin = Degrees.sin(present.heading());
            double x = pose.center().x() + bodies.asideX(b, cos, sin);
            double z = pose.center().z() + bodies.asideZ(b, cos, sin);
            outlines.add(b, bodies.id[b], present, x, z, cos, sin);
        }
        bodies.firstPiece[b] = first;
        bodies.pieces[b] = pieces.count - first;
        double size = 0;
        for (int piece = first; piece < pieces.count; piece++) {
            size = Math.max(size, pieces.reach[piece] + pieces.radius[piece]);
        }
        bodies.size[b] = size;
        double[] places = objects.places();
        int at = objects.place(bodies.id[b]) + ObjectTable.ROTATION;
        for (int row = 0; row < 3; row++) {
            upwards[3 * b + row] = places[at + 3 * row + 1];
        }
    }

    /** Gives the pieces that were added last their surface. */
    private void cover(ContactSurfaces surfaces, int object) {
        if (restitution.length < pieces.count) {
            restitution = Arrays.copyOf(restitution, 2 * pieces.count);
            still = Arrays.copyOf(still, 2 * pieces.count);
            sliding = Arrays.copyOf(sliding, 2 * pieces.count);
        }
        for (int piece = pieces.count - 1; piece >= 0 && pieces.object[piece] == object; piece--) {
            restitution[piece] = surfaces.restitution(object);
            still[piece] = surfaces.staticFriction(object);
            sliding[piece] = surfaces.slidingFriction(object);
        }
    }

    /** Four boxes around the world. */
    private void addBorder() {
        double thick = Math.max(1, Math.max(halfX, halfZ));
        // First those across X, then those across Z: so a corner's two come in the same order in all four corners.
        for (int sign = -1; sign <= 1; sign += 2) {
            Point beside = new Point(sign * (halfX + thick), 0, 0);
            outlines.addStill(-1, new BoxObject(beside, 2 * thick, 1, 2 * halfZ + 4 * thick));
        }
        for (int sign = -1; sign <= 1; sign += 2) {
            Point ahead = new Point(0, 0, sign * (halfZ + thick));
            outlines.addStill(-1, new BoxObject(ahead, 2 * halfX + 4 * thick, 1, 2 * thick));
        }
    }

    private double extent(int piece) {
        return Math.max(
                -leastNegated(pieces.x, piece) - least(pieces.x, piece),
                -leastNegated(pieces.z, piece) - least(pieces.z, piece));
    }

    private double least(double[] of, int piece) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = pieces.firstCorner[piece]; k < pieces.firstCorner[piece + 1]; k++) {
            least = Math.min(least, of[k]);
        }
        return least;
    }

    private double leastNegated(double[] of, int piece) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = pieces.firstCorner[piece]; k < pieces.firstCorner[piece + 1]; k++) {
            least = Math.min(least, -of[k]);
        }
        return least;
    }

    /** Takes the places of all bodies as the world has them; false where one has been tipped, so that its pieces are others. */
    boolean place() {
        ObjectTable objects = world.objects;
        double[] places = objects.places();
        for (int b = 0; b < bodies.count; b++) {
            int at = objects.place(bodies.id[b]);
            bodies.x[b] = places[at];
            bodies.z[b] = places[at + 2];
            bodies.angle[b] = 0;
            bodies.time[b] = 0;
            bodies.changes[b] = 0;
            bodies.lightness[b] = bodies.ownLightness[b];
            bodies.ease[b] = bodies.ownEase[b];
            int r = at + ObjectTable.ROTATION;
            for (int row = 0; row < 3; row++) {
                if (upwards[3 * b + row] != places[r + 3 * row + 1]) {
                    return false;
                }
            }
            boolean isUpright = places[r + 4] == 1;
            double cos = isUpright
                    ? places[r]
                    : Degrees.cos(places[at + ObjectTable.HEADING], places[at + ObjectTable.HEADING + 1]);
            double sin = isUpright
                    ? places[r + 2]
                    : Degrees.sin(places[at + ObjectTable.HEADING], places[at + ObjectTable.HEADING + 1]);
            if (bodies.isOffset(b)) {
                bodies.x[b] += bodies.asideX(b, cos, sin);
                bodies.z[b] += bodies.asideZ(b, cos, sin);
            }
            for (int k = 0; k < bodies.pieces[b]; k++) {
                pieces.turn(bodies.firstPiece[b] + k, cos, sin);
            }
        }
        return true;
    }
}
