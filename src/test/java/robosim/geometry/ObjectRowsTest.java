package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Objects as columns: what placements share is written once and shared again. */
class ObjectRowsTest {
    private static final Point CENTER = new Point(1, 2, 3);

    private static GridObject grid() {
        return new GridObject(CENTER, 0.5, 2, 4, 3, BitSet.valueOf(new long[] {0b1_1000_0110}));
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

    @Test
    void rowsShareTheMap() throws Exception {
        GridObject one = grid().named("one");
        List<GeometryObject> written =
                List.of(one, one.movedTo(new Point()).named("two").turned(0, 12), new SphereObject(CENTER, 1), grid());
        ObjectRows rows = ObjectRows.of(written);
        assertThat(rows.shapes()).as("the third grid has a map of its own").hasSize(2);
        List<GeometryObject> read = ((ObjectRows) copy(rows)).objects();
        assertThat(read).isEqualTo(written);
        assertThat(((GridObject) read.get(1)).cells()).isSameAs(((GridObject) read.get(0)).cells());
        assertThat(((GridObject) read.get(3)).cells()).isNotSameAs(((GridObject) read.get(0)).cells());
        assertThat(one.turned(0, 5).cells()).isSameAs(one.cells());
    }

    @Test
    void columnsHoldMaterialsWhereThereAreAny() throws Exception {
        Material red = Material.of(Color.parse("#ff0000"));
        GridObject map = grid().named("one");
        List<GeometryObject> written = List.of(
                map.withMaterial(red),
                map.named("two"),
                new SphereObject(CENTER, 1).withMaterial(red.withLabel(2)),
                new SphereObject(CENTER, 1),
                new ObjectGroup(List.of(new SphereObject(CENTER, 1).withMaterial(red))).withMaterial(red));
        ObjectRows rows = ObjectRows.of(written);
        assertThat(rows.shapes()).as("grids of two materials share their cells").hasSize(2);
        List<GeometryObject> read = ((ObjectRows) copy(rows)).objects();
        assertThat(read).isEqualTo(written);
        assertThat(read.get(4).material()).isSameAs(read.get(0).material());
        assertThat(ObjectRows.of(written.subList(1, 2)).materials()).isNull();
    }
}
