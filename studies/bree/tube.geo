// A narrow sector of a thin tube's cross-section: x and y in the section, z along the axis of the tube. [mm]
DefineConstant[ radius = 20, wall = 1, angle = 0.002, n_wall = 40 ];
Point(1) = {0, 0, 0}; a = radius - wall/2; b = radius + wall/2;
Point(2) = {a, 0, 0}; Point(3) = {b, 0, 0};
Point(4) = {b*Cos(angle), b*Sin(angle), 0}; Point(5) = {a*Cos(angle), a*Sin(angle), 0};
Line(1) = {2, 3}; Circle(2) = {3, 1, 4}; Line(3) = {4, 5}; Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve{1, 3} = n_wall + 1; Transfinite Curve{2, 4} = 2;
Transfinite Surface{1}; Recombine Surface{1};
Physical Surface("wall") = {1};
Physical Curve("bore") = {4};
Physical Curve("sides") = {1, 3};
