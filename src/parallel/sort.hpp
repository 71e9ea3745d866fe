#pragma once

#include <cstdint>
#include <vector>

#include "parallel/loops.hpp"

namespace corpuscle {

/// Stable counting sort: `place(i, position)` is called once for each item i with its position in the order of
/// key_of(i), which must lie in [0, keys). Items of equal key keep their order, so the result does not depend on threads.
/// Returns where each key begins (keys + 1 entries).
template <class KeyOf, class PlaceItem>
std::vector<std::uint32_t> stable_counting_sort(std::size_t count, std::size_t keys, const KeyOf& key_of, const PlaceItem& place)
{
    const std::size_t parts = part_count(count, 8192);
    std::vector<std::uint32_t> histogram(parts * keys, 0);
    for_each_part(count, parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
        std::uint32_t* own = histogram.data() + part * keys;
        for (std::size_t i = begin; i < end; ++i) ++own[key_of(i)];
    });
    std::vector<std::uint32_t> start(keys + 1);
    std::uint32_t total = 0;
    for (std::size_t key = 0; key < keys; ++key) {
        start[key] = total;
        for (std::size_t part = 0; part < parts; ++part) {
            const std::uint32_t own = histogram[part * keys + key];
            histogram[part * keys + key] = total;
            total += own;
        }
    }
    start[keys] = total;
    for_each_part(count, parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
        std::uint32_t* next = histogram.data() + part * keys;
        for (std::size_t i = begin; i < end; ++i) place(i, next[key_of(i)]++);
    });
    return start;
}

}  // namespace corpuscle
