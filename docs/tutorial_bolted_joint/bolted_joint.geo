SetFactory("OpenCASCADE");

DefineConstant[ h = {1.5, Name "Parameters/element size"} ];
shank = 12; hole = 13; head = 18; rim = 40;        // radii
plate = 30; head_height = 15; nut_height = 20;

// the bolt: its shank between the bearing faces of nut and head ...
Point(1) = {0, -plate, 0};
Point(2) = {shank, -plate, 0};
Point(3) = {head, -plate, 0};
Point(4) = {0, plate, 0};
Point(5) = {shank, plate, 0};
Point(6) = {head, plate, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {1, 4};
Line(6) = {2, 5};
Curve Loop(1) = {1, 6, -3, -5};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = Ceil(shank/h) + 1;
Transfinite Curve{2, 4} = Ceil((head - shank)/h) + 1;
Transfinite Curve{5, 6} = Ceil(2*plate/h) + 1;
Transfinite Surface{1};
Recombine Surface{1};
// ... and head and nut, drawn out from the lines at its ends
head_part[] = Extrude {0, head_height, 0} { Curve{3, 4}; Layers{Ceil(head_height/h)}; Recombine; };
nut_part[] = Extrude {0, -nut_height, 0} { Curve{1, 2}; Layers{Ceil(nut_height/h)}; Recombine; };

// the plates, each from its face in the joint
Point(101) = {hole, 0, 0};
Point(102) = {rim, 0, 0};
Point(103) = {hole, 0, 0};
Point(104) = {rim, 0, 0};
Line(101) = {101, 102};
Line(102) = {103, 104};
Transfinite Curve{101, 102} = Ceil((rim - hole)/h) + 1;
upper[] = Extrude {0, plate, 0} { Curve{101}; Layers{Ceil(plate/h)}; Recombine; };
lower[] = Extrude {0, -plate, 0} { Curve{102}; Layers{Ceil(plate/h)}; Recombine; };

// names
Physical Surface("bolt") = {1, head_part[1], head_part[5], nut_part[1], nut_part[5]};
Physical Surface("upper_plate") = {upper[1]};
Physical Surface("lower_plate") = {lower[1]};
Physical Curve("nut_face") = {2};
Physical Curve("head_face") = {4};
Physical Curve("upper_seat") = {upper[0]};
Physical Curve("lower_seat") = {lower[0]};
Physical Curve("upper_joint") = {101};
Physical Curve("lower_joint") = {102};
Physical Curve("upper_rim") = {upper[3]};
Physical Curve("lower_rim") = {lower[3]};
