package robosim.geometry.scenario;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.scenario.recording.QuietLog;

/** What an environment says, to be recorded. */
final class Conversation {
    final String title;
    final List<Bundle> requests = new ArrayList<>();
    private final List<String> notes = new ArrayList<>();

    Conversation(String title) {
        this.title = title;
    }

    /** The next request is about this. */
    Conversation note(String text) {
        while (notes.size() < requests.size()) {
            notes.add("");
        }
        notes.add(text);
        return this;
    }

    Conversation world(Dimension dimension, double size, GeometryObject... objects) {
        WorldSettings settings = new WorldSettings(size, size, size, dimension, Accuracy.EXACT);
        return ask(new InitBundle(List.of(objects), settings));
    }

    Conversation ask(Bundle request) {
        requests.add(request);
        return this;
    }

    Conversation moves(MoveRequest... moves) {
        return ask(new MoveBundle(List.of(moves)));
    }

    /** A translation in the plane. */
    static MoveRequest move(String name, double x, double z) {
        return new MoveRequest(name, x, 0, z, 0, 0);
    }

    static MoveRequest turn(String name, double ry) {
        return new MoveRequest(name, 0, 0, 0, 0, ry);
    }

    Conversation sonars(SonarRequest... requests) {
        return ask(new SonarRequestBundle(List.of(requests)));
    }

    static SonarRequest sonar(String name, double x, double z) {
        return new SonarRequest(name, x, z);
    }

    static SonarRequest sonar(String name, double x, double z, double min, double max, double width) {
        return new SonarRequest(name, x, z, new Beam(min, max, width));
    }

    /** A recording of it, without times. */
    byte[] recorded() throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ScenarioHeader header = new ScenarioHeader(title, SessionOptions.ROBOSIM);
        try (Recorder recorder = new Recorder(title, () -> new ScenarioWriter(file, header), null)) {
            Session session = new Session(SessionOptions.ROBOSIM, recorder, title, new QuietLog());
            for (int k = 0; k < requests.size(); k++) {
                String note = note(k);
                if (note != null) {
                    recorder.note(note);
                }
                session.reply(requests.get(k));
            }
        }
        return file.toByteArray();
    }

    private @Nullable String note(int k) {
        return k < notes.size() && !notes.get(k).isEmpty() ? notes.get(k) : null;
    }
}
