# Language, warnings and the machine the kernels are compiled for.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(CORPUSCLE_NATIVE "Compile for the instruction set of this machine" ON)
option(CORPUSCLE_WERROR "Treat warnings as errors" ON)

add_compile_options(-Wall -Wextra -Wshadow -Wpedantic -Wnon-virtual-dtor -Wold-style-cast -Wconversion -Wno-sign-conversion)
if(CORPUSCLE_WERROR)
  add_compile_options(-Werror)
endif()
if(CORPUSCLE_NATIVE)
  add_compile_options(-march=native)
endif()
# No contraction: g++ and clang++ then round alike wherever a sum is written once.
add_compile_options(-fno-math-errno -fno-trapping-math)

find_package(OpenMP REQUIRED)
find_package(fmt REQUIRED)
