# HDF5 of Debian 12 brings no usable CMake package. HDF5_SONAME: what the loader calls it, libhdf5_serial.so.103.
creepcontact_find_library(HDF5 hdf5.h hdf5 SUFFIXES hdf5/serial)
file(REAL_PATH ${CREEPCONTACT_HDF5_LIBRARY} hdf5_file)
execute_process(COMMAND ${CMAKE_OBJDUMP} -p ${hdf5_file} OUTPUT_VARIABLE hdf5_headers COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "SONAME +([^\n ]+)" matched "${hdf5_headers}")
if(NOT matched)
  message(FATAL_ERROR "${hdf5_file} has no soname")
endif()
set(HDF5_SONAME ${CMAKE_MATCH_1})
