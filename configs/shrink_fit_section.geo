// The section of a disc with a hub on a solid shaft: x is the radius, y the axis of rotation. The plane y = 0 is the middle of
// the disc; the half above it is drawn. A relief groove in the face of the hub makes the end of the bore flexible.
SetFactory("OpenCASCADE"); // which leaves the coinciding curves of the two bodies apart
DefineConstant[
  fit       = {100, Name "Parameters/radius of the fit"},
  rim       = {300, Name "Parameters/outer radius of the disc"},
  web       = {25,  Name "Parameters/half of the width of the web; as wide as the hub is long: a plain disc"},
  hub       = {165, Name "Parameters/outer radius of the hub"},
  length    = {70,  Name "Parameters/half of the length of the hub"},
  fillet    = {15,  Name "Parameters/radius of the fillet between web and hub"},
  groove    = {15,  Name "Parameters/depth of the groove; 0: no groove"},
  lip       = {18,  Name "Parameters/thickness of the lip between bore and groove"},
  round     = {5,   Name "Parameters/radius of the bottom of the groove, half of its width"},
  shaft     = {180, Name "Parameters/half of the length of the shaft"},
  h         = {16,  Name "Parameters/element size"},
  h_fit     = {6,   Name "Parameters/element size at the bore of the disc and in the groove"}
];

// The shaft: rectangles under the hub and, if it is longer, beside it.
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
Transfinite Curve{1, -3} = Ceil(fit/h) + 1 Using Progression 0.85;
Transfinite Curve{2, 4} = Ceil(length/h_fit) + 1;
shafts[] = {1}; outer[] = {2};
If (shaft > length)
  Point(5) = {fit, shaft, 0};
  Point(6) = {0, shaft, 0};
  Line(5) = {3, 5};
  Line(6) = {5, 6};
  Line(7) = {6, 4};
  Curve Loop(2) = {-3, 5, 6, 7};
  Plane Surface(2) = {2};
  Transfinite Curve{-6} = Ceil(fit/h) + 1 Using Progression 0.85;
  Transfinite Curve{5, -7} = Ceil((shaft - length)/h) + 1 Using Progression 1.15;
  shafts[] += {2}; outer[] += {5};
EndIf
Transfinite Surface{shafts[]};
Recombine Surface{shafts[]};

// The disc, in triangles: its contour from the bore to the rim, back along the web to the face of the hub, and the groove.
Point(11) = {fit, 0, 0, h_fit};
Point(12) = {rim, 0, 0, 2*h};
Line(11) = {11, 12};
contour[] = {11};
If (web < length)
  Point(13) = {rim, web, 0, 2*h};
  Point(14) = {hub + fillet, web, 0, h};
  Point(15) = {hub + fillet, web + fillet, 0};
  Point(16) = {hub, web + fillet, 0, h};
  Point(17) = {hub, length, 0, h};
  Line(12) = {12, 13};
  Line(13) = {13, 14};
  Circle(14) = {14, 15, 16};
  Line(15) = {16, 17};
  contour[] += {12, 13, 14, 15};
Else
  Point(17) = {rim, length, 0, 2*h};
  Line(15) = {12, 17};
  contour[] += {15};
EndIf
Point(27) = {fit, length, 0, h_fit};
If (groove > 0)
  bottom = length - groove + round;
  Point(21) = {fit + lip + 2*round, length, 0, h_fit};
  Point(22) = {fit + lip + 2*round, bottom, 0, h_fit};
  Point(23) = {fit + lip + round, bottom, 0};
  Point(24) = {fit + lip + round, bottom - round, 0, h_fit};
  Point(25) = {fit + lip, bottom, 0, h_fit};
  Point(26) = {fit + lip, length, 0, h_fit};
  Line(21) = {17, 21};
  Line(22) = {21, 22};
  Circle(23) = {22, 23, 24};
  Circle(24) = {24, 23, 25};
  Line(25) = {25, 26};
  Line(26) = {26, 27};
  contour[] += {21, 22, 23, 24, 25, 26};
Else
  Line(21) = {17, 27};
  contour[] += {21};
EndIf
Line(31) = {27, 11};
Transfinite Curve{31} = Ceil(0.8*length/h_fit) + 1; // the divisions of the two bodies need not match
Curve Loop(31) = {contour[], 31};
Plane Surface(3) = {31};

Physical Surface("shaft") = {shafts[]};
Physical Surface("disc") = {3};
Physical Curve("shaft_outer") = {outer[]};
Physical Curve("disc_bore") = {31};
Physical Curve("middle") = {1, 11};
