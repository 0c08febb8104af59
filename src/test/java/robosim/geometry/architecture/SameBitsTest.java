package robosim.geometry.architecture;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What may differ between JVMs is left to {@link StrictMath} wherever an answer comes from. */
@Tag("slow")
@Tag("sources")
class SameBitsTest {
    /** The methods of {@link Math} whose results the specification does not fix to the bit, or did not always. */
    private static final Set<String> LOOSE = Set.of(
            "sin",
            "cos",
            "tan",
            "asin",
            "acos",
            "atan",
            "atan2",
            "exp",
            "log",
            "log10",
            "pow",
            "hypot",
            "cbrt",
            "sinh",
            "cosh",
            "tanh",
            "expm1",
            "log1p",
            "toRadians",
            "toDegrees",
            "random");

    private static final DescribedPredicate<JavaMethodCall> CALLS_LOOSE_MATH = DescribedPredicate.describe(
            "calls Math where only StrictMath is the same everywhere",
            call -> call.getTargetOwner().isEquivalentTo(Math.class) && LOOSE.contains(call.getName()));

    @Test
    void answersDoNotDependOnTheJvmsMathematics() {
        assertThat(Imported.CLASSES).hasSizeGreaterThan(100);
        noClasses()
                .that()
                .resideOutsideOfPackages("..viewer..", "..cli..")
                .should()
                .callMethodWhere(CALLS_LOOSE_MATH)
                .check(Imported.CLASSES);
    }
}
