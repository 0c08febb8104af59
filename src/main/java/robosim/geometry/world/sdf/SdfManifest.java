package robosim.geometry.world.sdf;

import java.io.CharConversionException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.xml.SafeXml;
import robosim.geometry.world.xml.XmlHandler;

/** The file model.config of a model's folder, which names the model's file: that of the highest version. */
public final class SdfManifest extends XmlHandler {
    /** Its name in each folder. */
    public static final String NAME = "model.config";

    /** The model's default file. */
    static final String DEFAULT = "model.sdf";

    private final StringBuilder text = new StringBuilder();
    private int depth;
    private boolean named;
    private int version;
    private int best = -1;
    private @Nullable String model;

    /** Whether it is not well-formed XML. */
    private boolean broken;

    private SdfManifest(Path file) {
        super(file.toString());
    }

    /**
     * The name of the model's file. If the XML is not well-formed, as in many descriptions with an unescaped {@code &},
     * it is the name found before the error, or model.sdf if that exists.
     *
     * @param remarks receives remarks
     */
    static String read(Path file, Consumer<String> remarks) throws FileProblem {
        Deque<SdfManifest> attempts = new ArrayDeque<>();
        SdfManifest manifest;
        try {
            manifest = parse(file, attempts, remarks);
        } catch (FileProblem e) {
            manifest = attempts.peekLast();
            if (manifest == null || !manifest.broken) {
                throw e;
            }
            if (manifest.model == null && Files.isRegularFile(file.resolveSibling(DEFAULT))) {
                manifest.model = DEFAULT;
            }
            if (manifest.model == null) {
                throw e;
            }
            remarks.accept(e.getMessage() + "; only the name of the model's file matters here, and " + manifest.model
                    + " was used");
        }
        if (manifest.model == null || !Files.isRegularFile(file.resolveSibling(manifest.model))) {
            String named = manifest.model == null ? "no file" : manifest.model + ", which is not there";
            if (Files.isRegularFile(file.resolveSibling(DEFAULT))) {
                manifest.model = DEFAULT;
                remarks.accept(file + ": it names " + named + "; " + DEFAULT + " was used");
            }
        }
        if (manifest.model == null) {
            throw new FileProblem(
                    file.toString(), "<model> must have <sdf version=\"1.x\"> with a file's name (got: none)");
        }
        return manifest.model;
    }

    private static SdfManifest parse(Path file, Deque<SdfManifest> attempts, Consumer<String> remarks)
            throws FileProblem {
        try {
            return SafeXml.parseLeniently(
                    file,
                    file.toString(),
                    () -> {
                        attempts.add(new SdfManifest(file));
                        return attempts.getLast();
                    },
                    remarks);
        } catch (FileProblem e) {
            if (e.getCause() instanceof CharConversionException) { // invalid bytes
                attempts.getLast().broken = true;
            }
            throw e;
        }
    }

    /** The minor number of a version 1.x; -1 if it is not such a version. */
    static int minor(String version) {
        if (!version.matches("1\\.\\d{1,3}")) {
            return -1;
        }
        return Integer.parseInt(version.substring(2));
    }

    @Override
    public void startElement(String uri, String local, String name, Attributes attributes) {
        depth++;
        named = depth == 2 && name.equals("sdf");
        if (named) {
            String given = attributes.getValue("version");
            version = given == null ? 0 : Math.max(0, minor(given.strip()));
            text.setLength(0);
        }
    }

    @Override
    public void characters(char[] characters, int start, int length) {
        if (named && text.length() <= Limits.MAX_ATTRIBUTE) {
            text.append(characters, start, length);
        }
    }

    @Override
    public void endElement(String uri, String local, String name) {
        if (named && version > best && text.length() <= Limits.MAX_ATTRIBUTE) {
            best = version;
            model = text.toString().strip();
        }
        named = false;
        depth--;
    }

    @Override
    public void fatalError(SAXParseException e) throws SAXException {
        broken = true;
        super.fatalError(e);
    }
}
