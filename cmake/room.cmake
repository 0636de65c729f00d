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

# vantage_room(FOLDER [USES folder...] [LIBRARIES target...] [PRIVATE_LIBRARIES target...] [SOURCES file...] [LOOPS file...])
#
# Makes a library of a folder, named vantage_ and its path with _ for / (player/plan: vantage_player_plan). Its sources
# see its own headers and those of the rooms it uses, directly or through another, and no others: the source folder is
# linked into an include directory of the room's own, and the repository root is on no room's include path. An include
# against the order of dependencies does not compile.
#   USES               rooms, by their folders; part of the room's interface
#   LIBRARIES          libraries that the room's headers include
#   PRIVATE_LIBRARIES  libraries that only its sources include
#   SOURCES            default: FOLDER/*.cpp; a room without sources is an INTERFACE library
#   LOOPS              sources with loops over every pixel. -O2 does not vectorize them, and neither does -O3 if comparisons may
#                      trap or square roots set errno. The results are the same. Vectors are passed between inlined functions
#                      only, so that it does not matter how calls pass them.
# All sources of a room are compiled as one, which saves most of the build's time (-DCMAKE_UNITY_BUILD=OFF: one by one).
function(vantage_room folder)
  cmake_parse_arguments(ROOM "" "" "USES;LIBRARIES;PRIVATE_LIBRARIES;SOURCES;LOOPS" ${ARGN})
  string(REPLACE "/" "_" target vantage_${folder})
  list(TRANSFORM ROOM_LOOPS PREPEND ${CMAKE_SOURCE_DIR}/${folder}/)
  if(NOT ROOM_SOURCES)
    file(GLOB ROOM_SOURCES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
    list(REMOVE_ITEM ROOM_SOURCES ${ROOM_LOOPS})
  endif()
  set(include_directory ${CMAKE_BINARY_DIR}/rooms/${target})
  get_filename_component(parent ${include_directory}/${folder} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${folder} ${include_directory}/${folder} SYMBOLIC)

  set(used vantage_options)
  foreach(room ${ROOM_USES})
    string(REPLACE "/" "_" room vantage_${room})
    list(APPEND used ${room})
  endforeach()
  if(ROOM_SOURCES)
    add_library(${target} STATIC ${ROOM_SOURCES})
    target_include_directories(${target} PUBLIC ${include_directory})
    target_link_libraries(${target} PUBLIC ${used} ${ROOM_LIBRARIES} PRIVATE ${ROOM_PRIVATE_LIBRARIES})
    vantage_precompile(${target})
    if(ROOM_LOOPS)
      add_library(${target}_loops OBJECT ${ROOM_LOOPS})
      target_include_directories(${target}_loops PRIVATE ${include_directory})
      target_link_libraries(${target}_loops PRIVATE ${used} ${ROOM_LIBRARIES} ${ROOM_PRIVATE_LIBRARIES})
      target_compile_options(${target}_loops PRIVATE -O3 -fno-trapping-math -fno-math-errno -Wno-psabi)
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_loops>)
    endif()
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE ${include_directory})
    target_link_libraries(${target} INTERFACE ${used} ${ROOM_LIBRARIES})
  endif()
endfunction()
