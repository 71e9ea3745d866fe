#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "input/meshes/deck_lines.hpp"

namespace corpuscle {

/// A number of a deck's arithmetic; whole numbers divide as Fortran's do (7 / 2 is 3).
struct DeckNumber {
    double value = 0;
    bool whole = false;
};

/// What a name stands for; refuses unknown names itself.
using DeckNames = std::function<DeckNumber(const std::string& name)>;

/// The value of an expression of + - * / ** ( ), numbers, names (with or without "&" before them) and the functions
/// abs aint acos anint asin atan atan2 ceil cos cosh exp float floor int log log10 max min mod nint sign sin sinh sqrt tan tanh
/// (angles in radians). As in LS-DYNA a sign binds closer than a power (-3**2 is 9), and powers are taken from the right.
/// Refuses, at the present line, what is none, and what is not finite. Source: LS-DYNA Keyword User's Manual, volume I, *PARAMETER.
[[nodiscard]] DeckNumber evaluate_expression(const DeckLines& lines, std::string_view expression, const DeckNames& names);

}  // namespace corpuscle
