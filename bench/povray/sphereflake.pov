#include "common.inc"
background { rgb <0.4, 0.5, 0.7> }
global_settings { ambient_light 0 }
camera { location <4, 4.5, 6> right -x*4/3 up y angle 2 * degrees(atan(4/3 * tan(radians(18)))) look_at <0, 1.7, 0> }
light_source { <5, 10, 6>, rgb 1 }
plane { y, 0 Paint(0.6) }
// Around the axis A of each ball six smaller ones at its middle and three above.
#macro Ball(C, R, A, Levels)
    sphere { C, R pigment { rgb <1, 0.9, 0.8> } finish { diffuse 0.4 reflection 0.6 } }
    #if (Levels > 1)
        #local U = vnormalize(vcross(A, (abs(A.x) < 0.6 ? x : y)));
        #local V = vcross(A, U);
        #for (I, 0, 8)
            #local Turn = radians(I < 6 ? 60 * I : 120 * I + 30);
            #local D = cos(Turn) * U + sin(Turn) * V;
            #if (I > 5) #local D = sqrt(1/3) * D + sqrt(2/3) * A; #end
            Ball(C + 4/3 * R * D, R / 3, D, Levels - 1)
        #end
    #end
#end
Ball(<0, 2, 0>, 1, y, 5)
