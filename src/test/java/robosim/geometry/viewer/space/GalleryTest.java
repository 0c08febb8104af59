package robosim.geometry.viewer.space;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.space.Gallery.Arrangement;
import robosim.geometry.viewer.space.Gallery.Cell;

class GalleryTest {
    private static final GeometryObject DRUM = new CylinderObject(new Point(-5, 0, 0), 0.5, 1).moveable("drum");
    private static final GeometryObject CART = new CylinderObject(new Point(-7, 0, 3), 0.5, 1).moveable("cart");
    private static final Moment MOMENT = BackgroundRendererTest.moment(DRUM, CART);

    private static Gallery gallery(Arrangement arrangement) {
        Gallery gallery = new Gallery();
        gallery.resize(803, 601);
        gallery.show(arrangement);
        return gallery;
    }

    @Test
    void picturesShareTheAreaWithoutOverlap() {
        for (Arrangement arrangement : Arrangement.values()) {
            for (int[] size : new int[][] {{803, 601}, {300, 900}, {9, 7}}) {
                Gallery gallery = gallery(arrangement);
                gallery.resize(size[0], size[1]);
                List<Shot> shots = gallery.shots(MOMENT, null);
                List<Cell> cells = gallery.cells();
                assertThat(shots).hasSameSizeAs(cells);
                int covered = 0;
                for (int k = 0; k < cells.size(); k++) {
                    Cell cell = cells.get(k);
                    covered += cell.width() * cell.height();
                    assertThat(shots.get(k).view().width()).isEqualTo(cell.width());
                    assertThat(shots.get(k).view().height()).isEqualTo(cell.height());
                }
                int found = 0;
                for (int x = 0; x < size[0]; x++) {
                    for (int y = 0; y < size[1]; y++) {
                        found += gallery.at(x, y) >= 0 ? 1 : 0;
                    }
                }
                assertThat(found).isEqualTo(covered); // so no pixel is in two of them
            }
        }
    }

    @Test
    void aKeyGoesThroughAllArrangements() {
        Gallery gallery = gallery(Arrangement.ONE);
        for (Arrangement each : List.of(Arrangement.OWN, Arrangement.TWO, Arrangement.FOUR, Arrangement.ONE)) {
            gallery.next();
            assertThat(gallery.arrangement()).isEqualTo(each);
        }
    }

    @Test
    void aCameraThatFollowsKeepsItsDistance() {
        Gallery gallery = gallery(Arrangement.ONE);
        Point still = gallery.shots(MOMENT, "cart").get(0).view().pose().center();
        gallery.follow(true);
        Point with = gallery.shots(MOMENT, "cart").get(0).view().pose().center();
        assertThat(with).isNotEqualTo(still);
        GeometryObject there = CART.movedTo(new Point(-6, 0, 3.5));
        Point later = gallery.shots(BackgroundRendererTest.moment(DRUM, there), null)
                .get(0)
                .view()
                .pose()
                .center();
        assertThat(later.x() - with.x()).isCloseTo(1, within(1e-9));
        assertThat(later.z() - with.z()).isCloseTo(0.5, within(1e-9));
        gallery.follow(false);
        Point stays = gallery.shots(MOMENT, "cart").get(0).view().pose().center();
        assertThat(stays).isEqualTo(later);
    }

    @Test
    void theRobotIsTheSelectedOneOrElseTheFirst() {
        Gallery gallery = gallery(Arrangement.OWN);
        assertThat(gallery.shots(MOMENT, null).get(0).carrier()).isEqualTo("drum");
        assertThat(gallery.shots(MOMENT, "cart").get(0).carrier()).isEqualTo("cart");
        assertThat(gallery.cells().get(0).label()).isEqualTo("what cart sees");
        // It stays when something else is selected, as long as it is there.
        assertThat(gallery.shots(MOMENT, null).get(0).carrier()).isEqualTo("cart");
        assertThat(gallery.shots(BackgroundRendererTest.moment(DRUM), "nobody")
                        .get(0)
                        .carrier())
                .isEqualTo("drum");
        assertThat(gallery.shots(BackgroundRendererTest.moment(), null).get(0).at(BackgroundRendererTest.moment()))
                .isNull();
        assertThat(gallery.cells().get(0).label()).isEqualTo("no robot");
    }

    @Test
    void aRobotLooksForwardUntilItIsToldToLookElsewhere() {
        Gallery gallery = gallery(Arrangement.OWN);
        GeometryObject turned = DRUM.turned(0, 90); // towards -Z
        Moment moment = BackgroundRendererTest.moment(turned);
        SpaceView view = gallery.shots(moment, null).get(0).at(moment);
        Point way = view.direction(803 / 2.0, 601 / 2.0);
        assertThat(way.x()).isCloseTo(0, within(1e-12));
        assertThat(way.z()).isCloseTo(-1, within(1e-12));
        gallery.press(5, 5);
        gallery.drag(450, 0, Gallery.Hand.ORBIT); // what is seen follows the hand: it looks to its left, along -X
        gallery.zoom(5, 5, 3);
        SpaceView left = gallery.shots(moment, null).get(0).at(moment);
        assertThat(left.direction(803 / 2.0, 601 / 2.0).x()).isCloseTo(-1, within(1e-12));
        assertThat(left.fieldOfView()).isCloseTo(view.fieldOfView() / 3, within(1e-9));
        gallery.fly(1, 0, 0);
        gallery.fit();
        assertThat(gallery.shots(moment, null).get(0).at(moment)).isEqualTo(view);
    }

    @Test
    void aHandMovesTheCameraThatItTookHoldOf() {
        Gallery gallery = gallery(Arrangement.FOUR);
        List<Shot> before = gallery.shots(MOMENT, null);
        for (int number : new int[] {0, 2, 3}) {
            Cell cell = gallery.cells().get(number);
            gallery.press(cell.x() + 3, cell.y() + 3);
            gallery.drag(20, -10, Gallery.Hand.ORBIT);
            List<Shot> orbited = gallery.shots(MOMENT, null);
            gallery.drag(20, -10, Gallery.Hand.PAN);
            List<Shot> panned = gallery.shots(MOMENT, null);
            gallery.drag(20, -10, Gallery.Hand.LOOK);
            gallery.zoom(cell.x() + 9.0, cell.y() + 9.0, 1.5);
            gallery.fly(1, 0, 0);
            gallery.center(new Point(1, 0, 1));
            List<Shot> after = gallery.shots(MOMENT, null);
            for (int k = 0; k < 4; k++) {
                assertThat(after.get(k).equals(before.get(k))).isEqualTo(k != number);
            }
            assertThat(orbited.get(number)).isNotEqualTo(before.get(number));
            assertThat(panned.get(number)).isNotEqualTo(orbited.get(number));
            gallery.fit();
            assertThat(gallery.shots(MOMENT, null)).isEqualTo(before);
        }
    }

    @Test
    void fromAboveNorthIsUpAsOnThePlan() {
        Gallery gallery = gallery(Arrangement.FOUR);
        SpaceView above = gallery.shots(MOMENT, null).get(2).view();
        double[] east = new double[3];
        double[] north = new double[3];
        double[] middle = new double[3];
        assertThat(above.project(0, 0, 0, middle)).isTrue();
        assertThat(above.project(5, 0, 0, east)).isTrue();
        assertThat(above.project(0, 0, -3, north)).isTrue();
        assertThat(east[0]).isGreaterThan(middle[0] + 10);
        assertThat(east[1]).isCloseTo(middle[1], within(1e-9));
        assertThat(north[1]).isLessThan(middle[1] - 10);
        assertThat(north[0]).isCloseTo(middle[0], within(1e-9));
    }
}
