package robosim.geometry.protocol;

import java.util.ServiceLoader;
import java.util.Set;

/**
 * The place where who has RoboSim's original classes plugs them in: it turns what an environment sends into bundles, and
 * bundles into what the environment expects.
 *
 * <p>It is given to both ends through {@code robosim.geometry.net.NetOptions}, or found by {@link ServiceLoader}. One
 * translator serves all connections, on several threads at a time.
 *
 * <p>The limits hold for a translator's classes too. What its classes do while they are read is its own affair: a class
 * with a {@code readObject} that trusts its numbers opens a door that the module's own records keep shut.
 */
public interface MessageTranslator {
    /** The module's own records, as they are. */
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

    /** The translator that {@link ServiceLoader} finds first; {@link #RECORDS} where there is none. */
    static MessageTranslator installed() {
        return ServiceLoader.load(MessageTranslator.class).findFirst().orElse(RECORDS);
    }

    /**
     * Every class that a message may hold beside the module's own: serializable superclasses, enums and collections with
     * the classes behind them too. Only these classes are ever looked up, by their exact names.
     */
    Set<Class<?>> classes();

    /**
     * The bundle that a message means.
     *
     * @throws IllegalArgumentException where it means none: the message is refused and its connection closed
     */
    Bundle decode(Object message);

    /** What is written for a bundle. */
    Object encode(Bundle bundle);
}
