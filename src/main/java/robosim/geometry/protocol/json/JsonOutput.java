package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.TriangleMesh;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;

/** Writes messages as JSON; every double in the shortest digits that identify it. */
final class JsonOutput {
    private static final double[] FORWARD = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    private final JsonGenerator out;

    JsonOutput(JsonGenerator out) {
        this.out = out;
    }

    /** Writes a request. */
    void write(Bundle request) throws IOException {
        if (request instanceof InitBundle init) {
            init(init, false);
        } else if (request instanceof InitBundle.Answered asked) {
            init(asked.init(), true);
        } else if (request instanceof MoveBundle moves) {
            begin("moves");
            moves(moves.moves());
            out.writeEndObject();
        } else if (request instanceof SonarRequestBundle sonars) {
            begin("sonars");
            requests(sonars.requests());
            out.writeEndObject();
        } else if (request instanceof BatchRequestBundle batch) {
            begin("batch");
            new JsonBatchOutput(out, this::object).requests(batch.requests());
            out.writeEndObject();
        } else if (request instanceof StepBundle step) {
            begin("step");
            new JsonStepOutput(out).step(step);
            out.writeEndObject();
        } else {
            throw new IllegalArgumentException(
                    "a request must be an InitBundle, an InitBundle.Answered, a MoveBundle, a"
                            + " SonarRequestBundle, a BatchRequestBundle or a StepBundle (got: "
                            + request.getClass().getSimpleName() + ")");
        }
    }

    private void init(InitBundle init, boolean isAnswered) throws IOException {
        begin("init");
        objects("objects", init.objects());
        settings(init.settings());
        if (isAnswered) {
            out.writeBooleanField("answer", true);
        }
        out.writeEndObject();
    }

    /** Writes an answer, with the id of its request if that has one. */
    void write(Reply reply, @Nullable Object id) throws IOException {
        if (reply.bundle() instanceof MoveBundle made) {
            begin("moves", id);
            moves(made.moves());
            refused(reply.problems());
        } else if (reply.bundle() instanceof StepBundle.Answer step) {
            begin("bodies", id);
            new JsonStepOutput(out).answer(step);
            refused(reply.problems());
        } else if (reply.bundle() instanceof BatchAnswerBundle batch) {
            begin("answers", id);
            new JsonBatchOutput(out, this::object).answers(batch.answers(), reply.problems());
        } else {
            begin("distances", id);
            distances(((DistanceBundle) reply.bundle()).distances(), reply.problems());
        }
        out.writeEndObject();
    }

    private void refused(List<Problem> problems) throws IOException {
        out.writeArrayFieldStart("refused");
        for (Problem problem : problems) {
            out.writeStartObject();
            out.writeNumberField("index", problem.index());
            out.writeStringField("reason", problem.reason());
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    /** Writes the answer to a peer's hello. */
    void writeHello() throws IOException {
        begin("hello");
        out.writeNumberField("version", JsonLines.VERSION);
        out.writeStringField("module", JsonLines.MODULE);
        out.writeObjectFieldStart("limits");
        out.writeNumberField("messageBytes", MessageLimits.MAX_MESSAGE_BYTES);
        out.writeNumberField("depth", MessageLimits.MAX_DEPTH);
        out.writeNumberField("references", MessageLimits.MAX_REFERENCES);
        out.writeNumberField("arrayLength", MessageLimits.MAX_ARRAY_LENGTH);
        out.writeNumberField("listLength", MessageLimits.MAX_LIST_LENGTH);
        out.writeNumberField("parts", MessageLimits.MAX_PARTS);
        out.writeNumberField("textBytes", MessageLimits.MAX_TEXT_BYTES);
        out.writeEndObject();
        out.writeEndObject();
    }

    /** Writes the answer to a ping. */
    void writePong(@Nullable Object id) throws IOException {
        begin("pong", id);
        out.writeEndObject();
    }

    /** Writes why a request is not carried out, in a conversation that goes on. */
    void writeError(String message, @Nullable Object id) throws IOException {
        begin("error", id);
        out.writeBooleanField("continues", true);
        out.writeStringField("message", message);
        out.writeEndObject();
    }

    private void begin(String type) throws IOException {
        begin(type, null);
    }

    private void begin(String type, @Nullable Object id) throws IOException {
        out.writeStartObject();
        out.writeStringField("type", type);
        if (id instanceof Long number) {
            out.writeNumberField("id", number);
        } else if (id != null) {
            out.writeStringField("id", id.toString());
        }
    }

    private void settings(@Nullable WorldSettings settings) throws IOException {
        if (settings == null) {
            return;
        }
        out.writeObjectFieldStart("settings");
        size("width", settings.width());
        size("height", settings.height());
        size("length", settings.length());
        if (settings.dimension() != null) {
            out.writeStringField("dimension", settings.dimension().name());
        }
        if (settings.accuracy() != null) {
            out.writeStringField("accuracy", settings.accuracy().name());
        }
        out.writeEndObject();
    }

    private void size(String field, double size) throws IOException {
        if (size > 0) {
            out.writeNumberField(field, size);
        }
    }

    private void moves(List<MoveRequest> moves) throws IOException {
        out.writeArrayFieldStart("moves");
        for (MoveRequest move : moves) {
            out.writeStartObject();
            out.writeStringField("objectName", move.objectName());
            out.writeNumberField("x", move.x());
            out.writeNumberField("y", move.y());
            out.writeNumberField("z", move.z());
            out.writeNumberField("rx", move.rx());
            out.writeNumberField("ry", move.ry());
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    private void requests(List<SonarRequest> requests) throws IOException {
        out.writeArrayFieldStart("requests");
        for (SonarRequest request : requests) {
            out.writeStartObject();
            out.writeStringField("objectName", request.objectName());
            out.writeNumberField("xOffset", request.xOffset());
            out.writeNumberField("zOffset", request.zOffset());
            Beam beam = request.beam();
            if (beam != null) {
                out.writeObjectFieldStart("beam");
                out.writeNumberField("min", beam.min());
                out.writeFieldName("max");
                finiteOrNull(beam.max());
                out.writeNumberField("width", beam.width());
                out.writeEndObject();
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    private void distances(List<Double> distances, List<Problem> problems) throws IOException {
        out.writeArrayFieldStart("distances");
        int problem = 0;
        for (int k = 0; k < distances.size(); k++) {
            double distance = distances.get(k);
            while (problem < problems.size() && problems.get(problem).index() < k) {
                problem++;
            }
            if (Double.isNaN(distance)) {
                boolean known =
                        problem < problems.size() && problems.get(problem).index() == k;
                out.writeStartObject();
                out.writeStringField("error", known ? problems.get(problem).reason() : "no distance");
                out.writeEndObject();
            } else {
                finiteOrNull(distance);
            }
        }
        out.writeEndArray();
    }

    private void finiteOrNull(double number) throws IOException {
        if (number < Double.POSITIVE_INFINITY) {
            out.writeNumber(number);
        } else {
            out.writeNull();
        }
    }

    private void objects(String field, List<GeometryObject> objects) throws IOException {
        out.writeArrayFieldStart(field);
        for (GeometryObject object : objects) {
            object(object);
        }
        out.writeEndArray();
    }

    private void object(GeometryObject object) throws IOException {
        out.writeStartObject();
        place(object.kind().word(), object);
        double[] sizes = object.sizes();
        for (int k = 0; k < sizes.length; k++) {
            out.writeNumberField(object.kind().sizes().get(k), sizes[k]);
        }
        if (object instanceof MeshObject mesh) {
            mesh(mesh);
        } else if (object instanceof ObjectGroup group) {
            objects("members", group.members());
            bounding(group.boundingVolume());
        } else if (object instanceof GridObject grid) {
            grid(grid);
        }
        out.writeEndObject();
    }

    private void place(String kind, GeometryObject object) throws IOException {
        out.writeStringField("kind", kind);
        if (object.name() != null) {
            out.writeStringField("name", object.name());
        }
        if (object.isMoveable()) {
            out.writeBooleanField("moveable", true);
        }
        Point center = object.center();
        numbers("center", center.x(), center.y(), center.z());
        Pose pose = object.pose();
        double[] rotation = pose.rotation();
        if (!Arrays.equals(rotation, FORWARD) || pose.heading() != 0 || pose.lostHeading() != 0) {
            numbers("rotation", rotation);
            Pose plain = Pose.of(center, 0).oriented(rotation);
            if (plain.heading() != pose.heading() || plain.lostHeading() != pose.lostHeading()) {
                numbers("headingDegrees", pose.heading(), pose.lostHeading());
            }
        }
        new JsonMaterialOutput(out).field(object.material());
    }

    private void mesh(MeshObject mesh) throws IOException {
        TriangleMesh triangles = mesh.triangles();
        out.writeArrayFieldStart("vertices");
        for (int v = 0; v < triangles.vertices(); v++) {
            out.writeStartArray();
            for (int axis = 0; axis < 3; axis++) {
                out.writeNumber(triangles.coordinate(v, axis));
            }
            out.writeEndArray();
        }
        out.writeEndArray();
        out.writeArrayFieldStart("faces");
        for (int[] face : mesh.faces()) {
            out.writeArray(face, 0, face.length);
        }
        out.writeEndArray();
        new JsonMaterialOutput(out).fields(mesh.textureCoordinates());
        if (mesh.isSolid()) {
            out.writeBooleanField("solid", true);
        }
        bounding(mesh.boundingVolume());
    }

    private void grid(GridObject grid) throws IOException {
        out.writeNumberField("cell", grid.cell());
        out.writeNumberField("height", grid.height());
        out.writeNumberField("columns", grid.columns());
        out.writeNumberField("rows", grid.rows());
        out.writeStringField("occupied", Base64.getEncoder().encodeToString(grid.bytes()));
    }

    private void bounding(@Nullable GeometryObject volume) throws IOException {
        if (volume != null) {
            out.writeFieldName("boundingVolume");
            object(volume);
        }
    }

    private void numbers(String field, double... numbers) throws IOException {
        out.writeFieldName(field);
        out.writeArray(numbers, 0, numbers.length);
    }
}
