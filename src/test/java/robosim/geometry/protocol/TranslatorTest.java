package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.Vector;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.pace.MessagePace;

/** An environment of old, with mutable classes of its own. */
class TranslatorTest {
    /** As such classes were written. */
    static class OldMoves implements Serializable {
        private static final long serialVersionUID = 42;

        Vector<OldMove> moves = new Vector<>();
    }

    static class OldMove implements Serializable {
        private static final long serialVersionUID = 43;

        String name = "";
        double forward;
        double turn;
    }

    /** Uses one answer object for all answers, as old code did. */
    static final class OldTranslator implements MessageTranslator {
        private final OldMoves reused = new OldMoves();

        @Override
        public Set<Class<?>> classes() {
            return Set.of(OldMoves.class, OldMove.class, Vector.class, Object[].class);
        }

        @Override
        public Bundle decode(Object message) {
            if (!(message instanceof OldMoves old)) {
                return MessageTranslator.RECORDS.decode(message);
            }
            List<MoveRequest> moves = new ArrayList<>();
            for (OldMove move : old.moves) {
                moves.add(new MoveRequest(move.name, move.forward, 0, 0, 0, move.turn));
            }
            return new MoveBundle(moves);
        }

        @Override
        public Object encode(Bundle bundle) {
            if (!(bundle instanceof MoveBundle answer)) {
                return bundle;
            }
            reused.moves.clear();
            for (MoveRequest request : answer.moves()) {
                OldMove move = new OldMove();
                move.name = request.objectName();
                move.forward = request.x();
                move.turn = request.ry();
                reused.moves.add(move);
            }
            return reused;
        }
    }

    private static OldMoves old(String name) {
        OldMove move = new OldMove();
        move.name = name;
        move.forward = 1.5;
        OldMoves moves = new OldMoves();
        moves.moves.add(move);
        return moves;
    }

    private static byte[] stream(Object... objects) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            for (Object object : objects) {
                out.writeObject(object);
            }
        }
        return bytes.toByteArray();
    }

    private static MessageReader reader(byte[] bytes) {
        return new MessageReader(new ByteArrayInputStream(bytes), new OldTranslator(), MessagePace.NONE);
    }

    @Test
    void whatTheEnvironmentSendsBecomesABundle() throws IOException {
        MessageReader reader = reader(stream(old("a"), new MoveBundle(List.of())));
        assertThat(reader.read()).isEqualTo(new MoveBundle(List.of(new MoveRequest("a", 1.5, 0, 0, 0, 0))));
        assertThat(reader.read()).as("records pass too").isEqualTo(new MoveBundle(List.of()));
    }

    @Test
    void anAnswerThatIsChangedAndSentAgainIsNotStale() throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        MessageWriter writer = new MessageWriter(bytes, new OldTranslator());
        for (String name : List.of("a", "b")) {
            writer.write(new MoveBundle(List.of(new MoveRequest(name, 2, 0, 0, 0, 0))));
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            assertThat(((OldMoves) in.readObject()).moves.get(0).name).isEqualTo("a");
            assertThat(((OldMoves) in.readObject()).moves.get(0).name).isEqualTo("b");
        }
    }

    @Test
    void onlyTheTranslatorsOwnClassesAreAdded() throws IOException {
        assertThatThrownBy(() -> reader(stream(new ArrayList<>(List.of(1.0)))).read())
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("ArrayList");
        byte[] bytes = stream(old("a"));
        assertThatThrownBy(() -> new MessageReader(new ByteArrayInputStream(bytes)).read())
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("OldMoves");
    }

    @Test
    void whatTheTranslatorRefusesIsAProtocolFailure() throws IOException {
        byte[] bytes = stream(old("a"), "text", old("b"));
        MessageReader reader = reader(bytes);
        assertThat(reader.read()).isNotNull();
        assertThatThrownBy(reader::read).isInstanceOf(ProtocolException.class).hasMessageContaining("java.lang.String");
        OldMoves bad = old("a");
        bad.moves.get(0).forward = Double.NaN;
        byte[] nan = stream(bad);
        assertThatThrownBy(() -> reader(nan).read())
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("x must be a number");
    }

    @Test
    void withoutAServiceTheRecordsAreSpoken() {
        assertThat(MessageTranslator.installed()).isSameAs(MessageTranslator.RECORDS);
    }
}
