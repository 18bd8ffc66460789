SetFactory("OpenCASCADE"); // which leaves the coinciding points and lines of shaft and ring apart

DefineConstant[ h = {10, Name "Parameters/element size"} ];
bore = 40; fit = 70; rim = 130; half_width = 60;

Point(1) = {bore, 0, 0};
Point(2) = {fit, 0, 0};
Point(3) = {fit, 0, 0};
Point(4) = {rim, 0, 0};
Line(1) = {1, 2};
Line(2) = {3, 4};
Transfinite Curve{1} = Ceil((fit - bore)/h) + 1;
Transfinite Curve{2} = Ceil((rim - fit)/h) + 1;
shaft[] = Extrude {0, half_width, 0} { Curve{1}; Layers{Ceil(half_width/h)}; Recombine; };
ring[] = Extrude {0, half_width, 0} { Curve{2}; Layers{Ceil(half_width/h)}; Recombine; };

Physical Surface("shaft") = {shaft[1]};
Physical Surface("ring") = {ring[1]};
Physical Curve("bore") = {shaft[2]};
Physical Curve("shaft_outer") = {shaft[3]};
Physical Curve("ring_bore") = {ring[2]};
Physical Curve("rim") = {ring[3]};
Physical Curve("middle") = {1, 2};
