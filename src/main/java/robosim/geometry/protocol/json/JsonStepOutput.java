package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.StopAnswer;
import robosim.geometry.protocol.motion.SurfaceMixing;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.protocol.motion.Velocity;

/** Writes steps of bodies, and their answers, as JSON; what has its default is left out. */
final class JsonStepOutput {
    private static final double NONE = Double.POSITIVE_INFINITY;

    private final JsonGenerator out;

    JsonStepOutput(JsonGenerator out) {
        this.out = out;
    }

    void step(StepBundle step) throws IOException {
        out.writeNumberField("seconds", step.seconds());
        if (!step.bodies().isEmpty()) {
            out.writeArrayFieldStart("bodies");
            for (BodyRequest body : step.bodies()) {
                body(body);
            }
            out.writeEndArray();
        }
        if (!step.commands().isEmpty()) {
            out.writeArrayFieldStart("commands");
            for (DriveCommand command : step.commands()) {
                out.writeStartObject();
                out.writeStringField("objectName", command.objectName());
                unless(0, "forward", command.forward());
                unless(0, "right", command.right());
                unless(0, "turn", command.turn());
                out.writeEndObject();
            }
            out.writeEndArray();
        }
        SurfaceMixing mixing = step.mixing();
        if (mixing != null) {
            mixing(mixing);
        }
    }

    private void mixing(SurfaceMixing mixing) throws IOException {
        out.writeObjectFieldStart("mixing");
        out.writeStringField("restitution", mixing.restitution().name());
        out.writeStringField("friction", mixing.friction().name());
        out.writeEndObject();
    }

    private void body(BodyRequest body) throws IOException {
        out.writeStartObject();
        out.writeStringField("objectName", body.objectName());
        unless(0, "mass", body.mass());
        unless(0, "inertia", body.inertia());
        SurfaceSettings surface = body.surface();
        unless(0, "restitution", surface.restitution());
        unless(0, "staticFriction", surface.staticFriction());
        unless(0, "slidingFriction", surface.slidingFriction());
        unless(0, "damping", body.damping());
        unless(0, "turnDamping", body.turnDamping());
        unless(NONE, "maxSpeed", body.maxSpeed());
        unless(NONE, "maxTurn", body.maxTurn());
        unless(BodyRequest.FLOOR_FRICTION, "floorFriction", body.floorFriction());
        DriveSettings drive = body.drive();
        if (drive != null) {
            out.writeObjectFieldStart("drive");
            out.writeStringField("kind", drive.kind().name());
            unless(0, "base", drive.base());
            unless(NONE, "maxSpeed", drive.maxSpeed());
            unless(NONE, "maxAcceleration", drive.maxAcceleration());
            unless(NONE, "maxTurn", drive.maxTurn());
            unless(NONE, "maxTurnAcceleration", drive.maxTurnAcceleration());
            unless(0, "centreAhead", drive.centreAhead());
            out.writeEndObject();
        }
        Velocity velocity = body.velocity();
        if (velocity != null) {
            velocity(velocity);
        }
        out.writeEndObject();
    }

    void answer(StepBundle.Answer answer) throws IOException {
        out.writeArrayFieldStart("bodies");
        for (BodyAnswer body : answer.bodies()) {
            out.writeStartObject();
            out.writeStringField("objectName", body.objectName());
            point("center", body.center());
            out.writeNumberField("heading", body.heading());
            if (body.rotation().size() > 0) {
                out.writeFieldName("rotation");
                out.writeArray(body.rotation().values(), 0, body.rotation().size());
            }
            velocity(body.velocity());
            out.writeEndObject();
        }
        out.writeEndArray();
        out.writeArrayFieldStart("contacts");
        for (ContactAnswer contact : answer.contacts()) {
            contact(contact);
        }
        out.writeEndArray();
        out.writeArrayFieldStart("stopped");
        for (String name : answer.stopped()) {
            out.writeString(name);
        }
        out.writeEndArray();
        if (!answer.stops().isEmpty()) {
            stops(answer.stops());
        }
    }

    private void stops(List<StopAnswer> stops) throws IOException {
        out.writeArrayFieldStart("stops");
        for (StopAnswer stop : stops) {
            out.writeStartObject();
            out.writeStringField("objectName", stop.objectName());
            out.writeStringField("reason", stop.reason().name());
            @Nullable String other = stop.other();
            if (other != null) {
                out.writeStringField("other", other);
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    private void contact(ContactAnswer contact) throws IOException {
        out.writeStartObject();
        out.writeStringField("objectName", contact.objectName());
        @Nullable String other = contact.other();
        if (other != null) {
            out.writeStringField("other", other);
        }
        point("point", contact.point());
        point("normal", contact.normal());
        out.writeNumberField("impulse", contact.impulse());
        out.writeStringField("phase", contact.phase().name());
        unless(0, "fall", contact.fall());
        out.writeEndObject();
    }

    private void velocity(Velocity velocity) throws IOException {
        out.writeObjectFieldStart("velocity");
        out.writeNumberField("x", velocity.x());
        out.writeNumberField("y", velocity.y());
        out.writeNumberField("z", velocity.z());
        out.writeNumberField("ry", velocity.ry());
        out.writeEndObject();
    }

    private void point(String field, Point point) throws IOException {
        out.writeFieldName(field);
        out.writeArray(new double[] {point.x(), point.y(), point.z()}, 0, 3);
    }

    private void unless(double left, String field, double value) throws IOException {
        if (value != left) {
            out.writeNumberField(field, value);
        }
    }
}
