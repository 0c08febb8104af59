package robosim.geometry.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class GridObjectTest {
    private static final Point CENTER = new Point(1, 2, 3);

    private static BitSet bits(int... cells) {
        BitSet bits = new BitSet();
        for (int cell : cells) {
            bits.set(cell);
        }
        return bits;
    }

    /** Four columns, three rows; occupied are (1, 0), (2, 0), (3, 1) and (0, 2). */
    private static GridObject grid() {
        return new GridObject(CENTER, 0.5, 2, 4, 3, bits(1, 2, 7, 8));
    }

    private static GridObject made(double cell, double height, int columns, int rows, BitSet occupied) {
        return new GridObject(CENTER, cell, height, columns, rows, occupied);
    }

    private static Arguments refused(ThrowingCallable call, String... parts) {
        return Arguments.of(call, List.of(parts));
    }

    @SuppressWarnings("NullAway")
    static Stream<Arguments> refused() {
        return Stream.of(
                refused(() -> made(0, 1, 4, 3, bits(1)), "cell ", "(got: 0.0)"),
                refused(() -> made(-0.5, 1, 4, 3, bits(1)), "cell ", "(got: -0.5)"),
                refused(() -> made(Double.NaN, 1, 4, 3, bits(1)), "cell ", "(got: NaN)"),
                refused(() -> made(0x1p-501, 1, 4, 3, bits(1)), "cell ", "(got: " + String.valueOf(0x1p-501) + ")"),
                refused(() -> made(Double.POSITIVE_INFINITY, 1, 4, 3, bits(1)), "cell ", "(got: Infinity)"),
                refused(() -> made(0x1p101, 1, 4, 3, bits(1)), "cell ", "(got: " + String.valueOf(0x1p101) + ")"),
                refused(() -> made(0.5, -1, 4, 3, bits(1)), "height ", "(got: -1.0)"),
                refused(() -> made(0.5, Double.NaN, 4, 3, bits(1)), "height ", "(got: NaN)"),
                refused(() -> made(0.5, 1, 0, 3, bits(1)), "columns ", "(got: 0)"),
                refused(() -> made(0.5, 1, 4, -3, bits(1)), "rows ", "(got: -3)"),
                refused(() -> made(0.5, 1, 1 << 15, 1 << 14, bits(1)), "columns * rows ", "(got: 536870912)"),
                refused(() -> made(0.5, 1, 1 << 20, 1 << 20, bits(1)), "columns * rows ", "(got: 1099511627776)"),
                refused(() -> made(0.5, 1, 4, 3, bits()), "occupied ", "(got: none)"),
                refused(() -> made(0.5, 1, 4, 3, bits(1, 12)), "occupied ", "from 12 on", "(got: bit 12)"),
                refused(() -> made(0.5, 1, 4, 3, null), "occupied "),
                refused(() -> new GridObject(null, 0.5, 1, 4, 3, bits(1)), "center "),
                refused(() -> GridObject.of(CENTER, 0.5, 1, 4, 3, null), "occupied "),
                refused(() -> GridObject.of(CENTER, 0.5, 1, 4, 3, new byte[] {1}), "2 bytes", "(got: 1 bytes)"),
                refused(() -> GridObject.of(CENTER, 0.5, 1, 4, 3, new byte[] {1, 0, 0}), "2 bytes", "(got: 3 bytes)"),
                refused(() -> GridObject.of(CENTER, 0.5, 1, 4, 3, new byte[] {1, 16}), "occupied ", "(got: bit 12)"),
                refused(() -> grid().movedTo(new Point(0x1p30, 0, 0)), "2^30", "1.073741824E9"),
                refused(() -> grid().isOccupied(4, 0), "column and row ", "(got: 4 and 0)"),
                refused(() -> grid().isOccupied(0, -1), "column and row ", "(got: 0 and -1)"),
                refused(() -> grid().box(0, 3), "column and row ", "(got: 0 and 3)"),
                refused(() -> grid().moveable("map"), "static", "(got: \"map\")"),
                refused(() -> grid().turned(1, 0), "upright", "got: "),
                refused(() -> grid().turned(180, 0), "upright", "got: "),
                refused(() -> grid().oriented(new double[] {1, 0, 0, 0, 0, -1, 0, 1, 0}), "upright", "got: "),
                refused(() -> grid().oriented(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1 + 1e-10}), "upright", "got: "),
                refused(() -> new ObjectGroup(List.of(new SphereObject(CENTER, 1), grid())), "grid"));
    }

    @ParameterizedTest
    @MethodSource("refused")
    void refusalsNameTheArgumentAndItsValue(ThrowingCallable call, List<String> parts) {
        assertThatIllegalArgumentException()
                .isThrownBy(call)
                .satisfies(thrown -> assertThat(thrown).hasMessageContainingAll(parts.toArray(CharSequence[]::new)));
    }

    @Test
    void keepsItsNumbers() {
        GridObject grid = grid();
        assertThat(grid.cell()).isEqualTo(0.5);
        assertThat(grid.height()).isEqualTo(2);
        assertThat(grid.columns()).isEqualTo(4);
        assertThat(grid.rows()).isEqualTo(3);
        assertThat(grid.center()).isEqualTo(CENTER);
        assertThat(grid.isMoveable()).isFalse();
        assertThat(grid.name()).isNull();
        assertThat(grid.named("map").name()).isEqualTo("map");
        assertThat(grid.occupied()).isEqualTo(bits(1, 2, 7, 8));
        assertThat(grid.isOccupied(3, 1)).isTrue();
        assertThat(grid.isOccupied(1, 1)).isFalse();
        assertThat(grid.bytes()).containsExactly(0b1000_0110, 1);
        assertThat(GridObject.of(CENTER, 0.5, 2, 4, 3, grid.bytes())).isEqualTo(grid);
        BitSet mine = grid.occupied();
        mine.clear();
        assertThat(grid.occupied()).as("a fresh set").isEqualTo(bits(1, 2, 7, 8));
    }

    @Test
    void bytesCoverFreeCellsToo() {
        GridObject grid = new GridObject(new Point(), 1, 1, 100, 10, bits(0));
        assertThat(grid.bytes()).hasSize(125);
        assertThat(GridObject.of(new Point(), 1, 1, 100, 10, grid.bytes())).isEqualTo(grid);
    }

    @Test
    void boxesStandWhereTheGridPutsThem() {
        assertThat(grid().box(0, 0)).isEqualTo(new BoxObject(new Point(0.25, 2, 2.5), 0.5, 2, 0.5));
        assertThat(grid().box(3, 2)).isEqualTo(new BoxObject(new Point(1.75, 2, 3.5), 0.5, 2, 0.5));
        // A quarter to the left: columns go along -Z, rows along +X, and each box faces +X.
        assertThat(grid().turned(0, 90).box(0, 0)).isEqualTo(new BoxObject(new Point(0.5, 2, 3.75), 0.5, 2, 0.5));
        assertThat(grid().turned(0, 180).box(0, 0)).isEqualTo(new BoxObject(new Point(1.75, 2, 3.5), 0.5, 2, 0.5));
        GridObject turned = grid().turned(0, 33);
        assertThat(turned.box(2, 1).rotation()).isEqualTo(turned.rotation());
        assertThat(turned.box(2, 1).heading()).isEqualTo(33);
    }

    @Test
    void boundsAreThoseOfOccupiedCells() {
        Bounds all = grid().bounds();
        assertThat(List.of(all.minX(), all.minY(), all.minZ(), all.maxX(), all.maxY(), all.maxZ()))
                .isEqualTo(List.of(0.0, 1.0, 2.25, 2.0, 3.0, 3.75));
        Bounds one = new GridObject(CENTER, 0.5, 2, 4, 3, bits(11)).bounds();
        assertThat(List.of(one.minX(), one.maxX(), one.minZ(), one.maxZ())).isEqualTo(List.of(1.5, 2.0, 3.25, 3.75));
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 200; k++) {
            GridObject grid = grid().turned(0, random.nextDouble(-180, 180))
                    .movedTo(new Point(random.nextDouble(-9, 9), random.nextDouble(), random.nextDouble(-9, 9)));
            Bounds bounds = grid.bounds();
            for (int cell : grid.occupied().stream().toArray()) {
                Bounds box = grid.box(cell % 4, cell / 4).bounds();
                String as = grid + ", cell " + cell;
                assertThat(bounds.minX()).as(as).isLessThanOrEqualTo(box.minX() + 1e-14);
                assertThat(bounds.minY()).as(as).isLessThanOrEqualTo(box.minY());
                assertThat(bounds.minZ()).as(as).isLessThanOrEqualTo(box.minZ() + 1e-14);
                assertThat(bounds.maxX()).as(as).isGreaterThanOrEqualTo(box.maxX() - 1e-14);
                assertThat(bounds.maxY()).as(as).isGreaterThanOrEqualTo(box.maxY());
                assertThat(bounds.maxZ()).as(as).isGreaterThanOrEqualTo(box.maxZ() - 1e-14);
            }
        }
    }

    @Test
    void equalityIsOfAllNumbers() {
        assertThat(grid()).isEqualTo(grid()).hasSameHashCodeAs(grid());
        assertThat(grid().turned(0, 20)).isEqualTo(grid().turned(0, 20)).hasSameHashCodeAs(grid().turned(0, 20));
        assertThat(List.of(
                        grid().named("map"),
                        grid().movedTo(new Point()),
                        grid().turned(0, 20),
                        made(0.25, 2, 4, 3, bits(1, 2, 7, 8)),
                        made(0.5, 1, 4, 3, bits(1, 2, 7, 8)),
                        made(0.5, 2, 3, 4, bits(1, 2, 7, 8)),
                        made(0.5, 2, 4, 3, bits(1, 2, 7))))
                .doesNotContain(grid())
                .doesNotHaveDuplicates();
    }

    @Test
    void survivesSerialization() throws Exception {
        GridObject plain = grid();
        for (GridObject grid : List.of(
                plain, plain.named("map"), plain.turned(0, 0.1).turned(0, 0.1), plain.movedTo(new Point(7, -8, 9)))) {
            GridObject read = (GridObject) copy(grid);
            assertThat(read).isEqualTo(grid).hasSameHashCodeAs(grid);
            // The lost rounding of the heading came along too: the next turn gives the same bits.
            assertThat(read.turned(0, 0.1).rotation())
                    .isEqualTo(grid.turned(0, 0.1).rotation());
        }
    }

    private static Object copy(Object written) throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(written);
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            return in.readObject();
        }
    }
}
