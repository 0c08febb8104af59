package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.Component;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectStreamConstants;
import java.io.Serializable;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import robosim.geometry.Snapshot;
import robosim.geometry.cli.demo.Program;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Ray;
import robosim.geometry.sweep.ParameterSweep;

/** What is serializable at all, what of it may cross the wire, and in which form. */
class SerialClassesTest {
    private static final Set<Class<?>> ENDS = Set.of(Bundle.class, GeometryObject.class, Material.class, Texture.class);

    /** Worlds and sweeps go to other machines in streams of an engine's own, windows nowhere. */
    private static final Set<Class<?>> NEVER = Set.of(Component.class);

    private static final List<Class<?>> SERIALIZABLE = serializable();

    /** The classes of the module; none is initialized. */
    private static List<Class<?>> serializable() {
        List<Class<?>> found = new ArrayList<>();
        Path module = Program.home();
        try (Stream<Path> files = Files.walk(module)) {
            for (Path file : files.filter(f -> f.toString().endsWith(".class")).toList()) {
                String path = module.relativize(file).toString();
                String name = path.substring(0, path.length() - 6).replace(File.separatorChar, '.');
                if (!name.startsWith("robosim.")) {
                    continue; // the module itself, and the demo's programs
                }
                Class<?> loaded = Class.forName(name, false, BoxObject.class.getClassLoader());
                if (Serializable.class.isAssignableFrom(loaded) && !loaded.isInterface()) {
                    found.add(loaded);
                }
            }
        } catch (IOException | ClassNotFoundException e) {
            throw new AssertionError(e);
        }
        return found;
    }

    @Test
    void everySerializableClassSaysWhichVersionItIs() throws Exception {
        int records = 0;
        List<String> without = new ArrayList<>();
        for (Class<?> type : SERIALIZABLE) {
            if (type.isEnum() || Enum.class.isAssignableFrom(type)) {
                continue; // goes by its name; its number is always 0
            }
            records += type.isRecord() ? 1 : 0;
            try {
                Field version = type.getDeclaredField("serialVersionUID");
                version.setAccessible(true);
                assertThat(Modifier.isStatic(version.getModifiers()) && Modifier.isFinal(version.getModifiers()))
                        .isTrue();
                assertThat(version.getLong(null)).as(type.getName()).isEqualTo(1);
            } catch (NoSuchFieldException e) {
                without.add(type.getName());
            }
        }
        assertThat(without).isEmpty();
        assertThat(records).as("records seen").isGreaterThanOrEqualTo(18);
    }

    @Test
    void onlyRecordsAndEnumsOfTheModuleCrossTheWire() throws Exception {
        AllowedClasses allowed = new AllowedClasses(Set.of());
        int crossing = 0;
        for (Class<?> type : SERIALIZABLE) {
            if (allowed.byName(type.getName()) != null) {
                assertThat(type.isRecord() || type.isEnum()).as(type.getName()).isTrue();
                crossing++;
            } else {
                assertThat(Throwable.class.isAssignableFrom(type)
                                || ENDS.stream().anyMatch(end -> end.isAssignableFrom(type))
                                || type.getEnclosingClass() != null
                                || type.isEnum()
                                || NEVER.stream().anyMatch(other -> other.isAssignableFrom(type))
                                || type.getPackage().equals(Snapshot.class.getPackage())
                                || type.getPackage().equals(ParameterSweep.class.getPackage()))
                        .as(type.getName() + " crosses as itself or as a form, or never")
                        .isTrue();
            }
        }
        assertThat(crossing).isEqualTo(110);
    }

    /** An object under its own class's name, as no writer makes it. */
    @Test
    void anObjectMustComeAsItsForm() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeShort(ObjectStreamConstants.STREAM_MAGIC);
        out.writeShort(ObjectStreamConstants.STREAM_VERSION);
        out.writeByte(ObjectStreamConstants.TC_OBJECT);
        out.writeByte(ObjectStreamConstants.TC_CLASSDESC);
        out.writeUTF(BoxObject.class.getName());
        out.writeLong(1);
        out.writeByte(ObjectStreamConstants.SC_SERIALIZABLE);
        out.writeShort(0);
        out.writeByte(ObjectStreamConstants.TC_ENDBLOCKDATA);
        out.writeByte(ObjectStreamConstants.TC_NULL);
        assertThatThrownBy(() -> MessageTest.readAll(bytes.toByteArray()))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("class \"robosim.geometry.model.BoxObject\" is not on the list");
    }

    /** Every class that may cross is in the stored bytes; two are for messages to come. */
    @Test
    void theStoredBytesHoldEveryClass() throws Exception {
        String stored = new String(StoredBytesTest.stored(StoredBytesTest.WITH_MATERIALS), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored(StoredBytesTest.WITH_VISUALS), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored(StoredBytesTest.WITH_LAYERS), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored(StoredBytesTest.WITH_PUSHES), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("batches.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("frames.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("pictures.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("world-requests.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("obstacles.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("listed.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("walks.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("proofs.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("rules.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("measures.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("stops.ser"), StandardCharsets.ISO_8859_1)
                + new String(StoredBytesTest.stored("steps.ser"), StandardCharsets.ISO_8859_1);
        AllowedClasses allowed = new AllowedClasses(Set.of());
        Set<String> missing = new TreeSet<>();
        for (Class<?> type : SERIALIZABLE) {
            if (allowed.byName(type.getName()) != null && !stored.contains(type.getName())) {
                missing.add(type.getName());
            }
        }
        assertThat(missing).isEqualTo(new TreeSet<>(Set.of(Ray.class.getName(), Move.class.getName())));
    }

    /** A class description that is referred to where an item should be: generics would let it through. */
    @Test
    void aListHoldsItemsOfItsType() throws IOException {
        byte[] bytes = MessageTest.write(new MoveBundle(
                List.of(new MoveRequest("robot", 1, 0, 0, 0, 0), new MoveRequest("robot", 2, 0, 0, 0, 0))));
        // The second item: TC_OBJECT, then a reference to the first one's class. Without TC_OBJECT it is the class
        // itself.
        int item = -1;
        for (int k = 0; k + 5 < bytes.length; k++) {
            if (bytes[k] == ObjectStreamConstants.TC_OBJECT && bytes[k + 1] == ObjectStreamConstants.TC_REFERENCE) {
                item = k;
            }
        }
        ByteArrayOutputStream forged = new ByteArrayOutputStream();
        forged.write(bytes, 0, item);
        forged.write(bytes, item + 1, 5);
        forged.writeBytes(new byte[] {ObjectStreamConstants.TC_ENDBLOCKDATA});
        assertThatThrownBy(() -> MessageTest.readAll(forged.toByteArray()))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("moves[1] must be a MoveRequest (got: java.io.ObjectStreamClass)");
    }

    /** The form of the JDK's immutable lists is that of its maps too, for which it throws an error where a value lacks. */
    @Test
    void aListThatClaimsToBeAMapIsRefused() throws IOException {
        byte[] bytes = MessageTest.write(new DistanceBundle(List.of(1.0)));
        byte[] list = {0, 0, 0, 1, 0x77, 4, 0, 0, 0, 1};
        int forged = 0;
        for (int k = 0; k + list.length < bytes.length; k++) {
            if (Arrays.equals(bytes, k, k + list.length, list, 0, list.length)) {
                bytes[k + 3] = 3;
                forged++;
            }
        }
        assertThat(forged).isEqualTo(1);
        assertThatThrownBy(() -> MessageTest.readAll(bytes))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("the bytes are not a message");
    }

    /** Sets in sets, whose hash takes time that doubles with each level, are refused with the first class's name. */
    @Test
    void nestedHashSetsAreRefusedAtOnce() throws IOException {
        Set<Object> root = new HashSet<>();
        Set<Object> one = root;
        Set<Object> two = new HashSet<>();
        for (int k = 0; k < 100; k++) {
            Set<Object> left = new HashSet<>();
            Set<Object> right = new HashSet<>();
            left.add("x");
            one.add(left);
            one.add(right);
            two.add(left);
            two.add(right);
            one = left;
            two = right;
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (java.io.ObjectOutputStream out = new java.io.ObjectOutputStream(bytes)) {
            out.writeObject(root);
        }
        byte[] message = bytes.toByteArray();
        int[] read = new int[1];
        InputStream oneByOne = new InputStream() {
            @Override
            public int read() {
                return read[0] < message.length ? message[read[0]++] & 0xff : -1;
            }

            @Override
            public int read(byte[] into, int offset, int length) {
                int next = length > 0 ? read() : 0;
                if (next < 0 || length == 0) {
                    return next;
                }
                into[offset] = (byte) next;
                return 1;
            }
        };
        assertThatThrownBy(() -> new MessageReader(oneByOne).read())
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("class \"java.util.HashSet\" is not on the list");
        // The stream's header and the name of the first class: no element has been read, so that none can be hashed.
        assertThat(read[0]).isLessThan(50);
    }
}
