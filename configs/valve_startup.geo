// Axial section of the seat region of a steam valve: the body with the bridge that separates its two chambers, and the seat ring
// shrunk into the bridge; x is the radius and y the axis.
SetFactory("OpenCASCADE"); // which leaves the coinciding points and lines of ring and bridge apart
DefineConstant[
  port    = {60,  Name "Parameters/inner radius of the seat ring"},
  fit     = {78,  Name "Parameters/radius of the fit"},
  chamber = {120, Name "Parameters/radius of the chambers"},
  outside = {200, Name "Parameters/outer radius of the body"},
  bridge  = {40,  Name "Parameters/thickness of the bridge and height of the ring"},
  height  = {160, Name "Parameters/height of the section"},
  size    = {10,  Name "Parameters/element size"}
];

// the seat ring
Point(1) = {port, -bridge/2, 0};
Point(2) = {fit, -bridge/2, 0};
Line(1) = {1, 2};
Transfinite Curve{1} = Ceil((fit - port)/size*2) + 1;
ring[] = Extrude {0, bridge, 0} { Curve{1}; Layers{Ceil(bridge/size)}; Recombine; };

// the body: the bridge and the wall behind it, then the wall below and above
Point(11) = {fit, -bridge/2, 0};
Point(12) = {chamber, -bridge/2, 0};
Point(13) = {outside, -bridge/2, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Transfinite Curve{11} = Ceil((chamber - fit)/size) + 1;
Transfinite Curve{12} = Ceil((outside - chamber)/size) + 1;
middle[] = Extrude {0, bridge, 0} { Curve{11, 12}; Layers{Ceil(bridge/size) + 1}; Recombine; };
side = (height - bridge)/2;
lower[] = Extrude {0, -side, 0} { Curve{12}; Layers{Ceil(side/size)}; Recombine; };
upper[] = Extrude {0, side, 0} { Curve{middle[4]}; Layers{Ceil(side/size)}; Recombine; };
Physical Surface("ring") = {ring[1]};
Physical Surface("body") = {middle[1], middle[5], lower[1], upper[1]};
Physical Curve("ring_fit") = {ring[3]};
Physical Curve("ring_steam") = {1, ring[0], ring[2]};
Physical Curve("body_fit") = {middle[2]};
Physical Curve("chambers") = {11, middle[0], lower[2], upper[2]};
Physical Curve("outside") = {lower[3], middle[7], upper[3]};
Physical Curve("lower_end") = {lower[0]};
Physical Curve("upper_end") = {upper[0]};
Physical Point("ring_corner") = {1};
