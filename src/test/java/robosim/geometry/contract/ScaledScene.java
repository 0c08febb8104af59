package robosim.geometry.contract;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.RayHit;
import robosim.geometry.SenseBuffer;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;

/**
 * A random scene and questions about it, which can be asked at any scale: all lengths are multiples of 2<sup>-24</sup>, so
 * that each of them times a power of two is a double down to the smallest.
 */
final class ScaledScene {
    /** An answer: what was asked, and a number without a unit. */
    record Answer(String question, double value) {}

    private static final double SIZE = 64;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final Dimension dimension;
    private final Accuracy accuracy;
    private final List<GeometryObject> objects = new ArrayList<>();
    private final List<Ray> rays = new ArrayList<>();
    private final List<Move> moves = new ArrayList<>();
    private final GeometryObject visitor;
    private final boolean hasGrid;

    /** Whether heights of centres and starts stay as they are, which do not count in PLANAR. */
    private final boolean keepsHeights;

    ScaledScene(SplittableRandom random, Dimension dimension, Accuracy accuracy) {
        this.dimension = dimension;
        this.accuracy = accuracy;
        RandomObjects some = new RandomObjects(random, 3);
        hasGrid = random.nextInt(4) == 0;
        if (hasGrid) {
            objects.add(RandomGrids.next(random, some.heading()));
        }
        for (int k = random.nextInt(hasGrid ? 2 : 1, 5); k > 0; k--) {
            objects.add(scaled(some.next(), 0));
        }
        objects.set(objects.size() - 1, objects.get(objects.size() - 1).moveable("robot"));
        visitor = some.next();
        keepsHeights = dimension == Dimension.PLANAR && accuracy == Accuracy.EXACT && random.nextBoolean();
        for (int k = 0; k < 3; k++) {
            rays.add(new Ray(k == 0 ? new Point() : some.place(), some.direction()));
            Point way = some.place();
            double rx = random.nextInt(3) == 0 ? random.nextDouble(-200, 200) : 0;
            double ry = random.nextInt(3) == 0 ? 0 : random.nextDouble(-200, 200);
            moves.add(random.nextInt(3) == 0 ? new Move(0, 0, 0, rx, ry) : new Move(way.x(), way.y(), way.z(), rx, ry));
        }
    }

    /** Whether a grid's least cell forbids a scale. */
    boolean isLegalAt(int power) {
        return !hasGrid || power >= -490;
    }

    @Override
    public String toString() {
        return dimension + " " + accuracy + " " + objects;
    }

    /** All answers at a scale of 2<sup>power</sup>, lengths as multiples of it. */
    List<Answer> answers(int power) {
        List<Answer> answers = new ArrayList<>();
        Geometry world = world(power);
        double far = scaled(1e3, power);
        answers.add(new Answer("overlap", world.testObject(placed(visitor, power)) ? 1 : 0));
        for (Ray asked : rays) {
            Ray ray = new Ray(placed(asked.start(), power), asked.direction());
            for (double width : new double[] {0, 2, 30, 120}) {
                double distance = world.getRayDistance(ray, 0, width == 2 ? INFINITE : far, width);
                answers.add(length(asked + " width " + width, distance, power));
            }
            double[] scan = new double[5];
            world.scan("robot", -80, 40, 0, far, scan);
            for (double echo : scan) {
                answers.add(length("scan", echo, power));
            }
            hit(answers, asked, world.castRay(ray, far), power);
        }
        packet(answers, world, power);
        cones(answers, world, power);
        places(answers, world, power);
        answers.add(length("proximity", world.getProximity("robot", INFINITE), power));
        for (Move asked : moves) {
            Move move = scaled(asked, power);
            // What tips turns heights into the plane.
            Move own = keepsHeights ? new Move(move.x(), move.y(), move.z(), 0, 0) : move;
            move(answers, "move " + asked, world(power).move("robot", own));
            move(answers, "global " + asked, world(power).moveGlobal("robot", move));
            move(answers, "contact " + asked, world(power).moveToContact("robot", own, scaled(0.125, power)));
        }
        return answers;
    }

    private void packet(List<Answer> answers, Geometry world, int power) {
        double[] packet = new double[7 * rays.size()];
        for (int k = 0; k < rays.size(); k++) {
            Point start = placed(rays.get(0).start(), power);
            Point way = rays.get(k).direction();
            double[] numbers = {start.x(), start.y(), start.z(), way.x(), way.y(), way.z(), INFINITE};
            System.arraycopy(numbers, 0, packet, 7 * k, 7);
        }
        SenseBuffer out = new SenseBuffer();
        world.castRays(packet, rays.size(), out);
        for (int k = 0; k < rays.size(); k++) {
            answers.add(length("packet", out.distance(k), power));
        }
    }

    private void cones(List<Answer> answers, Geometry world, int power) {
        SenseOptions options = SenseOptions.range(0, scaled(1e3, power)).withWidth(20);
        SenseBuffer out = new SenseBuffer();
        world.sense("robot", Pose.ORIGIN, RayPattern.fan(-180, 40, 9), options, out);
        for (int k = 0; k < out.size(); k++) {
            answers.add(length("ring", out.distance(k), power));
        }
    }

    private void places(List<Answer> answers, Geometry world, int power) {
        double[] poses = new double[8 * rays.size()];
        for (int k = 0; k < rays.size(); k++) {
            Point from = placed(rays.get(k).start(), power);
            Point to = placed(rays.get(k).direction(), power);
            double[] numbers = {from.x(), from.y(), from.z(), 30 * k, to.x(), to.y(), to.z(), 50 * k};
            System.arraycopy(numbers, 0, poses, 8 * k, 8);
        }
        long[] free = new long[1];
        world.freePoses("robot", poses, free);
        answers.add(new Answer("free poses", free[0]));
        world.freeEdges("robot", poses, free);
        answers.add(new Answer("free edges", free[0]));
    }

    private void hit(List<Answer> answers, Ray ray, RayHit hit, int power) {
        answers.add(length(ray + " hit", hit == null ? INFINITE : hit.distance(), power));
        if (hit != null && !keepsHeights) { // how near to a face counts as on it depends on all coordinates
            answers.add(new Answer(ray + " normal x", hit.normal().x()));
            answers.add(new Answer(ray + " normal y", hit.normal().y()));
            answers.add(new Answer(ray + " normal z", hit.normal().z()));
        }
    }

    private static void move(List<Answer> answers, String what, MoveResult result) {
        answers.add(new Answer(what + " allowed", result.allowed() ? 1 : 0));
        answers.add(new Answer(what + " fraction", result.fraction()));
        answers.add(new Answer(what + " turnFraction", result.turnFraction()));
    }

    private Geometry world(int power) {
        double size = scaled(SIZE, power);
        Geometry world = new Geometry(size, size, size, dimension, accuracy);
        for (GeometryObject object : objects) {
            if (!world.addObjectUnchecked(placed(object, power))) {
                throw new AssertionError("outside: " + object);
            }
        }
        return world;
    }

    private static Answer length(String what, double length, int power) {
        return new Answer(what, times(length, -power));
    }

    private GeometryObject placed(GeometryObject object, int power) {
        GeometryObject scaled = scaled(object, power);
        return keepsHeights ? scaled.movedTo(placed(object.center(), power)) : scaled;
    }

    private Point placed(Point p, int power) {
        return keepsHeights ? new Point(scaled(p.x(), power), p.y(), scaled(p.z(), power)) : scaled(p, power);
    }

    private static double scaled(double length, int power) {
        return times(Math.rint(0x1p24 * length) * 0x1p-24, power);
    }

    private static double times(double value, int power) {
        return Math.scalb(Math.scalb(value, power / 2), power - power / 2);
    }

    private static Point scaled(Point p, int power) {
        return new Point(scaled(p.x(), power), scaled(p.y(), power), scaled(p.z(), power));
    }

    private static Move scaled(Move move, int power) {
        return new Move(
                scaled(move.x(), power), scaled(move.y(), power), scaled(move.z(), power), move.rx(), move.ry());
    }

    /** The object, its name included, with all lengths times a power of two. */
    static GeometryObject scaled(GeometryObject object, int power) {
        GeometryObject shape = sized(object, power);
        Pose pose = object.pose().movedTo(scaled(object.center(), power));
        GeometryObject there = shape.at(pose);
        return object.isMoveable() ? there.moveable(object.name()) : there;
    }

    private static GeometryObject sized(GeometryObject object, int power) {
        Point origin = new Point();
        if (object instanceof BoxObject o) {
            return new BoxObject(
                    origin, scaled(o.width(), power), scaled(o.height(), power), scaled(o.length(), power));
        }
        if (object instanceof CylinderObject o) {
            return new CylinderObject(origin, scaled(o.radius(), power), scaled(o.height(), power));
        }
        if (object instanceof CapsuleObject o) {
            return new CapsuleObject(origin, scaled(o.radius(), power), scaled(o.height(), power));
        }
        if (object instanceof SphereObject o) {
            return new SphereObject(origin, scaled(o.radius(), power));
        }
        if (object instanceof GridObject o) {
            return new GridObject(
                    origin, scaled(o.cell(), power), scaled(o.height(), power), o.columns(), o.rows(), o.occupied());
        }
        if (object instanceof MeshObject o) {
            List<Point> vertices =
                    o.vertices().stream().map(v -> scaled(v, power)).toList();
            MeshObject mesh = new MeshObject(vertices, o.faces());
            return o.isSolid() ? mesh.solid() : mesh;
        }
        ObjectGroup group = (ObjectGroup) object;
        return new ObjectGroup(
                group.members().stream().map(member -> scaled(member, power)).toList());
    }
}
