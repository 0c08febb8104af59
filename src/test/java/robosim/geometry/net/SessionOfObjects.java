package robosim.geometry.net;

import java.util.List;
import java.util.Objects;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;

/** A session that is asked about its world, and a few objects for it. */
abstract class SessionOfObjects {
    static final WorldSettings SPATIAL = new WorldSettings(20, 6, 20, Dimension.SPATIAL, Accuracy.EXACT);
    static final GeometryObject WALL = new BoxObject(new Point(3, 0, 0), 0.2, 2, 4).named("wall");
    static final GeometryObject POST = new CylinderObject(new Point(-3, 0, 0), 0.5, 2);
    static final GeometryObject ROBOT = new CylinderObject(new Point(), 0.25, 1).moveable("robot");

    final Session session = new Session();

    Reply reply(BatchRequest... requests) {
        return Objects.requireNonNull(session.reply(new BatchRequestBundle(List.of(requests))));
    }

    List<BatchAnswer> ask(BatchRequest... requests) {
        return ((BatchAnswerBundle) reply(requests).bundle()).answers();
    }
}
