#include "mesh/solid_faces.hpp"

#include <algorithm>

namespace corpuscle {

namespace {

using Face = std::array<int, 4>;

/// Corners of the faces, outward; -1 where a face has three.
std::span<const Face> faces_of(ElementShape shape)
{
    static constexpr std::array<Face, 4> tetrahedron{{{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}}};
    static constexpr std::array<Face, 6> hexahedron{{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
    if (shape == ElementShape::tetrahedron) return tetrahedron;
    if (shape == ElementShape::hexahedron) return hexahedron;
    return {};
}

/// A face's nodes in ascending order: equal for both elements that share it.
std::array<std::uint32_t, 4> key_of(const SolidFace& face)
{
    std::array<std::uint32_t, 4> key = face.node;
    if (face.corners == 3) key[3] = SolidFace::none;
    std::sort(key.begin(), key.end());
    return key;
}

std::vector<SolidFace> all_faces(std::span<const MeshElement> elements)
{
    std::vector<SolidFace> faces;
    for (std::uint32_t e = 0; e < elements.size(); ++e) {
        for (const Face& corners : faces_of(elements[e].shape)) {
            SolidFace face{{}, corners[3] < 0 ? 3 : 4, e, SolidFace::none};
            for (int c = 0; c < face.corners; ++c) face.node[c] = elements[e].node[corners[c]];
            faces.push_back(face);
        }
    }
    return faces;
}

}  // namespace

std::vector<SolidFace> solid_faces(std::span<const MeshElement> elements)
{
    std::vector<SolidFace> faces = all_faces(elements);
    std::vector<std::pair<std::array<std::uint32_t, 4>, std::uint32_t>> keys;
    for (std::uint32_t f = 0; f < faces.size(); ++f) keys.emplace_back(key_of(faces[f]), f);
    std::sort(keys.begin(), keys.end());
    std::vector<bool> second(faces.size(), false);
    for (std::size_t k = 1; k < keys.size(); ++k) {
        if (keys[k].first != keys[k - 1].first) continue;
        faces[keys[k - 1].second].other = faces[keys[k].second].element;
        second[keys[k].second] = true;
    }
    std::size_t kept = 0;
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (!second[f]) faces[kept++] = faces[f];
    faces.resize(kept);
    return faces;
}

}  // namespace corpuscle
