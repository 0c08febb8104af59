package robosim.geometry.scenario.drive;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.LongConsumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.session.SessionStart;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.json.WorldLoader;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.Skipped;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.shared.FileWork;

/**
 * Reads world files for the peers of a server: what they send, and what they name within one folder. What is sent is kept in
 * a temporary folder while it is read, and nothing outside of it is opened.
 */
public final class WorldLoading implements WorldLoader, AutoCloseable {
    private static final System.Logger LOG = System.getLogger(WorldLoading.class.getPackageName());

    private final @Nullable Path folder;
    private final ImportOptions options;

    /** The files that were sent and are being read; also the lock for {@code isClosed}. */
    private final Set<Kept> kept = new HashSet<>();

    private boolean isClosed;

    private static final class Kept {
        private final Path place;
        private boolean isRemoved;

        Kept(Path place) {
            this.place = place;
        }

        synchronized void write(Path file, byte[] content) throws IOException {
            if (isRemoved) {
                throw closed();
            }
            Files.createDirectories(Objects.requireNonNull(file.getParent()));
            Files.write(file, content);
        }

        synchronized void remove() throws IOException {
            if (isRemoved) {
                return;
            }
            isRemoved = true;
            try (Stream<Path> all = Files.walk(place)) {
                for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(each);
                }
            }
        }
    }

    private WorldLoading(@Nullable Path folder, ImportOptions options) {
        this.folder = folder;
        this.options = options;
    }

    /**
     * Reads what peers send, and the files of a folder and its subfolders.
     *
     * @param folder null for none
     * @param models folders of models, as in {@link ImportOptions}
     */
    public static WorldLoading of(@Nullable Path folder, List<Path> models) {
        return new WorldLoading(folder, ImportOptions.DEFAULT.withModels(models));
    }

    @Override
    public WorldLoader.Loaded load(WorldLoader.Load load) throws IOException {
        return load(load, units -> {});
    }

    @Override
    public WorldLoader.Loaded load(WorldLoader.Load load, LongConsumer work) throws IOException {
        Checks.present("load", load);
        Checks.present("work", work);
        if (!load.files().isEmpty()) {
            return sent(load, work);
        }
        if (folder == null) {
            throw new IOException(
                    "a file must be sent with its contents, in files, unless the module was given a folder of"
                            + " worlds: serve --worlds DIR (got: " + Text.quoted(load.file()) + ")");
        }
        Path file = inside(folder, load.file());
        if (!Files.exists(file) || !file.toRealPath().startsWith(folder.toRealPath())) {
            throw new IOException("file must be in the folder of worlds that the module was given (got: "
                    + Text.quoted(load.file()) + ")");
        }
        return read(load, folder, file, work);
    }

    private WorldLoader.Loaded sent(WorldLoader.Load load, LongConsumer work) throws IOException {
        if (!load.files().containsKey(load.file())) {
            throw new IOException("file must be one of the files sent (got: " + Text.quoted(load.file()) + ")");
        }
        Kept files = keep();
        Path place = files.place;
        try {
            for (Map.Entry<String, byte[]> each : load.files().entrySet()) {
                files.write(inside(place, each.getKey()), each.getValue());
            }
            return read(load, place, inside(place, load.file()), work);
        } catch (FileSystemException e) {
            throw new IOException("the files cannot be kept as they are named: " + shown(place, e.getMessage()), e);
        } finally {
            forget(files);
        }
    }

    private void forget(Kept files) throws IOException {
        try {
            files.remove();
        } finally {
            synchronized (kept) {
                kept.remove(files);
            }
        }
    }

    private Kept keep() throws IOException {
        synchronized (kept) {
            if (isClosed) {
                throw closed();
            }
            Kept files = new Kept(Files.createTempDirectory("robosim-world"));
            kept.add(files);
            return files;
        }
    }

    private static IOException closed() {
        return new IOException("no world files are loaded any more, as the module is shutting down");
    }

    /**
     * Loads nothing more that is sent, and removes the files that are still being read: where a process ends, nobody else may
     * have the time to do so.
     */
    @Override
    public void close() {
        List<Kept> left;
        synchronized (kept) {
            isClosed = true;
            left = List.copyOf(kept);
        }
        for (Kept files : left) {
            try {
                files.remove();
            } catch (IOException e) {
                LOG.log(System.Logger.Level.WARNING, "the folder " + files.place + " could not be removed: " + e);
            }
        }
    }

    /** A path below a folder, by its names alone. */
    private static Path inside(Path root, String name) throws IOException {
        try {
            Path file = root.resolve(name).normalize();
            if (!Path.of(name).isAbsolute() && file.startsWith(root.normalize()) && !file.equals(root.normalize())) {
                return file;
            }
        } catch (InvalidPathException e) {
            throw new IOException("a file must be a relative path (got: " + Text.quoted(name) + ")", e);
        }
        throw new IOException(
                "a file must be a relative path that stays in its folder (got: " + Text.quoted(name) + ")");
    }

    private WorldLoader.Loaded read(WorldLoader.Load load, Path root, Path file, LongConsumer work) throws IOException {
        WorldImport read;
        try {
            read = FileWork.counted(work, () -> WorldImport.read(file, options));
        } catch (WorldException e) {
            throw new IOException(shown(root, e.getMessage()), e);
        }
        World world = read.world();
        work.accept(world.objects().size()); // each is named and measured below
        List<GeometryObject> objects = new ArrayList<>(world.joined());
        if (load.isNaming()) {
            name(objects);
        }
        List<Bundle> requests = new ArrayList<>(List.of(new InitBundle(objects, settings(world, load.settings()))));
        List<BodyRequest> bodies = WorldBodies.of(world);
        if (!bodies.isEmpty()) {
            requests.add(new StepBundle(0, bodies, List.of()));
        }
        List<WorldAnswer.LeftOut> leftOut = new ArrayList<>();
        for (Skipped each : read.skipped()) {
            leftOut.add(new WorldAnswer.LeftOut(objects.size(), each.what(), shown(root, each.reason())));
        }
        return new WorldLoader.Loaded(requests, SessionStart.of(requests).bytes(), leftOut);
    }

    /** Words without the folder in which the files are here, of which a peer knows nothing. */
    private static String shown(Path root, @Nullable String words) {
        return String.valueOf(words)
                .replace(root.toAbsolutePath() + "/", "")
                .replace(root + "/", "")
                .replace(root.toString(), "the folder of the world");
    }

    private static WorldSettings settings(World world, @Nullable WorldSettings given) {
        WorldSettings own =
                new WorldSettings(world.width(), world.height(), world.length(), world.dimension(), world.accuracy());
        return given == null
                ? own
                : new WorldSettings(
                        given.width() > 0 ? given.width() : own.width(),
                        given.height() > 0 ? given.height() : own.height(),
                        given.length() > 0 ? given.length() : own.length(),
                        given.dimension() == null ? own.dimension() : given.dimension(),
                        given.accuracy() == null ? own.accuracy() : given.accuracy());
    }

    /** Names objects without a name by their kind and index, as in {@code box 3}. */
    private static void name(List<GeometryObject> objects) {
        Set<String> taken = new HashSet<>();
        objects.stream().map(GeometryObject::name).filter(Objects::nonNull).forEach(taken::add);
        for (int k = 0; k < objects.size(); k++) {
            GeometryObject object = objects.get(k);
            if (object.name() == null) {
                String name = object.kind().word() + " " + k;
                while (!taken.add(name)) {
                    name += "'";
                }
                objects.set(k, object.named(name));
            }
        }
    }
}
