package robosim.geometry.report.speed;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.cases.HardCase.Drive;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.reference.Gaps;
import robosim.geometry.report.Dyn4jPeer;
import robosim.geometry.report.Outline;
import robosim.geometry.report.Peer.CannotException;

/**
 * How far may an object go straight on? Stopping early is safe, stopping late is not; what is left of the two in each
 * other afterwards; and who goes through a wall.
 */
final class Moves implements Study {
    static final String SAMPLING = "10 tests on the way";
    static final String WALLS = "thin walls";
    private static final double NEVER = Double.POSITIVE_INFINITY;

    /** What moves against what, seen how. */
    enum Family {
        DISC_BOX("disc to turned box", Dimension.PLANAR),
        BOX_BOX("box to turned box", Dimension.PLANAR),
        DISC_DISC("disc to disc", Dimension.PLANAR),
        CYLINDER_BOX("upright cylinder to turned box", Dimension.SPATIAL);

        final String text;
        final Dimension dimension;

        Family(String text, Dimension dimension) {
            this.text = text;
            this.dimension = dimension;
        }
    }

    private static final class Tally {
        final Ecdf early = new Ecdf();
        final Ecdf late = new Ecdf();
        final Ecdf penetration = new Ecdf();
        int asked;
        int through;
        int invented;
    }

    @Override
    public void run(Form form, Sink sink, Progress progress) {
        int parts = Family.values().length + 1;
        for (Family family : Family.values()) {
            double done = family.ordinal();
            family(family, form, sink, share -> progress.at((done + share) / parts));
        }
        walls(25 * form.cases(), sink, share -> progress.at((parts - 1 + share) / parts));
    }

    private static void family(Family family, Form form, Sink sink, Progress progress) {
        SplittableRandom random = new SplittableRandom(Form.SEED + 100 + family.ordinal());
        Map<Subject, Tally> tallies = new LinkedHashMap<>();
        int count = Math.max(10, form.cases() / 5); // halving in exact arithmetic takes its time
        for (int k = 0; k < count; k++) {
            GeometryObject obstacle = obstacle(family, random);
            GeometryObject mover = mover(family, random).moveable("mover");
            Point way = way(mover.center(), family.dimension, random);
            if (Gap.between(mover, obstacle, family.dimension).signum() > 0) {
                ask(mover, way, obstacle, family.dimension, tallies);
            }
            progress.at((k + 1.0) / count);
        }
        tallies.forEach((subject, tally) -> {
            tally.early.putCurve(sink, subject, family.text, "move", "early");
            tally.late.putCurve(sink, subject, family.text, "move", "late");
            tally.penetration.put(sink, subject, family.text, "move", "penetration");
            sink.put(subject, family.text, "move", "asked", tally.asked);
            sink.put(subject, family.text, "move", "through", tally.through);
            sink.put(subject, family.text, "move", "invented", tally.invented);
        });
    }

    private static GeometryObject obstacle(Family family, SplittableRandom random) {
        Point at = new Point(random.nextDouble(-0.5, 0.5), random.nextDouble(-0.5, 0.5), random.nextDouble(-0.5, 0.5));
        if (family == Family.DISC_DISC) {
            return new CylinderObject(at, random.nextDouble(0.1, 1), 1);
        }
        return new BoxObject(at, random.nextDouble(0.05, 2), random.nextDouble(0.5, 2), random.nextDouble(0.5, 2))
                .turned(0, random.nextDouble(-180, 180));
    }

    private static GeometryObject mover(Family family, SplittableRandom random) {
        double angle = random.nextDouble(2 * Math.PI);
        double away = random.nextDouble(1.5, 8);
        Point at = new Point(Math.cos(angle) * away, random.nextDouble(-0.5, 0.5), Math.sin(angle) * away);
        return family == Family.BOX_BOX
                ? new BoxObject(at, random.nextDouble(0.2, 1), 1, random.nextDouble(0.2, 1))
                : new CylinderObject(at, random.nextDouble(0.1, 0.5), 1);
    }

    /** About towards the middle and beyond. */
    private static Point way(Point from, Dimension dimension, SplittableRandom random) {
        double scale = random.nextDouble(0.6, 2.5);
        double rise = dimension == Dimension.PLANAR ? 0 : random.nextDouble(-0.5, 0.5);
        return new Point(
                -from.x() * scale + random.nextDouble(-1, 1), rise, -from.z() * scale + random.nextDouble(-1, 1));
    }

    private static void ask(
            GeometryObject mover,
            Point way,
            GeometryObject obstacle,
            Dimension dimension,
            Map<Subject, Tally> tallies) {
        BigDecimal truth = Gaps.touch(mover, way, obstacle, dimension);
        Subject module = Subject.module(Accuracy.EXACT, dimension);
        Geometry geometry = new Geometry(200, 200, 200, dimension, Accuracy.EXACT);
        geometry.addObjectUnchecked(obstacle);
        geometry.addObjectUnchecked(mover);
        MoveResult result = geometry.moveToContact("mover", new Move(way.x(), way.y(), way.z(), 0, 0), 0);
        double share = result.allowed() ? NEVER : result.fraction();
        count(tallies, module, share, truth, way, geometry.getObject("mover"), obstacle, dimension);
        if (dimension == Dimension.PLANAR && !module.isAlone()) {
            double said = dyn4j(mover, way, obstacle);
            GeometryObject there = after(mover, way, Math.min(1, said));
            count(tallies, Subject.peer(Subject.DYN4J), said, truth, way, there, obstacle, dimension);
        }
    }

    private static GeometryObject after(GeometryObject mover, Point way, double share) {
        Point c = mover.center();
        return mover.movedTo(new Point(c.x() + way.x() * share, c.y() + way.y() * share, c.z() + way.z() * share));
    }

    private static double dyn4j(GeometryObject mover, Point way, GeometryObject obstacle) {
        double[] along = {way.x(), way.y(), way.z()};
        Drive drive = new Drive("mover", along, 0, List.of("obstacle"), "", 0, "", null);
        try {
            return new Dyn4jPeer().move(Outline.of(mover), drive, Outline.of(obstacle));
        } catch (CannotException e) {
            throw new IllegalStateException(e);
        }
    }

    private static void count(
            Map<Subject, Tally> tallies,
            Subject subject,
            double said,
            @Nullable BigDecimal truth,
            Point way,
            GeometryObject there,
            GeometryObject obstacle,
            Dimension dimension) {
        Tally tally = tallies.computeIfAbsent(subject, key -> new Tally());
        tally.asked++;
        if (truth == null || said == NEVER) {
            tally.through += truth != null ? 1 : 0;
            tally.invented += said != NEVER ? 1 : 0;
            return;
        }
        double length = Math.sqrt(way.x() * way.x() + way.y() * way.y() + way.z() * way.z());
        double off = new BigDecimal(said).subtract(truth).doubleValue() * length;
        tally.early.add(Math.max(0, -off));
        tally.late.add(Math.max(0, off));
        tally.penetration.add(
                Math.max(0, -Gap.between(there, obstacle, dimension).doubleValue()));
    }

    /** Fast discs across walls of a thickness down to none, in the middle of which they can not be missed. */
    private static void walls(int count, Sink sink, Progress progress) {
        SplittableRandom random = new SplittableRandom(Form.SEED + 200);
        Subject module = Subject.module(Accuracy.EXACT, Dimension.PLANAR);
        Map<Subject, int[]> through = new LinkedHashMap<>();
        for (int k = 0; k < count; k++) {
            double thick = k % 10 == 0 ? 0 : Math.pow(10, random.nextDouble(-12, -1));
            GeometryObject wall = new BoxObject(new Point(), thick, 1, 10).turned(0, random.nextDouble(-40, 40));
            double radius = Math.pow(10, random.nextDouble(-4, -0.5));
            GeometryObject mover = new CylinderObject(
                            new Point(-random.nextDouble(5, 50), 0, random.nextDouble(-1, 1)), radius, 1)
                    .moveable("mover");
            Point way = new Point(-2.5 * mover.center().x(), 0, random.nextDouble(-1, 1));
            Geometry geometry = new Geometry(300, 10, 300, Dimension.PLANAR, Accuracy.EXACT);
            geometry.addObjectUnchecked(wall);
            if (!module.isAlone()) {
                add(through, Subject.peer(Subject.DYN4J), dyn4j(mover, way, wall) == NEVER);
                boolean isSeen = false;
                for (int step = 1; step <= 10; step++) {
                    isSeen |= geometry.testObject(after(mover, way, step / 10.0).moveable("test"));
                }
                add(through, Subject.peer(SAMPLING), !isSeen);
            }
            geometry.addObjectUnchecked(mover);
            add(through, module, geometry.simpleMove("mover", way.x(), way.y(), way.z()));
            progress.at((k + 1.0) / count);
        }
        through.forEach((subject, counts) -> {
            sink.put(subject, WALLS, "move", "asked", counts[0]);
            sink.put(subject, WALLS, "move", "through", counts[1]);
        });
    }

    private static void add(Map<Subject, int[]> through, Subject subject, boolean isThrough) {
        int[] counts = through.computeIfAbsent(subject, key -> new int[2]);
        counts[0]++;
        counts[1] += isThrough ? 1 : 0;
    }
}
