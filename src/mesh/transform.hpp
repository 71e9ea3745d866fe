#pragma once

#include "mesh/mesh.hpp"

namespace corpuscle {

/// Moves every node by `shift` [m].
void translate(Mesh& mesh, const Vector3d& shift);

/// Turns the mesh by `angle` [rad] about the line through `center` along `axis` (any length, not zero), by the right hand.
void rotate(Mesh& mesh, const Vector3d& axis, double angle, const Vector3d& center = {});

/// Multiplies every length by `factor` (> 0) from the origin.
void scale(Mesh& mesh, double factor);

/// Adds the nodes, elements and sets of `other`; sets of the same name are united. Nodes stay apart: see merge_nodes.
void append(Mesh& mesh, const Mesh& other);

/// Makes nodes that lie within `tolerance` [m] of each other one (the one that comes first stays); returns how many went.
/// Elements and sets follow. Chains of near nodes are joined only through nodes that stay.
std::size_t merge_nodes(Mesh& mesh, double tolerance);

/// Drops nodes that no element uses, also from the sets; returns how many went.
std::size_t remove_unused_nodes(Mesh& mesh);

}  // namespace corpuscle
