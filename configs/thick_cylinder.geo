// A narrow sector of a slice of a thick-walled cylinder, meshed with hexahedra.
DefineConstant[
  bore      = {100, Name "Parameters/inner radius"},
  rim       = {200, Name "Parameters/outer radius"},
  angle     = {10,  Name "Parameters/angle of the sector in degrees"},
  thickness = {5,   Name "Parameters/thickness of the slice"},
  n_wall    = {20,  Name "Parameters/elements through the wall"},
  n_around  = {4,   Name "Parameters/elements around the sector"}
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
out[] = Extrude {0, 0, thickness} { Surface{1}; Layers{1}; Recombine; };

Physical Volume("wall") = {out[1]};
Physical Surface("bore") = {out[5]};
Physical Surface("rim") = {out[3]};
Physical Surface("cuts") = {out[2], out[4]};
Physical Surface("ends") = {1, out[0]};
