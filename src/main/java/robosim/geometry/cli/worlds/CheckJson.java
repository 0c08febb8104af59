package robosim.geometry.cli.worlds;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.Skipped;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.check.Overlap;
import robosim.geometry.world.check.Pile;
import robosim.geometry.world.check.RecommendedSetting;
import robosim.geometry.world.check.Room;
import robosim.geometry.world.check.SettingComparison;
import robosim.geometry.world.check.SubstituteRobot;
import robosim.geometry.world.check.WorldCheck;
import robosim.geometry.world.shared.JsonText;

/** A checked world as JSON, for scripts. docs/command-line.md describes the fields. */
public final class CheckJson {
    private CheckJson() {}

    static Map<String, @Nullable Object> problems(Path file, List<WorldException> problems) {
        return JsonText.fields(
                "file",
                file,
                "valid",
                false,
                "fine",
                false,
                "problems",
                problems.stream()
                        .map(problem -> JsonText.fields(
                                "file", problem.source(),
                                "line", problem.line(),
                                "column", problem.column(),
                                "message", problem.getMessage()))
                        .toList());
    }

    /** @param read the result of reading the file */
    static Map<String, @Nullable Object> of(Path file, WorldCheck check, WorldImport read) {
        Map<String, @Nullable Object> counts = new LinkedHashMap<>();
        check.counts().forEach((kind, count) -> counts.put(kind.word(), count));
        Pile pile = check.pile();
        return JsonText.fields(
                "file", file,
                "valid", true,
                "fine", check.isFine() && read.isWhole(),
                "problems", List.of(),
                "skipped", list(read.skipped(), CheckJson::skipped),
                "notes", read.remarks(),
                "world", world(check.world()),
                "counts", counts,
                "members", check.members(),
                "triangles", check.triangles(),
                "robots", list(check.robots(), each -> each.object().name()),
                "sonars", check.sonars(),
                "outside", list(check.outside(), each -> object(each.object())),
                "overlaps", list(check.overlaps(), CheckJson::overlap),
                "staticOverlaps", check.staticOverlaps(),
                "pile", pile == null ? null : JsonText.fields("at", point(pile.at()), "objects", pile.objects()),
                "falls", list(WorldCheck.falls(check.world()), CheckJson::fall),
                "rooms", list(check.rooms(), CheckJson::room),
                "needs", needs(check.needs()));
    }

    private static <T> List<@Nullable Object> list(List<T> items, Function<T, @Nullable Object> made) {
        List<@Nullable Object> all = new ArrayList<>();
        items.forEach(item -> all.add(made.apply(item)));
        return all;
    }

    private static Map<String, @Nullable Object> skipped(Skipped skipped) {
        return JsonText.fields(
                "file", skipped.source(),
                "line", skipped.line(),
                "what", skipped.what(),
                "reason", skipped.reason());
    }

    private static Map<String, @Nullable Object> fall(WorldCheck.Fall fall) {
        return JsonText.fields("robot", fall.robot().object().name(), "drop", fall.drop());
    }

    private static Map<String, @Nullable Object> world(World world) {
        Unit unit = world.unit();
        return JsonText.fields(
                "width", world.width(),
                "height", world.height(),
                "length", world.length(),
                "unit", unit == null ? null : unit.symbol(),
                "dimension", world.dimension(),
                "accuracy", world.accuracy());
    }

    private static Map<String, @Nullable Object> object(GeometryObject object) {
        return JsonText.fields("name", object.name(), "kind", object.kind().word(), "center", point(object.center()));
    }

    private static List<Double> point(Point p) {
        return List.of(p.x(), p.y(), p.z());
    }

    private static Map<String, @Nullable Object> overlap(Overlap overlap) {
        return JsonText.fields(
                "first", object(overlap.first().object()),
                "second", object(overlap.second().object()),
                "start", overlap.isStart(),
                "contact", point(overlap.contact()),
                "normal", point(overlap.normal()),
                "depth", overlap.depth());
    }

    private static Map<String, @Nullable Object> room(Room room) {
        return JsonText.fields(
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

    private static Map<String, @Nullable Object> needs(RecommendedSetting needs) {
        return JsonText.fields(
                "dimension", needs.dimension(),
                "accuracy", needs.accuracy(),
                "told", needs.isTold(),
                "proven", needs.isProven(),
                "met", needs.met(),
                "seed", needs.seed(),
                "standIn", standIn(needs.standIn()),
                "settings", needs.settings().stream().map(CheckJson::setting).toList());
    }

    private static @Nullable Map<String, @Nullable Object> standIn(@Nullable SubstituteRobot standIn) {
        return standIn == null
                ? null
                : JsonText.fields(
                        "radius", standIn.body().radius(),
                        "height", standIn.body().height(),
                        "floor", standIn.floor());
    }

    private static Map<String, @Nullable Object> setting(SettingComparison setting) {
        return JsonText.fields(
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
