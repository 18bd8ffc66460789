// Half of a ball on a cylindrical block, as a section: x is the radius, y the axis. They touch at the origin; the block is below.
// Triangles that grow away from the contact. The numbers here are defaults: [mesh.parameters] of the .toml overrides them.
SetFactory("OpenCASCADE"); // which leaves the coinciding points of the two bodies apart
DefineConstant[
  radius = {10,   Name "Parameters/radius of the ball"},
  width  = {10,   Name "Parameters/radius of the block"},
  height = {10,   Name "Parameters/height of the block"},
  zone   = {0.8,  Name "Parameters/radius within which the elements are small: more than that of the contact at the end"},
  h      = {0.05, Name "Parameters/size of the small elements"},
  growth = {0.3,  Name "Parameters/growth of the element size with the distance from there"}
];

Point(1) = {0, 0, 0};
Point(2) = {radius, radius, 0};
Point(3) = {0, radius, 0};
Circle(1) = {1, 3, 2};
Line(2) = {2, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};

Point(11) = {0, -height, 0};
Point(12) = {width, -height, 0};
Point(13) = {width, 0, 0};
Point(14) = {0, 0, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(2) = {2};

Field[1] = MathEval;
Field[1].F = Sprintf("%g + %g*Max(0, Sqrt(x*x + y*y) - %g)", h, growth, zone);
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMin = h;

Physical Surface("ball") = {1};
Physical Surface("block") = {2};
Physical Curve("ball_round") = {1};
Physical Curve("ball_middle") = {2};
Physical Curve("block_top") = {13};
Physical Curve("block_foot") = {11};
Physical Curve("axis") = {3, 14};
