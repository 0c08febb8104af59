package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.channel.MessageChannel;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.json.PeerAdmission;
import robosim.geometry.protocol.pace.MessagePace;

/**
 * Conversations of all sizes that are sent without waiting: how their bytes are split and joined on the way changes no
 * answer. The answers are compared with those of a session that sees no bytes.
 */
@Tag("clock")
@Timeout(120)
class PipelinedTest {
    private static final int CONVERSATIONS = Effort.cases(30);
    private static final int BUFFER = 8192;

    /** What it is sent, and what must be answered. */
    private record Talk(byte[] sent, List<Bundle> answers, int longBehindAnother) {
        static Talk of(Tongue tongue, SplittableRandom random) throws IOException {
            ByteArrayOutputStream sent = new ByteArrayOutputStream();
            Tongue.Saying saying = tongue == Tongue.JAVA ? tongue.over(sent) : json(sent, random);
            Session session = new Session();
            List<Bundle> answers = new ArrayList<>();
            int longBehindAnother = 0;
            for (int k = random.nextInt(1, 30); k >= 0; k--) {
                Bundle request = request(random, answers.isEmpty() && k % 2 == 0);
                int before = sent.size();
                saying.say(request);
                longBehindAnother += before > 0 && sent.size() - before > BUFFER ? 1 : 0;
                Bundle answer = session.answer(request);
                if (answer != null) {
                    answers.add(answer);
                }
            }
            return new Talk(sent.toByteArray(), answers, longBehindAnother);
        }

        /** Lines as other writers make them: the type anywhere, blanks, both ends of a line. */
        private static Tongue.Saying json(OutputStream out, SplittableRandom random) throws IOException {
            line(out, "{\"type\":\"hello\",\"version\":1}", random);
            return bundle -> {
                if (random.nextInt(4) == 0) {
                    line(out, "{\"type\":\"ping\",\"id\":" + random.nextInt(9) + "}", random);
                }
                line(out, JsonLines.write(bundle), random);
            };
        }

        private static void line(OutputStream out, String written, SplittableRandom random) throws IOException {
            String line = written;
            if (random.nextInt(3) == 0) {
                int end = line.indexOf(',');
                line = "{ " + line.substring(end + 1, line.length() - 1) + "  ,\t" + line.substring(1, end) + "}";
            }
            out.write((line + (random.nextInt(3) == 0 ? "\r\n" : "\n")).getBytes(StandardCharsets.UTF_8));
        }

        private static Bundle request(SplittableRandom random, boolean world) {
            int size = (int) Math.pow(2, random.nextDouble(0, 10.5));
            if (world) {
                List<GeometryObject> objects = new ArrayList<>();
                objects.add(new CylinderObject(new Point(), 0.25, 1).moveable("räuber"));
                for (int k = 0; k < size; k++) {
                    Point at = new Point(random.nextDouble(1, 30), 0, random.nextDouble(-20, 20));
                    objects.add(new BoxObject(at, 0.2, 1, 0.3).turned(0, random.nextInt(90)));
                }
                return new InitBundle(objects);
            }
            String name = random.nextInt(9) == 0 ? "\ud83e\udd16" : "räuber"; // of two, three and four bytes
            if (random.nextBoolean()) {
                List<MoveRequest> moves = new ArrayList<>();
                for (int k = 0; k < size; k++) {
                    moves.add(new MoveRequest(name, random.nextDouble(-0.01, 0.02), 0, 0, 0, random.nextDouble()));
                }
                return new MoveBundle(moves);
            }
            List<SonarRequest> sonars = new ArrayList<>();
            for (int k = 0; k < size; k++) {
                sonars.add(new SonarRequest(name, random.nextDouble(), random.nextDouble(-1, 1)));
            }
            return new SonarRequestBundle(sonars);
        }
    }

    /** Hands on as many bytes as it likes, or as many as are asked for. */
    private static final class Split extends InputStream {
        private final ByteArrayInputStream all;
        private final SplittableRandom random;
        private final int most;

        Split(byte[] bytes, SplittableRandom random) {
            this.all = new ByteArrayInputStream(bytes);
            this.random = random;
            this.most = random.nextInt(4) == 0 ? Integer.MAX_VALUE : 1 << random.nextInt(4, 18);
        }

        @Override
        public int read() {
            return all.read();
        }

        @Override
        public int read(byte[] into, int at, int length) {
            return all.read(into, at, Math.min(length, most == Integer.MAX_VALUE ? most : random.nextInt(1, most)));
        }
    }

    private static List<Bundle> heard(Tongue tongue, InputStream answers) throws IOException {
        List<Bundle> heard = new ArrayList<>();
        Tongue.Hearing hearing = tongue.over(answers);
        for (Bundle answer = hear(hearing); answer != null; answer = hear(hearing)) {
            heard.add(answer);
        }
        return heard;
    }

    private static Bundle hear(Tongue.Hearing hearing) throws IOException {
        return hearing.hear();
    }

    /** Answers without what a ping is answered by. */
    private static byte[] withoutPongs(Tongue tongue, byte[] answers) {
        return tongue == Tongue.JAVA
                ? answers
                : new String(answers, StandardCharsets.UTF_8)
                        .replaceAll("\\{\"type\":\"pong\"[^\n]*\n", "")
                        .getBytes(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @EnumSource
    void anAnswerDoesNotDependOnHowItsRequestArrived(Tongue tongue) throws Exception {
        SplittableRandom random = new SplittableRandom(24);
        int longBehindAnother = 0;
        for (int k = 0; k < CONVERSATIONS; k++) {
            Talk talk = Talk.of(tongue, random.split());
            longBehindAnother += talk.longBehindAnother();
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            InputStream in = new Split(talk.sent(), random.split());
            MessageChannel channel =
                    new MessageChannel(in, out, MessageTranslator.RECORDS, MessagePace.NONE, PeerAdmission.OPEN);
            Session session = new Session();
            for (Bundle request = channel.read(); request != null; request = channel.read()) {
                Reply reply = session.reply(request);
                if (reply != null) {
                    channel.write(reply);
                }
            }
            byte[] answers = withoutPongs(tongue, out.toByteArray());
            assertThat(heard(tongue, new ByteArrayInputStream(answers)))
                    .as("conversation " + k)
                    .isEqualTo(talk.answers());
        }
        assertThat(longBehindAnother).as("long messages behind others").isGreaterThan(CONVERSATIONS);
    }

    @ParameterizedTest
    @EnumSource
    void overASocketToo(Tongue tongue) throws Exception {
        SplittableRandom random = new SplittableRandom(42);
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0)) {
            for (int k = 0; k < 10; k++) {
                Talk talk = Talk.of(tongue, random.split());
                try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
                    socket.setSoTimeout(20_000);
                    Thread sender = new Thread(() -> send(socket, talk.sent()), "sender");
                    sender.start();
                    byte[] answers =
                            withoutPongs(tongue, socket.getInputStream().readAllBytes());
                    sender.join();
                    assertThat(heard(tongue, new ByteArrayInputStream(answers))).isEqualTo(talk.answers());
                }
            }
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    private static void send(Socket socket, byte[] bytes) {
        try {
            socket.getOutputStream().write(bytes);
            socket.shutdownOutput();
        } catch (IOException e) {
            return; // the listening half sees it too
        }
    }

    /** The least that was refused: a long line behind a short one. */
    @Test
    void aLongLineMayComeBehindAnother() throws Exception {
        String hello = "{\"type\":\"hello\",\"version\":1}\n";
        String moves = "{\"type\":\"moves\",\"moves\":[]}\n";
        String both = hello
                + moves.replace("}", " ".repeat(70_000) + "}")
                + moves.replace("[", "[" + " ".repeat(9000))
                + moves.replace("[", "[" + " ".repeat(9000))
                + moves;
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        MessageChannel channel = new MessageChannel(
                new ByteArrayInputStream(both.getBytes(StandardCharsets.UTF_8)),
                out,
                MessageTranslator.RECORDS,
                MessagePace.NONE,
                PeerAdmission.OPEN);
        for (int k = 0; k < 4; k++) {
            assertThat(channel.read()).isEqualTo(new MoveBundle(List.of()));
        }
        assertThat(channel.read()).isNull();
    }
}
