#include "common.inc"
background { rgb <0.4, 0.5, 0.7> }
global_settings { ambient_light 0 }
camera { location <1.2, 1.6, 3.6> right -x*4/3 up y angle 2 * degrees(atan(4/3 * tan(radians(16)))) look_at <0, 0.95, 0> }
light_source { <3, 5, 2>, rgb 1 }
plane { y, 0 Paint(0.6) }
// The mesh, as `./gradlew :bench:peers` writes it.
object {
    #include "displaced-sphere.inc"
    Paint(1)
}
