package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.nio.ByteBuffer;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Allocated;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.json.JsonLines;

/** Grids in messages of both encodings: as they were, or refused, whatever a sender claims about them. */
class GridMessagesTest {
    private static final double CELL = 0.123;

    /** Ten cells, of which the first, the third and the last are occupied. */
    private static final GridObject SMALL = GridObject.of(new Point(1, 2, 3), CELL, 4, 5, 2, new byte[] {0b101, 0b10});

    private static final String JSON =
            "{\"type\":\"init\",\"objects\":[{\"kind\":\"grid\",\"center\":[1,2,3],\"cell\":0.123,\"height\":4,\"columns\":5,"
                    + "\"rows\":2,\"occupied\":\"BQI=\"}]}";

    private static GridObject full(int columns, int rows) {
        BitSet all = new BitSet();
        all.set(0, columns * rows);
        return new GridObject(new Point(), CELL, 4, columns, rows, all);
    }

    private static void refused(byte[] bytes, String reason) {
        assertThatThrownBy(() -> MessageTest.readAll(bytes))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining(reason);
    }

    private static void refused(String line, String reason) {
        assertThatThrownBy(() -> JsonLines.readRequest(line))
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining(reason);
    }

    @Test
    void aGridIsWrittenAsThePageSays() throws ProtocolException {
        InitBundle bundle = new InitBundle(List.of(SMALL));
        assertThat(JsonLines.readRequest(JSON)).isEqualTo(bundle);
        assertThat(JsonLines.readRequest(JsonLines.write(bundle))).isEqualTo(bundle);
        assertThat(JsonLines.write(bundle)).contains("\"occupied\":\"BQI=\"");
    }

    @Test
    void gridsOfAllSizesComeBackAsTheyWere() throws IOException {
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 300; k++) {
            int columns = 1 + random.nextInt(k < 290 ? 40 : 700);
            int rows = 1 + random.nextInt(k < 290 ? 40 : 700);
            BitSet occupied = new BitSet();
            for (int cell = 0; cell < columns * rows; cell++) {
                occupied.set(cell, random.nextInt(3) == 0);
            }
            occupied.set(random.nextInt(columns * rows));
            GridObject grid = new GridObject(new Point(random.nextDouble(9), 0, -1), 0.05, 1, columns, rows, occupied)
                    .turned(0, k % 2 == 0 ? 0 : random.nextDouble(-180, 180));
            InitBundle bundle = new InitBundle(List.of(k % 3 == 0 ? grid : grid.named("map")));
            assertThat(MessageTest.readAll(MessageTest.write(bundle))).containsExactly(bundle);
            assertThat(JsonLines.readRequest(JsonLines.write(bundle))).isEqualTo(bundle);
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"columns\":5 | \"columns\":9 | occupied must have a bit for each of 9 x 2 cells, 3 bytes (got: 2 bytes)",
                "\"columns\":5 | \"columns\":4 | occupied must have a bit for each of 4 x 2 cells, 1 bytes (got: 2 bytes)",
                "\"columns\":5 | \"columns\":-5 | /columns: must be a whole number from 1 to 32000000 (got: -5)",
                "\"rows\":2 | \"rows\":0 | /rows: must be a whole number from 1",
                "\"rows\":2 | \"rows\":1.5 | /rows: must be a whole number from 1",
                "\"rows\":2 | \"rows\":32000000 | 5 x 32000000 cells, 20000000 bytes (got: 2 bytes)",
                "\"BQI=\" | \"AAA=\" | occupied must have a bit",
                "\"BQI=\" | \"BQY=\" | none from 10 on (got: bit 10)",
                "\"BQI=\" | \"BQI\" | /occupied: must be base64, with its padding and nothing else",
                "\"BQI=\" | \"BQJ=\" | must be base64",
                "\"BQI=\" | \"BQI= \" | must be base64",
                "\"BQI=\" | \"B QI=\" | must be base64",
                "\"BQI=\" | \"*()!\" | must be base64",
                "\"BQI=\" | \"\" | 2 bytes (got: 0 bytes)",
                "\"BQI=\" | [5,2] | /occupied: must be a string of base64 (got: a list)",
                "\"cell\":0.123 | \"cell\":0 | cell must be a number from 2^-500",
                "\"cell\":0.123 | \"cell\":-1 | cell must be a number from 2^-500",
                "\"center\":[1,2,3] | \"center\":[1e9,2,3] | a grid must lie within 2^30 of its cells",
                "\"rows\":2 | \"rows\":2,\"moveable\":true,\"name\":\"map\" | a grid is static",
                "\"rows\":2 | \"rows\":2,\"rotation\":[1,0,0,0,0,-1,0,1,0] | a grid stands upright",
                "\"rows\":2, | '' | must have the field \"rows\"",
                "\"rows\":2 | \"rows\":2,\"radius\":1 | a grid must not have the field \"radius\"",
                "\"kind\":\"grid\" | \"kind\":\"map\" | must be box, cylinder, sphere, capsule, mesh, group or grid",
            })
    void whatIsWrongInALineIsNamed(String part, String instead, String reason) {
        assertThat(JSON).contains(part);
        refused(JSON.replace(part, instead), reason);
    }

    @Test
    void aGridIsNoMemberInEitherEncoding() throws IOException {
        String grid = JSON.substring(JSON.indexOf('[') + 1, JSON.length() - 2);
        refused(
                "{\"type\":\"init\",\"objects\":[{\"kind\":\"group\",\"members\":[" + grid + "]}]}",
                "must not hold a grid");
        BoxObject box = new BoxObject(new Point(), 1, 1, 1);
        Object[] form = new Object[1];
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes) {
            {
                enableReplaceObject(true);
            }

            @Override
            protected Object replaceObject(Object object) {
                String type = object.getClass().getSimpleName();
                form[0] = type.equals("Grid") ? object : form[0];
                return type.equals("Box") ? form[0] : object;
            }
        }) {
            out.writeObject(new InitBundle(List.of(SMALL, new ObjectGroup(List.of(box)))));
        }
        refused(bytes.toByteArray(), "must not hold a grid");
    }

    /** The bytes of a message with the small grid, where the numbers of columns and rows begin. */
    private static int[] places(byte[] bytes) {
        byte[] cell = ByteBuffer.allocate(8).putDouble(CELL).array();
        for (int k = 0; k + 8 < bytes.length; k++) {
            if (ByteBuffer.wrap(bytes, k, 8).slice().equals(ByteBuffer.wrap(cell))) {
                return new int[] {k + 8, k + 20}; // fields go by their names: cell, columns, height, rows
            }
        }
        throw new AssertionError("no cell in the message");
    }

    @ParameterizedTest
    @CsvSource({
        "9, 2, 'occupied must have a bit for each of 9 x 2 cells, 3 bytes (got: 2 bytes)'",
        "16384, 16384, 33554432 bytes (got: 2 bytes)",
        "2147483647, 2147483647, (got: 2 bytes)",
        "-5, -2, columns must be",
        "-5, 2, occupied must have a bit",
        "0, 2, occupied must have a bit",
        "3, 3, none from 9 on (got: bit 9)"
    })
    void claimedSizesAreHeldAgainstTheBytesThatCame(int columns, int rows, String reason) throws IOException {
        byte[] bytes = MessageTest.write(new InitBundle(List.of(SMALL)));
        ByteBuffer.wrap(bytes).putInt(places(bytes)[0], columns).putInt(places(bytes)[1], rows);
        assertThat(Allocated.once(() -> refused(bytes, reason))).isLessThan(5_000_000);
    }

    @Test
    void anArrayOfBytesHasTheLengthOfAnyOther() throws IOException {
        byte[] bytes = MessageTest.write(new InitBundle(List.of(SMALL)));
        int at = 0;
        while (bytes[at] != 0b101 || bytes[at + 1] != 0b10 || bytes[at - 1] != 2) {
            at++;
        }
        ByteBuffer.wrap(bytes).putInt(at - 4, MessageLimits.MAX_ARRAY_LENGTH + 1);
        assertThat(Allocated.once(() -> refused(bytes, "an array must have at most 4000000 items (got: 4000001)")))
                .isLessThan(1_000_000);
        refused(
                JSON.replace("BQI=", "A".repeat(5_333_340)),
                "/occupied: must have at most 4000000 bytes in base64 (got: more)");
        // Other texts are not longer for it.
        refused(JSON.replace("\"rows\"", "\"name\":\"" + "x".repeat(65_536) + "\",\"rows\""), "65535 bytes");
    }

    @Test
    void theLargestMapThatWasTriedFitsInBothEncodings() throws IOException {
        BitSet walls = new BitSet();
        SplittableRandom random = new SplittableRandom(6);
        for (int k = 0; k < 1_600_000; k++) {
            walls.set(random.nextInt(16_000_000));
        }
        InitBundle bundle =
                new InitBundle(List.of(new GridObject(new Point(), 0.05, 2, 4000, 4000, walls).named("map")));
        byte[] bytes = MessageTest.write(bundle);
        assertThat(bytes.length).isBetween(2_000_000, 2_001_000);
        assertThat(MessageTest.readAll(bytes)).containsExactly(bundle);
        assertThat(JsonLines.readRequest(JsonLines.write(bundle))).isEqualTo(bundle);
    }

    /** A few bytes can place the same cells again, and each place may cost a look at all of them. */
    @Tag("slow")
    @Test
    void cellsCountAtEveryReference() throws IOException {
        GeometryObject floor = full(2000, 1000);
        InitBundle fair = new InitBundle(Collections.nCopies(7, floor));
        assertThat(MessageTest.readAll(MessageTest.write(fair))).containsExactly(fair);
        assertThat(JsonLines.readRequest(JsonLines.write(fair))).isEqualTo(fair);
        InitBundle many = new InitBundle(Collections.nCopies(8, floor));
        byte[] bytes = MessageTest.write(many);
        assertThat(bytes).hasSizeLessThan(260_000);
        refused(bytes, "at most 16000000 parts");
        refused(JsonLines.write(many), "at most 16000000 parts");
    }
}
