// Two blocks with 38 x 38 elements each on their common face.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 0.4};
Box(2) = {0, 0, 0.4, 1, 1, 0.4};
Transfinite Curve{:} = 39;
Transfinite Curve{1, 3, 5, 7, 13, 15, 17, 19} = 16;
Transfinite Surface{:}; Recombine Surface{:}; Transfinite Volume{:};
Physical Volume("lower") = {1}; Physical Volume("upper") = {2};
Physical Surface("lower_top") = {6}; Physical Surface("lower_bottom") = {5};
Physical Surface("upper_bottom") = {11}; Physical Surface("upper_top") = {12};
