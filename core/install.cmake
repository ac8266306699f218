# cmake --install: the libraries with their headers for find_package(lpquad), and the command.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(lpq_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lpquad)
install(TARGETS lpquad lpquad_io EXPORT lpquadTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET lpquad_command)
  install(TARGETS lpquad_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
# Installed headers find each other as <lpquad/base/result.h>, whatever the user's own are called.
install(CODE "set(SOURCE \"${CMAKE_CURRENT_LIST_DIR}\")
set(TARGET \"${PROJECT_BINARY_DIR}/headers/installed\")
include(\"${CMAKE_CURRENT_LIST_DIR}/install_headers.cmake\")")
install(DIRECTORY ${PROJECT_BINARY_DIR}/headers/installed/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lpquad)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/lpquad)

install(EXPORT lpquadTargets NAMESPACE lpquad:: DESTINATION ${lpq_package_dir})
file(WRITE ${PROJECT_BINARY_DIR}/lpquadConfig.cmake
  "include(CMakeFindDependencyMacro)\nfind_dependency(Threads)\n"
  "include(\${CMAKE_CURRENT_LIST_DIR}/lpquadTargets.cmake)\n")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lpquadConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lpquadConfig.cmake ${PROJECT_BINARY_DIR}/lpquadConfigVersion.cmake
  DESTINATION ${lpq_package_dir})
