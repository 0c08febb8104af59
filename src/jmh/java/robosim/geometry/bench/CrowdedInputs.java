package robosim.geometry.bench;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;

/**
 * Flat scenes that are not even, in the format of {@link PeerInputs}: crowds with nothing between them, corridors between
 * long rows of wall pieces with doors, sizes from hundredths to tens, one huge wall among specks. Each goes into a folder
 * of its own, where {@link Peers} finds 100 to 100,000 objects of it.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test
 * -Dexec.mainClass=robosim.geometry.bench.CrowdedInputs -Dexec.args=FOLDER}; then {@link Peers} with
 * {@code -Dpeers=FOLDER/clusters -Dengines=FOLDER_OF_ENGINES/bin -Dwork=W1a -Dsizes=100000}. What the program
 * {@code reference} prints of a folder is its truth if it is put there as {@code data/truth.txt}.
 */
public final class CrowdedInputs {
    private static final int QUERIES = 50_000;
    private static final double RANGE = 100;
    private static final double PROBE = 0.5;
    private static final int[] SIZES = {100, 1000, 10_000, 100_000};

    private final int count;
    private final double side;
    private final SplittableRandom random;
    private final List<double[]> boxes = new ArrayList<>();
    private final List<double[]> discs = new ArrayList<>();

    private CrowdedInputs(int count) {
        this.count = count;
        side = 10 * Math.sqrt(count);
        random = new SplittableRandom(9000 + count);
    }

    /** Writes all of them to the folder that is named. */
    public static void main(String[] args) throws IOException {
        Path folder = Path.of(args[0]);
        for (String name : List.of("clusters", "corridors", "mixed", "huge")) {
            Path data = Files.createDirectories(folder.resolve(name).resolve("data"));
            Files.createDirectories(folder.resolve(name).resolve("results"));
            for (int size : SIZES) {
                new CrowdedInputs(size).write(name, data, size, QUERIES);
            }
            // The engines ask for this one too.
            new CrowdedInputs(1).write(name, data, 1_000_000, 1);
        }
    }

    private void write(String name, Path data, int size, int queries) throws IOException {
        Supplier<double[]> place = switch (name) {
            case "clusters" -> clusters();
            case "corridors" -> corridors();
            case "mixed" -> mixed();
            default -> huge();
        };
        ByteBuffer out = ByteBuffer.allocate(24 + 40 * boxes.size() + 24 * discs.size() + 64 * queries)
                .order(ByteOrder.LITTLE_ENDIAN);
        out.putInt(boxes.size()).putInt(discs.size()).putInt(queries).putInt(queries);
        put(out, side);
        boxes.forEach(box -> put(out, box));
        discs.forEach(disc -> put(out, disc));
        for (int k = 0; k < queries; k++) {
            double[] start = place.get();
            double angle = random.nextDouble(-Math.PI, Math.PI);
            put(out, start[0], start[1], StrictMath.cos(angle), StrictMath.sin(angle), RANGE);
        }
        for (int k = 0; k < queries; k++) {
            double[] center = place.get();
            put(out, center[0], center[1], PROBE);
        }
        Files.write(data.resolve("scene2d_" + size + ".bin"), out.array());
    }

    private static void put(ByteBuffer out, double... numbers) {
        for (double number : numbers) {
            out.putDouble(number);
        }
    }

    private double[] anywhere() {
        return new double[] {random.nextDouble(side), random.nextDouble(side)};
    }

    /** A box or, three times in ten, a disc, of about that size. */
    private void thing(double x, double z, double size) {
        if (random.nextDouble() < 0.7) {
            double yaw = random.nextBoolean() ? 0 : random.nextDouble(-Math.PI, Math.PI);
            double halfX = size * random.nextDouble(0.3, 1.5);
            boxes.add(new double[] {x, z, halfX, size * random.nextDouble(0.3, 1.5), yaw});
        } else {
            discs.add(new double[] {x, z, size * random.nextDouble(0.3, 1)});
        }
    }

    /** A thousand to a crowd, and nothing between the crowds; rays pass between the members. */
    private Supplier<double[]> clusters() {
        int crowds = Math.max(1, count / 1000);
        double radius = 0.05 * side / Math.sqrt(crowds);
        List<double[]> middles = new ArrayList<>();
        for (int k = 0; k < crowds; k++) {
            middles.add(anywhere());
        }
        for (int k = 0; k < count; k++) {
            double[] at = beside(middles, radius);
            thing(at[0], at[1], 0.3 * radius * Math.sqrt((double) crowds / count));
        }
        return () -> random.nextBoolean() ? anywhere() : beside(middles, 2 * radius);
    }

    // Denser towards the middle.
    private double[] beside(List<double[]> middles, double radius) {
        double[] middle = middles.get(random.nextInt(middles.size()));
        double angle = random.nextDouble(-Math.PI, Math.PI);
        double away = radius * random.nextDouble();
        return new double[] {middle[0] + away * StrictMath.cos(angle), middle[1] + away * StrictMath.sin(angle)};
    }

    /** Rows of wall pieces 2 long, four units from each other, with a door now and then and a pillar in the way. */
    private Supplier<double[]> corridors() {
        double gap = 4;
        double length = 2;
        int row = (int) Math.ceil(Math.sqrt(count * gap / length));
        for (int k = 0; k < count; k++) {
            double x = (k % row + 0.5) * length;
            double z = (k / row + 0.5) * gap;
            if (random.nextDouble() < 0.08) {
                discs.add(new double[] {x, z + gap * random.nextDouble(), 0.2}); // a door, and a pillar
            } else {
                boxes.add(new double[] {x, z, 0.5 * length, 0.1, 0});
            }
        }
        double width = row * length;
        double depth = Math.ceil((double) count / row) * gap;
        return () -> new double[] {random.nextDouble(width), random.nextDouble(depth)};
    }

    /** Sizes from 0.02 to 50, most of them small. */
    private Supplier<double[]> mixed() {
        for (int k = 0; k < count; k++) {
            double[] at = anywhere();
            thing(at[0], at[1], Math.min(50, 0.02 * StrictMath.pow(random.nextDouble(), -0.8)));
        }
        return this::anywhere;
    }

    /** One wall through all of the place, aslant, and specks. */
    private Supplier<double[]> huge() {
        boxes.add(new double[] {0.5 * side, 0.5 * side, 0.45 * side, 0.02 * side, 0.4});
        for (int k = 1; k < count; k++) {
            double[] at = anywhere();
            thing(at[0], at[1], 0.05);
        }
        return this::anywhere;
    }
}
