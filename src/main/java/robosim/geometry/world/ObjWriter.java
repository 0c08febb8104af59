package robosim.geometry.world;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.LongConsumer;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.image.PngWriter;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.world.mesh.MaterialWriter;
import robosim.geometry.world.shared.AtomicFileWriter;
import robosim.geometry.world.shared.Decimal;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Placement;
import robosim.geometry.world.shared.Rectangles;

/**
 * Writes the surfaces of a world as a Wavefront OBJ file, for display in other programs: world units, Y up, an {@code
 * o} for each object. Boxes and meshes are exact, and the cells of a grid, to within rounding: as boxes of many cells. A cylinder has {@link #SIDES} flat sides, and a sphere or capsule as
 * many around; their corners are on the true surface, so round shapes are slightly too small.
 *
 * <p>Where objects were given materials, an MTL file of the same name is written beside it, with a PNG file for each picture.
 * A checker or stripes, and a picture on anything but a mesh with texture coordinates, are only a colour there.
 */
final class ObjWriter {
    /** Number of flat sides of a round shape. */
    static final int SIDES = 48;

    private static final int RINGS = SIDES / 2;

    private final BufferedWriter out;

    /** The number of vertices so far; OBJ counts them over the whole file, from 1. */
    private long vertices;

    /** The number of texture points so far. */
    private long texturePoints;

    private final MaterialWriter materials;

    /** What the last faces were made of. */
    private Material last = Material.DEFAULT;

    private ObjWriter(BufferedWriter out, MaterialWriter materials) {
        this.out = out;
        this.materials = materials;
    }

    /**
     * Writes a file atomically: an existing file stays as it was until the new one is complete.
     *
     * @param progress called from time to time with the number of objects written
     * @throws WorldException if the file cannot be written
     */
    static void write(World world, Path file, LongConsumer progress) throws WorldException {
        Checks.present("world", world);
        Checks.present("file", file);
        Checks.present("progress", progress);
        try {
            Path named = file.getFileName();
            String stem = (named == null ? "world" : named.toString()).replaceFirst("\\.[^.]*$", "");
            MaterialWriter materials = new MaterialWriter(stem);
            world.objects().forEach(each -> collect(each.object(), Material.DEFAULT, materials));
            boolean isDevice = Files.exists(file) && !Files.isRegularFile(file);
            boolean isPlain = isDevice || materials.isPlain();
            if (!isPlain) {
                write(materials, file.resolveSibling(stem + ".mtl"));
            }
            AtomicFileWriter.write(file, to -> {
                BufferedWriter out = new BufferedWriter(new OutputStreamWriter(to, StandardCharsets.UTF_8));
                new ObjWriter(out, materials).world(world, isPlain ? "" : "mtllib " + stem + ".mtl\n", progress);
                out.flush();
            });
        } catch (IOException e) {
            throw new WorldException(new FileProblem(file.toString(), "the file could not be written: " + e, e));
        }
    }

    private static void collect(GeometryObject object, Material around, MaterialWriter materials) {
        Material material = object.material().within(around);
        if (object instanceof ObjectGroup group) {
            group.members().forEach(member -> collect(member, material, materials));
        } else {
            materials.name(material);
        }
    }

    private static void write(MaterialWriter materials, Path library) throws IOException {
        for (Map.Entry<ImageTexture, String> picture : materials.pictures().entrySet()) {
            ImageTexture image = picture.getKey();
            AtomicFileWriter.write(
                    library.resolveSibling(picture.getValue()),
                    to -> PngWriter.writeColour(to, image.width(), image.height(), image.pixels()));
        }
        AtomicFileWriter.write(library, to -> to.write(materials.text().getBytes(StandardCharsets.UTF_8)));
    }

    private void world(World world, String library, LongConsumer progress) throws IOException {
        out.write("# " + number(world.width()) + " x " + number(world.height()) + " x " + number(world.length())
                + ", Y up" + (world.unit() == null ? "" : ", in " + world.unit().symbol()) + "\n");
        out.write(library);
        long done = 0;
        for (WorldObject each : world.objects()) {
            progress.accept(done++);
            String name = each.object().name();
            out.write("o " + (name == null ? "object_" + done : name.strip().replaceAll("\\s", "_")) + "\n");
            object(each.object(), Placement.NONE, Material.DEFAULT);
        }
    }

    private void object(GeometryObject object, Placement frame, Material around) throws IOException {
        Pose pose = object.pose();
        Material material = object.material().within(around);
        if (object.kind() != GeometryObject.Kind.GROUP && !material.equals(last)) {
            out.write("usemtl " + materials.name(material) + "\n");
            last = material;
        }
        Placement place = frame.then(Placement.turned(pose.center(), pose.rotation()));
        if (object instanceof ObjectGroup group) {
            for (GeometryObject member : group.members()) {
                object(member, place, material);
            }
        } else if (object instanceof MeshObject mesh) {
            mesh(mesh, place, material);
        } else if (object instanceof GridObject grid) {
            grid(grid, place);
        } else {
            solid(object.roundedBox(), place);
        }
    }

    private void solid(RoundedBox box, Placement place) throws IOException {
        double x = box.halfWidth();
        double y = box.halfHeight();
        double z = box.halfLength();
        if (box.ball() > 0) {
            ball(box.ball(), y, place);
        } else if (box.disc() > 0) {
            cylinder(box.disc(), y, place);
        } else {
            box(place, -x, x, -y, y, -z, z);
        }
    }

    /** Boxes of as many cells as make a rectangle. */
    private void grid(GridObject grid, Placement place) throws IOException {
        double y = grid.height() / 2;
        double x = -0.5 * grid.columns();
        double z = -0.5 * grid.rows();
        double cell = grid.cell();
        Rectangles.<IOException>cover(
                grid.occupied(),
                grid.columns(),
                grid.rows(),
                (fromColumn, fromRow, toColumn, toRow) -> box(
                        place,
                        (fromColumn + x) * cell,
                        (toColumn + x) * cell,
                        -y,
                        y,
                        (fromRow + z) * cell,
                        (toRow + z) * cell));
    }

    private void box(Placement place, double fromX, double toX, double fromY, double toY, double fromZ, double toZ)
            throws IOException {
        for (int k = 0; k < 8; k++) {
            vertex(place, (k & 1) == 0 ? fromX : toX, (k & 2) == 0 ? fromY : toY, (k & 4) == 0 ? fromZ : toZ);
        }
        face(8, 0, 4, 6, 2);
        face(8, 1, 3, 7, 5);
        face(8, 0, 1, 5, 4);
        face(8, 2, 6, 7, 3);
        face(8, 0, 2, 3, 1);
        face(8, 4, 5, 7, 6);
    }

    private void cylinder(double radius, double half, Placement place) throws IOException {
        int[] bottom = new int[SIDES];
        int[] top = new int[SIDES];
        for (int k = 0; k < SIDES; k++) {
            double x = radius * Degrees.cos(360.0 / SIDES * k);
            double z = -radius * Degrees.sin(360.0 / SIDES * k);
            vertex(place, x, -half, z);
            vertex(place, x, half, z);
            bottom[SIDES - 1 - k] = 2 * k;
            top[k] = 2 * k + 1;
        }
        for (int k = 0; k < SIDES; k++) {
            int next = (k + 1) % SIDES;
            face(2 * SIDES, 2 * k, 2 * next, 2 * next + 1, 2 * k + 1);
        }
        face(2 * SIDES, bottom);
        face(2 * SIDES, top);
    }

    /** A sphere; or one that is cut at its equator, with its halves moved apart by a half length each. */
    private void ball(double radius, double half, Placement place) throws IOException {
        int rings = half > 0 ? RINGS + 1 : RINGS;
        vertex(place, 0, -radius - half, 0);
        for (int row = 1; row < rings; row++) {
            int ring = half > 0 && row > RINGS / 2 ? row - 1 : row;
            double y = -radius * Degrees.cos(180.0 / RINGS * ring) + (row > RINGS / 2 ? half : -half);
            double across = radius * Degrees.sin(180.0 / RINGS * ring);
            for (int k = 0; k < SIDES; k++) {
                vertex(place, across * Degrees.cos(360.0 / SIDES * k), y, -across * Degrees.sin(360.0 / SIDES * k));
            }
        }
        vertex(place, 0, radius + half, 0);
        int count = 2 + (rings - 1) * SIDES;
        for (int k = 0; k < SIDES; k++) {
            int next = (k + 1) % SIDES;
            face(count, 0, 1 + next, 1 + k);
            for (int ring = 0; ring < rings - 2; ring++) {
                int here = 1 + ring * SIDES;
                face(count, here + k, here + next, here + SIDES + next, here + SIDES + k);
            }
            int last = 1 + (rings - 2) * SIDES;
            face(count, last + k, last + next, count - 1);
        }
    }

    private void mesh(MeshObject mesh, Placement place, Material material) throws IOException {
        for (Point vertex : mesh.vertices()) {
            vertex(place, vertex.x(), vertex.y(), vertex.z());
        }
        int count = mesh.vertices().size();
        TextureCoordinates texture = mesh.textureCoordinates();
        if (texture == null || !(material.texture() instanceof ImageTexture)) {
            for (int[] face : mesh.faces()) {
                face(count, face);
            }
            return;
        }
        double[] points = texture.points();
        for (int k = 0; k < points.length; k += 2) {
            out.write("vt " + number(points[k]) + " " + number(points[k + 1]) + "\n");
        }
        int[] corners = texture.corners();
        int at = 0;
        for (int[] face : mesh.faces()) {
            out.write("f");
            for (int corner : face) {
                int point = corners[at++];
                out.write(" " + (vertices - count + corner + 1)
                        + (point == TextureCoordinates.NONE ? "" : "/" + (texturePoints + point + 1)));
            }
            out.write("\n");
        }
        texturePoints += points.length / 2;
    }

    private void vertex(Placement place, double x, double y, double z) throws IOException {
        Point at = place.apply(new Point(x, y, z));
        out.write("v " + number(at.x()) + " " + number(at.y()) + " " + number(at.z()) + "\n");
        vertices++;
    }

    /** Drops the sign of a zero, which no viewer needs. */
    private static String number(double value) {
        return Decimal.of(value + 0.0);
    }

    /** Writes a face whose corners are counted from 0 among the last vertices. */
    private void face(int last, int... corners) throws IOException {
        out.write("f");
        for (int corner : corners) {
            out.write(" " + (vertices - last + corner + 1));
        }
        out.write("\n");
    }
}
