# The kinds of tests that there are, so that a test is one line where it is listed.

# What every test runs under. Pictures must not depend on the machine: llvmpipe draws them, with the vector width that
# every processor has; one thread each, since ctest already runs as many tests as there are processors.
set(test_environment
  GALLIUM_DRIVER=llvmpipe
  LIBGL_ALWAYS_SOFTWARE=1
  LP_NATIVE_VECTOR_WIDTH=128
  LP_NUM_THREADS=1
  LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/cmake/lsan.supp:print_suppressions=0
  NORMALSCOPE_GL_DEBUG=1  # any GL error ends the program, and so fails the test
  NORMALSCOPE=${PROJECT_BINARY_DIR}/normalscope
  PYTHONDONTWRITEBYTECODE=1)

# gtest_executable(TARGET FOLDER LIBRARIES...): the tests in FOLDER and below as one executable; its tests are found when
# ctest starts.
function(gtest_executable target folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  take_own_files(sources)
  add_executable(${target} ${sources})
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${target} PRIVATE ${ARGN} normalscope_embedded GTest::gtest_main)
  if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
    # Reusing none would still wait for core_tests.
  elseif(TARGET core_tests AND NOT target STREQUAL core_tests)
    target_precompile_headers(${target} REUSE_FROM core_tests)
  else()
    target_precompile_headers(${target} PRIVATE ${common_headers} <gtest/gtest.h>)
  endif()
  if(TARGET Eigen3::Eigen)
    target_link_libraries(${target} PRIVATE Eigen3::Eigen)
  endif()
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST TEST_PREFIX ${folder}. PROPERTIES LABELS ${folder})
  # Its PROPERTIES cannot hold a list, so the environment is set afterwards, on the tests it has found.
  set(properties "${CMAKE_CURRENT_BINARY_DIR}/${target}_environment.cmake")
  file(WRITE "${properties}"
    "set_tests_properties(\${${target}_TESTS} PROPERTIES ENVIRONMENT \"${test_environment}\")\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${properties}")
endfunction()

# compile_fail_tests(FILE): FILE must compile, and each of its blocks `#ifdef EXPECT_ERROR_name` must not, because the
# types forbid it: a misspelt name or a missing header would also fail to compile, and would prove nothing.
function(compile_fail_tests file)
  get_filename_component(stem ${file} NAME_WE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} blocks REGEX "^#ifdef EXPECT_ERROR_")
  list(TRANSFORM blocks REPLACE "^#ifdef +" "")
  set(includes "-I$<JOIN:$<TARGET_PROPERTY:normalscope_core_math,INTERFACE_INCLUDE_DIRECTORIES>,;-I>")
  foreach(block IN ITEMS COMPILES LISTS blocks)
    string(REPLACE EXPECT_ERROR_ "" name ${block})
    add_test(NAME compile_fail.${stem}.${name} COMMAND_EXPAND_LISTS
      COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -fsyntax-only -D${block} "${includes}" ${file})
    set_tests_properties(compile_fail.${stem}.${name} PROPERTIES LABELS compile_fail ENVIRONMENT LC_ALL=C)
    if(NOT block STREQUAL COMPILES)
      set_tests_properties(compile_fail.${stem}.${name} PROPERTIES
        # Given this, ctest ignores the exit status; a line with "error:" means that it was not 0.
        PASS_REGULAR_EXPRESSION "error: .*(static assertion|deleted|no match|no viable|convert|conversion|invalid operands)"
        FAIL_REGULAR_EXPRESSION "No such file|was not declared|undeclared|does not name a type|has no member")
    endif()
  endforeach()
endfunction()

# image_test(NAME SCENE [SET path=value …] [ARGS …] [SIZE 320x240] [TOLERANCE 3] [SHARE s])
#
# What `normalscope capture SCENE --set …` draws must be tests/image/baselines/NAME.png, but for TOLERANCE of 255 a
# channel and a SHARE of the pixels. SCENE is a built-in scene's name or a file beside the list; ARGS go to capture as
# they are. Pictures are left in build/image-tests/NAME.
function(image_test name scene)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "SIZE;TOLERANCE;SHARE" "SET;ARGS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "image_test(${name}): what is ${arg_UNPARSED_ARGUMENTS}?")
  endif()
  if(NOT arg_SIZE)
    set(arg_SIZE 320x240)
  endif()
  if(NOT DEFINED arg_TOLERANCE)
    set(arg_TOLERANCE 3)
  endif()
  set(compare "--tolerance ${arg_TOLERANCE}")
  if(DEFINED arg_SHARE)
    string(APPEND compare " --share ${arg_SHARE}")
  endif()
  if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${scene}")
    set(scene "${CMAKE_CURRENT_SOURCE_DIR}/${scene}")
  endif()
  list(TRANSFORM arg_SET PREPEND "--set;")
  add_test(NAME image.${name} COMMAND ${PROJECT_SOURCE_DIR}/cmake/image_test.sh
    ${PROJECT_BINARY_DIR}/normalscope ${PROJECT_BINARY_DIR}/image-tests/${name}
    ${PROJECT_SOURCE_DIR}/tests/image/baselines/${name}.png ${compare}
    ${scene} ${arg_SET} --size ${arg_SIZE} --context osmesa ${arg_ARGS})
  set_tests_properties(image.${name} PROPERTIES LABELS image ENVIRONMENT "${test_environment}")
endfunction()

# python_tests(FOLDER [COMMAND …]): each FOLDER/test_*.py, run by COMMAND … python3.
function(python_tests folder)
  file(GLOB scripts CONFIGURE_DEPENDS ${folder}/test_*.py)
  foreach(script IN LISTS scripts)
    get_filename_component(stem ${script} NAME_WE)
    string(REPLACE test_ "" name ${stem})
    add_test(NAME ${folder}.${name} COMMAND ${ARGN} ${Python3_EXECUTABLE} ${script})
    set_tests_properties(${folder}.${name} PROPERTIES LABELS ${folder} ENVIRONMENT "${test_environment}"
      SKIP_RETURN_CODE 77)
    if(folder STREQUAL desktop)  # xvfb-run looks for a free display number without reserving it
      # One after the other, so they start first: the others run beside them.
      set_tests_properties(${folder}.${name} PROPERTIES RESOURCE_LOCK display COST 2000)
    endif()
  endforeach()
endfunction()
