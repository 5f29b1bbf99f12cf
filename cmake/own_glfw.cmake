# GLFW 3.4 compiled from source, where fetch_portable.sh left it with the others: ${portable_folder}.
set(portable_folder "${NORMALSCOPE_THIRD_PARTY}/portable")
if(NOT EXISTS "${portable_folder}/complete")
  message(FATAL_ERROR "There is no GLFW in ${portable_folder}: run ./dev portable or ./dev windows, or cmake/fetch_portable.sh")
endif()

set(GLFW_LIBRARY_TYPE STATIC)
foreach(part DOCS EXAMPLES TESTS)
  set(GLFW_BUILD_${part} OFF)
endforeach()
set(GLFW_INSTALL OFF)
add_subdirectory("${portable_folder}/glfw3" glfw EXCLUDE_FROM_ALL)
