package robosim.geometry.world.xml;

import java.io.InputStream;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.XMLReader;
import org.xml.sax.ext.LexicalHandler;
import org.xml.sax.helpers.DefaultHandler;
import org.xml.sax.helpers.XMLFilterImpl;
import robosim.geometry.world.shared.CountedStream;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Limits;

/**
 * A filter between a parser and its handler that limits the nesting depth of elements, and the length of a tag or a
 * comment, which a parser keeps in memory until its end.
 */
final class XmlLimitFilter extends XMLFilterImpl implements LexicalHandler {
    private final String source;
    private @Nullable Locator locator;
    private int depth;

    /** Number of bytes read since the parser's last event. */
    private long silent;

    XmlLimitFilter(XMLReader parser, String source, DefaultHandler follower) throws SAXException {
        super(parser);
        this.source = source;
        parser.setProperty("http://xml.org/sax/properties/lexical-handler", this);
        setContentHandler(follower);
        setErrorHandler(follower);
        setEntityResolver(follower);
    }

    /** Counts the bytes that the parser reads from a stream without an event. */
    InputSource watched(InputStream in) {
        return new InputSource(new CountedStream(CountedStream.bounded(in), bytes -> {
            silent += bytes;
            if (silent > Limits.MAX_MARKUP) {
                throw new FileProblem(
                        source,
                        locator == null ? 0 : locator.getLineNumber(),
                        0,
                        "a tag with its attributes, a comment, or the space before the first tag must have at most "
                                + Limits.MAX_MARKUP + " bytes; keep large meshes in files of their own (got: more)");
            }
        }));
    }

    @Override
    public void setDocumentLocator(Locator given) {
        locator = given;
        super.setDocumentLocator(given);
    }

    @Override
    public void startElement(String uri, String name, String qualified, Attributes attributes) throws SAXException {
        silent = 0;
        FileWork.take(1);
        if (++depth > Limits.MAX_DEPTH) {
            throw new SAXException(new FileProblem(
                    source,
                    locator == null ? 0 : locator.getLineNumber(),
                    locator == null ? 0 : locator.getColumnNumber(),
                    "elements must be nested at most " + Limits.MAX_DEPTH + " deep; nest less (got: one more)"));
        }
        super.startElement(uri, name, qualified, attributes);
    }

    @Override
    public void endElement(String uri, String name, String qualified) throws SAXException {
        silent = 0;
        depth--;
        super.endElement(uri, name, qualified);
    }

    @Override
    public void characters(char[] text, int start, int length) throws SAXException {
        silent = 0;
        super.characters(text, start, length);
    }

    @Override
    public void ignorableWhitespace(char[] text, int start, int length) throws SAXException {
        silent = 0;
        super.ignorableWhitespace(text, start, length);
    }

    @Override
    public void processingInstruction(String target, String data) throws SAXException {
        silent = 0;
        super.processingInstruction(target, data);
    }

    @Override
    public void comment(char[] text, int start, int length) {
        silent = 0;
    }

    @Override
    public void startCDATA() {
        silent = 0;
    }

    @Override
    public void endCDATA() {
        silent = 0;
    }

    // Without a document type, there are no entities.

    @Override
    public void startDTD(String name, @Nullable String publicId, @Nullable String systemId) {}

    @Override
    public void endDTD() {}

    @Override
    public void startEntity(String name) {}

    @Override
    public void endEntity(String name) {}
}
