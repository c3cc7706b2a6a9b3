# cmake -DPROGRAM=... -DTIMEOUT=s -DOUTPUT=file -P: writes a test of ctest for each suite of a program of GoogleTest's.
cmake_minimum_required(VERSION 3.22)
set(pictures TenSteps Picture Picking ClothLook RoundedSheet Views Areas WaterPicture)

execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[^ \n]+\\.\n" suites "\n${listed}")
get_filename_component(name ${PROGRAM} NAME_WE)
set(tests "")
foreach(suite ${suites})
  string(REGEX REPLACE "[.\n]" "" suite "${suite}")
  string(APPEND tests "add_test([==[${name}.${suite}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.*]==])\n"
         "set_tests_properties([==[${name}.${suite}]==] PROPERTIES TIMEOUT ${TIMEOUT}")
  if(suite IN_LIST pictures)
    string(APPEND tests " LABELS pictures COST 20")
  endif()
  string(APPEND tests ")\n")
endforeach()
file(WRITE ${OUTPUT} "${tests}")
