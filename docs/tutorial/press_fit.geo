SetFactory("OpenCASCADE");

DefineConstant[
  h = {5, Name "Parameters/element size"},
  half_length = {60, Name "Parameters/half length of the shaft"}
];
bore = 30; fit = 60; rim = 100; half_width = 20;

// corner, width and height; curves: bottom, right, top, left, of the shaft 1 to 4, of the ring 5 to 8
Rectangle(1) = {bore, 0, 0, fit - bore, half_length};
Rectangle(2) = {fit, 0, 0, rim - fit, half_width};

Transfinite Curve{1, 3} = Ceil((fit - bore)/h) + 1;
Transfinite Curve{2, 4} = Ceil(half_length/h) + 1;
Transfinite Curve{5, 7} = Ceil((rim - fit)/h) + 1;
Transfinite Curve{6, 8} = Ceil(half_width/h) + 1;
Transfinite Surface{1, 2};
Recombine Surface{1, 2};

// names
Physical Surface("shaft") = {1};
Physical Surface("ring") = {2};
Physical Curve("shaft_outer") = {2};
Physical Curve("ring_bore") = {8};
Physical Curve("middle") = {1, 5};
