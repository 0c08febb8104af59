package robosim.geometry.world;

import java.util.Locale;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.XMLReader;

/** XML from a stranger: no document type, no entity, nothing read that the file names. */
final class SafeXml {
    /** Parser and validator are made to speak English, their root language: it is what {@link SchemaErrors} reads. */
    static final String LOCALE = "http://apache.org/xml/properties/locale";

    private SafeXml() {}

    /** A parser of the JDK's own, whatever else is on the class path. */
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
            return reader;
        } catch (ParserConfigurationException e) {
            throw new IllegalStateException("the JDK's XML parser refuses to be hardened", e);
        }
    }

    /** The parser's own errors: not well-formed, or against its limits. */
    static WorldException refusal(String source, SAXParseException e) {
        String message = String.valueOf(e.getMessage());
        String problem = message.contains("disallow-doctype-decl")
                ? "a document type is not accepted; remove <!DOCTYPE ...>, a world has no entities"
                : "this is no well-formed XML: " + message;
        return new WorldException(source, e.getLineNumber(), e.getColumnNumber(), problem, e);
    }
}
