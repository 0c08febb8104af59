package robosim.geometry.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PointTest {
    @Test
    void a() {
        assertThat(new Point(1, 2, 3).x()).isEqualTo(1);
    }
}
