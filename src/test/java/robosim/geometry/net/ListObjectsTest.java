package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.batch.ListedObject;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** The request that lists what is in the world, page by page. */
class ListObjectsTest extends SessionOfObjects {
    private List<ListedObject> list(int count) {
        List<ListedObject> all = new ArrayList<>();
        long first = 0;
        while (first >= 0) {
            WorldAnswer.Listed page = (WorldAnswer.Listed)
                    ask(new WorldRequest.ListObjects(first, count)).get(0);
            assertThat(page.objects()).hasSizeLessThanOrEqualTo(count);
            assertThat(page.fits(new WorldRequest.ListObjects(first, count))).isTrue();
            all.addAll(page.objects());
            first = page.next();
        }
        return all;
    }

    @Test
    void whatIsInTheWorldIsTold() {
        assertThat(reply(new WorldRequest.ListObjects(0, 9)).problems()).hasSize(1);
        GeometryObject outside = new SphereObject(new Point(30, 0, 0), 1);
        session.reply(new InitBundle(List.of(WALL, outside, POST, ROBOT, POST, WALL, POST), SPATIAL));
        ask(new WorldRequest.Place("robot", new Point(0, 0.25, 5), Math.PI / 2));
        List<ListedObject> all = list(100);
        assertThat(all).extracting(ListedObject::index).containsExactly(0L, 2L, 3L, 4L, 6L);
        assertThat(all).extracting(ListedObject::name).containsExactly("wall", "", "robot", "", "");
        assertThat(all.get(2))
                .isEqualTo(new ListedObject(
                        3,
                        "robot",
                        GeometryObject.Kind.CYLINDER,
                        new Point(0, 0.25, 5),
                        Math.PI / 2,
                        true,
                        new Point(-0.25, -0.25, 4.75),
                        new Point(0.25, 0.75, 5.25)));
        for (int count = 1; count < 7; count++) {
            assertThat(list(count)).as("in pages of " + count).isEqualTo(all);
        }
    }

    /** The numbers are those by which obstacles are told, however the world has changed since. */
    @Test
    void whatWasAddedAndRemovedIsListed() {
        SplittableRandom random = new SplittableRandom(5);
        session.reply(new InitBundle(List.of(WALL, ROBOT), SPATIAL));
        List<Long> numbers = new ArrayList<>(List.of(0L, 1L));
        List<String> names = new ArrayList<>(List.of("wall", "robot"));
        long next = 2;
        for (int k = 0; k < 2000; k++) {
            int at = random.nextInt(names.size());
            if (random.nextInt(3) == 0 && names.size() > 1 && !names.get(at).isEmpty()) {
                ask(new WorldRequest.Remove(names.remove(at)));
                numbers.remove(at);
            } else {
                String name = random.nextInt(4) == 0 ? "" : "o" + random.nextInt(500);
                GeometryObject ball = new SphereObject(new Point(random.nextDouble(-8, 8), 0, 0), 0.1);
                WorldRequest add = new WorldRequest.Add(name.isEmpty() ? ball : ball.named(name), true);
                if (ask(add).get(0) instanceof WorldAnswer.Changed change && change.done()) {
                    names.add(name);
                    numbers.add(next++);
                }
            }
            if (k % 100 == 99) {
                List<ListedObject> all = list(k < 1000 ? 1 + random.nextInt(50) : 1 << 16);
                assertThat(all).extracting(ListedObject::name).isEqualTo(names);
                assertThat(all).extracting(ListedObject::index).isEqualTo(numbers);
            }
        }
        assertThat(names).hasSizeGreaterThan(300);
    }

    /** An answer of long names is no longer than a message may be. */
    @Test
    void longNamesMakeShortPages() {
        List<GeometryObject> objects = new ArrayList<>();
        for (int k = 0; k < 40; k++) {
            objects.add(new SphereObject(new Point(), 0.1).named("n".repeat(60_000) + k));
        }
        session.reply(new InitBundle(objects, SPATIAL));
        WorldAnswer.Listed page =
                (WorldAnswer.Listed) ask(new WorldRequest.ListObjects(0, 100)).get(0);
        assertThat(page.objects()).hasSize(17);
        assertThat(page.next()).isEqualTo(17);
        assertThat(list(100)).hasSize(40);
    }
}
