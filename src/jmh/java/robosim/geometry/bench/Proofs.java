package robosim.geometry.bench;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.proof.Attempt;
import robosim.geometry.proof.Claim;
import robosim.geometry.proof.Proof;
import robosim.geometry.proof.ProofChecker;
import robosim.geometry.proof.Prover;
import robosim.geometry.proof.Scene;
import robosim.geometry.world.WorldReader;

/**
 * What proofs cost: CPU time of finding and of checking one, the least of some rounds, and the size of its JSON; and a picture of the
 * planes that keep a turning robot of {@code worlds/rooms.xml} from a wall. With {@code -Dpublish} it writes docs/report/proofs.md
 * and docs/images/turning-plane.svg.
 */
public final class Proofs {
    private static final Path REPORT = Path.of("docs", "report", "proofs.md");
    private static final Path PICTURE = Path.of("docs", "images", "turning-plane.svg");
    private static final int ROUNDS = Integer.getInteger("rounds", 7);
    private static final Pattern SLAB = Pattern.compile("\\[([-+.\\dE]+(?:,[-+.\\dE]+){7})\\]");

    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private final SplittableRandom random = new SplittableRandom(44);
    private final StringBuilder table = new StringBuilder();

    private Proofs() {}

    /** Prints the table. */
    public static void main(String[] args) throws IOException {
        Proofs proofs = new Proofs();
        proofs.measure();
        String picture = turn();
        System.out.print(proofs.table);
        if (Boolean.getBoolean("publish") || "".equals(System.getProperty("publish"))) {
            Files.writeString(PICTURE, picture);
            Files.writeString(REPORT, page(proofs.table.toString()));
        }
    }

    private void measure() {
        BoxObject crate = new BoxObject(new Point(0, 0, 0), 1, 2, 3);
        GeometryObject box = new BoxObject(new Point(2.2, 0.4, 0.3), 1, 1, 1).turned(20, 30);
        Prover pair = Prover.of(crate.turned(15, 40));
        ProofChecker pairs = new ProofChecker(pair.scene());
        row("two turned boxes, apart", "5 µs", "2 kB", "1 ms", 2000, () -> pair.apart(box), pairs);
        Geometry hundred = world(100, 50);
        row(
                "a blocked move among 100 objects",
                "200 µs",
                "10 kB",
                "20 ms",
                200,
                () -> hundred.prove().move("robot", new Move(24, 0, 5, 0, 0)).get(0),
                hundred.prove().checker());
        Geometry many = world(10_000, 250);
        row(
                "a ray among 10,000 objects",
                "1 ms",
                "50 kB",
                "100 ms",
                10,
                () -> many.prove().sonar("robot", 1, 0.2, 120, 0),
                many.prove().checker());
    }

    private Geometry world(int count, double side) {
        Geometry world = new Geometry(side + 10, 12, side + 10, Dimension.SPATIAL, Accuracy.EXACT);
        world.addObject(
                new BoxObject(new Point(0, 0, 0), 0.6, 1, 0.6).turned(0, 30).moveable("robot"));
        while (world.objects().size() <= count) {
            Point c = new Point(
                    random.nextDouble(-side / 2, side / 2),
                    random.nextDouble(-3, 3),
                    random.nextDouble(-side / 2, side / 2));
            switch (random.nextInt(3)) {
                case 0 ->
                    world.addObject(new BoxObject(c, 1, 2, 3).turned(random.nextDouble(360), random.nextDouble(360)));
                case 1 ->
                    world.addObject(
                            new CylinderObject(c, 0.7, 2).turned(random.nextDouble(90), random.nextDouble(360)));
                default -> world.addObject(new SphereObject(c, 1));
            }
        }
        return world;
    }

    private void row(
            String what,
            String mostFound,
            String mostSize,
            String mostChecked,
            int times,
            Supplier<Attempt> finding,
            ProofChecker checker) {
        Proof proof = finding.get().proof();
        if (proof == null || !checker.check(proof).isValid()) {
            throw new IllegalStateException(
                    what + " must be proved (got: " + finding.get().reason() + ")");
        }
        if (proof.claim() instanceof Claim.Ray ray && !(ray.low() > 1)) {
            throw new IllegalStateException("a ray must go some way (got: " + ray + ")");
        }
        double found = least(times, finding::get);
        double checked = least(Math.max(1, times / 50), () -> checker.check(proof));
        int bytes = proof.json().getBytes(StandardCharsets.UTF_8).length;
        table.append(String.format(
                Locale.ROOT,
                "| %s | %s | %s | %.1f kB | %s | %s | %s |%n",
                what,
                time(found),
                mostFound,
                bytes / 1000.0,
                mostSize,
                time(checked),
                mostChecked));
    }

    private double least(int times, Supplier<?> work) {
        double least = Double.POSITIVE_INFINITY;
        for (int round = 0; round < ROUNDS; round++) {
            long begin = threads.getCurrentThreadCpuTime();
            for (int k = 0; k < times; k++) {
                work.get();
            }
            least = Math.min(least, (threads.getCurrentThreadCpuTime() - begin) / 1e3 / times);
        }
        return least;
    }

    private static String time(double micros) {
        return micros < 1000
                ? String.format(Locale.ROOT, "%.3g µs", micros)
                : String.format(Locale.ROOT, "%.3g ms", micros / 1000);
    }

    private static String page(String rows) {
        return """
                # What proofs cost

                CPU time of one thread, the least of %d rounds, on two cores that are shared with other work, beside the aims.
                The JSON is that of the proof without the scene. What a proof says, and how to check one, is in [Proofs of answers](../proofs.md).

                | proof | found in | aim | JSON | aim | checked in | aim |
                |---|--:|--:|--:|--:|--:|--:|
                %s
                ```
                mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Proofs
                ```

                prints these lines; with `-Dpublish` it writes this page and its picture.

                ## A plane over time

                A cart of `worlds/rooms.xml` turns beside the end of a wall. That it never touches the wall is proved by a few planes,
                seen from above as lines, each for a part of the turn: the wall is on one side of it, and all of the cart on the other,
                at every moment of that part. The parts cover the whole turn.

                ![The cart in several attitudes beside the wall, with the line between them in each part of the turn](../images/turning-plane.svg)

                The checker does not trust the drawing. A corner of the cart goes around the circle, and its product with the line's normal is a
                quadratic in the tangent of half the angle; that this quadratic is negative from the beginning of the part to its end
                is decided in exact numbers.
                """.formatted(ROUNDS, rows);
    }

    /** The turn of a cart beside a wall, near enough that no single plane does. */
    private static String turn() throws IOException {
        List<GeometryObject> objects = new ArrayList<>(
                WorldReader.read(Path.of("worlds", "rooms.xml")).toGeometry().objects());
        GeometryObject cart = objects.stream()
                .filter(object -> object.isMoveable() && object instanceof BoxObject)
                .findFirst()
                .orElseThrow();
        GeometryObject wall = objects.stream()
                .filter(object -> object.center().x() == 4 && object.center().z() == -1.6)
                .findFirst()
                .orElseThrow();
        for (int k = 0; k < 400; k++) {
            Point place = new Point(6.35, cart.center().y(), -1.2 + 0.01 * (k % 10));
            GeometryObject at = cart.at(Pose.of(place, 9.0 * (k / 10)));
            Prover prover = new Prover(new Scene(List.of(wall), Dimension.PLANAR, null));
            Attempt attempt = prover.turn(at, -1, new Point(0, 1, 0), StrictMath.tan(Math.toRadians(70) / 2));
            List<double[]> slabs = attempt.proof() == null ? List.of() : slabs(attempt.proof());
            if (slabs.size() == 3) {
                return new TurnPicture((BoxObject) at, (BoxObject) wall, slabs).svg();
            }
        }
        throw new IllegalStateException("the cart must have a turn with a few planes");
    }

    private static List<double[]> slabs(Proof proof) {
        List<double[]> slabs = new ArrayList<>();
        Matcher each = SLAB.matcher(proof.json().replaceFirst(".*\"slabs\":", ""));
        while (each.find()) {
            slabs.add(Arrays.stream(each.group(1).split(","))
                    .mapToDouble(Double::parseDouble)
                    .toArray());
        }
        return slabs;
    }

    /** One panel for each plane. */
    private record TurnPicture(BoxObject cart, BoxObject wall, List<double[]> slabs) {
        private static final double SCALE = 110;
        private static final double WIDTH = 260;
        private static final double HEIGHT = 300;

        String svg() {
            StringBuilder svg = new StringBuilder(String.format(
                    Locale.ROOT,
                    "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" font-family=\"sans-serif\" font-size=\"13\">%n"
                            + "<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>%n",
                    slabs.size() * WIDTH,
                    HEIGHT));
            for (int k = 0; k < slabs.size(); k++) {
                panel(svg, k);
            }
            return svg.append("</svg>\n").toString();
        }

        private void panel(StringBuilder svg, int number) {
            double[] slab = slabs.get(number);
            double from = 2 * StrictMath.toDegrees(StrictMath.atan(slab[2]));
            double to = 2 * StrictMath.toDegrees(StrictMath.atan(slab[3]));
            svg.append(String.format(
                    Locale.ROOT,
                    "<svg x=\"%.0f\" width=\"%.0f\" height=\"%.0f\">%n<rect x=\"4\" y=\"4\" width=\"%.0f\" height=\"%.0f\" fill=\"#f6f7f9\"/>%n",
                    number * WIDTH,
                    WIDTH,
                    HEIGHT,
                    WIDTH - 8,
                    HEIGHT - 8));
            polygon(svg, corners(wall, 0), "#5b6470", "#5b6470", 1);
            for (int k = 0; k <= 4; k++) {
                double turned = from + (to - from) * k / 4;
                polygon(svg, corners(cart, turned), "#e08a1e", "#a05a00", k == 0 || k == 4 ? 0.45 : 0.18);
            }
            double nx = slab[4];
            double nz = slab[6];
            double length = Math.hypot(nx, nz);
            // Through the nearest point of the wall.
            double bound = Double.POSITIVE_INFINITY;
            double[] at = new double[2];
            for (double[] c : corners(wall, 0)) {
                double product = nx * c[0] + nz * c[1];
                if (product < bound) {
                    bound = product;
                    at = c;
                }
            }
            double[] p = place(at[0] - 9 * nz / length, at[1] + 9 * nx / length);
            double[] q = place(at[0] + 9 * nz / length, at[1] - 9 * nx / length);
            svg.append(String.format(
                    Locale.ROOT,
                    "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#c0182b\" stroke-width=\"2\"/>%n",
                    p[0],
                    p[1],
                    q[0],
                    q[1]));
            svg.append(String.format(
                    Locale.ROOT,
                    "<text x=\"14\" y=\"26\">plane %d: from %.0f° to %.0f°</text>%n"
                            + "<text x=\"14\" y=\"%.0f\" fill=\"#5b6470\">wall</text>%n</svg>%n",
                    number + 1,
                    from,
                    to,
                    place(0, -1.85)[1]));
        }

        /** East is right, and Z goes down. */
        private double[] place(double x, double z) {
            return new double[] {
                WIDTH / 2 + SCALE * (x - cart.center().x()),
                HEIGHT / 2 + 15 + SCALE * (z - cart.center().z())
            };
        }

        private static List<double[]> corners(BoxObject box, double turned) {
            double[] r = box.turned(0, turned).rotation();
            List<double[]> corners = new ArrayList<>();
            for (int k = 0; k < 4; k++) {
                double u = (k == 0 || k == 3 ? -0.5 : 0.5) * box.width();
                double v = (k < 2 ? -0.5 : 0.5) * box.length();
                corners.add(new double[] {
                    box.center().x() + r[0] * u + r[2] * v, box.center().z() + r[6] * u + r[8] * v
                });
            }
            return Collections.unmodifiableList(corners);
        }

        private void polygon(StringBuilder svg, List<double[]> corners, String fill, String stroke, double opacity) {
            svg.append("<polygon points=\"");
            for (double[] c : corners) {
                double[] p = place(c[0], c[1]);
                svg.append(String.format(Locale.ROOT, "%.1f,%.1f ", p[0], p[1]));
            }
            svg.append(String.format(
                    Locale.ROOT, "\" fill=\"%s\" fill-opacity=\"%.2f\" stroke=\"%s\"/>%n", fill, opacity, stroke));
        }
    }
}
