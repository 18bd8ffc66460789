SetFactory("OpenCASCADE");

DefineConstant[
  h = {5, Name "Parameters/element size"},
  half_length = {60, Name "Parameters/half length of the shaft"}
];
bore = 30; fit = 60; rim = 100; half_width = 20;

// the shaft's section in the plane y = 0
Point(1) = {bore, 0, 0};
Point(2) = {fit, 0, 0};
Point(3) = {fit, 0, half_length};
Point(4) = {bore, 0, half_length};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

// the ring's section
Point(5) = {fit, 0, 0};
Point(6) = {rim, 0, 0};
Point(7) = {rim, 0, half_width};
Point(8) = {fit, 0, half_width};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 5};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(2) = {2};

// divisions
Transfinite Curve{1, 3} = Ceil((fit - bore)/h) + 1;
Transfinite Curve{2, 4} = Ceil(half_length/h) + 1;
Transfinite Curve{5, 7} = Ceil((rim - fit)/h) + 1;
Transfinite Curve{6, 8} = Ceil(half_width/h) + 1;
Transfinite Surface{1, 2};
Recombine Surface{1, 2};

// a slice of 30 degrees about the z axis
shaft[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi/6} { Surface{1}; Layers{2}; Recombine; };
ring[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi/6} { Surface{2}; Layers{3}; Recombine; };

// names
Physical Volume("shaft") = {shaft[1]};
Physical Volume("ring") = {ring[1]};
Physical Surface("shaft_outer") = {shaft[3]};
Physical Surface("ring_bore") = {ring[5]};
Physical Surface("middle") = {shaft[2], ring[2]};
Physical Surface("cuts") = {1, shaft[0], 2, ring[0]};
