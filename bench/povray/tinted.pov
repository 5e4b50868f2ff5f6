#include "common.inc"
global_settings { ambient_light rgb 0.1 }
light_source { <-350, 700, 500>, rgb <0.6, 0.55, 0.5> }
light_source { <400, 600, 300>, rgb <0.25, 0.3, 0.35> }
Floor()
// A filter dims once at every crossing.
#macro Filter(C) pigment { rgbf <C.red, C.green, C.blue, 1> } interior { ior 1 } #end
// A dye fades by exp(-length*sigma): with fade_power 1001 the exponent is (1 - fade_color)*length/fade_distance.
#macro Dye(Sigma) pigment { rgbt 1 } interior { ior 1 fade_power 1001 fade_distance 1 fade_color rgb <1, 1, 1> - Sigma } #end
box { <-180, 10, -60>, <-60, 150, 40> Filter(rgb <0.95, 0.55, 0.3>) }
sphere { <0, 95, 110>, 60 Filter(rgb <0.5, 0.85, 0.6>) }
box { <60, 5, -80>, <190, 135, 40> Dye(<0.001, 0.008, 0.015>) rotate 15*y }
sphere { <170, 65, 150>, 55 Dye(<0.012, 0.003, 0.001>) }
