package robosim.geometry.protocol;

import java.util.ServiceLoader;
import java.util.Set;

/**
 * Translates between an environment's own message classes, such as RoboSim's original ones, and bundles.
 *
 * <p>It is passed to servers and clients through {@code robosim.geometry.net.NetOptions}, or found by {@link
 * ServiceLoader}. One translator serves all connections, on several threads at a time.
 *
 * <p>The limits hold for a translator's classes too. But what these classes do while they are deserialized is up to
 * them: a class whose {@code readObject} trusts its input opens a hole that the module's own records do not have.
 */
public interface MessageTranslator {
    /** Passes the module's own records unchanged. */
    MessageTranslator RECORDS = new MessageTranslator() {
        @Override
        public Set<Class<?>> classes() {
            return Set.of();
        }

        @Override
        public Bundle decode(Object message) {
            if (message instanceof Bundle bundle) {
                return bundle;
            }
            throw new IllegalArgumentException(
                    "a message must be a bundle (got: " + message.getClass().getName() + ")");
        }

        @Override
        public Object encode(Bundle bundle) {
            return bundle;
        }
    };

    /** The translator that {@link ServiceLoader} finds first; {@link #RECORDS} if there is none. */
    static MessageTranslator installed() {
        return ServiceLoader.load(MessageTranslator.class).findFirst().orElse(RECORDS);
    }

    /**
     * All classes that a message may contain in addition to the module's own, including serializable superclasses,
     * enums, and collections with the classes that implement them. Only these classes are ever looked up, by their
     * exact names.
     */
    Set<Class<?>> classes();

    /**
     * The bundle that corresponds to a message.
     *
     * @throws IllegalArgumentException if there is none: the message is refused and its connection closed
     */
    Bundle decode(Object message);

    /** The object that is written for a bundle. */
    Object encode(Bundle bundle);
}
