package robosim.geometry.cli.worlds;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.Skipped;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.check.Needs;
import robosim.geometry.world.check.Overlap;
import robosim.geometry.world.check.Pile;
import robosim.geometry.world.check.Room;
import robosim.geometry.world.check.Setting;
import robosim.geometry.world.check.StandIn;
import robosim.geometry.world.check.WorldCheck;

/** A checked world as JSON, for scripts. docs/command-line.md describes the fields. */
public final class CheckJson {
    private CheckJson() {}

    /** A file that is not a valid world. */
    static Map<String, @Nullable Object> problems(Path file, List<WorldException> problems) {
        Map<String, @Nullable Object> json = new LinkedHashMap<>();
        json.put("file", file);
        json.put("valid", false);
        json.put("fine", false);
        json.put(
                "problems",
                problems.stream()
                        .map(problem -> fields(
                                "file", problem.source(),
                                "line", problem.line(),
                                "column", problem.column(),
                                "message", problem.getMessage()))
                        .toList());
        return json;
    }

    /** @param read the result of reading the file */
    static Map<String, @Nullable Object> of(Path file, WorldCheck check, WorldImport read) {
        Map<String, @Nullable Object> json = new LinkedHashMap<>();
        json.put("file", file);
        json.put("valid", true);
        json.put("fine", check.isFine() && read.isWhole());
        json.put("problems", List.of());
        json.put("skipped", read.skipped().stream().map(CheckJson::skipped).toList());
        json.put("notes", read.remarks());
        json.put("world", world(check.world()));
        Map<String, @Nullable Object> counts = new LinkedHashMap<>();
        check.counts().forEach((kind, count) -> counts.put(kind.word(), count));
        json.put("counts", counts);
        json.put("members", check.members());
        json.put("triangles", check.triangles());
        json.put("robots", check.robots().stream().map(o -> o.object().name()).toList());
        json.put("sonars", check.sonars());
        json.put(
                "outside", check.outside().stream().map(o -> object(o.object())).toList());
        json.put("overlaps", check.overlaps().stream().map(CheckJson::overlap).toList());
        json.put("staticOverlaps", check.staticOverlaps());
        Pile pile = check.pile();
        json.put("pile", pile == null ? null : fields("at", point(pile.at()), "objects", pile.objects()));
        json.put(
                "falls",
                WorldCheck.falls(check.world()).stream().map(CheckJson::fall).toList());
        json.put("rooms", check.rooms().stream().map(CheckJson::room).toList());
        json.put("needs", needs(check.needs()));
        return json;
    }

    private static Map<String, @Nullable Object> fields(@Nullable Object... pairs) {
        Map<String, @Nullable Object> fields = new LinkedHashMap<>();
        for (int k = 0; k < pairs.length; k += 2) {
            fields.put(String.valueOf(pairs[k]), pairs[k + 1]);
        }
        return fields;
    }

    private static Map<String, @Nullable Object> skipped(Skipped skipped) {
        return fields(
                "file", skipped.source(),
                "line", skipped.line(),
                "what", skipped.what(),
                "reason", skipped.reason());
    }

    private static Map<String, @Nullable Object> fall(WorldCheck.Fall fall) {
        return fields("robot", fall.robot().object().name(), "drop", fall.drop());
    }

    private static Map<String, @Nullable Object> world(World world) {
        Unit unit = world.unit();
        return fields(
                "width", world.width(),
                "height", world.height(),
                "length", world.length(),
                "unit", unit == null ? null : unit.symbol(),
                "dimension", world.dimension(),
                "accuracy", world.accuracy());
    }

    private static Map<String, @Nullable Object> object(GeometryObject object) {
        return fields("name", object.name(), "kind", object.kind().word(), "center", point(object.center()));
    }

    private static List<Double> point(Point p) {
        return List.of(p.x(), p.y(), p.z());
    }

    private static Map<String, @Nullable Object> overlap(Overlap overlap) {
        return fields(
                "first", object(overlap.first().object()),
                "second", object(overlap.second().object()),
                "start", overlap.isStart(),
                "contact", point(overlap.contact()),
                "normal", point(overlap.normal()),
                "depth", overlap.depth());
    }

    private static Map<String, @Nullable Object> room(Room room) {
        return fields(
                "robots", room.robots(),
                "minX", room.minX(),
                "minZ", room.minZ(),
                "maxX", room.maxX(),
                "maxZ", room.maxZ(),
                "area", room.area(),
                "most", room.most(),
                "places", room.places(),
                "step", room.step(),
                "told", room.isTold());
    }

    private static Map<String, @Nullable Object> needs(Needs needs) {
        return fields(
                "dimension", needs.dimension(),
                "accuracy", needs.accuracy(),
                "told", needs.isTold(),
                "proven", needs.isProven(),
                "met", needs.met(),
                "seed", needs.seed(),
                "standIn", standIn(needs.standIn()),
                "settings", needs.settings().stream().map(CheckJson::setting).toList());
    }

    private static @Nullable Map<String, @Nullable Object> standIn(@Nullable StandIn standIn) {
        return standIn == null
                ? null
                : fields(
                        "radius", standIn.body().radius(),
                        "height", standIn.body().height(),
                        "floor", standIn.floor());
    }

    private static Map<String, @Nullable Object> setting(Setting setting) {
        return fields(
                "dimension", setting.dimension(),
                "accuracy", setting.accuracy(),
                "same", setting.isSame(),
                "places", setting.places(),
                "placesOtherwise", setting.placesOtherwise(),
                "moves", setting.moves(),
                "movesOtherwise", setting.movesOtherwise(),
                "distances", setting.distances(),
                "distancesOtherwise", setting.distancesOtherwise(),
                "shortest", setting.shortest());
    }
}
