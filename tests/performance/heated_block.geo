// A block with so many elements across it.
SetFactory("OpenCASCADE");
DefineConstant[n = 14];
Box(1) = {0, 0, 0, 30, 10, 10};
Transfinite Curve{:} = n + 1; Transfinite Curve{9, 10, 11, 12} = 3*n + 1;
Transfinite Surface{:}; Transfinite Volume{:}; Recombine Surface{:};
Physical Volume("block") = {1};
Physical Surface("x0") = {1}; Physical Surface("x1") = {2}; Physical Surface("y0") = {3}; Physical Surface("z0") = {5};
