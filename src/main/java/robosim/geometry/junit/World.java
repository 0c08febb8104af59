package robosim.geometry.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * The world of a test, read or built anew for each test. On a method it overrides that of the class.
 *
 * <p>The test and its {@code BeforeEach} and {@code AfterEach} methods may have parameters of type {@link RobotWorld},
 * its {@link robosim.geometry.Geometry}, a {@link VirtualClock} and a seeded {@link java.util.random.RandomGenerator},
 * {@link java.util.SplittableRandom} or {@link java.util.Random}; to test a client, also {@link
 * robosim.geometry.net.GeometryServer}, a server that listens on a free port of the loopback address until the test has
 * ended.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Documented
@ExtendWith(WorldExtension.class)
public @interface World {
    /**
     * World files in any format that {@link robosim.geometry.world.WorldImport#read} supports: paths relative to the
     * working directory, or else resources of the class path, relative to its root or the test class. Only a {@link
     * ScenarioTest} may have more than one.
     */
    String[] value() default {};

    /**
     * Instead of files, a static method of the test class without parameters that builds a {@link
     * robosim.geometry.Geometry}.
     */
    String method() default "";

    /** The length of a step of the virtual clock, milliseconds. */
    long stepMillis() default 100;
}
