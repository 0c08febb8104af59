package robosim.geometry.viewer.space;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.scene.Scene;

class TracesTest {
    private static final Scene.View BORDER = Scene.View.world(20, 10);

    private static List<Trace> traces(Dimension dimension, Scene.Ping ping) {
        Scene life = Scene.of("", BORDER, List.of()).with(List.of(), List.of(ping), List.of());
        return Traces.of(new Moment(0, dimension, BORDER, List.of(), life));
    }

    private static double[] at(Trace trace, int point) {
        return new double[] {trace.points()[3 * point], trace.points()[3 * point + 1], trace.points()[3 * point + 2]};
    }

    @Test
    void aConeOpensAboutItsBeam() {
        Point start = new Point(1, 2, 3);
        List<Trace> cone = traces(Dimension.SPATIAL, new Scene.Ping(start, 90, 40, 6, 5));
        Trace fan = cone.get(0);
        assertThat(fan.kind()).isEqualTo(Trace.Kind.FAN);
        assertThat(at(fan, 0)).containsExactly(1, 2, 3);
        double highest = Double.NEGATIVE_INFINITY;
        for (int k = 1; k < fan.size(); k++) {
            double dx = at(fan, k)[0] - 1;
            double dy = at(fan, k)[1] - 2;
            double dz = at(fan, k)[2] - 3;
            assertThat(Math.sqrt(dx * dx + dy * dy + dz * dz)).isCloseTo(5, within(1e-12));
            // 90 degrees are -Z.
            assertThat(-dz / 5).isCloseTo(Math.cos(Math.toRadians(20)), within(1e-12));
            highest = Math.max(highest, dy);
        }
        assertThat(highest).isCloseTo(5 * Math.sin(Math.toRadians(20)), within(1e-12));
    }

    @Test
    void inAPlaneItIsFlat() {
        List<Trace> cone =
                traces(Dimension.PLANAR, new Scene.Ping(new Point(1, 2, 3), 0, 40, 6, Double.POSITIVE_INFINITY));
        Trace fan = cone.get(0);
        for (int k = 0; k < fan.size(); k++) {
            assertThat(at(fan, k)[1]).isEqualTo(2);
        }
        // From the right to the left, as far as it can measure; +Z is to the right of one who looks along +X.
        double side = 6 * Math.sin(Math.toRadians(20));
        assertThat(at(fan, 1)[2]).isCloseTo(3 + side, within(1e-12));
        assertThat(at(fan, fan.size() - 1)[2]).isCloseTo(3 - side, within(1e-12));
    }

    @Test
    void aRayEndsInADotAndOneWithoutEchoDoesNot() {
        List<Trace> ray = traces(Dimension.PLANAR, new Scene.Ping(new Point(0, 1, 0), 0, 0, 6, 4));
        assertThat(ray).extracting(Trace::kind).containsExactly(Trace.Kind.LINE, Trace.Kind.DOTS);
        assertThat(at(ray.get(1), 0)).containsExactly(4, 1, 0);
        List<Trace> silent =
                traces(Dimension.PLANAR, new Scene.Ping(new Point(0, 1, 0), 0, 0, 6, Double.POSITIVE_INFINITY));
        assertThat(silent).extracting(Trace::kind).containsExactly(Trace.Kind.LINE);
        double none = Double.POSITIVE_INFINITY;
        assertThat(traces(Dimension.PLANAR, new Scene.Ping(new Point(0, 1, 0), 0, 20, none, none)))
                .isEmpty();
    }

    @Test
    void whatIsBehindAWallIsHidden() {
        Geometry world = new Geometry(20, 20, 20);
        world.addObject(new BoxObject(new Point(0, 0, 0), 1, 4, 4));
        double[] points = {-0.5, 0, 0, 0.5, 0, 0, 5, 0, 0, 5, 5, 0, -5, 0, 0};
        Trace line = Trace.of(Trace.Kind.LINE, points, Palette.TEXT, 1, 1);
        Trace found =
                Traces.hidden(List.of(line), new Point(-5, 0, 0), null, world).get(0);
        // On the near side of the wall, on its far side, behind it, above it, and in the eye itself.
        assertThat(found.seen()).containsExactly(true, false, false, true, true);
    }
}
