#include "common.inc"
global_settings { ambient_light rgb 0.9 }
Floor()
// Media, not fade_distance: that forgets what is reflected inside.
#macro Liquid(N, Sigma)
    hollow
    pigment { rgbt 1 }
    finish { reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior N media { absorption rgb Sigma } }
#end
cylinder { <-90, 5, 0>, <-90, 175, 0>, 90 Liquid(1.33, <0.001, 0.006, 0.015>) }
box { <-60, 5, -60>, <60, 125, 60> Liquid(1.5, <0.012, 0.004, 0.002>) rotate 20*y translate <125, 0, 60> }
