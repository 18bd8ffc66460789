// The section of configs/shrink_fit.geo; n multiplies the elements in both directions.
DefineConstant[ n = 1 ];
SetFactory("OpenCASCADE");
Rectangle(1) = {40, 0, 0, 20, 10};
Rectangle(2) = {60, 0, 0, 60, 10};
Transfinite Curve{1, 3} = 4*n + 1;
Transfinite Curve{5, 7} = 6*n + 1 Using Progression 1.15;
Transfinite Curve{2, 4} = 3*n + 1;
Transfinite Curve{6, 8} = 2*n + 1;
Transfinite Surface{1, 2};
Recombine Surface{1, 2};
Physical Surface("shaft") = {1};
Physical Surface("disc") = {2};
Physical Curve("shaft_outer") = {2};
Physical Curve("disc_bore") = {8};
Physical Curve("ends") = {1, 3, 5, 7};
