// The section of a hub on a shaft: x is the radius, y the axis. The plane y = 0 is the middle of the hub; the half above it is
// drawn. The numbers here are defaults: [mesh.parameters] of press_fit.toml overrides them.
SetFactory("OpenCASCADE"); // which leaves the coinciding curves of the two bodies apart
DefineConstant[
  bore   = {0,   Name "Parameters/inner radius of the shaft; 0: solid"},
  fit    = {50,  Name "Parameters/radius of the fit"},
  rim    = {100, Name "Parameters/outer radius of the hub"},
  length = {40,  Name "Parameters/half of the length of the hub"},
  beyond = {40,  Name "Parameters/length of the shaft beyond the hub; 0: both end together"},
  h      = {5,   Name "Parameters/element size"},
  h_edge = {1.5, Name "Parameters/element size at the edge of the fit"}
];
n_shaft = Ceil((fit - bore)/h);
n_hub = Ceil((rim - fit)/h);
n_fit = Ceil(2*length/(h + h_edge)) + 1;
n_beyond = Ceil(2*beyond/(h + h_edge)) + 1;
q = (h_edge/h)^(1/(n_fit - 1)); // factor from one element to the next, towards the edge of the hub

// the shaft under the hub
Point(1) = {bore, 0, 0};
Point(2) = {fit, 0, 0};
Point(3) = {fit, length, 0};
Point(4) = {bore, length, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 3};
Line(4) = {1, 4};
Curve Loop(1) = {1, 2, -3, -4};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = n_shaft + 1;
Transfinite Curve{2, 4} = n_fit + 1 Using Progression q;
shaft[] = {1};
// the shaft beyond it
If (beyond > 0)
  Point(5) = {fit, length + beyond, 0};
  Point(6) = {bore, length + beyond, 0};
  Line(5) = {3, 5};
  Line(6) = {6, 5};
  Line(7) = {4, 6};
  Curve Loop(2) = {3, 5, -6, -7};
  Plane Surface(2) = {2};
  Transfinite Curve{6} = n_shaft + 1;
  Transfinite Curve{5, 7} = n_beyond + 1 Using Progression 1/q;
  shaft[] += {2};
EndIf
// the hub, with points and curves of its own
Point(11) = {fit, 0, 0};
Point(12) = {rim, 0, 0};
Point(13) = {rim, length, 0};
Point(14) = {fit, length, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {14, 13};
Line(14) = {11, 14};
Curve Loop(3) = {11, 12, -13, -14};
Plane Surface(3) = {3};
Transfinite Curve{11, 13} = n_hub + 1;
Transfinite Curve{12, 14} = n_fit + 1 Using Progression q;

Transfinite Surface{shaft[], 3};
Recombine Surface{shaft[], 3};

Physical Surface("shaft") = {shaft[]};
Physical Surface("hub") = {3};
Physical Curve("shaft_seat") = {2};
Physical Curve("hub_bore") = {14};
Physical Curve("hub_rim") = {12};
Physical Curve("middle") = {1, 11};
