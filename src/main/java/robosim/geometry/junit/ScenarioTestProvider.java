package robosim.geometry.junit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.Extension;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.TestTemplateInvocationContext;
import org.junit.jupiter.api.extension.TestTemplateInvocationContextProvider;

/** Runs a test for each world with each seed. Registered by {@link ScenarioTest}. */
final class ScenarioTestProvider implements TestTemplateInvocationContextProvider {
    /** Called by JUnit. */
    public ScenarioTestProvider() {}

    @Override
    public boolean supportsTestTemplate(ExtensionContext context) {
        return Run.find(context, World.class).isPresent();
    }

    @Override
    public Stream<TestTemplateInvocationContext> provideTestTemplateInvocationContexts(ExtensionContext context) {
        World world = Run.find(context, World.class).orElseThrow();
        List<TestTemplateInvocationContext> all = new ArrayList<>();
        for (String file : world.value().length == 0 ? new @Nullable String[] {null} : world.value()) {
            Optional<Seed> seeds = Run.find(context, Seed.class);
            if (seeds.isEmpty()) {
                all.add(new Invocation(file == null ? world.method() : file, new Run.Choice(file, null)));
            } else {
                Arrays.stream(seeds.get().value())
                        .forEach(seed -> all.add(new Invocation(
                                (file == null ? world.method() : file) + ", seed " + seed,
                                new Run.Choice(file, seed))));
            }
        }
        return all.stream();
    }

    private record Invocation(String words, Run.Choice choice) implements TestTemplateInvocationContext {
        @Override
        public String getDisplayName(int index) {
            return words;
        }

        @Override
        public List<Extension> getAdditionalExtensions() {
            BeforeEachCallback chooses = context -> WorldExtension.choose(context, choice);
            return List.of(chooses);
        }
    }
}
