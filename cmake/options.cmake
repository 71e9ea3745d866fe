# Language, warnings, sanitizers and the machine the kernels are compiled for.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug or RelWithDebInfo" FORCE)
endif()

option(CORPUSCLE_NATIVE "Compile for the instruction set of this machine" ON)
set(CORPUSCLE_MARCH "" CACHE STRING "Instruction set where CORPUSCLE_NATIVE is off, e.g. x86-64-v3; empty: the compiler's default")
option(CORPUSCLE_WERROR "Treat warnings as errors" ON)
set(CORPUSCLE_SANITIZE "" CACHE STRING "Sanitizers compiled in: address,undefined or thread; empty: none")
option(CORPUSCLE_UNITY "Compile several sources of a module as one: quicker, but a missing include may go unseen" OFF)
option(CORPUSCLE_TESTS "Build the tests (needs GoogleTest)" ON)
option(CORPUSCLE_HOUSE "Let ctest also check the house itself: floors, format, clang-tidy, sanitizers (label house)" OFF)

# ccache makes every later build of the same source nearly free. A precompiled header (tests/CMakeLists.txt) is the same to it when its text is.
find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
endif()

add_compile_options(-Wall -Wextra -Wshadow -Wpedantic -Wnon-virtual-dtor -Wold-style-cast -Wconversion -Wno-sign-conversion)
# g++ 12 sees overlapping copies in plain string sums where there are none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  add_compile_options(-Wno-restrict)
endif()
# clang++ over libstdc++ 12: std::stable_sort calls what the library itself marks deprecated; a simd loop need not be vectorised.
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  add_compile_options(-Wno-deprecated-declarations -Wno-pass-failed)
endif()
if(CORPUSCLE_WERROR)
  add_compile_options(-Werror)
endif()

if(CORPUSCLE_NATIVE)
  add_compile_options(-march=native)
elseif(CORPUSCLE_MARCH)
  add_compile_options(-march=${CORPUSCLE_MARCH})
endif()
# No contraction of a*b+c: a loop's vector body, its remainder, g++ and clang++ then all round alike.
add_compile_options(-ffp-contract=off -fno-math-errno -fno-trapping-math)

# Release carries no debug information (RelWithDebInfo does, for profilers); Debug stays quick enough to run the unit tests.
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O3 -g -fno-omit-frame-pointer -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-Og -g")

# Sanitized trees: lines in the traces, the first finding ends the program. Only modules that compute are optimised (src/CMakeLists.txt):
# of the others it would take longer than it saves.
if(CORPUSCLE_SANITIZE)
  add_compile_options(-fsanitize=${CORPUSCLE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -gline-tables-only)
  add_link_options(-fsanitize=${CORPUSCLE_SANITIZE})
  set(CMAKE_CXX_FLAGS_DEBUG "-O0")
endif()

# Sources compiled as one see each other's local names: a local variable may then be called as another file's constant.
if(CORPUSCLE_UNITY)
  add_compile_options(-Wno-shadow)
endif()

find_package(OpenMP REQUIRED)
find_package(fmt REQUIRED)
