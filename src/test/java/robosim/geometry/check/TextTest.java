package robosim.geometry.check;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

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
}
