package robosim.geometry.world;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.xml.XMLConstants;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import javax.xml.validation.ValidatorHandler;
import org.jspecify.annotations.Nullable;
import org.xml.sax.SAXException;
import robosim.geometry.exact.Checks;

/**
 * Reads a world from XML. The format is that of the schema {@code world.xsd}; docs/world-format.md explains it.
 *
 * <p>An untrusted file is safe to read: document types and entities are refused and no address is followed, mesh files
 * are read only from the world file's own folder tree, and files that are too large, or too deep or long in any part,
 * are refused. A world is read completely or not at all.
 *
 * <pre>{@code
 * String xml = """
 *         <world xmlns="urn:robosim:world:1" width="10" height="4" length="10" unit="m">
 *           <box name="wall" center="2 0 0" width="10cm" height="2" length="4"/>
 *         </world>""";
 * World world = WorldReader.read(new ByteArrayInputStream(xml.getBytes("UTF-8")), "here", null);
 * world.objects().size(); // 1
 * String fault = "";
 * try {
 *     WorldReader.read(new ByteArrayInputStream(xml.replace("10cm", "-1").getBytes("UTF-8")), "here", null);
 * } catch (WorldException e) {
 *     fault = e.getMessage();
 * }
 * fault.startsWith("here:2:"); // true: it names line and column, and what should be there
 * }</pre>
 */
public final class WorldReader {
    private static final int MOST_WARNINGS = 10;
    private static final System.Logger LOG = System.getLogger(WorldReader.class.getPackageName());

    private WorldReader() {}

    /**
     * Reads a world file of any format that {@link WorldImport#read} knows, with its default options. Each part of a
     * file of another format that is left out is logged as a warning to the system logger of this package.
     *
     * @throws WorldException naming file, line, column and remedy, where the file cannot be read or is no world
     */
    public static World read(Path file) throws WorldException {
        WorldImport imported = WorldImport.read(file, ImportOptions.DEFAULT);
        List<Skipped> skipped = imported.skipped();
        for (Skipped each : skipped.subList(0, Math.min(MOST_WARNINGS, skipped.size()))) {
            LOG.log(System.Logger.Level.WARNING, each);
        }
        if (skipped.size() > MOST_WARNINGS) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    () -> file + ": left out " + (skipped.size() - MOST_WARNINGS) + " more, which convert names");
        }
        return imported.world();
    }

    /** Reads a world of this module's own format. */
    static World readXml(Path file) throws WorldException {
        try (InputStream in = RegularFile.open(file)) {
            return read(in, file.toString(), file.toAbsolutePath().getParent());
        } catch (IOException e) {
            throw WorldException.unreadable(file, e);
        }
    }

    /**
     * Reads a world from a stream, which is left open.
     *
     * @param source the name of the stream in messages
     * @param base   the folder in whose tree mesh files are looked up; null if the stream may not refer to any
     * @throws WorldException naming source, line, column and remedy, where the stream fails or holds no world
     */
    public static World read(InputStream in, String source, @Nullable Path base) throws WorldException {
        Checks.present("in", in);
        Checks.present("source", source);
        return parse(in, source, base, null).world();
    }

    /**
     * All problems of a world file, in the order of its lines: {@link #read(Path)} stops at the first, this method
     * reads on as far as it can, up to 100 problems. Empty if the file is a valid world.
     */
    public static List<WorldException> problems(Path file) {
        return problems(file, ImportOptions.DEFAULT);
    }

    /** All problems of a world file of any format, read as {@link WorldImport#read} does. */
    public static List<WorldException> problems(Path file, ImportOptions options) {
        Checks.present("file", file);
        Checks.present("options", options);
        try {
            WorldImport.read(file, options);
            return List.of();
        } catch (WorldException first) {
            List<WorldException> problems = new ArrayList<>();
            try (InputStream in = RegularFile.open(file)) {
                parse(in, file.toString(), file.toAbsolutePath().getParent(), problems);
            } catch (WorldException last) {
                problems.add(last);
            } catch (IOException e) {
                return List.of(first);
            }
            // A file of another format would only give misleading problems.
            boolean same = !problems.isEmpty()
                    && String.valueOf(first.getMessage()).equals(problems.get(0).getMessage());
            return same ? List.copyOf(problems) : List.of(first);
        }
    }

    private static WorldHandler parse(
            InputStream in, String source, @Nullable Path base, @Nullable List<WorldException> problems)
            throws WorldException {
        ValidatorHandler validator = SchemaHolder.SCHEMA.newValidatorHandler();
        WorldHandler handler = new WorldHandler(source, base, validator, problems);
        try {
            validator.setProperty(SafeXml.LOCALE, Locale.ROOT);
            XmlGuard.parse(new BufferedInputStream(in), source, handler);
            return handler;
        } catch (SAXException e) {
            if (e.getException() instanceof WorldException refusal) {
                throw refusal;
            }
            throw new WorldException(source, handler.line(), handler.column(), "the XML was refused: " + e, e);
        } catch (WorldException e) {
            throw e;
        } catch (IOException e) {
            throw new WorldException(
                    source, handler.line(), handler.column(), "the file could not be read: " + e.getMessage(), e);
        }
    }

    /** Loaded when the first world is read. */
    private static final class SchemaHolder {
        static final Schema SCHEMA = load();

        private static Schema load() {
            URL resource = WorldReader.class.getResource("world.xsd");
            if (resource == null) {
                throw new IllegalStateException("world.xsd is missing beside the classes of robosim.geometry.world");
            }
            try {
                SchemaFactory factory = SchemaFactory.newDefaultInstance();
                factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
                factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
                factory.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
                return factory.newSchema(resource);
            } catch (SAXException e) {
                throw new IllegalStateException("world.xsd is no schema: " + e.getMessage(), e);
            }
        }
    }
}
