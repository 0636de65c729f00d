# Writes one ctest entry for each suite of a test program.
# Usage: cmake -DPROGRAM=... -DTO=... -DTIMEOUT=... -DSLOWEST=... -DENVIRONMENT=... [-DAT_LENGTH=ON] -P list_suites.cmake
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE failed)
if(failed)
  file(REMOVE ${PROGRAM})  # so that the next build lists again
  message(FATAL_ERROR "${PROGRAM} cannot list its tests: ${failed}\n${listed}")
endif()
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${listed}")
set(entries "")
foreach(suite ${suites})
  string(REGEX REPLACE "^\n|\\.$" "" suite "${suite}")
  list(FIND SLOWEST ${suite} place)
  set(cost 0)
  if(place GREATER -1)
    math(EXPR cost "200 - ${place}")
  endif()
  set(labels "")
  if(AT_LENGTH OR suite MATCHES "AtLength$")
    set(labels "LABELS full")
  endif()
  string(APPEND entries "add_test([==[${suite}]==] \"${PROGRAM}\" \"--gtest_filter=${suite}.*\")\n"
    "set_tests_properties([==[${suite}]==] PROPERTIES TIMEOUT ${TIMEOUT} COST ${cost} ${labels}\n"
    "  ENVIRONMENT \"RC_PARAMS=seed=1;${ENVIRONMENT}\")\n")
endforeach()
file(WRITE ${TO} "${entries}")
