package robosim.geometry.cli.worlds;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import robosim.geometry.check.NumberText;
import robosim.geometry.check.Text;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.Skipped;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.check.Overlap;
import robosim.geometry.world.check.Pile;
import robosim.geometry.world.check.RecommendedSetting;
import robosim.geometry.world.check.Room;
import robosim.geometry.world.check.SettingComparison;
import robosim.geometry.world.check.SubstituteRobot;
import robosim.geometry.world.check.WorldCheck;
import robosim.geometry.world.shared.ObjectNames;

/** A checked world as text for people. */
public final class CheckText {
    /** How many pairs of static objects are listed; the rest are counted. */
    private static final int STATIC_PAIRS = 10;

    /** How many contacts of robots. */
    private static final int STARTS = 50;

    /** How many falls. */
    private static final int FALLS = 3;

    /** Things left out that are told one by one. */
    private static final int SKIPPED = 20;

    private final WorldCheck check;
    private final List<Skipped> skipped;
    private final List<String> notes;
    private final World world;
    private final String unit;
    private final StringBuilder text = new StringBuilder();

    private CheckText(WorldCheck check, WorldImport read) {
        this.check = check;
        this.skipped = read.skipped();
        this.notes = read.remarks();
        this.world = check.world();
        Unit given = world.unit();
        this.unit = given == null ? "" : " " + given.symbol();
    }

    /** @param read the result of reading the file */
    static String of(Path file, WorldCheck check, WorldImport read) {
        CheckText text = new CheckText(check, read);
        text.contents(file);
        text.skipped();
        text.outside();
        text.overlaps();
        text.falls();
        text.rooms();
        text.needs();
        text.add(
                "verdict",
                check.isFine() && read.isWhole()
                        ? "fine"
                        : "FINDINGS: " + text.findings().stream().collect(Collectors.joining(", ")));
        return text.text.toString();
    }

    private void add(String what, String line, Object... values) {
        String told = values.length == 0 ? line : String.format(Locale.ROOT, line, values);
        text.append(String.format(Locale.ROOT, "%-9s %s%n", what, told));
    }

    private void more(int count, String where) {
        if (count > 0) {
            add("", "  and %,d more; --json %s", count, where);
        }
    }

    /** The noun for a kind, singular or plural. */
    private static String kinds(GeometryObject.Kind kind, int count) {
        String one = kind.word();
        return count == 1 ? one : one.endsWith("x") || one.endsWith("sh") ? one + "es" : one + "s";
    }

    private static String number(double value) {
        return Math.abs(value) >= 1e-3 ? NumberText.places(value, 4) : NumberText.digits(value, 3);
    }

    private String length(double value) {
        return number(value) + unit;
    }

    private static String point(Point p) {
        return "(" + number(p.x()) + ", " + number(p.y()) + ", " + number(p.z()) + ")";
    }

    private void contents(Path file) {
        add(
                "world",
                "%s: %s x %s x %s%s, %s, %s",
                file,
                number(world.width()),
                number(world.height()),
                number(world.length()),
                unit,
                world.dimension(),
                world.accuracy());
        String kinds = check.counts().entrySet().stream()
                .map(kind ->
                        String.format(Locale.ROOT, "%,d %s", kind.getValue(), kinds(kind.getKey(), kind.getValue())))
                .collect(Collectors.joining(", "));
        String inside = (check.members() > 0
                        ? String.format(Locale.ROOT, "; %,d members of groups", check.members())
                        : "")
                + (check.triangles() > 0 ? String.format(Locale.ROOT, "; %,d triangles", check.triangles()) : "");
        add("objects", "%,d%s%s", world.objects().size(), kinds.isEmpty() ? "" : ": " + kinds, inside);
        add("robots", "%,d moveable, %,d sonars", check.robots().size(), check.sonars());
    }

    private void skipped() {
        skipped.stream().limit(SKIPPED).forEach(each -> add("skipped", "%s", each));
        more(skipped.size() - SKIPPED, "lists all");
        notes.stream().limit(SKIPPED).forEach(each -> add("note", "%s", each));
        more(notes.size() - SKIPPED, "lists all");
    }

    private void outside() {
        if (check.outside().isEmpty()) {
            add("border", "nothing reaches beyond it");
        }
        check.outside()
                .forEach(object -> add(
                        "border",
                        "%s reaches beyond the world and is not part of what follows; move it or enlarge the world",
                        ObjectNames.of(object.object())));
    }

    private void overlaps() {
        List<Overlap> starts = check.startingContacts();
        if (starts.isEmpty() && !check.robots().isEmpty()) {
            add("contacts", "no robot starts in contact");
        }
        starts.stream()
                .limit(STARTS)
                .forEach(overlap ->
                        add("contacts", "%s starts out %s", overlap(overlap).toArray()));
        more(starts.size() - STARTS, "lists them");
        pile();
        if (check.staticOverlaps() == 0) {
            add("overlaps", "no static objects touch or overlap");
            return;
        }
        add(
                "overlaps",
                "%s%,d %s of static objects touch or overlap, which is allowed",
                check.staticOverlaps() < WorldCheck.MOST_COUNTED ? "" : "at least ",
                check.staticOverlaps(),
                check.staticOverlaps() == 1 ? "pair" : "pairs");
        check.overlaps().stream()
                .filter(overlap -> !overlap.isStart())
                .limit(STATIC_PAIRS)
                .forEach(overlap -> add("", "  %s is %s", overlap(overlap).toArray()));
        if (check.staticOverlaps() > STATIC_PAIRS) {
            add(
                    "",
                    "  and %s%,d more; --json tells the first %,d",
                    check.staticOverlaps() < WorldCheck.MOST_COUNTED ? "" : "at least ",
                    check.staticOverlaps() - STATIC_PAIRS,
                    WorldCheck.MAX_STATIC_OVERLAPS);
        }
    }

    private void pile() {
        Pile pile = check.pile();
        if (pile != null) {
            add(
                    "overlaps",
                    "%,d objects overlap in one place, at %s; not all pairs were compared, and not all contacts are"
                            + " listed",
                    pile.objects(),
                    point(pile.at()));
        }
    }

    private void falls() {
        List<WorldCheck.Fall> falls = WorldCheck.falls(world);
        falls.stream().limit(FALLS).forEach(fall -> add("falls", "%s", fall(fall, world)));
        more(falls.size() - FALLS, "lists all");
    }

    /** What comes of a robot without a floor. */
    static String fall(WorldCheck.Fall fall, World world) {
        Unit unit = world.unit();
        return Text.quoted(String.valueOf(fall.robot().object().name()))
                + " stands on nothing: where bodies move it falls "
                + number(fall.drop()) + (unit == null ? "" : " " + unit.symbol())
                + " to the lower border of the world, below all walls; add a floor, or make the world PLANAR";
    }

    /** The first object's name, and how it touches or overlaps the second. */
    private List<String> overlap(Overlap overlap) {
        String second = ObjectNames.of(overlap.second().object());
        String at = " at " + point(overlap.contact());
        String how = overlap.depth() == 0
                ? "touching " + second + at
                : Double.isInfinite(overlap.depth())
                        ? "inside " + second + at
                        : "overlapping " + second + at + ", " + length(overlap.depth()) + " deep along "
                                + point(overlap.normal());
        return List.of(ObjectNames.of(overlap.first().object()), how);
    }

    private void rooms() {
        List<Room> rooms = check.rooms();
        if (rooms.isEmpty()) {
            add(
                    "ways",
                    check.robots().isEmpty()
                            ? "there is no robot"
                            : "every robot starts in contact, so none could be tested");
            return;
        }
        Room main = rooms.get(0);
        if (rooms.size() == 1) {
            add(
                    "ways",
                    main.robots().size() == 1 ? "%s can move in %s" : "%s can reach each other, in %s",
                    main.robots().size() == 1
                            ? main.robots().get(0)
                            : "all " + main.robots().size() + " robots that start free",
                    room(main));
        } else {
            add("ways", "%s can move in %s", names(main), room(main));
        }
        String them = main.robots().size() == 1 ? main.robots().get(0) : "them";
        check.shutIn()
                .forEach(room -> add("ways", "%s cannot reach %s: shut in, in %s", names(room), them, room(room)));
        check.stuck().forEach(room -> add("ways", "%s cannot make a single step", names(room)));
        check.untold()
                .forEach(room -> add(
                        "ways",
                        room.equals(main)
                                ? "unknown at a step of %3$s whether %1$s can move"
                                : "unknown at a step of %3$s whether %1$s can reach %2$s",
                        names(room),
                        them,
                        length(room.step())));
    }

    private static String names(Room room) {
        return String.join(", ", room.robots());
    }

    private String room(Room room) {
        return String.format(
                Locale.ROOT,
                "x %s to %s, z %s to %s, an area of about %s to %s%s (%,d places at a step of %s%s)",
                number(room.minX()),
                number(room.maxX()),
                number(room.minZ()),
                number(room.maxZ()),
                number(room.area()),
                number(room.most()),
                unit.isEmpty() ? "" : unit + "^2",
                room.places(),
                length(room.step()),
                room.isTold() ? "" : ", too coarse for narrow ways");
    }

    private void needs() {
        if (!skipped.isEmpty() || !check.outside().isEmpty()) {
            add(
                    "needs",
                    "unknown because the world is incomplete: %s; correct that and check again",
                    String.join(", ", missing()));
            return;
        }
        RecommendedSetting needs = check.needs();
        SettingComparison truth = needs.setting(world.dimension(), Accuracy.EXACT);
        SubstituteRobot standIn = needs.standIn();
        if (check.robots().isEmpty()) {
            add(
                    "robot",
                    standIn == null
                            ? "none, and no place for one from which anything is seen; the command add puts one there"
                            : "none; in its place a cylinder of radius %s and height %s asked, on a floor at Y %s;"
                                    + " the command add puts a robot there",
                    standIn == null
                            ? new Object[0]
                            : new Object[] {
                                length(standIn.body().radius()),
                                length(standIn.body().height()),
                                length(standIn.floor())
                            });
        }
        if (check.robots().isEmpty() && standIn == null) {
            add("needs", "unknown, for there is no robot");
            return;
        }
        if (truth.isAskedEnough() && !needs.isTold()) {
            add(
                    "needs",
                    "unknown: only %,d of %,d places, %,d moves and %,d distances hit anything; stay with %s, %s",
                    needs.met(),
                    truth.places(),
                    truth.moves(),
                    truth.distances(),
                    needs.dimension(),
                    needs.accuracy());
            return;
        }
        if (!needs.isTold()) {
            add(
                    "needs",
                    "unknown: robots had room for only %,d moves and %,d distances; stay with %s, %s",
                    truth.moves(),
                    truth.distances(),
                    needs.dimension(),
                    needs.accuracy());
            return;
        }
        add(
                "needs",
                "%s, %s is enough: the coarsest that answers %,d places, %,d moves and %,d %s as EXACT does",
                needs.dimension(),
                needs.accuracy(),
                truth.places(),
                truth.moves(),
                truth.distances(),
                check.sonars() > 0 ? "sonars" : "rays");
        dimension(needs);
        for (SettingComparison setting : needs.settings()) {
            if (setting.dimension() == needs.dimension() && setting.accuracy() != Accuracy.EXACT) {
                add("", "  %-6s %s", setting.accuracy(), otherwise(setting));
            }
        }
    }

    private void dimension(RecommendedSetting needs) {
        boolean planar = world.dimension() == Dimension.PLANAR;
        SettingComparison other = needs.setting(planar ? Dimension.SPATIAL : Dimension.PLANAR, Accuracy.EXACT);
        String why = needs.isProven()
                ? "heights cannot matter: everything stands upright and reaches the height of every robot's centre"
                : other.isSame() ? "heights did not matter in any of them" : "heights matter: ";
        add("", "  %s%s", why, needs.isProven() || other.isSame() ? "" : other.dimension() + " " + otherwise(other));
    }

    private String otherwise(SettingComparison setting) {
        if (setting.isSame()) {
            return "answers all the same";
        }
        return String.format(
                Locale.ROOT,
                "answers %s of places, %s of moves, %s of distances differently%s",
                share(setting.placesOtherwise(), setting.places()),
                share(setting.movesOtherwise(), setting.moves()),
                share(setting.distancesOtherwise(), setting.distances()),
                shortfall(setting));
    }

    private String shortfall(SettingComparison setting) {
        if (setting.shortest() == 0) {
            return "";
        }
        return Double.isInfinite(setting.shortest())
                ? ", and detects surfaces that are not there"
                : ", short by up to " + length(setting.shortest());
    }

    private static String share(int some, int all) {
        return all == 0
                ? "0 %"
                : String.format(
                        Locale.ROOT, some > 0 && some * 1000L < all ? "%.2f %%" : "%.1f %%", 100.0 * some / all);
    }

    /** The number of objects that were not checked, by the reason. */
    private List<String> missing() {
        List<String> missing = new ArrayList<>();
        count(missing, skipped.size(), "left out of the file");
        count(missing, check.outside().size(), "outside the world");
        return missing;
    }

    private List<String> findings() {
        List<String> findings = missing();
        count(
                findings,
                (int) check.startingContacts().stream()
                        .flatMap(contact -> Stream.of(contact.first(), contact.second()))
                        .filter(each -> each.object().isMoveable())
                        .distinct()
                        .count(),
                "starting in contact");
        count(
                findings,
                check.shutIn().stream().mapToInt(room -> room.robots().size()).sum(),
                "shut in");
        count(findings, check.stuck().size(), "unable to move");
        return findings;
    }

    private static void count(List<String> findings, int count, String what) {
        if (count > 0) {
            findings.add(count + " " + what);
        }
    }
}
