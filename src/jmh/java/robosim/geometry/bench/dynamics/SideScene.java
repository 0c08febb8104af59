package robosim.geometry.bench.dynamics;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** A planar scene for several engines: bodies, walls, one surface, and velocities that are set anew every half second. */
final class SideScene {
    /** Seconds after which all velocities are set anew, where they are. */
    static final double STIRRED = 0.5;

    final String name;
    final String text;
    final Surface surface;
    final boolean isStirred;
    final List<GeometryObject> bodies = new ArrayList<>();
    final List<GeometryObject> walls = new ArrayList<>();

    /** Half of the side of the square room. */
    final double half;

    /** The side of the square cells into which walls part the room. */
    final double cell;

    private final double speed;
    private final double turn;
    private final SplittableRandom random = new SplittableRandom(8);

    private SideScene(String name, String text, Surface surface, boolean isStirred, double[] sizes) {
        this.name = name;
        this.text = text;
        this.surface = surface;
        this.isStirred = isStirred;
        half = sizes[0];
        cell = sizes[1];
        double thick = sizes[2];
        speed = sizes[3];
        turn = sizes[4];
        // The outer walls stand outside; those within are thin.
        for (int side = -1; side <= 1; side += 2) {
            walls.add(new BoxObject(new Point(side * (half + 0.5), 0, 0), 1, 1, 2 * half + 2));
            walls.add(new BoxObject(new Point(0, 0, side * (half + 0.5)), 2 * half, 1, 1));
        }
        for (double at = cell - half; at < half - 0.5 * cell; at += cell) {
            walls.add(new BoxObject(new Point(at, 0, 0), thick, 1, 2 * half));
            walls.add(new BoxObject(new Point(0, 0, at), 2 * half, 1, thick));
        }
    }

    /** 200 discs and boxes that cover 40 % of a room. */
    static SideScene crowd() {
        SideScene scene = new SideScene(
                "crowd",
                "200 discs and boxes of about 0.5 m cover 40 % of a room and move at up to 2 m/s",
                new Surface(0.5, 0.3, 0.3),
                true,
                new double[] {0.5 * Math.sqrt(200 * 0.25 / 0.4), 1e9, 0, 2, 115});
        scene.fill(200, false);
        return scene;
    }

    /** Cells between walls of a millimetre. */
    static SideScene cells() {
        SideScene scene = new SideScene(
                "thin walls",
                "64 discs and boxes in 16 cells of 3 m between walls of 1 mm move at up to 50 m/s",
                new Surface(0.5, 0.3, 0.3),
                true,
                new double[] {6, 3, 1e-3, 50, 115});
        scene.fill(64, false);
        return scene;
    }

    /** Elastic discs. */
    static SideScene billiards() {
        SideScene scene = new SideScene(
                "billiards",
                "50 elastic discs without friction cover a fifth of a room and begin at up to 5 m/s",
                new Surface(1, 0, 0),
                false,
                new double[] {0.5 * Math.sqrt(50 * 0.25 / 0.2), 1e9, 0, 5, 0});
        scene.fill(50, true);
        return scene;
    }

    private void fill(int count, boolean areRound) {
        Geometry free = world();
        while (bodies.size() < count) {
            Point c = new Point(random.nextDouble(-half, half), 0, random.nextDouble(-half, half));
            String its = "b" + bodies.size();
            GeometryObject body = areRound || bodies.size() % 2 == 0
                    ? new CylinderObject(c, random.nextDouble(0.22, 0.32), 1).moveable(its)
                    : new BoxObject(c, random.nextDouble(0.35, 0.65), 1, random.nextDouble(0.35, 0.65))
                            .turned(0, random.nextDouble(360))
                            .moveable(its);
            if (free.addObject(body)) {
                bodies.add(body);
            }
        }
    }

    /** The walls in a world; the bodies as well, once there are any. */
    Geometry world() {
        Geometry world = new Geometry(2 * half + 4, 2, 2 * half + 4, Dimension.PLANAR, Accuracy.EXACT);
        walls.forEach(world::addObjectUnchecked);
        bodies.forEach(world::addObject);
        return world;
    }

    /** Velocities along X and Z and of turning, degrees a second, for each body; the same for each time. */
    double[] velocities(int time) {
        SplittableRandom of = new SplittableRandom(100 + time);
        double[] all = new double[3 * bodies.size()];
        for (int k = 0; k < all.length; k++) {
            all[k] = (k % 3 == 2 ? turn : speed) * of.nextDouble(-1, 1);
        }
        return all;
    }

    /** The number of the cell in which a place is; -1 outside. */
    int cellOf(double x, double z) {
        if (!(Math.abs(x) < half && Math.abs(z) < half)) {
            return -1;
        }
        int across = (int) Math.ceil(2 * half / cell);
        return across * (int) ((z + half) / cell) + (int) ((x + half) / cell);
    }
}
