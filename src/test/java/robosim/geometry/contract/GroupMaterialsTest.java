package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;
import robosim.geometry.net.Session;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.sensor.Intrinsics;
import robosim.geometry.sensor.SegmentationCamera;
import robosim.geometry.sensor.SegmentationFrame;

/** What the parts of groups are made of, for all that ask: members of the default material are made of the group's. */
class GroupMaterialsTest {
    private final SplittableRandom random = new SplittableRandom(20);

    private Material material() {
        return switch (random.nextInt(4)) {
            case 0 -> Material.DEFAULT.withLabel(random.nextInt(1, 1000));
            case 1 -> Material.of(new Color(random.nextDouble(), random.nextDouble(), random.nextDouble()));
            default -> Material.DEFAULT;
        };
    }

    private Point place() {
        return new Point(random.nextDouble(-3, 3), random.nextDouble(-3, 3), random.nextDouble(-3, 3));
    }

    private ObjectGroup group(int depth) {
        List<GeometryObject> members = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            GeometryObject member = depth > 0 && random.nextBoolean()
                    ? group(depth - 1).movedTo(place()).turned(0, random.nextDouble(-180, 180))
                    : new SphereObject(place(), random.nextDouble(0.3, 0.8)).turned(20, 30);
            members.add(member.withMaterial(material()));
        }
        return new ObjectGroup(members);
    }

    /** One part after the other, each by its own walk from the top: where it stands, and the nearest material. */
    private static void walk(ObjectGroup group, List<GeometryObject> around, List<GeometryObject> found) {
        for (GeometryObject member : group.members()) {
            List<GeometryObject> path = new ArrayList<>(around);
            path.add(member);
            if (member instanceof ObjectGroup inner) {
                walk(inner, path, found);
                continue;
            }
            Material own = Material.DEFAULT;
            int label = 0;
            for (int k = path.size() - 1; k >= 0; k--) {
                Material told = path.get(k).material();
                own = own.isDefault() ? told : own;
                label = label == 0 ? told.label() : label;
            }
            GeometryObject placed = member;
            for (int k = path.size() - 2; k > 0; k--) {
                placed = placed.at(placed.pose().within(path.get(k).pose()));
            }
            found.add(placed.withMaterial(own.withLabel(label)));
        }
    }

    @Test
    void partsOfRandomGroups() {
        int inherited = 0;
        int deep = 0;
        for (int round = 0; round < 300; round++) {
            GeometryObject top = group(round % 4).withMaterial(material()).movedTo(place());
            List<GeometryObject> expected = new ArrayList<>();
            walk((ObjectGroup) top, List.of(top), expected);
            List<GeometryObject> parts = ((ObjectGroup) top).parts();
            assertThat(parts).hasSameSizeAs(expected);
            for (int k = 0; k < parts.size(); k++) {
                assertThat(parts.get(k).material()).isEqualTo(expected.get(k).material());
                assertThat(apart(parts.get(k).center(), expected.get(k).center()))
                        .isLessThan(1e-13);
                for (int j = 0; j < 9; j++) {
                    assertThat(Math.abs(
                                    parts.get(k).rotation()[j] - expected.get(k).rotation()[j]))
                            .isLessThan(1e-14);
                }
                inherited += parts.get(k).material().equals(top.material())
                                && !top.material().isDefault()
                        ? 1
                        : 0;
            }
            deep += round % 4 > 1 ? parts.size() : 0;
        }
        assertThat(inherited).isGreaterThan(100);
        assertThat(deep).isGreaterThan(1000);
    }

    private static double apart(Point a, Point b) {
        return Math.max(Math.abs(a.x() - b.x()), Math.max(Math.abs(a.y() - b.y()), Math.abs(a.z() - b.z())));
    }

    @Test
    void partsOfAFlatGroupAreItsMembers() {
        GeometryObject plain = new BoxObject(new Point(1, 0, 0), 1, 1, 1);
        GeometryObject red = new SphereObject(new Point(), 1).withMaterial(Material.of(Color.parse("#ff0000")));
        ObjectGroup group = new ObjectGroup(List.of(plain, red, plain));
        assertThat(group.parts()).isEqualTo(group.members());
        Material blue = Material.of(Color.parse("#0000ff")).withLabel(3);
        assertThat(group.withMaterial(blue).movedTo(new Point(5, 5, 5)).parts())
                .containsExactly(
                        plain.withMaterial(blue),
                        red.withMaterial(red.material().withLabel(3)),
                        plain.withMaterial(blue));
    }

    /** A group's material, given after it was made, for a camera of labels, a session and a picture. */
    @Test
    void whoeverLooksSeesTheSame() {
        int seenAlone = 0;
        for (int round = 0; round < 12; round++) {
            Material own = Material.of(new Color(random.nextDouble(), random.nextDouble(), 0.3))
                    .withLabel(round);
            GeometryObject top = group(2).movedTo(new Point(14, 0, 0)).withMaterial(own);
            GeometryObject eye = new SphereObject(new Point(), 0.01).moveable("eye");
            Geometry world = new Geometry(60, 60, 60);
            Geometry single = new Geometry(60, 60, 60); // the parts as objects of their own
            world.addObjectUnchecked(top);
            world.addObjectUnchecked(eye);
            for (GeometryObject part : ((ObjectGroup) top).parts()) {
                single.addObjectUnchecked(part.at(part.pose().within(top.pose())));
            }
            RayPattern pattern = RayPattern.pinhole(24, 18, 50);
            SenseBuffer each = new SenseBuffer(Extra.OBJECTS);
            single.sense(Pose.ORIGIN, pattern, SenseOptions.range(0, 100), each);

            SegmentationFrame labels = new SegmentationFrame();
            SegmentationCamera.of(Intrinsics.fieldOfView(24, 18, 50))
                    .on("eye", Pose.ORIGIN)
                    .read(world, labels);
            Session session = new Session();
            session.reply(new InitBundle(
                    List.of(top, eye), new WorldSettings(60, 60, 60, world.dimension(), world.accuracy())));
            SenseRequest request = new SenseRequest(
                    "eye",
                    Mount.CENTER,
                    new BeamPattern.Pinhole(24, 18, Math.toRadians(50)),
                    0,
                    100,
                    0,
                    false,
                    false,
                    true,
                    null,
                    false,
                    List.of());
            SenseAnswer answer =
                    (SenseAnswer) ((BatchAnswerBundle) session.reply(new BatchRequestBundle(List.of(request)))
                                    .bundle())
                            .answers()
                            .get(0);
            for (int k = 0; k < pattern.size(); k++) {
                GeometryObject met = each.object(k);
                int label = met == null ? 0 : met.material().label();
                assertThat(labels.label(k)).isEqualTo(label);
                assertThat(answer.labels().get(k)).isEqualTo(label);
                seenAlone += label == round && round > 0 ? 1 : 0;
            }

            ColorFrame whole = new ColorFrame();
            ColorFrame parts = new ColorFrame();
            ColorCamera camera = ColorCamera.of(24, 18, 50).on("eye", Pose.ORIGIN);
            camera.render(world, whole);
            camera.at(Pose.ORIGIN).render(single, parts);
            int same = 0;
            for (int k = 0; k < pattern.size(); k++) {
                same += whole.pixels()[k] == parts.pixels()[k] ? 1 : 0;
            }
            // Poses are rounded twice for parts of their own: at most edges may differ.
            assertThat(same).isGreaterThan(pattern.size() * 98 / 100);
        }
        assertThat(seenAlone).isGreaterThan(200);
    }
}
