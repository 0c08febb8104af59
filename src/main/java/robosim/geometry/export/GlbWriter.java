package robosim.geometry.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongConsumer;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.render.Lighting;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.shared.AtomicFileWriter;

/**
 * Writes a world as a binary glTF 2.0 file (.glb): a node for each object with its name, place and material, groups as
 * nodes with children, in metres; pictures are in the file. glTF's axes are this module's: right-handed, Y up. Round shapes have 48 flat sides, with the
 * normals of the true surface.
 */
public final class GlbWriter {
    private static final int MAGIC = 0x46546c67;
    private static final int JSON = 0x4e4f534a;
    private static final int BINARY = 0x004e4942;

    private GlbWriter() {}

    /**
     * Writes a file atomically: an existing file stays as it was until the new one is complete.
     *
     * @param title    the name of the node that holds all others
     * @param progress called from time to time with the number of objects written
     * @throws IOException if the file cannot be written
     */
    public static void write(World world, String title, Path file, LongConsumer progress) throws IOException {
        Checks.present("world", world);
        Checks.present("title", title);
        Checks.present("progress", progress);
        GlbScene scene = new GlbScene();
        List<Integer> nodes = new ArrayList<>();
        int robots = 0;
        for (WorldObject each : world.objects()) {
            progress.accept(nodes.size());
            GeometryObject object = each.object();
            GeometryObject seen = object.seen();
            if (seen == null) {
                continue;
            }
            int usual = (object.isMoveable() ? Palette.robot(robots) : Palette.of(object.kind())).in(Theme.LIGHT);
            robots += object.isMoveable() ? 1 : 0;
            String name = object.name();
            String called = name == null ? object.kind().word() + " " + (nodes.size() + 1) : name;
            nodes.add(scene.object(seen, Material.of(Color.ofPacked(usual)), called));
        }
        Unit unit = world.unit();
        for (GeometryObject each : world.scenery()) {
            Material usual = Material.of(Color.ofPacked(Palette.of(each.kind()).in(Theme.LIGHT)));
            nodes.add(scene.object(each, usual, "scenery " + (nodes.size() + 1)));
        }
        double metres = unit == null ? 1 : unit.metres();
        Lighting lighting = world.lighting();
        if (lighting != null) {
            lighting.lights().forEach(light -> nodes.add(scene.light(light, metres)));
        }
        int root = scene.root(title, metres, nodes);
        byte[] json = scene.json(root).getBytes(StandardCharsets.UTF_8);
        byte[] numbers = scene.numbers.toBytes();
        AtomicFileWriter.write(file, out -> write(json, numbers, out));
    }

    /** The header and the two chunks, each of a multiple of four bytes. */
    private static void write(byte[] json, byte[] numbers, OutputStream out) throws IOException {
        int jsonLength = (json.length + 3) / 4 * 4;
        int binary = numbers.length == 0 ? 0 : 8 + numbers.length;
        out.write(words(MAGIC, 2, Math.addExact(20 + jsonLength, binary), jsonLength, JSON));
        out.write(json);
        for (int k = json.length; k < jsonLength; k++) {
            out.write(' ');
        }
        if (binary > 0) { // its numbers are of four bytes each
            out.write(words(numbers.length, BINARY));
            out.write(numbers);
        }
    }

    private static byte[] words(int... words) {
        PackedStream bytes = new PackedStream();
        for (int word : words) {
            bytes.number(word, Integer.BYTES);
        }
        return bytes.toBytes();
    }
}
