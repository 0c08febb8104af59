package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Writes requests of a batch about the world's objects, and their answers, as JSON. */
final class JsonWorldOutput {
    private final JsonGenerator out;
    private final JsonBatchOutput.ObjectWriter objects;

    JsonWorldOutput(JsonGenerator out, JsonBatchOutput.ObjectWriter objects) {
        this.out = out;
        this.objects = objects;
    }

    void request(WorldRequest request) throws IOException {
        if (request instanceof WorldRequest.Describe) {
            out.writeStringField("kind", "world");
        } else if (request instanceof WorldRequest.Add add) {
            out.writeStringField("kind", "add");
            out.writeFieldName("object");
            objects.write(add.object());
            if (add.overlapping()) {
                out.writeBooleanField("overlapping", true);
            }
        } else if (request instanceof WorldRequest.Place place) {
            named("place", place);
            point("center", place.center());
            out.writeNumberField("heading", place.heading());
        } else if (request instanceof WorldRequest.Go move) {
            named("move", move);
            out.writeNumberField("x", move.x());
            out.writeNumberField("y", move.y());
            out.writeNumberField("z", move.z());
            out.writeNumberField("rx", move.rx());
            out.writeNumberField("ry", move.ry());
        } else {
            named(request instanceof WorldRequest.Locate ? "pose" : "remove", request);
        }
    }

    private void named(String kind, WorldRequest request) throws IOException {
        out.writeStringField("kind", kind);
        out.writeStringField("objectName", request.objectName());
    }

    void answer(WorldAnswer answer) throws IOException {
        if (answer instanceof WorldAnswer.Described world) {
            described(world);
        } else if (answer instanceof WorldAnswer.Located pose) {
            point("center", pose.center());
            out.writeFieldName("rotation");
            out.writeArray(pose.rotation().values(), 0, pose.rotation().size());
            out.writeNumberField("heading", pose.heading());
        } else if (answer instanceof WorldAnswer.Changed change) {
            out.writeBooleanField("done", change.done());
            obstacle(change.obstacle());
        } else {
            went((WorldAnswer.Went) answer);
        }
    }

    private void went(WorldAnswer.Went move) throws IOException {
        out.writeBooleanField("made", move.made());
        Point contact = move.contact();
        Point normal = move.normal();
        if (contact != null && normal != null) {
            out.writeNumberField("fraction", move.fraction());
            out.writeNumberField("turnFraction", move.turnFraction());
            obstacle(move.obstacle());
            point("contact", contact);
            point("normal", normal);
        }
    }

    private void described(WorldAnswer.Described world) throws IOException {
        out.writeNumberField("added", world.added());
        out.writeArrayFieldStart("leftOut");
        for (WorldAnswer.LeftOut object : world.leftOut()) {
            out.writeStartObject();
            out.writeNumberField("index", object.index());
            if (!object.name().isEmpty()) {
                out.writeStringField("name", object.name());
            }
            out.writeStringField("reason", object.reason());
            out.writeEndObject();
        }
        out.writeEndArray();
        out.writeNumberField("width", world.width());
        out.writeNumberField("height", world.height());
        out.writeNumberField("length", world.length());
        out.writeStringField("dimension", world.dimension().name());
        out.writeStringField("accuracy", world.accuracy().name());
    }

    private void obstacle(@Nullable String name) throws IOException {
        if (name != null) {
            out.writeStringField("obstacle", name);
        }
    }

    private void point(String field, Point point) throws IOException {
        out.writeFieldName(field);
        out.writeArray(new double[] {point.x(), point.y(), point.z()}, 0, 3);
    }
}
