# embed(TARGET ROOT dir GLOBS pattern… FILES name=path…)
#
# A static library that holds files as they are on disk, with <embedded.h> to look them up by name. The assembler's
# .incbin copies the bytes: no limit on length as for string literals, and no slow array of numbers to compile.
# Files found by GLOBS are named by their path from ROOT; FILES gives names to files from elsewhere.
function(embed target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "ROOT" "GLOBS;FILES")
  list(TRANSFORM arg_GLOBS PREPEND "${arg_ROOT}/")
  file(GLOB_RECURSE found RELATIVE "${arg_ROOT}" CONFIGURE_DEPENDS ${arg_GLOBS})
  list(SORT found)
  list(TRANSFORM found REPLACE "(.+)" "\\1=${arg_ROOT}/\\1")

  set(index 0)
  set(paths)
  foreach(entry IN LISTS found arg_FILES)
    string(REGEX MATCH "^([^=]+)=(.+)$" _ "${entry}")
    set(name "${CMAKE_MATCH_1}")
    set(path "${CMAKE_MATCH_2}")
    set(begin "embedded_${index}")
    set(end "embedded_${index}_end")
    # The zero after the end lets data() serve as a C string too.
    string(APPEND data ".global NAME(${begin})\n.global NAME(${end})\n.balign 16\n"
      "NAME(${begin}): .incbin \"${path}\"\nNAME(${end}): .byte 0\nLENGTHS(${begin}, ${end})\n")
    string(APPEND symbols "extern \"C\" const char ${begin}[], ${end}[];\n")
    string(APPEND names "    \"${name}\",\n")
    string(APPEND contents "        {${begin}, static_cast<std::size_t>(${end} - ${begin})},\n")
    list(APPEND paths "${path}")
    math(EXPR index "${index} + 1")
  endforeach()

  set(folder "${CMAKE_CURRENT_BINARY_DIR}/${target}")
  set(templates "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
  configure_file("${templates}/embedded.h" "${folder}/embedded.h" COPYONLY)
  configure_file("${templates}/embedded.cpp.in" "${folder}/embedded.cpp" @ONLY)
  configure_file("${templates}/embedded.S.in" "${folder}/embedded.S" @ONLY)
  set_source_files_properties("${folder}/embedded.S" PROPERTIES OBJECT_DEPENDS "${paths}")

  add_library(${target} STATIC "${folder}/embedded.cpp" "${folder}/embedded.S")
  target_include_directories(${target} PUBLIC "${folder}")
endfunction()
