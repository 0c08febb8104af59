package robosim.geometry.sweep;

import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.sweep.lines.Names;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldReader;

/**
 * A world of a sweep, with a name.
 *
 * @param name     the name in the results, without the characters {@code /}, {@code ,} and blanks; seeds are derived
 *     from it
 * @param snapshot the world with which every replicate begins
 */
public record SweepWorld(String name, Snapshot snapshot) implements Serializable {
    private static final long serialVersionUID = 1;

    /** Refuses a name with characters that separate names. */
    public SweepWorld {
        Checks.present("snapshot", snapshot);
        Names.check("name of a world", name);
        Checks.present("snapshot", snapshot);
    }

    /**
     * Reads a world file; the world's name is that of the file without its ending.
     *
     * @throws IOException if it cannot be read or is not a world
     */
    public static SweepWorld read(Path file) throws IOException {
        Checks.present("file", file);
        return of(file, WorldReader.read(file));
    }

    /** A world that was read from a file, after which it is named as {@link #read} does. */
    public static SweepWorld of(Path file, World world) {
        Checks.present("file", file);
        Checks.present("world", world);
        return new SweepWorld(Names.of(file), world.toGeometry().snapshot());
    }

    /** This world in the dimensions and accuracies that parameters ask for, each built once for all threads. */
    static final class Views {
        private record View(int world, Dimension dimension, Accuracy accuracy) {}

        /** A world, or why it could not be made, so that it is not tried again for each replicate. */
        private record Made(
                @Nullable Snapshot snapshot, @Nullable RuntimeException failure) {}

        private final Map<View, Made> all = new ConcurrentHashMap<>();

        Snapshot of(int index, SweepWorld world, Dimension dimension, Accuracy accuracy) {
            Snapshot plain = world.snapshot();
            if (dimension == plain.dimension() && accuracy == plain.accuracy()) {
                return plain;
            }
            Made made = all.computeIfAbsent(new View(index, dimension, accuracy), view -> tried(plain, view));
            if (made.snapshot == null) {
                throw made.failure == null ? new IllegalStateException("neither a world nor a failure") : made.failure;
            }
            return made.snapshot;
        }

        private static Made tried(Snapshot from, View view) {
            try {
                return new Made(made(from, view.dimension, view.accuracy), null);
            } catch (RuntimeException e) {
                return new Made(null, e);
            }
        }

        private static Snapshot made(Snapshot from, Dimension dimension, Accuracy accuracy) {
            Geometry world = new Geometry(from.width(), from.height(), from.length(), dimension, accuracy);
            for (GeometryObject object : from.objects()) {
                Checks.refuse(
                        !world.addObjectUnchecked(object),
                        "every object must be within the world, in " + dimension + " too",
                        object);
            }
            return world.snapshot();
        }
    }
}
