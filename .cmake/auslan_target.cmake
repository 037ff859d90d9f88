# SPDX-License-Identifier: Apache-2.0
# The one place that says how every target of the project is compiled, and the one function that makes a library.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
# Asserts stay on in RelWithDebInfo.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g")

find_program(AUSLANJAM_CCACHE ccache)
if(AUSLANJAM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${AUSLANJAM_CCACHE}")
endif()

find_package(Threads REQUIRED)

# Language standard, floating-point contract and warnings: every target of the project links it.
add_library(auslan_standard INTERFACE)
add_library(auslan::standard ALIAS auslan_standard)
target_compile_features(auslan_standard INTERFACE cxx_std_20)
target_compile_options(auslan_standard INTERFACE
  -ffp-contract=off -fno-fast-math
  $<BUILD_INTERFACE:-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wundef>
  # g++ 12 reports overlaps inside std::string's operator+ that are not there (GCC bug 105651).
  $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>>
  $<$<BOOL:${AUSLANJAM_WERROR}>:-Werror>)
if(AUSLANJAM_SANITIZE)
  target_compile_options(auslan_standard INTERFACE
    -fsanitize=${AUSLANJAM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(auslan_standard INTERFACE -fsanitize=${AUSLANJAM_SANITIZE})
endif()

# GLM as the determinism contract wants it: plain types, no SIMD of its own.
find_package(glm REQUIRED)
add_library(auslan_glm INTERFACE)
add_library(auslan::glm ALIAS auslan_glm)
target_compile_definitions(auslan_glm INTERFACE GLM_FORCE_XYZW_ONLY GLM_FORCE_EXPLICIT_CTOR)
get_target_property(_glm_include glm::glm INTERFACE_INCLUDE_DIRECTORIES)
target_include_directories(auslan_glm SYSTEM INTERFACE ${_glm_include})

# auslan_library(NAME [ROOT dir] SOURCES ... HEADERS ... PUBLIC ... PRIVATE ...)
# Makes the static library auslan_NAME with alias auslan::NAME in the current folder. Headers live in include/ and are a
# FILE_SET, so that all_verify_interface_header_sets compiles each on its own; only include/ is exposed, so that an
# include in the wrong direction does not compile.
function(auslan_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE")
  add_library(auslan_${name} STATIC ${arg_SOURCES})
  add_library(auslan::${name} ALIAS auslan_${name})
  set_target_properties(auslan_${name} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(auslan_${name} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${arg_HEADERS})
  target_include_directories(auslan_${name} PRIVATE src)
  # What is installed asks of others the language alone: warnings and floating-point flags are this project's own.
  target_compile_features(auslan_${name} PUBLIC cxx_std_20)
  target_link_libraries(auslan_${name} PUBLIC $<BUILD_INTERFACE:auslan::standard> ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
endfunction()
