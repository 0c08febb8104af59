package robosim.geometry.protocol.json;

import java.util.List;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.PushRequest;
import robosim.geometry.protocol.motion.StopAnswer;
import robosim.geometry.protocol.motion.SurfaceMixing;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.protocol.motion.SwerveSettings;
import robosim.geometry.protocol.motion.Velocity;

/** Steps of bodies, and their answers, as JSON. */
final class JsonSteps {
    private static final double NONE = Double.POSITIVE_INFINITY;

    private static final JsonObject<Velocity> VELOCITY = JsonObject.of(Velocity.class);

    private static final JsonObject<SwerveSettings> SWERVE = JsonObject.of(SwerveSettings.class)
            .omitting(NONE, "maxSteering~")
            .form(
                    "motor",
                    JsonObject.of(SwerveSettings.Motor.class)
                            .omitting(NONE, "currentLimit")
                            .omitting(0.0, "supplyResistance"))
            .omitting(null, "motor");

    private static final JsonObject<DriveSettings> DRIVE = JsonObject.of(DriveSettings.class)
            .form("kind", JsonForm.anyCase(DriveSettings.Kind.class))
            .omitting(0.0, "base centreAhead")
            .omitting(NONE, "maxSpeed maxAcceleration maxTurn~ maxTurnAcceleration~")
            .form("swerve", SWERVE)
            .omitting(null, "swerve");

    private static final JsonObject<SurfaceSettings> SURFACE =
            JsonObject.of(SurfaceSettings.class).omitting(0.0, "restitution staticFriction slidingFriction");

    private static final JsonObject<BodyRequest> BODY = JsonObject.of(BodyRequest.class)
            .inline("surface", SURFACE)
            .omitting(0.0, "mass inertia damping turnDamping drag rolling")
            .omitting(NONE, "maxSpeed maxTurn~")
            .omitting(BodyRequest.FLOOR_FRICTION, "floorFriction")
            .form("drive", DRIVE)
            .form("velocity", VELOCITY)
            .omitting(null, "drive velocity")
            .form("ignored", JsonForm.list(JsonForm.TEXT))
            .omitting(List.of(), "ignored");

    private static final JsonObject<DriveCommand> COMMAND =
            JsonObject.of(DriveCommand.class).omitting(0.0, "forward right turn~");

    static final JsonObject<StepBundle> STEP = JsonObject.of(StepBundle.class)
            .form("bodies", JsonForm.list(BODY))
            .form("commands", JsonForm.list(COMMAND))
            .form("mixing", JsonObject.of(SurfaceMixing.class))
            .form("pushes", JsonForm.list(JsonObject.of(PushRequest.class).omitting(null, "impulse force at")))
            .omitting(List.of(), "bodies commands pushes")
            .omitting(null, "mixing");

    private static final JsonObject<BodyAnswer> PLACED = JsonObject.of(BodyAnswer.class)
            .form("rotation", JsonForm.ROTATION)
            .omitting(Numbers.NONE, "rotation")
            .form("velocity", VELOCITY);

    private static final JsonObject<ContactAnswer> CONTACT =
            JsonObject.of(ContactAnswer.class).omitting(null, "other").omitting(0.0, "fall");

    private static final JsonObject<StepBundle.Answer> ANSWER = JsonObject.of(StepBundle.Answer.class)
            .form("bodies", JsonForm.list(PLACED))
            .form("contacts", JsonForm.list(CONTACT))
            .form("stops", JsonForm.list(JsonObject.of(StopAnswer.class).omitting(null, "other")))
            .omitting(List.of(), "stops");

    static final JsonObject<Reply> BODIES = JsonObject.of(Bodies.class)
            .inline("answer", ANSWER)
            .form("refused", JsonAnswers.REFUSED)
            .as(
                    bodies -> new Reply(bodies.answer, bodies.refused),
                    reply -> new Bodies((StepBundle.Answer) reply.bundle(), reply.problems()));

    private JsonSteps() {}

    record Bodies(StepBundle.Answer answer, List<Problem> refused) {}
}
