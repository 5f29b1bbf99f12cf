# One file for any Linux of the last years: what is not on every desktop is within it. ./dev portable makes it.
#
# GLFW 3.4 loads X11 or Wayland at run time, whichever is there; GL, OSMesa, EGL and fontconfig are looked for at run time
# anyway. So the program needs the C library alone, and of that no more than version 2.34 has.
include(cmake/own_glfw.cmake)

set(usual_suffixes ${CMAKE_FIND_LIBRARY_SUFFIXES})
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
set(CMAKE_FIND_LIBRARY_SUFFIXES ${usual_suffixes})
find_package(CLI11 CONFIG REQUIRED)
find_package(glm CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(Threads REQUIRED)

add_library(portable_glibc STATIC cmake/portable_glibc.c)
add_link_options(-static-libstdc++ -Wl,--as-needed -Wl,--wrap=hypot -Wl,--wrap=hypotf)
