// Axial section of two rings, one shrunk onto the other: a thin slice that is free to expand along the axis, so that it is in
// plane stress but for its own temperature. x is the radius and y the axis.
SetFactory("OpenCASCADE"); // which leaves the coinciding points and lines of the two rings apart
DefineConstant[
  bore      = {30,  Name "Parameters/inner radius of the inner ring"},
  fit       = {60,  Name "Parameters/radius of the fit"},
  rim       = {120, Name "Parameters/outer radius of the outer ring"},
  thickness = {4,   Name "Parameters/thickness of the slice"},
  n_inner   = {6,   Name "Parameters/elements through the inner ring"},
  n_outer   = {10,  Name "Parameters/elements through the outer ring"}
];
// Points 2 and 3 have the same position but are two points, or the rings would be one body.
Point(1) = {bore, 0, 0};
Point(2) = {fit, 0, 0};
Point(3) = {fit, 0, 0};
Point(4) = {rim, 0, 0};
Line(1) = {1, 2};
Line(2) = {3, 4};
Transfinite Curve{1} = n_inner + 1;
Transfinite Curve{2} = n_outer + 1 Using Progression 1.1;
inner[] = Extrude {0, thickness, 0} { Curve{1}; Layers{1}; Recombine; };
outer[] = Extrude {0, thickness, 0} { Curve{2}; Layers{1}; Recombine; };

Physical Surface("inner") = {inner[1]};
Physical Surface("outer") = {outer[1]};
Physical Curve("bore") = {inner[2]};
Physical Curve("inner_fit") = {inner[3]};
Physical Curve("outer_fit") = {outer[2]};
Physical Curve("rim") = {outer[3]};
Physical Curve("lower") = {1, 2};
