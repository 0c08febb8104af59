package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.WorkLimit;
import robosim.geometry.WorkLimitException;
import robosim.geometry.world.shared.FileWork;

/** Reading a file of any format is counted, so it can be limited and cancelled. */
class LimitedImportTest {
    /** Of a file of a few thousand parts; what is counted at once must be far less, so that a reader ends soon. */
    private static final int PARTS = 1500;

    private static final int MOST_AT_ONCE = 2000;

    @TempDir
    Path folder;

    /** Files with a given number of triangles, boxes or rows. */
    private enum Kind {
        WORLD("w.xml") {
            @Override
            void write(Path file, int parts) throws IOException {
                String boxes = text(parts, k -> "<box center='" + k + " 0 0' width='0.5' height='1' length='1'/>\n");
                Files.writeString(
                        file,
                        "<world xmlns='urn:robosim:world:1' width='1e6' height='4' length='10'>" + boxes + "</world>");
            }
        },
        GRID("g.xml") {
            @Override
            void write(Path file, int parts) throws IOException {
                Files.writeString(
                        file,
                        "<world xmlns='urn:robosim:world:1' width='1e6' height='4' length='1e6'><grid center='0 0 0' cell='1'"
                                + " height='2' columns='3' rows='" + parts + "'>" + text(parts, k -> "0 1 1 1\n")
                                + "</grid></world>");
            }
        },
        OBJ("m.obj") {
            @Override
            void write(Path file, int parts) throws IOException {
                Files.writeString(
                        file,
                        text(parts + 2, k -> "v " + k / 2 + " " + k % 2 + " " + k % 3 + "\n")
                                + text(parts, k -> "f " + (k + 1) + " " + (k + 2) + " " + (k + 3) + "\n"));
            }
        },
        STL_TEXT("t.stl") {
            @Override
            void write(Path file, int parts) throws IOException {
                Files.writeString(
                        file,
                        "solid s\n"
                                + text(
                                        parts,
                                        k -> "facet normal 0 0 1 outer loop vertex " + k + " 0 0 vertex " + k
                                                + " 1 0 vertex " + k + " 0 1 endloop endfacet\n")
                                + "endsolid s\n");
            }
        },
        STL_BINARY("b.stl") {
            @Override
            void write(Path file, int parts) throws IOException {
                ByteBuffer out = ByteBuffer.allocate(84 + 50 * parts).order(ByteOrder.LITTLE_ENDIAN);
                out.putInt(80, parts);
                for (int k = 0; k < parts; k++) {
                    out.putFloat(96 + 50 * k, k).putFloat(108 + 50 * k, k + 1).putFloat(124 + 50 * k, 1);
                }
                Files.write(file, out.array());
            }
        },
        PLY("p.ply") {
            @Override
            void write(Path file, int parts) throws IOException {
                Files.writeString(
                        file,
                        "ply\nformat ascii 1.0\nelement vertex " + (parts + 2)
                                + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + parts
                                + "\nproperty list uchar int vertex_indices\nend_header\n"
                                + text(parts + 2, k -> k / 2 + " " + k % 2 + " " + k % 3 + "\n")
                                + text(parts, k -> "3 " + k + " " + (k + 1) + " " + (k + 2) + "\n"));
            }
        },
        COLLADA("c.dae") {
            @Override
            void write(Path file, int parts) throws IOException {
                Files.writeString(
                        file,
                        "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><library_geometries>"
                                + "<geometry id='g'><mesh><source id='p'><float_array id='a' count='" + 3 * (parts + 2)
                                + "'>" + text(parts + 2, k -> k / 2 + " " + k % 2 + " " + k % 3 + " ")
                                + "</float_array></source><vertices id='v'><input semantic='POSITION' source='#p'/></vertices>"
                                + "<triangles count='" + parts
                                + "'><input semantic='VERTEX' source='#v' offset='0'/><p>"
                                + text(parts, k -> k + " " + (k + 1) + " " + (k + 2) + " ")
                                + "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
                                + "<visual_scene id='w'><node><instance_geometry url='#g'/></node></visual_scene>"
                                + "</library_visual_scenes><scene><instance_visual_scene url='#w'/></scene></COLLADA>");
            }
        },
        GLTF("s.gltf") {
            @Override
            void write(Path file, int parts) throws IOException {
                ByteBuffer places = ByteBuffer.allocate(12 * (parts + 2)).order(ByteOrder.LITTLE_ENDIAN);
                for (int k = 0; k < parts + 2; k++) {
                    places.putFloat(k / 2).putFloat(k % 2).putFloat(k % 3);
                }
                String json =
                        "{'asset':{'version':'2.0'},'scene':0,'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}],'meshes':"
                                + "[{'primitives':[{'attributes':{'POSITION':0},'mode':5}]}],'buffers':[{'byteLength':"
                                + places.capacity() + ",'uri':'data:application/octet-stream;base64,"
                                + Base64.getEncoder().encodeToString(places.array())
                                + "'}],'bufferViews':[{'buffer':0,'byteLength':" + places.capacity()
                                + "}],'accessors':[{'bufferView':0,'componentType':5126,'count':" + (parts + 2)
                                + ",'type':'VEC3'}]}";
                Files.writeString(file, json.replace('\'', '"'));
            }
        },
        SDF("w.sdf") {
            @Override
            void write(Path file, int parts) throws IOException {
                Files.writeString(
                        file,
                        "<sdf version='1.9'><world name='w'>"
                                + text(
                                        parts,
                                        k -> "<model name='m" + k + "'><static>true</static><link name='l'><collision"
                                                + " name='c'><geometry><sphere><radius>1</radius></sphere></geometry>"
                                                + "</collision></link></model>\n")
                                + "</world></sdf>");
            }
        },
        URDF("r.urdf") {
            @Override
            void write(Path file, int parts) throws IOException {
                Files.writeString(
                        file,
                        "<robot name='r'><link name='base'>"
                                + text(
                                        parts,
                                        k -> "<collision><origin xyz='" + k
                                                + " 0 0'/><geometry><sphere radius='0.2'/></geometry></collision>\n")
                                + "</link></robot>");
            }
        },
        STAGE("s.world") {
            @Override
            void write(Path file, int parts) throws IOException {
                Files.writeString(file, text(parts, k -> "model( size [1 1 1] pose [" + 2 * k + " 0 0 0] )\n"));
            }
        },
        MAP("m.yaml") {
            @Override
            void write(Path file, int parts) throws IOException {
                Files.writeString(
                        file.resolveSibling("m.pgm"),
                        "P2 4 " + parts + " 255\n" + text(parts, k -> "0 255 0 255\n"),
                        StandardCharsets.US_ASCII);
                Files.writeString(
                        file,
                        "image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                                + "free_thresh: 0.196\n");
            }
        };

        private final String name;

        Kind(String name) {
            this.name = name;
        }

        abstract void write(Path file, int parts) throws IOException;

        Path file(Path folder, int parts) throws IOException {
            Path file = Files.createDirectories(folder.resolve("of" + parts)).resolve(name);
            write(file, parts);
            return file;
        }
    }

    private static String text(int parts, IntFunction<String> part) {
        return IntStream.range(0, parts).mapToObj(part).collect(Collectors.joining());
    }

    /** How many units reading takes, and the most at once. */
    private static long[] units(Path file) throws IOException {
        long[] units = new long[2];
        FileWork.counted(
                more -> {
                    units[0] += more;
                    units[1] = Math.max(units[1], more);
                },
                () -> WorldImport.read(file, ImportOptions.DEFAULT));
        return units;
    }

    @ParameterizedTest
    @EnumSource
    void everyPartIsCountedAndTheCountIsTheLimit(Kind kind) throws IOException {
        Path file = kind.file(folder, PARTS);
        long[] units = units(file);
        assertThat(units(file)).isEqualTo(units);
        assertThat(units[0] - units(kind.file(folder, PARTS / 2))[0]).isGreaterThanOrEqualTo(PARTS / 2);
        assertThat(units[1]).isLessThanOrEqualTo(MOST_AT_ONCE);

        WorldImport whole = WorldImport.read(file, ImportOptions.DEFAULT, WorkLimit.of(units[0]));
        assertThat(whole.world())
                .isEqualTo(WorldImport.read(file, ImportOptions.DEFAULT).world());
        for (long fewer : new long[] {units[0] - 1, units[0] / 2, 0}) {
            assertThatThrownBy(() -> WorldImport.read(file, ImportOptions.DEFAULT, WorkLimit.of(fewer)))
                    .isInstanceOf(WorkLimitException.class)
                    .hasMessageStartingWith("reading a file must take at most " + fewer + " units of work");
        }
    }

    @ParameterizedTest
    @EnumSource
    void cancellingEndsIt(Kind kind) throws IOException {
        Path file = kind.file(folder, PARTS);
        AtomicReference<WorkLimit> cancelled = new AtomicReference<>();
        int[] pauses = new int[1];
        WorkLimit limit = WorkLimit.none().pausing(() -> {
            pauses[0]++;
            cancelled.get().cancel();
        });
        cancelled.set(limit);
        assertThatThrownBy(() -> WorldImport.read(file, ImportOptions.DEFAULT, limit))
                .isInstanceOfSatisfying(
                        WorkLimitException.class,
                        e -> assertThat(e.isCancelled()).isTrue());
        assertThat(pauses[0]).isEqualTo(1);
    }

    private interface Reading {
        void of(InputStream in, WorkLimit limit) throws WorldException;
    }

    /** Streams are counted as files are: the least limit that is enough reads all, one unit less does not. */
    @ParameterizedTest
    @EnumSource(
            value = Kind.class,
            names = {"WORLD", "OBJ", "STL_TEXT", "STL_BINARY", "COLLADA"})
    void aStreamIsReadWithinALimitToo(Kind kind) throws IOException {
        byte[] bytes = Files.readAllBytes(kind.file(folder, 300));
        Reading reading = switch (kind) {
            case WORLD -> (in, limit) -> WorldReader.read(in, "here", null, limit);
            case OBJ -> (in, limit) -> WorldReader.readMesh(in, "here.obj", 1, limit);
            case COLLADA -> (in, limit) -> WorldReader.readMesh(in, "here.dae", 1, limit);
            default -> (in, limit) -> WorldReader.readMesh(in, "here.stl", 1, limit);
        };
        long tooFew = 0;
        long enough = 1 << 20;
        while (enough - tooFew > 1) {
            long units = (tooFew + enough) / 2;
            try {
                reading.of(new ByteArrayInputStream(bytes), WorkLimit.of(units));
                enough = units;
            } catch (WorkLimitException e) {
                assertThat(e).hasMessageContaining("must take at most " + units + " units of work");
                tooFew = units;
            }
        }
        assertThat(enough).isGreaterThanOrEqualTo(300 + bytes.length / 64);
    }

    /** What is thrown is no mistake of a file, even if it looks like one. */
    @ParameterizedTest
    @EnumSource
    void whatACounterThrowsComesOutAsItIs(Kind kind) throws IOException {
        Path file = kind.file(folder, 50);
        long all = units(file)[0];
        for (int at = 0; at < 40; at++) {
            long most = all * at / 40;
            long[] taken = new long[1];
            IllegalArgumentException reason = new IllegalArgumentException("enough");
            assertThatThrownBy(() -> FileWork.counted(
                            more -> {
                                taken[0] += more;
                                if (taken[0] > most) {
                                    throw reason;
                                }
                            },
                            () -> WorldImport.read(file, ImportOptions.DEFAULT)))
                    .isSameAs(reason);
        }
        FileWork.take(Long.MAX_VALUE); // nothing is counted any more
    }

    @Test
    void aWorldWithinAnotherAndAPolygonOfManyCorners() throws IOException {
        Kind.SDF.write(folder.resolve("inner.sdf"), 500);
        Files.writeString(
                folder.resolve("outer.xml"),
                "<world xmlns='urn:robosim:world:1' width='1e3' height='1e3' length='1e3'>"
                        + text(10, k -> "<include file='inner.sdf' prefix='p" + k + "' at='0 0 " + k + "'/>")
                        + "</world>");
        assertThat(units(folder.resolve("outer.xml"))[0])
                .as("each copy of the objects counts, the file itself once")
                .isBetween(10 * 500L, 10 * 500L + 2 * units(folder.resolve("inner.sdf"))[0]);

        int corners = 1000;
        Files.writeString(
                folder.resolve("comb.obj"),
                text(
                                corners,
                                k -> "v " + (k < corners / 2 ? k : corners - k - 0.5) + " 0 "
                                        + (k < corners / 2 ? k % 2 : 3) + "\n")
                        + "f" + text(corners, k -> " " + (k + 1)));
        assertThat(units(folder.resolve("comb.obj"))[0]).isGreaterThan((long) corners * corners / 100);
    }
}
