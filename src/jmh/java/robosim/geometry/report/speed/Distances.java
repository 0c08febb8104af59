package robosim.geometry.report.speed;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Reference;
import robosim.geometry.report.Dyn4jPeer;
import robosim.geometry.report.JtsPeer;
import robosim.geometry.report.Outline;
import robosim.geometry.report.Peer;
import robosim.geometry.report.Peer.CannotException;

/**
 * How far is it along a ray? Against the distance at 80 digits, in units in the last place of the largest number of the
 * question; who hears an echo where there is none, or none where there is one, or no number at all, has bars of its own.
 */
final class Distances implements Study {
    private static final double RANGE = 4e6;

    /** What is hit, and how it is seen. */
    enum Target {
        DISC("disc", Dimension.PLANAR),
        RECTANGLE("turned rectangle", Dimension.PLANAR),
        CYLINDER("upright cylinder", Dimension.SPATIAL),
        BALL("sphere", Dimension.SPATIAL),
        BOX("box in any attitude", Dimension.SPATIAL);

        final String text;
        final Dimension dimension;

        Target(String text, Dimension dimension) {
            this.text = text;
            this.dimension = dimension;
        }
    }

    /** How rays are aimed. */
    enum Aim {
        RANDOM("random"),
        GRAZING("grazing"),
        FAR("grazing from a million away");

        final String text;

        Aim(String text) {
            this.text = text;
        }
    }

    /** What an engine said so far. */
    private static final class Tally {
        final Ecdf ulps = new Ecdf();
        int asked;
        int missed;
        int invented;
        int noNumber;
    }

    @Override
    public void run(Form form, Sink sink, Progress progress) {
        int parts = Target.values().length * Aim.values().length;
        int part = 0;
        for (Target target : Target.values()) {
            for (Aim aim : Aim.values()) {
                double done = part++;
                family(target, aim, form, sink, share -> progress.at((done + share) / parts));
            }
        }
    }

    private static void family(Target target, Aim aim, Form form, Sink sink, Progress progress) {
        SplittableRandom random = new SplittableRandom(Form.SEED + 7L * target.ordinal() + aim.ordinal());
        Map<Subject, Tally> tallies = new LinkedHashMap<>();
        for (int k = 0; k < form.cases(); k++) {
            GeometryObject object = object(target, random);
            Ray ray = ray(aim, target, object, random);
            ask(ray, object, target.dimension, tallies);
            progress.at((k + 1.0) / form.cases());
        }
        tallies.forEach((subject, tally) -> {
            tally.ulps.putCurve(sink, subject, target.text, aim.text, "ulp");
            sink.put(subject, target.text, aim.text, "asked", tally.asked);
            sink.put(subject, target.text, aim.text, "missed", tally.missed);
            sink.put(subject, target.text, aim.text, "invented", tally.invented);
            sink.put(subject, target.text, aim.text, "no number", tally.noNumber);
        });
    }

    private static GeometryObject object(Target target, SplittableRandom random) {
        Point at = new Point(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        double a = random.nextDouble(0.2, 2);
        double b = random.nextDouble(0.2, 2);
        double c = random.nextDouble(0.2, 2);
        double turn = random.nextDouble(-180, 180);
        return switch (target) {
            case DISC, CYLINDER -> new CylinderObject(at, a / 2, b);
            case RECTANGLE -> new BoxObject(at, a, b, c).turned(0, turn);
            case BALL -> new SphereObject(at, a / 2);
            case BOX -> new BoxObject(at, a, b, c).turned(turn, random.nextDouble(-180, 180));
        };
    }

    /** At a point in the object, or beside its middle by about what it is wide; a little more or less. */
    private static Ray ray(Aim aim, Target target, GeometryObject object, SplittableRandom random) {
        double away = aim == Aim.FAR ? 1e6 * random.nextDouble(0.5, 1.5) : random.nextDouble(2, 20);
        double angle = random.nextDouble(2 * Math.PI);
        double rise =
                target.dimension == Dimension.PLANAR ? 0 : random.nextDouble(-0.4, 0.4) * (aim == Aim.FAR ? 1e-7 : 1);
        double dx = Math.cos(angle);
        double dz = Math.sin(angle);
        double aside = aim == Aim.RANDOM
                ? random.nextDouble(-1.2, 1.2)
                : extent(object, -dz, dx) * (1 - Math.pow(10, random.nextDouble(-14, -2)));
        Point c = object.center();
        double x = c.x() - dz * aside;
        double z = c.z() + dx * aside;
        return new Ray(
                new Point(x - dx * away, c.y() - rise * away, z - dz * away), new Point(dx * 3, rise * 3, dz * 3));
    }

    /** How far an object reaches from its centre in a level direction, to a rounding. */
    private static double extent(GeometryObject object, double nx, double nz) {
        if (object instanceof CylinderObject cylinder) {
            return cylinder.radius();
        }
        if (object instanceof SphereObject sphere) {
            return sphere.radius();
        }
        BoxObject box = (BoxObject) object;
        double[] r = box.rotation();
        return (Math.abs(nx * r[0] + nz * r[6]) * box.width()
                        + Math.abs(nx * r[1] + nz * r[7]) * box.height()
                        + Math.abs(nx * r[2] + nz * r[8]) * box.length())
                / 2;
    }

    private static void ask(Ray ray, GeometryObject object, Dimension dimension, Map<Subject, Tally> tallies) {
        BigDecimal truth = Reference.distance(ray, object, dimension);
        double unit = Math.ulp(largest(ray, object, truth));
        Geometry geometry = new Geometry(8 * RANGE, 8 * RANGE, 8 * RANGE, dimension, Accuracy.EXACT);
        geometry.addObjectUnchecked(object);
        Subject module = Subject.module(Accuracy.EXACT, dimension);
        count(tallies, module, geometry.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, 0), truth, unit);
        if (dimension == Dimension.PLANAR && !module.isAlone()) {
            askPeer(new JtsPeer(), ray, object, truth, unit, tallies);
            askPeer(new Dyn4jPeer(), ray, object, truth, unit, tallies);
        }
    }

    private static void askPeer(
            Peer peer,
            Ray ray,
            GeometryObject object,
            @Nullable BigDecimal truth,
            double unit,
            Map<Subject, Tally> tallies) {
        double[] from = {ray.start().x(), ray.start().z()};
        double[] direction = {ray.direction().x(), ray.direction().z()};
        try {
            double said = peer.ray(from, direction, RANGE, Outline.of(object));
            count(tallies, Subject.peer(peer.name()), said, truth, unit);
        } catch (CannotException e) {
            return; // it has no words for this
        } catch (RuntimeException e) {
            count(tallies, Subject.peer(peer.name()), Double.NaN, truth, unit);
        }
    }

    private static double largest(Ray ray, GeometryObject object, @Nullable BigDecimal truth) {
        double most = truth == null ? 0 : truth.doubleValue();
        for (Point p : new Point[] {ray.start(), object.center()}) {
            most = Math.max(most, Math.max(Math.abs(p.x()), Math.max(Math.abs(p.y()), Math.abs(p.z()))));
        }
        return most;
    }

    private static void count(
            Map<Subject, Tally> tallies, Subject subject, double said, @Nullable BigDecimal truth, double unit) {
        Tally tally = tallies.computeIfAbsent(subject, key -> new Tally());
        tally.asked++;
        if (Double.isNaN(said)) {
            tally.noNumber++;
        } else if (truth == null) {
            tally.invented += said < Double.POSITIVE_INFINITY ? 1 : 0;
        } else if (said == Double.POSITIVE_INFINITY) {
            tally.missed++;
        } else {
            BigDecimal off = new BigDecimal(said).subtract(truth).abs();
            tally.ulps.add(
                    off.divide(new BigDecimal(unit), MathContext.DECIMAL64).doubleValue());
        }
    }
}
