package robosim.geometry.bench;

import java.io.IOException;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.IntToDoubleFunction;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.bench.Workload.Answer;
import robosim.geometry.bench.Workload.Structure;
import robosim.geometry.bench.Workload.Task;
import robosim.geometry.bench.Workload.Title;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Ray;

/** What {@link Peers} asks of the module, at EXACT and through what every user calls. */
final class PeerWorkloads {
    /** By number of objects: hits and sum of distances of W1a, then hits of W1b, as the inputs' notes give them. */
    private static final Map<Integer, double[]> FLAT = Map.of(
            100, new double[] {143820, 2114168.307223301, 29593},
            1000, new double[] {179101, 3484668.247231327, 31412},
            10_000, new double[] {190355, 3985802.876468010, 31259},
            100_000, new double[] {194324, 4109458.424287017, 31026},
            1_000_000, new double[] {195729, 4173422.037896298, 31521});

    private static final Map<String, Answer> MESHES = Map.of(
            "knot4k", new Answer(105214, 376831.713125666),
            "knot64k", new Answer(105884, 378845.170989482),
            "knot1m", new Answer(105930, 378978.568047521));

    /** By number of solids: hits and sum of distances of W5, then of W6. */
    private static final Map<Integer, double[]> SPACE = Map.of(
            100, new double[] {27217, 357772.510092, 60445, 756054.541673},
            1000, new double[] {53711, 1444501.445223, 99027, 2393453.156970},
            10_000, new double[] {76336, 2775946.877157, 162549, 6787056.853523},
            100_000, new double[] {90910, 3639980.524058, 159262, 7200407.463268});

    private static final Answer PAIRS = new Answer(1342, 1342);

    private final PeerInputs inputs;
    private final List<String> works;
    private final List<String> sizes;
    private final List<Workload> all = new ArrayList<>();

    private PeerWorkloads(PeerInputs inputs, List<String> works, List<String> sizes) {
        this.inputs = inputs;
        this.works = works;
        this.sizes = sizes;
    }

    /** The workloads of these names and sizes; all sizes where none is named. */
    static List<Workload> of(PeerInputs inputs, List<String> works, List<String> sizes) throws IOException {
        PeerWorkloads workloads = new PeerWorkloads(inputs, works, sizes);
        for (int size : new int[] {100, 1000, 10_000, 100_000, 1_000_000}) {
            workloads.addFlat(size);
        }
        for (int size : new int[] {100, 1000, 10_000, 100_000}) {
            workloads.addSpace(size);
        }
        if (works.contains("W2") && workloads.wants("knot4k")) {
            workloads.addPairs();
        }
        for (String mesh : new String[] {"knot4k", "knot64k", "knot1m"}) {
            if (works.contains("W3") && workloads.wants(mesh)) {
                workloads.addMesh(mesh);
            }
        }
        if (works.contains("W4")) {
            for (int robots : new int[] {100, 1000, 10_000}) {
                if (workloads.wants(String.valueOf(robots))) {
                    Swarm.addTo(workloads.all, robots);
                }
            }
        }
        return workloads.all;
    }

    private boolean wants(String size) {
        return sizes.contains("") || sizes.contains(size);
    }

    private void addFlat(int size) throws IOException {
        String name = String.valueOf(size);
        if (!wants(name) || works.stream().noneMatch(work -> work.startsWith("W1"))) {
            return;
        }
        PeerInputs.Scene scene = inputs.scene(size);
        double world = 2 * scene.side() + 40;
        long start = System.nanoTime();
        Geometry geometry = new Geometry(world, 10, world, Dimension.PLANAR, Accuracy.EXACT);
        scene.objects().forEach(geometry::addObjectUnchecked);
        geometry.getRayDistance(scene.rays()[0], 0, 1, 0);
        double build = (System.nanoTime() - start) * 1e-6;
        double[] given = inputs.truth(size);
        double[] truth = given == null ? FLAT.getOrDefault(size, new double[3]) : given;
        if (works.contains("W1a")) {
            add(
                    "W1a",
                    name,
                    scene.rays().length,
                    build,
                    new Answer((long) truth[0], truth[1]),
                    () -> rays(geometry, scene),
                    new Structure(
                            geometry,
                            size,
                            scene.rays().length,
                            k -> geometry.getRayDistance(scene.rays()[k], 0, scene.ranges()[k], 0)));
        }
        if (works.contains("W1b")) {
            Answer probes = new Answer((long) truth[2], truth[2]);
            add(
                    "W1b",
                    name,
                    scene.probes().length,
                    build,
                    probes,
                    () -> probes(geometry, scene.probes()),
                    new Structure(
                            geometry,
                            size,
                            scene.probes().length,
                            k -> geometry.testObject(scene.probes()[k]) ? 1 : 0));
        }
        if (works.contains("W1c") && size <= 10_000) {
            Additions.addTo(all, name, scene.objects(), world);
        }
    }

    private void add(
            String work,
            String size,
            long queries,
            double build,
            Answer truth,
            Supplier<Answer> task,
            @Nullable Structure structure) {
        all.add(new Workload(
                new Title(Workload.MODULE, work, size),
                queries,
                build,
                new Task<>(() -> 0, none -> task.get()),
                truth,
                structure));
    }

    private void addSpace(int size) throws IOException {
        String name = String.valueOf(size);
        if (!wants(name) || !(works.contains("W5") || works.contains("W6"))) {
            return;
        }
        PeerInputs.Space space = inputs.space(size);
        double world = 2 * space.side() + 40;
        long start = System.nanoTime();
        Geometry geometry = new Geometry(world, world, world, Dimension.SPATIAL, Accuracy.EXACT);
        space.objects().forEach(geometry::addObjectUnchecked);
        geometry.getRayDistance(space.rays()[0], 0, 1, 0);
        double build = (System.nanoTime() - start) * 1e-6;
        double[] truth = SPACE.get(size);
        if (works.contains("W5")) {
            addSpace("W5", name, build, geometry, space.rays(), new Answer((long) truth[0], truth[1]));
        }
        if (works.contains("W6")) {
            addSpace("W6", name, build, geometry, space.frames(), new Answer((long) truth[2], truth[3]));
        }
    }

    private void addSpace(String work, String name, double build, Geometry geometry, Ray[] rays, Answer truth) {
        IntToDoubleFunction ask = k -> geometry.getRayDistance(rays[k], 0, PeerInputs.Space.RANGE, 0);
        add(
                work,
                name,
                rays.length,
                build,
                truth,
                () -> castAll(rays, ray -> geometry.getRayDistance(ray, 0, PeerInputs.Space.RANGE, 0)),
                new Structure(geometry, geometry.objects().size(), rays.length, ask));
    }

    private static Answer rays(Geometry geometry, PeerInputs.Scene scene) {
        Ray[] rays = scene.rays();
        double[] ranges = scene.ranges();
        long hits = 0;
        double sum = 0;
        for (int k = 0; k < rays.length; k++) {
            double distance = geometry.getRayDistance(rays[k], 0, ranges[k], 0);
            if (distance < Double.POSITIVE_INFINITY) {
                hits++;
                sum += distance;
            }
        }
        return new Answer(hits, sum);
    }

    private static Answer probes(Geometry geometry, GeometryObject[] probes) {
        long hits = 0;
        for (GeometryObject probe : probes) {
            hits += geometry.testObject(probe) ? 1 : 0;
        }
        return new Answer(hits, hits);
    }

    private void addPairs() throws IOException {
        MeshObject mesh = inputs.mesh("knot4k");
        PeerInputs.Poses poses = inputs.poses();
        double build = buildMillis(mesh);
        Supplier<Answer> task = () -> {
            long hits = 0;
            for (int k = 0; k < poses.centers().length; k++) {
                GeometryObject other = mesh.oriented(poses.rotations()[k]).movedTo(poses.centers()[k]);
                hits += CollisionDetection.intersects(mesh, other) ? 1 : 0;
            }
            return new Answer(hits, hits);
        };
        add("W2", "knot4k", poses.centers().length, build, PAIRS, task, null);
    }

    private void addMesh(String name) throws IOException {
        MeshObject mesh = inputs.mesh(name);
        double build = buildMillis(mesh);
        Ray[] rays = inputs.rays();
        Geometry geometry = new Geometry();
        geometry.addObjectUnchecked(mesh);
        Answer truth = MESHES.get(name);
        add(
                "W3",
                name,
                rays.length,
                build,
                truth,
                () -> castAll(rays, ray -> geometry.getRayDistance(ray, 0, 1e30, 0)),
                new Structure(
                        mesh.triangles(),
                        mesh.triangles().size(),
                        rays.length,
                        k -> geometry.getRayDistance(rays[k], 0, 1e30, 0)));
    }

    /** By name, since the tree's class has another package in the builds before this one. */
    private static double buildMillis(MeshObject mesh) {
        try {
            Method tree = mesh.triangles().getClass().getMethod("tree");
            long start = System.nanoTime();
            tree.invoke(mesh.triangles());
            return (System.nanoTime() - start) * 1e-6;
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Answer castAll(Ray[] rays, ToDoubleFunction<Ray> cast) {
        long hits = 0;
        double sum = 0;
        for (Ray ray : rays) {
            double distance = cast.applyAsDouble(ray);
            if (distance < Double.POSITIVE_INFINITY) {
                hits++;
                sum += distance;
            }
        }
        return new Answer(hits, sum);
    }
}
