package robosim.geometry.net;

import java.lang.management.ManagementFactory;
import java.util.Hashtable;
import java.util.Map;
import javax.management.JMException;
import javax.management.ObjectName;

/** Registers figures as MBeans, for tools such as jconsole. Without {@code java.management} only this is missing. */
final class Management implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Management.class.getPackageName());

    private final Runnable withdrawal;

    private Management(Runnable withdrawal) {
        this.withdrawal = withdrawal;
    }

    /**
     * Registers figures until the result is closed.
     *
     * @param type {@code GeometryServer} or {@code GeometryClient}
     * @param name the name that tells it from others of its type
     */
    static Management show(FiguresMXBean figures, String type, String name) {
        try {
            return new Management(Beans.register(figures, type, name));
        } catch (NoClassDefFoundError e) {
            LOG.log(System.Logger.Level.DEBUG, type + " " + name + ": no figures by JMX, there is no java.management");
            return new Management(() -> {});
        }
    }

    @Override
    public void close() {
        withdrawal.run();
    }

    /** The only class that needs java.management, so that the others load without it. */
    private static final class Beans {
        private Beans() {}

        @SuppressWarnings("JdkObsolete") // what ObjectName takes
        static Runnable register(FiguresMXBean figures, String type, String name) {
            try {
                ObjectName place = new ObjectName(
                        "robosim.geometry", new Hashtable<>(Map.of("type", type, "name", ObjectName.quote(name))));
                ManagementFactory.getPlatformMBeanServer().registerMBean(figures, place);
                return () -> withdraw(place);
            } catch (JMException | RuntimeException e) {
                LOG.log(System.Logger.Level.WARNING, type + " " + name + ": no figures by JMX: " + e.getMessage());
                return () -> {};
            }
        }

        private static void withdraw(ObjectName place) {
            try {
                ManagementFactory.getPlatformMBeanServer().unregisterMBean(place);
            } catch (JMException e) {
                LOG.log(System.Logger.Level.DEBUG, place + " was no longer registered", e);
            }
        }
    }
}
