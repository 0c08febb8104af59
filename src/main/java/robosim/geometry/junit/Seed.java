package robosim.geometry.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * The seed of a test's random source. Without it each test has one of its own, always the same, that comes from the names
 * of its class and method. JUnit's configuration parameter {@code robosim.seed} stands before both, as in
 * {@code -Drobosim.seed=42}. A failure tells which it was.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Documented
@ExtendWith(WorldExtension.class)
public @interface Seed {
    /** The seed. More than one is for a {@link ScenarioTest}. */
    long[] value();
}
