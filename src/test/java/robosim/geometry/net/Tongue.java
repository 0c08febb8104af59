package robosim.geometry.net;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.channel.MessageChannel;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.json.PeerAdmission;
import robosim.geometry.protocol.pace.MessagePace;

/** What an environment speaks. */
enum Tongue {
    JAVA {
        @Override
        Saying over(OutputStream out) throws IOException {
            MessageWriter writer = new MessageWriter(out);
            return writer::write;
        }

        @Override
        Hearing over(InputStream in) {
            MessageReader reader = new MessageReader(in);
            return reader::read;
        }

        @Override
        long[] answerEnds(List<Reply> replies) throws IOException {
            return ends(this, replies.stream().map(Reply::bundle).toList());
        }
    },

    JSON {
        @Override
        Saying over(OutputStream out) throws IOException {
            line(out, HELLO);
            return bundle -> line(out, JsonLines.write(bundle));
        }

        @Override
        Hearing over(InputStream in) {
            BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
            boolean[] greeted = new boolean[1];
            return () -> {
                String line = lines.readLine();
                while (!greeted[0] && line != null) {
                    greeted[0] = line.contains("\"hello\""); // before it there may be a stream header
                    line = lines.readLine();
                }
                return line == null ? null : JsonLines.readReply(line).bundle();
            };
        }

        @Override
        long[] answerEnds(List<Reply> replies) throws IOException {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            ByteArrayOutputStream hello = new ByteArrayOutputStream();
            line(hello, HELLO);
            ByteArrayInputStream in = new ByteArrayInputStream(hello.toByteArray());
            new MessageChannel(in, bytes, MessageTranslator.RECORDS, MessagePace.NONE, PeerAdmission.OPEN).read();
            long[] ends = new long[replies.size()];
            for (int k = 0; k < ends.length; k++) {
                line(bytes, JsonLines.write(replies.get(k)));
                ends[k] = bytes.size() - 1; // a listener need not see the line feed
            }
            return ends;
        }
    };

    private static final String HELLO = "{\"type\":\"hello\",\"version\":1}";

    /** Says one bundle, whole. */
    @FunctionalInterface
    interface Saying {
        void say(Bundle bundle) throws IOException;
    }

    /** Hears one answer. */
    @FunctionalInterface
    interface Hearing {
        /** Null at the end. */
        @Nullable
        Bundle hear() throws IOException;
    }

    abstract Saying over(OutputStream out) throws IOException;

    abstract Hearing over(InputStream in) throws ProtocolException;

    /** Where each answer ends in the module's stream. */
    abstract long[] answerEnds(List<Reply> replies) throws IOException;

    /** Where each message ends in an environment's stream. */
    static long[] ends(Tongue tongue, List<Bundle> messages) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Saying saying = tongue.over(bytes);
        long[] ends = new long[messages.size()];
        for (int k = 0; k < ends.length; k++) {
            saying.say(messages.get(k));
            ends[k] = bytes.size();
        }
        return ends;
    }

    private static void line(OutputStream out, String line) throws IOException {
        out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
        out.flush();
    }
}
