package robosim.geometry.report.speed;

import java.io.IOException;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Ray;

/**
 * The worlds of {@code worlds/} at every level and in both dimensions: time a query, and how far answers are from those
 * at EXACT. With EXACT alone, what the filters without exact paths would take.
 */
final class Worlds implements Study {
    private static final int QUERIES = 4000;

    /** The generated scene beside the worlds where filters are compared. */
    static final int GENERATED = 10_000;

    private final boolean hasLevels;

    Worlds(boolean hasLevels) {
        this.hasLevels = hasLevels;
    }

    @Override
    public void run(Form form, Sink sink, Progress progress) throws IOException {
        int count = Math.min(QUERIES, 2 * form.cases());
        for (int k = 0; k < Place.NAMES.size(); k++) {
            double done = k;
            world(Place.NAMES.get(k), count, form, sink, share -> progress.at((done + share) / Place.NAMES.size()));
        }
        if (!hasLevels) {
            generated(Math.min(GENERATED, form.objects()), form, sink);
        }
    }

    private static void generated(int objects, Form form, Sink sink) {
        Field field = new Field(objects, Form.SEED);
        Ray[] rays = field.rays(Sizes.QUERIES);
        GeometryObject[] probes = field.probes(Sizes.QUERIES);
        InTurn tasks = new InTurn(form);
        for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
            Geometry geometry = field.geometry(dimension);
            Subject subject = Subject.module(Accuracy.EXACT, dimension);
            String scene = objects + " generated";
            InTurn.Batch cones = Asked.cones(geometry, rays, Field.CONE_RANGE, Field.CONE_DEGREES, Accuracy.EXACT);
            tasks.add(subject, scene, "ray", rays.length, Asked.rays(geometry, rays, Field.RAY_RANGE, Accuracy.EXACT));
            tasks.add(subject, scene, "cone", rays.length, cones);
            tasks.add(subject, scene, "overlap", probes.length, Asked.probes(geometry, probes, Accuracy.EXACT));
        }
        tasks.run(sink, share -> {});
    }

    private void world(String name, int count, Form form, Sink sink, Progress progress) throws IOException {
        Place place = Place.of(name);
        Ray[] rays = place.rays(count);
        GeometryObject[] probes = place.probes(count);
        double[] ways = place.ways(count);
        InTurn tasks = new InTurn(form);
        Answered spatial =
                new Answered(place.geometry(Dimension.SPATIAL, Accuracy.EXACT), rays, probes, Accuracy.EXACT);
        for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
            Geometry geometry = place.geometry(dimension, Accuracy.EXACT);
            Answered truth = new Answered(geometry, rays, probes, Accuracy.EXACT);
            for (Accuracy level : hasLevels ? Sizes.backwards() : List.of(Accuracy.EXACT)) {
                Subject subject = Subject.module(level, dimension);
                if (hasLevels) {
                    Answered answered = new Answered(geometry, rays, probes, level);
                    answered.put(truth, "", subject, name, sink);
                    answered.put(spatial, "of SPATIAL ", subject, name, sink);
                }
                Geometry own = place.geometry(dimension, level);
                tasks.add(subject, name, "ray", count, Asked.rays(geometry, rays, Place.RANGE, level));
                tasks.add(
                        subject,
                        name,
                        "cone",
                        count,
                        Asked.cones(geometry, rays, Place.RANGE, Place.CONE_DEGREES, level));
                tasks.add(subject, name, "overlap", count, Asked.probes(geometry, probes, level));
                tasks.add(subject, name, "move", count, Asked.moves(own, place.robots(), ways));
            }
        }
        tasks.run(sink, progress);
    }

    /** What a world answers at a level. */
    private static final class Answered {
        private final double[] distances;
        private final double[] cones;
        private final boolean[] hits;

        Answered(Geometry geometry, Ray[] rays, GeometryObject[] probes, Accuracy level) {
            distances = new double[rays.length];
            cones = new double[rays.length];
            hits = new boolean[probes.length];
            for (int k = 0; k < rays.length; k++) {
                distances[k] = Math.min(Place.RANGE, geometry.getRayDistance(rays[k], 0, Place.RANGE, 0, level));
                cones[k] = Math.min(
                        Place.RANGE, geometry.getRayDistance(rays[k], 0, Place.RANGE, Place.CONE_DEGREES, level));
            }
            for (int k = 0; k < probes.length; k++) {
                hits[k] = geometry.testObject(probes[k], level);
            }
        }

        /** Writes down how these answers differ from others that are held to be right. */
        void put(Answered truth, String of, Subject subject, String scene, Sink sink) {
            error(distances, truth.distances).put(sink, subject, scene, "ray", of + "error");
            error(cones, truth.cones).put(sink, subject, scene, "cone", of + "error");
            int added = 0;
            int missed = 0;
            for (int k = 0; k < hits.length; k++) {
                added += hits[k] && !truth.hits[k] ? 1 : 0;
                missed += !hits[k] && truth.hits[k] ? 1 : 0;
            }
            sink.put(subject, scene, "overlap", of + "added share", added / (double) hits.length);
            sink.put(subject, scene, "overlap", of + "missed share", missed / (double) hits.length);
        }

        private static Ecdf error(double[] said, double[] truth) {
            Ecdf errors = new Ecdf();
            for (int k = 0; k < said.length; k++) {
                errors.add(Math.abs(said[k] - truth[k]));
            }
            return errors;
        }
    }
}
