package glint.android.apk;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.android.apksig.ApkVerifier;
import com.googlecode.d2j.reader.MultiDexFileReader;
import java.io.File;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The app's packages can be installed, and say what they are. */
class PackageTest {

  private static File apk(String type) {
    return new File(System.getProperty("glint.apk." + type));
  }

  @ParameterizedTest
  @ValueSource(strings = {"debug", "release"})
  void isSigned(String type) throws Exception {
    ApkVerifier.Result result = new ApkVerifier.Builder(apk(type)).build().verify();
    assertTrue(result.isVerified(), result.getErrors().toString());
    assertTrue(result.isVerifiedUsingV2Scheme());
    assertEquals(1, result.getSignerCertificates().size());
  }

  @ParameterizedTest
  @ValueSource(strings = {"debug", "release"})
  void isAligned(String type) throws IOException {
    int stored = 0;
    try (RandomAccessFile file = new RandomAccessFile(apk(type), "r")) {
      for (ZipIndex.Entry entry : ZipIndex.of(file)) {
        if (entry.isStored()) {
          assertEquals(0, entry.data() % 4, entry.name());
          stored++;
        }
      }
    }
    assertTrue(stored > 0);
  }

  private static String badging(String type) throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(
                System.getProperty("glint.aapt2"), "dump", "badging", apk(type).getPath())
            .redirectErrorStream(true)
            .start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), text);
    return text;
  }

  @ParameterizedTest
  @ValueSource(strings = {"debug", "release"})
  void saysWhatItIs(String type) throws Exception {
    String badging = badging(type);
    String version = System.getProperty("glint.version");
    assertContains(
        badging, "package: name='glint.android' versionCode='1' versionName='" + version);
    assertContains(badging, "minSdkVersion:'26'");
    assertContains(badging, "targetSdkVersion:'34'");
    assertContains(badging, "application: label='Glint' icon='res/");
    assertContains(badging, "launchable-activity: name='glint.android.MainActivity'");
    assertEquals(type.equals("debug"), badging.contains("application-debuggable"));
  }

  /** To write is asked for where Android is too old to do without; that implies to read there. */
  @Test
  void asksForNoMoreThanItNeeds() throws Exception {
    List<String> asked =
        badging("release")
            .lines()
            .filter(line -> line.startsWith("uses-permission:"))
            .collect(Collectors.toList());
    String write = "name='android.permission.WRITE_EXTERNAL_STORAGE' maxSdkVersion='28'";
    String read = "name='android.permission.READ_EXTERNAL_STORAGE' maxSdkVersion='28'";
    assertEquals(List.of("uses-permission: " + write, "uses-permission: " + read), asked);
  }

  private static void assertContains(String text, String part) {
    assertTrue(text.contains(part), "'" + part + "' is not in\n" + text);
  }

  @Test
  void theReleaseIsSmall() throws IOException {
    long assets = 0;
    try (ZipFile zip = new ZipFile(apk("release"))) {
      assets =
          zip.stream()
              .filter(entry -> entry.getName().startsWith("assets/"))
              .mapToLong(ZipEntry::getCompressedSize)
              .sum();
      assertTrue(assets > 0);
    }
    long code = apk("release").length() - assets;
    assertTrue(code < 1 << 20, "bytes without assets: " + code);
  }

  /** What the manifest and layouts name is found by Android, not by code that R8 sees. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "GlintApplication",
        "MainActivity",
        "RenderActivity",
        "SettingsActivity",
        "PictureView"
      })
  void theReleaseKeepsWhatResourcesName(String name) throws IOException {
    byte[] file = Files.readAllBytes(apk("release").toPath());
    List<String> classes = MultiDexFileReader.open(file).getClassNames();
    assertTrue(classes.contains("Lglint/android/" + name + ";"), classes.size() + " classes");
  }

  @Test
  void onlyScenesThatItListsArePacked() throws IOException {
    try (ZipFile zip = new ZipFile(apk("release"))) {
      assertTrue(zip.getEntry("assets/gallery.yaml") != null);
      assertTrue(zip.getEntry("assets/images/world.png") != null);
      assertFalse(zip.stream().anyMatch(entry -> entry.getName().startsWith("assets/analytic")));
    }
  }
}
