package robosim.geometry.bench;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.bench.Questions.Family;
import robosim.geometry.bench.Questions.Subject;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/**
 * One number for the bits of many answers, the same on every JVM: verdicts, distances of rays, cones and between objects,
 * free shares of motions, places after moves; of the kernels, and of worlds of both dimensions and every accuracy.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test
 * -Dexec.mainClass=robosim.geometry.bench.Digest -Dexec.args=1000000}
 */
public final class Digest {
    private static final int[][] FACES = {
        {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}
    };

    private final MessageDigest hash;
    private final ByteBuffer bytes = ByteBuffer.allocate(8);
    private int left;

    private Digest(int answers) {
        left = answers;
        try {
            hash = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Prints the digest of as many answers as are asked for, a million if no number is given. */
    public static void main(String[] args) {
        int count = args.length > 0 && args[0].matches("\\d+") ? Integer.parseInt(args[0]) : 1_000_000;
        System.out.println(of(count));
    }

    /** The digest of so many answers, half of them of kernels and half of worlds. */
    public static String of(int count) {
        Digest digest = new Digest(count / 2);
        digest.kernels();
        digest.left = count - count / 2;
        digest.worlds();
        return HexFormat.of().formatHex(digest.hash.digest());
    }

    private void add(double answer) {
        if (left > 0) {
            bytes.clear();
            hash.update(bytes.putLong(Double.doubleToLongBits(answer)).array());
            left--;
        }
    }

    private void add(Point point) {
        add(point.x());
        add(point.y());
        add(point.z());
    }

    private void kernels() {
        Questions questions = new Questions();
        List<Family> families = Questions.families(Subject.values());
        for (int round = 0; left > 0; round++) {
            for (Family family : families) {
                questions.make(family, 17, round);
                add(questions.ask());
            }
        }
    }

    private void worlds() {
        for (int round = 0; left > 0; round++) {
            for (Dimension dimension : Dimension.values()) {
                for (Accuracy accuracy : Accuracy.values()) {
                    world(dimension, accuracy, new SplittableRandom(round));
                }
            }
        }
    }

    private void world(Dimension dimension, Accuracy accuracy, SplittableRandom random) {
        Geometry geometry = new Geometry(16, 6, 16, dimension, accuracy);
        for (int k = 0; k < 40; k++) {
            add(geometry.addObject(object(random)) ? 1 : 0);
        }
        List<String> robots = new ArrayList<>();
        for (int k = 0; k < 40 && robots.size() < 4; k++) {
            if (geometry.addObject(object(random).moveable("robot " + k))) {
                robots.add("robot " + k);
            }
        }
        for (int step = 0; step < 10; step++) {
            for (String robot : robots) {
                move(geometry, robot, random);
                look(geometry, robot, random);
            }
        }
    }

    private void move(Geometry geometry, String robot, SplittableRandom random) {
        Move move = new Move(
                random.nextDouble(-1, 1),
                random.nextInt(3) == 0 ? random.nextDouble(-0.5, 0.5) : 0,
                random.nextDouble(-0.2, 0.2),
                random.nextInt(4) == 0 ? random.nextDouble(-40, 40) : 0,
                random.nextDouble(-90, 90));
        MoveResult result = switch (random.nextInt(4)) {
            case 0 -> geometry.moveGlobal(robot, move);
            case 1 -> geometry.moveToContact(robot, move, 0.01);
            default -> geometry.move(robot, move);
        };
        add(result.allowed() ? 1 : 0);
        add(result.fraction());
        add(result.turnFraction());
        if (result.contact() != null && result.normal() != null) {
            add(result.contact());
            add(result.normal());
        }
        GeometryObject moved = geometry.getObject(robot);
        add(moved.center());
        for (double number : moved.rotation()) {
            add(number);
        }
        add(moved.heading());
    }

    private void look(Geometry geometry, String robot, SplittableRandom random) {
        for (double width : new double[] {0, 0, random.nextDouble(1, 60)}) {
            Point way = new Point(random.nextDouble(-1, 1), random.nextDouble(-0.3, 0.3), random.nextDouble(-1, 1));
            Point start = new Point(random.nextDouble(-8, 8), random.nextDouble(-2, 2), random.nextDouble(-8, 8));
            add(geometry.getRayDistance(new Ray(start, way), 0, 30, width));
            add(geometry.getSonarDistance(robot, way.x(), way.z(), 0.1, 10, width));
        }
        add(geometry.getProximity(robot, 5));
        for (double distance : geometry.scan(robot, 0, 30, 12, 0, 10)) {
            add(distance);
        }
    }

    private static GeometryObject object(SplittableRandom random) {
        GeometryObject shape = switch (random.nextInt(6)) {
            case 0, 1 -> box(random);
            case 2 -> new CylinderObject(new Point(), random.nextDouble(0.1, 0.6), random.nextDouble(0.1, 1.5));
            case 3 -> new SphereObject(new Point(), random.nextDouble(0.1, 0.6));
            case 4 -> random.nextBoolean() ? mesh(random) : mesh(random).solid();
            default -> new ObjectGroup(List.of(box(random), new SphereObject(new Point(0.5, 0, 0), 0.3)));
        };
        GeometryObject turned = shape.turned(
                random.nextBoolean() ? 0 : random.nextDouble(-180, 180),
                random.nextInt(3) == 0 ? 90 * random.nextInt(4) : random.nextDouble(-180, 180));
        return turned.movedTo(
                new Point(random.nextDouble(-7, 7), random.nextDouble(-1.5, 1.5), random.nextDouble(-7, 7)));
    }

    private static BoxObject box(SplittableRandom random) {
        return new BoxObject(
                new Point(), random.nextDouble(0.1, 1.5), random.nextDouble(0.1, 1.5), random.nextDouble(0.1, 1.5));
    }

    // A box with its corners pushed about.
    private static MeshObject mesh(SplittableRandom random) {
        List<Point> corners = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            corners.add(new Point(
                    (k & 1) - 0.5 + random.nextDouble(-0.2, 0.2),
                    (k >> 1 & 1) - 0.5 + random.nextDouble(-0.2, 0.2),
                    (k >> 2 & 1) - 0.5 + random.nextDouble(-0.2, 0.2)));
        }
        return new MeshObject(corners, FACES);
    }
}
