#include "common.inc"
global_settings { ambient_light rgb 0.2 }
light_source { <-300, 700, 500>, rgb 0.8 }
Floor()
sphere { <40, 40, 170>, 40 Paint(<0.8, 0.3, 0.5>) }

// POV-Ray's shadow rays pass glass undimmed. Glint's law: each crossing lets through what is not reflected, at the angle on
// the outer side. Here that is done by a twin of the body that only shadow rays meet.
#macro Body(Shape, N)
    object { Shape Glass(N) #if (Law) no_shadow #end }
    #if (Law)
        object {
            Shape
            no_image no_reflection
            pigment {
                aoi
                color_map {
                    #for (I, 0, Steps)
                        [0.5 + 0.5 * I / Steps rgbt <1, 1, 1, 1 - Reflectance(1 / N, pi / 2 * (1 - I / Steps))>]
                    #end
                }
            }
        }
    #end
#end
Body(sphere { <-105, 105, 0>, 100 }, 1.5)
Body(box { <-75, 5, -75>, <75, 155, 75> rotate 30*y translate <115, 0, 20> }, 1.6)
