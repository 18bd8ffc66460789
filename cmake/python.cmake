# The package creepcontact for Python, in <build>/python: an extension module and sources in Python, with links to what the
# library starts and reads at run time. Left out where pybind11 or Python's headers are missing.
option(CREEPCONTACT_PYTHON "Build the package for Python, where pybind11 and Python's headers are found" ON)
if(NOT CREEPCONTACT_PYTHON OR CREEPCONTACT_FUZZ)
  return()
endif()
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)  # that of the packages of the system, whatever the path has before it
endif()
find_package(Python3 3.11 COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 CONFIG QUIET)
if(NOT Python3_FOUND OR NOT pybind11_FOUND)
  message(STATUS "creepcontact is built without its Python package: pybind11 or Python's headers are missing")
  return()
endif()
set(python_package ${CMAKE_BINARY_DIR}/python/creepcontact)
creepcontact_extension(python creepcontact_python USES creepcontact_run PRIVATE_USES creepcontact_fit creepcontact_config
                       creepcontact_model creepcontact_io creepcontact_material)
set_target_properties(creepcontact_python PROPERTIES OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${python_package}
                      SUFFIX ".${Python3_SOABI}.so")
target_link_options(creepcontact_python PRIVATE -Wl,--exclude-libs,ALL)  # other modules of the process have libraries of their own
target_compile_definitions(creepcontact_python PRIVATE CREEPCONTACT_VERSION="${PROJECT_VERSION}")
file(GLOB python_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/creepcontact/*.py
     ${PROJECT_SOURCE_DIR}/python/creepcontact/*.pyi ${PROJECT_SOURCE_DIR}/python/creepcontact/py.typed)
file(MAKE_DIRECTORY ${python_package})
foreach(source IN LISTS python_sources)
  get_filename_component(name ${source} NAME)
  file(CREATE_LINK ${source} ${python_package}/${name} SYMBOLIC)
endforeach()
foreach(companion materials creepcontact-mesher creepcontact-optimizer.so)
  file(CREATE_LINK ${CMAKE_BINARY_DIR}/bin/${companion} ${python_package}/${companion} SYMBOLIC)
endforeach()
add_dependencies(creepcontact_python creepcontact_mesher)
