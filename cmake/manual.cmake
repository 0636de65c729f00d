# Manual pages and shell completions of the programs, made from the output of --describe.
add_executable(vantage-manual ${CMAKE_CURRENT_LIST_DIR}/write_manual.cpp)
target_link_libraries(vantage-manual PRIVATE vantage_base_cli)

find_program(GZIP gzip REQUIRED)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/manual)
file(MAKE_DIRECTORY ${folder})
foreach(program vantage vantage-player)
  set(description ${folder}/${program}.lines)
  add_custom_command(OUTPUT ${description} DEPENDS ${program}
    COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 $<TARGET_FILE:${program}> --describe >${description})
  list(APPEND descriptions ${description})
endforeach()
add_custom_command(OUTPUT ${folder}/written DEPENDS vantage-manual ${descriptions}
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}/man1 ${folder}/bash ${folder}/zsh
  COMMAND vantage-manual ${PROJECT_VERSION} ${folder} ${descriptions}
  COMMAND ${GZIP} -9nr ${folder}/man1
  COMMAND ${CMAKE_COMMAND} -E touch ${folder}/written)
add_custom_target(manual ALL DEPENDS ${folder}/written)
