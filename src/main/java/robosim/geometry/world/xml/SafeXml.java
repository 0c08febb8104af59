package robosim.geometry.world.xml;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Locale;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.XMLReader;
import org.xml.sax.helpers.DefaultHandler;
import robosim.geometry.world.shared.FileProblem;

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
     * @throws SAXException around a {@link FileProblem}, if it exceeds the limits
     */
    public static void parse(InputStream in, String source, DefaultHandler follower) throws SAXException, IOException {
        XmlLimitFilter filter = new XmlLimitFilter(reader(), source, follower);
        filter.parse(filter.watched(in));
    }

    /** The JDK's own parser, whatever else is on the class path. */
    private static XMLReader reader() throws SAXException {
        SAXParserFactory factory = SAXParserFactory.newDefaultNSInstance();
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
        String problem = message.contains("disallow-doctype-decl")
                ? "a document type is not allowed; remove <!DOCTYPE ...>, as a world has no entities"
                : "this is not well-formed XML: " + message;
        return new FileProblem(source, e.getLineNumber(), e.getColumnNumber(), problem, e);
    }
}
