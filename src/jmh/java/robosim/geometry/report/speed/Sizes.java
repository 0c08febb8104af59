package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Ray;

/** Time a query in generated scenes of 100 to 1,000,000 objects: all levels, both dimensions, and other engines. */
final class Sizes implements Study {
    static final int QUERIES = 20_000;

    /** What other engines are asked at most: their scenes of a million fill the memory of small machines. */
    static final int MOST_OF_PEERS = 100_000;

    @Override
    public void run(Form form, Sink sink, Progress progress) {
        List<Integer> sizes = new ArrayList<>();
        for (int n = 100; n <= form.objects(); n *= 10) {
            sizes.add(n);
        }
        for (int k = 0; k < sizes.size(); k++) {
            double done = k;
            size(sizes.get(k), form, sink, share -> progress.at((done + share) / sizes.size()));
        }
    }

    private static void size(int n, Form form, Sink sink, Progress progress) {
        Field field = new Field(n, Form.SEED);
        Ray[] rays = field.rays(QUERIES);
        CylinderObject[] probes = field.probes(QUERIES);
        String scene = Integer.toString(n);
        InTurn tasks = new InTurn(form);
        for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
            long start = System.nanoTime();
            Geometry geometry = field.geometry(dimension);
            geometry.getRayDistance(rays[0], 0, 1, 0);
            double built = System.nanoTime() - start;
            sink.put(Subject.module(Accuracy.EXACT, dimension), scene, "build", "ms", built * 1e-6);
            for (Accuracy level : backwards()) {
                Subject subject = Subject.module(level, dimension);
                tasks.add(subject, scene, "ray", QUERIES, Asked.rays(geometry, rays, Field.RAY_RANGE, level));
                tasks.add(subject, scene, "overlap", QUERIES, Asked.probes(geometry, probes, level));
                tasks.add(
                        subject,
                        scene,
                        "cone",
                        QUERIES,
                        Asked.cones(geometry, rays, Field.CONE_RANGE, Field.CONE_DEGREES, level));
            }
        }
        if (n <= MOST_OF_PEERS) {
            JtsScene jts = new JtsScene(field.objects);
            tasks.add(Subject.peer(Subject.JTS), scene, "ray", QUERIES, jts.rays(rays, Field.RAY_RANGE));
            tasks.add(Subject.peer(Subject.JTS), scene, "overlap", QUERIES, jts.probes(probes));
            Dyn4jScene dyn4j = new Dyn4jScene(field.objects);
            tasks.add(Subject.peer(Subject.DYN4J), scene, "ray", QUERIES, dyn4j.rays(rays, Field.RAY_RANGE));
            tasks.add(Subject.peer(Subject.DYN4J), scene, "overlap", QUERIES, dyn4j.probes(probes));
        }
        tasks.run(sink, progress);
    }

    /** EXACT first: the others are told as ratios to it. */
    static List<Accuracy> backwards() {
        return List.of(Accuracy.EXACT, Accuracy.DOP, Accuracy.OBB, Accuracy.AABB, Accuracy.SPHERE);
    }
}
