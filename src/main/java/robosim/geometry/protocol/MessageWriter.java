package robosim.geometry.protocol;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import robosim.geometry.check.Checks;

/**
 * Writes bundles to a stream and resets it after each, so that neither end keeps past messages.
 *
 * <p>The stream's header is written and flushed at once: two ends that first wait for each other's header wait forever,
 * so create the writer before the reader.
 */
public final class MessageWriter {
    private final MessageTranslator translator;
    private final ObjectOutputStream objects;

    /** Writes the module's own records. */
    public MessageWriter(OutputStream out) throws IOException {
        this(out, MessageTranslator.RECORDS);
    }

    /** Writes the objects that a translator makes of the bundles. */
    public MessageWriter(OutputStream out, MessageTranslator translator) throws IOException {
        this.translator = Checks.present("translator", translator);
        this.objects = new ObjectOutputStream(new BufferedOutputStream(Checks.present("out", out), 8192));
        objects.flush();
    }

    /** Writes one complete message and flushes it. */
    public void write(Bundle bundle) throws IOException {
        objects.writeObject(translator.encode(Checks.present("bundle", bundle)));
        objects.reset();
        objects.flush();
    }
}
