package robosim.geometry.world.xml;

import java.io.BufferedInputStream;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.XMLReader;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.RegularFile;

/**
 * Parses untrusted XML: no document type, no entities, nothing that the file refers to is read, and all within limits (see {@link
 * XmlLimitFilter}).
 */
public final class SafeXml {
    /** Parser and validator are set to English, their default language, which {@code SchemaErrors} parses. */
    public static final String LOCALE = "http://apache.org/xml/properties/locale";

    /**
     * Limits of the JDK that differ between versions; {@link XmlLimitFilter} replaces them here, and without entities they
     * are not needed.
     */
    private static final List<String> OWN_LIMITS =
            List.of("jdk.xml.maxElementDepth", "jdk.xml.maxGeneralEntitySizeLimit", "jdk.xml.totalEntitySizeLimit");

    private SafeXml() {}

    /**
     * Parses a stream.
     *
     * @param source the name of the stream in messages
     * @throws FileProblem if it cannot be read, is not well-formed, exceeds the limits or is refused by its handler
     */
    public static void parse(InputStream in, String source, XmlHandler follower) throws FileProblem {
        try {
            parse(reader(SAXParserFactory.newDefaultNSInstance()), in, source, follower);
        } catch (SAXException e) {
            throw refused(source, follower.line(), follower.column(), e);
        } catch (FileProblem e) {
            throw e;
        } catch (IOException e) {
            String problem = "the file could not be read: " + e.getMessage();
            throw new FileProblem(source, follower.line(), follower.column(), problem, e);
        }
    }

    private static FileProblem refused(String source, int line, int column, SAXException e) {
        return e.getException() instanceof FileProblem refusal
                ? refusal
                : new FileProblem(source, line, column, "the XML was refused: " + e, e);
    }

    private static void parse(XMLReader reader, InputStream in, String source, XmlHandler follower)
            throws SAXException, IOException {
        XmlLimitFilter filter = new XmlLimitFilter(reader, source, follower);
        filter.parse(filter.watched(in));
    }

    /**
     * Parses a file of Gazebo or ROS, whose parsers know no namespaces and do not mind some mistakes: names are those
     * written, a prefix need not be declared, and a file that is not well-formed is tried again with these mistakes mended.
     *
     * @param source    the name of the file in messages
     * @param followers called for each attempt
     * @param remarks   told what was mended
     * @return the follower of the attempt that succeeded
     * @throws FileProblem as {@link #parse}
     */
    public static <H extends XmlHandler> H parseLeniently(
            Path file, String source, Supplier<H> followers, Consumer<String> remarks) throws FileProblem {
        try {
            return parseMended(file, source, followers, remarks);
        } catch (SAXException e) {
            throw refused(source, 0, 0, e);
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
    }

    private static <H extends XmlHandler> H parseMended(
            Path file, String source, Supplier<H> followers, Consumer<String> remarks)
            throws SAXException, IOException {
        try (InputStream in = new BufferedInputStream(RegularFile.open(file))) {
            H follower = followers.get();
            parse(plainReader(), in, source, follower);
            return follower;
        } catch (SAXException e) {
            if (!(e.getException() instanceof NotWellFormed)) {
                throw e;
            }
        } catch (CharConversionException e) { // bytes that are not of its encoding
        }
        try (LenientXml in = new LenientXml(RegularFile.open(file))) {
            H follower = followers.get();
            parse(plainReader(), in, source, follower);
            in.mended(source).forEach(remarks);
            return follower;
        }
    }

    /** Whether a file is not well-formed, and may be read nevertheless from its {@link #mended} bytes. */
    public static boolean isNotWellFormed(FileProblem problem) {
        return problem instanceof NotWellFormed;
    }

    /** The bytes of a file without the mistakes that Gazebo does not mind. */
    public static InputStream mended(InputStream in) throws IOException {
        return new LenientXml(in);
    }

    /** A parser to which a colon is a letter. */
    private static XMLReader plainReader() throws SAXException {
        return reader(SAXParserFactory.newDefaultInstance());
    }

    /** The JDK's own parser, whatever else is on the class path. */
    private static XMLReader reader(SAXParserFactory factory) throws SAXException {
        try {
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            factory.setFeature("http://xml.org/sax/features/external-general-entities", false);
            factory.setFeature("http://xml.org/sax/features/external-parameter-entities", false);
            factory.setFeature("http://apache.org/xml/features/nonvalidating/load-external-dtd", false);
            factory.setXIncludeAware(false);
            XMLReader reader = factory.newSAXParser().getXMLReader();
            reader.setProperty(LOCALE, Locale.ROOT);
            for (String own : OWN_LIMITS) {
                reader.setProperty(own, "0");
            }
            return reader;
        } catch (ParserConfigurationException e) {
            throw new IllegalStateException("the JDK's XML parser does not support the secure settings", e);
        }
    }

    /** The exception for an error of the parser: not well-formed, or beyond its limits. */
    public static FileProblem refusal(String source, SAXParseException e) {
        String message = String.valueOf(e.getMessage());
        if (message.contains("disallow-doctype-decl")) {
            String problem = "a document type is not allowed; remove <!DOCTYPE ...>, as a world has no entities";
            return new FileProblem(source, e.getLineNumber(), e.getColumnNumber(), problem, e);
        }
        String problem = "this is not well-formed XML: " + plain(message);
        return new NotWellFormed(source, e.getLineNumber(), e.getColumnNumber(), problem, e);
    }

    /** What the parser says of a file that ends too early, in words that help. */
    private static String plain(String message) {
        if (message.startsWith("Premature end of file")) {
            return "it has no element; the file is empty or was cut off";
        }
        return message.contains("must start and end within the same entity")
                ? "it ends before its elements do; a closing tag is missing, or the file was cut off"
                : message;
    }
}
