// Axial section of a valve, the insert that it closes on and the head around the insert; x is the radius and y the axis. The
// combustion chamber is above.
DefineConstant[
  port    = {15,   Name "Parameters/radius of the port"},
  fit     = {18.5, Name "Parameters/outer radius of the insert"},
  depth   = {7,    Name "Parameters/height of the insert"},
  face    = {2,    Name "Parameters/radial width of the seat"},
  outside = {45,   Name "Parameters/outer radius of the head"},
  size    = {0.9,  Name "Parameters/element size of the insert"}
];
low = depth - face; // where the seat begins: it rises at 45 degrees
chamfer = 0.5;
fine = size/7;      // on the elastic sides of the contacts, which do not creep and cost little

// The valve, whose cone is wider than the seat on both sides.
Point(1) = {0, low - 2, 0, 4*size};
Point(2) = {port - 2, low - 2, 0, 2*size};
Point(3) = {port, low, 0, fine};
Point(4) = {port + face, depth, 0, fine};
Point(5) = {port + face + 0.5, depth + 0.5, 0, size};
Point(6) = {port + face + 0.5, depth + 2, 0, 2*size};
Point(7) = {0, depth + 2, 0, 4*size};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 1};
Curve Loop(1) = {1 : 7};
Plane Surface(1) = {1};

// The insert.
Point(11) = {port, 0, 0, size/2};
Point(12) = {fit - chamfer, 0, 0, size/3};
Point(13) = {fit, chamfer, 0, size/2};
Point(14) = {fit, depth, 0, size};
Point(15) = {port + face, depth, 0, size/2};
Point(16) = {port, low, 0, size/2};
Line(11) = {11, 12}; Line(12) = {12, 13}; Line(13) = {13, 14}; Line(14) = {14, 15}; Line(15) = {15, 16}; Line(16) = {16, 11};
Curve Loop(2) = {11 : 16};
Plane Surface(2) = {2};

// The head: a shoulder under the insert and the metal around it.
Point(21) = {port, -8, 0, 3*size};
Point(22) = {outside, -8, 0, 7*size};
Point(23) = {outside, depth, 0, 7*size};
Point(24) = {fit, depth, 0, 3*fine};
Point(25) = {fit, 0, 0, 2*fine};
Point(26) = {port, 0, 0, 2*fine};
Line(21) = {21, 22}; Line(22) = {22, 23}; Line(23) = {23, 24}; Line(24) = {24, 25}; Line(25) = {25, 26}; Line(26) = {26, 21};
Curve Loop(3) = {21 : 26};
Plane Surface(3) = {3};

Physical Surface("valve") = {1};
Physical Surface("insert") = {2};
Physical Surface("head") = {3};
Physical Curve("valve_top") = {6};
Physical Curve("valve_cone") = {2, 3, 4};
Physical Curve("seat") = {15};
Physical Curve("insert_outside") = {13};
Physical Curve("insert_bottom") = {11};
Physical Curve("head_bore") = {24};
Physical Curve("head_shoulder") = {25};
Physical Curve("head_bottom") = {21};
