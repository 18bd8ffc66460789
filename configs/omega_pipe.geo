// The wall of a long pipe, half an axial section: x is the radius, y the axis of rotation.
DefineConstant[
  bore   = {120, Name "Parameters/inner radius"},
  rim    = {160, Name "Parameters/outer radius"},
  height = {5,   Name "Parameters/height of the slice"},
  n_wall = {8,   Name "Parameters/elements through the wall"}
];

Point(1) = {bore, 0, 0};
Point(2) = {rim, 0, 0};
Point(3) = {rim, height, 0};
Point(4) = {bore, height, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = n_wall + 1;
Transfinite Curve{2, 4} = 2;
Transfinite Surface{1};
Recombine Surface{1};

Physical Surface("pipe") = {1};
Physical Curve("bore") = {4};
Physical Curve("ends") = {1, 3};
