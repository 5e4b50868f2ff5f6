#include "common.inc"
global_settings { ambient_light rgb 0.9 }
Floor()
difference {
    sphere { <-60, 125, 0>, 120 }
    sphere { <-60, 125, 0>, 95 }
    Glass(1.5)
}
sphere { <-75, 115, 15>, 60 Glass(1.8) }
sphere { <140, 70, 60>, 65 Glass(1.33) }
