package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

class TextTest {
    /** Of control characters the tab alone stays, line breaks do not; surrogates stay in pairs only. */
    @Test
    void whatALabelCannotHaveIsReplaced() {
        assertThat(Text.xml("a<b>&\"c\"")).isEqualTo("a&lt;b&gt;&amp;&quot;c&quot;");
        assertThat(Text.xml("\t \ud7ff\ue000\ufffd")).isEqualTo("\t \ud7ff\ue000\ufffd");
        assertThat(Text.xml("\ud83e\udd16")).as("beyond the first plane").isEqualTo("\ud83e\udd16");
        for (String bad : new String[] {"\u0000", "\u001f", "\n", "\ud800", "\udfff", "\ufffe", "\uffff"}) {
            assertThat(Text.xml("a" + bad + "b")).isEqualTo("a\ufffdb");
        }
    }

    @Test
    void anObjectIsToldByItsKindAndItsName() {
        SphereObject ball = new SphereObject(new Point(), 1);
        assertThat(Text.kindAndName(ball)).isEqualTo("sphere without a name");
        assertThat(Text.kindAndName(ball.named("a \"b\"\n"))).isEqualTo("sphere \"a \\\"b\\\"\\u000a\"");
    }

    @Test
    void problemsAreEqualByIndexAndReason() {
        Problem one = Problem.of(2, () -> "too " + "far");
        assertThat(one).isEqualTo(Problem.of(2, () -> "too far")).hasSameHashCodeAs(Problem.of(2, () -> "too far"));
        assertThat(one).isNotEqualTo(Problem.of(3, () -> "too far")).isNotEqualTo(Problem.of(2, () -> "too near"));
        assertThat(one.hashCode()).isNotEqualTo(Problem.of(3, () -> "too far").hashCode());
        assertThat(one).hasToString("2: too far");
    }
}
