package robosim.geometry.report.speed;

import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * How long one question takes, each by the clock: the median, 999 of 1,000 and the worst, on random input and where 1 %
 * and 10 % of it is degenerate to a rounding: rays aimed at corners, discs that touch faces. Beside it how many questions
 * in a million came to pairs of doubles, and to exact arithmetic.
 */
final class Latency implements Study {
    static final List<Double> SHARES = List.of(0.0, 0.01, 0.1);
    private static final int OBJECTS = 1000;
    private static final int MOST = 200_000;

    @Override
    public void run(Form form, Sink sink, Progress progress) {
        int count = Math.min(MOST, 50 * form.cases());
        Field field = new Field(OBJECTS, Form.SEED);
        JtsScene jts = new JtsScene(field.objects);
        Dyn4jScene dyn4j = new Dyn4jScene(field.objects);
        Geometry flat = field.geometry(Dimension.PLANAR);
        Geometry space = field.geometry(Dimension.SPATIAL);
        int done = 0;
        for (double share : SHARES) {
            Ray[] rays = field.rays(count);
            CylinderObject[] probes = field.probes(count);
            spoil(field.objects, share, rays, probes, new SplittableRandom(Form.SEED + 300));
            Subject planar = Subject.module(Accuracy.EXACT, Dimension.PLANAR);
            Subject spatial = Subject.module(Accuracy.EXACT, Dimension.SPATIAL);
            String scene = "degenerate " + share;
            measure(planar, scene, "ray", Asked.rays(flat, rays, Field.RAY_RANGE, Accuracy.EXACT), count, sink);
            measure(spatial, scene, "ray", Asked.rays(space, rays, Field.RAY_RANGE, Accuracy.EXACT), count, sink);
            measure(planar, scene, "overlap", Asked.probes(flat, probes, Accuracy.EXACT), count, sink);
            measure(spatial, scene, "overlap", Asked.probes(space, probes, Accuracy.EXACT), count, sink);
            int few = count / 4; // slower, and told by as many nines
            measure(Subject.peer(Subject.JTS), scene, "ray", jts.rays(rays, Field.RAY_RANGE), few, sink);
            measure(Subject.peer(Subject.JTS), scene, "overlap", jts.probes(probes), few, sink);
            measure(Subject.peer(Subject.DYN4J), scene, "ray", dyn4j.rays(rays, Field.RAY_RANGE), few, sink);
            measure(Subject.peer(Subject.DYN4J), scene, "overlap", dyn4j.probes(probes), few, sink);
            progress.at(++done / (double) SHARES.size());
        }
        measure(Subject.peer("the clock alone"), "none", "nothing", (from, each) -> from, count, sink);
    }

    private static void spoil(
            List<GeometryObject> objects, double share, Ray[] rays, CylinderObject[] probes, SplittableRandom random) {
        List<BoxObject> boxes = objects.stream()
                .filter(BoxObject.class::isInstance)
                .map(BoxObject.class::cast)
                .toList();
        for (int k = 0; k < rays.length; k++) {
            if (random.nextDouble() < share) {
                BoxObject box = boxes.get(random.nextInt(boxes.size()));
                double[] r = box.rotation();
                Point c = box.center();
                double w = box.width() / 2 * (random.nextBoolean() ? 1 : -1);
                double l = box.length() / 2 * (random.nextBoolean() ? 1 : -1);
                double x = c.x() + w * r[0] + l * r[2];
                double z = c.z() + w * r[6] + l * r[8];
                Point start = new Point(x + random.nextDouble(-9, 9), c.y(), z + random.nextDouble(-9, 9));
                rays[k] = new Ray(start, new Point(x - start.x(), 0, z - start.z()));
                double reach = w + Math.copySign(0.5, w);
                probes[k] = probes[k].movedTo(
                        new Point(c.x() + reach * r[0], probes[k].center().y(), c.z() + reach * r[6]));
            }
        }
    }

    private static void measure(
            Subject subject, String scene, String query, InTurn.Batch batch, int count, Study.Sink sink) {
        double sum = batch.ask(0, count);
        long fine = falls(true);
        long exact = falls(false);
        Ecdf nanos = new Ecdf();
        for (int k = 0; k < count; k++) {
            long start = System.nanoTime();
            sum += batch.ask(k, 1);
            long end = System.nanoTime();
            nanos.add(end - start);
        }
        InTurn.used = sum;
        nanos.put(sink, subject, scene, query, "single ns");
        if (subject.isModule()) {
            sink.put(subject, scene, query, "pairs of doubles share", (falls(true) - fine) / (double) count);
            sink.put(subject, scene, query, "exact share", (falls(false) - exact) / (double) count);
        }
    }

    private static long falls(boolean fine) {
        return StageCounters.counts().entrySet().stream()
                .filter(stage -> stage.getKey().endsWith(" fine") == fine)
                .mapToLong(Map.Entry::getValue)
                .sum();
    }
}
