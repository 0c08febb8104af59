package robosim.geometry.cli.network;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A SIGTERM or SIGINT that comes while the process is ending already, which Java itself ignores. */
final class NextSignal {
    private static final System.Logger LOG = System.getLogger(NextSignal.class.getPackageName());

    private NextSignal() {}

    /**
     * Runs something at each such signal from now on, on a thread of its own. By reflection, as the JDK's module for it,
     * jdk.unsupported, may be missing; signals are then ignored as before.
     */
    static void runs(Runnable action) {
        try {
            Class<?> signal = Class.forName("sun.misc.Signal");
            Class<?> handler = Class.forName("sun.misc.SignalHandler");
            InvocationHandler calls = (proxy, method, arguments) -> answer(proxy, method.getName(), arguments, action);
            Object handling =
                    Proxy.newProxyInstance(NextSignal.class.getClassLoader(), new Class<?>[] {handler}, calls);
            for (String name : List.of("TERM", "INT")) {
                signal.getMethod("handle", signal, handler)
                        .invoke(null, signal.getConstructor(String.class).newInstance(name), handling);
            }
        } catch (ReflectiveOperationException | RuntimeException e) {
            LOG.log(System.Logger.Level.DEBUG, "a second signal will be ignored", e);
        }
    }

    private static @Nullable Object answer(
            Object proxy, String method, Object @Nullable [] arguments, Runnable action) {
        return switch (method) {
            case "handle" -> {
                action.run();
                yield null;
            }
            case "equals" -> arguments != null && proxy == arguments[0];
            case "hashCode" -> System.identityHashCode(proxy);
            default -> "what a second signal runs";
        };
    }
}
