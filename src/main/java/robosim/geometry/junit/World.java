package robosim.geometry.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * The world that a test is about, read or built anew for each test. On a method it stands before that of the class.
 *
 * <p>The test and its {@code BeforeEach} and {@code AfterEach} methods may ask for a {@link RobotWorld}, its {@link
 * robosim.geometry.Geometry}, a {@link VirtualClock} and a seeded {@link java.util.random.RandomGenerator}, {@link
 * java.util.SplittableRandom} or {@link java.util.Random}; and for a client under test for a {@link
 * robosim.geometry.net.GeometryServer} that listens on a free port of the loopback address until the test has ended.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Documented
@ExtendWith(WorldExtension.class)
public @interface World {
    /**
     * World files of any format that {@link robosim.geometry.world.WorldImport#read} knows: paths from the working
     * directory, or else resources of the class path, from its root or beside the test class. More than one is for a
     * {@link ScenarioTest}.
     */
    String[] value() default {};

    /**
     * Instead of files, a static method of the test class without parameters that builds a {@link
     * robosim.geometry.Geometry}.
     */
    String method() default "";

    /** How long a step of the virtual clock is. */
    long stepMillis() default 100;
}
