# The headers that nearly every source includes are parsed once and reused by all targets.
option(VANTAGE_PRECOMPILE "Precompile common headers" ON)
function(vantage_precompile target)
  if(NOT VANTAGE_PRECOMPILE)
    return()
  endif()
  if(NOT TARGET vantage_precompiled)
    file(WRITE ${CMAKE_BINARY_DIR}/precompiled.cpp "")
    add_library(vantage_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(vantage_precompiled PRIVATE vantage_options Eigen3::Eigen)
    target_precompile_headers(vantage_precompiled PRIVATE ${CMAKE_SOURCE_DIR}/cmake/precompiled.h)
  endif()
  target_precompile_headers(${target} REUSE_FROM vantage_precompiled)
endfunction()

# vantage_module(FOLDER [USES folder...] [LIBRARIES target...] [PRIVATE_LIBRARIES target...] [SOURCES file...] [LOOPS file...])
#
# Makes a library from a folder. The library's name is vantage_ followed by the folder's path with _ in place
# of / (player/plan: vantage_player_plan). A module's sources see only its own headers and those of the
# modules that it uses, directly or indirectly. For this purpose, the source folder is linked into an include
# directory of the module's own, and the repository root is not on any module's include path. An include that
# violates the order of dependencies does not compile.
#   USES               the folders of the modules that it uses; they are part of the module's interface
#   LIBRARIES          libraries that the module's headers include
#   PRIVATE_LIBRARIES  libraries that only its sources include
#   SOURCES            default: all *.cpp in FOLDER and below; a module without sources is an INTERFACE library
#   LOOPS              sources with loops over every pixel. -O2 does not vectorize them, and neither does -O3 if comparisons may
#                      trap or square roots set errno. The results are the same. Vectors are passed between inlined functions
#                      only, so the calling convention does not matter.
# The global property vantage_modules has a line for each module, with the modules that it uses.
# All sources of a module are compiled as one, which saves most of the build time. With
# -DCMAKE_UNITY_BUILD=OFF, the sources are compiled separately.
function(vantage_module folder)
  cmake_parse_arguments(MODULE "" "" "USES;LIBRARIES;PRIVATE_LIBRARIES;SOURCES;LOOPS" ${ARGN})
  string(REPLACE "/" "_" target vantage_${folder})
  list(TRANSFORM MODULE_LOOPS PREPEND ${CMAKE_SOURCE_DIR}/${folder}/)
  if(NOT MODULE_SOURCES)
    file(GLOB_RECURSE MODULE_SOURCES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
    list(REMOVE_ITEM MODULE_SOURCES ${MODULE_LOOPS})
  endif()
  set(include_directory ${CMAKE_BINARY_DIR}/modules/${target})
  get_filename_component(parent ${include_directory}/${folder} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${folder} ${include_directory}/${folder} SYMBOLIC)

  string(JOIN " " uses ${MODULE_USES})
  set_property(GLOBAL APPEND_STRING PROPERTY vantage_modules "${folder}: ${uses}\n")

  set(used vantage_options)
  foreach(module ${MODULE_USES})
    string(REPLACE "/" "_" module vantage_${module})
    list(APPEND used ${module})
  endforeach()
  if(MODULE_SOURCES)
    add_library(${target} STATIC ${MODULE_SOURCES})
    target_include_directories(${target} PUBLIC ${include_directory})
    target_link_libraries(${target} PUBLIC ${used} ${MODULE_LIBRARIES} PRIVATE ${MODULE_PRIVATE_LIBRARIES})
    vantage_precompile(${target})
    if(MODULE_LOOPS)
      add_library(${target}_loops OBJECT ${MODULE_LOOPS})
      target_include_directories(${target}_loops PRIVATE ${include_directory})
      target_link_libraries(${target}_loops PRIVATE ${used} ${MODULE_LIBRARIES} ${MODULE_PRIVATE_LIBRARIES})
      target_compile_options(${target}_loops PRIVATE -O3 -fno-trapping-math -fno-math-errno -Wno-psabi)
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_loops>)
    endif()
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE ${include_directory})
    target_link_libraries(${target} INTERFACE ${used} ${MODULE_LIBRARIES})
  endif()
endfunction()
