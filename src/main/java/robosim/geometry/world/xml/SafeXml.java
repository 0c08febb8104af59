package robosim.geometry.world.xml;

import java.util.List;
import java.util.Locale;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.XMLReader;
import robosim.geometry.world.shared.FileProblem;

/** Hardened XML parsing: no document type, no entities, and nothing that the file refers to is read. */
public final class SafeXml {
    /** Parser and validator are set to English, their default language, which {@code SchemaErrors} parses. */
    public static final String LOCALE = "http://apache.org/xml/properties/locale";

    /**
     * Limits of the JDK that differ between versions; {@link XmlGuard} replaces them here, and without entities they
     * are not needed.
     */
    private static final List<String> OWN_LIMITS =
            List.of("jdk.xml.maxElementDepth", "jdk.xml.maxGeneralEntitySizeLimit", "jdk.xml.totalEntitySizeLimit");

    private SafeXml() {}

    /** The JDK's own parser, whatever else is on the class path. */
    static XMLReader reader() throws SAXException {
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
