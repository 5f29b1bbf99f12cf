# The program as a Mac shows it: normalscope.app, with its icon, and the page where ./dev web has made it.
find_program(RSVG_CONVERT rsvg-convert REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(icon "${PROJECT_BINARY_DIR}/normalscope.icns")
add_custom_command(OUTPUT "${icon}"
  COMMAND ${Python3_EXECUTABLE} "${PROJECT_SOURCE_DIR}/cmake/make_icon.py" "${RSVG_CONVERT}"
    "${PROJECT_SOURCE_DIR}/assets/icons/normalscope.svg" "${icon}"
  DEPENDS assets/icons/normalscope.svg cmake/make_icon.py
  COMMENT "The icon, in the sizes that a Mac shows")
set(brought "${icon}")
if(EXISTS "${PROJECT_SOURCE_DIR}/build/web/normalscope.html")
  list(APPEND brought "${PROJECT_SOURCE_DIR}/build/web/normalscope.html")
endif()
target_sources(normalscope PRIVATE ${brought})
set_source_files_properties(${brought} PROPERTIES MACOSX_PACKAGE_LOCATION Resources)
set_target_properties(normalscope PROPERTIES
  MACOSX_BUNDLE ON MACOSX_BUNDLE_INFO_PLIST "${PROJECT_SOURCE_DIR}/assets/macos/Info.plist.in")
