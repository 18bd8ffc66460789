// A quarter of a plate with a round hole, upper half of its thickness, meshed with hexahedra.
DefineConstant[
  radius    = {10, Name "Parameters/radius of the hole"},
  half      = {50, Name "Parameters/half width and half length"},
  thickness = {2,  Name "Parameters/half thickness"},
  n_around  = {6,  Name "Parameters/elements along each half of the hole's quarter"},
  n_out     = {8,  Name "Parameters/elements from the hole to the edges"}
];

c = radius*Sqrt(0.5);
Point(1) = {0, 0, 0};
Point(2) = {radius, 0, 0};
Point(3) = {c, c, 0};
Point(4) = {0, radius, 0};
Point(5) = {half, 0, 0};
Point(6) = {half, half, 0};
Point(7) = {0, half, 0};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Line(3) = {2, 5};
Line(4) = {3, 6};
Line(5) = {4, 7};
Line(6) = {5, 6};
Line(7) = {6, 7};
Curve Loop(1) = {3, 6, -4, -1};
Plane Surface(1) = {1};
Curve Loop(2) = {4, 7, -5, -2};
Plane Surface(2) = {2};
Transfinite Curve{1, 2, 6, 7} = n_around + 1;
Transfinite Curve{3, 4, 5} = n_out + 1 Using Progression 1.25;
Transfinite Surface{1, 2};
Recombine Surface{1, 2};
// out[]: top, volume, then the sides of the curves in the order of the loop
right[] = Extrude {0, 0, thickness} { Surface{1}; Layers{1}; Recombine; };
left[] = Extrude {0, 0, thickness} { Surface{2}; Layers{1}; Recombine; };

Physical Volume("plate") = {right[1], left[1]};
Physical Surface("hole") = {right[5], left[5]};
Physical Surface("end") = {left[3]};
Physical Surface("symmetry_x") = {left[4]};
Physical Surface("symmetry_y") = {right[2]};
Physical Surface("symmetry_z") = {1, 2};
