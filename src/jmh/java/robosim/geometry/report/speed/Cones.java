package robosim.geometry.report.speed;

import java.io.IOException;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A sonar's cone answered as the nearest point in it, and as fans of level rays over the same angle. */
final class Cones implements Study {
    static final List<Integer> FANS = List.of(3, 5, 11, 21, 45, 91, 181);
    static final List<Integer> DEGREES = List.of(15, 30);
    static final String GENERATED = "1000 generated";
    static final List<String> SCENES = List.of("rooms", "warehouse", "cylinders", GENERATED);
    private static final int POSES = 1000;

    /** A world and where sonars stand in it. */
    private record Setting(String name, Geometry geometry, Ray[] rays) {}

    @Override
    public void run(Form form, Sink sink, Progress progress) throws IOException {
        int poses = Math.min(POSES, 2 * form.cases());
        int parts = 2 * SCENES.size();
        int part = 0;
        for (String scene : SCENES) {
            for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
                double done = part++;
                Setting setting = setting(scene, dimension, poses);
                measure(setting, dimension, form, sink, share -> progress.at((done + share) / parts));
            }
        }
    }

    private static Setting setting(String scene, Dimension dimension, int poses) throws IOException {
        if (scene.equals(GENERATED)) {
            Field field = new Field(1000, Form.SEED);
            return new Setting(scene, field.geometry(dimension), field.rays(poses));
        }
        Place place = Place.of(scene);
        return new Setting(scene, place.geometry(dimension, Accuracy.EXACT), place.rays(poses));
    }

    private static void measure(Setting setting, Dimension dimension, Form form, Sink sink, Progress progress) {
        Geometry geometry = setting.geometry;
        Ray[] rays = setting.rays;
        InTurn tasks = new InTurn(form);
        for (int degrees : DEGREES) {
            String scene = setting.name + " " + degrees;
            Subject exact = Subject.module(Accuracy.EXACT, dimension);
            double[] truth = new double[rays.length];
            for (int k = 0; k < rays.length; k++) {
                truth[k] = Math.min(Place.RANGE, geometry.getRayDistance(rays[k], 0, Place.RANGE, degrees));
            }
            tasks.add(
                    exact,
                    scene,
                    "cone",
                    rays.length,
                    Asked.cones(geometry, rays, Place.RANGE, degrees, Accuracy.EXACT));
            for (int size : FANS) {
                Ray[][] fans = new Ray[rays.length][];
                for (int k = 0; k < rays.length; k++) {
                    fans[k] = fan(rays[k], size, degrees);
                }
                String query = "fan of " + size;
                put(geometry, fans, truth, exact, scene, query, sink);
                tasks.add(exact, scene, query, rays.length, (from, count) -> {
                    double sum = 0;
                    for (int k = from; k < from + count; k++) {
                        sum += ask(geometry, fans[k]);
                    }
                    return sum;
                });
            }
        }
        tasks.run(sink, progress);
    }

    /** Level rays from one edge of the cone to the other, the edges too. */
    private static Ray[] fan(Ray axis, int size, double degrees) {
        Ray[] fan = new Ray[size];
        double dx = axis.direction().x();
        double dz = axis.direction().z();
        for (int k = 0; k < size; k++) {
            double angle = Math.toRadians(degrees) * (k / (size - 1.0) - 0.5);
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            fan[k] = new Ray(axis.start(), new Point(dx * cos - dz * sin, 0, dx * sin + dz * cos));
        }
        return fan;
    }

    private static double ask(Geometry geometry, Ray[] fan) {
        double least = Place.RANGE;
        for (Ray ray : fan) {
            least = Math.min(least, geometry.getRayDistance(ray, 0, Place.RANGE, 0));
        }
        return least;
    }

    private static void put(
            Geometry geometry, Ray[][] fans, double[] truth, Subject subject, String scene, String query, Sink sink) {
        Ecdf late = new Ecdf();
        int unheard = 0;
        int echoes = 0;
        double early = 0;
        for (int k = 0; k < fans.length; k++) {
            double said = ask(geometry, fans[k]);
            late.add(Math.max(0, said - truth[k]));
            early = Math.max(early, truth[k] - said);
            echoes += truth[k] < Place.RANGE ? 1 : 0;
            unheard += truth[k] < Place.RANGE && said >= Place.RANGE ? 1 : 0;
        }
        late.put(sink, subject, scene, query, "late");
        sink.put(subject, scene, query, "early most", early);
        sink.put(subject, scene, query, "unheard share", unheard / (double) Math.max(1, echoes));
    }
}
