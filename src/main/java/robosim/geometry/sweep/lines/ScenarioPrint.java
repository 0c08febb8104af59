package robosim.geometry.sweep.lines;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;

/** A digest of a conversation: its options, its world, its requests and answers. */
public final class ScenarioPrint {
    /** Counts the changes of what a result has: results of earlier versions are not resumed. */
    private static final int RESULTS = 2;

    private final Fingerprint print = new Fingerprint();

    private ScenarioPrint() {}

    public static String of(
            SessionOptions options, InitBundle init, List<Bundle> requests, List<@Nullable Bundle> answers) {
        ScenarioPrint of = new ScenarioPrint();
        of.print.add(RESULTS);
        of.print.add(options.dimension().name()).add(options.accuracy().name());
        of.add(options.beam());
        of.add(init);
        of.print.add(requests.size());
        for (int k = 0; k < requests.size(); k++) {
            of.add(requests.get(k));
            of.add(answers.get(k));
        }
        return of.print.hex().substring(0, 16);
    }

    private void add(@Nullable Beam beam) {
        print.add(beam == null ? 0 : 1);
        if (beam != null) {
            print.add(beam.min()).add(beam.max()).add(beam.width());
        }
    }

    private void add(@Nullable Bundle bundle) {
        print.add(bundle == null ? "" : bundle.getClass().getSimpleName());
        if (bundle instanceof InitBundle init) {
            addWorld(init);
        } else if (bundle instanceof MoveBundle moves) {
            print.add(moves.moves().size());
            for (MoveRequest move : moves.moves()) {
                print.add(move.objectName()).add(move.x()).add(move.y()).add(move.z());
                print.add(move.rx()).add(move.ry());
            }
        } else if (bundle instanceof SonarRequestBundle sonars) {
            print.add(sonars.requests().size());
            for (SonarRequest sonar : sonars.requests()) {
                print.add(sonar.objectName()).add(sonar.xOffset()).add(sonar.zOffset());
                add(sonar.beam());
            }
        } else if (bundle instanceof StepBundle || bundle instanceof StepBundle.Answer) {
            print.add(bundle.toString()); // of records, whose doubles are all digits
        } else if (bundle instanceof DistanceBundle distances) {
            print.add(distances.distances().size());
            distances.distances().forEach(print::add);
        }
    }

    private static String name(@Nullable Enum<?> constant) {
        return constant == null ? "" : constant.name();
    }

    private void addWorld(InitBundle init) {
        WorldSettings settings = init.settings();
        print.add(settings == null ? 0 : 1);
        if (settings != null) {
            print.add(settings.width()).add(settings.height()).add(settings.length());
            print.add(name(settings.dimension())).add(name(settings.accuracy()));
        }
        print.add(init.objects().size());
        init.objects().forEach(print::add);
    }
}
