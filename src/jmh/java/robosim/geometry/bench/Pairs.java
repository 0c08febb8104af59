package robosim.geometry.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/**
 * CPU time of one pair at any attitude near contact: whether the two touch, their distance, and a contact of those that
 * touch. The second of each pair is moved along a line until the two touch, then on or back by 1e-9 to 1e-1, so half of the
 * pairs overlap. With {@code -Dcoal=PROGRAM}, Coal 3.0 answers the same pairs in the same rounds.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Pairs
 * -Dcoal=bin/coal_pairs}. The program is built from {@code src/jmh/cpp/coal_pairs.cpp} with the headers and libraries that
 * {@code pip install coal} brings. {@code -Dpairs=} takes a part of the sets, {@code -Drounds=} is their number.
 *
 * <p>Each number is the least of the rounds.
 */
public final class Pairs {
    private static final int PAIRS = 2000;
    private static final int MESH_PAIRS = 100;
    private static final ThreadMXBean CLOCK = ManagementFactory.getThreadMXBean();

    private record Pair(GeometryObject a, GeometryObject b, boolean touch) {}

    private static final class Row {
        final String name;
        final List<Pair> pairs = new ArrayList<>();

        /** CPU ns of the module's three questions, then of Coal's two; then how many pairs Coal judges otherwise. */
        final double[] nanos = new double[6];

        Row(String name) {
            this.name = name;
            Arrays.fill(nanos, 0, 5, Double.POSITIVE_INFINITY);
        }
    }

    private final SplittableRandom random = new SplittableRandom(39);
    private final List<Row> rows = new ArrayList<>();
    private @Nullable MeshObject mesh;

    private Pairs() {}

    /** Makes the pairs, measures them in rounds, and prints a line for each row. */
    public static void main(String[] args) throws IOException {
        Pairs all = new Pairs();
        String wanted = System.getProperty(
                "pairs",
                "box-box,box-sphere,capsule-capsule,cylinder-capsule,box-cylinder,cylinder-cylinder,mesh-mesh");
        for (String name : wanted.split(",", -1)) {
            all.add(name);
        }
        int rounds = Integer.getInteger("rounds", 10);
        String coal = System.getProperty("coal");
        if (coal == null) {
            for (int round = 0; round < rounds; round++) {
                all.rows.forEach(Pairs::measure);
            }
        } else {
            all.beside(coal, rounds);
        }
        Timing.print(
                "%-18s %10s %10s %10s %10s %10s %8s",
                "pair", "intersects", "distance", "first", "collide", "distance", "misjudged");
        for (Row row : all.rows) {
            double[] n = row.nanos;
            Timing.print(
                    "%-18s %10.0f %10.0f %10.0f %10.0f %10.0f %8.0f", row.name, n[0], n[1], n[2], n[3], n[4], n[5]);
        }
    }

    private void beside(String coal, int rounds) throws IOException {
        Path folder = Files.createTempDirectory("pairs");
        Path file = folder.resolve("pairs.txt");
        write(file, folder.resolve("mesh.txt"));
        Process process = new ProcessBuilder(coal, file.toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try (PrintStream to = new PrintStream(process.getOutputStream(), true, StandardCharsets.UTF_8);
                BufferedReader from =
                        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            for (int round = 0; round < rounds; round++) {
                rows.forEach(Pairs::measure);
                to.println("turn");
                for (String line = from.readLine(); line != null && !line.startsWith("done"); line = from.readLine()) {
                    String[] words = line.split(" ", -1);
                    for (Row row : rows) {
                        if (row.name.equals(words[0])) {
                            row.nanos[3] = Math.min(row.nanos[3], Double.parseDouble(words[1]));
                            row.nanos[4] = Math.min(row.nanos[4], Double.parseDouble(words[2]));
                            row.nanos[5] = Double.parseDouble(words[3]);
                        }
                    }
                }
            }
        }
        process.destroy();
    }

    private static void measure(Row row) {
        int misjudged = 0;
        for (Pair pair : row.pairs) {
            misjudged += CollisionDetection.intersects(pair.a, pair.b) == pair.touch ? 0 : 1;
        }
        if (misjudged > 0) {
            throw new IllegalStateException("a pair must be judged as before (got: " + misjudged + " changes)");
        }
        time(row, 0, row.pairs, pair -> CollisionDetection.intersects(pair.a, pair.b) ? 1 : 0);
        time(
                row,
                1,
                row.pairs,
                pair -> ContactQuery.distance(pair.a, pair.b, Budget.UNLIMITED).low());
        List<Pair> touching = row.pairs.stream().filter(Pair::touch).toList();
        time(row, 2, touching, pair -> ContactQuery.first(pair.a, pair.b) == null ? 1 : 0);
    }

    private static void time(Row row, int at, List<Pair> pairs, ToDoubleFunction<Pair> task) {
        double sum = 0;
        long start = CLOCK.getCurrentThreadCpuTime();
        for (Pair pair : pairs) {
            sum += task.applyAsDouble(pair);
        }
        double nanos = (CLOCK.getCurrentThreadCpuTime() - start) / (double) pairs.size();
        row.nanos[at] = sum == 42.5 ? 0 : Math.min(row.nanos[at], nanos);
    }

    private void add(String name) {
        String[] kinds = name.split("-", -1);
        Row row = new Row(name);
        while (row.pairs.size() < (kinds[0].equals("mesh") ? MESH_PAIRS : PAIRS)) {
            row.pairs.add(pair(shape(kinds[0]), shape(kinds[1])));
        }
        rows.add(row);
    }

    private GeometryObject shape(String kind) {
        Point at = new Point(0, 0, 0);
        double p = random.nextDouble(0.2, 1);
        double q = random.nextDouble(0.2, 1);
        GeometryObject shape = switch (kind) {
            case "box" -> new BoxObject(at, p, q, random.nextDouble(0.2, 1));
            case "sphere" -> new SphereObject(at, p / 2);
            case "capsule" -> new CapsuleObject(at, p / 2, q);
            case "cylinder" -> new CylinderObject(at, p / 2, q);
            case "mesh" -> mesh();
            default -> throw new IllegalArgumentException("a kind must be known (got: " + kind + ")");
        };
        return shape.turned(random.nextDouble(-180, 180), random.nextDouble(-180, 180));
    }

    // A knotted tube of 5,856 triangles.
    private MeshObject mesh() {
        MeshObject made = mesh;
        if (made != null) {
            return made;
        }
        int along = 244;
        int around = 12;
        List<Point> vertices = new ArrayList<>();
        int[][] faces = new int[2 * along * around][];
        for (int i = 0; i < along; i++) {
            double t = 2 * Math.PI * i / along;
            for (int j = 0; j < around; j++) {
                double s = 2 * Math.PI * j / around;
                double out = 0.6 + 0.25 * StrictMath.cos(3 * t) + 0.12 * StrictMath.cos(s);
                vertices.add(new Point(
                        out * StrictMath.cos(2 * t),
                        0.25 * StrictMath.sin(3 * t) + 0.12 * StrictMath.sin(s),
                        out * StrictMath.sin(2 * t)));
                int right = (i + 1) % along * around;
                int up = (j + 1) % around;
                faces[2 * (i * around + j)] = new int[] {i * around + j, i * around + up, right + up};
                faces[2 * (i * around + j) + 1] = new int[] {i * around + j, right + up, right + j};
            }
        }
        made = new MeshObject(vertices, faces);
        mesh = made;
        return made;
    }

    private Pair pair(GeometryObject a, GeometryObject b) {
        double x = random.nextDouble(-1, 1);
        double y = random.nextDouble(-1, 1);
        double z = random.nextDouble(-1, 1);
        double length = Math.sqrt(x * x + y * y + z * z);
        double near = 0;
        double far = 4;
        while (far - near > 1e-13) {
            double middle = (near + far) / 2;
            if (CollisionDetection.intersects(a, at(b, middle / length, x, y, z))) {
                near = middle;
            } else {
                far = middle;
            }
        }
        double gap = StrictMath.pow(10, random.nextDouble(-9, -1)) * (random.nextBoolean() ? 1 : -1);
        GeometryObject placed = at(b, (near + gap) / length, x, y, z);
        return new Pair(a, placed, CollisionDetection.intersects(a, placed));
    }

    private static GeometryObject at(GeometryObject b, double share, double x, double y, double z) {
        return b.movedTo(new Point(share * x, share * y, share * z));
    }

    private void write(Path file, Path model) throws IOException {
        List<String> lines = new ArrayList<>();
        MeshObject tube = mesh;
        if (tube != null) {
            lines.add("model " + model);
            List<String> numbers = new ArrayList<>();
            numbers.add(tube.vertices().size() + " " + tube.faces().length);
            tube.vertices().forEach(p -> numbers.add(p.x() + " " + p.y() + " " + p.z()));
            for (int[] face : tube.faces()) {
                numbers.add(face[0] + " " + face[1] + " " + face[2]);
            }
            Files.write(model, numbers);
        }
        for (Row row : rows) {
            lines.add("set " + row.name);
            for (Pair pair : row.pairs) {
                lines.add((pair.touch ? "touch " : "apart ") + words(pair.a) + " " + words(pair.b));
            }
        }
        Files.write(file, lines);
    }

    private static String words(GeometryObject object) {
        String sizes = "mesh 0 0 0";
        if (object instanceof BoxObject box) {
            sizes = "box " + box.width() + " " + box.height() + " " + box.length();
        } else if (object instanceof SphereObject sphere) {
            sizes = "sphere " + sphere.radius() + " 0 0";
        } else if (object instanceof CapsuleObject capsule) {
            sizes = "capsule " + capsule.radius() + " " + capsule.segment() + " 0";
        } else if (object instanceof CylinderObject cylinder) {
            sizes = "cylinder " + cylinder.radius() + " " + cylinder.height() + " 0";
        }
        StringBuilder line = new StringBuilder(sizes);
        Point c = object.center();
        line.append(String.format(Locale.ROOT, " %s %s %s", c.x(), c.y(), c.z()));
        for (double number : object.rotation()) {
            line.append(' ').append(number);
        }
        return line.toString();
    }
}
