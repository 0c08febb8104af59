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
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.RegularFile;
import robosim.geometry.world.xml.SafeXml;

/** The module's own format: how its files are opened, checked against the schema and read. */
final class XmlWorld {
    private XmlWorld() {}

    static World read(Path file) throws FileProblem {
        try (InputStream in = RegularFile.open(file)) {
            return read(in, file.toString(), file.toAbsolutePath().getParent());
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
    }

    static World read(InputStream in, String source, @Nullable Path base) throws FileProblem {
        return parse(in, source, base, null).world();
    }

    /** All problems of a file, as far as it can be read; fails if it cannot be opened. */
    static List<FileProblem> problems(Path file) throws IOException {
        List<FileProblem> problems = new ArrayList<>();
        try (InputStream in = RegularFile.open(file)) {
            parse(in, file.toString(), file.toAbsolutePath().getParent(), problems);
        } catch (FileProblem last) {
            problems.add(last);
        }
        return problems;
    }

    private static WorldHandler parse(
            InputStream in, String source, @Nullable Path base, @Nullable List<FileProblem> problems)
            throws FileProblem {
        ValidatorHandler validator = SchemaHolder.SCHEMA.newValidatorHandler();
        WorldHandler handler = new WorldHandler(source, base, validator, problems);
        try {
            validator.setProperty(SafeXml.LOCALE, Locale.ROOT);
            SafeXml.parse(new BufferedInputStream(in), source, handler);
            return handler;
        } catch (SAXException e) {
            if (e.getException() instanceof FileProblem refusal) {
                throw refusal;
            }
            throw new FileProblem(source, handler.line(), handler.column(), "the XML was refused: " + e, e);
        } catch (FileProblem e) {
            throw e;
        } catch (IOException e) {
            throw new FileProblem(
                    source, handler.line(), handler.column(), "the file could not be read: " + e.getMessage(), e);
        }
    }

    /** Loaded when the first world is read. */
    private static final class SchemaHolder {
        static final Schema SCHEMA = load();

        private static Schema load() {
            URL resource = XmlWorld.class.getResource("world.xsd");
            if (resource == null) {
                throw new IllegalStateException("world.xsd is missing from the package robosim.geometry.world");
            }
            try {
                SchemaFactory factory = SchemaFactory.newDefaultInstance();
                factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
                factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
                factory.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
                return factory.newSchema(resource);
            } catch (SAXException e) {
                throw new IllegalStateException("world.xsd is not a valid schema: " + e.getMessage(), e);
            }
        }
    }
}
