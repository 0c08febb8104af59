package robosim.geometry.world;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javax.xml.validation.ValidatorHandler;
import org.jspecify.annotations.Nullable;
import org.xml.sax.SAXException;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Floor;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Placement;
import robosim.geometry.world.shared.RegularFile;
import robosim.geometry.world.xml.SafeXml;
import robosim.geometry.world.xml.WorldSchema;

/**
 * The module's own format: how its files are opened, checked against the schema and read, with the files that they
 * include, each of which is read once.
 */
final class XmlWorld implements WorldHandler.Includes {
    /**
     * A world that was read.
     *
     * @param read    number of elements that were read
     * @param skipped what is missing of included files
     * @param remarks what a user should know of them
     */
    record Found(World world, String format, Map<String, Integer> read, Set<Skipped> skipped, Set<String> remarks) {}

    /** Reads a file of another format, with folders of models. */
    @FunctionalInterface
    interface Others {
        Found read(Path file, List<Path> folders) throws WorldException;
    }

    /** The folders in whose trees included files lie: that of the world that is read, and those of models. */
    private final List<Path> folders = new ArrayList<>();

    private final Others others;
    private final boolean hasModels;

    /** The files that are being read, each of which includes the next, as they are named to users. */
    private final Map<Path, String> open = new LinkedHashMap<>();

    private final Map<Path, Found> known = new HashMap<>();
    private final Set<Skipped> skipped = new LinkedHashSet<>();
    private final Set<String> remarks = new LinkedHashSet<>();
    private final Map<String, Integer> read = new HashMap<>();
    private long bytes;

    private XmlWorld(@Nullable Path base, List<Path> models, Others others) {
        this.others = others;
        hasModels = !models.isEmpty();
        if (base != null) {
            folders.add(base);
        }
        folders.addAll(models);
    }

    static Found read(Path file, List<Path> models, Others others) throws FileProblem {
        try (InputStream in = RegularFile.open(file)) {
            Path base = file.toAbsolutePath().getParent();
            XmlWorld reader = new XmlWorld(base, models, others);
            reader.open.put(file.toRealPath(), String.valueOf(file.getFileName()));
            World world = reader.parse(in, file.toString(), base, null).world();
            reader.read.put("object", world.objects().size());
            return new Found(world, "world", reader.read, reader.skipped, reader.remarks);
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
    }

    static World read(InputStream in, String source, @Nullable Path base, Others others) throws FileProblem {
        return new XmlWorld(base, List.of(), others)
                .parse(in, source, base, null)
                .world();
    }

    /** All problems of a file, as far as it can be read; fails if it cannot be opened. */
    static List<FileProblem> problems(Path file, List<Path> models, Others others) throws IOException {
        List<FileProblem> problems = new ArrayList<>();
        try (InputStream in = RegularFile.open(file)) {
            Path base = file.toAbsolutePath().getParent();
            XmlWorld reader = new XmlWorld(base, models, others);
            reader.open.put(file.toRealPath(), String.valueOf(file.getFileName()));
            reader.parse(in, file.toString(), base, problems);
        } catch (FileProblem last) {
            problems.add(last);
        }
        return problems;
    }

    /**
     * The objects of a file that an element names, where the element puts them.
     *
     * @param base the folder of the file with the element; null if it has none
     * @throws IllegalArgumentException saying what is wrong with the element or with that file
     */
    @Override
    public List<WorldObject> include(Element element, @Nullable Path base, Placement place, World outer)
            throws FileProblem {
        Found included = included(locate(element.attribute("file", ""), base));
        Unit unit = outer.unit();
        Unit other = included.world().unit();
        if (unit != null && other != null && unit != other) {
            throw new IllegalArgumentException("an included file must have the unit of the world, " + unit.symbol()
                    + "; convert one of them (got: " + other.symbol() + ")");
        }
        String given = element.attribute("prefix"); // spaces at its end count
        String prefix = given == null ? "" : given;
        // A plane that an element tilts is no floor.
        boolean isSdf = included.format().equals(SdfReader.FORMAT) && place.isUpright();
        List<WorldObject> objects = new ArrayList<>(included.world().objects().size());
        for (WorldObject each : included.world().objects()) {
            FileWork.take(1);
            if (isSdf
                    && Floor.isFloor(
                            each.object(),
                            included.world().width(),
                            included.world().length())) {
                floor(each, place, outer).ifPresent(floor -> objects.add(placed(floor, Placement.NONE, prefix)));
            } else {
                objects.add(placed(each, place, prefix));
            }
        }
        return objects;
    }

    /** An infinite ground as the floor of the outer world; none where it lies below that, or heights do not count. */
    private static Optional<WorldObject> floor(WorldObject given, Placement place, World outer) {
        if (outer.dimension() == Dimension.PLANAR) {
            return Optional.empty();
        }
        BoxObject floor = Floor.within(
                (BoxObject) given.object(), place.origin().y(), outer.width(), outer.height(), outer.length());
        return Optional.ofNullable(floor).map(box -> new WorldObject(box, given.color(), given.sonars(), given.body()));
    }

    private static WorldObject placed(WorldObject given, Placement place, String prefix) {
        GeometryObject object = given.object();
        String name = object.name();
        Point origin = place.origin();
        if (!(place.isShift() && origin.equals(new Point()))) {
            object = place.isShift()
                    ? object.movedTo(new Point(
                            object.center().x() + origin.x(),
                            object.center().y() + origin.y(),
                            object.center().z() + origin.z()))
                    : object.at(place.then(Placement.of(object.pose())).pose());
        }
        if (name != null && !prefix.isEmpty()) {
            object = object.isMoveable() ? object.moveable(prefix + name) : object.named(prefix + name);
        }
        String attached = given.attached() == null ? null : prefix + given.attached();
        return new WorldObject(object, given.color(), given.sonars(), given.body(), attached);
    }

    /** A file that exists and lies in the tree of one of the folders, also after following links. */
    private Path locate(String file, @Nullable Path base) throws FileProblem {
        if (base == null) {
            throw new IllegalArgumentException(
                    "a world from a stream without a folder cannot include files (got: " + file + ")");
        }
        try {
            if (file.indexOf('\\') >= 0 || Path.of(file).isAbsolute()) {
                throw outside(file);
            }
            int scheme = file.indexOf("://");
            List<Path> candidates = new ArrayList<>();
            if (scheme < 0) {
                candidates.add(base.resolve(file).normalize());
            }
            for (Path folder : folders) {
                candidates.add(folder.resolve(scheme < 0 ? file : file.substring(scheme + 3))
                        .normalize());
            }
            for (Path candidate : candidates) {
                if (Files.exists(candidate)) {
                    return within(candidate.toRealPath(), file);
                }
            }
            throw new IllegalArgumentException("there is no such file in " + base
                    + (!hasModels ? "" : ", nor below a folder of models")
                    + "; check the path (got: " + file + ")");
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException("file must be a path (got: " + file + ")", e);
        } catch (IOException e) {
            throw FileProblem.unreadable(base.resolve(file), e);
        }
    }

    private Path within(Path real, String file) throws IOException {
        for (Path folder : folders) {
            if (real.startsWith(folder.toRealPath())) {
                return real;
            }
        }
        throw outside(file);
    }

    private static IllegalArgumentException outside(String file) {
        return new IllegalArgumentException("file must be a path with / relative to the world file's folder, and lie"
                + " below the folder of the world that is read, or below one of models (got: " + file + ")");
    }

    private Found included(Path real) throws FileProblem {
        Found before = known.get(real);
        if (before != null) {
            return before;
        }
        String name = shown(real);
        if (open.containsKey(real)) {
            throw new IllegalArgumentException("a world must not include itself; remove one of these (got: "
                    + String.join(", which includes ", open.values()) + ", which includes " + name + ")");
        }
        if (open.size() > Limits.MAX_GROUPS) {
            throw new IllegalArgumentException(
                    "files must be included at most " + Limits.MAX_GROUPS + " deep; nest less (got: one more)");
        }
        Found made;
        open.put(real, name);
        try {
            bytes += Files.isRegularFile(real) ? Files.size(real) : 0;
            if (bytes > Limits.MAX_INCLUDED_BYTES) {
                throw new IllegalArgumentException("all included files must have at most " + Limits.MAX_INCLUDED_BYTES
                        + " bytes together; simplify some, or leave some out (got: more, with " + name + ")");
            }
            made = name.toLowerCase(Locale.ROOT).endsWith(".xml")
                    ? nested(real, name)
                    : others.read(real, List.copyOf(folders));
        } catch (WorldException | FileProblem e) {
            throw new IllegalArgumentException(String.valueOf(e.getMessage()), e);
        } catch (IOException e) {
            throw FileProblem.unreadable(real, e);
        } finally {
            open.remove(real);
        }
        known.put(real, made);
        skipped.addAll(made.skipped());
        remarks.addAll(made.remarks());
        read.merge("included " + made.format(), 1, Integer::sum);
        return made;
    }

    /** A file's path as it is told to users: relative to the world that is read, if it lies below its folder. */
    private String shown(Path real) throws FileProblem {
        try {
            Path first = folders.get(0).toRealPath();
            return real.startsWith(first) ? first.relativize(real).toString() : real.toString();
        } catch (IOException e) {
            throw FileProblem.unreadable(folders.get(0), e);
        }
    }

    private Found nested(Path file, String name) throws IOException {
        try (InputStream in = RegularFile.open(file)) {
            World world = parse(in, name, file.getParent(), null).world();
            return new Found(world, "world", Map.of(), Set.of(), Set.of());
        }
    }

    private WorldHandler parse(InputStream in, String source, @Nullable Path base, @Nullable List<FileProblem> problems)
            throws FileProblem {
        ValidatorHandler validator = WorldSchema.get().newValidatorHandler();
        try {
            validator.setProperty(SafeXml.LOCALE, Locale.ROOT);
        } catch (SAXException e) {
            throw new IllegalStateException("the JDK's validator takes a locale", e);
        }
        WorldHandler handler = new WorldHandler(source, base, validator, problems, this);
        SafeXml.parse(new BufferedInputStream(in), source, handler);
        return handler;
    }
}
