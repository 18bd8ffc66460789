Include "press_fit.geo";
Delete Physicals;

// a slice of 30 degrees about the y axis
shaft[] = Extrude {{0, 1, 0}, {0, 0, 0}, Pi/6} { Surface{1}; Layers{2}; Recombine; };
ring[] = Extrude {{0, 1, 0}, {0, 0, 0}, Pi/6} { Surface{2}; Layers{3}; Recombine; };

Physical Volume("shaft") = {shaft[1]};
Physical Volume("ring") = {ring[1]};
Physical Surface("shaft_outer") = {shaft[3]};
Physical Surface("ring_bore") = {ring[5]};
Physical Surface("middle") = {shaft[2], ring[2]};
Physical Surface("cuts") = {1, shaft[0], 2, ring[0]};
