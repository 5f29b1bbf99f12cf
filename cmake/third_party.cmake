# Dear ImGui and glad, built from source: see fetch_third_party.sh for why, and for where they come from.
#
# They are fetched once, into a folder that every build folder can share. To bring your own instead (say, on a
# system without apt), set
#   NORMALSCOPE_IMGUI_DIR  a checkout of Dear ImGui 1.90.1 or later
#   NORMALSCOPE_GLAD_DIR   what `glad --api gl:core=3.3 --extensions GL_KHR_debug --out-path DIR c` of glad 2 wrote
set(third_party "$ENV{NORMALSCOPE_THIRD_PARTY}")
if(NOT third_party)
  set(third_party "${PROJECT_SOURCE_DIR}/build/third_party")
endif()
set(NORMALSCOPE_THIRD_PARTY "${third_party}" CACHE PATH "Where Dear ImGui and glad are fetched to")
set(NORMALSCOPE_IMGUI_DIR "${NORMALSCOPE_THIRD_PARTY}/imgui" CACHE PATH "Dear ImGui's source")
set(NORMALSCOPE_GLAD_DIR "${NORMALSCOPE_THIRD_PARTY}/glad" CACHE PATH "glad's generated loader")

if(NOT EXISTS "${NORMALSCOPE_IMGUI_DIR}/imgui.h" OR NOT EXISTS "${NORMALSCOPE_GLAD_DIR}/src/gl.c")
  message(STATUS "Fetching Dear ImGui and glad into ${NORMALSCOPE_THIRD_PARTY}")
  execute_process(COMMAND "${CMAKE_CURRENT_LIST_DIR}/fetch_third_party.sh" "${NORMALSCOPE_THIRD_PARTY}"
    RESULT_VARIABLE failed ERROR_VARIABLE reason ERROR_STRIP_TRAILING_WHITESPACE)
  if(failed)
    message(FATAL_ERROR "${reason}")
  endif()
endif()

if(EMSCRIPTEN)
  add_library(glad INTERFACE)  # a page's GL needs no loader
else()
  add_library(glad STATIC "${NORMALSCOPE_GLAD_DIR}/src/gl.c")
  target_include_directories(glad SYSTEM PUBLIC "${NORMALSCOPE_GLAD_DIR}/include")
endif()

set(imgui "${NORMALSCOPE_IMGUI_DIR}")
add_library(imgui STATIC
  "${imgui}/imgui.cpp"
  "${imgui}/imgui_draw.cpp"
  "${imgui}/imgui_tables.cpp"
  "${imgui}/imgui_widgets.cpp"
  "${imgui}/misc/cpp/imgui_stdlib.cpp")
target_include_directories(imgui SYSTEM PUBLIC "${imgui}" "${imgui}/misc/cpp")
if(one_file)
  target_compile_options(imgui PRIVATE -Os)
endif()
target_compile_definitions(imgui PUBLIC
  IMGUI_DISABLE_OBSOLETE_FUNCTIONS
  IMGUI_DISABLE_DEMO_WINDOWS
  IMGUI_USE_WCHAR32)

# The backend apart, so that app/ui, which draws to no particular window, cannot reach GL through ImGui.
add_library(imgui_backends STATIC "${imgui}/backends/imgui_impl_opengl3.cpp")
target_include_directories(imgui_backends SYSTEM PUBLIC "${imgui}/backends")
target_link_libraries(imgui_backends PUBLIC imgui glad)

# With its own loader ImGui takes GL from libGL and fails in OSMesa; LOADER_CUSTOM means "the includer brought one".
if(NOT EMSCRIPTEN)
  set_source_files_properties("${imgui}/backends/imgui_impl_opengl3.cpp" PROPERTIES
    COMPILE_DEFINITIONS IMGUI_IMPL_OPENGL_LOADER_CUSTOM
    COMPILE_OPTIONS "-include;glad/gl.h")
endif()
