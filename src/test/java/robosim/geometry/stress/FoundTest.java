package robosim.geometry.stress;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.overlap.SpatialOverlap;
import robosim.geometry.narrow.ray.PlanarRay;
import robosim.geometry.narrow.ray.SpatialRay;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.narrow.sweep.SpatialSweep;

/** What a stress run has found wrong once, in the numbers that it found. */
class FoundTest {
    /** It starts 1e-17 above a box that is thinner than any rounding, and goes away from it. */
    @Test
    void aRayFromJustBesideAFlatBoxMisses() {
        double cos = 0x1.f3b92138b3964p-2;
        double sin = -0x1.bee48faab16e3p-1;
        double[] box = new double[16];
        box[3] = 0x1.743799ce872dap-1;
        box[4] = 1;
        box[5] = Double.MIN_VALUE;
        Forms.upright(box, cos, sin);
        double distance = PlanarRay.distance(
                new BeamAxis()
                        .line(
                                -0x1.107814fb7f712p-2,
                                0,
                                -0x1.e753e44686f26p-2,
                                0x1.6b4ac6a501e23p-3,
                                0,
                                0x1.44e2982f04a19p-2),
                LeafKind.UPRIGHT_BOX,
                box,
                0,
                new Scratch().ray);
        assertThat(distance).isInfinite();
    }

    /** A side of 5e-324 is parallel to all others, as far as products that underflow can tell. */
    @Test
    void aBoxOfNoHeightThrowsItsWholeShadow() {
        double[] disc = new double[16];
        disc[2] = -1;
        double[] box = {
            0x1.0def1faaed8c4p-1,
            -0x1.8832dcab9e788p-2,
            -0x1.4283e76aab848p1,
            2,
            Double.MIN_VALUE,
            0.5,
            0x1.2183249acded2p-2,
            -0x1.47231b531975ep-1,
            0x1.6e4b2532da379p-1,
            -0x1.7345cd99ffdf2p-2,
            0x1.3d181f92c672ap-1,
            0x1.648f21e4d8476p-1,
            -0x1.c6aca59a2d23ep-1,
            -0x1.d33b826ad65aap-2,
            -0x1.cf599dded3e4p-5,
            0
        };
        assertThat(PlanarOverlap.test(
                        new Leaf(LeafKind.SPHERE, disc, 0), new Leaf(LeafKind.BOX, box, 0), new Scratch().overlap))
                .isTrue();
    }

    /** A long thin tetrahedron in the difference of the two seems to hold the origin, by rounding alone. */
    @Test
    void aTinySphereBesideALongTurnedCylinderIsApart() {
        double[] sphere = new double[16];
        sphere[0] = -0x1.b5b16c9ef1d66p0;
        sphere[1] = -0x1.1d8a666c1e1p-6;
        sphere[2] = 0x1.b2cc850e3b4fp-1;
        sphere[3] = 0x1.94e61dcf6c384p-28;
        double[] cylinder = {
            -0x1.11347dae68de8p1,
            -0x1.940e9ce853dacp-2,
            0x1.e01b33b6f318ap-2,
            0x1.52848a91f4daep-1,
            0x1.e13ae11b04c4dp12,
            0x1.c1c7da6c05fecp-2,
            0x1.1c499c6659306p-1,
            0x1.3341c66af8ee5p-1,
            -0x1.26d175661a555p-1,
            0x1.9a5e1a2eacdfp-1,
            -0x1.24520f720cc18p-1,
            0x1.6c39099f822e5p-3,
            -0x1.c6b7d7ea583fcp-3,
            -0x1.1edaeab97674p-1,
            -0x1.9893b03d5784ap-1,
            0
        };
        assertThat(SpatialOverlap.test(
                        new Leaf(LeafKind.SPHERE, sphere, 0),
                        new Leaf(LeafKind.CYLINDER, cylinder, 0),
                        new Scratch().overlap))
                .isFalse();
    }

    /** Numbers so small that half of one, or a quarter, is another. */
    @Test
    void meshesOfSubnormalSizeKeepTheirTriangles() {
        double tiny = Double.MIN_VALUE;
        List<Point> corners = List.of(
                new Point(7 * tiny, 10 * tiny, 10 * tiny),
                new Point(8 * tiny, -10 * tiny, -7 * tiny),
                new Point(-9 * tiny, 6 * tiny, -7 * tiny));
        MeshObject triangle = new MeshObject(corners, new int[][] {{0, 1, 2}});
        for (Point corner : corners) {
            BoxObject point = new BoxObject(corner, 0, 0, 0);
            assertThat(CollisionDetection.intersects(triangle, point)).isTrue();
        }
    }

    /** 5e-324 is a direction's coordinate like any other: this ray rises above the edge that it starts at the height of. */
    @Test
    void aDirectionKeepsTheLeastOfItsCoordinates() {
        MeshObject triangle = new MeshObject(
                List.of(new Point(-1, 0, 0), new Point(-1, -1, 1), new Point(-1, 0, 2)), new int[][] {{0, 1, 2}});
        assertThat(distance(new Point(-8, 0, 0), triangle)).isEqualTo(8);
        assertThat(distance(new Point(-8, Double.MIN_VALUE, 0), triangle)).isInfinite();
    }

    /** It starts 5e-324 below a disc and goes down: a share of time so short is no zero. */
    @Test
    void aRayFromJustBelowADiscMisses() {
        double[] disc = new double[16];
        disc[3] = 3;
        double distance = SpatialRay.distance(
                new BeamAxis().line(1, -Double.MIN_VALUE, 1, 0, -3, 0),
                LeafKind.UPRIGHT_CYLINDER,
                disc,
                0,
                new Scratch().ray);
        assertThat(distance).isInfinite();
    }

    private static double distance(Point direction, MeshObject object) {
        return CollisionDetection.rayDistance(new Ray(new Point(7, 0, 1), direction), object);
    }

    /** Along a diagonal towards a square, through lengths of which a share is less than the least double. */
    @Test
    void aPointOfSubnormalSizeDoesNotPassThroughABox() {
        double unit = 0x1p-1060;
        double[] point = new double[16];
        point[0] = -2.5 * unit;
        point[1] = -2.5 * unit;
        point[2] = 1.25 * unit;
        double[] square = {0.5 * unit, 0.5 * unit, -1.5 * unit, 0, 0, 0.25 * unit, 0, 1, 0, 1, 0, 0, 0, 0, -1, 0};
        double time = SpatialSweep.translation(
                new Leaf(LeafKind.SPHERE, point, 0),
                6 * unit,
                6 * unit,
                -6 * unit,
                new Leaf(LeafKind.BOX, square, 0),
                new Scratch().sweep);
        assertThat(time).isEqualTo(0.5);
    }

    /** The square of 2^-1014, from corner to corner, is no number. */
    @Test
    void aDiscMeetsASideWhoseSquareUnderflows() {
        double unit = 0x1p61;
        double[] side = {0, -0.5 * unit, unit, 0, -0.5 * unit, unit, -0x1p-1014, -0.5 * unit, unit, 0, 0, 0, 0, 0, 0, 0
        };
        double[] disc = new double[16];
        disc[0] = -1.5 * unit;
        disc[2] = -1.5 * unit;
        disc[3] = unit;
        double time = PlanarSweep.translation(
                new Leaf(LeafKind.TRIANGLE, side, 0),
                -3 * unit,
                0,
                -2.5 * unit,
                new Leaf(LeafKind.SPHERE, disc, 0),
                new Scratch().sweep);
        assertThat(time).isBetween(0.5, 1.0);
    }

    /** The foot is on a side whose square has two bits: the distance to it is the height above it all the same. */
    @Test
    void aDiscBesideASideWhoseSquareIsAllButLostIsApart() {
        double[] side = {-0x1.4p-537, 0, 1, 0x1.5p-536, 0, 1, 0x1.5p-536, 0, 1, 0, 0, 0, 0, 0, 0, 0};
        double[] disc = new double[16];
        for (int k = 1; k < 16; k++) {
            disc[3] = k / 8.0;
            assertThat(PlanarOverlap.test(
                            new Leaf(LeafKind.SPHERE, disc, 0),
                            new Leaf(LeafKind.TRIANGLE, side, 0),
                            new Scratch().overlap))
                    .as("a disc of radius " + disc[3] + " under a side at 1")
                    .isEqualTo(disc[3] >= 1);
        }
    }

    /** From 1,000 away along a side, but for 1e-13 of its length: it enters at the near end. */
    @Test
    void aRayAlongASideEntersAtItsNearEnd() {
        double[] triangle = {
            0.9249278089292172,
            -0.9456710005703698,
            1.314376704204852,
            -1.32004320430771,
            -1.3701374959763393,
            -1.4200288955111997,
            -1.1046531926047445,
            -0.9133062826845862,
            -0.3972184487342023,
            0,
            0,
            0,
            0,
            0,
            0,
            0
        };
        double distance = PlanarRay.distance(
                new BeamAxis()
                        .line(677.0660113339505, 0, 824.8635245941497, -0.6602940268799037, 0, -0.8042472147362743),
                LeafKind.TRIANGLE,
                triangle,
                0,
                new Scratch().ray);
        assertThat(distance).isCloseTo(1065.551483420977, within(4 * Math.ulp(1065.0)));
    }

    /** One axis of the box is level, so that two sides are parallel but for rounding; the ray runs along both. */
    @Test
    void aRayAlongTwoSidesThatAreAllButParallelIsNotLate() {
        double[] box = {
            -0.10589361833663657,
            0.045895008048493224,
            -0.4857342044709423,
            0.7204449437632923,
            0.8471864618238465,
            0.5411624869509957,
            -0.7732375858721114,
            0.5897284576595785,
            -0.23307505662580827,
            0,
            -0.3675587775169207,
            -0.9300002930484844,
            -0.6341164213255078,
            -0.7191111814571662,
            0.28421026179328823,
            0
        };
        double distance = PlanarRay.distance(
                new BeamAxis()
                        .line(1.684165654826531, 0, -1.5323813892229832, -0.6341164213255079, 0, 0.7732375858721114),
                LeafKind.BOX,
                box,
                0,
                new Scratch().ray);
        assertThat(distance).isCloseTo(1.5412229636509853, within(1e-15));
    }

    /** Its height is 4e-11 of its width: the side that it throws is so short that a look along it goes astray. */
    @Test
    void aDiscWithinAThinTippedBoxTouchesIt() {
        double[] box = {
            8.7109253855116211E17,
            5.2422874893815245E17,
            -1.02232674589903283E18,
            1.58532880156492902E18 / 2,
            6.855546263056758E7 / 2,
            1.27110301279055181E18 / 2,
            -0.35551190533332805,
            -0.0941830940391968,
            0.9299144207740143,
            0,
            -0.9949101576638282,
            -0.10076595743273897,
            0.9346717526309795,
            -0.03582349751965006,
            0.3537024057865493,
            0
        };
        double[] disc = new double[16];
        disc[0] = 4.5936031775959693E17;
        disc[1] = 3.5578666005411328E17;
        disc[2] = -3.3086614204348531E17;
        for (double radius : new double[] {0, 1, 1e3, 1e5, 1e6, 1e9}) {
            disc[3] = radius;
            assertThat(PlanarOverlap.test(
                            new Leaf(LeafKind.SPHERE, disc, 0), new Leaf(LeafKind.BOX, box, 0), new Scratch().overlap))
                    .as("a disc of radius " + radius)
                    .isTrue();
        }
    }
}
