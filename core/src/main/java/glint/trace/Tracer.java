package glint.trace;

import glint.accel.Intersector;
import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.light.LampSight;
import glint.optics.Fresnel;
import glint.optics.Material;
import glint.optics.Medium;
import glint.sampling.GlossyLobe;
import glint.sampling.SobolSampler;
import glint.scene.Background;
import glint.scene.Prepared;
import glint.scene.RenderPlan;
import glint.trace.RayTree.Reason;
import java.util.ArrayList;
import java.util.List;

/**
 * Computes the radiance that a ray brings back, after Whitted (1980); one per worker.
 *
 * <p>The model is written down in docs/shading.md. Everything mutable in here is scratch that is
 * used again for every ray.
 */
public final class Tracer {

  /** In a signature: nothing was met. */
  private static final long SKY = -1;

  /** In a signature: the first light of an area was met. */
  private static final long LAMP = -2;

  /** Added to the number of a ray: the pair of numbers that chooses its mirror image. */
  private static final long GLOSS = -2;

  /** Turns the number of a ray in its tree into that of its mirror image. */
  private static final long MIRRORED = 0x9e3779b97f4a7c15L;

  /** The same for what goes through. */
  private static final long THROUGH = 0xc2b2ae3d27d4eb4fL;

  private final Prepared scene;
  private final RenderPlan plan;
  private final int maxDepth;
  private final double least;

  private final Intersector intersector;
  private final RayCounts counts = new RayCounts();
  private final Hit hit = new Hit();
  private final Boundary boundary;
  private final Signature signature = new Signature();
  private final DirectLight direct;
  private final StartMedia start;
  private final LampSight lamps;

  /** Numbers of rays that leave nothing to chance. */
  private final SobolSampler centre = new SobolSampler(0);

  private SobolSampler numbers = centre;
  private final GlossyLobe lobe = new GlossyLobe();

  /** Is told of every ray; null unless somebody asks. */
  private final Recorder recorder;

  private final List<Frame> frames = new ArrayList<>();

  /** The radiance found by the last call of {@link #trace}, linear. */
  public double r;

  public double g;
  public double b;

  /** Whether the ray at work ends at a lamp. */
  private boolean shines;

  /** A bound, in any channel, on the radiance that the last call of {@link #trace} left out. */
  public double cut;

  /** What the last camera ray met first: the number of a surface, {@link #lamp}, or -1. */
  public int first;

  /** Whether the next calls of {@link #trace} find out about {@link #veil}. */
  public boolean watchesShadows;

  /** What shadows keep from where the last camera ray ends, if that was to be found out. */
  public final Veil veil = new Veil();

  /** Whether the next calls of {@link #trace} find out about {@link #sight}. */
  public boolean watchesSight;

  /** How the last camera ray saw what it met, if that was to be found out. */
  public final Sight sight = new Sight();

  /** The image on what the last camera ray met first, if there is one and the plan knows of any. */
  public final Print print = new Print();

  /** Makes a tracer that tells nobody. */
  public Tracer(Prepared scene, int maxDepth, double negligible) {
    this(scene, maxDepth, negligible, null);
  }

  /**
   * Makes a tracer of its own scratch.
   *
   * @param maxDepth the most successive bounces
   * @param negligible the radiance below which a bounce is not followed
   * @param recorder is told of every ray, if not null
   */
  public Tracer(Prepared scene, int maxDepth, double negligible, Recorder recorder) {
    this.scene = scene;
    this.recorder = recorder;
    this.plan = scene.plan();
    this.intersector = scene.intersector();
    this.maxDepth = maxDepth;
    // Where radiance has no bound, a ray is given up as if display white were the most it brings.
    double bound = scene.radianceBound();
    this.least = negligible / (bound < Double.POSITIVE_INFINITY ? bound : 1);
    boundary = new Boundary(scene, intersector);
    direct = new DirectLight(scene, intersector, counts, signature, recorder);
    start = new StartMedia(scene, intersector);
    lamps = new LampSight(scene.lights());
  }

  /**
   * Returns what the last call of {@link #trace} met, in one number: rays of equal numbers met the
   * same faces in the same light.
   */
  public long signature() {
    return signature.value();
  }

  /**
   * Returns where in the images that it met the last call of {@link #trace} looked, in pixels, but
   * for the {@link #print}.
   */
  public double imageX() {
    return signature.x();
  }

  /** Returns the same upwards. */
  public double imageY() {
    return signature.y();
  }

  /** Returns the rays traced so far. */
  public RayCounts counts() {
    return counts;
  }

  /**
   * Traces a camera ray that leaves nothing to chance.
   *
   * @param ray of unit direction
   * @param tMax where the far clipping plane ends it
   */
  public void trace(Ray ray, double tMax) {
    centre.centre();
    trace(ray, tMax, centre);
  }

  /**
   * Traces a camera ray and leaves its radiance in {@link #r}, {@link #g} and {@link #b}.
   *
   * @param ray of unit direction
   * @param tMax where the far clipping plane ends it
   * @param sample decides what is left to chance
   */
  public void trace(Ray ray, double tMax, SobolSampler sample) {
    numbers = sample;
    r = 0;
    g = 0;
    b = 0;
    cut = 0;
    first = -1;
    signature.clear();
    veil.clear();
    sight.clear();
    print.clear();
    counts.camera++;
    Frame f = frame(0);
    f.ray.copy(ray);
    f.begin(tMax, 1, 1, 1);
    f.pencil = scene.pencils().fromEye();
    f.gain = 1;
    f.from = ray.tMin;
    f.path = 0;
    f.interior.clear();
    if (plan.refraction().used()) {
      start.find(ray, f.interior);
    }
    follow(0, 0);
  }

  /**
   * Finds what a camera ray sees first, without shading it.
   *
   * @return the hit, resolved and facing the ray if it was found
   */
  public Hit look(Ray ray, double tMax) {
    counts.camera++;
    intersector.closest(ray, tMax, scene.pencils().fromEye(), hit);
    if (hit.found()) {
      intersector.resolve(ray, hit);
      scene.face(ray, hit);
    }
    return hit;
  }

  /** Follows a ray and then its mirror image, again and again; what is refracted goes deeper. */
  private void follow(int level, int bounces) {
    Frame f = frame(level);
    for (int depth = bounces; ; depth++) {
      counts.maxDepth = Math.max(counts.maxDepth, depth);
      if (recorder != null) {
        recorder.follows(f, level, depth, depth > bounces);
      }
      if (!advance(f)) {
        first = shines && level + depth == 0 ? lamp(lamps.light()) : first;
        addEnd(f);
        return;
      }
      signature.add(hit, boundary.surface);
      first = level + depth == 0 ? boundary.surface : first;
      Material material = scene.material(boundary.surface);
      if (watchesSight) {
        sight.meet(hit, material);
      }
      direct.veil = watchesShadows && level + depth == 0 ? veil : null;
      direct.print = plan.images().used() && level + depth == 0 ? print : null;
      direct.find(boundary.surface, hit, f.ray, f.interior, numbers, f.path);
      if (direct.print != null && print.found) {
        print.end(direct.pattern, f.weightR, f.weightG, f.weightB);
      }
      add(f, direct.r, direct.g, direct.b);
      if (boundary.opaque && !plan.mirrors().used()) {
        return;
      }
      // A surface that passes on more than it gets would double its rays at every bounce for ever.
      f.gain *= Math.max(1, material.reflection().max() + material.transparency().max());
      double share = 0;
      boolean refracts = false;
      int deeper = depth + 1;
      if (!boundary.opaque) {
        share = refract(f, frame(level + 1), material.transparency());
        deeper = boundary.eta == 1 ? depth : depth + 1; // straight on is no bounce
        refracts = share < 1 && matters(frame(level + 1), deeper);
      }
      Rgb mirror = material.reflection();
      Rgb fresnel = material.transparency();
      f.weightR *= mirror.r() + share * fresnel.r();
      f.weightG *= mirror.g() + share * fresnel.g();
      f.weightB *= mirror.b() + share * fresnel.b();
      boolean reflects = matters(f, depth + 1);
      signature.add((reflects ? 1 : 0) + (refracts ? 2 : 0));
      if (reflects) {
        if (watchesSight) {
          sight.reflect(hit, boundary.surface);
        }
        reflect(f, material.gloss());
      }
      if (refracts) {
        counts.refraction++;
        follow(level + 1, deeper);
      }
      if (!reflects) {
        return;
      }
    }
  }

  /** Returns what {@link #first} is where a lamp is met, by the number of its light. */
  public static int lamp(int light) {
    return -2 - light;
  }

  /** Goes to the next surface that is seen; returns whether there is one before any lamp. */
  private boolean advance(Frame f) {
    while (true) {
      shines = plan.lamps().used() && lamps.find(f.ray, f.end);
      intersector.closest(f.ray, shines ? lamps.t() : f.end, f.pencil, hit);
      if (!hit.found()) {
        absorb(f, shines ? lamps.t() : Double.POSITIVE_INFINITY);
        return false;
      }
      intersector.resolve(f.ray, hit);
      scene.face(f.ray, hit);
      if (!plan.refraction().used()) {
        boundary.surface = hit.surface;
        boundary.opaque = true;
        tellMeeting(f);
        return true;
      }
      f.interior.complete(hit);
      double t = hit.t;
      boundary.meet(f.ray, f.end, hit, f.interior);
      tellMeeting(f);
      if (boundary.opaque || boundary.visible) {
        absorb(f, t);
        return true;
      }
      f.interior.copy(boundary.beyond);
    }
  }

  private void tellMeeting(Frame f) {
    if (recorder != null) {
      Medium before = scene.medium(f.interior.current());
      Medium beyond = scene.medium(boundary.beyond.current());
      recorder.meets(f.ray, hit, boundary, before, beyond);
    }
  }

  /** Fades the ray, by Beer and Lambert's law, from where that was last done up to a parameter. */
  private void absorb(Frame f, double t) {
    Medium medium = scene.medium(f.interior.current());
    if (medium.absorbs()) {
      f.weightR *= medium.transmission(medium.absorption().r(), t - f.from);
      f.weightG *= medium.transmission(medium.absorption().g(), t - f.from);
      f.weightB *= medium.transmission(medium.absorption().b(), t - f.from);
    }
    f.from = t;
  }

  /** Adds the lamp that a ray ends at, or the background. */
  private void addEnd(Frame f) {
    if (!shines) {
      signature.add(SKY);
      addBackground(f);
      return;
    }
    signature.add(LAMP - lamps.light());
    if (recorder != null) {
      recorder.meets(scene.lights().number(lamps.light()));
    }
    Rgb radiance = lamps.radiance();
    add(f, radiance.r(), radiance.g(), radiance.b());
  }

  private void addBackground(Frame f) {
    Background sky = scene.scene().background();
    Rgb up = sky.up();
    if (!plan.sky().used()) {
      add(f, up.r(), up.g(), up.b());
      return;
    }
    Rgb down = sky.down();
    double s = (1 + f.ray.dy) / 2;
    add(
        f,
        down.r() + s * (up.r() - down.r()),
        down.g() + s * (up.g() - down.g()),
        down.b() + s * (up.b() - down.b()));
  }

  /** Adds what a ray sees at its end. */
  private void add(Frame f, double seenR, double seenG, double seenB) {
    r += f.weightR * seenR;
    g += f.weightG * seenG;
    b += f.weightB * seenB;
    if (recorder != null) {
      recorder.sees(f, seenR, seenG, seenB);
    }
  }

  /** Returns whether a ray is worth following; if not, what it could bring is cut off. */
  private boolean matters(Frame f, int depth) {
    double weight = Math.max(f.weightR, Math.max(f.weightG, f.weightB));
    if (weight > least * f.gain && depth <= maxDepth) {
      return true;
    }
    if (weight > 0) {
      double missing = weight * scene.radianceBound();
      cut += missing;
      if (recorder != null) {
        recorder.cuts(f, depth, depth > maxDepth ? Reason.DEPTH : Reason.CONTRIBUTION, missing);
      }
    }
    return false;
  }

  /**
   * Sets a frame's ray to its mirror image about the normal, from the hit, or one close to that.
   */
  private void reflect(Frame f, double gloss) {
    Ray ray = f.ray;
    double twice = 2 * (ray.dx * hit.sx + ray.dy * hit.sy + ray.dz * hit.sz);
    double dx = ray.dx - twice * hit.sx;
    double dy = ray.dy - twice * hit.sy;
    double dz = ray.dz - twice * hit.sz;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    if (plan.gloss().used() && gloss < Double.POSITIVE_INFINITY) {
      numbers.draw(f.path + GLOSS);
      lobe.spread(dx / length, dy / length, dz / length, gloss, numbers.u, numbers.v);
      hit.spawn(lobe.x(), lobe.y(), lobe.z(), 1, ray);
    } else {
      hit.spawn(dx / length, dy / length, dz / length, 1, ray);
    }
    f.begin(Double.POSITIVE_INFINITY, f.weightR, f.weightG, f.weightB);
    f.from = plan.refraction().used() ? -hit.lead(ray) : 0;
    f.path = (f.path + 1) * MIRRORED;
    counts.reflection++;
  }

  /**
   * Sets a deeper frame to what goes through the boundary, bent by Snell's law.
   *
   * @return the share that is reflected by Fresnel's law; if it is 1, nothing goes through
   */
  private double refract(Frame f, Frame through, Rgb transparency) {
    Ray ray = f.ray;
    double eta = boundary.eta;
    double cosIn = -(ray.dx * hit.sx + ray.dy * hit.sy + ray.dz * hit.sz);
    cosIn = Math.min(Math.max(cosIn, 0), 1);
    // What will run along the surface, of length sin t: it has more digits than cos i leaves.
    double tx = eta * (ray.dx + cosIn * hit.sx);
    double ty = eta * (ray.dy + cosIn * hit.sy);
    double tz = eta * (ray.dz + cosIn * hit.sz);
    double cosOut = Fresnel.cosine(tx * tx + ty * ty + tz * tz);
    double share = Fresnel.reflectance(cosIn, cosOut, eta);
    if (recorder != null) {
      recorder.splits(share);
    }
    if (share == 1) {
      return 1;
    }
    through.interior.copy(boundary.beyond);
    through.gain = f.gain;
    through.path = (f.path + 1) * THROUGH;
    double rest = 1 - share;
    double wr = f.weightR * transparency.r() * rest;
    double wg = f.weightG * transparency.g() * rest;
    double wb = f.weightB * transparency.b() * rest;
    if (eta == 1) { // straight on, on the very same line
      through.ray.copy(ray);
      through.begin(f.end, wr, wg, wb);
      through.pencil = f.pencil;
      through.from = f.from;
      return share;
    }
    double dx = tx - cosOut * hit.sx;
    double dy = ty - cosOut * hit.sy;
    double dz = tz - cosOut * hit.sz;
    hit.spawn(dx, dy, dz, -1, through.ray);
    through.begin(Double.POSITIVE_INFINITY, wr, wg, wb);
    through.from = -hit.lead(through.ray);
    if (boundary.several) { // what coincides here is crossed already
      through.ray.tMin = hit.clearance(through.ray);
    }
    return share;
  }

  /** Returns the frame of a level, made when it is first needed. */
  private Frame frame(int level) {
    while (frames.size() <= level) {
      frames.add(new Frame(scene));
    }
    return frames.get(level);
  }
}
