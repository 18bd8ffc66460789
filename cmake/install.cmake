# cmake --install: program, its manual page, completion in bash, documentation, example configurations, headers,
# libraries and the CMake package `creepcontact`
# (find_package(creepcontact), targets creepcontact::base, creepcontact::run, ...). Component `program` is what a user needs, `python` the
# package for Python,
# `development` the rest.
include(CMakePackageConfigHelpers)

if(TARGET creepcontact)
  install(TARGETS ${creepcontact_programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(TARGETS creepcontact_mesher RUNTIME DESTINATION ${companions_directory} COMPONENT program)
  install(TARGETS creepcontact_optimizer LIBRARY DESTINATION ${companions_directory} COMPONENT program)
  install(FILES docs/creepcontact.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES completions/creepcontact DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
endif()
if(TARGET creepcontact_python)
  if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set(python_directory lib/python3/dist-packages)  # that of Debian's packages
  else()
    set(python_directory lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/dist-packages)
  endif()
  install(TARGETS creepcontact_python LIBRARY DESTINATION ${python_directory}/creepcontact COMPONENT python)
  install(FILES ${python_sources} DESTINATION ${python_directory}/creepcontact COMPONENT python)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-creepcontact COMPONENT python RENAME copyright)
endif()
install(FILES README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program RENAME copyright)
install(DIRECTORY studies DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program FILES_MATCHING PATTERN *.md PATTERN *.png PATTERN *.svg
        PATTERN *.toml PATTERN results EXCLUDE PATTERN runs EXCLUDE)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program PATTERN *.1 EXCLUDE)
install(DIRECTORY configs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/creepcontact/configs COMPONENT program PATTERN results EXCLUDE)
install(DIRECTORY materials DESTINATION ${CMAKE_INSTALL_DATADIR}/creepcontact COMPONENT program)
install(DIRECTORY include/creepcontact DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

get_property(modules GLOBAL PROPERTY CREEPCONTACT_MODULES)
list(REMOVE_ITEM modules creepcontact_cli creepcontact_mpi)  # the programs' own
foreach(target IN LISTS modules ITEMS creepcontact_options)
  string(REPLACE creepcontact_ "" export_name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${export_name})
endforeach()
install(TARGETS ${modules} creepcontact_options EXPORT creepcontactTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/creepcontact)
install(EXPORT creepcontactTargets NAMESPACE creepcontact:: DESTINATION ${package_dir} COMPONENT development)
# The package finds its libraries as the build does, so it carries the same file.
file(WRITE ${CMAKE_BINARY_DIR}/creepcontactConfig.cmake
"include(\${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
include(\${CMAKE_CURRENT_LIST_DIR}/creepcontactTargets.cmake)
")
write_basic_package_version_file(${CMAKE_BINARY_DIR}/creepcontactConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/creepcontactConfig.cmake ${CMAKE_BINARY_DIR}/creepcontactConfigVersion.cmake
              cmake/dependencies.cmake
        DESTINATION ${package_dir} COMPONENT development)
