#include "common.inc"
global_settings { ambient_light rgb 0.9 }
Floor()
sphere { <-105, 105, 0>, 100 Glass(1.5) }
box { <-75, 5, -75>, <75, 155, 75> Glass(1.6) rotate 30*y translate <115, 0, 20> }
