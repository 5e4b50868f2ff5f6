package glint.io;

import java.nio.charset.StandardCharsets;
import java.util.Random;

/**
 * Good files, and what damages them: a few pieces deleted, repeated, or replaced by what readers
 * stumble over.
 */
enum Damage {
  SCENES(Resources.text("everything.yaml"), Baits.YAML),
  PAGE(SceneFormatDocTest.example(), Baits.YAML),
  COURSE(Good.COURSE, Baits.YAML),
  MODEL(Good.MODEL, Baits.MODEL),
  LIBRARY(Good.LIBRARY, Baits.MODEL),
  SCENE_OF_MODEL(Good.SCENE_OF_MODEL, Baits.YAML);

  private final String good;
  private final String[] baits;

  Damage(String good, String[] baits) {
    this.good = good;
    this.baits = baits;
  }

  /** Returns the file as it was. */
  byte[] good() {
    return good.getBytes(StandardCharsets.UTF_8);
  }

  /** Returns the file with the damage that is drawn. */
  byte[] draw(Random random) {
    StringBuilder text = new StringBuilder(good);
    int times = 1 + random.nextInt(4);
    for (int i = 0; i < times && text.length() > 0; i++) {
      int from = random.nextInt(text.length());
      int to = Math.min(text.length(), from + 1 + random.nextInt(12));
      String bait = baits[random.nextInt(baits.length)];
      switch (random.nextInt(6)) {
        case 0 -> text.delete(from, to);
        case 1 -> text.insert(from, bait);
        case 2 -> text.replace(from, to, bait);
        case 3 -> text.insert(random.nextInt(text.length()), text.substring(from, to));
        case 4 -> text.setCharAt(from, (char) (1 + random.nextInt(300)));
        default -> text.setLength(random.nextInt(20) == 0 ? from : text.length());
      }
    }
    boolean wide = random.nextInt(20) == 0;
    String marked = wide ? "\uFEFF" + text : text.toString();
    byte[] bytes = marked.getBytes(wide ? StandardCharsets.UTF_16LE : StandardCharsets.UTF_8);
    if (random.nextInt(20) == 0 && bytes.length > 0) {
      bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
    }
    return bytes;
  }

  private static final class Baits {

    static final String[] YAML =
        ("&a ¦*a¦<<: *a¦[¦]¦{¦}¦: ¦- ¦? ¦\t¦\n¦\r¦\0¦#¦\"¦'¦|¦>¦!¦!!float ¦"
                + "%YAML 1.1\n---\n¦---\n¦...\n¦1e999¦-1¦.nan¦.inf¦0x10¦~¦yes¦\u2028¦\uFEFF¦ü¦"
                + "\uD83D\uDE00¦99999999999999999999¦[[[[[[[[[[¦{a: {a: {a: ¦&b [*b]¦\\U¦"
                + "transparency¦sphere¦NaN¦PopMatrix\n")
            .split("¦");

    static final String[] MODEL =
        ("f ¦v ¦\n¦\r¦\r\n¦\\\n¦\\¦#¦/¦//¦-¦+¦.¦,¦e¦e999¦nan¦inf¦1.#INF¦0¦-1¦-6¦99¦"
                + "2147483648¦-2147483649¦1e308¦1e-400¦\0¦\u001A¦\t¦\f¦\u00A0¦ü¦\uFEFF¦"
                + "\uD83D\uDE00¦v 1e200 0 0\n¦f 1 2 3 4 5 4 3 2\n¦f 1 1 1 1\n¦f 7 8 9\n¦curv 0 1\n¦"
                + "vn\n¦0.00000000000000000001¦usemtl ¦usemtl red\n¦mtllib a.mtl\n¦mtllib ¦newmtl ¦"
                + "Kd ¦d 2\n¦illum 7\n¦illum 99\n¦map_Kd -s 1 ¦-clamp on¦Ni 0\n")
            .split("¦");
  }

  private static final class Good {

    static final String COURSE =
        """
        Camera 0 0 40  0 1 0  0 0 9.9  36.5 1
        Output 512 512 CornellBox.png
        BounceDepth 1
        ShadowBias 0.005
        AmbientLight 0.05 0.05 0.05
        PushMatrix
        Rotate 10 20 30
        PointLight 0 9 0  1 1 1
        DirectionalLight 0 -1 0  1 1 1
        Material 1 1 1  0.8 0.8 0.8  0 0 0  0 0 0  0
        Translate 1 2 3
        Scale 1 2 1
        Triangle -10 -10 10  10 -10 -10  -10 -10 -10
        PopMatrix
        Sphere 5 -6 1 4
        """;

    static final String MODEL =
        """
        # a bit of everything
        mtllib a.mtl
        o thing
        v 0 0 0
        v 1.5 -2.5e-1 .25 1.0
        v 1 1 0 0.5 0.5 0.5
        v 0 1 1e-3
        v 2 2 2
        vt 0 0
        vn 0 0 1
        usemtl red
        s 1
        f 1 2 3
        f 1/1 2/1 3/1 4/1
        f 1//1 2//1 \\
        3//1
        f -5/-1/-1 -4/-1/-1 -3/-1/-1 -2/-1/-1 -1/-1/-1 # five
        p 1
        l 1 2
        f 1 3 2 4 5 3
        """;

    static final String LIBRARY =
        """
        # of all kinds
        newmtl red
        Ka 0.1 0.1 0.1
        Kd 0.8 0.2 .1
        Ks 0.5
        Ns 96.1
        Ke 0 0 0
        d 0.9
        Tr 0.1
        Tf 1 1 1
        Ni 1.5
        illum 7
        map_Kd -s 2 2 -o .5 -clamp on red paint.png
        map_Bump -bm 1 b.png
        newmtl blue sky \\
          above
        Kd 0 0 1
        illum 2
        newmtl Material #25
        Kd .5
        d .5
        """;

    static final String SCENE_OF_MODEL =
        """
        materials: {gold: {color: [1, 0.7, 0], reflection: 0.1}}
        scenes:
          one:
            camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}
            surfaces:
              - mesh: {file: a.obj}
              - mesh: {file: a.obj, smooth: 60, scale: 2, material: gold}
          two:
            camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}
            surfaces:
              - mesh: {file: a.obj, rotate: {axis: [0, 1, 0], degrees: 30}}
        """;
  }
}
