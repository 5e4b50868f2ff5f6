package glint.image;

import glint.color.Transfer;

/** Pairs of pictures made by integer formulas, so that another program can make the same. */
enum Patterns {
  /** A gradient with a slanted edge, under noise of ±20 codes. */
  NOISE(48, 40) {
    @Override
    int test(int x, int y, int c) {
      return clamp(scene(x, y, c) + hash(x, y, c) % 41 - 20);
    }

    @Override
    int reference(int x, int y, int c) {
      return clamp(scene(x, y, c));
    }
  },
  /** The same gradient, one pixel to the left. */
  SHIFT(48, 40) {
    @Override
    int test(int x, int y, int c) {
      return clamp(scene(x + 1, y, c));
    }

    @Override
    int reference(int x, int y, int c) {
      return clamp(scene(x, y, c));
    }
  },
  /** One white pixel on black. */
  FIREFLY(31, 27) {
    @Override
    int test(int x, int y, int c) {
      return x == 11 && y == 6 ? 255 : 0;
    }

    @Override
    int reference(int x, int y, int c) {
      return 0;
    }
  },
  /** Black and white tiles against grey. */
  CHECKER(33, 26) {
    @Override
    int test(int x, int y, int c) {
      return 255 * ((x / 3 + y / 4) % 2);
    }

    @Override
    int reference(int x, int y, int c) {
      return 128;
    }
  },
  /** Red against green. */
  HUE(24, 24) {
    @Override
    int test(int x, int y, int c) {
      return c == 0 ? 200 : 60;
    }

    @Override
    int reference(int x, int y, int c) {
      return c == 1 ? 200 : 60;
    }
  },
  /** Two constant greys. */
  GREY(24, 24) {
    @Override
    int test(int x, int y, int c) {
      return 153;
    }

    @Override
    int reference(int x, int y, int c) {
      return 128;
    }
  },
  /** Colour noise as small as the SSIM window. */
  CORNER(12, 11) {
    @Override
    int test(int x, int y, int c) {
      return hash(x, y, c);
    }

    @Override
    int reference(int x, int y, int c) {
      return hash(x + 5, y, c);
    }
  },
  /** Colour noise smaller than all filters. */
  TINY(5, 4) {
    @Override
    int test(int x, int y, int c) {
      return hash(x, y, c);
    }

    @Override
    int reference(int x, int y, int c) {
      return hash(y, x, c);
    }
  };

  final int width;
  final int height;

  Patterns(int width, int height) {
    this.width = width;
    this.height = height;
  }

  abstract int test(int x, int y, int c);

  abstract int reference(int x, int y, int c);

  Image testImage() {
    return image(width, height, this::test);
  }

  Image referenceImage() {
    return image(width, height, this::reference);
  }

  ImagePair pair() {
    return new ImagePair(testImage(), referenceImage());
  }

  /** The eight-bit sRGB code of a channel of a pixel. */
  interface Codes {
    int at(int x, int y, int c);
  }

  /** Returns the linear image of these codes. */
  static Image image(int width, int height, Codes codes) {
    Image image = new Image(width, height);
    for (int i = 0; i < image.rgb().length; i++) {
      int pixel = i / 3;
      int code = codes.at(pixel % width, pixel / width, i % 3);
      image.rgb()[i] = Transfer.SRGB.decode(code / 255.0);
    }
    return image;
  }

  private static int scene(int x, int y, int c) {
    if (2 * x + y < 50) {
      return switch (c) {
        case 0 -> 40 + 2 * x + y;
        case 1 -> 200 - 3 * y;
        default -> 30 + x * y % 64;
      };
    }
    return switch (c) {
      case 0 -> 220 - x;
      case 1 -> 60 + 3 * x;
      default -> 90 + 4 * y;
    };
  }

  private static int hash(int x, int y, int c) {
    return (x * 7919 + y * 104729 + c * 15485 + x * y * 31) % 251;
  }

  private static int clamp(int code) {
    return Math.max(0, Math.min(255, code));
  }
}
