// Two squares side by side: quadrilaterals on the left, triangles on the right. Made into sheet_*.msh by gmsh 4.8, sheet_parts_* with -part 2 -part_ghosts.
Point(1) = {0, 0, 0, 1}; Point(2) = {1, 0, 0, 1}; Point(3) = {2, 0, 0, 1};
Point(4) = {0, 1, 0, 1}; Point(5) = {1, 1, 0, 1}; Point(6) = {2, 1, 0, 1};
Point(7) = {5, 5, 5, 1};
Line(1) = {1, 2}; Line(2) = {2, 5}; Line(3) = {5, 4}; Line(4) = {4, 1}; Line(5) = {2, 3}; Line(6) = {3, 6}; Line(7) = {6, 5};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, -2}; Plane Surface(2) = {2};
Transfinite Curve {1:7} = 3;
Transfinite Surface {1}; Recombine Surface {1};
Transfinite Surface {2};
Physical Point("corner") = {1};
Physical Curve("left edge") = {4};
Physical Curve(9) = {6};
Physical Surface("quads") = {1};
Physical Surface("all of it") = {1, 2};
