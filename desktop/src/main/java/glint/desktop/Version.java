package glint.desktop;

import java.io.IOException;
import java.io.InputStream;
import java.util.Properties;
import picocli.CommandLine.IVersionProvider;

/** The versions of Glint and of what it runs on. */
final class Version implements IVersionProvider {

  /** Returns the version of Glint, as the build wrote it into core. */
  static String glint() {
    try (InputStream in = Version.class.getResourceAsStream("/glint/version.properties")) {
      Properties properties = new Properties();
      if (in != null) {
        properties.load(in);
      }
      return properties.getProperty("version", "unknown");
    } catch (IOException e) {
      throw new IllegalStateException("cannot read the version: " + e.getMessage(), e);
    }
  }

  /** Returns the version of the running Java. */
  static String java() {
    return System.getProperty("java.version");
  }

  @Override
  public String[] getVersion() {
    return new String[] {
      "glint " + glint(),
      "Java " + java() + " (" + System.getProperty("java.vm.name") + ")",
      "kernel scalar"
    };
  }
}
