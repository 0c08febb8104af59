package robosim.geometry.protocol;

import java.io.Serializable;

/** One message. */
public sealed interface Bundle extends Serializable
        permits InitBundle, MoveBundle, SonarRequestBundle, DistanceBundle, BatchRequestBundle, BatchAnswerBundle {}
