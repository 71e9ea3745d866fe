// A door of 0.8 m x 1.6 m in the plane x = 2, 40 elements of 40 mm high. Lengths in mm.
// Made into door.msh by gmsh 4.8: gmsh -2 door.geo -o door.msh
Point(1) = {2000, 600, 0}; Point(2) = {2000, 1400, 0}; Point(3) = {2000, 1400, 1600}; Point(4) = {2000, 600, 1600};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Transfinite Curve {1, 3} = 21; Transfinite Curve {2, 4} = 41;
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {-1}; // looks into the room
Transfinite Surface {1}; Recombine Surface {1};
Mesh.MshFileVersion = 4.1;
Physical Surface("door") = {1};
Physical Curve("hinges") = {4};
Physical Curve("frame") = {1, 2, 3};
