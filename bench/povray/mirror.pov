#include "common.inc"
global_settings { ambient_light rgb 0.06 }
light_source { <40, 240, 60>, rgb 0.3 }
#macro Wall(C) pigment { rgb C } finish { ambient 1 diffuse 0.4 reflection 0.75 } #end
// A box of mirrors around the eye.
box { <-250, -20, -250>, <250, 0, 750> Wall(<0.7, 0.7, 0.6>) }
box { <-250, 280, -250>, <250, 300, 750> Wall(<0.5, 0.5, 0.6>) }
box { <-270, 0, -250>, <-250, 280, 750> Wall(<0.8, 0.3, 0.2>) }
box { <250, 0, -250>, <270, 280, 750> Wall(<0.2, 0.6, 0.3>) }
box { <-250, 0, -270>, <250, 280, -250> Wall(<0.3, 0.4, 0.8>) }
box { <-250, 0, 750>, <250, 280, 770> Wall(<0.6, 0.6, 0.6>) }
sphere { <-80, 80, 0>, 80 Wall(<0.9, 0.8, 0.5>) }
box { <-60, 0, -60>, <60, 120, 60> Paint(<0.6, 0.5, 0.4>) rotate 35*y translate <120, 0, 60> }
