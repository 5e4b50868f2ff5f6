import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.math.BigInteger;
import java.net.HttpURLConnection;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Comparator;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The small steps of setup.sh and gradlew that a POSIX shell has no portable word for. */
public final class Kit {
  private static final int TIMEOUT_MILLIS = 5_000;

  private Kit() {}

  /** Runs one step; exits 0 if it holds, 1 with a line on stderr if it does not. */
  public static void main(String[] args) throws Exception {
    boolean holds =
        switch (args[0]) {
          case "reachable" -> reachable(args[1]);
          case "folder" -> folder(args[1]);
          case "verify" -> verify(Path.of(args[1]), Path.of(args[2]));
          case "install" -> install(Path.of(args[1]), Path.of(args[2]));
          default -> throw new IllegalArgumentException(args[0]);
        };
    System.exit(holds ? 0 : 1);
  }

  /** Whether the file at {@code url} could be downloaded, behind its redirects. */
  private static boolean reachable(String url) {
    try {
      HttpURLConnection connection = (HttpURLConnection) new URL(url).openConnection();
      connection.setRequestMethod("HEAD");
      connection.setConnectTimeout(TIMEOUT_MILLIS);
      connection.setReadTimeout(TIMEOUT_MILLIS);
      return connection.getResponseCode() == HttpURLConnection.HTTP_OK;
    } catch (IOException e) {
      return false;
    }
  }

  /** Prints the name of the folder in which Gradle's wrapper looks for {@code url}'s contents. */
  private static boolean folder(String url) throws NoSuchAlgorithmException {
    byte[] md5 = MessageDigest.getInstance("MD5").digest(url.getBytes(StandardCharsets.UTF_8));
    System.out.println(new BigInteger(1, md5).toString(Character.MAX_RADIX));
    return true;
  }

  /** Whether {@code dir} holds exactly the files of the list, each with its SHA-256. */
  private static boolean verify(Path list, Path dir) throws Exception {
    TreeMap<String, String> found = new TreeMap<>();
    for (Path file : children(dir)) {
      found.put(file.getFileName().toString(), sha256(file));
    }
    TreeMap<String, String> wanted = new TreeMap<>();
    for (String line : Files.readAllLines(list)) {
      String[] sumAndName = line.split(" +", 2);
      wanted.put(sumAndName[1], sumAndName[0]);
    }
    if (found.equals(wanted)) {
      return true;
    }
    System.err.println("registry-only: the downloads are not the ones of " + list + ". Found:");
    found.forEach((name, sum) -> System.err.println(sum + "  " + name));
    return false;
  }

  /**
   * Moves the folder {@code staged} to {@code target} in one step, in place of what is there.
   *
   * <p>Where two do it at once both succeed: the second finds the first's folder and drops its own.
   */
  private static boolean install(Path staged, Path target) throws IOException {
    Files.createDirectories(target.getParent());
    Path old = staged.resolveSibling(staged.getFileName() + ".old");
    try {
      Files.move(target, old, StandardCopyOption.ATOMIC_MOVE);
    } catch (NoSuchFileException e) {
      // nothing was there, or another run has just moved it away
    }
    try {
      Files.move(staged, target, StandardCopyOption.ATOMIC_MOVE);
    } catch (FileSystemException e) {
      if (!Files.isDirectory(target)) {
        throw e;
      }
      delete(staged);
    }
    delete(old);
    return true;
  }

  private static String sha256(Path file) throws IOException, NoSuchAlgorithmException {
    MessageDigest digest = MessageDigest.getInstance("SHA-256");
    try (InputStream in = new DigestInputStream(Files.newInputStream(file), digest)) {
      in.transferTo(OutputStream.nullOutputStream());
    }
    return String.format("%064x", new BigInteger(1, digest.digest()));
  }

  private static List<Path> children(Path dir) throws IOException {
    try (Stream<Path> files = Files.list(dir)) {
      return files.collect(Collectors.toList());
    }
  }

  private static void delete(Path tree) throws IOException {
    if (!Files.exists(tree)) {
      return;
    }
    try (Stream<Path> paths = Files.walk(tree)) {
      for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    }
  }
}
