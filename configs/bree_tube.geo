// The wall of a thin tube as a strip: x goes through the wall, y along a short piece of it. [mm]
DefineConstant[ wall = 1, piece = 0.02, n_wall = 40 ];
Point(1) = {0, 0, 0}; Point(2) = {wall, 0, 0}; Point(3) = {wall, piece, 0}; Point(4) = {0, piece, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve{1, 3} = n_wall + 1; Transfinite Curve{2, 4} = 2;
Transfinite Surface{1}; Recombine Surface{1};
Physical Surface("wall") = {1};
Physical Curve("inside") = {4};
Physical Curve("cut") = {1};
