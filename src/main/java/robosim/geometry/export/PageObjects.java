package robosim.geometry.export;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.Kind;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Quaternion;
import robosim.geometry.world.shared.Placement;

/** The objects of a page, each once: what several worlds of a recording have in common is told once. */
final class PageObjects {
    /** By the number that stands for it: the kinds of parts. */
    private static final List<Kind> KINDS =
            List.of(Kind.BOX, Kind.CYLINDER, Kind.SPHERE, Kind.CAPSULE, Kind.MESH, Kind.GRID);

    /** An object as it is painted. */
    private record Painted(GeometryObject object, int colour) {}

    private final PageQuantization quanta;
    private final PageStreams out;
    private final Map<Painted, Integer> known = new HashMap<>();
    private final Map<TriangleMesh, Integer> meshes = new HashMap<>();
    private final PageLooks looks;

    /** Each grid of which cells were taken together, in words. */
    private final List<String> coarse = new ArrayList<>();

    PageObjects(PageQuantization quanta, PageStreams out) {
        this.quanta = quanta;
        this.out = out;
        looks = new PageLooks(quanta, out.looks);
    }

    List<String> coarse() {
        return coarse;
    }

    /**
     * The number of an object, which is written at its first use.
     *
     * @param colour 0xRRGGBB; also that of all surfaces of an object without a material
     */
    int number(GeometryObject object, int colour) {
        GeometryObject placed = object.isMoveable() ? object.at(Pose.ORIGIN) : object;
        Painted painted = new Painted(placed, colour);
        Integer number = known.get(painted);
        if (number == null) {
            number = known.size();
            known.put(painted, number);
            write(painted);
        }
        return number;
    }

    private void write(Painted painted) {
        GeometryObject object = painted.object;
        String name = object.name();
        out.objects.text(name == null ? "" : name);
        out.objects.text(object.kind().word());
        for (int shift = 16; shift >= 0; shift -= 8) {
            out.objects.octet(painted.colour >> shift);
        }
        Pose pose = object.pose();
        out.objects.real(object.isMoveable() ? 0 : quanta.x(pose.center()));
        out.objects.real(object.isMoveable() ? 0 : quanta.y(pose.center()));
        out.objects.real(object.isMoveable() ? 0 : quanta.z(pose.center()));
        turned(Quaternion.of(pose));
        List<Part> parts = new ArrayList<>();
        Material usual = Material.of(Color.ofPacked(painted.colour));
        GeometryObject seen = object.seen();
        if (seen != null) {
            collect(seen, object.material().within(usual), Placement.NONE, parts);
        }
        out.objects.count(parts.size());
        parts.forEach(this::part);
    }

    /** A shape that is no group, in its object's own frame. */
    private record Part(GeometryObject shape, Material material, Placement place) {}

    private static void collect(GeometryObject object, Material material, Placement place, List<Part> parts) {
        if (object instanceof ObjectGroup group) {
            for (GeometryObject member : group.members()) {
                Pose pose = member.pose();
                Placement inner = place.then(Placement.turned(pose.center(), pose.rotation()));
                collect(member, member.material().within(material), inner, parts);
            }
        } else {
            parts.add(new Part(object, material, place));
        }
    }

    private void part(Part part) {
        boolean placed = part.place != Placement.NONE;
        GeometryObject shape = part.shape;
        out.objects.octet(KINDS.indexOf(shape.kind()) | (placed ? 8 : 0));
        if (shape instanceof MeshObject mesh) {
            out.objects.count(mesh(mesh));
        } else if (shape instanceof GridObject grid) {
            cells(grid);
        } else {
            lengths(shape.sizes());
        }
        out.objects.count(looks.number(part.material));
        if (placed) {
            out.objects.real(quanta.length(part.place.origin().x()));
            out.objects.real(quanta.length(part.place.origin().y()));
            out.objects.real(quanta.length(part.place.origin().z()));
            turned(Quaternion.of(part.place.pose()));
        }
    }

    private void lengths(double... sizes) {
        for (double size : sizes) {
            out.objects.real(quanta.length(size));
        }
    }

    private void turned(Quaternion turned) {
        out.objects.real(turned.x());
        out.objects.real(turned.y());
        out.objects.real(turned.z());
        out.objects.real(turned.w());
    }

    private void cells(GridObject grid) {
        GridCells cells = new GridCells(grid);
        if (cells.together > 1) {
            coarse.add(grid.columns() + " x " + grid.rows() + " cells are shown in squares of " + cells.together + " x "
                    + cells.together + " cells");
        }
        lengths(grid.cell(), grid.height());
        out.objects.count(grid.columns());
        out.objects.count(grid.rows());
        out.objects.count(cells.rectangles.size());
        int row = 0;
        for (GridCells.Rectangle each : cells.rectangles) {
            out.objects.count(each.fromRow() - row);
            out.objects.count(each.fromColumn());
            out.objects.count(each.toColumn() - each.fromColumn());
            out.objects.count(each.toRow() - each.fromRow());
            row = each.fromRow();
        }
    }

    /** The number of a mesh's triangles, which are written at their first use. */
    private int mesh(MeshObject mesh) {
        TriangleMesh triangles = mesh.triangles();
        Integer number = meshes.get(triangles);
        if (number != null) {
            return number;
        }
        meshes.put(triangles, meshes.size());
        out.meshes.count(triangles.vertices());
        for (int axis = 0; axis < 3; axis++) {
            for (int v = 0; v < triangles.vertices(); v++) {
                out.meshes.real(quanta.length(triangles.coordinate(v, axis)));
            }
        }
        out.meshes.count(triangles.size());
        int before = 0;
        for (int t = 0; t < triangles.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                int vertex = triangles.vertex(t, corner);
                out.meshes.signed(vertex - before);
                before = vertex;
            }
        }
        return meshes.size() - 1;
    }
}
