#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "laws/strength/material.hpp"
#include "structure/elements/elements.hpp"
#include "structure/erosion.hpp"

namespace corpuscle {

/// A part: elements of one kind and one material over nodes of its own.
struct Part {
    std::string name;
    Material material;
    Elements elements;
    Erosion erosion;
    bool erodes = false;           ///< by a limit of its own or by its law's damage
    std::uint32_t first_node = 0;  ///< its nodes lie together
    std::uint32_t node_count = 0;
    std::uint32_t first_element = 0;            ///< its elements' numbers over all parts
    std::uint32_t first_corner = 0;             ///< where its corner loads begin
    std::vector<std::int64_t> element_numbers;  ///< in the mesh's file; empty: counted from 1

    [[nodiscard]] std::uint32_t element_count() const { return static_cast<std::uint32_t>(corpuscle::element_count(elements)); }
    /// How people know an element.
    [[nodiscard]] std::int64_t number_of(std::size_t element) const
    {
        return element_numbers.empty() ? static_cast<std::int64_t>(element) + 1 : element_numbers[element];
    }
    [[nodiscard]] bool rigid() const { return std::holds_alternative<RigidFacets>(elements); }
};

}  // namespace corpuscle
