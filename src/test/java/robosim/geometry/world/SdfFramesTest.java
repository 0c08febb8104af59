package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;

/**
 * Where things stand in random trees of models, links, frames and joints whose poses count from each other, against a slow
 * twin: 4 x 4 matrices in SDFormat's own axes, multiplied along the way from each thing to the world.
 */
class SdfFramesTest {
    @TempDir
    Path folder;

    /** How poses are made: of any angles, or of quarter turns and whole places, where all is exact. */
    private enum Sort {
        ANY,
        QUARTERS
    }

    /** A thing with a frame, as the twin knows it. */
    private static final class Thing {
        final String kind;
        final String name;
        final @Nullable Thing model;
        final List<Thing> parts = new ArrayList<>();
        double[][] pose = identity();
        String poseText = "";

        /** What its pose counts from; null where the default holds. */
        @Nullable
        Thing base;

        String baseName = "";

        /** Of a frame: what it is attached to; of a joint: its child. */
        @Nullable
        Thing other;

        String otherName = "";

        /** Of a model: what its pose is about. */
        @Nullable
        Thing placement;

        String placementName = "";

        Thing(String kind, String name, @Nullable Thing model) {
            this.kind = kind;
            this.name = name;
            this.model = model;
        }

        /** In the frame of a model around it. */
        double[][] in(@Nullable Thing root) {
            if (this == root) {
                return identity();
            }
            Thing from = base != null ? base : other != null ? other : model;
            double[][] matrix = times(from == null ? identity() : from.in(root), pose);
            return placement == null ? matrix : times(matrix, inverse(placement.in(this)));
        }
    }

    private static double[][] identity() {
        return new double[][] {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    }

    private static double[][] times(double[][] a, double[][] b) {
        double[][] product = new double[4][4];
        for (int row = 0; row < 4; row++) {
            for (int column = 0; column < 4; column++) {
                for (int k = 0; k < 4; k++) {
                    product[row][column] += a[row][k] * b[k][column];
                }
            }
        }
        return product;
    }

    private static double[][] inverse(double[][] m) {
        double[][] inverse = identity();
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                inverse[row][column] = m[column][row];
                inverse[row][3] -= m[column][row] * m[column][3];
            }
        }
        return inverse;
    }

    /** As SDFormat says it: a turn about X, then Y, then Z, all of them fixed; then a move. */
    private static double[][] matrix(double x, double y, double z, double roll, double pitch, double yaw) {
        double[][] aboutX = identity();
        aboutX[1] = new double[] {0, StrictMath.cos(roll), -StrictMath.sin(roll), 0};
        aboutX[2] = new double[] {0, StrictMath.sin(roll), StrictMath.cos(roll), 0};
        double[][] aboutY = identity();
        aboutY[0] = new double[] {StrictMath.cos(pitch), 0, StrictMath.sin(pitch), 0};
        aboutY[2] = new double[] {-StrictMath.sin(pitch), 0, StrictMath.cos(pitch), 0};
        double[][] aboutZ = identity();
        aboutZ[0] = new double[] {StrictMath.cos(yaw), -StrictMath.sin(yaw), 0, 0};
        aboutZ[1] = new double[] {StrictMath.sin(yaw), StrictMath.cos(yaw), 0, 0};
        double[][] moved = times(aboutZ, times(aboutY, aboutX));
        moved[0][3] = x;
        moved[1][3] = y;
        moved[2][3] = z;
        return moved;
    }

    /** The quaternion of a turn about an axis. */
    private static double[][] matrix(double x, double y, double z, double[] q) {
        // Its columns are where it takes the axes: v + 2 w (u x v) + 2 u x (u x v).
        double[][] m = identity();
        for (int axis = 0; axis < 3; axis++) {
            double[] v = {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
            double[] once = cross(q, v);
            double[] twice = cross(q, once);
            for (int row = 0; row < 3; row++) {
                m[row][axis] = v[row] + 2 * (q[3] * once[row] + twice[row]);
            }
        }
        m[0][3] = x;
        m[1][3] = y;
        m[2][3] = z;
        return m;
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static void place(Thing thing, Sort sort, SplittableRandom random) {
        String relative = thing.baseName.isEmpty() ? "" : " relative_to=\"" + thing.baseName + "\"";
        if (random.nextInt(8) == 0) { // none, or one that says only what it counts from
            thing.poseText = relative.isEmpty() ? "" : "<pose" + relative + "/>";
            return;
        }
        double[] p = new double[6];
        for (int k = 0; k < 6; k++) {
            p[k] = sort == Sort.QUARTERS
                    ? (k < 3 ? random.nextInt(-9, 10) : 90 * random.nextInt(-4, 5))
                    : random.nextDouble(-4, 4);
            if (k >= 3 && random.nextInt(3) == 0) {
                p[k] = 0; // upright ones too
            }
        }
        if (sort == Sort.QUARTERS) {
            thing.pose = matrix(
                    p[0],
                    p[1],
                    p[2],
                    StrictMath.toRadians(p[3]),
                    StrictMath.toRadians(p[4]),
                    StrictMath.toRadians(p[5]));
            for (double[] row : thing.pose) {
                for (int k = 0; k < 4; k++) {
                    row[k] = Math.rint(row[k]);
                }
            }
            boolean inDegrees = random.nextBoolean();
            for (int k = 3; k < 6; k++) {
                p[k] = inDegrees ? p[k] : p[k] / 90 * (Math.PI / 2);
            }
            thing.poseText = "<pose" + relative + (inDegrees ? " degrees=\"true\"" : "") + ">" + text(p) + "</pose>";
        } else if (random.nextInt(3) == 0) {
            double[] q = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1), 0.3};
            double norm = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
            double[] unit = {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
            thing.pose = matrix(p[0], p[1], p[2], unit);
            thing.poseText = "<pose" + relative + " rotation_format=\"quat_xyzw\">"
                    + text(p[0], p[1], p[2], q[0], q[1], q[2], q[3]) + "</pose>";
        } else {
            thing.pose = matrix(p[0], p[1], p[2], p[3], p[4], p[5]);
            thing.poseText = "<pose" + relative + " rotation_format=\"euler_rpy\">" + text(p) + "</pose>";
        }
    }

    private static String text(double... numbers) {
        StringBuilder text = new StringBuilder();
        for (double number : numbers) {
            text.append(text.isEmpty() ? "" : " ").append(number);
        }
        return text.toString();
    }

    /** Another name of the scope, or of a model in it, that is there already: so nothing goes in a circle. */
    private static @Nullable String pick(List<Thing> earlier, Thing[] found, SplittableRandom random) {
        if (earlier.isEmpty() || random.nextInt(3) == 0) {
            return null;
        }
        Thing thing = earlier.get(random.nextInt(earlier.size()));
        StringBuilder name = new StringBuilder(thing.name);
        while (thing.kind.equals("model") && !thing.parts.isEmpty() && random.nextInt(3) > 0) {
            thing = thing.parts.get(random.nextInt(thing.parts.size()));
            name.append("::").append(thing.name);
        }
        found[0] = thing;
        return name.toString();
    }

    private static Thing model(
            String name, @Nullable Thing outer, List<Thing> beside, int depth, Sort sort, SplittableRandom random) {
        Thing model = new Thing("model", name, outer);
        Thing[] found = new Thing[1];
        String base = pick(beside, found, random);
        if (base != null) {
            model.base = found[0];
            model.baseName = base;
        }
        place(model, sort, random);
        int count = random.nextInt(2, 7);
        for (int k = 0; k < count; k++) {
            int kind = random.nextInt(depth > 0 ? 5 : 4);
            if (kind == 4) {
                model.parts.add(model("m" + k, model, model.parts, depth - 1, sort, random));
                continue;
            }
            Thing part = new Thing(kind < 2 || k == 0 ? "link" : kind == 2 ? "frame" : "joint", "p" + k, model);
            String other = part.kind.equals("link") ? null : pick(model.parts, found, random);
            if (part.kind.equals("joint") && other == null) {
                found[0] = model.parts.get(0);
                other = found[0].name;
            }
            if (other != null) {
                part.other = found[0];
                part.otherName = other;
            }
            String relative = pick(model.parts, found, random);
            if (relative != null) {
                part.base = found[0];
                part.baseName = relative;
            }
            place(part, sort, random);
            model.parts.add(part);
        }
        if (random.nextInt(3) == 0) {
            String placement = pick(model.parts, found, random);
            if (placement != null) {
                model.placement = found[0];
                model.placementName = placement;
            }
        }
        return model;
    }

    private static void write(Thing thing, StringBuilder out, SplittableRandom random) {
        out.append('<').append(thing.kind).append(" name=\"").append(thing.name).append('"');
        switch (thing.kind) {
            case "frame" -> out.append(thing.otherName.isEmpty() ? "" : " attached_to=\"" + thing.otherName + "\"");
            case "model" ->
                out.append(thing.placementName.isEmpty() ? "" : " placement_frame=\"" + thing.placementName + "\"");
            default -> {}
        }
        out.append(">\n").append(thing.poseText).append('\n');
        switch (thing.kind) {
            case "joint" -> out.append("<child>").append(thing.otherName).append("</child>");
            case "link" ->
                out.append("<collision name=\"c\"><geometry><box><size>1 2 3</size></box></geometry>"
                        + "</collision><collision name=\"d\"><pose>0 0 1 0 0 0</pose><geometry><sphere><radius>1</radius>"
                        + "</sphere></geometry></collision>\n");
            case "model" -> {
                List<Thing> shuffled = new ArrayList<>(thing.parts); // names are used before they are given
                for (int k = shuffled.size() - 1; k > 0; k--) {
                    int other = random.nextInt(k + 1);
                    Thing kept = shuffled.get(k);
                    shuffled.set(k, shuffled.get(other));
                    shuffled.set(other, kept);
                }
                shuffled.forEach(part -> write(part, out, random));
            }
            default -> {}
        }
        out.append("</").append(thing.kind).append(">\n");
    }

    private static void links(Thing thing, String path, Map<String, Thing> found) {
        for (Thing part : thing.parts) {
            if (part.kind.equals("link")) {
                found.put(path + "::" + part.name, part);
            } else {
                links(part, path + "::" + part.name, found);
            }
        }
    }

    /** SDFormat's axes are turned to the world's by a turn about X. */
    private static double[][] inOurAxes(double[][] m) {
        double[][] axes = {{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}};
        return times(times(axes, m), inverse(axes));
    }

    private static void same(GeometryObject object, double[][] sdf, double tolerance) {
        double[][] expected = inOurAxes(sdf);
        double[] center = {
            object.center().x(), object.center().y(), object.center().z()
        };
        for (int row = 0; row < 3; row++) {
            assertThat(center[row]).as("place of %s", object).isCloseTo(expected[row][3], within(tolerance));
            for (int column = 0; column < 3; column++) {
                assertThat(object.pose().rotation(3 * row + column))
                        .as("rotation of %s", object)
                        .isCloseTo(expected[row][column], within(tolerance));
            }
        }
    }

    /** Answers how many of the poses counted from a frame that they name. */
    private int trees(Sort sort, int count, double tolerance, SplittableRandom random) throws IOException {
        int links = 0;
        int named = 0;
        for (int k = 0; k < count; k++) {
            List<Thing> models = new ArrayList<>();
            StringBuilder text = new StringBuilder("<sdf version=\"1.10\"><world name=\"w\">\n");
            for (int m = 0; m < 3; m++) {
                models.add(model("t" + m, null, models, 3, sort, random));
            }
            Map<String, Thing> expected = new HashMap<>();
            for (Thing model : models) {
                StringBuilder body = new StringBuilder();
                write(model, body, random);
                text.append(body.toString().replaceFirst(">\n", "><static>true</static>\n"));
                links(model, model.name, expected);
            }
            text.append("</world></sdf>\n");
            Path file = Files.writeString(folder.resolve("tree.sdf"), text);
            List<WorldObject> objects = SdfReader.read(file, List.of()).world().objects();
            assertThat(objects).as("%s", text).hasSize(2 * expected.size());
            for (WorldObject each : objects) {
                String name = each.object().name();
                assertThat(name).isNotNull();
                Thing link = expected.get(name.substring(0, name.length() - 3));
                assertThat(link).as("%s", name).isNotNull();
                double[][] place = link.in(null);
                same(each.object(), name.endsWith("c") ? place : times(place, matrix(0, 0, 1, 0, 0, 0)), tolerance);
                links++;
                named += link.base == null ? 0 : 1;
            }
        }
        assertThat(links).isGreaterThan(10 * count);
        return named * 100 / links;
    }

    @Test
    void anyPoses() throws IOException {
        assertThat(trees(Sort.ANY, 300, 1e-11, new SplittableRandom(61))).isBetween(30, 70);
    }

    /** Whole places and quarter turns come out whole, however they were nested. */
    @Test
    void quarterTurnsAreExact() throws IOException {
        assertThat(trees(Sort.QUARTERS, 300, 0, new SplittableRandom(62))).isBetween(30, 70);
    }

    /** The same models, but moveable: what is in the group is where the single objects were. */
    @Test
    void movingModelsHoldTheSamePlaces() throws IOException {
        SplittableRandom random = new SplittableRandom(63);
        for (int k = 0; k < 100; k++) {
            Thing model = model("t", null, List.of(), 3, Sort.ANY, random);
            StringBuilder text = new StringBuilder();
            write(model, text, random);
            Map<String, Thing> expected = new HashMap<>();
            links(model, "t", expected);
            Path file = Files.writeString(folder.resolve("body.sdf"), "<sdf version=\"1.10\">" + text + "</sdf>");
            Path still = Files.writeString(
                    folder.resolve("still.sdf"),
                    "<sdf version=\"1.10\">" + text.toString().replaceFirst(">\n", "><static>1</static>\n") + "</sdf>");
            List<WorldObject> bodies = SdfReader.read(file, List.of()).world().objects();
            assertThat(bodies).hasSize(1);
            GeometryObject body = bodies.get(0).object();
            assertThat(body.name()).isEqualTo("t");
            assertThat(body.isMoveable()).isTrue();
            same(body, model.in(null), 1e-12);
            List<double[]> places = new ArrayList<>();
            for (GeometryObject member : ((ObjectGroup) body).members()) {
                double[] r = body.rotation();
                double[] at = {
                    member.center().x(), member.center().y(), member.center().z()
                };
                double[] c = {
                    body.center().x(), body.center().y(), body.center().z()
                };
                for (int row = 0; row < 3; row++) {
                    c[row] += r[3 * row] * at[0] + r[3 * row + 1] * at[1] + r[3 * row + 2] * at[2];
                }
                places.add(c);
            }
            List<WorldObject> rest = SdfReader.read(still, List.of()).world().objects();
            assertThat(places).hasSameSizeAs(rest);
            for (WorldObject each : rest) {
                assertThat(each.object().isMoveable()).isFalse();
                double[] at = {
                    each.object().center().x(),
                    each.object().center().y(),
                    each.object().center().z()
                };
                assertThat(places)
                        .anyMatch(place -> Math.abs(place[0] - at[0]) <= 1e-11
                                && Math.abs(place[1] - at[1]) <= 1e-11
                                && Math.abs(place[2] - at[2]) <= 1e-11);
            }
        }
    }
}
