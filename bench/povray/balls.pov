#include "common.inc"
global_settings { ambient_light rgb 0.15 }
light_source { <-350, 500, 600>, rgb 0.5 }
light_source { <450, 300, 300>, rgb <0.4, 0.35, 0.2> }
Floor()
// Rows of balls, which hide and shadow each other.
#macro Row(Z, C)
    #for (I, 0, 6)
        sphere { <90 * I - 270, 36 + 10 * mod(I, 2), Z>, 35 Paint(C) }
    #end
#end
Row(-240, <0.35, 0.25, 0.50>)
Row(-120, <0.80, 0.30, 0.20>)
Row(0, <0.30, 0.60, 0.55>)
Row(120, <0.75, 0.70, 0.30>)
