package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.WorldAnswer;

/** Reads world files for peers. */
@FunctionalInterface
public interface WorldLoader {
    /** Reads none. */
    WorldLoader NONE = load -> {
        Checks.present("load", load);
        throw new IOException("this module loads no world files for its peers; send the objects in an init, or start it"
                + " with `serve` (got: " + Text.quoted(load.file()) + ")");
    };

    /**
     * Reads a world.
     *
     * @throws IOException for people, if it cannot be read; the world that there is stays
     */
    Loaded load(Load load) throws IOException;

    /**
     * Reads a world, and counts its work, so that it can be limited and cancelled. Unless a loader overrides this method, it
     * counts nothing.
     *
     * @param work is given units of work as they are done, as {@code WorkLimit} takes them; what it throws ends the
     *     reading, and is thrown here
     */
    default Loaded load(Load load, LongConsumer work) throws IOException {
        return load(load);
    }

    /**
     * Asks for a new world from a file: what a JSON peer sends as a {@code load}. It is no bundle: a {@link WorldLoader} makes bundles
     * of it.
     *
     * @param file     the file: of {@code files}, or if there are none a path within the folder that the module's operator
     *                 allows
     * @param files    the contents of the file and of those that it refers to, by their paths relative to a common folder
     * @param settings replace the file's own where they are given; null for none
     * @param isNaming whether objects without a name get one
     */
    record Load(
            String file,
            Map<String, byte[]> files,
            @Nullable WorldSettings settings,
            boolean isNaming) {
        /** Refuses null. */
        public Load {
            Checks.present("file", file);
            files = Map.copyOf(Checks.present("files", files));
        }
    }

    /**
     * A world from a file, as requests.
     *
     * @param requests an InitBundle first, then perhaps steps of no time that give bodies
     * @param bytes    how many bytes their messages would have, by which memory is claimed
     * @param leftOut  what the file has and the world has not
     */
    record Loaded(List<Bundle> requests, int bytes, List<WorldAnswer.LeftOut> leftOut) {
        /** Refuses null, and a list that does not begin with an InitBundle. */
        public Loaded {
            requests = Checks.copy("requests", requests, Bundle.class);
            leftOut = Checks.copy("leftOut", leftOut, WorldAnswer.LeftOut.class);
            if (requests.isEmpty() || !(requests.get(0) instanceof InitBundle)) {
                throw new IllegalArgumentException(
                        "requests must begin with an InitBundle (got: " + requests.size() + " requests)");
            }
        }
    }
}
