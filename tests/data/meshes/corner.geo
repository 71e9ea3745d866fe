// A unit tetrahedron, coarse. Made into corner_*.msh and corner*.stl by gmsh 4.8.
Point(1) = {0, 0, 0, 1}; Point(2) = {1, 0, 0, 1}; Point(3) = {0, 1, 0, 1}; Point(4) = {0, 0, 1, 1};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 1}; Line(4) = {1, 4}; Line(5) = {2, 4}; Line(6) = {3, 4};
Curve Loop(1) = {1, 2, 3}; Curve Loop(2) = {1, 5, -4}; Curve Loop(3) = {2, 6, -5}; Curve Loop(4) = {3, 4, -6};
Plane Surface(1) = {-1}; Plane Surface(2) = {2}; Plane Surface(3) = {3}; Plane Surface(4) = {4};
Transfinite Curve {1:6} = 3;
Surface Loop(1) = {1, 2, 3, 4}; Volume(1) = {1};
Physical Volume("corner") = {1};
Physical Surface("slope") = {3};
