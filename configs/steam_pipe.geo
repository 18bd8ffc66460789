// A sector of a thick-walled pipe, from a plane of symmetry (z = 0) to a free end, meshed with hexahedra.
DefineConstant[
  bore     = {120, Name "Parameters/inner radius"},
  rim      = {160, Name "Parameters/outer radius"},
  angle    = {10,  Name "Parameters/angle of the sector in degrees"},
  length   = {400, Name "Parameters/distance of the end from the plane of symmetry"},
  n_wall   = {8,   Name "Parameters/elements through the wall"},
  n_around = {2,   Name "Parameters/elements around the sector"},
  n_length = {10,  Name "Parameters/elements along the pipe"}
];

c = Cos(angle*Pi/180); s = Sin(angle*Pi/180);
Point(1) = {0, 0, 0};
Point(2) = {bore, 0, 0};
Point(3) = {rim, 0, 0};
Point(4) = {rim*c, rim*s, 0};
Point(5) = {bore*c, bore*s, 0};
Line(1) = {2, 3};
Circle(2) = {3, 1, 4};
Line(3) = {5, 4};
Circle(4) = {2, 1, 5};
Curve Loop(1) = {1, 2, -3, -4};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = n_wall + 1;
Transfinite Curve{2, 4} = n_around + 1;
Transfinite Surface{1};
Recombine Surface{1};
// out[]: top, volume, then the sides of the curves 1, 2, 3, 4
out[] = Extrude {0, 0, length} { Surface{1}; Layers{n_length}; Recombine; };

Physical Volume("pipe") = {out[1]};
Physical Surface("bore") = {out[5]};
Physical Surface("rim") = {out[3]};
Physical Surface("cuts") = {out[2], out[4]};
Physical Surface("middle") = {1};
Physical Surface("end") = {out[0]};
