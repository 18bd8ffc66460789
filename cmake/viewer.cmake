# The interactive view of fields in reports: a bundle of web/report and three.js, made by npm (Debian packages nodejs and npm) and
# embedded in the program. Without npm, or with CREEPCONTACT_VIEWER=OFF, reports have still pictures only.
find_program(NPM_EXECUTABLE npm)
if(NPM_EXECUTABLE)
  set(viewer_default ON)
else()
  set(viewer_default OFF)
endif()
option(CREEPCONTACT_VIEWER "Interactive view of fields in reports (needs npm and its registry)" ${viewer_default})

set(viewer_directory ${CMAKE_BINARY_DIR}/viewer)
set(viewer_files ${viewer_directory}/dist/viewer.js ${viewer_directory}/dist/viewer.css)
if(CREEPCONTACT_VIEWER)
  if(NOT NPM_EXECUTABLE)
    message(FATAL_ERROR "CREEPCONTACT_VIEWER needs npm (Debian packages nodejs and npm); -D CREEPCONTACT_VIEWER=OFF builds without")
  endif()
  set(viewer_source ${PROJECT_SOURCE_DIR}/web/report)
  file(GLOB viewer_sources CONFIGURE_DEPENDS ${viewer_source}/src/* ${viewer_source}/test/*)
  if(NOT CREEPCONTACT_TESTS)
    set(without_test_packages --omit=dev)
  endif()
  # Packages are installed once per lock file, and not into the source tree.
  add_custom_command(
    OUTPUT ${viewer_directory}/installed
    COMMAND ${CMAKE_COMMAND} -E make_directory ${viewer_directory}
    COMMAND ${CMAKE_COMMAND} -E copy ${viewer_source}/package.json ${viewer_source}/package-lock.json ${viewer_source}/.npmrc
            ${viewer_directory}
    COMMAND ${CMAKE_COMMAND} -E chdir ${viewer_directory} ${NPM_EXECUTABLE} ci ${without_test_packages} --no-audit --no-fund --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${viewer_directory}/installed
    DEPENDS ${viewer_source}/package.json ${viewer_source}/package-lock.json
    COMMENT "Installing the packages of the interactive view"
    VERBATIM)
  add_custom_command(
    OUTPUT ${viewer_files}
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${viewer_directory}/src ${viewer_directory}/test
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${viewer_source}/src ${viewer_directory}/src
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${viewer_source}/test ${viewer_directory}/test
    COMMAND ${CMAKE_COMMAND} -E chdir ${viewer_directory} ${NPM_EXECUTABLE} run --silent build
    DEPENDS ${viewer_directory}/installed ${viewer_sources}
    COMMENT "Bundling the interactive view"
    VERBATIM)
else()
  message(STATUS "No interactive view of fields in reports (CREEPCONTACT_VIEWER)")
  foreach(viewer_file IN LISTS viewer_files)
    file(WRITE ${viewer_file} "")
  endforeach()
endif()

# Embeds files in a module, as macros of src/<module>/assets.S: pairs of a macro and a file.
function(creepcontact_embed module)
  set(assets ${PROJECT_SOURCE_DIR}/src/${module}/assets.S)
  set(files)
  set(definitions)
  while(ARGN)
    list(POP_FRONT ARGN macro file)
    list(APPEND files ${file})
    list(APPEND definitions "${macro}=\"${file}\"")
  endwhile()
  set_source_files_properties(${assets} PROPERTIES LANGUAGE ASM OBJECT_DEPENDS "${files}" COMPILE_DEFINITIONS "${definitions}"
                              SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(creepcontact_${module} PRIVATE ${assets})
endfunction()
list(GET viewer_files 0 viewer_script)
list(GET viewer_files 1 viewer_style)
creepcontact_embed(report VIEWER_SCRIPT ${viewer_script} VIEWER_STYLE ${viewer_style} REPORT_STYLE
                   ${PROJECT_SOURCE_DIR}/src/report/report.css COLOURS ${PROJECT_SOURCE_DIR}/web/report/src/colours.json)
creepcontact_embed(plot PICTURE_SCRIPT ${PROJECT_SOURCE_DIR}/src/plot/picture.py)
