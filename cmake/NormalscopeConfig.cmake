# For projects that test their pictures with Normalscope:
#
#   find_package(Normalscope REQUIRED)
#   normalscope_test(wing wing.json REFERENCE references/wing.png)
#
# normalscope_test(NAME SCENE REFERENCE PICTURE.png [SET path=value …] [SIZE 640x360] [TOLERANCE 3] [SHARE 0.001] [PERCEPTUAL]
#                  [ARGS …])
#
# A test of ctest's: what `normalscope capture SCENE --set …` draws must be the reference, but for TOLERANCE of 255 a
# channel and a SHARE of the pixels. SCENE is a scene, a mesh or a built-in scene's name; files are found from the folder
# of the CMakeLists.txt. NAME may have folders in it, such as render/wing, and spaces. ARGS go to capture as they are. The
# picture is left as normalscope/NAME.png in the build folder, with NAME.expected.png and NAME.difference.png beside it
# where the test fails. Copy it to the reference, once you have
# looked at it, to make a new reference.
get_filename_component(_normalscope_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
find_program(NORMALSCOPE_PROGRAM normalscope HINTS "${_normalscope_prefix}/bin" DOC "The program normalscope")
unset(_normalscope_prefix)
if(NOT NORMALSCOPE_PROGRAM)
  set(Normalscope_FOUND FALSE)
  set(Normalscope_NOT_FOUND_MESSAGE "the program normalscope was not found; set NORMALSCOPE_PROGRAM to its path")
endif()

function(normalscope_test name scene)
  cmake_parse_arguments(PARSE_ARGV 2 arg "PERCEPTUAL" "REFERENCE;SIZE;TOLERANCE;SHARE" "SET;ARGS")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_REFERENCE)
    message(FATAL_ERROR "normalscope_test(${name}): expected NAME SCENE REFERENCE PICTURE.png "
      "[SET path=value …] [SIZE 640x360] [TOLERANCE 3] [SHARE 0.001] [PERCEPTUAL] [ARGS …]")
  endif()
  string(REGEX REPLACE "#[0-9]+$" "" file "${scene}")  # a lesson's step
  cmake_path(IS_ABSOLUTE file is_absolute)
  if(NOT is_absolute AND NOT scene MATCHES "^normalscope:" AND
     (EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${file}" OR file MATCHES "[./]"))
    # A file, there or not: no built-in scene has such a name, and what is wrong is then said with the folder's name.
    set(scene "${CMAKE_CURRENT_SOURCE_DIR}/${scene}")
  endif()
  set(options --size 640x360)
  foreach(option IN ITEMS SIZE TOLERANCE SHARE)
    if(DEFINED arg_${option})
      string(TOLOWER ${option} word)
      list(APPEND options --${word} ${arg_${option}})
    endif()
  endforeach()
  if(arg_PERCEPTUAL)
    list(APPEND options --perceptual)
  endif()
  list(TRANSFORM arg_SET PREPEND "--set;")
  get_filename_component(reference "${arg_REFERENCE}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  set(picture "${CMAKE_BINARY_DIR}/normalscope/${name}.png")
  get_filename_component(folder "${picture}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  add_test(NAME "${name}" COMMAND "${NORMALSCOPE_PROGRAM}" capture "${scene}" ${arg_SET} ${options} ${arg_ARGS}
    -o "${picture}" --expect "${reference}")
  # The same driver and the same arithmetic on every machine.
  set_tests_properties("${name}" PROPERTIES ENVIRONMENT "GALLIUM_DRIVER=llvmpipe;LP_NATIVE_VECTOR_WIDTH=128")
endfunction()
