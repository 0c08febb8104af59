package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.FreeEdgesRequest;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SceneLight;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Writes requests with packed numbers, and their answers, as JSON. */
final class JsonBatchOutput {
    private final JsonGenerator out;
    private final ObjectWriter objects;

    /** Writes an object. */
    @FunctionalInterface
    interface ObjectWriter {
        void write(GeometryObject object) throws IOException;
    }

    JsonBatchOutput(JsonGenerator out, ObjectWriter objects) {
        this.out = out;
        this.objects = objects;
    }

    void requests(List<BatchRequest> requests) throws IOException {
        out.writeArrayFieldStart("requests");
        for (BatchRequest request : requests) {
            out.writeStartObject();
            if (request instanceof SenseRequest sense) {
                out.writeStringField("kind", "sense");
                if (sense.isCarried()) {
                    out.writeStringField("objectName", sense.objectName());
                }
                sense(sense);
            } else if (request instanceof FreePosesRequest poses) {
                out.writeStringField("kind", "poses");
                out.writeStringField("objectName", poses.objectName());
                packed("poses", poses.poses());
            } else if (request instanceof PictureRequest picture) {
                out.writeStringField("kind", "picture");
                picture(picture);
            } else if (request instanceof WorldRequest about) {
                new JsonWorldOutput(out, objects).request(about);
            } else {
                FreeEdgesRequest edges = (FreeEdgesRequest) request;
                out.writeStringField("kind", "edges");
                out.writeStringField("objectName", edges.objectName());
                packed("edges", edges.edges());
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    private void mount(Mount mount) throws IOException {
        if (!mount.equals(Mount.CENTER)) {
            out.writeObjectFieldStart("mount");
            point("place", mount.place());
            if (!mount.rotation().equals(Mount.CENTER.rotation())) {
                numbers("rotation", mount.rotation());
            }
            out.writeEndObject();
        }
    }

    private void picture(PictureRequest picture) throws IOException {
        if (picture.isCarried()) {
            out.writeStringField("objectName", picture.objectName());
        }
        mount(picture.mount());
        out.writeObjectFieldStart("pattern");
        pattern(picture.camera());
        out.writeEndObject();
        if (picture.samples() != 1) {
            out.writeNumberField("samples", picture.samples());
        }
        if (picture.mirrors() != PictureRequest.USUAL_MIRRORS) {
            out.writeNumberField("mirrors", picture.mirrors());
        }
        if (picture.seesCarrier()) {
            out.writeBooleanField("seesCarrier", true);
        }
        if (picture.light() != null) {
            light(picture.light());
        }
    }

    private void light(SceneLight light) throws IOException {
        JsonMaterialOutput colors = new JsonMaterialOutput(out);
        out.writeObjectFieldStart("light");
        colors.color("zenith", light.zenith());
        colors.color("horizon", light.horizon());
        colors.color("ground", light.ground());
        out.writeNumberField("strength", light.strength());
        out.writeArrayFieldStart("sources");
        for (SceneLight.Source source : light.sources()) {
            out.writeStartObject();
            if (source instanceof SceneLight.Sun sun) {
                out.writeStringField("kind", "sun");
                point("direction", sun.direction());
            } else if (source instanceof SceneLight.Lamp lamp) {
                out.writeStringField("kind", "lamp");
                point("place", lamp.place());
            } else {
                SceneLight.Spot spot = (SceneLight.Spot) source;
                out.writeStringField("kind", "spot");
                point("place", spot.place());
                point("direction", spot.direction());
                out.writeNumberField("angle", spot.angle());
            }
            colors.color("color", source.color());
            out.writeNumberField("strength", source.strength());
            out.writeEndObject();
        }
        out.writeEndArray();
        out.writeEndObject();
    }

    private void point(String field, Point point) throws IOException {
        numbers(field, Numbers.of(point.x(), point.y(), point.z()));
    }

    private void sense(SenseRequest sense) throws IOException {
        mount(sense.mount());
        out.writeObjectFieldStart("pattern");
        pattern(sense.pattern());
        out.writeEndObject();
        out.writeNumberField("min", sense.min());
        if (sense.max() < Double.POSITIVE_INFINITY) {
            out.writeNumberField("max", sense.max());
        } else {
            out.writeNullField("max");
        }
        out.writeNumberField("width", sense.width());
        if (sense.seesCarrier()) {
            out.writeBooleanField("seesCarrier", true);
        }
        if (sense.normals()) {
            out.writeBooleanField("normals", true);
        }
        if (sense.objects()) {
            out.writeBooleanField("objects", true);
        }
        if (sense.rep117()) {
            out.writeBooleanField("rep117", true);
        }
        ScanMotion motion = sense.motion();
        if (!motion.equals(ScanMotion.NONE)) {
            out.writeObjectFieldStart("motion");
            out.writeNumberField("duration", motion.duration());
            out.writeNumberField("x", motion.x());
            out.writeNumberField("y", motion.y());
            out.writeNumberField("z", motion.z());
            out.writeNumberField("ry", motion.ry());
            out.writeEndObject();
        }
    }

    private void pattern(BeamPattern pattern) throws IOException {
        if (pattern instanceof BeamPattern.Fan fan) {
            out.writeStringField("kind", "fan");
            out.writeNumberField("first", fan.first());
            out.writeNumberField("step", fan.step());
            out.writeNumberField("count", fan.count());
        } else if (pattern instanceof BeamPattern.Layers layers) {
            out.writeStringField("kind", "layers");
            numbers("elevations", layers.elevations());
            out.writeNumberField("first", layers.first());
            out.writeNumberField("step", layers.step());
            out.writeNumberField("count", layers.count());
        } else if (pattern instanceof BeamPattern.Pinhole camera) {
            out.writeStringField("kind", "pinhole");
            out.writeNumberField("width", camera.width());
            out.writeNumberField("height", camera.height());
            out.writeNumberField("fieldOfView", camera.fieldOfView());
        } else {
            out.writeStringField("kind", "directions");
            packed("directions", ((BeamPattern.Directions) pattern).directions());
        }
    }

    void answers(List<BatchAnswer> answers, List<Problem> problems) throws IOException {
        out.writeArrayFieldStart("answers");
        int problem = 0;
        for (int k = 0; k < answers.size(); k++) {
            while (problem < problems.size() && problems.get(problem).index() < k) {
                problem++;
            }
            out.writeStartObject();
            if (answers.get(k) instanceof SenseAnswer sense) {
                packed("distances", sense.distances());
                if (sense.normals().size() > 0) {
                    packed("normals", sense.normals());
                }
                if (sense.objects().size() > 0) {
                    out.writeArrayFieldStart("names");
                    for (String name : sense.names()) {
                        out.writeString(name);
                    }
                    out.writeEndArray();
                    out.writeBinaryField("objects", PackedNumbers.bytes(sense.objects()));
                    out.writeBinaryField("labels", PackedNumbers.bytes(sense.labels()));
                }
            } else if (answers.get(k) instanceof PictureAnswer picture) {
                out.writeNumberField("width", picture.width());
                out.writeNumberField("height", picture.height());
                out.writeBinaryField("rgb", picture.rgb());
            } else if (answers.get(k) instanceof FreeAnswer free) {
                out.writeNumberField("count", free.count());
                out.writeBinaryField("free", free.free());
            } else if (answers.get(k) instanceof WorldAnswer about) {
                new JsonWorldOutput(out, objects).answer(about);
            } else {
                boolean known =
                        problem < problems.size() && problems.get(problem).index() == k;
                out.writeStringField("error", known ? problems.get(problem).reason() : "no answer");
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    private void packed(String field, Numbers numbers) throws IOException {
        out.writeBinaryField(field, PackedNumbers.bytes(numbers));
    }

    private void numbers(String field, Numbers numbers) throws IOException {
        out.writeFieldName(field);
        out.writeArray(numbers.values(), 0, numbers.size());
    }
}
