package robosim.geometry.junit;

import java.io.IOException;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionConfigurationException;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.LifecycleMethodExecutionExceptionHandler;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.junit.jupiter.api.extension.TestExecutionExceptionHandler;
import org.opentest4j.AssertionFailedError;
import org.opentest4j.IncompleteExecutionException;
import robosim.geometry.Geometry;
import robosim.geometry.net.GeometryServer;

/**
 * Resolves the parameters of tests, and says on failure how to reproduce it. Registered by {@link World} and {@link
 * Seed}.
 */
final class WorldExtension
        implements BeforeEachCallback,
                AfterEachCallback,
                ParameterResolver,
                TestExecutionExceptionHandler,
                LifecycleMethodExecutionExceptionHandler {
    private static final ExtensionContext.Namespace NAMESPACE = ExtensionContext.Namespace.create(WorldExtension.class);

    private static final Set<Class<?>> TYPES = Set.of(
            Geometry.class,
            GeometryServer.class,
            RobotWorld.class,
            VirtualClock.class,
            Clock.class,
            RandomGenerator.class,
            SplittableRandom.class,
            Random.class);

    /** Called by JUnit. */
    public WorldExtension() {}

    /** Chooses world and seed, before any parameter of a test is resolved. */
    static void choose(ExtensionContext context, Run.Choice choice) {
        context.getStore(NAMESPACE).put(Run.Choice.class, choice);
    }

    private static Run run(ExtensionContext context) {
        ExtensionContext.Store store = context.getStore(NAMESPACE);
        Run run = store.get(Run.class, Run.class);
        if (run == null) {
            Run.Choice choice = store.get(Run.Choice.class, Run.Choice.class);
            Run.Source source = Run.find(context, World.class)
                    .map(world -> new Run.Source(
                            List.of(world.value()), world.method(), Duration.ofMillis(world.stepMillis())))
                    .orElse(null);
            long[] seeds = Run.find(context, Seed.class).map(Seed::value).orElse(null);
            run = new Run(context, choice == null ? Run.Choice.NONE : choice, source, seeds);
            store.put(Run.class, run);
        }
        return run;
    }

    @Override
    public void beforeEach(ExtensionContext context) throws IOException {
        Run.evidence(context).clear();
    }

    @Override
    public void afterEach(ExtensionContext context) {
        Run run = context.getStore(NAMESPACE).get(Run.class, Run.class);
        if (run != null) {
            run.talks().close();
        }
    }

    @Override
    public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
        return context.getTestMethod().isPresent()
                && TYPES.contains(parameter.getParameter().getType());
    }

    @Override
    public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
        Run run = run(context);
        Class<?> type = parameter.getParameter().getType();
        if (type == GeometryServer.class) {
            return run.talks().server();
        }
        if (type == Geometry.class) {
            return run.world().geometry();
        }
        if (type == RobotWorld.class) {
            return run.world();
        }
        if (type == VirtualClock.class || type == Clock.class) {
            return run.world().clock();
        }
        return type == Random.class ? run.random() : run.splittable();
    }

    @Override
    public void handleTestExecutionException(ExtensionContext context, Throwable thrown) throws Throwable {
        throw told(context, thrown);
    }

    @Override
    public void handleBeforeEachMethodExecutionException(ExtensionContext context, Throwable thrown) throws Throwable {
        throw told(context, thrown);
    }

    @Override
    public void handleAfterEachMethodExecutionException(ExtensionContext context, Throwable thrown) throws Throwable {
        throw told(context, thrown);
    }

    /**
     * The same failure with the evidence in its message; anything but a failure, or a broken JVM, is returned
     * unchanged.
     */
    private static Throwable told(ExtensionContext context, Throwable thrown) {
        if (thrown instanceof IncompleteExecutionException || thrown instanceof VirtualMachineError) {
            return thrown;
        }
        String words = thrown instanceof AssertionError ? String.valueOf(thrown.getMessage()) : thrown.toString();
        String evidence;
        try {
            evidence = run(context).leave(words);
        } catch (ExtensionConfigurationException | LinkageError e) { // no seed and therefore no run, or a missing class
            thrown.addSuppressed(e);
            return thrown;
        }
        AssertionFailedError told = compared(thrown, words + evidence);
        told.setStackTrace(thrown.getStackTrace());
        return told;
    }

    private static AssertionFailedError compared(Throwable thrown, String message) {
        if (thrown instanceof AssertionFailedError failed && failed.isExpectedDefined() && failed.isActualDefined()) {
            return new AssertionFailedError(message, failed.getExpected(), failed.getActual(), failed);
        }
        return new AssertionFailedError(message, thrown);
    }
}
