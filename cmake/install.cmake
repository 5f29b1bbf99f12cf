# What is installed, and the Debian package of it.

if(WIN32)
  # A folder to look into, with the program on top.
  install(TARGETS normalscope RUNTIME DESTINATION .)
  install(FILES README.md CHANGELOG.md LICENSE DESTINATION .)
  install(DIRECTORY docs DESTINATION .)
  install(FILES "${PROJECT_SOURCE_DIR}/build/web/normalscope.html" DESTINATION . OPTIONAL)  # where ./dev web made it
  return()
endif()

add_executable(option_docs app/cli/option_docs.cpp)
target_link_libraries(option_docs PRIVATE normalscope_cli)
set(option_docs "${PROJECT_BINARY_DIR}/option_docs_out")
file(MAKE_DIRECTORY "${option_docs}")
set(option_docs_files
  ${option_docs}/normalscope.1 ${option_docs}/normalscope ${option_docs}/_normalscope ${option_docs}/normalscope.fish)
add_custom_command(OUTPUT ${option_docs_files} COMMAND option_docs "${option_docs}" DEPENDS option_docs
  COMMENT "Manual page and shell completion, from the options")
add_custom_target(option_docs_files ALL DEPENDS ${option_docs_files})
add_dependencies(normalscope option_docs_files)  # so that whoever built the program can install

include(CMakePackageConfigHelpers)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/NormalscopeConfigVersion.cmake" COMPATIBILITY SameMinorVersion)

install(TARGETS normalscope BUNDLE DESTINATION .)
install(FILES assets/normalscope.desktop DESTINATION share/applications)
install(FILES assets/icons/normalscope.svg DESTINATION share/icons/hicolor/scalable/apps)
install(FILES ${option_docs}/normalscope.1 DESTINATION share/man/man1)
install(FILES ${option_docs}/normalscope DESTINATION share/bash-completion/completions)
install(FILES ${option_docs}/_normalscope DESTINATION share/zsh/vendor-completions)
install(FILES ${option_docs}/normalscope.fish DESTINATION share/fish/vendor_completions.d)
install(FILES cmake/NormalscopeConfig.cmake "${PROJECT_BINARY_DIR}/NormalscopeConfigVersion.cmake"
  DESTINATION lib/cmake/Normalscope)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE DESTINATION share/doc/normalscope)
install(DIRECTORY docs DESTINATION share/doc/normalscope)
install(FILES "${PROJECT_SOURCE_DIR}/build/web/normalscope.html" DESTINATION share/normalscope OPTIONAL)  # where ./dev web made it

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR Normalscope)
set(CPACK_PACKAGE_CONTACT "Normalscope <normalscope@example.invalid>")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is looked for at run time, so that no tool finds it.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libosmesa6 | libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1, libegl1, libfontconfig1")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg")
include(CPack)
