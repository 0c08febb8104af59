package robosim.geometry.junit;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.extension.ExtensionConfigurationException;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.platform.commons.support.AnnotationSupport;

/** The objects that are injected into one test. A world is made when it is first asked for. */
final class Run {
    private static final Pattern INVOCATION = Pattern.compile("#(\\d+)]");

    private final ExtensionContext context;
    private final @Nullable Source source;
    private final Choice choice;
    private final long seed;
    private final SplittableRandom splittable;
    private final Random random;
    private final RecordedServer talks = new RecordedServer();
    private @Nullable RobotWorld world;

    /** Which of several worlds and seeds to use; null if there is nothing to choose. */
    record Choice(@Nullable String world, @Nullable Long seed) {
        static final Choice NONE = new Choice(null, null);
    }

    /**
     * What the annotations say.
     *
     * @param files  worlds to choose from
     * @param method that makes a world where there are no files
     */
    record Source(List<String> files, String method, Duration step) {}

    Run(ExtensionContext context, Choice choice, @Nullable Source source, long @Nullable [] seeds) {
        this.context = context;
        this.choice = choice;
        this.source = source;
        this.seed = seed(seeds);
        this.splittable = new SplittableRandom(seed);
        this.random = new Random(seed);
    }

    /** The nearest annotation: on the method, its class, or an enclosing class. */
    static <A extends java.lang.annotation.Annotation> Optional<A> find(ExtensionContext context, Class<A> type) {
        Optional<ExtensionContext> at = Optional.of(context);
        while (at.isPresent()) {
            Optional<A> found = AnnotationSupport.findAnnotation(at.get().getElement(), type);
            if (found.isPresent()) {
                return found;
            }
            at = at.get().getParent();
        }
        return Optional.empty();
    }

    private long seed(long @Nullable [] values) {
        Optional<String> wanted = context.getConfigurationParameter("robosim.seed");
        if (wanted.isPresent()) {
            try {
                return Long.parseLong(wanted.get().trim());
            } catch (NumberFormatException e) {
                throw new ExtensionConfigurationException(
                        "robosim.seed must be a whole number (got: " + wanted.get() + ")", e);
            }
        }
        Long chosen = choice.seed();
        if (chosen != null) {
            return chosen;
        }
        if (values == null) {
            return name(context).hashCode();
        }
        if (values.length != 1) {
            throw new ExtensionConfigurationException(
                    "@Seed must have one value except on a @ScenarioTest (got: " + values.length + ")");
        }
        return values[0];
    }

    RobotWorld world() {
        if (world == null) {
            if (source == null) {
                throw new ExtensionConfigurationException("a test with a world must have one by @World (got: none)");
            }
            world = world(source, new VirtualClock(source.step()));
        }
        return world;
    }

    private RobotWorld world(Source named, VirtualClock clock) {
        Class<?> test = context.getRequiredTestClass();
        List<String> files = named.files();
        if (named.method().isEmpty() == files.isEmpty()) {
            throw new ExtensionConfigurationException(
                    "@World must name either files or a method (got: " + (files.isEmpty() ? "neither" : "both") + ")");
        }
        if (files.isEmpty()) {
            return new RobotWorld(WorldFile.build(named.method(), test), null, clock);
        }
        String chosen = choice.world();
        if (chosen == null && files.size() > 1) {
            throw new ExtensionConfigurationException(
                    "@World must name one file except on a @ScenarioTest (got: " + files.size() + ")");
        }
        robosim.geometry.world.World file = WorldFile.read(chosen == null ? files.get(0) : chosen, test);
        try {
            return new RobotWorld(file.toGeometry(), file, clock);
        } catch (IllegalArgumentException e) {
            throw new ExtensionConfigurationException("the world of @World cannot be had: " + e.getMessage(), e);
        }
    }

    SplittableRandom splittable() {
        return splittable;
    }

    Random random() {
        return random;
    }

    static Evidence evidence(ExtensionContext context) {
        String folder = context.getConfigurationParameter("robosim.evidence").orElse("target/robosim");
        return new Evidence(Path.of(folder, name(context)));
    }

    RecordedServer talks() {
        return talks;
    }

    /** Names the moment as the message of the failure does: a conversation has several requests in a step of the clock. */
    private String title() {
        long steps = world == null ? 0 : world.clock().steps();
        return name(context) + ", seed " + seed + (steps == 0 ? "" : ", step " + steps + " of the clock");
    }

    /** Writes the evidence of a failure and returns the lines that name it. */
    String leave(String failure) {
        return evidence(context).leave(failure, seed, world, talks, title());
    }

    /** Class, method and number of the invocation, as a valid folder name. */
    private static String name(ExtensionContext context) {
        StringBuilder name =
                new StringBuilder(context.getRequiredTestClass().getName().replace('$', '.')
                        + "."
                        + context.getRequiredTestMethod().getName());
        Matcher invocation = INVOCATION.matcher(context.getUniqueId());
        while (invocation.find()) {
            name.append('-').append(invocation.group(1));
        }
        return name.toString();
    }
}
