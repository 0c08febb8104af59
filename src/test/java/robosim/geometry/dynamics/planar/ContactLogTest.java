package robosim.geometry.dynamics.planar;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

class ContactLogTest {
    private final ObjectTable objects;
    private final int ball;
    private final int room;
    private final int pole;
    private ContactLog log;
    private ContactLog before;

    ContactLogTest() {
        Geometry world = new Geometry(40, 40, 40);
        BoxObject box = new BoxObject(new Point(5, 0, 0), 1, 1, 1);
        world.addObject(new ObjectGroup(List.of(box)).named("room"));
        world.addObject(box.movedTo(new Point(9, 0, 0)).named("pole"));
        world.addObject(new SphereObject(new Point(0, 0, 0), 1).moveable("ball"));
        objects = world.engine().objects;
        ball = objects.find("ball");
        room = objects.find("room");
        pole = objects.find("pole");
        log = new ContactLog(objects);
        before = new ContactLog(objects);
    }

    private void begin() {
        ContactLog last = log;
        log = before;
        before = last;
        log.begin(before);
    }

    /** Notes a contact whose normal is so many degrees from straight up. */
    private void note(int object, double degrees, double impulse) {
        double angle = Math.toRadians(degrees);
        log.note(ball, object, 0, 0, 0, Math.sin(angle), Math.cos(angle), 0, impulse);
    }

    private void touch(int object, double... degrees) {
        for (double each : degrees) {
            note(object, each, 1);
        }
        log.tell();
    }

    @Test
    void facesOfOneObjectAreContactsOfTheirOwn() {
        begin();
        touch(room, 0, 10, 90, 0);
        touch(room, 90);
        assertThat(log.count()).isEqualTo(3);
        assertThat(log.impulse(0)).isEqualTo(2);
        assertThat(log.impulse(1)).isEqualTo(1);
        assertThat(log.impulse(2)).isEqualTo(2);
    }

    @Test
    void theBorderHasFacesToo() {
        begin();
        touch(-1, 0, 90);
        assertThat(log.count()).isEqualTo(2);
        assertThat(log.other(0)).isNull();
    }

    @Test
    void twoConvexObjectsHaveOneContactHoweverTheyTurn() {
        begin();
        touch(pole, 0);
        touch(pole, 90);
        assertThat(log.count()).isEqualTo(1);
        begin();
        touch(pole, 180);
        assertThat(log.isOld(0)).isTrue();
        assertThat(before.goesOn(0)).isTrue();
    }

    @Test
    void aNormalThatTurnsStaysOneContact() {
        begin();
        for (int degrees = 0; degrees <= 80; degrees += 20) {
            touch(room, degrees);
        }
        assertThat(log.count()).isEqualTo(1);
        assertThat(log.impulse(0)).isEqualTo(5);
        begin();
        touch(room, 100);
        assertThat(log.isOld(0)).isTrue();
        touch(room, 0);
        assertThat(log.count()).isEqualTo(2);
        assertThat(log.isOld(1)).isFalse();
    }

    /** Also if another one is told before it, or if it is near without a push. */
    @Test
    void aFaceThatIsStillTouchedIsNotTakenForOneThatHasTurned() {
        begin();
        touch(room, 0);
        begin();
        touch(room, 10, 0);
        assertThat(log.count()).isEqualTo(2);
        assertThat(List.of(log.isOld(0), log.isOld(1))).containsExactly(false, true);
        begin();
        touch(room, 0);
        note(room, 0, -1);
        note(room, 10, 1);
        log.tell();
        assertThat(log.count()).isEqualTo(2);
        assertThat(List.of(log.isOld(0), log.isOld(1))).containsExactly(true, true);
    }

    @Test
    void whatIsNearWithoutAPushIsNoContact() {
        begin();
        note(room, 0, -1);
        note(pole, 0, -1);
        log.tell();
        assertThat(log.count()).isZero();
    }

    @Test
    void oneFaceOfSeveralEnds() {
        begin();
        touch(room, 0, 90);
        begin();
        touch(room, 90);
        assertThat(List.of(before.goesOn(0), before.goesOn(1))).containsExactly(false, true);
    }

    @Test
    void whereTheyTouchIsThatOfTheGreatestImpulse() {
        begin();
        log.note(ball, room, 1, 2, 3, 0, 1, 0, 1);
        log.note(ball, room, 4, 5, 6, 0, 1, 0, 2);
        log.note(ball, room, 7, 8, 9, 0, 1, 0, 0.5);
        log.tell();
        assertThat(List.of(log.point(0, 0), log.point(0, 1), log.point(0, 2))).containsExactly(4.0, 5.0, 6.0);
        assertThat(log.impulse(0)).isEqualTo(3.5);
    }

    @Test
    void keepsAnyNumber() {
        begin();
        for (int degrees = 0; degrees < 360; degrees++) {
            note(room, degrees, 1);
        }
        note(pole, 0, 1);
        log.tell();
        begin();
        for (int degrees = 359; degrees >= 0; degrees--) {
            note(room, degrees, 1);
        }
        note(pole, 0, 1);
        log.tell();
        assertThat(log.count()).isEqualTo(361);
        for (int entry = 0; entry < 361; entry++) {
            assertThat(log.isOld(entry)).isTrue();
            assertThat(before.goesOn(entry)).isTrue();
        }
    }
}
