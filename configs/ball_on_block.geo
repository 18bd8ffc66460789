// A quarter of a hemisphere on a quarter of a block; tetrahedra that grow away from the contact.
SetFactory("OpenCASCADE");
DefineConstant[
  radius = {10,   Name "Parameters/radius of the ball, extent of the block"},
  zone   = {1.6,  Name "Parameters/radius within which the elements are small"},
  h      = {0.3,  Name "Parameters/size of the small elements"},
  growth = {0.35, Name "Parameters/growth of the element size with distance"}
];
eps = 1e-5*radius;

Sphere(1) = {0, 0, radius, radius, -Pi/2, 0, Pi/2};
Box(2) = {0, 0, -radius, radius, radius, radius};

Field[1] = MathEval;
Field[1].F = Sprintf("%g + %g*Max(0, Sqrt(x*x + y*y + z*z) - %g)", h, growth, zone);
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMin = h;

Physical Volume("ball") = {1};
Physical Volume("block") = {2};
Physical Surface("ball_round") = {1};
top[] = Surface In BoundingBox{-eps, -eps, radius-eps, radius+eps, radius+eps, radius+eps};
Physical Surface("ball_top") = {top[]};
face[] = Surface In BoundingBox{-eps, -eps, -eps, radius+eps, radius+eps, eps};
Physical Surface("block_top") = {face[]};
foot[] = Surface In BoundingBox{-eps, -eps, -radius-eps, radius+eps, radius+eps, -radius+eps};
Physical Surface("block_foot") = {foot[]};
sx[] = Surface In BoundingBox{-eps, -eps, -radius-eps, eps, radius+eps, radius+eps};
Physical Surface("symmetry_x") = {sx[]};
sy[] = Surface In BoundingBox{-eps, -eps, -radius-eps, radius+eps, eps, radius+eps};
Physical Surface("symmetry_y") = {sy[]};
