package robosim.geometry.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * The seed of a test's random source. Without this annotation each test has its own constant seed, derived from the
 * names of its class and method. JUnit's configuration parameter {@code robosim.seed} overrides both, as in {@code
 * -Drobosim.seed=42}. A failure message names the seed.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Documented
@ExtendWith(WorldExtension.class)
public @interface Seed {
    /** The seed; only a {@link ScenarioTest} may have more than one. */
    long[] value();
}
