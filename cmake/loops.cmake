# vantage_loops(FILE...): sources with loops over every pixel. -O2 does not vectorize them, and neither does -O3 if comparisons
# may trap or square roots set errno. The results are the same. Vectors are passed between inlined functions only, so that it
# does not matter how calls pass them.
function(vantage_loops)
  foreach(file ${ARGN})
    set(path ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    if(NOT EXISTS ${path})
      message(FATAL_ERROR "vantage_loops: there is no ${path}")
    endif()
    set_source_files_properties(${path} PROPERTIES
      COMPILE_OPTIONS "-O3;-fno-trapping-math;-fno-math-errno;-Wno-psabi" SKIP_PRECOMPILE_HEADERS ON)
  endforeach()
endfunction()
