#include "common.inc"
global_settings { ambient_light rgb 0.1 }
light_source { <-350, 500, 600>, rgb 0.5 }
light_source { <450, 300, 300>, rgb <0.4, 0.35, 0.2> }
// `phong` is (r·v)^phong_size, Phong's lobe.
#macro Shiny(E) pigment { rgb <0.35, 0.25, 0.5> } finish { ambient 1 diffuse 1 phong 0.6 phong_size E } #end
Floor()
sphere { <-200, 66, 0>, 65 Shiny(1) }
sphere { <-65, 66, 0>, 65 Shiny(5) }
sphere { <70, 66, 0>, 65 Shiny(32) }
sphere { <205, 66, 0>, 65 Shiny(250) }
box { <-60, 0, 90>, <60, 30, 190> Shiny(20) }
cylinder { <-150, 5, 160>, <-90, 45, 160>, 30 Shiny(12) }
