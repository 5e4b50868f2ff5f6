#include "common.inc"
global_settings { ambient_light rgb 0.9 #if (Law) adc_bailout 3e-4 max_trace_level 16 #end }
Floor()
sphere { <-60, 125, 0>, 120 Glass(1.33) }
sphere {
    <-75, 115, 15>, 60
    Glass(1.7)
    // From a body into the one around it POV-Ray 3.7 reflects nothing, as if the indices were equal. Fresnel's law:
    #if (Law)
        interior_texture {
            aoi
            texture_map {
                #for (I, 0, Steps)
                    [0.5 + 0.5 * I / Steps
                        pigment { rgbt 1 }
                        finish { reflection { Reflectance(1.7 / 1.33, pi / 2 * (1 - I / Steps)) } conserve_energy }]
                #end
            }
        }
    #end
}
sphere { <140, 70, 60>, 65 Glass(1.5) }
