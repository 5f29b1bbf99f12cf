# One file for any Linux of the last years: what is not on every desktop is within it. ./dev portable makes it.
#
# GLFW 3.4 loads X11 or Wayland at run time, whichever is there; GL, OSMesa, EGL and fontconfig are looked for at run time
# anyway. So the program needs the C library alone, and of that no more than version 2.34 has.
set(portable_folder "${NORMALSCOPE_THIRD_PARTY}/portable")
if(NOT EXISTS "${portable_folder}/complete")
  message(FATAL_ERROR "There is no GLFW in ${portable_folder}: run ./dev portable, or cmake/fetch_portable.sh")
endif()

set(usual_suffixes ${CMAKE_FIND_LIBRARY_SUFFIXES})
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
set(CMAKE_FIND_LIBRARY_SUFFIXES ${usual_suffixes})
find_package(CLI11 CONFIG REQUIRED)
find_package(glm CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(Threads REQUIRED)

set(GLFW_LIBRARY_TYPE STATIC)
foreach(part DOCS EXAMPLES TESTS)
  set(GLFW_BUILD_${part} OFF)
endforeach()
set(GLFW_INSTALL OFF)
add_subdirectory("${portable_folder}/glfw3" glfw EXCLUDE_FROM_ALL)

add_library(portable_glibc STATIC cmake/portable_glibc.c)
add_link_options(-static-libstdc++ -Wl,--as-needed -Wl,--wrap=hypot -Wl,--wrap=hypotf)
