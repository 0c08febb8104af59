package robosim.geometry.world.xml;

import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;

/** Handles the events of a parser, which {@link SafeXml} runs, and refuses what is wrong at the place where the parser is. */
public abstract class XmlHandler extends DefaultHandler {
    private final String source;
    private @Nullable Locator locator;
    private int kept;

    /** @param source the name of the file in messages */
    protected XmlHandler(String source) {
        this.source = source;
    }

    /** Counted from 1; 0 before the parser has begun. */
    protected final int line() {
        return locator == null ? 0 : locator.getLineNumber();
    }

    /** Counted from 1; 0 before the parser has begun. */
    protected final int column() {
        return locator == null ? 0 : locator.getColumnNumber();
    }

    @Override
    public void setDocumentLocator(Locator given) {
        locator = given;
    }

    @Override
    public void error(SAXParseException e) throws SAXException {
        fatalError(e);
    }

    @Override
    public void fatalError(SAXParseException e) throws SAXException {
        throw new SAXException(SafeXml.refusal(source, e));
    }

    /** Nothing outside the file is ever read, whatever the defaults of features are. */
    @Override
    public final InputSource resolveEntity(@Nullable String publicId, @Nullable String systemId) throws SAXException {
        throw refusal("external entities are not allowed; remove the reference (got: " + systemId + ")");
    }

    /** What ends the parsing. */
    protected final SAXException refusal(String problem) {
        return new SAXException(new FileProblem(source, line(), column(), problem));
    }

    /** Counts one of the elements that are kept in memory. */
    protected final void count() throws SAXException {
        if (++kept > Limits.MAX_ELEMENTS) {
            throw refusal("a file must have at most " + Limits.MAX_ELEMENTS
                    + " relevant elements; split it in several files (got: more)");
        }
    }

    /** The attributes of an element, none of which is too long. */
    protected final Map<String, String> attributes(String element, Attributes attributes) throws SAXException {
        Map<String, String> values = attributes.getLength() == 0 ? Map.of() : new TreeMap<>();
        for (int k = 0; k < attributes.getLength(); k++) {
            String value = attributes.getValue(k);
            if (value.length() > Limits.MAX_ATTRIBUTE) {
                throw refusal(attributes.getQName(k) + " of <" + element + "> must have at most " + Limits.MAX_ATTRIBUTE
                        + " characters; shorten it (got: " + value.length() + ")");
            }
            values.put(attributes.getQName(k), value);
        }
        return values;
    }
}
