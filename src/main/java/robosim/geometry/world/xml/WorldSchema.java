package robosim.geometry.world.xml;

import java.net.URL;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import javax.xml.XMLConstants;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import org.xml.sax.SAXException;

/** The schema of world files, loaded once, when the first of them is read or a little before. */
public final class WorldSchema {
    private static final String PLACE = "/robosim/geometry/world/world.xsd";

    private static final FutureTask<Schema> LOADED = new FutureTask<>(WorldSchema::load);

    private WorldSchema() {}

    /** Begins to load it on another thread, for a program that is about to read a world and has something else to do first. */
    public static void prepare() {
        Thread thread = new Thread(LOADED, "world schema");
        thread.setDaemon(true);
        thread.start();
    }

    /** The schema; a failure to load it is the same each time. */
    public static Schema get() {
        LOADED.run(); // nothing if another thread does or did
        boolean isInterrupted = false;
        try {
            while (true) {
                try {
                    return LOADED.get();
                } catch (InterruptedException e) {
                    isInterrupted = true; // it will not be long
                } catch (ExecutionException e) {
                    if (e.getCause() instanceof Error error) {
                        throw error; // as of a class that a smaller Java runtime lacks
                    }
                    throw new IllegalStateException(e.getCause());
                }
            }
        } finally {
            if (isInterrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private static Schema load() {
        URL resource = WorldSchema.class.getResource(PLACE);
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
