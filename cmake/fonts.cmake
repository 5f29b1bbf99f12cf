# The fonts that are built into the program, as distributions package them. Each path is a cache variable of its own. What is
# one file for a system has of them what it can show, and a page only the letters that it needs.
set(fonts)
function(subset_font from to)
  set(script "${PROJECT_SOURCE_DIR}/cmake/subset_font.py")
  set(interface "${PROJECT_SOURCE_DIR}/app/ui/kit/fonts.cpp")
  set(texts)
  if(EMSCRIPTEN)
    file(GLOB texts CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/assets/lessons/*" "${PROJECT_SOURCE_DIR}/assets/scenes/*")
  endif()
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/fonts")
  add_custom_command(OUTPUT "${to}" COMMAND python3 "${script}" "${from}" "${to}" "${interface}" ${texts}
    DEPENDS "${script}" "${interface}" ${texts} VERBATIM)
endfunction()
function(find_font name package)
  string(MAKE_C_IDENTIFIER "NORMALSCOPE_FONT_${name}" variable)
  find_file(${variable} ${name}
    PATHS /usr/share/fonts /usr/local/share/fonts
    PATH_SUFFIXES truetype/open-sans truetype/dejavu open-sans dejavu TTF
    DOC "The font ${name}" NO_CMAKE_FIND_ROOT_PATH)
  if(NOT ${variable})
    message(FATAL_ERROR "${name} was not found: install ${package}, or set ${variable} to its path")
  endif()
  set(font "${${variable}}")
  if(one_file)
    subset_font("${font}" "${PROJECT_BINARY_DIR}/fonts/${name}")
    set(font "${PROJECT_BINARY_DIR}/fonts/${name}")
  endif()
  set(fonts ${fonts} "fonts/${name}=${font}" PARENT_SCOPE)
endfunction()

find_font(OpenSans-Regular.ttf fonts-open-sans)
find_font(OpenSans-Semibold.ttf fonts-open-sans)
find_font(OpenSans-SemiboldItalic.ttf fonts-open-sans)
find_font(DejaVuSans.ttf fonts-dejavu-core)
