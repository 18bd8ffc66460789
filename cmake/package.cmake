# cpack: Debian packages of the program with its documentation and examples, and of the package for Python; the headers and libraries are
# left out. scripts/package
# runs it.
set(CPACK_PACKAGE_NAME creepcontact)
set(CPACK_PACKAGE_VENDOR "The creepcontact developers")
set(CPACK_PACKAGE_CONTACT "The creepcontact developers <creepcontact@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "creep of machine parts in contact, by finite elements")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "creepcontact computes how shrink fits, bolted joints, blade roots
and other parts in contact creep at high temperature: finite elements,
Schwarz contact with friction, and integration of the creep strain in
time under error control. It reads Gmsh geometries and meshes and decks
of CalculiX and Abaqus, and writes tables, plots, fields for ParaView
and reports.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program)
if(TARGET creepcontact_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME creepcontact)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-creepcontact)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "creepcontact (= ${PROJECT_VERSION}), libhdf5-103-1, python3-numpy, \
python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_python})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-meshio")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "creep of machine parts in contact, as a package for Python
The library of creepcontact for scripts and notebooks: models, variants,
results as arrays, creep laws and published material data.")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded when it is needed, so that the linker does not know of it.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libhdf5-103-1)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-vtk9, xvfb, paraview, calculix-cgx")
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package_files.cmake)
include(CPack)
