package robosim.geometry.world.sdf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * The address of a model of Gazebo Fuel, or of a file of one. Gazebo keeps what it has downloaded in a folder with a tree
 * {@code SERVER/OWNER/models/NAME/VERSION}, all in lower case.
 *
 * @param server  its name
 * @param owner   as in the address
 * @param name    as in the address, with spaces
 * @param version a number; empty for the newest
 * @param file    relative to the model's folder; empty for the model itself
 */
record FuelUri(String server, String owner, String name, String version, String file) {
    private static final Pattern ADDRESS =
            Pattern.compile("(?i)https?://([^/\\s]+)/+(?:\\d+\\.\\d+/+)?([^/\\s]+)/+models/+([^/]+)"
                    + "(?:/+(\\d+|tip)?(?:/+files/+(.*))?)?/*");

    /** The servers of Fuel: before and after Gazebo got its name back. A model of one is one of the other. */
    private static final List<String> SERVERS = List.of("fuel.gazebosim.org", "fuel.ignitionrobotics.org");

    /** An address, if it is one of Fuel; else null. */
    static @Nullable FuelUri of(String address) {
        Matcher found = ADDRESS.matcher(address.strip());
        if (!found.matches()) {
            return null;
        }
        String version = found.group(4) == null || found.group(4).equalsIgnoreCase("tip") ? "" : found.group(4);
        return new FuelUri(
                found.group(1).toLowerCase(Locale.ROOT),
                found.group(2),
                found.group(3).replace("%20", " "),
                version,
                found.group(5) == null ? "" : found.group(5).replace("%20", " "));
    }

    /** Whether a folder is one in which Gazebo keeps what it has downloaded. */
    static boolean isCache(Path folder) {
        return SERVERS.stream().anyMatch(server -> Files.isDirectory(folder.resolve(server)));
    }

    /** The folder of a cache in which the version of the model is, below which its file is; null if it is not there. */
    @Nullable
    Path folder(Path cache) throws IOException {
        List<String> servers = new ArrayList<>(List.of(server));
        if (SERVERS.contains(server)) {
            servers.addAll(SERVERS);
        }
        for (String each : servers) {
            Path versions = cache.resolve(each)
                    .resolve(owner.toLowerCase(Locale.ROOT))
                    .resolve("models")
                    .resolve(name.toLowerCase(Locale.ROOT));
            Path found = version.isEmpty() ? newest(versions) : versions.resolve(version);
            if (found != null && Files.isDirectory(found)) {
                return found;
            }
        }
        return null;
    }

    private static @Nullable Path newest(Path versions) throws IOException {
        if (!Files.isDirectory(versions)) {
            return null;
        }
        Path newest = null;
        try (Stream<Path> all = Files.list(versions)) {
            for (Path each : (Iterable<Path>) all::iterator) {
                if (number(each) >= 0 && (newest == null || number(each) > number(newest))) {
                    newest = each;
                }
            }
        }
        return newest;
    }

    private static int number(Path folder) {
        String name = String.valueOf(folder.getFileName());
        return name.matches("\\d{1,9}") ? Integer.parseInt(name) : -1;
    }

    /** The address of the model, as Gazebo's program for downloads takes it. */
    String address() {
        return "https://" + server + "/1.0/" + owner + "/models/" + name + (version.isEmpty() ? "" : "/" + version);
    }

    /**
     * What to do if the model is not there.
     *
     * @param caches the folders that were searched
     */
    String remedy(List<Path> caches) {
        String where = caches.isEmpty()
                ? "there is no folder of models that Gazebo has downloaded, such as ~/.gz/fuel; give it with --models"
                        + " or ImportOptions.withModels"
                : "Gazebo has not downloaded it to "
                        + String.join(", ", caches.stream().map(Path::toString).toList());
        return "network addresses are not followed, and " + where + "; download it: gz fuel download -u \"" + address()
                + "\"";
    }
}
