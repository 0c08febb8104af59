package robosim.geometry.scenario;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldReader;

/** Reads the worlds that a scenario's file names, relative to its folder and only from within a root. */
final class WorldFiles {
    private final @Nullable Path folder;
    private final @Nullable Path root;

    private WorldFiles(@Nullable Path folder, @Nullable Path root) {
        this.folder = folder;
        this.root = root;
    }

    /** Refuses every name. */
    static WorldFiles none() {
        return new WorldFiles(null, null);
    }

    /** Looks up names relative to a scenario's folder. */
    static WorldFiles beside(Path scenario, Path root) {
        return new WorldFiles(scenario.toAbsolutePath().getParent(), root);
    }

    /** Reads a world file as a request for its world; the exception says why it cannot be read. */
    InitBundle read(String name) throws IOException {
        if (folder == null || root == null) {
            throw new IOException("a world file can only be named in a file (got: " + name + ")");
        }
        World world = WorldReader.read(inside(folder, root, name));
        try {
            world.toGeometry();
        } catch (IllegalArgumentException e) {
            throw new IOException("the world of " + name + " cannot be: " + e.getMessage(), e);
        }
        WorldSettings settings =
                new WorldSettings(world.width(), world.height(), world.length(), world.dimension(), world.accuracy());
        return new InitBundle(world.joined(), settings);
    }

    private static Path inside(Path folder, Path root, String name) throws IOException {
        Path file;
        try {
            file = folder.resolve(name).normalize();
        } catch (InvalidPathException e) {
            throw new IOException("file must be the path of a world file (got: " + name + ")", e);
        }
        Path realRoot = root.toRealPath();
        if (!file.startsWith(root.toAbsolutePath().normalize()) && !file.startsWith(realRoot)) {
            throw new IOException("file must lead to a file under " + root + " (got: " + name + ")");
        }
        if (!Files.isRegularFile(file)) {
            throw new IOException("file must lead to a world file; " + file + " is none (got: " + name + ")");
        }
        if (!file.toRealPath().startsWith(realRoot)) {
            throw new IOException("file must lead to a file under " + root + ", links followed (got: " + name + ")");
        }
        return file;
    }
}
