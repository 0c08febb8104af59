package robosim.geometry.scenario;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.WorldRequest;

/** Estimates the memory of a step in units of some 60 bytes, the most that one object, move or distance takes. */
final class StepWeight {
    /** The number of characters of a name that take one unit. */
    private static final int CHARACTERS = 32;

    /** The bytes of a batch, and the cells of a grid, that take one unit. */
    private static final int UNIT_BYTES = 60;

    private StepWeight() {}

    /**
     * One unit, plus those of its contents: objects with their members, vertices, triangles and cells, moves, distances,
     * names, reasons.
     */
    static long of(Step step) {
        long weight = 1;
        for (String note : step.notes()) {
            weight += text(note);
        }
        if (step.request() instanceof InitBundle init) {
            weight += of(init.objects());
        } else if (step.request() instanceof MoveBundle moves) {
            for (MoveRequest move : moves.moves()) {
                weight += 1 + text(move.objectName());
            }
        } else if (step.request() instanceof SonarRequestBundle sonars) {
            for (SonarRequest sonar : sonars.requests()) {
                weight += 1 + text(sonar.objectName());
            }
        } else if (step.request() instanceof BatchRequestBundle batch) {
            for (BatchRequest request : batch.requests()) {
                weight += 1 + text(request.objectName());
                GeometryObject addition = request instanceof WorldRequest about ? about.addition() : null;
                weight += addition == null ? 0 : of(List.of(addition));
            }
            weight += batch.workBytes() / UNIT_BYTES;
        } else if (step.request() instanceof StepBundle bodies) {
            weight += weight(bodies, step.expected());
        }
        return step.expected() == null
                ? weight
                : weight + step.expected().problems().size();
    }

    private static long weight(StepBundle step, @Nullable Reply expected) {
        // A body or an answer about one has numbers of some 240 bytes, a contact of some 120.
        long weight = 4L * step.size();
        return expected != null && expected.bundle() instanceof StepBundle.Answer answer
                ? weight + 4L * answer.bodies().size() + 2L * answer.contacts().size()
                : weight;
    }

    /** Without recursion: members may have members to any depth, and this runs on the session's thread. */
    private static long of(List<GeometryObject> objects) {
        Deque<GeometryObject> left = new ArrayDeque<>(objects);
        long weight = 0;
        while (!left.isEmpty()) {
            GeometryObject object = left.pop();
            String name = object.name();
            weight += 1 + (name == null ? 0 : text(name));
            GeometryObject around = null;
            if (object instanceof ObjectGroup group) {
                group.members().forEach(left::push);
                around = group.boundingVolume();
            } else if (object instanceof MeshObject mesh) {
                weight += (long) mesh.triangles().vertices() + mesh.triangles().size();
                around = mesh.boundingVolume();
            } else if (object instanceof GridObject grid) {
                weight += (long) grid.columns() * grid.rows() / UNIT_BYTES;
            }
            if (around != null) {
                left.push(around);
            }
        }
        return weight;
    }

    private static int text(String text) {
        return text.length() / CHARACTERS;
    }
}
