// A hub shrunk onto a hollow shaft: the section of a thin slice, x the radius and y the axis.
SetFactory("OpenCASCADE"); // which leaves the coinciding edges of the two bodies apart
DefineConstant[
  bore      = {30,  Name "Parameters/inner radius of the shaft"},
  fit       = {60,  Name "Parameters/radius of the fit"},
  rim       = {120, Name "Parameters/outer radius of the hub"},
  thickness = {10,  Name "Parameters/thickness of the slice"},
  n_shaft   = {3,   Name "Parameters/elements through the shaft"},
  n_hub     = {5,   Name "Parameters/elements through the hub"}
];

Rectangle(1) = {bore, 0, 0, fit - bore, thickness};
Rectangle(2) = {fit, 0, 0, rim - fit, thickness};
// The edges of a rectangle: bottom, right, top, left; then those of the second one.
Transfinite Curve{1, 3} = n_shaft + 1;
Transfinite Curve{5, 7} = n_hub + 1;
Transfinite Curve{2, 4, 6, 8} = 2;
Transfinite Surface{1, 2};
Recombine Surface{1, 2};
Physical Surface("shaft") = {1};
Physical Surface("hub") = {2};
Physical Curve("shaft_outer") = {2};
Physical Curve("hub_bore") = {8};
Physical Curve("foot") = {1, 5};
