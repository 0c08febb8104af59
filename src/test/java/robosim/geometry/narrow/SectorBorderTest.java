package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * The border of a sector enters a short edge, which doubles take to be as deep everywhere: the corner outside, up to 280,000
 * ulp too near, was answered for it. What is expected is the place of the entry, computed elsewhere in rational numbers.
 */
class SectorBorderTest {
    private static double heard(GeometryObject object, Point start, Point way, double width) {
        Geometry world = new Geometry(1e9, 1e9, 1e9, Dimension.PLANAR, Accuracy.EXACT);
        assertThat(world.addObjectUnchecked(object)).isTrue();
        return world.getRayDistance(new Ray(start, way), 0, Double.POSITIVE_INFINITY, width);
    }

    private static void check(double heard, double truth) {
        assertThat(heard).isBetween(truth - 8 * Math.ulp(truth), truth + 8 * Math.ulp(truth));
    }

    @Test
    void ofATippedBox() {
        GeometryObject box = new BoxObject(
                        new Point(-11.970134232531978, 0.0, 199.91835920893777),
                        1.8935241444659634,
                        0.16458166873314922,
                        2.5976419939502433)
                .oriented(new double[] {
                    1.0,
                    1.1422302523345911E-17,
                    2.355835708791034E-10,
                    0.0,
                    0.9999999999999988,
                    -4.848514045662201E-8,
                    -2.3558357087910373E-10,
                    4.848514045662201E-8,
                    0.9999999999999988
                });
        Point way = new Point(-0.02685842920743875, 0.1713857363825293, 0.490265702043269);
        check(heard(box, new Point(), way, 4.609510438969111E-6), 201.51890319598309);
    }

    @Test
    void ofATriangle() {
        GeometryObject triangle = new MeshObject(
                List.of(
                        new Point(-69.6836802896449, 2.585777322213937, 79.89114655377546),
                        new Point(-69.67779445831528, 3.0185781622856642, 79.75126243148085),
                        new Point(-69.67779456521816, 3.0185782002302144, 79.75126235379882)),
                new int[][] {{0, 1, 2}});
        Point start = new Point(-4.986461014055318, 2.5406507327862844, 2.356319726973619);
        Point way = new Point(-0.6801403834005657, -0.7323748478825707, 0.8137012141661348);
        check(heard(triangle, start, way, 1e-5), 100.87093625438950);
    }

    @Test
    void ofATriangleInAWiderSector() {
        GeometryObject triangle = new MeshObject(
                List.of(
                        new Point(6777.257305980075, 0.0023658458724065885, -14446.833343034827),
                        new Point(6777.282687830114, 3.624408162407543, -14445.701388414825),
                        new Point(6777.282687830159, 3.6244081623879087, -14445.70138841487)),
                new int[][] {{0, 1, 2}});
        Point way = new Point(0.25610150960735667, -0.3456514659263539, -0.41483452320096625);
        check(heard(triangle, new Point(), way, 13.11112323969708), 15956.498652085727);
    }
}
