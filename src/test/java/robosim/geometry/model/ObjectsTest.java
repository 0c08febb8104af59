package robosim.geometry.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.InvalidClassException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.ObjectStreamClass;
import java.io.ObjectStreamConstants;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject.RoundedBox;

class ObjectsTest {
    private static final int[][] TETRAHEDRON = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

    private static MeshObject tetrahedron() {
        return new MeshObject(
                List.of(new Point(), new Point(1, 0, 0), new Point(0, 0, 1), new Point(0, 1, 0)), TETRAHEDRON);
    }

    static Stream<GeometryObject> shapes() {
        BoxObject box = new BoxObject(new Point(1, 2, 3), 4, 5, 6);
        CylinderObject cylinder = new CylinderObject(new Point(1, 2, 3), 4, 5);
        return Stream.of(
                box,
                cylinder,
                new SphereObject(new Point(1, 2, 3), 4),
                tetrahedron(),
                tetrahedron().solid(),
                new ObjectGroup(List.of(box.turned(10, 20), new ObjectGroup(List.of(cylinder, tetrahedron())))));
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void aShapeIsAValueThatSurvivesSerialization(GeometryObject shape) throws Exception {
        for (GeometryObject object : List.of(
                shape,
                shape.named("wall"),
                shape.moveable("robot")
                        .movedTo(new Point(7, 8, 9))
                        .turned(0, 0.1)
                        .turned(0, 0.1),
                shape.turned(33, 44),
                shape.withMaterial(Material.of(Color.BLACK)))) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
                out.writeObject(object);
            }
            try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
                Object read = in.readObject();
                assertThat(read).isEqualTo(object).hasSameHashCodeAs(object);
                // The lost rounding of the heading came along too: the next turn gives the same bits.
                assertThat(((GeometryObject) read).turned(0, 0.1).rotation())
                        .isEqualTo(object.turned(0, 0.1).rotation());
            }
        }
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void changesMakeNewValues(GeometryObject shape) {
        GeometryObject moved = shape.movedTo(new Point(1, 1, 1));
        assertThat(moved.center()).isEqualTo(new Point(1, 1, 1));
        assertThat(moved.rotation()).isEqualTo(shape.rotation());
        GeometryObject robot = shape.moveable("r");
        assertThat(robot.isMoveable()).isTrue();
        assertThat(robot.name()).isEqualTo("r");
        assertThat(shape.isMoveable()).isFalse();
        assertThat(shape.name()).isNull();
        assertThat(shape.named("w").isMoveable()).isFalse();
        assertThat(robot.named("s").isMoveable()).isTrue();
        assertThat(robot).isNotEqualTo(shape);
        robot.rotation()[0] = 17;
        assertThat(robot.rotation()[0]).isEqualTo(1);
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void aMaterialStaysWithItsObject(GeometryObject shape) {
        Material red = Material.of(Color.parse("#ff0000")).withLabel(3);
        assertThat(shape.material()).isSameAs(Material.DEFAULT);
        GeometryObject painted = shape.withMaterial(red);
        assertThat(painted.material()).isEqualTo(red);
        assertThat(painted).isNotEqualTo(shape);
        assertThat(painted.withMaterial(Material.DEFAULT)).isEqualTo(shape);
        assertThat(painted).as("sentences are about shapes").hasToString(shape.toString());
        for (GeometryObject changed : List.of(
                painted.named("n"),
                painted.moveable("m"),
                painted.movedTo(new Point(1, 2, 3)),
                painted.turned(1, 2),
                painted.oriented(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}),
                painted.at(Pose.of(new Point(), 5)))) {
            assertThat(changed.material()).isSameAs(red);
        }
        assertThat(painted.moveable("m").withMaterial(Material.DEFAULT).isMoveable())
                .isTrue();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> shape.withMaterial(null))
                .withMessage("material must be given (got: null)");
    }

    @Test
    void aPositiveYawTurnsForwardToMinusZ() {
        BoxObject box = new BoxObject(new Point(), 1, 1, 1).turned(0, 90);
        assertThat(box.rotation()).containsExactly(0, 0, 1, 0, 1, 0, -1, 0, 0);
        assertThat(box.heading()).isEqualTo(90);
        assertThat(box.turned(0, 90).heading()).isEqualTo(180);
        assertThat(box.turned(0, 180).heading()).isEqualTo(-90);
    }

    @Test
    void theTurnAboutXComesAfterTheTurnAboutY() {
        double[] r = new BoxObject(new Point(), 1, 1, 1).turned(90, 90).rotation();
        // Own X is where the yaw took it; own Y went about it to what was the own Z after the yaw, the world's X.
        assertThat(r).containsExactly(0, 1, 0, 0, 0, -1, -1, 0, 0);
    }

    @Test
    void manySmallTurnsDoNotDrift() {
        BoxObject box = new BoxObject(new Point(), 1, 1, 1);
        for (int k = 0; k < 100_000; k++) {
            box = box.turned(0, 0.1);
        }
        assertThat(box.heading()).isCloseTo(10_000 - 28 * 360, within(1e-10)); // -80
    }

    @Test
    void aGivenRotationIsKeptAsGiven() {
        double[] given = {0.6, 0, 0.8, 0, 1, 0, -0.8, 0, 0.6};
        assertThat(new SphereObject(new Point(), 1).oriented(given).rotation()).isEqualTo(given);
        given[0] = 0.7;
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SphereObject(new Point(), 1).oriented(given))
                .withMessageContaining("rotation")
                .withMessageContaining("0.7");
        double[] mirror = {1, 0, 0, 0, 1, 0, 0, 0, -1};
        assertThatIllegalArgumentException().isThrownBy(() -> new SphereObject(new Point(), 1).oriented(mirror));
        assertThatIllegalArgumentException().isThrownBy(() -> new SphereObject(new Point(), 1).oriented(new double[8]));
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, -1, -Double.MIN_VALUE, 0x1.0000000000001p100})
    void sizesThatCanNotBeAreRefusedByName(double bad) {
        Point o = new Point();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new BoxObject(o, bad, 1, 1))
                .withMessageContaining("width")
                .withMessageContaining(String.valueOf(bad));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new BoxObject(o, 1, bad, 1))
                .withMessageContaining("height");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new BoxObject(o, 1, 1, bad))
                .withMessageContaining("length");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new CylinderObject(o, bad, 1))
                .withMessageContaining("radius");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new CylinderObject(o, 1, bad))
                .withMessageContaining("height");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SphereObject(o, bad))
                .withMessageContaining("radius");
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.NEGATIVE_INFINITY, -0x1.0000000000001p100})
    void coordinatesThatCanNotBeAreRefusedByName(double bad) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Point(bad, 0, 0))
                .withMessageContaining("x must");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Point(0, bad, 0))
                .withMessageContaining("y must");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Point(0, 0, bad))
                .withMessageContaining("z must");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Move(0, bad, 0, 0, 0))
                .withMessageContaining("y must");
    }

    @Test
    void theLargestAndSmallestNumbersAreLegal() {
        assertThat(new Point(0x1p100, -0x1p100, Double.MIN_VALUE).z()).isEqualTo(Double.MIN_VALUE);
        assertThat(new BoxObject(new Point(), 0x1p100, 0, Double.MIN_VALUE).height())
                .isZero();
        assertThat(Double.doubleToRawLongBits(new Point(-0.0, 0, 0).x())).isZero();
        assertThat(new Point(-0.0, 0, 0)).isEqualTo(new Point());
    }

    @Test
    void aRayNeedsADirectionAndAnAngleMustBeFinite() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Ray(new Point(), new Point(0, -0.0, 0)))
                .withMessageContaining("direction");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Move(0, 0, 0, Double.POSITIVE_INFINITY, 0))
                .withMessageContaining("rx");
        assertThat(new Move(0, 0, 0, 1e300, -7200).ry()).isEqualTo(-7200);
    }

    @Test
    void facesThatCanNotBeAreRefused() {
        List<Point> three = List.of(new Point(), new Point(1, 0, 0), new Point(0, 1, 0));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new MeshObject(three, new int[][] {{0, 1, 3}}))
                .withMessageContaining("faces[0]")
                .withMessageContaining("3");
        assertThatIllegalArgumentException().isThrownBy(() -> new MeshObject(three, new int[][] {{0, -1, 2}}));
        assertThatIllegalArgumentException().isThrownBy(() -> new MeshObject(three, new int[][] {{0, 1}}));
        assertThatIllegalArgumentException().isThrownBy(() -> new MeshObject(three, new int[][] {{0, 1, 2, 0, 1}}));
        assertThatIllegalArgumentException().isThrownBy(() -> new MeshObject(three, new int[][] {null}));
        assertThatIllegalArgumentException().isThrownBy(() -> new MeshObject(three, new int[0][]));
        assertThatIllegalArgumentException().isThrownBy(() -> new MeshObject(List.of(), new int[][] {{0, 0, 0}}));
        assertThatIllegalArgumentException().isThrownBy(() -> new ObjectGroup(List.of()));
    }

    @Test
    void onlyAClosedMeshCanBeSolid() {
        assertThat(tetrahedron().solid().isSolid()).isTrue();
        MeshObject open = new MeshObject(tetrahedron().vertices(), new int[][] {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}});
        assertThatIllegalArgumentException().isThrownBy(open::solid).withMessageContaining("closed");
        // The same surface with a corner of its own for each face is closed once equal corners are joined.
        List<Point> v = tetrahedron().vertices();
        MeshObject soup = new MeshObject(
                List.of(
                        v.get(0), v.get(2), v.get(1), v.get(0), v.get(1), v.get(3), v.get(1), v.get(2), v.get(3),
                        v.get(2), v.get(0), v.get(3)),
                new int[][] {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}});
        assertThat(soup.solid().isSolid()).isTrue();
    }

    @Test
    void aBoundingVolumeMustEnclose() {
        List<Point> v = tetrahedron().vertices();
        SphereObject large = new SphereObject(new Point(), 1);
        assertThat(new MeshObject(v, TETRAHEDRON, large).boundingVolume()).isEqualTo(large);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new MeshObject(v, TETRAHEDRON, new SphereObject(new Point(), 0.999)))
                .withMessageContaining("boundingVolume");
        assertThatIllegalArgumentException().isThrownBy(() -> new MeshObject(v, TETRAHEDRON, tetrahedron()));
        GeometryObject ball = new SphereObject(new Point(1, 0, 0), 1);
        assertThat(new ObjectGroup(List.of(ball), new BoxObject(new Point(1, 0, 0), 2, 2, 2)).boundingVolume())
                .isNotNull();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ObjectGroup(List.of(ball), new BoxObject(new Point(1, 0, 0), 2, 2, 1.99)));
        assertThat(new ObjectGroup(List.of(ball), new CylinderObject(new Point(1, 0, 0), 1, 2)).boundingVolume())
                .isNotNull();
    }

    @Test
    void namesMustBeVisible() {
        assertThatIllegalArgumentException().isThrownBy(() -> tetrahedron().moveable(" "));
        assertThatIllegalArgumentException().isThrownBy(() -> tetrahedron().named(null));
    }

    /** Its sizes are all there is to a shape that has them, and its rounded box reaches as far as it does in any direction. */
    @Test
    void sizesAndRoundedBoxesTellTheShape() {
        SplittableRandom random = new SplittableRandom(38);
        int turned = 0;
        for (GeometryObject.Kind kind : GeometryObject.Kind.values()) {
            if (!kind.isSized()) {
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> kind.of(new Point()))
                        .withMessageContaining(kind.word());
                continue;
            }
            for (int k = 0; k < 50; k++) {
                double[] sizes = random.doubles(kind.sizes().size(), 0, 4)
                        .map(Math::rint)
                        .toArray();
                GeometryObject upright = kind.of(new Point(1, 2, 3), sizes);
                assertThat(upright.kind()).isEqualTo(kind);
                assertThat(upright.sizes()).containsExactly(sizes);
                GeometryObject shape = upright.turned(random.nextInt(4) * 20, random.nextInt(360));
                turned += shape.pose().isUpright() ? 0 : 1;
                assertThat(kind.of(new Point(), shape.sizes()).at(shape.pose())).isEqualTo(shape);
                RoundedBox box = shape.roundedBox();
                double[] r = shape.rotation();
                Bounds bounds = shape.bounds();
                double[] extents = {bounds.width(), bounds.height(), bounds.length()};
                for (int axis = 0; axis < 3; axis++) {
                    double[] along = {Math.abs(r[3 * axis]), Math.abs(r[3 * axis + 1]), Math.abs(r[3 * axis + 2])};
                    double half =
                            along[0] * box.halfWidth() + along[1] * box.halfHeight() + along[2] * box.halfLength();
                    double rim = box.disc() * Math.hypot(along[0], along[2]);
                    assertThat(extents[axis]).as("%s", shape).isCloseTo(2 * (half + rim + box.ball()), within(1e-12));
                }
            }
        }
        assertThat(turned).isBetween(60, 190);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> GeometryObject.Kind.BOX.of(new Point(), 1, 2))
                .withMessageContaining("width, height, length")
                .withMessageContaining("got: 2");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> tetrahedron().roundedBox())
                .withMessageContaining("mesh");
    }

    /** A stream that names the class itself, and not its serial form, makes no object past its constructor. */
    @ParameterizedTest
    @ValueSource(
            classes = {
                BoxObject.class,
                CylinderObject.class,
                SphereObject.class,
                CapsuleObject.class,
                MeshObject.class,
                ObjectGroup.class,
                GridObject.class
            })
    void noObjectIsMadePastItsConstructor(Class<?> shape) throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeShort(ObjectStreamConstants.STREAM_MAGIC);
            out.writeShort(ObjectStreamConstants.STREAM_VERSION);
            out.writeByte(ObjectStreamConstants.TC_OBJECT);
            out.writeByte(ObjectStreamConstants.TC_CLASSDESC);
            out.writeUTF(shape.getName());
            out.writeLong(ObjectStreamClass.lookup(shape).getSerialVersionUID());
            out.writeByte(ObjectStreamConstants.SC_SERIALIZABLE);
            out.writeShort(0); // fields
            out.writeByte(ObjectStreamConstants.TC_ENDBLOCKDATA);
            out.writeByte(ObjectStreamConstants.TC_NULL); // no superclass that is serialized
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            assertThatExceptionOfType(InvalidClassException.class)
                    .isThrownBy(in::readObject)
                    .withMessageContaining(shape.getSimpleName());
        }
    }
}
