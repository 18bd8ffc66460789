// The section of a plain disc on a solid shaft: x is the radius, y the axis of rotation. The plane y = 0 is the middle of the
// disc; the half above it is drawn.
SetFactory("OpenCASCADE"); // which leaves the coinciding curves of the two bodies apart
DefineConstant[
  fit    = {100, Name "Parameters/radius of the fit"},
  rim    = {350, Name "Parameters/outer radius of the disc"},
  length = {30,  Name "Parameters/half of the width of the disc"},
  shaft  = {30,  Name "Parameters/half of the length of the shaft, at least that of the disc"},
  n      = {24,  Name "Parameters/elements along the radius of the disc"}
];
Point(1) = {0, 0, 0};
Point(2) = {fit, 0, 0};
Point(3) = {fit, length, 0};
Point(4) = {0, length, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = Ceil(n/3) + 1;
Transfinite Curve{2, 4} = Ceil(n/6) + 1;
shafts[] = {1}; outer[] = {2};
If (shaft > length)
  Point(5) = {fit, shaft, 0};
  Point(6) = {0, shaft, 0};
  Line(5) = {3, 5};
  Line(6) = {5, 6};
  Line(7) = {6, 4};
  Curve Loop(2) = {-3, 5, 6, 7};
  Plane Surface(2) = {2};
  Transfinite Curve{6} = Ceil(n/3) + 1;
  Transfinite Curve{5, 7} = Ceil(n/6*(shaft - length)/length) + 1;
  shafts[] += {2}; outer[] += {5};
EndIf

Point(11) = {fit, 0, 0};
Point(12) = {rim, 0, 0};
Point(13) = {rim, length, 0};
Point(14) = {fit, length, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Curve Loop(11) = {11, 12, 13, 14};
Plane Surface(11) = {11};
Transfinite Curve{11, -13} = n + 1 Using Progression 1.06;
Transfinite Curve{12, 14} = Ceil(n/6) + 1;
Transfinite Surface{shafts[], 11};
Recombine Surface{shafts[], 11};

Physical Surface("shaft") = {shafts[]};
Physical Surface("disc") = {11};
Physical Curve("shaft_outer") = {outer[]};
Physical Curve("disc_bore") = {14};
Physical Curve("middle") = {1, 11};
