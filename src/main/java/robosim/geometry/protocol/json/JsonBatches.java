package robosim.geometry.protocol.json;

import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.material.Color;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.CopyRequest;
import robosim.geometry.protocol.batch.FreeEdgesRequest;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SceneLight;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldRequest;

/** Requests of a batch as JSON. */
final class JsonBatches {
    private static final JsonForm<Integer> COUNT = JsonForm.whole(1, RayPattern.MAX_SIZE);

    private static final int DRIVES = MeasureRequest.Question.DRIVES.given;

    private static final JsonForm<Numbers> ELEVATIONS =
            JsonForm.doubles(MessageLimits.MAX_BEAMS).as(Numbers::new, Numbers::values);

    private static final JsonKinds<BeamPattern> PATTERN = JsonKinds.tagged(
            "",
            JsonKinds.kind("fan", JsonObject.of(BeamPattern.Fan.class).form("count", COUNT)),
            JsonKinds.kind(
                    "layers",
                    JsonObject.of(BeamPattern.Layers.class)
                            .form("elevations", ELEVATIONS)
                            .form("count", COUNT)),
            JsonKinds.kind("pinhole", JsonObject.of(BeamPattern.Pinhole.class).form("width height", COUNT)),
            JsonKinds.kind(
                    "directions",
                    JsonObject.of(BeamPattern.Directions.class)
                            .form("directions", JsonForm.packed(3, MessageLimits.MAX_BEAMS))));

    private static final JsonObject<Mount> MOUNT = JsonObject.of(Facing.class)
            .form("rotation", JsonForm.ROTATION)
            .form("heading", JsonForm.HEADING)
            .omitting(null, "rotation heading~")
            .as(Facing::mount, Facing::of);

    private static final JsonObject<SenseRequest> SENSE = JsonObject.of(SenseRequest.class)
            .omitting("", "objectName")
            .form("mount", MOUNT)
            .omitting(Mount.CENTER, "mount")
            .form("pattern", PATTERN)
            .form("max", JsonForm.RANGE)
            .optional(0.0, "min width")
            .optional(Double.POSITIVE_INFINITY, "max")
            .omitting(false, "seesCarrier normals objects rep117")
            .form("motion", JsonObject.of(ScanMotion.class).optional(0.0, "x y z ry~"))
            .omitting(ScanMotion.NONE, "motion")
            .omitting(List.of(), "ignored")
            .last("motion");

    private static final JsonKinds<SenseRequest> SENSOR = JsonKinds.tagged("", JsonKinds.kind("sense", SENSE));

    private static final JsonKinds<SceneLight.Source> SOURCE = JsonKinds.tagged(
            "",
            source("sun", SceneLight.Sun.class),
            source("lamp", SceneLight.Lamp.class),
            source("spot", SceneLight.Spot.class));

    private static final JsonObject<SceneLight> LIGHT = JsonObject.of(SceneLight.class)
            .form("sources", JsonForm.list(SOURCE, SceneLight.MOST_SOURCES))
            .optional(List.of(), "sources");

    private static final JsonObject<PictureRequest> PICTURE = JsonObject.of(Picture.class)
            .omitting("", "objectName")
            .form("mount", MOUNT)
            .omitting(Mount.CENTER, "mount")
            .form("pattern", PATTERN)
            .form("samples", JsonForm.whole(1, PictureRequest.MOST_SAMPLES))
            .omitting(1, "samples")
            .form("mirrors", JsonForm.whole(0, PictureRequest.MOST_MIRRORS))
            .omitting(PictureRequest.USUAL_MIRRORS, "mirrors")
            .omitting(false, "seesCarrier")
            .form("light", LIGHT)
            .omitting(null, "light")
            .as(Picture::request, Picture::of);

    private static final String MOVE = "x y z rx~ ry~";

    private static final JsonObject<WorldRequest.GoAndSlide> SLIDE = JsonObject.of(WorldRequest.GoAndSlide.class)
            .optional(0.0, MOVE + " clearance")
            .form("bends", JsonForm.whole(0, WorldRequest.GoAndSlide.MOST_BENDS))
            .optional(WorldRequest.GoAndSlide.USUAL_BENDS, "bends")
            .inline(
                    "walk",
                    JsonObject.of(WorldRequest.Walk.class)
                            .optional(0.0, "stepHeight snap")
                            .optional(Math.PI / 2, "maxSlope~"))
            .as(JsonBatches::unlessNone, slide -> slide);

    private static final JsonObject<WorldRequest.Go> GO =
            JsonObject.of(WorldRequest.Go.class).optional(0.0, MOVE);

    private static final JsonObject<WorldRequest.Locate> LOCATE = JsonObject.of(WorldRequest.Locate.class);

    /** The requests whose answers can be proved. */
    private static final JsonKinds<BatchRequest> PROVABLE = JsonKinds.tagged(
            "", JsonKinds.kind("sense", SENSE), JsonKinds.kind("pose", LOCATE), JsonKinds.kind("move", GO));

    private static final JsonKinds<BatchRequest> REQUEST = JsonKinds.tagged(
            "",
            JsonKinds.kind("sense", SENSE),
            JsonKinds.kind(
                    "poses",
                    JsonObject.of(FreePosesRequest.class)
                            .form("poses", JsonForm.packed(FreePosesRequest.STRIDE, MessageLimits.MAX_POSES))),
            JsonKinds.kind(
                    "edges",
                    JsonObject.of(FreeEdgesRequest.class)
                            .form("edges", JsonForm.packed(FreeEdgesRequest.STRIDE, MessageLimits.MAX_POSES))),
            JsonKinds.kind(
                    "measure",
                    JsonObject.of(MeasureRequest.class)
                            .form("numbers", JsonForm.packed(1, DRIVES * MessageLimits.MAX_POSES))
                            .form("max", JsonForm.RANGE)
                            .optional(Double.POSITIVE_INFINITY, "max")
                            .optional(0.0, "margin")
                            .omitting(Numbers.NONE, "numbers")
                            .omitting(List.of(), "ignored")
                            .omitting(null, "other")),
            JsonKinds.kind("picture", PictureRequest.class, PICTURE),
            JsonKinds.kind("world", JsonObject.of(WorldRequest.Describe.class)),
            JsonKinds.kind("pose", LOCATE),
            changing("place", JsonObject.of(WorldRequest.Place.class).optional(0.0, "heading~")),
            changing(
                    "add",
                    JsonObject.of(WorldRequest.Add.class)
                            .form("object", JsonShapes.OBJECT)
                            .omitting(false, "overlapping")),
            JsonKinds.kind("remove", JsonObject.of(WorldRequest.Remove.class)),
            changing("move", GO),
            JsonKinds.kind(
                    "moveToContact",
                    JsonObject.of(WorldRequest.GoToContact.class).optional(0.0, MOVE + " clearance")),
            JsonKinds.kind(
                    "drive",
                    JsonObject.of(WorldRequest.Drive.class)
                            .optional(0.0, "x y z ry~")
                            .form("clearance", JsonForm.NUMBER)
                            .omitting(null, "clearance")),
            JsonKinds.kind("moveAndSlide", SLIDE),
            JsonKinds.kind(
                    "list",
                    JsonObject.of(WorldRequest.ListObjects.class)
                            .optional(0L, "first")
                            .form("count", JsonForm.whole(1, WorldRequest.ListObjects.MOST_LISTED))
                            .optional(WorldRequest.ListObjects.USUAL_LISTED, "count")),
            JsonKinds.kind("separate", JsonObject.of(WorldRequest.Separate.class)),
            JsonKinds.kind(
                    "attach",
                    JsonObject.of(WorldRequest.Attach.class)
                            .form("mount", MOUNT)
                            .omitting(null, "mount")),
            JsonKinds.kind("detach", JsonObject.of(WorldRequest.Detach.class)),
            JsonKinds.kind("scene", JsonObject.of(WorldRequest.DescribeScene.class)),
            JsonKinds.kind("prove", JsonObject.of(WorldRequest.Prove.class).form("request", PROVABLE)),
            JsonKinds.kind(
                    "copy",
                    JsonObject.of(CopyRequest.Make.class).form("index", JsonForm.whole(0, CopyRequest.MOST - 1))),
            JsonKinds.kind(
                    "tick",
                    JsonObject.of(CopyRequest.Tick.class)
                            .form("commands", JsonForm.packed(CopyRequest.Tick.STRIDE, CopyRequest.MOST))
                            .form("bodies", JsonForm.list(JsonForm.TEXT, CopyRequest.Tick.MOST_NAMED))
                            .form("senses", JsonForm.list(SENSOR, CopyRequest.Tick.MOST_NAMED))
                            .omitting(List.of(), "bodies senses")
                            .omitting(false, "single")));

    static final JsonObject<BatchRequestBundle> BATCH =
            JsonObject.of(BatchRequestBundle.class).form("requests", JsonForm.list(REQUEST));

    private JsonBatches() {}

    private static <S extends Record & SceneLight.Source> JsonKinds.Kind<SceneLight.Source> source(
            String word, Class<S> type) {
        return JsonKinds.kind(word, JsonObject.of(type).optional(Color.WHITE, "color"));
    }

    /** A request that may want to know which objects are in the way. */
    private static JsonKinds.Kind<BatchRequest> changing(String word, JsonObject<? extends WorldRequest> form) {
        Predicate<Object> has =
                request -> request instanceof WorldRequest of && form.type.isInstance(Change.of(of).request);
        return JsonKinds.kind(
                word,
                has,
                JsonObject.of(Change.class)
                        .inline("request", form)
                        .omitting(false, "identify")
                        .as(Change::asked, Change::of));
    }

    private static WorldRequest.GoAndSlide unlessNone(WorldRequest.GoAndSlide slide) {
        return WorldRequest.Walk.NONE.equals(slide.walk())
                ? new WorldRequest.GoAndSlide(
                        slide.objectName(),
                        slide.x(),
                        slide.y(),
                        slide.z(),
                        slide.rx(),
                        slide.ry(),
                        slide.clearance(),
                        slide.bends())
                : slide;
    }

    record Change(WorldRequest request, boolean identify) {
        static Change of(WorldRequest asked) {
            return asked instanceof WorldRequest.Identify identify
                    ? new Change(identify.request(), true)
                    : new Change(asked, false);
        }

        WorldRequest asked() {
            return identify ? new WorldRequest.Identify(request) : request;
        }
    }

    record Facing(
            Point place,
            @Nullable Numbers rotation,
            @Nullable Double heading) {
        static Facing of(Mount mount) {
            boolean isForward = mount.rotation().equals(Mount.CENTER.rotation());
            return new Facing(mount.place(), isForward ? null : mount.rotation(), null);
        }

        Mount mount() {
            if (rotation != null && heading != null) {
                throw new IllegalArgumentException("heading and rotation must not both be given (got: both)");
            }
            if (heading != null) {
                return new Mount(
                        place,
                        new Numbers(
                                Pose.of(new Point(), Degrees.toDegrees(heading)).rotation()));
            }
            return rotation == null ? new Mount(place) : new Mount(place, rotation);
        }
    }

    record Picture(
            String objectName,
            Mount mount,
            BeamPattern pattern,
            int samples,
            int mirrors,
            boolean seesCarrier,
            @Nullable SceneLight light) {
        static Picture of(PictureRequest asked) {
            return new Picture(
                    asked.objectName(),
                    asked.mount(),
                    asked.camera(),
                    asked.samples(),
                    asked.mirrors(),
                    asked.seesCarrier(),
                    asked.light());
        }

        PictureRequest request() {
            if (pattern instanceof BeamPattern.Pinhole camera) {
                return new PictureRequest(objectName, mount, camera, samples, mirrors, seesCarrier, light);
            }
            throw new IllegalArgumentException("pattern must be of kind \"pinhole\" for a picture (got: another)");
        }
    }
}
