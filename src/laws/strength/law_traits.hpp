#pragma once

// What a strength law has besides `stretch`; a law says only what applies to it. All are questions to its type, so that kernels are
// compiled for the answer.

namespace corpuscle {

/// Its points warm up by plastic work.
template <class Law>
[[nodiscard]] constexpr bool heats()
{
    if constexpr (requires { Law::heats(); }) return Law::heats();
    return false;
}

/// Its points count damage up to failure at 1.
template <class Law>
[[nodiscard]] constexpr bool damages()
{
    if constexpr (requires { Law::damages(); }) return Law::damages();
    return false;
}

/// Its pressure comes from an equation of state.
template <class Law>
[[nodiscard]] constexpr bool has_equation_of_state()
{
    if constexpr (requires { Law::has_equation_of_state(); }) return Law::has_equation_of_state();
    return false;
}

/// It has a plane stress form, for shells and membranes.
template <class Law>
[[nodiscard]] constexpr bool for_shells()
{
    if constexpr (requires { Law::for_shells(); }) return Law::for_shells();
    return true;
}

/// It has a form for solids.
template <class Law>
[[nodiscard]] constexpr bool for_solids()
{
    if constexpr (requires { Law::for_solids(); }) return Law::for_solids();
    return true;
}

}  // namespace corpuscle
