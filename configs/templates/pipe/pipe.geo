// The section of a pipe: x is the radius, y the axis. The plane y = 0 is a plane of symmetry; the pipe goes on beyond it alike.
// The numbers here are defaults: [mesh.parameters] of pipe.toml overrides them.
DefineConstant[
  inner  = {100, Name "Parameters/inner radius"},
  outer  = {125, Name "Parameters/outer radius"},
  length = {250, Name "Parameters/distance of the end from the plane of symmetry"},
  n_wall   = {8,  Name "Parameters/elements through the wall"},
  n_length = {16, Name "Parameters/elements along the pipe"}
];

Point(1) = {inner, 0, 0};
Point(2) = {outer, 0, 0};
Point(3) = {outer, length, 0};
Point(4) = {inner, length, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 3};
Line(4) = {1, 4};
Curve Loop(1) = {1, 2, -3, -4};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = n_wall + 1;
Transfinite Curve{2, 4} = n_length + 1;
Transfinite Surface{1};
Recombine Surface{1};

Physical Surface("pipe") = {1};
Physical Curve("inside") = {4};
Physical Curve("outside") = {2};
Physical Curve("middle") = {1};
Physical Curve("end") = {3};
