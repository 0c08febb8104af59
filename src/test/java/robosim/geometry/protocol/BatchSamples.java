package robosim.geometry.protocol;

import java.util.List;
import java.util.Set;
import robosim.geometry.material.Color;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
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
import robosim.geometry.protocol.motion.SurfaceMixing;

/** Requests with packed numbers, and answers. The stored bytes hold these: do not change them, add. */
public final class BatchSamples {
    private static final double INFINITY = Double.POSITIVE_INFINITY;

    private BatchSamples() {}

    /** One request of each kind, with each kind of pattern, with every optional part given and left out. */
    public static BatchRequestBundle requests() {
        Mount mount = new Mount(new Point(0.1, 0.5, -0.0), Numbers.of(0, 0, 1, 0, 1, 0, -1, 0, 0));
        return new BatchRequestBundle(List.of(
                new SenseRequest("robot", new BeamPattern.Fan(-2.356194490192345, 0.004363323129985824, 1081)),
                new SenseRequest(
                        "robot",
                        mount,
                        new BeamPattern.Layers(Numbers.of(-Math.PI / 2, 0.1, Math.PI / 2), Math.PI, -0.1, 7),
                        0.5,
                        30,
                        0,
                        true,
                        true,
                        false,
                        ScanMotion.NONE,
                        false,
                        List.of()),
                new SenseRequest(
                        "\u00e9\ud83e\udd16",
                        new Mount(new Point(0, 1, 0)),
                        new BeamPattern.Pinhole(4, 3, 1.5),
                        0,
                        INFINITY,
                        Math.nextDown(Math.PI),
                        false,
                        false,
                        false,
                        ScanMotion.NONE,
                        false,
                        List.of()),
                new SenseRequest("", new BeamPattern.Directions(Numbers.of(1, -0.0, 0, 0x1p100, 1e-300, -2))),
                new FreePosesRequest("robot", Numbers.of(1, 2, 3, Math.PI / 2, -0.0, 0, 1e-320, -7)),
                new FreePosesRequest("robot", Numbers.NONE),
                new FreeEdgesRequest("robot", Numbers.of(1, 2, 3, 0, 1, 2, 4, Math.PI))));
    }

    /** One answer of each kind. */
    public static BatchAnswerBundle answers() {
        return new BatchAnswerBundle(List.of(
                new SenseAnswer(Numbers.of(0, 0x1.23456789abcdep-3, INFINITY), Numbers.NONE),
                new SenseAnswer(Numbers.of(2, INFINITY), Numbers.of(-1, 0, -0.0, 0, 0, 0)),
                new SenseAnswer(Numbers.NONE, Numbers.NONE),
                new FreeAnswer(11, new byte[] {(byte) 0x81, 0x05}),
                new FreeAnswer(0, new byte[0]),
                new NoAnswer()));
    }

    /** What came after the stored bytes: frames with objects, and from a robot that moves. */
    public static List<Bundle> frames() {
        return List.of(
                new BatchRequestBundle(List.of(new SenseRequest(
                        "robot",
                        Mount.CENTER,
                        new BeamPattern.Pinhole(2, 1, 1.5),
                        0,
                        INFINITY,
                        0,
                        false,
                        false,
                        true,
                        new ScanMotion(0.1, -1, 0.5, 1e-300, -7),
                        false,
                        List.of()))),
                new BatchAnswerBundle(List.of(
                        new SenseAnswer(
                                Numbers.of(3, INFINITY, 1),
                                Numbers.NONE,
                                List.of("", "wall \u00e9"),
                                Integers.of(1, -1, 0),
                                Integers.of(Integer.MAX_VALUE, 0, 7)),
                        new SenseAnswer(
                                Numbers.of(2), Numbers.of(0, 1, 0), List.of("a"), Integers.of(0), Integers.of(0)))));
    }

    /** What came after those: pictures, with every optional part given and left out. */
    public static List<Bundle> pictures() {
        Mount mount = new Mount(new Point(0.1, 0.5, -0.0), Numbers.of(0, 0, 1, 0, 1, 0, -1, 0, 0));
        BeamPattern.Pinhole camera = new BeamPattern.Pinhole(2, 1, 1.5);
        Color red = Color.parse("#ff0000");
        Color fine = new Color(0.1, 0.2, 1e-300);
        SceneLight light = new SceneLight(
                Color.WHITE,
                fine,
                Color.BLACK,
                0.5,
                List.of(
                        new SceneLight.Sun(new Point(0, -1, 0), red, 1),
                        new SceneLight.Lamp(new Point(1, 2, 3), Color.WHITE, 0),
                        new SceneLight.Spot(new Point(), new Point(1e-9, 0, 0), 0.7, fine, 0x1p100)));
        SceneLight dark = new SceneLight(Color.BLACK, Color.BLACK, Color.BLACK, 0, List.of());
        return List.of(
                new BatchRequestBundle(List.of(
                        new PictureRequest("robot", Mount.CENTER, camera),
                        new PictureRequest("", mount, camera, 16, 0, false, light),
                        new PictureRequest("\u00e9", mount, camera, 2, 16, true, dark))),
                new BatchAnswerBundle(List.of(
                        new PictureAnswer(2, 1, new byte[] {0, 1, 2, -1, -128, 127}),
                        PictureAnswer.of(1, 1, new int[] {0xff8001}))));
    }

    /** What is measured at places and on motions, and the numbers. */
    public static List<Bundle> measures() {
        return List.of(
                new BatchRequestBundle(List.of(
                        new MeasureRequest(
                                "robot",
                                MeasureRequest.Question.DRIVES,
                                Numbers.of(1, 2, 3, -7, 1e-300, -0.0, 4, 0.5, 9),
                                INFINITY,
                                0.25,
                                List.of("floor", "\u00e9")),
                        new MeasureRequest(
                                "", MeasureRequest.Question.CLEARANCES, Numbers.of(0, 0, 0, 0), 3, 0, List.of()),
                        new MeasureRequest("a", MeasureRequest.Question.DISTANCES, Numbers.NONE, 0, 0x1p100, List.of()),
                        new MeasureRequest(
                                "a", MeasureRequest.Question.EDGES, Numbers.of(new double[8]), 1, 0, List.of("b")))),
                new BatchAnswerBundle(List.of(
                        new MeasureRequest.Answer(Numbers.of(-0.5, INFINITY)),
                        new MeasureRequest.Answer(Numbers.NONE))));
    }

    /** Motions that turn while they translate, and what sensors ignore. */
    public static List<Bundle> drives() {
        WorldAnswer.Went went = new WorldAnswer.Went(false, 0.5, 0.5, "", new Point(1, 2, 3), new Point(-1, 0, 0));
        return List.of(
                new BatchRequestBundle(List.of(
                        new WorldRequest.Drive("robot", 1, -0.0, 2, -0.5, 3, null),
                        new WorldRequest.Drive("\u00e9", 1, 0, 0x1p100, Math.PI, 1e-300, 0.25),
                        new SenseRequest("robot", new BeamPattern.Fan(0, 1, 4))
                                .ignoring(List.of("glass", "b \u00e9")))),
                new BatchAnswerBundle(List.of(
                        new WorldAnswer.Identified(WorldAnswer.Went.MADE, List.of()),
                        new WorldAnswer.Identified(
                                went, List.of(new Obstacle(2, "", GeometryObject.Kind.BOX, new Point(1, 0, 0)))))),
                new InitBundle(List.of(
                        new BoxObject(new Point(1, 2, 3), 1, 1, 1).withLayers(Set.of("glass", "\u00e9")),
                        new SphereObject(new Point(4, 0, 0), 1)
                                .moveable("robot")
                                .withLayers(Set.of("robots")))));
    }

    /** Requests about the world's objects, and answers to them; what came after the frames. */
    public static List<Bundle> world() {
        return List.of(
                new BatchRequestBundle(List.of(
                        new WorldRequest.Describe(),
                        new WorldRequest.Locate("wall \u00e9"),
                        new WorldRequest.Place("robot", new Point(1, -0.5, 1e-300), -7),
                        new WorldRequest.Add(new SphereObject(new Point(3, 0, 0), 0.5).named("ball"), true),
                        new WorldRequest.Add(
                                new ObjectGroup(List.of(new BoxObject(new Point(), 1, 2, 3))).turned(0, 30), false),
                        new WorldRequest.Remove(""),
                        new WorldRequest.Go("robot", 1, -0.0, 0x1p100, 1e-320, Math.PI / 2))),
                new BatchAnswerBundle(List.of(
                        new WorldAnswer.Described(
                                3,
                                List.of(
                                        new WorldAnswer.LeftOut(1, "wall", "an earlier object has its name"),
                                        new WorldAnswer.LeftOut(4, "", "it would leave the world")),
                                10,
                                5,
                                0x1p101,
                                Dimension.SPATIAL,
                                Accuracy.DOP),
                        new WorldAnswer.Located(
                                new Point(1, 2, -3), Numbers.of(0, 0, 1, 0, 1, 0, -1, 0, 0), Math.PI / 2),
                        new WorldAnswer.Changed(true, null),
                        new WorldAnswer.Changed(false, null),
                        new WorldAnswer.Changed(false, "wall"),
                        WorldAnswer.Went.MADE,
                        new WorldAnswer.Went(false, 0.25, 0, "", new Point(1, 2, 3), new Point(-1, 0, 0)),
                        new WorldAnswer.Went(false, 1, 0.5, null, new Point(1, 2, 3), new Point(0, 0, 1)))),
                new InitBundle(List.of(), WorldSettings.NONE.withDimension(Dimension.SPATIAL)),
                new InitBundle(List.of(), new WorldSettings(0, 4, 0, null, Accuracy.OBB)),
                new InitBundle(List.of(), WorldSettings.NONE));
    }

    /** What came after those: answers that tell objects without a name, moves to a contact and along it, fixed sensors. */
    public static List<Bundle> obstacles() {
        Obstacle nameless = new Obstacle(4, "", GeometryObject.Kind.BOX, new Point(0, 0, -3));
        Obstacle named = new Obstacle((1L << 53) - 1, "wall \u00e9", GeometryObject.Kind.GRID, new Point(1e-300, 2, 3));
        Point contact = new Point(1, 2, 3);
        Point normal = new Point(-1, 0, 0);
        return List.of(
                new BatchRequestBundle(List.of(
                        new WorldRequest.Identify(new WorldRequest.Place("robot", new Point(1, -0.5, 0), 2)),
                        new WorldRequest.Identify(
                                new WorldRequest.Add(new SphereObject(new Point(3, 0, 0), 0.5).named("ball"), true)),
                        new WorldRequest.Identify(
                                new WorldRequest.Add(new BoxObject(new Point(3, 0, 0), 1, 2, 3), false)),
                        new WorldRequest.Identify(new WorldRequest.Go("robot", 1, -0.0, 0x1p100, 1e-320, Math.PI / 2)),
                        new WorldRequest.GoToContact("robot", 1, 0, -2, 0, Math.PI, 0.01),
                        new WorldRequest.GoToContact("", -0.0, 0x1p100, 0, -7, 0, 0),
                        new WorldRequest.GoAndSlide("robot", 3, 0, 4, 0.5, 0, 1e-300, 64),
                        new WorldRequest.GoAndSlide("\u00e9", 0, 0, 0, 0, 0, 0, 0),
                        new SenseRequest(
                                "",
                                new Mount(new Point(5, 2, 0), Numbers.of(0, 0, 1, 0, 1, 0, -1, 0, 0)),
                                new BeamPattern.Fan(0, 1, 4),
                                0.5,
                                30,
                                0,
                                false,
                                true,
                                true,
                                new ScanMotion(0.1, 1, 0, 0, 2),
                                false,
                                List.of()))),
                new BatchAnswerBundle(List.of(
                        new WorldAnswer.Identified(new WorldAnswer.Changed(true, null), List.of()),
                        new WorldAnswer.Identified(new WorldAnswer.Changed(false, null), List.of()),
                        new WorldAnswer.Identified(new WorldAnswer.Changed(false, ""), List.of(nameless, named)),
                        new WorldAnswer.Identified(WorldAnswer.Went.MADE, List.of()),
                        new WorldAnswer.Identified(
                                new WorldAnswer.Went(false, 0.25, 0, "wall \u00e9", contact, normal), List.of(named)),
                        new WorldAnswer.Identified(
                                new WorldAnswer.Went(false, 1, 0.5, null, contact, normal), List.of()),
                        new WorldAnswer.Slid(new Point(1, 0, -2), 3.5, new Point(0, 0, 0x1p100), 0, List.of()),
                        new WorldAnswer.Slid(
                                new Point(),
                                0,
                                new Point(),
                                1,
                                List.of(
                                        new WorldAnswer.Contact(nameless, contact, normal),
                                        new WorldAnswer.Contact(null, contact, normal),
                                        new WorldAnswer.Contact(named, new Point(), new Point(0, 0, 1)))))));
    }

    /** How an object walks. */
    public static Bundle walks() {
        return new BatchRequestBundle(
                List.of(new WorldRequest.GoAndSlide("r", 1, 0, 0, 0, 0, 0, 4, new WorldRequest.Walk(0.25, 0.5, 1))));
    }

    /** What is attached and detached. */
    public static Bundle attachments() {
        return new BatchRequestBundle(List.of(
                new WorldRequest.Attach("b", "r", null),
                new WorldRequest.Attach("b", "r", new Mount(new Point(1, 0.5, -2))),
                new WorldRequest.Detach("b")));
    }

    /** Requests of proofs and of what they are about, and their answers. */
    public static List<Bundle> proofs() {
        return List.of(
                new BatchRequestBundle(List.of(
                        new WorldRequest.DescribeScene(),
                        new WorldRequest.Prove(new WorldRequest.Locate("wall")),
                        new WorldRequest.Prove(new WorldRequest.Go("r", 1, 0, 0, 0, -0.5)),
                        new WorldRequest.Prove(new SenseRequest("r", new BeamPattern.Fan(0, 1, 3))))),
                new BatchAnswerBundle(List.of(
                        new WorldAnswer.SceneText(List.of("{\"objects\":[", "]}")),
                        new WorldAnswer.Proved(List.of(
                                new WorldAnswer.Evidence(List.of("{\"claim\":", "{}}"), ""),
                                new WorldAnswer.Evidence(List.of(), "a turn of half a circle"))),
                        new WorldAnswer.Proved(List.of()))));
    }

    /** Distances out of range, freed objects and rules for surfaces. */
    public static List<Bundle> rules() {
        SenseRequest fan = new SenseRequest("r", new BeamPattern.Fan(0, 1, 3));
        return List.of(
                new BatchRequestBundle(List.of(fan.asRep117(), new WorldRequest.Separate("r", 0.5))),
                new BatchAnswerBundle(List.of(
                        new SenseAnswer(Numbers.of(SenseAnswer.NEARER, 1, 1.0 / 0), Numbers.NONE),
                        new WorldAnswer.Separated(new Point(0.25, 0, -1)),
                        new WorldAnswer.Changed(false, null))),
                new StepBundle(
                        0.5,
                        List.of(),
                        List.of(),
                        new SurfaceMixing(SurfaceMixing.Rule.LARGER, SurfaceMixing.Rule.PRODUCT),
                        List.of()));
    }

    /** What came after those: what is in the world. */
    public static List<Bundle> listed() {
        Point low = new Point(-1, -2, -3);
        Point high = new Point(1, 2, 0x1p100);
        ListedObject first =
                new ListedObject(0, "", GeometryObject.Kind.MESH, new Point(), -Math.PI / 2, false, low, high);
        ListedObject last =
                new ListedObject((1L << 53) - 2, "wall \u00e9", GeometryObject.Kind.BOX, low, Math.PI, true, low, low);
        return List.of(
                new BatchRequestBundle(List.of(
                        new WorldRequest.ListObjects(0, 1), new WorldRequest.ListObjects((1L << 53) - 1, 1 << 16))),
                new BatchAnswerBundle(List.of(
                        new WorldAnswer.Listed(List.of(), -1),
                        new WorldAnswer.Listed(List.of(first, last), -1),
                        new WorldAnswer.Listed(List.of(first, last), (1L << 53) - 1))));
    }

    /** What came after those: copies of the world. */
    public static List<Bundle> copies() {
        SenseRequest laser = new SenseRequest("robot", new BeamPattern.Fan(-1, 1, 3));
        return List.of(
                new BatchRequestBundle(List.of(
                        new CopyRequest.Make(0),
                        new CopyRequest.Make(CopyRequest.MOST - 1),
                        new CopyRequest.Tick(
                                "robot", Numbers.of(0.1, 1, -0.0, Math.PI), List.of("robot"), List.of(laser), false),
                        new CopyRequest.Tick("robot", Numbers.of(3600, 1, 2, 3), List.of(), List.of(laser), true),
                        new CopyRequest.Tick("robot", Numbers.NONE, List.of(), List.of(), false))),
                new BatchAnswerBundle(List.of(
                        new TickAnswer(
                                Numbers.of(1, 2, 3, -0.0, 5, 6, 7, 8),
                                new Integers(new int[] {2}),
                                Numbers.of(1, 0.1, INFINITY),
                                Integers.NONE),
                        new TickAnswer(Numbers.NONE, Integers.NONE, Numbers.NONE, new Integers(new int[] {
                            Float.floatToIntBits(0.1f)
                        })),
                        new TickAnswer(Numbers.NONE, Integers.NONE, Numbers.NONE, Integers.NONE))));
    }

    /** The bundles. */
    public static List<Bundle> everyBundle() {
        return List.of(new BatchRequestBundle(List.of()), requests(), new BatchAnswerBundle(List.of()), answers());
    }
}
