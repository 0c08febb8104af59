package robosim.geometry.world.sdf;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.FileKind;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Folder;
import robosim.geometry.world.shared.LeftOut;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.RegularFile;
import robosim.geometry.world.shared.TextureFiles;

/**
 * Finds the files that an SDFormat file names: relative to it, or in given model folders. Nothing outside their trees
 * is opened, and no network address is followed.
 */
public final class SdfFiles {
    /** The folders around a model of Fuel: its server, its owner, models, its name and its version. */
    private static final int FUEL_DEPTH = 5;

    private static final Pattern REMOTE = Pattern.compile("(?i)(https?|ftp|fuel)://");

    private static final Pattern PACKAGE_NAME = Pattern.compile("<name>\\s*([^<\\s]+)\\s*</name>");

    private final Path main;
    private final List<Path> folders = new ArrayList<>();
    /** Those of the folders in which Gazebo keeps what it has downloaded. */
    private final List<Path> caches = new ArrayList<>();
    /** The file of a model, by the included path: the file itself or its folder. */
    private final Map<Path, Path> models = new HashMap<>();

    private final Map<Path, SdfElement> roots = new HashMap<>();
    private final Set<Path> urdf = new HashSet<>();
    private final Map<Path, Boolean> counted = new HashMap<>();

    /** A cache of lookups, found or not: a model may be included a thousand times, and file access is slow. */
    private final Map<Name, Optional<Path>> known = new HashMap<>();

    private @Nullable Map<String, List<Path>> packages;
    private final List<String> remarks = new ArrayList<>();
    private final List<LeftOut> leftOut = new ArrayList<>();
    private final TextureFiles textures;
    private long bytes;

    private record Name(String uri, Path from) {}

    /** For an SDFormat file, with folders whose subfolders are models. */
    public SdfFiles(Path main, List<Path> given) throws FileProblem {
        try {
            this.main = main.toRealPath();
            folders.add(folder(this.main));
            for (Path folder : given) {
                folders.add(folder.toRealPath());
            }
            for (Path folder : folders) {
                if (FuelUri.isCache(folder)) {
                    caches.add(folder);
                }
            }
            Path beside = beside(folders.get(0));
            if (beside != null && !folders.contains(beside)) {
                folders.add(beside);
            }
        } catch (IOException e) {
            throw FileProblem.unreadable(main, e);
        }
        textures = new TextureFiles(folders, leftOut);
    }

    /** The pictures that its meshes name, from the same folders. */
    TextureFiles textures() {
        return textures;
    }

    /** The pictures of meshes that could not be read. */
    public List<LeftOut> leftOut() {
        return leftOut;
    }

    /** Remarks about the files, none of which means that something is missing. */
    public List<String> remarks() {
        return remarks;
    }

    private static Path folder(Path file) {
        Path folder = file.getParent();
        return folder == null ? file : folder;
    }

    /** The folder {@code models} beside {@code worlds}, as packages for Gazebo have them; null if there is none. */
    private static @Nullable Path beside(Path worlds) throws IOException {
        Path models = worlds.endsWith("worlds") ? worlds.resolveSibling("models") : null;
        return models != null && Files.isDirectory(models) ? models.toRealPath() : null;
    }

    /** The main file, under the name that the user gave. */
    public SdfElement main(String shown) throws FileProblem {
        return open(main, shown);
    }

    /** Whether the main file, which has been read, is URDF. */
    public boolean isUrdf() {
        return urdf.contains(main);
    }

    private SdfElement open(Path real, String shown) throws FileProblem {
        SdfElement known = roots.get(real);
        if (known == null) {
            SdfFile file = new SdfFile(real, folder(real), shown);
            if (shown.toLowerCase(Locale.ROOT).endsWith(".xacro")) {
                String name = String.valueOf(real.getFileName());
                throw new FileProblem(shown, Xacro.remedy(name, name.substring(0, name.length() - 6)));
            }
            if (isUrdf(file)) {
                urdf.add(real);
                known = UrdfParser.read(file, remarks::add);
            } else {
                known = SdfParser.read(file, remarks::add);
            }
            roots.put(real, known);
        }
        return known;
    }

    /** Whether a file is URDF: by its root, since Gazebo does not mind its name; by its name if the root is neither's. */
    private static boolean isUrdf(SdfFile file) {
        String root = FileKind.root(file.path());
        return "robot".equals(root) || (UrdfParser.isNamed(file) && !"sdf".equals(root) && !"gazebo".equals(root));
    }

    /** Whether a URI is a network address, which is never read. */
    static boolean isRemote(String uri) {
        return REMOTE.matcher(uri).lookingAt();
    }

    /**
     * The root element of an included model: of the file itself, or of the one that a folder's model.config names. Null
     * if it does not exist.
     */
    @Nullable
    SdfElement included(SdfElement uri) throws FileProblem {
        Path found = find(uri);
        if (found == null) {
            return null;
        }
        Path file = models.get(found);
        if (file == null) {
            file = Files.isDirectory(found) ? modelOf(found, remarks::add) : found;
            models.put(found, file);
        }
        count(uri, file);
        return open(file, file.toString());
    }

    /**
     * The file of the model in a folder.
     *
     * @param remarks receives remarks
     */
    public static Path modelOf(Path folder, Consumer<String> remarks) throws FileProblem {
        Path manifest = folder.resolve(SdfManifest.NAME);
        boolean isNamed = Files.isRegularFile(manifest);
        if (!isNamed && !Files.isRegularFile(folder.resolve(SdfManifest.DEFAULT))) {
            throw new FileProblem(
                    folder.toString(),
                    "a folder must be a model's, with " + SdfManifest.NAME + "; else name a file in it (got: none)");
        }
        try {
            String name = isNamed ? SdfManifest.read(manifest, remarks) : SdfManifest.DEFAULT;
            return Folder.locate(folder.toRealPath(), name, "model", "SDFormat");
        } catch (IllegalArgumentException e) {
            throw new FileProblem(manifest.toString(), String.valueOf(e.getMessage()), e);
        } catch (IOException e) {
            throw FileProblem.unreadable(manifest, e);
        }
    }

    /** Finds a file by name; null if it does not exist. */
    @Nullable
    Path find(SdfElement uri) throws FileProblem {
        Name name = new Name(uri.value(), uri.file.folder());
        Optional<Path> found = known.get(name);
        if (found == null) {
            found = Optional.ofNullable(search(uri));
            known.put(name, found);
        }
        return found.orElse(null);
    }

    private @Nullable Path search(SdfElement uri) throws FileProblem {
        String name = uri.value();
        if (name.isEmpty() || name.indexOf('\\') >= 0) {
            throw uri.wrong(shown(uri) + " must be a path with /, or model://NAME (got: " + name + ")");
        }
        try {
            List<Path> candidates = isRemote(name) ? downloaded(name) : candidates(name, uri.file.folder());
            String decoded = decoded(name);
            if (!isRemote(name) && !decoded.equals(name)) { // as it is written counts first
                candidates.addAll(candidates(decoded, uri.file.folder()));
            }
            for (Path candidate : candidates) {
                if (Files.exists(candidate)) {
                    Path real = candidate.toRealPath();
                    if (folders.stream().noneMatch(real::startsWith)) {
                        throw uri.wrong(
                                shown(uri) + " must refer to a file below the folder of the file being read, or below a"
                                        + " given model folder (got: " + name + ")");
                    }
                    return real;
                }
            }
            return null;
        } catch (InvalidPathException e) {
            throw uri.wrong(shown(uri) + " must be a path (got: " + name + ")");
        } catch (IOException e) {
            throw new FileProblem(uri.file.shown(), uri.line, uri.column, name + " could not be read: " + e, e);
        }
    }

    /** A name without its {@code %20} and the like; the name itself if they are none. */
    private static String decoded(String name) {
        try {
            String decoded = Folder.decoded(name);
            return decoded.indexOf('\\') < 0 ? decoded : name;
        } catch (IllegalArgumentException e) {
            return name;
        }
    }

    /** What names a file, as its format has it. */
    private String shown(SdfElement uri) {
        return urdf.contains(uri.file.path()) ? "filename of <mesh>" : "<uri>";
    }

    /** Where a file of Fuel may be: in the folders where Gazebo keeps what it has downloaded. */
    private List<Path> downloaded(String address) throws IOException {
        FuelUri wanted = FuelUri.of(address);
        List<Path> candidates = new ArrayList<>();
        if (wanted == null) {
            return candidates;
        }
        for (Path cache : caches) {
            Path folder = wanted.folder(cache);
            Path file = folder == null ? null : folder.resolve(wanted.file()).normalize();
            if (file != null && file.startsWith(folder)) {
                candidates.add(file);
            }
        }
        return candidates;
    }

    /**
     * The folder of the model of Fuel that a file is part of; null if it is of none. There, {@code model://} of any name
     * is that model: what Gazebo downloads is complete.
     */
    private @Nullable Path fuelModel(Path from) {
        for (Path cache : caches) {
            if (from.startsWith(cache)) {
                Path inner = cache.relativize(from);
                return inner.getNameCount() >= FUEL_DEPTH ? cache.resolve(inner.subpath(0, FUEL_DEPTH)) : null;
            }
        }
        return null;
    }

    /** Why a network address is left out, and what to do. */
    String remote(String address) {
        FuelUri wanted = FuelUri.of(address);
        return wanted == null
                ? "network addresses are not followed; download the model, write model://NAME, and give the folder"
                        + " that contains it"
                : wanted.remedy(caches);
    }

    /** How deep below a folder a package may be: in a repository of a workspace. */
    private static final int PACKAGE_DEPTH = 3;

    /** Entries of a folder tree that are looked at for a package. A workspace of some 100 packages has some 3,000. */
    private static final int MOST_ENTRIES = 20_000;

    /**
     * The folders of a package of ROS: one around the file that names it, so that a robot finds its own meshes, and those
     * deeper in the given folders. Both must have a package.xml, which gives the name of the package; that of the folder may be
     * another, and counts too.
     */
    private void packages(String name, String rest, Path from, List<Path> candidates) throws IOException {
        for (Path around = from; around != null; around = around.getParent()) {
            if (isPackage(around) && (name.equals(packageName(around)) || around.endsWith(name))) {
                folders.add(around);
                candidates.add(around.resolve(rest).normalize());
                return;
            }
        }
        for (Path each : packages().getOrDefault(name, List.of())) {
            candidates.add(each.resolve(rest).normalize());
        }
    }

    /** The packages below the given folders by name, looked for once. */
    private Map<String, List<Path>> packages() throws IOException {
        if (packages != null) {
            return packages;
        }
        Map<String, List<Path>> found = new HashMap<>();
        for (Path folder : folders) {
            if (caches.contains(folder)) {
                continue;
            }
            try (Stream<Path> below = Files.walk(folder, PACKAGE_DEPTH)) {
                below.limit(MOST_ENTRIES).filter(SdfFiles::isPackage).sorted().forEach(each -> {
                    String folderName = String.valueOf(each.getFileName());
                    for (String name : new LinkedHashSet<>(List.of(packageName(each), folderName))) {
                        found.computeIfAbsent(name, key -> new ArrayList<>()).add(each);
                    }
                });
            } catch (UncheckedIOException e) {
                throw e.getCause();
            }
        }
        packages = found;
        return found;
    }

    /** The name that a package gives itself; empty if that cannot be read. */
    private static String packageName(Path folder) {
        try (InputStream in = RegularFile.open(folder.resolve("package.xml"))) {
            String xml = new String(in.readNBytes(Limits.MAX_SETTINGS), StandardCharsets.UTF_8);
            Matcher name = PACKAGE_NAME.matcher(xml.replaceAll("(?s)<!--.*?-->", ""));
            return name.find() ? name.group(1) : "";
        } catch (IOException e) {
            return "";
        }
    }

    private static boolean isPackage(Path folder) {
        return Files.isRegularFile(folder.resolve("package.xml"));
    }

    private List<Path> candidates(String name, Path from) throws IOException {
        List<Path> candidates = new ArrayList<>();
        int scheme = name.indexOf("://");
        if (scheme < 0) {
            candidates.add(from.resolve(name).normalize());
            inFolders(name, candidates);
        } else if (name.startsWith("file://")) {
            String path = name.substring(scheme + 3);
            candidates.add(from.resolve(path).normalize());
            inFolders(path, candidates);
        } else {
            String rest = name.substring(scheme + 3);
            int slash = rest.indexOf('/');
            String model = slash < 0 ? rest : rest.substring(0, slash);
            Path last = from.getFileName();
            if (last != null && last.toString().equals(model)) { // a model's own files
                candidates.add(
                        from.resolve(slash < 0 ? "" : rest.substring(slash + 1)).normalize());
            }
            Path fuel = name.startsWith("model://") && slash > 0 ? fuelModel(from) : null;
            if (fuel != null) {
                candidates.add(fuel.resolve(rest.substring(slash + 1)).normalize());
            }
            candidates.add(from.resolve(rest).normalize());
            for (Path folder : folders) {
                candidates.add(folder.resolve(rest).normalize());
            }
            if (name.startsWith("package://")
                    && slash > 0
                    && candidates.stream().noneMatch(Files::exists)) {
                packages(model, rest.substring(slash + 1), from, candidates);
            }
        }
        return candidates;
    }

    /**
     * A path in each folder. It may also begin with the name of the folder itself, as Gazebo's {@code file://models/...} does,
     * which is relative to the folder around that of the models.
     */
    private void inFolders(String path, List<Path> candidates) {
        int slash = path.indexOf('/');
        for (Path folder : folders) {
            candidates.add(folder.resolve(path).normalize());
            if (slash > 0 && folder.endsWith(path.substring(0, slash))) {
                candidates.add(folder.resolve(path.substring(slash + 1)).normalize());
            }
        }
    }

    /** An exception that says where a file was searched for. */
    FileProblem missing(SdfElement uri) {
        StringBuilder searched = new StringBuilder();
        for (Path folder : folders) {
            searched.append(searched.isEmpty() ? "" : ", ").append(folder);
        }
        return uri.wrong("there is no such file or folder below " + searched + "; check the name, or give the folder"
                + " that contains the model: --models DIR, or ImportOptions.withModels (got: " + uri.value() + ")");
    }

    /** Counts the bytes of a file that is about to be read. */
    void count(SdfElement uri, Path file) throws FileProblem {
        if (counted.putIfAbsent(file, true) != null) {
            return;
        }
        try {
            bytes += Files.size(file);
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
        if (bytes > Limits.MAX_INCLUDED_BYTES) {
            throw uri.wrong("all files that an SDFormat file includes must have at most " + Limits.MAX_INCLUDED_BYTES
                    + " bytes together; simplify some, or leave some out (got: more, with " + file + ")");
        }
    }
}
