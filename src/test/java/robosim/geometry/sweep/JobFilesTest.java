package robosim.geometry.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A job is done where replicates failed, as these would fail again; it is not where there are no results. */
@DisabledOnOs(OS.WINDOWS) // they are shell scripts
@Tag("clock")
class JobFilesTest {
    private static final Path JOBS = Path.of("examples", "spark-sweep");

    @TempDir
    Path folder;

    /** Runs it with a java that ends so, after it has maybe written results. */
    private int run(int code, boolean writes, String... command) throws IOException, InterruptedException {
        Path java = folder.resolve("java");
        Files.writeString(
                java, "#!/bin/sh\n" + (writes ? "echo {} > sweep-3-of-16.jsonl\n" : "") + "exit " + code + "\n");
        Files.setPosixFilePermissions(java, PosixFilePermissions.fromString("rwx------"));
        ProcessBuilder job = new ProcessBuilder(command).directory(folder.toFile());
        job.environment().put("PATH", folder + ":" + job.environment().get("PATH"));
        job.environment().put("JOB_COMPLETION_INDEX", "3");
        job.environment().put("SLURM_ARRAY_TASK_ID", "3");
        job.environment().put("SLURM_CPUS_PER_TASK", "1");
        return job.start().waitFor();
    }

    @ParameterizedTest
    @CsvSource({"0, true, true", "1, true, true", "1, false, false", "2, true, false", "137, true, false"})
    void isDoneWhereReplicatesFailed(int code, boolean writes, boolean isDone) throws Exception {
        String yaml = Files.readString(JOBS.resolve("kubernetes-job.yaml"));
        String beginning = "command: [sh, -c, '";
        assertThat(yaml).contains(beginning);
        String script = yaml.substring(yaml.indexOf(beginning) + beginning.length());
        script = script.substring(0, script.indexOf('\''));
        assertThat(run(code, writes, "sh", "-c", script) == 0).isEqualTo(isDone);
        String slurm = JOBS.resolve("slurm-array.sh").toAbsolutePath().toString();
        assertThat(run(code, writes, "bash", slurm) == 0).isEqualTo(isDone);
    }
}
