# The fonts that are built into the program, as distributions package them. Each path is a cache variable of its own.
set(fonts)
function(find_font name package)
  string(MAKE_C_IDENTIFIER "NORMALSCOPE_FONT_${name}" variable)
  find_file(${variable} ${name}
    PATHS /usr/share/fonts /usr/local/share/fonts
    PATH_SUFFIXES truetype/open-sans truetype/dejavu open-sans dejavu TTF
    DOC "The font ${name}" NO_CMAKE_FIND_ROOT_PATH)
  if(NOT ${variable})
    message(FATAL_ERROR "${name} was not found: install ${package}, or set ${variable} to its path")
  endif()
  set(fonts ${fonts} "fonts/${name}=${${variable}}" PARENT_SCOPE)
endfunction()

find_font(OpenSans-Regular.ttf fonts-open-sans)
find_font(OpenSans-Semibold.ttf fonts-open-sans)
find_font(OpenSans-SemiboldItalic.ttf fonts-open-sans)
find_font(OpenSans-Bold.ttf fonts-open-sans)
find_font(DejaVuSans.ttf fonts-dejavu-core)
