package robosim.geometry.cli;

import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Version;

/** Prints a shell completion script for these commands. */
@Command(
        name = "completion",
        description = "Prints a script that makes bash or zsh complete the commands and their options.",
        footer = {
            "  alias robosim-geometry='java -jar /path/to/robosim-geometry-app.jar'",
            "  source <(robosim-geometry completion)",
            "",
            "Put both lines into ~/.bashrc to have completion in every shell. In zsh, put these before them:",
            "  autoload -U compinit bashcompinit; compinit; bashcompinit"
        })
final class CompletionCommand implements Runnable {
    @Spec
    private CommandSpec spec;

    @Override
    public void run() {
        spec.commandLine()
                .getOut()
                .print(AutoComplete.bash(Version.PROGRAM, spec.root().commandLine()));
        spec.commandLine().getOut().flush();
    }
}
