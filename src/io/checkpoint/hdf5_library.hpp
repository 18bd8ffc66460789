#pragma once
/// HDF5, loaded when it is first needed: it brings thirty libraries (for files in the cloud), which would more than
/// double the time in which the program starts.

#include <hdf5.h>

#include <stdexcept>

// The header's constants call H5open() and H5check() wherever they are used; loading the library does that once.
#undef H5OPEN
#define H5OPEN
#undef H5CHECK
#define H5CHECK

namespace creepcontact::io {

/// What the library could not do.
struct Hdf5Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The functions and values used, by their own names.
struct Hdf5Library {
  decltype(&::H5Dclose) H5Dclose;
  decltype(&::H5Dcreate2) H5Dcreate2;
  decltype(&::H5Dget_space) H5Dget_space;
  decltype(&::H5Dopen2) H5Dopen2;
  decltype(&::H5Dread) H5Dread;
  decltype(&::H5Dwrite) H5Dwrite;
  decltype(&::H5Eset_auto2) H5Eset_auto2;
  decltype(&::H5Fclose) H5Fclose;
  decltype(&::H5Fcreate) H5Fcreate;
  decltype(&::H5Fget_filesize) H5Fget_filesize;
  decltype(&::H5Fopen) H5Fopen;
  decltype(&::H5Gclose) H5Gclose;
  decltype(&::H5Gcreate2) H5Gcreate2;
  decltype(&::H5Gget_info) H5Gget_info;
  decltype(&::H5Gopen2) H5Gopen2;
  decltype(&::H5Iget_file_id) H5Iget_file_id;
  decltype(&::H5Lget_name_by_idx) H5Lget_name_by_idx;
  decltype(&::H5Pclose) H5Pclose;
  decltype(&::H5Pcreate) H5Pcreate;
  decltype(&::H5Pset_userblock) H5Pset_userblock;
  decltype(&::H5Sclose) H5Sclose;
  decltype(&::H5Screate_simple) H5Screate_simple;
  decltype(&::H5Sget_simple_extent_dims) H5Sget_simple_extent_dims;
  decltype(&::H5Sget_simple_extent_ndims) H5Sget_simple_extent_ndims;
  decltype(&::H5Sget_simple_extent_npoints) H5Sget_simple_extent_npoints;
  hid_t file_create_class, native_double, native_int64, native_char;
};

/// @throws Hdf5Error if the library cannot be loaded
const Hdf5Library& hdf5();

}  // namespace creepcontact::io
