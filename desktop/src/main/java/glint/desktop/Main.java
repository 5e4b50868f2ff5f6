package glint.desktop;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.AutoComplete.GenerateCompletion;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** The {@code glint} command. */
@Command(
    name = "glint",
    description = "Renders scenes by ray tracing.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    subcommands = {
      RenderCommand.class,
      PlanCommand.class,
      CheckCommand.class,
      CompareCommand.class,
      ReplayCommand.class,
      ReportCommand.class,
      VerifyCommand.class,
      WindowCommand.class,
      HelpCommand.class,
      GenerateCompletion.class
    },
    footer = {"", "Example: glint render scenes/gallery.yaml", "'glint COMMAND --help' says more."})
public final class Main implements Callable<Integer> {

  @Spec private CommandSpec spec;

  /** Runs the command and ends the process with its exit code. */
  public static void main(String[] args) {
    Locale.setDefault(Locale.ROOT);
    int exitCode =
        commandLine()
            .setOut(utf8(FileDescriptor.out))
            .setErr(utf8(FileDescriptor.err))
            .execute(args);
    System.exit(exitCode);
  }

  /** Returns the command, ready to execute; its output goes to the standard streams. */
  static CommandLine commandLine() {
    CommandLine glint = new CommandLine(new Main());
    glint.registerConverter(Path.class, Main::path);
    glint.setParameterExceptionHandler((e, args) -> explainUsage(e));
    glint.setExecutionExceptionHandler((e, command, result) -> explainFailure(e, command.getErr()));
    return glint;
  }

  /** Without a command the window opens with the bundled gallery. */
  @Override
  public Integer call() throws RunException, InterruptedException {
    return WindowCommand.open(List.of(), spec.commandLine().getErr());
  }

  private static Path path(String text) {
    if (text.isEmpty()) {
      throw new TypeConversionException("the name of a file or folder is empty");
    }
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw new TypeConversionException(Reasons.of(e));
    }
  }

  private static int explainUsage(ParameterException e) {
    CommandLine command = e.getCommandLine();
    command.getErr().println("glint: " + e.getMessage());
    UnmatchedArgumentException.printSuggestions(e, command.getErr());
    command.getErr().println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
    return ExitCode.USAGE;
  }

  private static int explainFailure(Throwable e, PrintWriter err) {
    err.println("glint: " + Reasons.of(e));
    Reasons.trace(e, err);
    return ExitCode.FAILED;
  }

  private static PrintWriter utf8(FileDescriptor stream) {
    return new PrintWriter(
        new OutputStreamWriter(new FileOutputStream(stream), StandardCharsets.UTF_8), true);
  }
}
