package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.batch.ListedObject;
import robosim.geometry.protocol.batch.Obstacle;
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
        if (request instanceof WorldRequest.Identify identify) {
            request(identify.request());
            out.writeBooleanField("identify", true);
        } else if (request instanceof WorldRequest.Describe) {
            out.writeStringField("kind", "world");
        } else if (request instanceof WorldRequest.ListObjects list) {
            out.writeStringField("kind", "list");
            out.writeNumberField("first", list.first());
            out.writeNumberField("count", list.count());
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
            numbers(move.x(), move.y(), move.z(), move.rx(), move.ry());
        } else if (request instanceof WorldRequest.GoToContact move) {
            named("moveToContact", move);
            numbers(move.x(), move.y(), move.z(), move.rx(), move.ry());
            out.writeNumberField("clearance", move.clearance());
        } else if (request instanceof WorldRequest.GoAndSlide move) {
            named("moveAndSlide", move);
            numbers(move.x(), move.y(), move.z(), move.rx(), move.ry());
            out.writeNumberField("clearance", move.clearance());
            out.writeNumberField("bends", move.bends());
            WorldRequest.Walk walk = move.walk();
            if (walk != null) {
                out.writeNumberField("stepHeight", walk.stepHeight());
                out.writeNumberField("maxSlope", walk.maxSlope());
                out.writeNumberField("snap", walk.snap());
            }
        } else if (request instanceof WorldRequest.Separate free) {
            named("separate", free);
            out.writeNumberField("max", free.max());
        } else {
            named(request instanceof WorldRequest.Locate ? "pose" : "remove", request);
        }
    }

    private void named(String kind, WorldRequest request) throws IOException {
        out.writeStringField("kind", kind);
        out.writeStringField("objectName", request.objectName());
    }

    private void numbers(double x, double y, double z, double rx, double ry) throws IOException {
        out.writeNumberField("x", x);
        out.writeNumberField("y", y);
        out.writeNumberField("z", z);
        out.writeNumberField("rx", rx);
        out.writeNumberField("ry", ry);
    }

    void answer(WorldAnswer answer) throws IOException {
        if (answer instanceof WorldAnswer.Described world) {
            described(world);
        } else if (answer instanceof WorldAnswer.Identified identified) {
            answer(identified.answer());
            out.writeArrayFieldStart("obstacles");
            for (Obstacle obstacle : identified.obstacles()) {
                obstacle(obstacle);
            }
            out.writeEndArray();
        } else if (answer instanceof WorldAnswer.Slid slid) {
            slid(slid);
        } else if (answer instanceof WorldAnswer.Listed list) {
            listed(list);
        } else if (answer instanceof WorldAnswer.Located pose) {
            point("center", pose.center());
            out.writeFieldName("rotation");
            out.writeArray(pose.rotation().values(), 0, pose.rotation().size());
            out.writeNumberField("heading", pose.heading());
        } else if (answer instanceof WorldAnswer.Separated freed) {
            out.writeBooleanField("done", true);
            point("displacement", freed.displacement());
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

    private void slid(WorldAnswer.Slid slid) throws IOException {
        point("displacement", slid.displacement());
        out.writeNumberField("length", slid.length());
        point("left", slid.left());
        out.writeNumberField("turnFraction", slid.turnFraction());
        out.writeArrayFieldStart("contacts");
        for (WorldAnswer.Contact contact : slid.contacts()) {
            out.writeStartObject();
            Obstacle obstacle = contact.obstacle();
            if (obstacle != null) {
                out.writeFieldName("obstacle");
                obstacle(obstacle);
            }
            point("point", contact.point());
            point("normal", contact.normal());
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    private void listed(WorldAnswer.Listed list) throws IOException {
        out.writeArrayFieldStart("listed");
        for (ListedObject object : list.objects()) {
            out.writeStartObject();
            out.writeNumberField("index", object.index());
            if (!object.name().isEmpty()) {
                out.writeStringField("name", object.name());
            }
            out.writeStringField("kind", object.kind().word());
            point("center", object.center());
            out.writeNumberField("heading", object.heading());
            out.writeBooleanField("moveable", object.moveable());
            point("low", object.low());
            point("high", object.high());
            out.writeEndObject();
        }
        out.writeEndArray();
        if (list.next() >= 0) {
            out.writeNumberField("next", list.next());
        }
    }

    private void obstacle(Obstacle obstacle) throws IOException {
        out.writeStartObject();
        out.writeNumberField("index", obstacle.index());
        if (!obstacle.name().isEmpty()) {
            out.writeStringField("name", obstacle.name());
        }
        out.writeStringField("kind", obstacle.kind().word());
        point("center", obstacle.center());
        out.writeEndObject();
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
