package robosim.geometry.limits;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import robosim.geometry.image.PngWriter;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.WorldImport;

/**
 * Gives bytes to the readers of other programs' files and judges what becomes of them: a world, or the one exception of
 * files, within a second and within memory that is known. The first byte chooses the reader.
 */
final class HostileFiles {
    private static final long MOST_NANOS = 2_000_000_000L;
    private static final long MOST_BYTES = 256L << 20;

    /** A file that is read, and the one that has the bytes. */
    private enum Kind {
        DAE("t.dae"),
        URDF("t.urdf"),
        PLY("t.ply"),
        GLB("t.glb"),
        GLTF("t.gltf"),
        OBJ("t.obj"),
        STL("t.stl"),
        SDF("t.sdf"),
        STAGE("t.world"),
        PNG("h.png"),
        PGM("h.pgm"),
        PART_OF_DAE("part.dae"),
        PART_OF_OBJ("part.obj"),
        PART_OF_STL("part.stl"),
        PART_OF_GLTF("part.gltf");

        private final String bytes;

        Kind(String bytes) {
            this.bytes = bytes;
        }

        /** What is read: the file itself, or a world whose collision is of it. */
        String read() {
            return ordinal() < PNG.ordinal() ? bytes : bytes + ".sdf";
        }

        String geometry() {
            return ordinal() <= PGM.ordinal()
                    ? "<heightmap><uri>" + bytes + "</uri><size>4 4 1</size><sampling>2</sampling></heightmap>"
                    : "<mesh><uri>package://own/" + bytes
                            + "</uri><submesh><name>part</name><center>1</center></submesh></mesh>";
        }
    }

    private final Path folder;
    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final int[] understood = new int[Kind.values().length];
    private long inputs;
    private long slowestNanos;
    private long largestBytes;

    HostileFiles(Path parent) {
        folder = parent.resolve("own"); // the package that the worlds name
        try {
            Files.createDirectories(folder);
            Files.writeString(folder.resolve("package.xml"), "<package/>");
            Files.writeString(folder.resolve("part.inc"), "define low model( size [1 1 .1] )\n");
            Files.writeString(folder.resolve("own.pgm"), "P2 3 2 255 0 255 0 255 0 255");
            for (Kind kind : Kind.values()) {
                if (!kind.read().equals(kind.bytes)) {
                    Files.writeString(folder.resolve(kind.read()), sdf(kind.geometry()));
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String sdf(String geometry) {
        return "<sdf version=\"1.9\"><model name=\"m\"><static>1</static><pose>0 0 1 0 0 0</pose><link name=\"l\">"
                + "<collision name=\"b\"><geometry><box><size>1 1 1</size></box></geometry></collision>"
                + "<collision name=\"c\"><pose>1 2 3 .1 .2 .3</pose><geometry>" + geometry
                + "</geometry></collision></link></model></sdf>";
    }

    /** Whether the bytes are read as a world; fails where anything but the exception of files comes of them. */
    boolean accepts(byte[] bytes) {
        if (bytes.length == 0) {
            return false;
        }
        Kind kind = Kind.values()[(bytes[0] & 0xff) % Kind.values().length];
        boolean accepted = false;
        long allocated = 0;
        long time = 0;
        try {
            Files.write(folder.resolve(kind.bytes), Arrays.copyOfRange(bytes, 1, bytes.length));
            allocated = threads.getCurrentThreadAllocatedBytes();
            time = threads.getCurrentThreadCpuTime();
            WorldImport read = WorldImport.read(folder.resolve(kind.read()), ImportOptions.DEFAULT);
            assertThat(read.world().objects()).isNotEmpty();
            read.skipped().forEach(each -> judge(each.toString()));
            accepted = read.isWhole();
        } catch (WorldException e) {
            judge(String.valueOf(e.getMessage()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        time = threads.getCurrentThreadCpuTime() - time;
        allocated = threads.getCurrentThreadAllocatedBytes() - allocated;
        inputs++;
        understood[kind.ordinal()] += accepted ? 1 : 0;
        slowestNanos = Math.max(slowestNanos, time);
        largestBytes = Math.max(largestBytes, allocated);
        if (inputs % 10_000 == 0) {
            write();
        }
        assertThat(time).as("nanoseconds").isLessThan(MOST_NANOS);
        assertThat(allocated).as("bytes allocated").isLessThan(MOST_BYTES);
        return accepted;
    }

    private static void judge(String message) {
        assertThat(message).isNotBlank().doesNotContain("Exception").hasSizeLessThan(5000);
    }

    /** The figures so far. */
    private void write() {
        String line = String.format(
                Locale.ROOT,
                "files: %,d inputs, read whole %s of %s, slowest %.0f ms, most memory %.1f MB%n",
                inputs,
                Arrays.toString(understood),
                Arrays.toString(Kind.values()),
                slowestNanos / 1e6,
                largestBytes / 1e6);
        try {
            Path file = Path.of("target", "fuzz", "files.txt");
            Files.createDirectories(file.getParent());
            Files.writeString(file, line);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Small files of each kind that are read whole. */
    static List<byte[]> seeds() {
        List<byte[]> seeds = new ArrayList<>();
        String dae = "<?xml version=\"1.0\"?><COLLADA><asset><unit meter=\"0.5\"/><up_axis>Z_UP</up_axis></asset>"
                + "<library_geometries><geometry id=\"g\" name=\"part\"><mesh><source id=\"s\"><float_array id=\"a\">"
                + "0 0 0 1 0 0 0 1 0 0 0 1 2 2 0</float_array><technique_common><accessor source=\"#a\" count=\"5\""
                + " stride=\"3\"/></technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/>"
                + "</vertices><polylist count=\"2\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><vcount>4 3"
                + "</vcount><p>0 1 4 2 0 1 3</p></polylist><tristrips><input semantic=\"VERTEX\" source=\"#v\" offset=\"1\"/>"
                + "<p>9 0 9 1 9 2 9 3</p></tristrips></mesh></geometry></library_geometries><library_nodes><node id=\"n\">"
                + "<instance_geometry url=\"#g\"/></node></library_nodes><library_visual_scenes><visual_scene id=\"w\"><node>"
                + "<rotate>1 0 0 90</rotate><translate>1 2 3</translate><scale>1 2 1</scale><instance_node url=\"#n\"/>"
                + "<node><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url=\"#g\"/></node></node>"
                + "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#w\"/></scene></COLLADA>";
        String obj =
                "o whole\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 0\ng part other\nf 1 3 2\nf -1/1 -4 1//2 3 4\n";
        String stl = "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                + "endfacet\nendsolid part\n";
        ByteBuffer floats = ByteBuffer.allocate(66).order(ByteOrder.LITTLE_ENDIAN);
        for (float each : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 5}) {
            floats.putFloat(each);
        }
        floats.put(new byte[] {0, 1, 2, 1, 3, 2});
        String gltf = gltf(",\"uri\":\"data:;base64," + Base64.getEncoder().encodeToString(floats.array()) + "\"");
        String ply = "\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
                + "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float t\nelement tristrips 1\n"
                + "property list int int vertex_indices\nend_header\n";
        add(seeds, Kind.DAE, dae);
        add(seeds, Kind.PART_OF_DAE, dae);
        add(seeds, Kind.OBJ, obj);
        add(seeds, Kind.PART_OF_OBJ, obj);
        add(seeds, Kind.STL, stl);
        add(seeds, Kind.PART_OF_STL, stl);
        add(seeds, Kind.GLTF, gltf);
        add(seeds, Kind.PART_OF_GLTF, gltf);
        add(seeds, Kind.GLB, glb(gltf(""), floats.array()));
        add(
                seeds,
                Kind.PLY,
                "ply\nformat ascii 1.0" + ply
                        + "0 0 0 1 1 0 0 2 0 1 0 3 0 0 1 4\n3 0 1 2 1 .5\n4 0 1 2 3 0\n5 0 1 2 3 -1\n");
        add(seeds, Kind.PLY, binaryPly(ply, ByteOrder.LITTLE_ENDIAN));
        add(seeds, Kind.PLY, binaryPly(ply, ByteOrder.BIG_ENDIAN));
        add(
                seeds,
                Kind.URDF,
                "<robot name=\"r\"><link name=\"a\"><collision><origin xyz=\"1 2 3\" rpy=\"0 .5 0\"/><geometry>"
                        + "<box size=\"1 2 3\"/></geometry></collision></link><link name=\"b\"><collision><geometry><cylinder"
                        + " radius=\"1\" length=\"2\"/></geometry></collision></link><joint name=\"j\" type=\"fixed\"><origin"
                        + " xyz=\"0 0 1\"/><parent link=\"a\"/><child link=\"b\"/></joint></robot>");
        add(
                seeds,
                Kind.SDF,
                sdf("<polyline><point>0 0</point><point>1 0</point><point>0 1</point><height>1</height></polyline>"));
        add(seeds, Kind.SDF, sdf("<ellipsoid><radii>1 2 3</radii></ellipsoid>"));
        add(
                seeds,
                Kind.STAGE,
                "include \"part.inc\"\ndefine eye sensor( range [0.1 4] fov 20 samples 3 )\nwindow( size [1 2] )\n"
                        + "position( name \"r\" pose [1 2 0 30] size [1 1 1] ranger( eye( pose [0 0 0 90] ) ) model( size [1 1 1] ) )\n"
                        + "model( boundary 1 size [4 4 1] block( points 3 point[0] [0 0] point[1] [1 0] point[2] [0 1] z [0 1] ) )\n"
                        + "model( bitmap \"own.pgm\" size [2 2 1] )\n");
        add(seeds, Kind.PGM, "P2 3 3 9 0 1 2 3 4 5 6 7 8");
        add(seeds, Kind.PGM, "P5 2 2 65535 abcdefgh");
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        try {
            PngWriter.writeGrey16(png, 3, 2, new short[] {1, 2, 3, 400, 500, 600});
            add(seeds, Kind.PNG, png.toByteArray());
            png.reset();
            PngWriter.writeColour(png, 3, 2, new int[] {1, 0x20000, 3, 4, 5, 6});
            add(seeds, Kind.PNG, png.toByteArray());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return seeds;
    }

    private static String gltf(String uri) {
        return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0,"
                + "\"name\":\"part\",\"rotation\":[0,0.6,0,0.8],\"children\":[2]},{\"mesh\":0,\"translation\":[1,2,3]},"
                + "{\"mesh\":0,\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],\"meshes\":[{\"primitives\":[{\"attributes\":"
                + "{\"POSITION\":0},\"indices\":1},{\"mode\":5,\"attributes\":{\"POSITION\":0}}]}],\"buffers\":"
                + "[{\"byteLength\":66" + uri
                + "}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":60,\"byteStride\":12},"
                + "{\"buffer\":0,\"byteOffset\":60,\"byteLength\":6}],\"accessors\":[{\"bufferView\":0,"
                + "\"componentType\":5126,\"count\":5,\"type\":\"VEC3\",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":1,"
                + "\"componentType\":5121},\"values\":{\"bufferView\":0,\"byteOffset\":12}}},{\"bufferView\":1,"
                + "\"componentType\":5121,\"count\":6,\"type\":\"SCALAR\"}]}";
    }

    private static byte[] glb(String json, byte[] bytes) {
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        ByteBuffer out = ByteBuffer.allocate(28 + text.length + bytes.length).order(ByteOrder.LITTLE_ENDIAN);
        out.putInt(0x46546c67).putInt(2).putInt(out.capacity());
        return out.putInt(text.length)
                .putInt(0x4e4f534a)
                .put(text)
                .putInt(bytes.length)
                .putInt(0x004e4942)
                .put(bytes)
                .array();
    }

    private static byte[] binaryPly(String elements, ByteOrder order) {
        String head =
                "ply\nformat binary_" + (order == ByteOrder.BIG_ENDIAN ? "big" : "little") + "_endian 1.0" + elements;
        ByteBuffer out = ByteBuffer.allocate(head.length() + 200).order(order);
        out.put(head.getBytes(StandardCharsets.US_ASCII));
        for (int k = 0; k < 4; k++) {
            out.putFloat(k % 2).putFloat(k / 2).putFloat(k).put((byte) k);
        }
        out.put((byte) 3).putInt(0).putInt(1).putInt(2).put((byte) 1).putFloat(1);
        out.put((byte) 4).putInt(0).putInt(1).putInt(3).putInt(2).put((byte) 0);
        out.putInt(4).putInt(0).putInt(1).putInt(2).putInt(3);
        return Arrays.copyOf(out.array(), out.position());
    }

    private static void add(List<byte[]> seeds, Kind kind, String text) {
        add(seeds, kind, text.getBytes(StandardCharsets.UTF_8));
    }

    private static void add(List<byte[]> seeds, Kind kind, byte[] bytes) {
        byte[] seed = new byte[bytes.length + 1];
        seed[0] = (byte) kind.ordinal();
        System.arraycopy(bytes, 0, seed, 1, bytes.length);
        seeds.add(seed);
    }
}
