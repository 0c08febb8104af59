package robosim.geometry.world.shared;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

class ObjectNamesTest {
    @Test
    void anObjectIsToldByItsKindAndItsName() {
        SphereObject ball = new SphereObject(new Point(), 1);
        assertThat(ObjectNames.kindAndName(ball)).isEqualTo("sphere without a name");
        assertThat(ObjectNames.kindAndName(ball.named("a \"b\"\n"))).isEqualTo("sphere \"a \\\"b\\\"\\u000a\"");
    }
}
