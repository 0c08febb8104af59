package robosim.geometry.protocol;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.PlacedObject;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.CopyRequest;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.FreeEdgesRequest;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.Integers;
import robosim.geometry.protocol.batch.ListedObject;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.Obstacle;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SceneLight;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.TickAnswer;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;
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

/** The allow-list of a message's classes: those that a stream may name, and those that replace them when it is read. */
final class AllowedClasses {
    /**
     * The serialized form of {@link List#of} and the like; package-private in the JDK, but named in its documentation.
     */
    private static final Class<?> LIST_FORM = listForm();

    private static final Set<Class<?>> BUNDLES = Set.of(
            InitBundle.class,
            InitBundle.Answered.class,
            WorldSettings.class,
            MoveBundle.class,
            MoveRequest.class,
            SonarRequestBundle.class,
            SonarRequest.class,
            Beam.class,
            DistanceBundle.class);

    /** {@code Number} and {@code Enum} are described in the stream along with their subclasses. */
    private static final Set<Class<?>> VALUES = Set.of(
            Double.class,
            Number.class,
            Enum.class,
            double[].class,
            int[].class,
            int[][].class,
            byte[].class,
            LIST_FORM);

    /** Requests with packed numbers, and their answers. */
    private static final Set<Class<?>> BATCHES = Set.of(
            BatchRequestBundle.class,
            SenseRequest.class,
            Mount.class,
            BeamPattern.Fan.class,
            BeamPattern.Layers.class,
            BeamPattern.Pinhole.class,
            BeamPattern.Directions.class,
            Numbers.class,
            Integers.class,
            ScanMotion.class,
            FreePosesRequest.class,
            PictureRequest.class,
            PictureAnswer.class,
            SceneLight.class,
            SceneLight.Sun.class,
            SceneLight.Lamp.class,
            SceneLight.Spot.class,
            FreeEdgesRequest.class,
            MeasureRequest.class,
            MeasureRequest.Question.class,
            MeasureRequest.Answer.class,
            BatchAnswerBundle.class,
            SenseAnswer.class,
            FreeAnswer.class,
            CopyRequest.Make.class,
            CopyRequest.Tick.class,
            TickAnswer.class,
            NoAnswer.class,
            WorldRequest.Describe.class,
            WorldRequest.ListObjects.class,
            WorldRequest.Locate.class,
            WorldRequest.Place.class,
            WorldRequest.Add.class,
            WorldRequest.Remove.class,
            WorldRequest.Attach.class,
            WorldRequest.Detach.class,
            WorldRequest.Go.class,
            WorldRequest.GoToContact.class,
            WorldRequest.Drive.class,
            WorldRequest.GoAndSlide.class,
            WorldRequest.Walk.class,
            WorldRequest.Separate.class,
            WorldAnswer.Separated.class,
            WorldRequest.Identify.class,
            WorldRequest.DescribeScene.class,
            WorldRequest.Prove.class,
            WorldAnswer.SceneText.class,
            WorldAnswer.Evidence.class,
            WorldAnswer.Proved.class,
            WorldAnswer.LeftOut.class,
            WorldAnswer.Described.class,
            WorldAnswer.Listed.class,
            WorldAnswer.Located.class,
            WorldAnswer.Changed.class,
            WorldAnswer.Went.class,
            WorldAnswer.Identified.class,
            WorldAnswer.Slid.class,
            WorldAnswer.Contact.class,
            Obstacle.class,
            ListedObject.class,
            GeometryObject.Kind.class,
            int[].class,
            byte[].class);

    /** Steps of bodies, and their answers. */
    private static final Set<Class<?>> STEPS = Set.of(
            StepBundle.class,
            StepBundle.Answer.class,
            BodyRequest.class,
            SurfaceSettings.class,
            DriveSettings.class,
            DriveSettings.Kind.class,
            DriveCommand.class,
            BodyAnswer.class,
            Velocity.class,
            ContactAnswer.class,
            ContactAnswer.Phase.class,
            PushRequest.class,
            SwerveSettings.class,
            SwerveSettings.Motor.class,
            StopAnswer.class,
            StopAnswer.Reason.class,
            SurfaceMixing.class,
            SurfaceMixing.Rule.class);

    private static final Set<Class<?>> MADE = Set.of(
            BoxObject.class,
            CylinderObject.class,
            SphereObject.class,
            CapsuleObject.class,
            MeshObject.class,
            ObjectGroup.class,
            GridObject.class,
            Material.class,
            ImageTexture.class,
            Object[].class,
            String.class,
            List.of().getClass(),
            List.of(0).getClass());

    private final Map<String, Class<?>> named = new HashMap<>();
    private final Set<Class<?>> all = new HashSet<>(MADE);

    AllowedClasses(Set<Class<?>> translated) {
        for (Set<Class<?>> some : List.of(
                BUNDLES, VALUES, BATCHES, STEPS, PlacedObject.serialClasses(), Material.serialClasses(), translated)) {
            for (Class<?> type : some) {
                named.put(type.getName(), type);
            }
            all.addAll(some);
        }
    }

    /** The class of that exact name, or null. */
    @Nullable
    Class<?> byName(String name) {
        return named.get(name);
    }

    boolean holds(Class<?> type) {
        return all.contains(type);
    }

    private static Class<?> listForm() {
        try {
            return Class.forName("java.util.CollSer");
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException("this Java has no java.util.CollSer, the serialized form of its lists", e);
        }
    }
}
